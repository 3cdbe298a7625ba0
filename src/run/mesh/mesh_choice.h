// Voxel and tolerance of a run: as they were given, or by default (docs/mesh.md, Default settings).
//
// A default depends on the stock, the cutters and counts of the cut surface: never on a clock or on
// the number of threads, so that equal inputs give equal bytes.
#pragma once

#include "removal/field/field.h"
#include "run/cuts/cut_kinds.h"
#include "run/cuts/cuts.h"
#include <mrsim/mrsim.h>

#include <string>

namespace mrsim {

struct MeshChoice {
  double voxel = 0;  ///< mm
  std::string voxel_reason;
  double tolerance = 0;  ///< mm, 0 = the grid of the voxels
  std::string tolerance_reason;
  CutKinds kinds;                  ///< where the voxel was not given
  bool fits_voxel = false;         ///< it was not given: fit_mesh() may change it
  bool is_default = false;         ///< nor was the tolerance: likewise
  bool measure = false;            ///< MeshPlan::measure
  std::size_t most_nodes = 0;      ///< MeshPlan::most_nodes: 0 where the tolerance is a wish
  double most_tolerance = 0;       ///< MeshPlan::most_tolerance
  bool makes_new_octrees = false;  ///< MeshPlan::makes_new_octrees
  double fallback_voxel = 0;       ///< mm: of the grid where the tolerance is given up
  double fallback_cells = 0;       ///< CarvePlan::cut_cells of that grid
  double cut_cells = 0;            ///< CarvePlan::cut_cells
  double cut_layers = 0;           ///< CarvePlan::cut_layers
  double block_sweeps = 0;         ///< CarvePlan::block_sweeps
  double shared_sweeps = 0;        ///< CarvePlan::shared_sweeps
};

/// What was given; else what the size of stock and cutters suggests.
MeshChoice choose_mesh(const Job& job, const StockShape& stock, const CutList& cuts);

/// Looks how large the cut surface is. Voxel and tolerance that were not given get coarser where it
/// is so large that the run would take long.
void fit_mesh(const ExactField& field, int threads, MeshChoice& choice);

/// The mesh is within `raised` (mm), because what was chosen takes too many cells.
void raise_tolerance(MeshChoice& choice, double raised);

/// The mesh within the tolerance was given up for the grid of choice.fallback_voxel.
void give_up_tolerance(MeshChoice& choice, const std::string& why);

}  // namespace mrsim
