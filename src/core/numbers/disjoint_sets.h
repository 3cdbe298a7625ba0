// Numbers that are joined to sets, two sets at a time (union-find).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrsim {

class DisjointSets {
 public:
  DisjointSets() = default;
  explicit DisjointSets(std::size_t count) { grow(count); }

  std::size_t size() const { return parent_.size(); }
  /// Adds numbers until there are `count`, each in a set of its own.
  void grow(std::size_t count) {
    const std::size_t first = parent_.size();
    parent_.resize(count);
    for (std::size_t i = first; i < count; ++i) parent_[i] = static_cast<std::uint32_t>(i);
  }
  /// The least number of the set that holds i.
  std::uint32_t least(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// The least number of the set that is made.
  std::uint32_t join(std::uint32_t a, std::uint32_t b) {
    a = least(a), b = least(b);
    return parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;  ///< a number of the same set that is no larger
};

}  // namespace mrsim
