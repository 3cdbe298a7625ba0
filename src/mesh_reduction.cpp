#include "mesh_reduction.h"

#include "core/error.h"
#include "mesh/reduce/reduce.h"
#include <mrsim/compare.h>

#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::size_t kSamples = 50000;  // of each mesh, where the search for the distance starts

MeshReduction measure(const TriMesh& before, const TriMesh& after, const Job& job) {
  CompareOptions options;
  options.samples = kSamples;
  options.hints = false;
  options.threads = job.mesh.threads;
  options.progress = job.mesh.progress;
  const HausdorffBound found = compare(after, before, options).hausdorff;
  return {before.triangles.size(), found.lower, found.upper, found.place};
}

}  // namespace

bool reduce_part(const Job& job, JobResult& result, PartMesh& part, Outputs& outputs) {
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
  result.reduction = measure(before, after, job);
  part.replace(std::move(after));
  outputs.replace_mesh();
  return true;
}

}  // namespace mrsim
