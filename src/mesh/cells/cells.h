// The cells of the mesher as the surface over them sees them: the leaves of an octree, or one tile
// of the uniform grid.
#pragma once

#include "core/numbers/vec.h"
#include "mesh/points/surface_search.h"
#include "mesh/solid/vertex_lattice.h"
#include "removal/field/field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace mrsim::detail {

/// mm: how near d = 0 the surface -kInsideTolerance is looked for.
inline constexpr double kSurfaceBand = 4 * kInsideTolerance;

/// mm: what rounding may take a point of a plane of the part off it.
inline double surface_band(const Vec3& p) {
  return kSurfaceBand + coordinate_step(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}));
}

/// The box for which lists of candidates are made, for cells of `cell` mm in `box`: points of the
/// surface are searched for a little beyond a cell.
inline Box3 reach_of(const Box3& box, double cell) {
  return inflated(box, kCellReach * cell + kQuantum);
}

/// The smallest cube about the box's middle that holds it.
inline Box3 cube_about(const Box3& box) {
  const Vec3 size = box.hi - box.lo, middle = 0.5 * (box.lo + box.hi);
  const double half = 0.5 * std::max({size.x, size.y, size.z});
  return inflated(Box3{middle, middle}, half);
}

/// Octant k of a box: bits 0, 1 and 2 of k are set in the upper halves along x, y and z.
inline Box3 octant(const Box3& box, int k) {
  const Vec3 m = 0.5 * (box.lo + box.hi);
  return {{k & 1 ? m.x : box.lo.x, k & 2 ? m.y : box.lo.y, k & 4 ? m.z : box.lo.z},
          {k & 1 ? box.hi.x : m.x, k & 2 ? box.hi.y : m.y, k & 4 ? box.hi.z : m.z}};
}

/// One edge of the grid that no smaller cell divides, and the four cells about it (equal where one
/// cell spans two quadrants).
struct MinimalEdge {
  std::int32_t cells[4];  ///< by bits: side on axis + 1, side on axis + 2
  LatticePoint start;
  std::int32_t axis = 0, length = 0;
  std::int32_t low = -1, high = -1;  ///< samples at its ends
  std::int8_t smallest = 3;          ///< which of the cells is: the last of the smallest ones
  bool low_inside = false;           ///< the end at `start` is in the material
  bool owned = true;                 ///< its triangles are made here, not by another tile

  std::int32_t smallest_cell() const { return cells[smallest]; }
};

/// Where an edge runs: its low end, and the coordinate of the high one along its axis.
struct EdgeEnds {
  Vec3 low;
  double high = 0;
};

/// A face of a cell that no smaller cell divides, with the crossings on its sides: the first four
/// of them, since more can not be joined. A crossing's slot: 4 * its edge + the quadrant
/// about the edge (ring_cell) of the cell before the face.
struct CellFace {
  std::int32_t low = -1, high = -1;  ///< cells on both sides of it
  std::int32_t axis = 0;
  bool low_complete = false, high_complete = false;  ///< see is_complete()
  std::int32_t count = 0;                            ///< of all its crossings
  std::int32_t slots[4] = {-1, -1, -1, -1};

  void add(std::int32_t edge, int quadrant) {
    if (count < 4) slots[count] = 4 * edge + quadrant;
    ++count;
  }
  std::int32_t crossing(int i) const { return slots[i] / 4; }
  /// All crossings of its border are known.
  bool has_all_edges() const { return low_complete || high_complete; }
};

class SurfaceCells {
 public:
  explicit SurfaceCells(const Lattice& lattice) : lattice_(lattice) {}
  SurfaceCells(const SurfaceCells&) = delete;
  SurfaceCells& operator=(const SurfaceCells&) = delete;
  virtual ~SurfaceCells() = default;

  const Lattice& lattice() const { return lattice_; }

  /// How many cells there are: their ids are below it.
  virtual std::size_t size() const = 0;
  /// Edge of the cell in fine units.
  virtual std::int32_t size_of(std::int32_t cell) const = 0;
  virtual Box3 box(std::int32_t cell) const = 0;
  /// Where vertices of the cell may lie: off its sides by at least two steps of the coordinates.
  virtual Box3 inner_box(std::int32_t cell) const { return inner(box(cell)); }
  /// Whether the surface may pass a cell; the others are all of air or all of material.
  virtual bool is_mixed(std::int32_t cell) const = 0;
  /// The sweeps that can decide d in a mixed cell; of the others they do not tell the side.
  virtual std::span<const std::uint32_t> candidates(std::int32_t cell) const = 0;
  /// Cells of equal numbers, below lists(), have the same candidates.
  virtual std::int32_t list_of(std::int32_t cell) const { return cell; }
  virtual std::size_t lists() const { return size(); }
  /// False for cells at the border, of which only a part of the surroundings is there.
  virtual bool is_complete(std::int32_t cell) const = 0;
  /// No surface passes the edges of the cell or of its neighbours, as far as these are known here.
  virtual bool is_far(std::int32_t cell) const = 0;
  /// Whether the cell is counted here, and not by another tile.
  virtual bool is_owned_cell(std::int32_t cell) const = 0;

  /// d + kInsideTolerance at both ends of an edge, which may be rounded or not known (infinite,
  /// NaN). Requires: the surface crosses the edge.
  virtual std::pair<double, double> offsets(const MinimalEdge& edge) const = 0;
  virtual EdgeEnds ends(const MinimalEdge& edge) const = 0;

 private:
  Lattice lattice_;
};

/// The cells about an edge: quadrants 0..3, counter-clockwise about the edge's axis.
inline std::int32_t ring_cell(const MinimalEdge& e, int quadrant) {
  return e.cells[(quadrant ^ (quadrant >> 1)) & 3];
}

/// The face between the quadrants `quadrant` and `quadrant + 1` of an edge; low = high where one
/// cell spans both.
inline CellFace face_of(const MinimalEdge& e, int quadrant) {
  const std::int32_t from = ring_cell(e, quadrant), to = ring_cell(e, (quadrant + 1) & 3);
  CellFace face;
  face.axis = (e.axis + 1 + (quadrant & 1)) % 3;
  face.low = quadrant < 2 ? from : to;
  face.high = quadrant < 2 ? to : from;
  return face;
}

inline Vec3 high_end(const EdgeEnds& ends, int axis) {
  Vec3 end = ends.low;
  mrsim::component(end, axis) = ends.high;
  return end;
}

}  // namespace mrsim::detail
