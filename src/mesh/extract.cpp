#include "mesh/extract.h"

namespace mrsim {

TriMesh extract_mesh(const Stock& stock, const MeshOptions& options, ContourReport* report) {
  return contour(stock.field(), stock.voxel(), options, report);
}

}  // namespace mrsim
