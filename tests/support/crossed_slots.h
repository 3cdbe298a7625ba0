// Narrow level slots that cross each other in every voxel of a long bar: pieces of surface in one
// cell whose triangles meet, so that the uniform mesher splits cells and makes its tiles again.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace mrsim::testing {

inline constexpr double kCrossedSize[3] = {50, 10, 4};  ///< the bar, from the origin, mm
inline constexpr double kCrossedMill = 0.25;            ///< diameter, mm
inline constexpr double kCrossedVoxel = 0.5;            ///< mm

/// x and y of both ends and the height, multiples of 0.05 mm.
inline std::vector<std::array<double, 5>> crossed_slots() {
  std::uint32_t state = 1;
  const auto number = [&](int low, int high) {  // the same on every machine
    state = state * 1664525u + 1013904223u;
    return 0.05 *
           (20 * low + static_cast<int>((state >> 8) % static_cast<unsigned>(20 * (high - low))));
  };
  std::vector<std::array<double, 5>> out;
  for (int k = 0; k < 250; ++k) {
    const double x = number(-1, 46), y = number(-1, 11), z = number(1, 4);
    out.push_back({x, y, x + number(-10, 10), number(-1, 11), z});
  }
  return out;
}

}  // namespace mrsim::testing
