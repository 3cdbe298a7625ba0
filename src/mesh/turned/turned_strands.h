// The outline of a turned part within the squares of a lattice in the half plane (docs/mesh.md,
// Turned parts).
#pragma once

#include "mesh/turned/turned_outline.h"
#include "removal/field/lattice.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace mrsim::detail {

/// mm: closer points of an outline are one.
inline constexpr double kSamePlace = 1e-7;

struct LatticeNode {
  std::int32_t x = 0, z = 0;
};

/// The lattice in the half plane, down to 1 / per_voxel of a voxel; the first line is the axis. At
/// most kMostVoxels to the longest side: voxels that would be smaller are not.
class HalfPlaneLattice {
 public:
  HalfPlaneLattice(const Box3& bounds, double voxel, double finest) {
    const double longest = std::max(bounds.hi.x, bounds.hi.z - bounds.lo.z);
    voxel_ = std::max(voxel, longest / kMostVoxels);
    while (voxel_ / per_voxel_ > finest && per_voxel_ < kMostParts) per_voxel_ *= 2;
    first_z_ = lattice_floor(voxel_, bounds.lo.z, kLatticeShift.z) - 1;
    while (size_ < longest / voxel_ + 4) size_ *= 2;
  }
  double voxel() const { return voxel_; }
  std::int32_t per_voxel() const { return per_voxel_; }
  std::int32_t size() const { return size_ * per_voxel_; }  ///< of a square that holds the section
  Vec3 at(LatticeNode n) const {
    const double u = static_cast<double>(n.x) / per_voxel_, shift = 1 - kLatticeShift.x;
    const double w = static_cast<double>(n.z) / per_voxel_;
    return {voxel_ * (u < 1 ? u * (1 - shift) : u - shift), 0,
            voxel_ * (static_cast<double>(first_z_) + kLatticeShift.z + w)};
  }

 private:
  static constexpr std::int32_t kMostParts = 1 << 10, kMostVoxels = 1 << 16;
  double voxel_ = 1;
  std::int32_t per_voxel_ = 1, size_ = 1;
  std::int64_t first_z_ = 0;
};

struct Square {
  LatticeNode low;
  std::int32_t size = 0;
  /// Counter-clockwise.
  LatticeNode corner(int k) const {
    return {low.x + (k == 1 || k == 2 ? size : 0), low.z + (k >= 2 ? size : 0)};
  }
};

/// The outline within a square.
struct Strand {
  std::uint64_t from = 0, to = 0;  ///< where it passes the border, by names that all squares share
  std::vector<OutlinePoint> points;  ///< without the end
  Vec3 end;
};

/// The strands that pass a square.
struct TracedSquare {
  std::vector<Strand> strands;
  std::vector<FoundThin> thin;
};

/// Follows the outline through a square, or through its quarters where the samples of the square do
/// not fit a simple strand; `height` as for turned_section(). Requires: `candidates` hold about the
/// square.
TracedSquare trace_square(const ExactField& field, const HalfPlaneLattice& lattice,
                          const Square& square, std::span<const std::uint32_t> candidates,
                          double height);

}  // namespace mrsim::detail
