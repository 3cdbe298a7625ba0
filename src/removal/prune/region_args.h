// A region as the pruning loops see it, with what single precision may err by (docs/removal.md).
#pragma once

#include "removal/prune/candidate_list.h"

#include <algorithm>
#include <cmath>

namespace mrsim {

inline constexpr double kHalfUlp = 1.0 / (1 << 24);  ///< of a float, relative

/// Factors that widen a size, and the spread of packs, by more than it is rounded as a float.
inline constexpr double kWider = 1.000001, kWiderSpread = 1.0001;

/// About the list's origin; without errors.
inline RegionArgs region_args(const PruneRegion& region, const Vec3& origin) {
  RegionArgs a;
  a.x = static_cast<float>(region.center.x - origin.x);
  a.y = static_cast<float>(region.center.y - origin.y);
  a.z = static_cast<float>(region.center.z - origin.z);
  a.half = static_cast<float>(region.half * kWider);
  a.tall = static_cast<float>(region.tall * kWider);
  a.radius = static_cast<float>(region.radius * kWider);
  a.box = region.box;
  return a;
}

/// The largest coordinate or size that the loops meet, of those known before.
inline double near_extent(const RegionArgs& a, const CandidateList& list) {
  return std::max<double>({list.extent, std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)});
}

/// The loops err by less than 64 half ulps of the largest value.
inline void set_delta(RegionArgs& a, double extent, double radius) {
  a.delta = static_cast<float>(64 * kHalfUlp * (extent + radius));
}

/// Margin of dominance. The skeletons of two packs differ from their chords by up to `spread` mm
/// together: so do the distances of a point from them, and their squares by that times twice the
/// larger one.
inline void set_margin(RegionArgs& a, float spread) {
  a.fixed = a.delta * (4 * a.radius + 16 * a.delta) + kTieMargin + 2 * spread * a.radius;
  a.per_root = 4 * a.delta + 2 * spread;
}

/// mm: how far from the centre sweeps may be that are kept, where the nearest one is at most at
/// `least`, or nearer by up to `unsure`; `slack`: of a difference of distances. One farther than 2r
/// beyond it loses to it everywhere, as both are 1-Lipschitz: so d is exact in all of the region,
/// however deep in the material. Where none comes within `reach`, none is wanted.
inline double kept_within(double least, double unsure, const PruneRegion& region, double reach,
                          double slack) {
  return least - unsure > reach ? reach : least + 2 * region.radius + slack;
}

/// mm: how far the points of the region are at most from a point at (x, y, z) beside its centre.
inline double farthest(const PruneRegion& region, double x, double y, double z) {
  if (!region.box) return std::sqrt(x * x + y * y + z * z) + region.radius;
  const double dx = std::fabs(x) + region.half, dy = std::fabs(y) + region.half,
               dz = std::fabs(z) + region.tall;
  return std::sqrt(dx * dx + dy * dy + dz * dz);
}

/// mm: what comes_within() of the loops is asked, so that errors do not matter: the distance from a
/// skeleton at which a region ends to be deep in the material.
inline float surely_within(const RegionArgs& a, const PruneRegion& region, double reach) {
  return static_cast<float>(kWider * (a.tool.round + reach - region.radius)) + 16 * a.delta;
}

}  // namespace mrsim
