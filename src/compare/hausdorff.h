// Hausdorff distances with a proven bound, by subdividing triangles until they are decided.
//
// The largest distance of any point of a triangle S from the other surface is bounded from above
// by each of
//   (1) min over a few triangles T of the largest distance of S's corners from T, since distance
//       to a convex set is convex (as in Tang, Lee, Kim 2009; Cignoni et al. 1998 sample instead);
//   (2) the distance at S's centre plus its radius, since distances are 1-Lipschitz;
//   (3) where the other surface is flat about S: the heights of S's corners above that plane. Flat
//       means that no crease of the other surface comes nearer to the centre's foot than S's
//       radius. Without (3), two flat faces with different triangles cost area / distance^2 pieces.
// Pieces whose bound exceeds the largest distance found by more than the error are halved.
#pragma once

#include "compare/nominal.h"
#include <mrsim/compare.h>

#include <memory>

namespace mrsim {

/// The coplanar patches of a surface and a distance query to the creases between them.
class FlatPatches {
 public:
  explicit FlatPatches(const TriMesh& mesh);
  /// Whether the patch of `triangle` has more triangles.
  bool is_joined(std::uint32_t triangle) const { return joined_[triangle]; }
  /// Height above the plane of the patch of `triangle`, and how far the patch strays from it.
  double height(std::uint32_t triangle, const Vec3& p) const;
  double flatness() const { return flatness_; }
  /// Distance of p from the nearest border of a joined patch; infinite when there is none.
  /// `hint` is where the last search ended, and makes this one faster.
  double crease_distance(const Vec3& p, std::uint32_t& hint) const;
  std::size_t memory() const;

 private:
  double flatness_ = 0;
  std::vector<std::uint32_t> seed_;  ///< #F: the triangle whose plane the patch has
  std::vector<bool> joined_;
  std::vector<Vec3> origins_, normals_;
  std::unique_ptr<TriangleTree> creases_;
};

/// Directed: the largest distance of a point of `from` from the surface `to`. `known` is a distance
/// reached at `place` (the largest over the samples). Stops at `error`, or after `budget` pieces
/// with the bound that stands then.
HausdorffBound directed_hausdorff(const TriMesh& from, const NominalSurface& to,
                                  const FlatPatches& patches, double known, const Vec3& place,
                                  double error, std::size_t budget, int threads);

}  // namespace mrsim
