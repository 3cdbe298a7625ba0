// The tool path as a picture: SVG (rapids dashed, arcs as arcs; a lathe in ZX) or PLY (coloured
// edges, arcs sampled). The function itself is declared in <mrsim/mrsim.h>.
#pragma once

#include <mrsim/mrsim.h>

#include <string>

namespace mrsim {

/// The picture as SVG, and as PLY.
std::string path_svg(const Program& program);
std::string path_ply(const Program& program);

}  // namespace mrsim
