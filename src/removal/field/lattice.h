// The sampling lattice, fixed in stock coordinates: voxel (i, j, k) is sampled at voxel * ((i, j,
// k) + kLatticeShift).
//
// The shift is made of odd 64ths, so that coordinates as programs use them (multiples of the voxel,
// halves, tenths) never fall on a sample, and a plane of the part never runs through a layer of
// samples.
#pragma once

#include <mrsim/types.h>

#include <cmath>

namespace mrsim {

inline constexpr Vec3 kLatticeShift{29.0 / 64.0, 21.0 / 64.0, 35.0 / 64.0};

/// Half width of the narrow band in voxels.
inline constexpr double kBandVoxels = 3;

/// Position in mm of the sample with the given lattice coordinate on one axis.
inline double lattice_position(double voxel, std::int64_t index, double shift) {
  return voxel * (static_cast<double>(index) + shift);
}

/// The last lattice coordinate at or below x mm.
inline std::int64_t lattice_floor(double voxel, double x, double shift) {
  return static_cast<std::int64_t>(std::floor(x / voxel - shift));
}

}  // namespace mrsim
