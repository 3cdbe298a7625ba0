// Ridges whose tips pass between the edges of the grid: the crease lies outside of the cells that
// see both flanks, and the corner in which it ends outside of those that see three faces. Their
// vertices are moved there, where that makes no triangles meet; it is the one step that leaves the
// envelopes, so it is tested exactly.
#pragma once

#include "mesh/cells/octree.h"
#include "mesh/surface/loop_triangles.h"
#include "mesh/surface/ridge_strip.h"
#include "mesh/surface/surface_graph.h"

#include <span>
#include <vector>

namespace mrsim::detail {

class RidgeSharpener : public SurfaceStep {
 public:
  RidgeSharpener(SurfaceGraph& graph, BaseMesh& mesh) : SurfaceStep(graph), mesh_(mesh) {}

  /// Does what DualSurface::sharpen() promises.
  void sharpen(const CellOctree& tree);

 private:
  std::vector<SurfacePoint> find_tips() const;
  std::size_t segment_vertices() const;
  std::vector<RidgeVertex> find_ridge(const CellOctree& tree) const;
  SurfacePoint point_on(const Segment& s) const;
  void label_moved(std::span<const std::uint32_t> triangles, const RidgeStrip& strip);

  BaseMesh& mesh_;
};

}  // namespace mrsim::detail
