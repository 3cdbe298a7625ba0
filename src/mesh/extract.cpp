#include "mesh/extract.h"

namespace mrsim {

TriMesh extract_mesh(const Stock& stock, const MeshOptions& options, MeshReport* report) {
  return mesh_part(stock.field(), stock.voxel(), options, report);
}

void extract_mesh(const Stock& stock, const MeshOptions& options, MeshSink& sink,
                  MeshReport* report) {
  mesh_part(stock.field(), stock.voxel(), options, sink, report);
}

}  // namespace mrsim
