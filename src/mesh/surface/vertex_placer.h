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
class KnownPoints {
 public:
  struct Result {
    SurfacePoint point, outside;
    bool smooth = false;  ///< of a crease: the faces join smoothly there
  };
  const Result* find(std::uint64_t key) const {
    const std::int32_t i = ids_.find(key);
    return i < 0 ? nullptr : &results_[static_cast<std::size_t>(i)];
  }
  void add(std::uint64_t key, const Result& result) {
    if (ids_.insert(key, static_cast<std::int32_t>(results_.size())).second)
      results_.push_back(result);
  }

 private:
  FlatMap ids_;
  std::vector<Result> results_;
};

class VertexPlacer : public SurfaceStep {
 public:
  explicit VertexPlacer(SurfaceGraph& graph) : SurfaceStep(graph) {}

  /// Fills creases and the points of loops.
  void place();
  /// Puts the vertices of these cells between their crossings from the next place() on: pieces of
  /// surface in one cell hardly meet then, but creases in it are cut off. False: all of them
  /// lie there already.
  bool flatten(std::span<const std::int32_t> cells);
  /// DualSurface::flatten_only().
  void flatten_only(std::span<const std::int32_t> cells) {
    flat_cells_ = {cells.begin(), cells.end()};
  }

 private:
  void find_creases();
  KnownPoints::Result place_crease(const Segment& s) const;
  void place_loops();
  void place_loops_of(std::span<const std::int32_t> loops);
  bool is_smooth(const Loop& loop) const;
  void count_segments();
  // Whether another piece of surface passes the same face, or the same cell.
  bool is_crowded(const Segment& s) const;
  bool is_crowded(const Loop& loop) const;
  std::optional<BorderSearch> owner_border(const Loop& loop) const;
  Vec3 mean_crossing(const Loop& loop) const;
  void finish_loop(std::int32_t loop);
  void flatten_loops();
  std::uint64_t key_of(const Segment& s) const;
  std::uint64_t key_of(const Loop& loop) const;

  std::vector<std::uint8_t> segments_in_face_;  ///< by face: one or two
  std::set<std::int32_t> flat_cells_;
  KnownPoints known_loops_, known_creases_;
};

}  // namespace mrsim::detail
