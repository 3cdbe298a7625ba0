// From crossings of edges to closed loops about cells: segments join the crossings on each face of
// a cell, and those about a cell make its loops.
#pragma once

#include "mesh/cells/octree.h"
#include "mesh/surface/surface_graph.h"

#include <vector>

namespace mrsim::detail {

/// The edges that the surface crosses, and the faces about them.
struct CrossedGrid {
  std::vector<MinimalEdge> edges;
  std::vector<CellFace> faces;
};

/// Splits cells about faces on whose sides the crossings can not be joined in one way: more than
/// two (four, in cells up to a voxel), or two on one side; until there are none.
CrossedGrid split_badly_crossed(CellOctree& tree);

class LoopFinder : public SurfaceStep {
 public:
  explicit LoopFinder(SurfaceGraph& graph) : SurfaceStep(graph) {}

  /// Fills faces, segments and loops. Requires: crossings; on every face they can be joined.
  void find(std::vector<CellFace> faces);

 protected:
  void begin_loops();
  Loop& new_loop(std::int32_t cell);
  bool is_crease(const CellFace& face, const Crossing& a, const Crossing& b) const;
  void add_segment(std::int32_t face, int from, int to);
  void pair_four(std::int32_t face);
  void list_segments();

 private:
  void find_segments();
  void join_loops();
  void list_crossings();
};

}  // namespace mrsim::detail
