// The surface over the leaves of the octree: crossings of edges, segments in faces, loops in cells,
// and from them triangles that can not intersect (docs/mesh.md, Surface).
#pragma once

#include "mesh/contour_octree.h"
#include "mesh/contour_vertex.h"
#include "mesh/flat_map.h"

#include <array>
#include <vector>

namespace mrsim::detail {

/// Where the surface crosses an edge of the grid. Ring places 0..3 run counter-clockwise about the
/// edge's axis; `segments[i]` lies in the face between places i and i + 1 (-1: one cell spans
/// both).
struct Crossing {
  MinimalEdge edge;
  Vec3 position;
  FieldSample at;
  std::int32_t segments[4] = {-1, -1, -1, -1};
  std::int32_t loops[4] = {-1, -1, -1, -1};

  std::int32_t cell(int place) const { return ring_cell(edge, place); }
};

/// The curve of the surface in a face, from one crossing to another.
struct Segment {
  std::int32_t face = -1, from = -1, to = -1;
  bool is_crease = false;    ///< its ends lie on faces of the part that meet in a crease
  SurfacePoint point;        ///< where the crease passes; later also smooth points
  SurfacePoint outside;      ///< the crease beyond the face, where it does not pass inside
  bool is_explicit = false;  ///< the point is a vertex of the mesh
  std::int32_t vertex = -1;
};

/// A closed run of segments about a cell: one piece of surface in it, with one vertex.
struct Loop {
  std::int32_t cell = -1;
  SmallList<8> crossings;
  SmallList<8> segments;
  SurfacePoint point;
  SurfacePoint outside;  ///< a crease beyond the cell, where none passes inside
};

struct BaseMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::int32_t> crossings;  ///< of each triangle: the one whose edge it surrounds
};

/// The edges that the surface crosses, and the faces about them.
struct CrossedGrid {
  std::vector<MinimalEdge> edges;
  std::vector<CellFace> faces;
};

inline CrossedGrid crossed_grid(const ContourCells& cells) {
  CrossedGrid grid;
  grid.edges = cells.crossing_edges();
  grid.faces = cells.faces(grid.edges);
  return grid;
}

/// Splits cells about faces on whose sides the crossings can not be joined in one way: more than
/// two (four, in cells up to a voxel), or two on one side; until there are none.
CrossedGrid split_badly_crossed(ContourOctree& tree);

/// Points of former rounds, by a hash of all that they are computed from.
class PlacedPoints {
 public:
  struct Place {
    SurfacePoint point, outside;
    bool is_crease = false;
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

class ContourSurface {
 public:
  struct Options {
    double shallow = 0;     ///< mm: creases that may be cut off by that much are
    bool sharpen = false;   ///< look for creases just outside of their cells, for sharpen()
    bool remember = false;  ///< keep crossings and vertices for the next round
    int threads = 0;
  };
  ContourSurface(const ExactField& field, const ContourCells& cells, const Options& options)
      : field_(field), cells_(cells), options_(options) {}

  /// Finds crossings, segments and loops. Requires: the crossings on every face can be joined.
  void find_loops(CrossedGrid grid);
  /// Cells that hold more than one loop.
  const std::vector<std::int32_t>& crowded() const { return crowded_; }
  /// Places vertices and makes triangles.
  const BaseMesh& make_triangles();

  /// Moves vertices to creases just beyond their cells and faces, as far as no triangles meet.
  /// Requires: make_triangles(). Costs a test of the whole mesh where there is anything to move.
  void sharpen(const ContourOctree& tree);

  const BaseMesh& mesh() const { return mesh_; }
  const std::vector<Crossing>& crossings() const { return crossings_; }
  const std::vector<Loop>& loops() const { return loops_; }
  const std::vector<Segment>& segments() const { return segments_; }

 private:
  struct Found {
    Vec3 position;
    FieldSample at;
  };

  void find_crossings(const std::vector<MinimalEdge>& edges);
  void find_crossing_of(Crossing& c) const;
  void find_segments();
  void pair_four(std::int32_t face);
  void join_loops();
  void add_segment(std::int32_t face, std::int32_t from, std::int32_t to);
  Probe probe(std::int32_t cell) const {
    return {field_, cells_.candidates(cell), options_.shallow};
  }
  Box3 face_box(const CellFace& face) const;
  std::int32_t face_cell(const CellFace& face) const;  ///< the smaller one

  void place_creases();
  void place_crease(Segment& s) const;
  void place_loops();
  void place_loop(Loop& loop) const;
  std::uint64_t key_of(const Segment& s) const;
  std::uint64_t key_of(const Loop& loop) const;
  void add_ends(const Crossing& c, std::vector<Vec3>& out) const;
  void choose_explicit();
  bool may_be_implicit(const Segment& s) const;
  bool vertex_on_crease(const Loop& loop, const Segment& s) const;
  SurfacePoint point_between(const CellFace& face, const Box3& box, const Crossing& a,
                             const Crossing& b) const;
  void add_polygon(std::int32_t crossing);
  bool add_flat_polygon(const Crossing& c, const std::vector<std::uint32_t>& ring, std::int32_t id);
  void add_triangle(std::int32_t crossing, std::uint32_t a, std::uint32_t b, std::uint32_t c);
  const Loop& loop_of(std::int32_t crossing, std::int32_t cell) const;

  const ExactField& field_;
  const ContourCells& cells_;
  Options options_;
  std::vector<Crossing> crossings_;
  std::vector<CellFace> faces_;
  std::vector<Segment> segments_;
  std::vector<Loop> loops_;
  std::vector<std::uint8_t> loops_in_cell_;
  std::vector<std::int32_t> crowded_;
  FlatMap known_;             ///< crossings of former rounds, by edge
  std::vector<Found> found_;  ///< what is known of them
  PlacedPoints placed_loops_, placed_creases_;
  BaseMesh mesh_;
};

}  // namespace mrsim::detail
