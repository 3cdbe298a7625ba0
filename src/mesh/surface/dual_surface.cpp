#include "mesh/surface/dual_surface.h"

#include "mesh/surface/ridge_sharpener.h"
#include "mesh/surface/tile_loops.h"

#include <utility>

namespace mrsim::detail {

void DualSurface::find_loops(CrossedGrid grid) {
  graph_.complete = std::move(grid.complete);
  crossings_.find(grid.edges);
  LoopFinder(graph_).find(std::move(grid.faces));
}

void DualSurface::find_loops(const CellTile& tile) {
  std::vector<MinimalEdge> edges;
  tile.append_crossed(edges);
  crossings_.find(edges);
  TileLoops(graph_).find(tile);
}

const BaseMesh& DualSurface::make_triangles() {
  vertices_.place();
  LoopTriangles(graph_, mesh_).make();
  return mesh_;
}

void DualSurface::sharpen(const CellOctree& tree) { RidgeSharpener(graph_, mesh_).sharpen(tree); }

}  // namespace mrsim::detail
