// A list of indices that needs no memory of its own while it is short.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrsim::detail {

template <std::size_t N>
class SmallList {
 public:
  void push_back(std::int32_t x) {
    if (rest_.empty() && count_ < N) {
      few_[count_++] = x;
      return;
    }
    if (rest_.empty()) rest_.assign(few_.begin(), few_.end());
    rest_.push_back(x);
    ++count_;
  }
  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  const std::int32_t* begin() const { return rest_.empty() ? few_.data() : rest_.data(); }
  const std::int32_t* end() const { return begin() + count_; }
  std::int32_t operator[](std::size_t i) const { return begin()[i]; }
  std::int32_t back() const { return begin()[count_ - 1]; }

 private:
  std::array<std::int32_t, N> few_{};
  std::size_t count_ = 0;
  std::vector<std::int32_t> rest_;  ///< all of them, once they are more than N
};

}  // namespace mrsim::detail
