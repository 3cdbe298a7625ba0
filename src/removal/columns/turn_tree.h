// The sweeps of turning inserts as a tree in the half plane (rho, z): they depend on nothing else.
// The tree finds the sweep that is nearest to a point, and those that can be nearest anywhere in a
// rectangle (docs/removal.md).
//
// Sweeps of one insert follow one another in packs of eight, and packs in packs of eight above
// them. A pack above knows of each of its children a polygon that holds what they have swept: the
// insert along a chord of their paths, thickened by how far the paths leave the chord. Programs
// move along smooth curves, so chords are close and a search goes down one way.
#pragma once

#include "core/process/heap.h"
#include "removal/columns/turn_members.h"
#include "removal/forms/turn_sweep.h"
#include "removal/simd/sweep_kernels.h"
#include "removal/tool/tool.h"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace mrsim {

/// A rectangle of the half plane: rho and z of its centre, and half its sides, mm.
struct TurnRegion {
  Vec2 center, half;
};
/// The rectangle that holds a box turned about the axis.
TurnRegion turn_region(const Box3& box);

class TurnTree {
 public:
  /// A sweep of a table: its index, its row among `turns`, and the insert that makes it.
  struct Item {
    std::uint32_t sweep = 0, row = 0;
    std::int32_t shape = 0;
  };
  /// Pack 2k of a list is pack k of the tree before the spindle axis, 2k + 1 its mirror image.
  using Packs = std::vector<std::uint32_t>;

  /// What is nearest so far; of equally near sweeps the one with the least index.
  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    std::uint32_t sweep = ~0u, row = 0;
    bool behind = false;
  };

  TurnTree() = default;
  /// `turns` stay where they are. `items` ascend. Memory: 2 KB for 7 sweeps of an insert with four
  /// corners.
  TurnTree(TurnRows turns, std::span<const ToolShape> shapes, std::vector<Item> items, int threads);

  std::size_t size() const { return turns_.size(); }  ///< sweeps
  TurnRows turns() const { return turns_; }
  std::size_t memory() const {  ///< bytes
    return bytes_of(items_) + bytes_of(packs_) + bytes_of(sides_) + bytes_of(size_);
  }
  /// Packs that hold all sweeps.
  const Packs& roots() const { return roots_; }
  /// Whether the pack holds sweeps, not packs.
  bool is_leaf(std::uint32_t pack) const { return packs_[pack / 2].leaf; }
  /// Indices of the sweeps of a pack, in no order.
  void append_sweeps(std::uint32_t pack, std::vector<std::uint32_t>& out) const;

  /// Brings `best` up to date with the sweeps of a pack at rho (or -rho) and z, the bits of
  /// turn_distance.
  void nearest(std::uint32_t pack, double rho, double z, Nearest& best) const;

  /// Packs that hold all sweeps of `in` that can be nearest somewhere in the region and are there
  /// not farther than `limit` from its centre; `best` is the nearest of all at the centre, if its
  /// sweep is one of the tree. `slack`: what rounding may change in a difference of distances.
  void narrow(const TurnRegion& region, const Nearest& best, double limit, double slack,
              std::span<const std::uint32_t> in, Packs& out) const;

  /// Appends those sweeps of what narrow() has left that may be nearest somewhere in the region.
  void members(const TurnRegion& region, const Nearest& best, double limit, double slack,
               std::span<const std::uint32_t> in, std::vector<TurnMember>& out) const;

 private:
  static constexpr std::size_t kLanes = PolygonSides::kLanes;
  struct alignas(64) Pack {
    double round[kLanes];  // subtracted from the distance of a polygon; -infinite in empty lanes
    std::uint32_t sides = 0, first = 0;  // of sides_; the item or the pack of lane 0
    std::uint16_t side_count = 0;
    std::uint8_t lanes = 0;   // of the children
    std::uint8_t behind = 0;  // of the members that also count beyond the axis
    std::uint8_t curved = 0;  // of sweeps that are not polygons
    bool leaf = false;
  };
  class Builder;
  class Narrowing;
  void measure(const Pack& pack, double x, double z, double* out) const;

  TurnRows turns_;
  std::vector<Item> items_;
  std::vector<Pack> packs_;
  std::vector<PolygonSides> sides_;
  std::vector<double> size_;  // of the path of each pack, mm
  Packs roots_;
};

}  // namespace mrsim
