// How much memory a run will take, an estimate, and whether it is done as a whole or in slabs.
// What a mesh with a tolerance takes besides is estimated from its first cells
// (mesh/cells/mesh_memory.h).
#pragma once

#include "removal/part/carve_plan.h"
#include "removal/part/part_field.h"

#include <cstddef>
#include <span>

namespace mrsim {

struct MemoryPlan {
  std::size_t limit = 0;  ///< bytes
  double expected = 0;    ///< bytes at the peak, as planned; without a mesh that has a tolerance
  double whole = 0;       ///< bytes at the peak of a run that is not cut into slabs
  double mesh_room = 0;   ///< bytes, of the limit, that a mesh on the voxels may take as a whole
  double list_room = 0;   ///< bytes that the lists of an octree may take beyond the expected
  /// Bytes, of the limit, in which tiles of such a mesh may be kept while others are mended.
  double tile_room = 0;
  bool in_slabs = false;
};

/// Throws Error "memory" where the limit in force (memory_limit.h) does not leave what a
/// SweepTable of these would take, estimated from some of the motions.
void require_table(std::span<const Motion> motions, std::span<const Tool> tools,
                   const SweepSelection& selection);

/// The same for the lists that threads have of the sweeps while the part is surveyed.
void require_survey(const SweepTable& sweeps, int threads);

/// The plan of a run whose program has that many motions. Throws Error "voxel-invalid";
/// "voxel-too-small" where the stock's surface has too many voxels; "memory" where the run does not
/// fit, with what would.
MemoryPlan plan_memory(const PartField& field, std::size_t motions, const CarvePlan& options);

}  // namespace mrsim
