// The largest tool that reaches a place without cutting a solid: opening of the space outside of it
// by a ball, and by an upright cylinder that comes from above.
//
// Both are found on a lattice about the places. A lattice that holds large tools is coarse, so the
// search is repeated with smaller tools on finer lattices until the voxels of the level set.
#pragma once

#include <mrsim/types.h>

#include <span>

#include <openvdb/openvdb.h>

namespace mrsim {

struct Reach {
  double diameter = 0;    ///< mm
  double error = 0;       ///< mm, either way
  bool is_least = false;  ///< larger ones were not tried
};

/// The largest ball that, moved about outside of the solid, comes to each of the places. `solid`: a
/// level set. `most`: the largest diameter that is tried, mm.
Reach largest_ball(const openvdb::FloatGrid& solid, std::span<const Vec3> places, double most);

/// The same for an upright cylinder with a flat end below and no end above.
Reach largest_cylinder(const openvdb::FloatGrid& solid, std::span<const Vec3> places, double most);

}  // namespace mrsim
