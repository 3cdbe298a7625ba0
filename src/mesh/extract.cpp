#include "mesh/extract.h"

namespace mrsim {

TriMesh extract_mesh(const Stock& stock, const MeshPlan& options, MeshReport* report) {
  return mesh_part(stock.field(), stock.voxel(), options, report);
}

void extract_mesh(const Stock& stock, const MeshPlan& options, MeshSink& sink, MeshReport* report) {
  mesh_part(stock.field(), stock.voxel(), options, sink, report);
}

}  // namespace mrsim
