// Where the vertices of loops lie, and where creases pass the faces of cells.
#pragma once

#include "mesh/cells/flat_map.h"
#include "mesh/points/vertex.h"
#include "mesh/surface/surface_graph.h"

#include <optional>
#include <set>
#include <span>
#include <vector>

namespace mrsim::detail {

/// Points of former rounds, by a hash of all that they are computed from.
class PlacedPoints {
 public:
  struct Place {
    SurfacePoint point, outside;
    bool smooth = false;  ///< of creases: there is none
  };
  const Place* find(std::uint64_t key) const {
    const std::int32_t i = ids_.find(key);
    return i < 0 ? nullptr : &places_[static_cast<std::size_t>(i)];
  }
  void add(std::uint64_t key, const Place& place) {
    if (ids_.insert(key, static_cast<std::int32_t>(places_.size())).second)
      places_.push_back(place);
  }

 private:
  FlatMap ids_;
  std::vector<Place> places_;
};

class VertexPlacer : public SurfaceStep {
 public:
  explicit VertexPlacer(SurfaceGraph& graph) : SurfaceStep(graph) {}

  /// Fills creases and the points of loops.
  void place();
  /// Puts the vertices of these cells between their crossings from the next place() on: pieces of
  /// surface in one cell hardly meet then, but creases in it are cut off. False where all of them
  /// lie so.
  bool flatten(std::span<const std::int32_t> cells);

 private:
  void find_creases();
  PlacedPoints::Place place_crease(const Segment& s) const;
  void place_loops();
  void place_loops_of(std::span<const std::int32_t> loops);
  bool is_smooth(const Loop& loop) const;
  std::optional<BorderSearch> owner_border(const Loop& loop) const;
  Vec3 mean_crossing(const Loop& loop) const;
  void finish_loop(std::int32_t loop);
  void flatten_loops();
  std::uint64_t key_of(const Segment& s) const;
  std::uint64_t key_of(const Loop& loop) const;

  std::set<std::int32_t> flat_cells_;
  PlacedPoints placed_loops_, placed_creases_;
};

}  // namespace mrsim::detail
