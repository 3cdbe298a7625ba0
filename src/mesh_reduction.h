// Job::max_triangles: the part's mesh made smaller, and how far that moved it.
#pragma once

#include "mesh_store.h"
#include "outputs.h"
#include <mrsim/mrsim.h>

namespace mrsim {

/// Reduces the mesh where it has more triangles than the job allows, and measures the distance
/// between both meshes into result.reduction. Returns whether it did. Throws Error "max-triangles",
/// which names a number that is possible, where no sound mesh is that small.
bool reduce_part(const Job& job, JobResult& result, MeshStore& part, Outputs& outputs);

}  // namespace mrsim
