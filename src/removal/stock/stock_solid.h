// The stock before the first cut as a signed distance: negative inside, exact everywhere for box,
// cylinder and tube.
#pragma once

#include "core/numbers/rounding.h"
#include "core/numbers/triangle_tree.h"
#include "core/numbers/vec.h"
#include "removal/field/field.h"
#include <mrsim/types.h>

#include <memory>
#include <vector>

namespace mrsim {

/// Faces of the primitives, as FieldSample::patch numbers them.
enum StockPatch : std::int32_t {
  kBoxXLow,
  kBoxXHigh,
  kBoxYLow,
  kBoxYHigh,
  kBoxZLow,
  kBoxZHigh,  // box
  kRoundWall = 0,
  kRoundBottom,
  kRoundTop,
  kRoundBore  // cylinder and tube
};

class StockSolid {
 public:
  struct Sample {
    double distance = 0;
    std::int32_t patch = 0;
  };

  /// Requires, for a mesh: closed and oriented outwards. Throws Error "stock-empty" for a solid
  /// without volume.
  explicit StockSolid(StockShape shape);

  double distance(const Vec3& p) const { return sample(p).distance; }
  bool is_box() const { return shape_.kind == StockShape::Kind::box; }
  /// Whether the stock has one section at all heights: a box, cylinder or tube.
  bool is_upright() const { return shape_.kind != StockShape::Kind::mesh; }
  /// Signed distance in plan from the sides. Requires: is_upright().
  double plan_distance(double x, double y) const;
  /// Unit outward normal of the side that plan_distance() counts from. Requires: a cylinder or
  /// tube.
  Vec2 plan_normal(double x, double y) const;
  /// The largest signed distance from a box's six planes: distance() inside, no more than that
  /// outside, and it changes by no more than any coordinate. Requires: is_box().
  double plane_distance(const Vec3& p) const;
  /// out[k] = distance({x[k], y[k], z[k]}), the same bits. With `cut`, the distances from what has
  /// been cut, only where that is -cut[k] or more, so that it decides; else something below that.
  void distances(std::size_t n, const double* x, const double* y, const double* z, double* out,
                 const double* cut = nullptr) const;
  /// With `least`, only a distance of at least that is exact; a lower one is told by some lower
  /// one.
  Sample sample(const Vec3& p, double least = -kInfinity) const;
  /// Unit outward normal of the patch at the point of it that is nearest to p.
  Vec3 gradient(const Vec3& p, std::int32_t patch) const;
  /// Signed distance from the patch's plane or cylinder, untrimmed; positive outside.
  double patch_distance(const Vec3& p, std::int32_t patch) const;
  /// Encloses patch_distance() on a triangle.
  FaceRange patch_range(const Corners3& t, std::int32_t patch) const;
  const Box3& bounds() const { return shape_.box; }
  /// A cylinder or tube about the Z axis: the same at every angle.
  bool is_turned() const;
  /// 0 where it is no mesh.
  std::size_t triangles() const { return shape_.mesh.triangles.size(); }
  /// mm^3; of a mesh, its signed volume.
  double volume() const;
  /// mm^2.
  double area() const;
  /// mm of edges of a mesh, by the sine of half the angle of their faces; 0 where it is no mesh.
  double bent_edges() const { return bent_edges_; }
  /// Of a mesh; flat faces of more than a hundredth of it are large.
  const StockFacets& facets() const { return facets_; }

 private:
  Sample sample_box(const Vec3& p) const;
  Sample sample_round(const Vec3& p) const;
  Sample sample_mesh(const Vec3& p, double least) const;
  double radius_at(const Vec3& p) const;
  void find_flat_faces();
  void find_bends();
  double find_facet_area() const;

  StockShape shape_;
  std::shared_ptr<const TriangleTree> tree_;  // mesh; shared so that a solid stays a value
  std::uint64_t number_ = 0;                  // mesh: another one for every tree
  std::vector<std::int32_t> faces_;           // mesh: the flat face of each triangle
  struct Plane {
    Vec3 normal;
    double offset;  // dot(normal, point of the plane)
  };
  std::vector<Plane> planes_;  // mesh: of each flat face
  double bent_edges_ = 0;
  StockFacets facets_;
};

}  // namespace mrsim
