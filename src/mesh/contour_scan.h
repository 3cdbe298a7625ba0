// Whether a cell above a voxel may stay whole: a look at the part on all points of the voxel
// lattice in it that lie near the surface (docs/mesh.md, Cells).
#pragma once

#include "mesh/contour_lattice.h"
#include "removal/field.h"

#include <array>
#include <span>
#include <vector>

namespace mrsim::detail {

/// Where the surface crosses the edges of a cell, nearly.
struct CellSurface {
  struct Point {
    Vec3 position, normal;
    FieldSample at;
  };
  Point points[12];
  std::size_t count = 0;

  std::span<const Point> all() const { return {points, count}; }
};

/// `corners`: d at the corners, by bits x, y, z.
CellSurface surface_of(const ExactField& field, std::span<const std::uint32_t> candidates,
                       const Box3& cell, const double (&corners)[8]);

/// How the surface turns in a cell of `size` mm: little enough for the tolerance; where faces meet;
/// by a face.
enum class Bend : std::uint8_t { even, crease, face };
Bend bend_of(const ExactField& field, const CellSurface& surface, double size, double tolerance);

/// A cell, and what is known of the part in it from its corners, centre and edges.
struct CellView {
  LatticePoint origin;
  std::int32_t voxels = 1;  ///< to a side
  bool is_inside = false;   ///< the first corner
  const CellSurface& surface;
  std::span<const std::uint32_t> candidates;  ///< what can decide d in it
  std::span<const std::uint32_t> seen;        ///< those of them that do where it was looked at
  bool all_seen = false;                      ///< no candidate is missing in `seen`
  bool stock_seen = true;                     ///< or the stock can not decide d in the cell
};

/// What the lattice points must not show, for the cell to stay.
struct CellLimits {
  double near = 0;    ///< mm from the surface, where they are looked at
  double unseen = 0;  ///< mm that owners which were not seen may add to d
  double bend = 0;    ///< mm that d may differ from a plane; at most `near`, or infinite
};

/// True where a lattice point near the surface shows more than the limits allow. Lattice points on
/// the cell's sides count. Requires: the corners differ in side.
bool shows_more(const ExactField& field, const Lattice& lattice, const CellView& cell,
                const CellLimits& limits);

/// True where a lattice point lies more than `depth` mm on the other side of the surface than all
/// corners, which lie on one.
bool hides_surface(const ExactField& field, const Lattice& lattice, const CellView& cell,
                   double depth);

/// Distances at an edge of the voxel lattice and the points before and behind it, on one line: true
/// where they rise or fall evenly, as those of a surface do that passes beside the edge; a wall or
/// gap across it does not. False where one is not known (infinite).
bool run_evenly(const std::array<double, 4>& distances, double voxel);

/// An edge of the voxel lattice, a voxel long.
struct VoxelEdge {
  LatticePoint start;
  int axis = 0;
};

/// Edges of the voxel lattice in a cell above a voxel, but for those on its high sides, that show
/// what the cell may hide: whose ends lie on the same side of the surface, have different owners,
/// and are near enough to it for it to pass twice between them, but for run_evenly(); and, where
/// all corners of the cell lie on one side (`alike`), those that the surface passes once. The
/// surface's area in voxels tells what it costs: some eight samples for each.
std::vector<VoxelEdge> doubtful_inside(const ExactField& field, const Lattice& lattice,
                                       std::span<const std::uint32_t> candidates,
                                       const LatticePoint& origin, std::int32_t voxels, bool alike);

}  // namespace mrsim::detail
