// Makes rows of a SweepTable from some motions of a program. Parts are made side by side, each with
// shapes and frames of its own, and joined in the order of the program.
#pragma once

#include "removal/columns/sweep_columns.h"
#include "removal/columns/sweep_selection.h"
#include "removal/forms/sweep_motion.h"

#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace mrsim {

/// What a shape is made from; equal for equal shapes.
struct ShapeKey {
  std::int32_t tool = 0, piece = 0;
  double travel = 0;  ///< by which it is drawn out, mm; infinite: without end
  friend bool operator<(const ShapeKey& a, const ShapeKey& b) {
    return std::tie(a.tool, a.piece, a.travel) < std::tie(b.tool, b.piece, b.travel);
  }
};

class SweepBuilder {
 public:
  SweepBuilder(std::span<const Tool> tools, const SweepSelection& selection)
      : tools_(tools), selection_(selection), shapes_of_(tools.size()) {}

  /// Appends the sweeps of a motion, if it is wanted. Throws as SweepTable.
  void add(const Motion& m, std::int32_t index);

  /// The columns made so far, without tags, classes and packs.
  SweepColumns& columns() { return columns_; }
  /// What each shape is known by, in their order.
  const std::vector<ShapeKey>& keys() const { return keys_; }

 private:
  struct ShapeRange {
    int first = -1, count = 0;
  };
  bool wanted(const Motion& m) const;
  bool stays_above(const Motion& m, const Profile& tool) const;
  ShapeRange shapes(const Motion& m);
  int drawn_out(int shape, double travel);
  int extended_up(int shape, double lowest);
  void add_shape(ToolShape&& shape, const ShapeKey& key);
  std::uint16_t frame(const Vec3& axis);
  void add_milling(SweepRef ref, const Motion& m, const Tool& tool);
  void add_horizontal(SweepRef& ref, const LocalMotion& l, const Profile& tool);
  void add_upright(SweepRef& ref, const LocalMotion& l, const Profile& tool);
  bool add_curtain(SweepRef& ref, const LocalMotion& l, const Profile& tool);
  void add_path(SweepRef& ref, LocalMotion l, const Profile& tool);
  void add_turning(SweepRef ref, const Motion& m, const Tool& tool);
  void allow(double error) { columns_.max_error = std::max(columns_.max_error, error); }

  SweepColumns columns_;
  std::vector<ShapeKey> keys_;
  std::span<const Tool> tools_;
  SweepSelection selection_;
  std::vector<ShapeRange> shapes_of_;
  std::map<std::pair<int, double>, int> drawn_out_;
};

}  // namespace mrsim
