// Items sorted into groups that share a list of candidates, so that they can be sampled together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mrsim::detail {

class Groups {
 public:
  /// Sorts the items by group_of(item), a number below `count`. Groups come in the order of their
  /// first items, and the items of a group in theirs.
  template <class GroupOf>
  Groups(std::span<const std::int32_t> items, std::size_t count, GroupOf group_of) {
    std::vector<std::int32_t> number(count, -1);
    std::vector<std::uint32_t> of(items.size());
    for (std::size_t k = 0; k < items.size(); ++k) {
      std::int32_t& n = number[static_cast<std::size_t>(group_of(items[k]))];
      if (n < 0) {
        n = static_cast<std::int32_t>(begin_.size());
        begin_.push_back(0);
      }
      of[k] = static_cast<std::uint32_t>(n);
      ++begin_[of[k]];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& b : begin_) {
      const std::uint32_t size = b;
      b = sum;
      sum += size;
    }
    begin_.push_back(sum);
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end());
    items_.resize(items.size());
    for (std::size_t k = 0; k < items.size(); ++k) items_[next[of[k]]++] = items[k];
  }

  std::size_t size() const { return begin_.size() - 1; }
  std::span<const std::int32_t> operator[](std::size_t g) const {
    return {items_.data() + begin_[g], begin_[g + 1] - begin_[g]};
  }

 private:
  std::vector<std::int32_t> items_;
  std::vector<std::uint32_t> begin_;
};

}  // namespace mrsim::detail
