// A region in the form that the pruning loops take, with bounds of their errors in single precision
// (docs/removal.md).
#pragma once

#include "removal/prune/candidate_list.h"

#include <algorithm>
#include <cmath>

namespace mrsim {

inline constexpr double kHalfUlp = 1.0 / (1 << 24);  ///< of a float, relative

/// Factors that widen a size, and the spread of packs, by more than it is rounded as a float.
inline constexpr double kWider = 1.000001, kWiderSpread = 1.0001;

/// The region about the list's origin; the members for errors are not set.
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

/// The largest coordinate or size that the loops compute with, as far as it is known before.
inline double near_extent(const RegionArgs& a, const CandidateList& list) {
  return std::max<double>({list.extent, std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)});
}

/// Sets the error of the loops: less than 64 half ulps of the largest value.
inline void set_delta(RegionArgs& a, double extent, double radius) {
  a.delta = static_cast<float>(64 * kHalfUlp * (extent + radius));
}

/// Sets the margin by which one candidate must beat another. The skeletons of two packs differ from
/// their chords by up to `spread` mm together, and so do the distances of a point from them.
/// Squares of the distances differ by that times twice the larger distance.
inline void set_margin(RegionArgs& a, float spread) {
  a.fixed = a.delta * (4 * a.radius + 16 * a.delta) + kTieMargin + 2 * spread * a.radius;
  a.per_root = 4 * a.delta + 2 * spread;
}

/// mm: sweeps farther from the centre than this can be dropped. The nearest sweep is at `least`, or
/// nearer by up to `unsure`; `slack` is the rounding of a difference of distances. A sweep that is
/// 2r farther than the nearest one loses to it in the whole region, since both distances are
/// 1-Lipschitz. If no sweep comes within `reach`, none is wanted.
inline double kept_within(double least, double unsure, const PruneRegion& region, double reach,
                          double slack) {
  return least - unsure > reach ? reach : least + 2 * region.radius + slack;
}

/// mm: the largest distance of a point of the region from the point at (x, y, z) from its centre.
inline double farthest(const PruneRegion& region, double x, double y, double z) {
  if (!region.box) return std::sqrt(x * x + y * y + z * z) + region.radius;
  const double dx = std::fabs(x) + region.half, dy = std::fabs(y) + region.half,
               dz = std::fabs(z) + region.tall;
  return std::sqrt(dx * dx + dy * dy + dz * dz);
}

/// mm: the distance that the loops' comes_within() is asked about. However the loops are rounded, a
/// region that does not come so near to a skeleton is nowhere nearer to the sweep than `reach` less
/// the region's radius.
inline float surely_within(const RegionArgs& a, const PruneRegion& region, double reach) {
  return static_cast<float>(kWider * (a.tool.round + reach - region.radius)) + 16 * a.delta;
}

}  // namespace mrsim
