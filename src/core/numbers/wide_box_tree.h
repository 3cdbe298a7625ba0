// A tree of boxes for searches by distance: four children to a node, whose boxes are compared at
// once, and one box to a leaf, so that only boxes that are near have their content looked at.
#pragma once

#include "core/numbers/box_tree.h"
#include <mrsim/types.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace mrsim {

/// Divided again and again at medians of the boxes' centres, across their longest extent. Its depth
/// is at most 16. 37 bytes a box.
class WideBoxTree {
 public:
  static constexpr int kWide = 4;

  WideBoxTree() = default;
  /// Requires: one box at least, fewer than 2^31. `names`: by box, what searches are told; several
  /// boxes may have the same. Costs n log n.
  WideBoxTree(std::span<const FloatBox> boxes, std::span<const std::uint32_t> names);

  /// Calls least(name), which says how far a search still goes, mm^2, for boxes that are no farther
  /// from p than that, and some that are by rounding, near ones first. `most`: how far at first.
  template <class Least>
  void search(const Vec3& p, double most, Least&& least) const {
    const Place place = place_of(p);
    search_by([&place](const Node& node) { return distances2(node, place, 3); }, most, least);
  }
  /// The same for distances in plan, among the boxes that reach above p.z.
  template <class Least>
  void search_in_plan(const Vec3& p, double most, Least&& least) const {
    const Place place = place_of(p);
    search_by(
        [&place](const Node& node) {
          Four all = distances2(node, place, 2);
          for (std::size_t k = 0; k < kWide; ++k)
            if (node.hi[2][k] < place.low[2]) all[k] = std::numeric_limits<float>::infinity();
          return all;
        },
        most, least);
  }
  /// Calls visit(name) for all boxes that touch `box`, in a fixed order, until it returns false.
  template <class Visit>
  void visit(const Box3& box, Visit&& visit) const;

  std::size_t memory() const { return nodes_.capacity() * sizeof(Node); }

 private:
  // A child that is a leaf has the bit kLeaf and the name of its box.
  static constexpr std::uint32_t kLeaf = 0x80000000u;
  using Four __attribute__((vector_size(16))) = float;  // a number for each child
  struct alignas(16) Node {
    std::array<Four, 3> lo, hi;  // of empty places: infinitely far
    std::array<std::uint32_t, kWide> child;
  };
  struct Entry {
    std::uint32_t child;
    float distance2;
  };
  // Factor that makes a sum of squares in single precision a lower bound of the true one.
  static constexpr float kBelow = 1 - 1e-6F;

  // A place between two numbers of single precision, by axis.
  struct Place {
    std::array<float, 3> low, high;
  };
  static Place place_of(const Vec3& p);
  // Squares of distances, never above the true ones, of all four boxes; with two axes, those in
  // plan.
  static Four distances2(const Node& n, const Place& p, std::size_t axes) {
    Four sum{};
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const Four below = n.lo[axis] - p.high[axis], above = p.low[axis] - n.hi[axis];
      const Four outside = below > above ? below : above;
      const Four beyond = outside > 0 ? outside : Four{};
      sum += beyond * beyond;
    }
    return kBelow * sum;
  }

  // Bit 8 k where place k holds.
  using Holds __attribute__((vector_size(16))) = std::int32_t;
  static std::uint32_t places(Holds holds) {
    using Bytes __attribute__((vector_size(4))) = std::int8_t;
    return std::bit_cast<std::uint32_t>(__builtin_convertvector(holds, Bytes)) & 0x01010101u;
  }
  static float not_below(double most) {
    const auto near = static_cast<float>(most);
    return near * (1 + 1e-6F) + std::numeric_limits<float>::min();
  }

  template <class Distances, class Least>
  void search_by(Distances&& distances, double most, Least&& least) const;
  void build(std::span<const FloatBox> boxes, std::span<const std::uint32_t> names,
             std::span<std::uint32_t> order, std::uint32_t self);

  std::vector<Node> nodes_;  // the first one is the root
};

inline WideBoxTree::Place WideBoxTree::place_of(const Vec3& p) {
  Place place;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double at = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
    const auto near = static_cast<float>(at);
    const float step = std::max(std::fabs(near) * 1.2e-7F, std::numeric_limits<float>::min());
    place.low[axis] = near - step, place.high[axis] = near + step;
  }
  return place;
}

template <class Distances, class Least>
void WideBoxTree::search_by(Distances&& distances, double most, Least&& least) const {
  std::array<Entry, 3 * 16 + kWide> stack;
  std::size_t top = 0;
  float limit = not_below(most);
  stack[top++] = {0, 0};
  while (top > 0) {
    const Entry entry = stack[--top];
    if (entry.distance2 > limit) continue;
    const Node& node = nodes_[entry.child];
    const Four near = distances(node);
    // Far ones first, so that near ones lie on top.
    const std::size_t bottom = top;
    std::array<Entry, kWide> leaves;
    std::size_t count = 0;
    for (std::uint32_t found = places(near <= limit); found != 0; found &= found - 1) {
      const int k = std::countr_zero(found) / 8;
      const std::uint32_t child = node.child[std::size_t(k)];
      const bool is_leaf = child >= kLeaf;
      Entry* const first = is_leaf ? leaves.data() : stack.data() + bottom;
      std::size_t& size = is_leaf ? count : top;
      Entry* at = first + size - (is_leaf ? 0 : bottom);
      for (; at > first && (at - 1)->distance2 < near[k]; --at) *at = *(at - 1);
      *at = {child, near[k]};
      ++size;
    }
    for (; count > 0 && leaves[count - 1].distance2 <= limit; --count)
      limit = not_below(least(leaves[count - 1].child & ~kLeaf));
  }
}

template <class Visit>
void WideBoxTree::visit(const Box3& box, Visit&& visit) const {
  std::array<std::uint32_t, 3 * 16 + kWide> stack;
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const Node& n = nodes_[stack[--top]];
    for (std::size_t k = 0; k < kWide; ++k) {
      if (n.lo[0][k] > box.hi.x || n.hi[0][k] < box.lo.x || n.lo[1][k] > box.hi.y ||
          n.hi[1][k] < box.lo.y || n.lo[2][k] > box.hi.z || n.hi[2][k] < box.lo.z)
        continue;
      if (n.child[k] < kLeaf)
        stack[top++] = n.child[k];
      else if (!visit(n.child[k] & ~kLeaf))
        return;
    }
  }
}

}  // namespace mrsim
