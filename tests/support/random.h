// Numbers for random tests, the same on every machine.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace mrsim::testing {

/// The seed itself, or another one for each MRSIM_TEST_SEED in the environment: tests on inputs
/// that nobody has chosen.
inline std::uint64_t salted(std::uint64_t seed) {
  const char* salt = std::getenv("MRSIM_TEST_SEED");
  return salt == nullptr ? seed : seed + 1'000'003 * std::strtoull(salt, nullptr, 10);
}

/// Xorshift [Marsaglia 2003]; only + - * / of exact numbers.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(salted(seed) * 2654435769u + 88172645463325252u) {}
  std::uint64_t next() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return state_;
  }
  double operator()(double lo, double hi) {
    return lo + (hi - lo) * (static_cast<double>(next() >> 11) * 0x1p-53);
  }
  int pick(int n) { return static_cast<int>(next() % static_cast<std::uint64_t>(n)); }

 private:
  std::uint64_t state_;
};

}  // namespace mrsim::testing
