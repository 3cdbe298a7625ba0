// A queue of triangles that are worked on at once.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <span>
#include <utility>
#include <vector>

namespace mrsim::detail {

class ApartQueue {
 public:
  /// Does nothing if the triangle is in the queue already.
  void push(std::uint32_t triangle) {
    if (triangle >= waits_.size()) waits_.resize(triangle + 1, 0);
    if (std::exchange(waits_[triangle], 1) == 0) queue_.push_back(triangle);
  }
  bool empty() const { return queue_.empty(); }

  /// Takes triangles from the front of the queue, no two with a common corner, so that changing one
  /// of them hardly ever changes another. The others keep their places. `corners`: of every
  /// triangle; `vertices`: how many there are.
  std::vector<std::uint32_t> take(std::span<const std::array<std::uint32_t, 3>> corners,
                                  std::size_t vertices) {
    constexpr std::size_t kMost = 8192;  // triangles that are looked at
    std::vector<std::uint32_t> apart, others;
    ++turn_;
    turns_.resize(vertices, 0);
    for (std::size_t k = std::min(queue_.size(), kMost); k > 0; --k) {
      const std::uint32_t t = queue_.front();
      queue_.pop_front();
      const auto& x = corners[t];
      const bool is_apart =
          std::none_of(x.begin(), x.end(), [&](std::uint32_t v) { return turns_[v] == turn_; });
      (is_apart ? apart : others).push_back(t);
      waits_[t] = !is_apart;
      for (const std::uint32_t v : x)
        if (is_apart) turns_[v] = turn_;
    }
    queue_.insert(queue_.begin(), others.begin(), others.end());
    return apart;
  }

 private:
  std::deque<std::uint32_t> queue_;
  std::vector<char> waits_;  ///< by triangle
  std::uint32_t turn_ = 0;
  std::vector<std::uint32_t> turns_;  ///< by vertex: the last one that took a triangle there
};

}  // namespace mrsim::detail
