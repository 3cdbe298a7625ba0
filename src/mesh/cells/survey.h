// How much surface the sweeps have made, estimated from coarse blocks: what a mesh of it will take
// (docs/mesh.md, Default settings).
#pragma once

#include "removal/field/field.h"

#include <cstddef>

namespace mrsim::detail {

/// Cubes that the surface may pass and in which a sweep may decide it.
struct SurfaceSurvey {
  double block = 0;        ///< edge of a cube, mm
  std::size_t blocks = 0;  ///< how many cubes there are
  double sweeps = 0;       ///< sweeps that matter in a cube, on average
  double creasing = 0;     ///< the same, but 1 for each cube without a crease
  double sheets = 1;       ///< how often a line along x, y or z meets the surface in a cube
  /// Layers of surface in a cube of a quarter of the longest side, by the area of the cube's side:
  /// the mean over all of the surface.
  double layers = 0;
  /// The share of all sweeps that matter in such a cube, where it is largest, 0 to 1.
  double shared = 0;

  /// Cells of `voxel` mm that the cut surface passes, about. Flat sides of the stock do not count:
  /// their cells are merged. Rather too many than too few.
  double cells(double voxel) const;
  /// The same with several sheets of surface in one cube, as cells that hold one sheet each. One
  /// that holds two takes more.
  double crossed_cells(double voxel) const;
};

/// Looks at smaller and smaller blocks until they are some ten thousand, or 1/128 of the longest
/// side. `list`: field.all(), or an even choice of them, which gives the area well, not how many
/// matter. One block in `one_in`, a power of two, is sampled for creases and sheets. Same result
/// for any number of threads. Cost: some hundredths of a second, and some microseconds a sweep.
SurfaceSurvey survey_surface(const ExactField& field, const Candidates& list, int threads,
                             int one_in = 16);

}  // namespace mrsim::detail
