// From loops to triangles. A loop's vertex lies strictly inside its cell, a segment's strictly
// inside its face, a crossing strictly inside its edge: cones from the loops' vertices over their
// segments can not meet, and where face and edge vertices are left out, orientation tests see to it
// that each polygon stays in the envelope of its edge [Ju and Udeshi 2006].
#pragma once

#include "mesh/surface/surface_graph.h"

#include <array>
#include <span>
#include <utility>
#include <vector>

namespace mrsim::detail {

struct BaseMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::int32_t> crossings;  ///< by triangle: the crossing of the edge that it surrounds
  /// Triangles that lie on another face of the part than their crossing, ascending.
  std::vector<std::pair<std::uint32_t, FieldSample>> moved;
};

class LoopTriangles : public SurfaceStep {
 public:
  LoopTriangles(SurfaceGraph& graph, BaseMesh& mesh) : SurfaceStep(graph), mesh_(mesh) {}

  /// Fills the mesh. Requires: the points of loops and creases.
  void make();

 private:
  void choose_explicit();
  bool may_be_implicit(const Segment& s) const;
  Vec3 explicit_vertex(const Segment& s) const;
  SurfacePoint point_between(const CellFace& face, const Box3& box, const Crossing& a,
                             const Crossing& b) const;
  void add_polygon(std::int32_t crossing);
  bool add_flat_polygon(const Crossing& c, std::span<const std::uint32_t> ring, std::int32_t id);
  void add_triangle(std::int32_t crossing, std::uint32_t a, std::uint32_t b, std::uint32_t c);

  BaseMesh& mesh_;
};

}  // namespace mrsim::detail
