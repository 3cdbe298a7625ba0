// The owners that a mesh names, collected as its blocks come.
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <vector>

namespace mrsim {

class OwnerSet {
 public:
  /// Takes about a nanosecond an owner, and a bit of memory for each number up to the largest. The
  /// few numbers beyond 2^26 are kept in a set.
  void add(std::span<const std::int32_t> owners);
  void clear() { *this = {}; }
  /// Ascending, each once.
  std::vector<std::int32_t> sorted() const;

 private:
  static constexpr std::uint32_t kDense = std::uint32_t(1) << 26;
  std::vector<std::uint64_t> seen_;  ///< bits, by owner + 1
  std::set<std::int32_t> sparse_;
};

}  // namespace mrsim
