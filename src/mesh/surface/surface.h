// The surface over the leaves of the octree: crossings of edges, segments in faces, loops in cells,
// and from them triangles that can not intersect (docs/mesh.md, Surface).
#pragma once

#include "mesh/cells/cell_lists.h"
#include "mesh/cells/flat_map.h"
#include "mesh/cells/octree.h"
#include "mesh/cells/tile.h"
#include "mesh/points/vertex.h"
#include "mesh/surface/ridge_strip.h"

#include <array>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace mrsim::detail {

/// How finely the surface about an edge of the grid is drawn: by the vertices of its cells alone
/// where that can not meet other triangles; about the crossing; with the vertices of its faces as
/// well, as finely as cells of half the size would.
enum class Detail : std::uint8_t { flat, fan, full };

/// Where the surface crosses an edge of the grid. Ring places 0..3 run counter-clockwise about the
/// edge's axis; `segments[i]` lies in the face between places i and i + 1 (-1: one cell spans
/// both).
struct Crossing {
  MinimalEdge edge;
  double low = 0, high = 0;  ///< coordinates of the edge's ends, along its axis
  Vec3 position, normal;
  FieldSample at;
  std::int32_t segments[4] = {-1, -1, -1, -1};
  std::int32_t loops[4] = {-1, -1, -1, -1};
  Detail detail = Detail::flat;

  std::int32_t cell(int place) const { return ring_cell(edge, place); }
  Vec3 low_end() const { return end(low); }
  Vec3 high_end() const { return end(high); }

 private:
  Vec3 end(double along) const {
    Vec3 p = position;
    mrsim::component(p, edge.axis) = along;
    return p;
  }
};

/// The curve of the surface in a face, from one crossing to another.
struct Segment {
  std::int32_t face = -1, from = -1, to = -1;
  std::int8_t from_place = 0, to_place = 0;  ///< of the face, in the rings of these crossings
  std::int32_t low = -1, high = -1;          ///< loops of the cells on both sides of the face
  bool is_crease = false;    ///< its ends lie on faces of the part that meet in a crease
  std::int32_t crease = -1;  ///< where it is one
  std::int32_t vertex = -1;  ///< its own one, -1 where the mesh needs none
};

/// Where a crease passes a face of a cell.
struct Crease {
  std::int32_t segment = -1;
  SurfacePoint point;
  SurfacePoint outside;  ///< the crease beyond the face, where it does not pass inside
};

/// A closed run of segments about a cell: one piece of surface in it, with one vertex.
struct Loop {
  std::int32_t cell = -1;
  std::uint32_t first_crossing = 0, crossings = 0;  ///< in the lists of the surface
  std::uint32_t first_segment = 0, segments = 0;
  SurfacePoint point;
};

struct BaseMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::int32_t> crossings;  ///< of each triangle: the one whose edge it surrounds
  /// Triangles that lie on another face of the part than their crossing, ascending.
  std::vector<std::pair<std::uint32_t, FieldSample>> moved;
};

/// The edges that the surface crosses, and the faces about them.
struct CrossedGrid {
  std::vector<MinimalEdge> edges;
  std::vector<CellFace> faces;
};

/// Splits cells about faces on whose sides the crossings can not be joined in one way: more than
/// two (four, in cells up to a voxel), or two on one side; until there are none.
CrossedGrid split_badly_crossed(CellOctree& tree);

/// Tells an edge from all others of its lattice. Requires: no more than 2^20 fine units.
std::uint64_t edge_key(const MinimalEdge& e);

/// Of a list that is counted by signed numbers.
template <class T>
const T& at(const std::vector<T>& v, std::int32_t i) {
  return v[static_cast<std::size_t>(i)];
}

/// Points of former rounds, by a hash of all that they are computed from.
class PlacedPoints {
 public:
  struct Place {
    SurfacePoint point, outside;
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

class DualSurface {
 public:
  struct Options {
    double shallow = 0;     ///< mm: creases that may be cut off by that much are
    bool sharpen = false;   ///< look for creases just outside of their cells, for sharpen()
    bool narrow = false;    ///< cells share lists of candidates: long ones are narrowed to a cell
    bool remember = false;  ///< keep crossings and vertices for the next round
    int threads = 0;
  };
  DualSurface(const ExactField& field, const SurfaceCells& cells, const Options& options)
      : field_(field), cells_(cells), lists_(field, cells), options_(options) {}

  /// Finds crossings, segments and loops. Requires: the crossings on every face can be joined.
  void find_loops(CrossedGrid grid);
  /// The same of a tile, where segments between crossings of one face of the part, which need no
  /// vertex, are left out.
  void find_loops(const CellTile& tile);
  /// Cells that hold more than one loop.
  const std::vector<std::int32_t>& crowded() const { return crowded_; }
  /// Places vertices and makes triangles.
  const BaseMesh& make_triangles();

  /// Draws the surface about an edge at least that finely from the next find_loops() on. Requires:
  /// Options::remember.
  void refine(const Crossing& crossing, Detail detail);

