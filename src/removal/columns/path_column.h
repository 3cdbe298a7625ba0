// The paths of those sweeps that have no closed form, by row. Lines are stored apart from arcs:
// most paths are lines, and a line takes a fifth of the memory of an arc.
#pragma once

#include "core/process/heap.h"
#include "removal/forms/tool_path.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace mrsim {

class PathColumn {
 public:
  struct Line {
    Vec3 start, travel;
    Vec3 end() const { return start + travel; }
  };
  /// A path of the column, as it was added; a line is made anew, which costs some ten nanoseconds.
  /// Valid as long as the column is not changed.
  class Path {
   public:
    explicit Path(const ToolPath& arc) : arc_(&arc) {}
    explicit Path(const Line& line) {
      line_.emplace();
      line_->start = line.start, line_->travel = line.travel;
      line_->speed = length(line.travel);
    }
    const ToolPath& operator*() const { return arc_ != nullptr ? *arc_ : *line_; }

   private:
    const ToolPath* arc_ = nullptr;
    std::optional<ToolPath> line_;
  };

  std::size_t size() const { return numbers_.size(); }
  bool empty() const { return numbers_.empty(); }
  bool is_line(std::size_t row) const { return (numbers_[row] & kArc) == 0; }
  Path operator[](std::size_t row) const { return is_line(row) ? Path(line(row)) : Path(arc(row)); }
  /// Requires: is_line(row).
  const Line& line(std::size_t row) const { return lines_[numbers_[row]]; }
  /// Requires: not is_line(row).
  const ToolPath& arc(std::size_t row) const { return arcs_[numbers_[row] & ~kArc]; }
  /// The position at parameter t, which runs from 0 to end(): 1, or the angle of an arc in radians.
  PathPoint point(std::size_t row, double t) const {
    if (!is_line(row)) return path_point(arc(row), t);
    return {line(row).start + t * line(row).travel, line(row).travel};
  }
  double end(std::size_t row) const { return is_line(row) ? 1 : arc(row).sweep; }

  void push_back(const ToolPath& path);
  /// Appends a part, the `done`th of `all`.
  void append(const PathColumn& part, std::size_t done, std::size_t all);
  std::size_t memory() const;  ///< bytes

 private:
  static constexpr std::uint32_t kArc = 1u << 31;
  std::vector<std::uint32_t> numbers_;  ///< by row: in lines_, or in arcs_ with kArc
  std::vector<Line> lines_;
  std::vector<ToolPath> arcs_;
};

}  // namespace mrsim
