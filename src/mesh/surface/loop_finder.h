// From crossings of edges to closed loops about cells: segments join the crossings on each face of
// a cell, and those about a cell make its loops.
#pragma once

#include "mesh/cells/octree.h"
#include "mesh/surface/surface_graph.h"

#include <vector>

namespace mrsim::detail {

/// The edges that the surface crosses, and the faces about them. `complete`: by cell, whether all
/// of its edges are there; empty: of all cells.
struct CrossedGrid {
  std::vector<MinimalEdge> edges;
  std::vector<CellFace> faces;
  std::vector<char> complete;
};

/// Splits cells about faces on whose sides the crossings can not be joined in one way: more than
/// two (four, in cells up to a voxel), or two on one side; until there are none.
CrossedGrid split_badly_crossed(CellOctree& tree);
/// The same where only the leaves of `changed` (by cell) have changed since it was done. The grid
/// is the part about these leaves and those made from them: as much as their surface, with that of
/// the leaves that share an edge with them, needs. Costs what that part takes, and some bytes for
/// each node.
CrossedGrid split_badly_crossed(CellOctree& tree, std::vector<char> changed);

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
