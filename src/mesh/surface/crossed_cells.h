// Cells in which several pieces of surface meet each other (docs/mesh.md, Surface).
#pragma once

#include "mesh/surface/dual_surface.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrsim::detail {

/// The cells, of `cells`, with more than one loop whose triangles meet others; a cell may stand
/// there several times. Only these can hold triangles that meet. Requires: make_triangles().
std::vector<std::int32_t> crossed_cells(const DualSurface& surface, std::size_t cells, int threads);

}  // namespace mrsim::detail
