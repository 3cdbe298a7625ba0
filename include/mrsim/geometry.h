/// mrsim: points and boxes.
#pragma once

#include <limits>

namespace mrsim {

/// A point or a vector, in mm unless said otherwise.
struct Vec3 {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

/// An axis-aligned box; empty when lo > hi on any axis.
struct Box3 {
  Vec3 lo{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
          std::numeric_limits<double>::infinity()};
  Vec3 hi{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
          -std::numeric_limits<double>::infinity()};
  friend bool operator==(const Box3&, const Box3&) = default;
};

}  // namespace mrsim
