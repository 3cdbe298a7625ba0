// Where the surface crosses the edges of the grid, found together for edges with the same
// candidates, and remembered from round to round.
#pragma once

#include "mesh/cells/flat_map.h"
#include "mesh/surface/surface_graph.h"

#include <span>
#include <vector>

namespace mrsim::detail {

/// Tells an edge from all others of its lattice. Requires: no more than 2^20 fine units.
std::uint64_t edge_key(const MinimalEdge& e);

class CrossingFinder : public SurfaceStep {
 public:
  explicit CrossingFinder(SurfaceGraph& graph) : SurfaceStep(graph) {}

  /// Fills crossings, in the order of the edges.
  void find(const std::vector<MinimalEdge>& edges);
  /// Draws the surface about an edge at least that finely from the next find() on. Requires:
  /// SurfaceOptions::remember.
  void refine(const Crossing& crossing, Detail detail);

 private:
  struct Found {
    Vec3 position, normal;
    FieldSample at;
    Detail detail = Detail::flat;
  };

  void find_together(std::span<const std::int32_t> crossings);
  void find_ends(const Probe& probe, std::span<const std::int32_t> crossings,
                 std::vector<SegmentEnd>& out) const;

  FlatMap known_;             ///< crossings of former rounds, by edge
  std::vector<Found> found_;  ///< what is known of them
};

}  // namespace mrsim::detail
