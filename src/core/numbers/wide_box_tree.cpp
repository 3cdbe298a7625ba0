#include "core/numbers/wide_box_tree.h"

#include "core/process/error.h"

#include <numeric>

namespace mrsim {
namespace {

constexpr std::size_t kMost = std::size_t(1) << 31;

FloatBox box_of(std::span<const FloatBox> boxes, std::span<const std::uint32_t> order) {
  FloatBox all;
  for (const std::uint32_t i : order) all.extend(boxes[i]);
  return all;
}

// Brings the `count` boxes of the least centres across their longest extent to the front.
void divide(std::span<const FloatBox> boxes, std::span<std::uint32_t> order, std::size_t count) {
  const auto center = [&](std::uint32_t i, std::size_t axis) {
    return boxes[i].lo[axis] + boxes[i].hi[axis];
  };
  FloatBox centers;
  for (const std::uint32_t i : order) {
    const std::array<float, 3> c{center(i, 0), center(i, 1), center(i, 2)};
    centers.extend({c, c});
  }
  const std::size_t axis = centers.longest_axis();
  std::nth_element(order.begin(), order.begin() + std::ptrdiff_t(count), order.end(),
                   [&](std::uint32_t i, std::uint32_t j) {
                     const float x = center(i, axis), y = center(j, axis);
                     return x != y ? x < y : i < j;
                   });
}

}  // namespace

WideBoxTree::WideBoxTree(std::span<const FloatBox> boxes, std::span<const std::uint32_t> names) {
  MRSIM_ASSERT(!boxes.empty() && boxes.size() < kMost && names.size() == boxes.size());
  std::vector<std::uint32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0u);
  nodes_.reserve(boxes.size() / (kWide - 1) + 17);
  nodes_.emplace_back();
  build(boxes, names, order, 0);
}

// All children but the last one hold a power of four, so that nodes are full.
void WideBoxTree::build(std::span<const FloatBox> boxes, std::span<const std::uint32_t> names,
                        std::span<std::uint32_t> order, std::uint32_t self) {
  std::size_t share = 1;
  while (share * kWide < order.size()) share *= kWide;
  const std::size_t parts = (order.size() + share - 1) / share;
  std::array<std::span<std::uint32_t>, kWide> children;
  const std::size_t half = std::min((parts + 1) / 2 * share, order.size());
  if (half < order.size()) divide(boxes, order, half);
  std::size_t count = 0;
  for (std::span<std::uint32_t> side : {order.first(half), order.subspan(half)}) {
    if (side.size() > share) {
      divide(boxes, side, share);
      children[count++] = side.first(share);
      side = side.subspan(share);
    }
    if (!side.empty()) children[count++] = side;
  }
  for (std::size_t k = 0; k < kWide; ++k) {
    const FloatBox box = box_of(boxes, children[k]);
    for (std::size_t axis = 0; axis < 3; ++axis)
      nodes_[self].lo[axis][k] = box.lo[axis], nodes_[self].hi[axis][k] = box.hi[axis];
    const bool is_leaf = children[k].size() == 1;
    const auto next = static_cast<std::uint32_t>(nodes_.size());
    nodes_[self].child[k] = is_leaf               ? kLeaf | names[children[k][0]]
                            : children[k].empty() ? kLeaf | names[0]
                                                  : next;
    if (is_leaf || children[k].empty()) continue;
    nodes_.emplace_back();
    build(boxes, names, children[k], next);
  }
}

}  // namespace mrsim
