#include "mesh/surface/surface_graph.h"

namespace mrsim::detail {

std::int32_t smaller_cell(const SurfaceCells& cells, const CellFace& face) {
  return cells.size_of(face.high) < cells.size_of(face.low) ? face.high : face.low;
}

Box3 SurfaceStep::face_box(const CellFace& face) const {
  const std::int32_t cell = face_cell(face);
  Box3 b = cells_.box(cell);
  const double plane =
      mrsim::component(cell == face.low ? b.hi : b.lo, static_cast<int>(face.axis));
  mrsim::component(b.lo, face.axis) = mrsim::component(b.hi, face.axis) = plane;
  return b;
}

}  // namespace mrsim::detail
