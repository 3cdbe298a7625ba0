// Exact signed distance to a closed triangle mesh: a tree of boxes over its triangles,
// point-triangle distances in double, sign by angle-weighted pseudonormals (Baerentzen and Aanaes
// 2005), which is right at edges and vertices too.
//
// Guarantees: the same bits on every machine; nearest() is exact up to rounding. Does not check the
// mesh: the sign means nothing for an open or wrongly oriented one. Cost: building n log n, a query
// about log n.
#pragma once

#include "core/numbers/wide_box_tree.h"
#include <mrsim/types.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace mrsim {

/// Where on a triangle the nearest point lies: 0..2 its corners, 3..5 the edges from corner i - 3
/// to the next, 6 inside.
using TriangleFeature = std::uint8_t;
inline constexpr TriangleFeature kTriangleFace = 6;

/// The point of a triangle that is nearest to p.
struct TrianglePoint {
  Vec3 point;
  double distance2 = std::numeric_limits<double>::infinity();  ///< mm^2
  TriangleFeature feature = kTriangleFace;
};
TrianglePoint nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

class TriangleTree {
 public:
  struct Hit : TrianglePoint {
    std::uint32_t triangle = 0;
  };

  struct Corners {
    Vec3 a, b, c;
  };

  /// What has a box of its own: triangles, or their pieces where they are longer than most. Pieces
  /// take up to three times the memory of boxes and make searches among long, thin triangles,
  /// whose boxes overlap, three times as fast.
  enum class Boxes : std::uint8_t { triangles, pieces };

  /// Requires: at least one triangle, indices in range, finite vertices.
  explicit TriangleTree(const TriMesh& mesh, Boxes boxes = Boxes::triangles);

  /// The nearest point of the mesh; of several triangles at the same distance the one with the
  /// least index. A `hint` (any triangle, such as the one nearest to a neighbour of p) makes the
  /// search faster and does not change its result.
  Hit nearest(const Vec3& p, std::uint32_t hint = 0) const;
  /// Whether p lies no farther than `most` mm from the mesh; cheaper than nearest().
  bool is_near(const Vec3& p, double most) const;
  /// The point in plan (z = 0) of what the mesh has above p.z that is nearest to p, nearer than
  /// `most`, mm. Without one the distance is infinite.
  TrianglePoint nearest_in_plan(const Vec3& p, double most) const;
  /// Calls visit(triangle) for all triangles that may touch the box, in a fixed order, until it
  /// returns false; a triangle that has pieces may come more than once.
  template <class Visit>
  void visit(const Box3& box, Visit&& visit) const {
    boxes_.visit(box, visit);
  }
  /// Outward pseudonormal of the feature that was hit, not of unit length.
  Vec3 pseudonormal(const Hit& hit) const;
  /// Distance with its sign, negative inside.
  double signed_distance(const Vec3& p, const Hit& hit) const;
  double signed_distance(const Vec3& p) const { return signed_distance(p, nearest(p)); }
  /// Unit normal of a triangle; zero for one without area.
  Vec3 normal(std::uint32_t triangle) const;
  Corners corners(std::uint32_t triangle) const;
  double area(std::uint32_t triangle) const;  ///< mm^2
  /// Triangles across the edges from corner i to the next; size() or more where there is none.
  const std::array<std::uint32_t, 3>& neighbors(std::uint32_t triangle) const {
    return neighbors_[triangle];
  }
  std::size_t size() const { return triangles_.size(); }
  const Box3& bounds() const { return bounds_; }
  std::size_t memory() const;

 private:
  void build_boxes(Boxes boxes);
  void build_normals(std::size_t vertices);

  std::vector<std::array<std::array<float, 3>, 3>> corners_;  ///< by triangle, in one place
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  WideBoxTree boxes_;
  std::vector<std::array<std::uint32_t, 3>>
      neighbors_;  ///< across the edge from corner i to the next
  std::vector<Vec3> vertex_normals_;
  Box3 bounds_;
};

}  // namespace mrsim
