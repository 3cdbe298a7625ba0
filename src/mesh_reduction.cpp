#include "mesh_reduction.h"

#include "compare/hausdorff.h"
#include "core/error.h"
#include "mesh/reduce/reduce.h"

#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr DistanceError kError{1e-4, 0.01};

}  // namespace

bool reduce_part(const Job& job, JobResult& result, MeshStore& part, Outputs& outputs) {
  if (job.max_triangles == 0) return false;
  const TriMesh& before = part.in_memory();
  if (before.triangles.size() <= job.max_triangles) return false;
  result.expected_memory += static_cast<std::size_t>(reduction_memory(before.triangles.size()));
  TriMesh after = reduce_mesh(before, job.max_triangles, job.mesh);
  if (after.triangles.size() > job.max_triangles)
    throw Error("max-triangles",
                fmt::format("--max-triangles {}: no mesh of so few triangles was found that does "
                            "not cross itself; {} are possible",
                            job.max_triangles, after.triangles.size()));
  const HausdorffBound apart = surface_distance(after, before, kError, job.mesh.threads);
  result.reduction = {before.triangles.size(), apart.lower, apart.upper, apart.place};
  part.replace(std::move(after));
  outputs.replace_mesh();
  return true;
}

}  // namespace mrsim