  /// Puts the vertices of these cells between their crossings from the next make_triangles() on:
  /// pieces of surface in one cell hardly meet then, but creases in it are cut off. False where all
  /// of them lie so.
  bool flatten(std::span<const std::int32_t> cells);

  /// Moves vertices to creases just beyond their cells and faces, as far as no triangles meet, and
  /// takes away triangles that have no area there; vertices may be left that none uses.
  /// Requires: make_triangles(). Costs a test of the whole mesh where there is anything to move.
  void sharpen(const CellOctree& tree);

  const BaseMesh& mesh() const { return mesh_; }
  const std::vector<Crossing>& crossings() const { return crossings_; }
  const std::vector<Loop>& loops() const { return loops_; }

 private:
  struct Found {
    Vec3 position, normal;
    FieldSample at;
    Detail detail = Detail::flat;
  };

  void find_crossings(const std::vector<MinimalEdge>& edges);
  void find_crossings_of(std::span<const std::int32_t> crossings);
  void find_ends(const Probe& probe, std::span<const std::int32_t> crossings,
                 std::vector<SegmentEnd>& out) const;
  void find_segments();
  void pair_four(std::int32_t face);
  void begin_loops();
  Loop& new_loop(std::int32_t cell);
  void join_loops();
  void list_crossings();
  void list_segments();
  void add_square(const CellTile& tile, const TileSquare& square);
  std::vector<std::uint64_t> add_plain_loops(const CellTile& tile);
  void add_loop(const CellTile& tile, std::int32_t x, std::int32_t y, std::int32_t z,
                std::uint32_t edges);
  template <int kAxis>
  void add_segments(const CellTile& tile, const std::vector<std::uint64_t>& crowded);
  void add_segment_if(CellFace& face, bool is_needed);
  void add_crowded_loops(const CellTile& tile, std::int32_t x, std::int32_t y, std::int32_t z);
  void add_segment(std::int32_t face, int from, int to);
  Probe probe(std::int32_t cell) const {
    return {field_, cells_.candidates(cell), options_.shallow};
  }
  /// For several samples in one cell.
  Probe probe_within(std::int32_t cell) const {
    return {field_, options_.narrow ? lists_.of(cell) : cells_.candidates(cell), options_.shallow};
  }
  Box3 face_box(const CellFace& face) const;
  std::int32_t face_cell(const CellFace& face) const;  ///< the smaller one

  void find_creases();
  bool is_crease(const CellFace& face, const Crossing& a, const Crossing& b) const;
  void place_crease(Crease& crease) const;
  void place_loops();
  void place_loops_of(std::span<const std::int32_t> loops);
  bool is_smooth(const Loop& loop) const;
  std::optional<BorderSearch> owner_border(const Loop& loop) const;
  Vec3 mean_crossing(const Loop& loop) const;
  void finish_loop(std::int32_t loop);
  void flatten_loops();
  std::span<const std::int32_t> crossings_of(const Loop& loop) const {
    return {loop_crossings_.data() + loop.first_crossing, loop.crossings};
  }
  std::span<const std::int32_t> segments_of(const Loop& loop) const {
    return {loop_segments_.data() + loop.first_segment, loop.segments};
  }
  std::vector<SurfacePoint> find_tips() const;
  std::vector<RidgeVertex> find_ridge(const CellOctree& tree) const;
  SurfacePoint place_of(const Segment& s) const;
  std::size_t segment_vertices() const;
  void label_moved(std::span<const std::uint32_t> triangles, const RidgeStrip& strip);
  std::uint64_t key_of(const Segment& s) const;
  std::uint64_t key_of(const Loop& loop) const;
  void add_ends(const Crossing& c, std::vector<Vec3>& out) const;
  void choose_explicit();
  bool may_be_implicit(const Segment& s) const;
  Vec3 explicit_vertex(const Segment& s) const;
  SurfacePoint point_between(const CellFace& face, const Box3& box, const Crossing& a,
                             const Crossing& b) const;
  void add_polygon(std::int32_t crossing);
  bool add_flat_polygon(const Crossing& c, std::span<const std::uint32_t> ring, std::int32_t id);
  void add_triangle(std::int32_t crossing, std::uint32_t a, std::uint32_t b, std::uint32_t c);

  const ExactField& field_;
  const SurfaceCells& cells_;
  CellLists lists_;
  Options options_;
  std::vector<Crossing> crossings_;
  std::vector<CellFace> faces_;
  std::vector<Segment> segments_;
  std::vector<Crease> creases_;
  std::vector<Loop> loops_;
  std::vector<std::int32_t> loop_crossings_, loop_segments_;
  std::vector<SurfacePoint> outside_;  ///< by loop, to sharpen: a crease beyond the cell
  std::vector<std::uint8_t> loops_in_cell_;
  std::vector<std::int32_t> crowded_;
  std::set<std::int32_t> flat_cells_;
  FlatMap known_;             ///< crossings of former rounds, by edge
  std::vector<Found> found_;  ///< what is known of them
  PlacedPoints placed_loops_, placed_creases_;
  BaseMesh mesh_;
};

}  // namespace mrsim::detail
