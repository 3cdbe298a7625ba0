#include "mesh_reduction.h"

#include "core/error.h"
#include "mesh/reduce/reduce.h"
#include <mrsim/compare.h>

#include <algorithm>
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

bool is_small(const TriMesh& mesh, std::size_t most) {
  return !mesh.triangles.empty() && mesh.triangles.size() <= most;
}

// `found`: triangles of what came instead, 0 for none.
[[noreturn]] void refuse(const TriMesh& mesh, std::size_t found, const Job& job) {
  std::size_t possible = std::max(found, job.max_triangles + job.max_triangles / 2);
  while (possible < mesh.triangles.size() &&
         !is_small(reduce_mesh(mesh, possible, job.mesh), possible))
    possible += possible / 2;
  throw Error("max-triangles",
              fmt::format("--max-triangles {}: no mesh of so few triangles was found that does not "
                          "cross itself; {} are possible",
                          job.max_triangles, std::min(possible, mesh.triangles.size())));
}

}  // namespace

void reduce_part(const Job& job, JobResult& result, PartMesh& part, Outputs& outputs) {
  const TriMesh& before = part.in_memory();
  if (job.max_triangles == 0 || before.triangles.size() <= job.max_triangles) return;
  TriMesh after = reduce_mesh(before, job.max_triangles, job.mesh);
  if (!is_small(after, job.max_triangles)) refuse(before, after.triangles.size(), job);
  result.reduction = measure(before, after, job);
  part.replace(std::move(after));
  outputs.replace_mesh();
}

}  // namespace mrsim
