// Decides whether a cell larger than a voxel may stay whole, by looking at the part on all points
// of the voxel lattice in it that lie near the surface (docs/mesh.md, Cells).
#pragma once

#include "mesh/solid/vertex_lattice.h"
#include "removal/field/field.h"

#include <span>

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

/// How the surface bends in a cell of `size` mm: by less than the tolerance; because two faces meet
/// in it; because one face is bent. `candidates`: what can decide d in the cell.
enum class Bend : std::uint8_t { even, crease, face };
Bend bend_of(const ExactField& field, std::span<const std::uint32_t> candidates,
             const CellSurface& surface, double size, double tolerance);

/// A cell, and what is known of the part in it from its corners, centre and edges.
struct CellView {
  LatticePoint origin;
  std::int32_t voxels = 1;  ///< to a side
  bool is_inside = false;   ///< the first corner
  const CellSurface& surface;
  std::span<const std::uint32_t> candidates;  ///< sweeps that can decide d in the cell
  std::span<const std::uint32_t> seen;        ///< candidates that decide d at a sampled point
  bool all_seen = false;                      ///< `seen` has all candidates
  bool stock_seen = true;                     ///< or the stock cannot decide d in the cell
};

/// What the points of the lattice may show at most if the cell is to stay whole.
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

}  // namespace mrsim::detail
