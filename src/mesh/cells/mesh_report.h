// What a mesher reports of its work beside the mesh.
#pragma once

#include <mrsim/types.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace mrsim {

/// A wall or gap that passes between two neighbouring samples.
struct ThinFeature {
  Vec3 place;             ///< mm, on or in the feature
  bool wall = false;      ///< material between air; else a gap
  double thickness = 0;   ///< mm of the edge of the grid that lie in it
  std::int32_t owner[2];  ///< what bounds it: motion or kStockOwner
};

struct MeshReport {
  double tolerance = 0;     ///< mm: MeshPlan::tolerance, or what it was raised to
  double bound = 0;         ///< mm: largest certified distance of the mesh from the part; 0 without
                            ///< tolerance, unless it was measured
  double usual = 0;         ///< mm: what 99 % of the triangles of a measured mesh do not exceed
  std::size_t sampled = 0;  ///< triangles whose distance from their face is not proven, but sampled
  double volume_excess = 0;  ///< mm^3 that the mesh holds more than the exact part, by quadrature
                             ///< (docs/mesh.md, Volume); 0 without tolerance
  double memory = 0;       ///< bytes at the mesher's peak, estimated by its cells and triangles; 0
                           ///< without tolerance
  std::string given_up;    ///< why there is no mesh within the tolerance; empty: there is one
  std::size_t cells = 0;   ///< cells that the surface passes
  std::size_t passes = 0;  ///< rounds of splitting
  std::size_t triangles_before = 0;  ///< triangles before simplification
  std::size_t kept = 0;           ///< vertices that simplification left, as the surface would have
                                  ///< met itself without them
  std::size_t unresolved = 0;     ///< places that stayed above the tolerance at the smallest cell
  std::vector<ThinFeature> thin;  ///< in the order of the grid's edges
  std::vector<std::pair<std::string, double>> seconds;  ///< by step
};

}  // namespace mrsim
