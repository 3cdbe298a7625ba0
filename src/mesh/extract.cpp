#include "mesh/extract.h"

namespace mrsim {

TriMesh extract_mesh(const Stock& stock, const MeshOptions& options, ContourReport* report) {
  return contour(stock.field(), stock.voxel(), options, report);
}

void extract_mesh(const Stock& stock, const MeshOptions& options, MeshSink& sink,
                  ContourReport* report) {
  contour(stock.field(), stock.voxel(), options, sink, report);
}

}  // namespace mrsim
