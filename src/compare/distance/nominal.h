// A closed surface that answers signed distances for many points at once.
//
// Distances are exact to rounding. The sign comes from angle-weighted pseudonormals, which are
// right at faces, edges and vertices of a manifold, on walls of any thinness; where surfaces touch
// (an edge of four triangles, a vertex of two fans) or a triangle has no area, the winding number
// decides instead: slow, exact, and rare. Build n log n; a query about 1 us in a batch, because
// points are visited along a space-filling curve and each starts with its forerunner's hit.
#pragma once

#include "core/numbers/triangle_tree.h"
#include <mrsim/types.h>

#include <span>
#include <string>
#include <vector>

namespace mrsim {

/// Signed distance in mm, negative inside, and the triangle that is nearest.
struct SurfaceHit {
  double distance = 0;
  std::uint32_t triangle = 0;
};

class NominalSurface {
 public:
  /// Requires: a mesh that passed require_comparable.
  explicit NominalSurface(const TriMesh& mesh, int threads = 0);

  /// The nearest place of the surface to p, with a signed distance. `hint`: a triangle that is
  /// probably near, for speed only.
  SurfaceHit at(const Vec3& p, std::uint32_t hint = 0) const;
  /// at() for what the tree has found nearest to p.
  SurfaceHit signed_hit(const Vec3& p, const TriangleTree::Hit& hit) const;
  /// out[i] for points[i]; the same for any number of threads. Requires: equal sizes.
  void query(std::span<const Vec3> points, std::span<SurfaceHit> out, int threads = 0) const;

  const TriangleTree& tree() const { return tree_; }
  /// Bytes that it holds.
  std::size_t memory() const;

 private:
  double winding_number(const Vec3& p) const;

  TriangleTree tree_;
  std::vector<std::uint8_t> doubtful_;  ///< #F or empty: bit f is set where feature f needs winding
};

/// Bytes of a triangle that require_comparable() takes at most, to say where a mesh is no solid.
inline constexpr double kCheckBytes = 520;

/// Throws Error "compare-empty", "compare-not-finite", "compare-too-far" (10 km) or
/// "compare-<role>-open" unless the mesh bounds a solid. `role` is "part" or "nominal". Returns its
/// signed volume in mm^3.
double require_comparable(const TriMesh& mesh, const std::string& role, const std::string& name,
                          int threads = 0);

/// Indices of the points along a Morton curve, so that neighbours in the list are near each other.
std::vector<std::uint32_t> spatial_order(std::span<const Vec3> points, const Box3& bounds);

}  // namespace mrsim
