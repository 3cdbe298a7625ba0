// From faces to program lines: who cut what, and how well.
#pragma once

#include "compare/distance/sampling.h"
#include <mrsim/compare.h>

#include <map>
#include <memory>
#include <tuple>
#include <vector>

namespace mrsim {

/// A line of a program with a tool; the order is that of the program, stock first.
struct LineKey {
  std::int32_t file = -1, line = 0, tool = -1;
  bool is_stock() const { return file < 0 && line == 0; }
  friend auto operator<=>(const LineKey&, const LineKey&) = default;
};

/// The line behind each face of a mesh with owners.
class FaceLines {
 public:
  /// A mesh without owners is all stock; an owner that the table does not know becomes line
  /// (-1, -owner - 2), a number that no program has.
  explicit FaceLines(const TriMesh& part);
  const LineKey& of(std::uint32_t face) const { return lines_[index_[face]]; }
  std::uint32_t index(std::uint32_t face) const { return index_[face]; }
  const std::vector<LineKey>& lines() const { return lines_; }  ///< ascending
  bool any_cut() const { return any_cut_; }

 private:
  std::vector<LineKey> lines_;
  std::vector<std::uint32_t> index_;  ///< #F, into lines_
  bool any_cut_ = false;
};

/// Figures of every line from the part's samples.
std::vector<LineFigures> line_figures(const DeviationField& part, const FaceLines& lines,
                                      const Acceptance& band);

/// The cut surface alone: which line's is nearest to a point.
class CutSurface {
 public:
  CutSurface(const TriMesh& part, const FaceLines& lines);
  struct Nearest {
    LineKey line;
    double distance = 0;
  };
  bool empty() const { return !tree_; }
  /// The place of the cut surface nearest to p, and the line that has cut it. Requires: !empty().
  Nearest nearest(const Vec3& p) const;

 private:
  std::vector<std::uint32_t> faces_;
  const FaceLines& lines_;
  std::unique_ptr<TriangleTree> tree_;
};

/// Fills file, line, tool and text of a line for people.
BlamedLine name_line(const LineKey& key, const OwnerTable& table,
                     const std::vector<std::vector<std::string>>& texts);

}  // namespace mrsim
