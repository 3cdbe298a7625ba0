#include "mesh/extract.h"

#include "mesh/grid_mesh.h"
#include "removal/stock_grid.h"

namespace mrsim {

TriMesh extract_mesh(const Stock& stock, const MeshOptions& options) {
  TriMesh mesh = mesh_grid(*stock.grid().distance, stock.grid().owner.get(), options.threads);
  if (mesh.triangles.empty()) throw Error("part-empty", "nothing is left of the stock");
  return mesh;
}

}  // namespace mrsim
