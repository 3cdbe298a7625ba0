// Recognition of stocks: a mesh that is a box, a cylinder or a tube becomes that exact solid.
//
// Why: a turned bar comes from CAD as a prism of a few hundred sides. Simulated as it is, its skin
// would show facets and its volume would be short by them; the machinist's bar is round.
//
// When a mesh counts as a box, cylinder or tube: it is closed; every vertex lies within 4 float32
// ulps of the largest coordinate from the solid; every triangle lies in one of its faces and looks
// outwards; the volume agrees; round faces have at least 64 facets a turn, each with a chord error
// below 0.005 mm. A hexagon bar stays a hexagon bar. Boxes are parallel to the axes, round solids
// stand along Z.
#pragma once

#include <mrsim/options.h>
#include <mrsim/types.h>

#include <string>

namespace mrsim {

/// Fewest facets of a full turn, and largest chord error in mm, of a mesh that stands for a round
/// face.
inline constexpr int kFewestFacets = 64;
inline constexpr double kLargestChordError = 0.005;

/// The stock that `mesh` is, with a description for the report. `source` is the file's name.
/// Numbers of a primitive are the shortest decimals that the mesh allows ("25.4", not
/// 25.3999996...). Requires: mesh checked as a solid. Linear but for one sort of the edges.
StockShape recognise_stock(TriMesh mesh, const StockOptions& options = {},
                           const std::string& source = "");

/// "box 100 x 60 x 10 mm", "cylinder d 50 x 51 mm", "tube d 50 / 20 x 51 mm", "mesh of 1204
/// triangles, 100 x 60 x 10 mm".
std::string describe_shape(const StockShape& shape);

}  // namespace mrsim
