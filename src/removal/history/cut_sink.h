// The lattice of a stock's history, and the interface of whoever takes its voxels.
#pragma once

#include "removal/field/lattice.h"
#include <mrsim/types.h>

#include <array>
#include <cstdint>

namespace mrsim {

inline constexpr std::int32_t kStillThere = -1;  ///< no motion removes the place
inline constexpr std::int32_t kNeverThere = -2;  ///< the place lies outside of the stock

/// Where voxels lie: in space, or for turned parts in the half plane y = 0, x >= 0, where each
/// voxel stands for a ring about the Z axis.
struct CutLattice {
  double voxel = 0;  ///< mm
  bool half_plane = false;

  /// Centre of a voxel, mm. In space the lattice is that of the level set (lattice.h).
  Vec3 position(const std::array<std::int32_t, 3>& at) const {
    const double z = lattice_position(voxel, at[2], kLatticeShift.z);
    if (half_plane) return {lattice_position(voxel, at[0], 0.5), 0, z};
    return {lattice_position(voxel, at[0], kLatticeShift.x),
            lattice_position(voxel, at[1], kLatticeShift.y), z};
  }
};

/// A cube of size^3 voxels; in the half plane a square of size x 1 x size.
struct CutCell {
  std::array<std::int32_t, 3> origin{};  ///< its first voxel
  int size = 0;
};

/// Takes the voxels of a walk, each exactly once.
class CutSink {
 public:
  virtual ~CutSink() = default;
  /// All voxels of a cell are cut by one motion, or are kStillThere or kNeverThere.
  virtual void tile(const CutCell& cell, std::int32_t cut) = 0;
  /// The voxels of a cell of 4 or 8 voxels each way, z fastest, then y.
  virtual void leaf(const CutCell& cell, const std::int32_t* cut) = 0;
};

}  // namespace mrsim
