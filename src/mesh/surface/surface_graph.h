// The surface over cells before it is triangles: crossings of edges, segments in faces from
// crossing to crossing, loops of segments about cells, and the steps that fill it. Faces of a cell
// are its six sides; faces of the part, smooth pieces of its surface, are named as such.
#pragma once

#include "mesh/cells/cells.h"
#include "mesh/points/surface_search.h"

#include <cstdint>
#include <span>
#include <vector>

namespace mrsim::detail {

/// How finely the surface about an edge of the grid is drawn: by the vertices of its cells alone
/// where that can not meet other triangles; about the crossing; with the vertices of its faces as
/// well, as finely as cells of half the size would.
enum class Detail : std::uint8_t { flat, fan, full };

/// Where the surface crosses an edge of the grid. Quadrants 0..3 are counter-clockwise about the
/// edge's axis; `segments[i]` lies in the face between quadrants i and i + 1 (-1: one cell spans
/// both).
struct Crossing {
  MinimalEdge edge;
  double low = 0, high = 0;  ///< coordinates of the edge's ends, along its axis
  Vec3 position, normal;
  FieldSample at;
  std::int32_t segments[4] = {-1, -1, -1, -1};
  std::int32_t loops[4] = {-1, -1, -1, -1};
  Detail detail = Detail::flat;

  std::int32_t cell(int quadrant) const { return ring_cell(edge, quadrant); }
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
  std::int8_t from_quadrant = 0,
              to_quadrant = 0;       ///< of the face, about the edges of these crossings
  std::int32_t low = -1, high = -1;  ///< loops of the cells on both sides of the face
  bool is_crease = false;            ///< its ends lie on faces of the part that meet in a crease
  std::int32_t crease = -1;          ///< index of the crease, where it is one
  std::int32_t vertex = -1;          ///< of the segment itself, -1 where it needs none
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

/// Element i of a list that is counted by signed numbers.
template <class T>
const T& at(const std::vector<T>& v, std::int32_t i) {
  return v[static_cast<std::size_t>(i)];
}

struct SurfaceOptions {
  double shallow = 0;     ///< mm: creases that may be cut off by that much are
  bool sharpen = false;   ///< look for creases just outside of their cells, for sharpen()
  bool remember = false;  ///< keep crossings and vertices for the next round
  int threads = 0;
};

struct SurfaceGraph {
  SurfaceGraph(const ExactField& field_in, const SurfaceCells& cells_in,
               const SurfaceOptions& options_in)
      : field(field_in), cells(cells_in), options(options_in) {}

  const ExactField& field;
  const SurfaceCells& cells;
  SurfaceOptions options;
  std::vector<char> complete;  ///< see CrossedGrid::complete
  std::vector<Crossing> crossings;
  std::vector<CellFace> faces;
  std::vector<Segment> segments;
  std::vector<Crease> creases;
  std::vector<Loop> loops;
  std::vector<std::int32_t> loop_crossings, loop_segments;
  std::vector<SurfacePoint> outside;  ///< by loop, to sharpen: a crease beyond the cell
  std::vector<std::uint8_t> loops_in_cell;
  std::vector<std::int32_t> crowded;  ///< cells that hold more than one loop
};

/// The smaller one of the cells on both sides of a face.
std::int32_t smaller_cell(const SurfaceCells& cells, const CellFace& face);

/// What the steps from cells to triangles share. Each is a class of its own that derives from this
/// one.
class SurfaceStep {
 protected:
  explicit SurfaceStep(SurfaceGraph& graph)
      : field_(graph.field),
        cells_(graph.cells),
        options_(graph.options),
        complete_(graph.complete),
        crossings_(graph.crossings),
        faces_(graph.faces),
        segments_(graph.segments),
        creases_(graph.creases),
        loops_(graph.loops),
        loop_crossings_(graph.loop_crossings),
        loop_segments_(graph.loop_segments),
        outside_(graph.outside),
        loops_in_cell_(graph.loops_in_cell),
        crowded_(graph.crowded) {}

  Probe probe(std::int32_t cell) const {
    return {field_, cells_.candidates(cell), options_.shallow};
  }
  bool is_complete(std::int32_t cell) const {
    return cells_.is_complete(cell) && (complete_.empty() || at(complete_, cell) != 0);
  }
  std::int32_t face_cell(const CellFace& face) const { return smaller_cell(cells_, face); }
  Box3 face_box(const CellFace& face) const;
  std::span<const std::int32_t> crossings_of(const Loop& loop) const {
    return {loop_crossings_.data() + loop.first_crossing, loop.crossings};
  }
  std::span<const std::int32_t> segments_of(const Loop& loop) const {
    return {loop_segments_.data() + loop.first_segment, loop.segments};
  }

  const ExactField& field_;
  const SurfaceCells& cells_;
  const SurfaceOptions& options_;
  const std::vector<char>& complete_;
  std::vector<Crossing>& crossings_;
  std::vector<CellFace>& faces_;
  std::vector<Segment>& segments_;
  std::vector<Crease>& creases_;
  std::vector<Loop>& loops_;
  std::vector<std::int32_t>&loop_crossings_, &loop_segments_;
  std::vector<SurfacePoint>& outside_;
  std::vector<std::uint8_t>& loops_in_cell_;
  std::vector<std::int32_t>& crowded_;
};

}  // namespace mrsim::detail
