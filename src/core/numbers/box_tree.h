// A tree of boxes over triangles, or over other things that have a box each.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace mrsim {

/// A box in single precision; by default one that holds nothing.
struct FloatBox {
  static constexpr float kFar = std::numeric_limits<float>::infinity();
  std::array<float, 3> lo{kFar, kFar, kFar}, hi{-kFar, -kFar, -kFar};

  void extend(const FloatBox& b) {
    for (std::size_t k = 0; k < 3; ++k) {
      lo[k] = std::min(lo[k], b.lo[k]);
      hi[k] = std::max(hi[k], b.hi[k]);
    }
  }
  std::size_t longest_axis() const {
    const float x = hi[0] - lo[0], y = hi[1] - lo[1], z = hi[2] - lo[2];
    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  }
  bool overlaps(const FloatBox& b) const {
    return lo[0] <= b.hi[0] && b.lo[0] <= hi[0] && lo[1] <= b.hi[1] && b.lo[1] <= hi[1] &&
           lo[2] <= b.hi[2] && b.lo[2] <= hi[2];
  }
};

/// Halved again and again at the median of the boxes' centres, across their longest extent, down to
/// leaves of a few boxes. Its depth is at most 32.
class BoxTree {
 public:
  /// A leaf holds the `count` boxes from order()[first] on. An inner node has count 0; its children
  /// are the next node and `first`.
  struct Node : FloatBox {
    std::uint32_t first = 0, count = 0;
  };

  BoxTree() = default;
  /// Over the boxes with the numbers in `order`; up to `leaf` of them in one leaf. Costs n log n.
  BoxTree(std::span<const FloatBox> boxes, std::vector<std::uint32_t> order, std::uint32_t leaf)
      : order_(std::move(order)) {
    nodes_.reserve(4 * order_.size() / leaf + 1);  // leaves are at least half full
    if (!order_.empty()) build(boxes, 0, static_cast<std::uint32_t>(order_.size()), leaf);
  }

  const std::vector<Node>& nodes() const { return nodes_; }  ///< the first one is the root
  const std::vector<std::uint32_t>& order() const { return order_; }
  std::size_t memory() const {
    return nodes_.capacity() * sizeof(Node) + order_.capacity() * sizeof(order_[0]);
  }

 private:
  void build(std::span<const FloatBox> boxes, std::uint32_t begin, std::uint32_t end,
             std::uint32_t leaf) {
    const auto self = nodes_.size();
    const auto center = [&](std::uint32_t i, std::size_t axis) {
      return boxes[i].lo[axis] + boxes[i].hi[axis];
    };
    Node node;
    FloatBox centers;
    for (std::uint32_t k = begin; k < end; ++k) {
      const std::uint32_t i = order_[k];
      node.extend(boxes[i]);
      const std::array<float, 3> c{center(i, 0), center(i, 1), center(i, 2)};
      centers.extend({c, c});
    }
    node.first = begin, node.count = end - begin;
    nodes_.push_back(node);
    if (end - begin <= leaf) return;
    const std::size_t axis = centers.longest_axis();
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t i, std::uint32_t j) {
                       const float x = center(i, axis), y = center(j, axis);
                       return x != y ? x < y : i < j;
                     });
    build(boxes, begin, middle, leaf);
    nodes_[self].first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[self].count = 0;
    build(boxes, middle, end, leaf);
  }

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;  ///< numbers of the boxes in the order of the leaves
};

}  // namespace mrsim
