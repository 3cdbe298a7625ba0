// Hausdorff distances with a proven bound, by splitting triangles until they are decided.
//
// The largest distance of any point of a triangle S from the other surface is bounded from above
// by each of
//   (1) min over a few triangles T of the largest distance of S's corners from T, since distance
//       to a convex set is convex (as in Tang, Lee, Kim 2009; Cignoni et al. 1998 sample instead);
//   (2) the distance at S's centre plus its radius, since distances are 1-Lipschitz;
//   (3) where S lies over a flat patch of the other surface, or over one triangle and those about
//       it, the heights of its corners, and how far those stray from their plane.
// Pieces whose bound exceeds the largest distance found by more than the error are split along the
// borders of the patch below them or of the nearest triangle's features, so that (1) and (3) become
// exact; where there is no such border, they are halved.
#pragma once

#include "compare/distance/flat_patches.h"
#include <mrsim/compare.h>

#include <algorithm>

namespace mrsim {

/// Directed: the largest distance of a point of `from` from the surface `to`. `known` is a distance
/// reached at `place` (the largest over the samples). Stops at `error`, or after `budget` pieces or
/// where memory ends, with the bound that stands then.
HausdorffBound directed_hausdorff(const TriMesh& from, const NominalSurface& to,
                                  const FlatPatches& patches, double known, const Vec3& place,
                                  double error, std::size_t budget, int threads);

inline constexpr std::size_t kHausdorffPieces = 300'000;

/// How close a bound is searched: to `least` mm, or to `share` of the distance where that is more.
struct DistanceError {
  double least = 0, share = 0;
  double of(double distance) const { return std::max(least, share * distance); }
};
/// Where nobody asks for another: a tenth of a micrometre, or a hundredth of the distance.
inline constexpr DistanceError kUsualError{1e-4, 0.01};

/// The larger of both directed distances of two surfaces, of which either may be open.
HausdorffBound surface_distance(const TriMesh& a, const TriMesh& b, const DistanceError& error,
                                int threads);

}  // namespace mrsim
