// Numbers for random programs, the same on every machine.
#pragma once

#include <cstdint>
#include <random>

namespace mrsim::testing {

class Random {
 public:
  explicit Random(std::uint64_t seed) : random_(seed) {}
  double operator()(double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  int pick(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }

 private:
  std::mt19937_64 random_;
};

}  // namespace mrsim::testing
