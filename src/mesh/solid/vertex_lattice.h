// Coordinates of the mesher. The planes of its grid and all vertices are multiples of 2^-20 mm that
// a float holds, so that what is decided about them is true of the file too, and predicates on them
// are exact in 128-bit integers.
#pragma once

#include "core/numbers/vec.h"
#include "removal/field/lattice.h"
#include <mrsim/types.h>

#include <cmath>
#include <cstdint>
#include <utility>

namespace mrsim::detail {

inline constexpr double kQuantum = 1.0 / (1 << 20);  ///< mm

/// The nearest coordinate that a vertex may have. The rounding to the 24 bits of a float is
/// Veltkamp's split: GCC 12 drops a cast to float and back when it vectorises three of them (-O2).
inline double snap(double x) {
  const double y = std::floor(x / kQuantum + 0.5) * kQuantum;
  const double c = y * ((1 << 29) + 1.0);
  return c - (c - y);
}
inline Vec3 snap(const Vec3& p) { return {snap(p.x), snap(p.y), snap(p.z)}; }

/// Whether a vertex may lie at p, and predicates on it are exact.
inline bool is_vertex(const Vec3& p) {
  constexpr double kMost = 4096;  // mm
  return p == snap(p) && std::abs(p.x) < kMost && std::abs(p.y) < kMost && std::abs(p.z) < kMost;
}

/// More than the distance of two neighbouring coordinates about x.
inline double coordinate_step(double x) {
  const double a = x < 0 ? -x : x;
  const double ulp = a * (1.0 / (1 << 22));
  return ulp > 2 * kQuantum ? ulp : 2 * kQuantum;
}

/// What coordinates strictly between two planes of the grid are moved into: off both by at least
/// two steps.
inline std::pair<double, double> inner(double low, double high) {
  const double a = coordinate_step(low), b = coordinate_step(high), step = 2 * (a < b ? b : a);
  return {snap(low + step), snap(high - step)};
}
inline Box3 inner(const Box3& room) {
  const auto x = inner(room.lo.x, room.hi.x), y = inner(room.lo.y, room.hi.y),
             z = inner(room.lo.z, room.hi.z);
  return {{x.first, y.first, z.first}, {x.second, y.second, z.second}};
}
/// Whether the line from p to q, on both sides of a face that is flat on the axis, passes clearly
/// inside it. Always so where p and q are in the inner boxes of two cells of one size that share
/// this face: the margin is at most half of what inner() keeps off.
inline bool passes_inside(const Box3& face, int axis, const Vec3& p, const Vec3& q) {
  const double plane = mrsim::component(face.lo, axis), from = mrsim::component(p, axis);
  const Vec3 x = lerp(p, q, (plane - from) / (mrsim::component(q, axis) - from));
  for (const int a : {(axis + 1) % 3, (axis + 2) % 3}) {
    const double low = mrsim::component(face.lo, a), high = mrsim::component(face.hi, a);
    const double margin = 0.5 * (coordinate_step(low) + coordinate_step(high));
    if (!(mrsim::component(x, a) > low + margin && mrsim::component(x, a) < high - margin))
      return false;
  }
  return true;
}
/// x rounded, and moved between two coordinates.
inline double snap_between(double x, double low, double high) {
  const double y = snap(x), z = y < low ? low : y;
  return high < z ? high : z;
}
inline Vec3 snap_into(const Vec3& p, const Box3& inner) {
  return {snap_between(p.x, inner.lo.x, inner.hi.x), snap_between(p.y, inner.lo.y, inner.hi.y),
          snap_between(p.z, inner.lo.z, inner.hi.z)};
}

struct LatticePoint {
  std::int32_t x = 0, y = 0, z = 0;
  friend bool operator==(const LatticePoint&, const LatticePoint&) = default;
};
inline std::int32_t& component(LatticePoint& p, int i) { return i == 0 ? p.x : i == 1 ? p.y : p.z; }
inline std::int32_t component(const LatticePoint& p, int i) {
  return i == 0 ? p.x : i == 1 ? p.y : p.z;
}
inline std::uint64_t key(const LatticePoint& p) {
  return static_cast<std::uint64_t>(p.x) | static_cast<std::uint64_t>(p.y) << 21 |
         static_cast<std::uint64_t>(p.z) << 42;
}

/// The grid: a cube of 2^levels fine units, voxel * 2^-halvings each, aligned with the carver's
/// samples.
class Lattice {
 public:
  Lattice() = default;
  /// Begins `margin` voxels before the bounds.
  Lattice(const Box3& bounds, double voxel, int halvings, int margin = 2)
      : voxel_(voxel), fine_(voxel / (1 << halvings)), per_voxel_(1 << halvings) {
    const Vec3 size = bounds.hi - bounds.lo;
    const double longest =
        size.x > size.y ? (size.x > size.z ? size.x : size.z) : (size.y > size.z ? size.y : size.z);
    std::int64_t voxels = 8;
    while (static_cast<double>(voxels) < longest / voxel + 6) voxels *= 2;
    size_ = voxels * per_voxel_;
    for (int a = 0; a < 3; ++a)
      first_[a] =
          lattice_floor(voxel, mrsim::component(bounds.lo, a), mrsim::component(kLatticeShift, a)) -
          margin;
  }

  double voxel() const { return voxel_; }
  std::int64_t size() const { return size_; }
  std::int32_t per_voxel() const { return per_voxel_; }
  double fine() const { return fine_; }

  double coordinate(int axis, std::int32_t i) const {
    const double base = static_cast<double>(first_[axis]) + mrsim::component(kLatticeShift, axis);
    return snap(voxel_ * base + fine_ * static_cast<double>(i));
  }
  /// The last point of the lattice at or below p on each axis, up to the rounding of coordinates.
  LatticePoint floor(const Vec3& p) const {
    const auto index = [&](int axis) {
      const double base =
          voxel_ * (static_cast<double>(first_[axis]) + mrsim::component(kLatticeShift, axis));
      return static_cast<std::int32_t>((mrsim::component(p, axis) - base) / fine_);
    };
    return {index(0), index(1), index(2)};
  }
  /// The point of the lattice at p, up to the rounding of coordinates.
  LatticePoint nearest(const Vec3& p) const {
    const double half = 0.5 * fine_;
    return floor(p + Vec3{half, half, half});
  }
  Vec3 position(const LatticePoint& p) const {
    return {coordinate(0, p.x), coordinate(1, p.y), coordinate(2, p.z)};
  }

 private:
  double voxel_ = 1, fine_ = 1;
  std::int32_t per_voxel_ = 1;
  std::int64_t size_ = 0;
  std::int64_t first_[3] = {};
};

}  // namespace mrsim::detail
