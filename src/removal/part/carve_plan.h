// What carve() is to do: the options of the user, and what a run has decided about its mesh.
#pragma once

#include <mrsim/options.h>

#include <cstddef>
#include <string>

namespace mrsim {

struct CarvePlan {
  double voxel = 0;            ///< CarveOptions::voxel
  int threads = 0;             ///< CarveOptions::threads
  std::size_t max_memory = 0;  ///< CarveOptions::max_memory
  /// The mesh will be made on the voxels, without a tolerance: it counts in the estimate.
  bool grid_mesh = false;
  /// About how many voxels the cut surface passes, for the estimate of such a mesh; 0 = not known.
  double cut_cells = 0;
  /// How many layers these voxels make in a part of the stock, as most of them see it; 0 = spread
  /// evenly.
  double cut_layers = 0;
  /// How many sweeps matter in a small block, on average, for the lists of these voxels.
  double block_sweeps = 0;
  /// The share of all sweeps that matter in one part of the stock, where it is largest: more than a
  /// quarter where most passes meet everywhere.
  double shared_sweeps = 0;
  /// Sample the part into a narrow band and keep it, unless the run is done in slabs. Only a .vdb
  /// needs that: meshes come from the exact part.
  bool keep_grid = true;
  /// Why a run that does not fit cannot be done in slabs, a sentence for its refusal; empty: it
  /// can.
  std::string no_slabs = "the stock is wanted as a whole";
  bool slabs = false;  ///< in slabs, whatever the estimate says
  Progress progress;
};

inline CarvePlan carve_plan(const CarveOptions& options) {
  return {.voxel = options.voxel,
          .threads = options.threads,
          .max_memory = options.max_memory,
          .progress = options.progress};
}

}  // namespace mrsim
