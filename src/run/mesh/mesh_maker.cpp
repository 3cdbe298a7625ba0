#include "run/mesh/mesh_maker.h"

#include "compare/distance/hausdorff.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "core/process/error.h"
#include "core/process/memory_limit.h"
#include "core/process/parallel.h"
#include "mesh/extract.h"
#include "mesh/mesh_part.h"
#include "mesh/reduce/reduce.h"
#include "mesh/solid/check.h"
#include "run/files/outputs.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();
// A mesh within a tolerance takes at most kMeshErr times its expected memory, and kThreadRoom bytes
// more for each thread.
constexpr double kMeshErr = 1.25, kThreadRoom = 8e6;

// Of a measured grid the volume is known better than by its own.
bool is_measured(const Job& job, const MeshChoice& choice) {
  return choice.measure || (job.accept > 0 && choice.tolerance == 0);
}

MeshPlan chosen_plan(const Job& job, const Stock& stock, const MeshChoice& choice) {
  MeshPlan plan = mesh_plan(job.mesh);
  plan.tolerance = choice.tolerance;
  plan.measure = is_measured(job, choice);
  plan.most_nodes = choice.most_nodes;
  plan.most_tolerance = choice.most_tolerance;
  plan.makes_new_octrees = choice.makes_new_octrees;
  // A limit that the user has set must hold; the mesher's estimate may err.
  double left = static_cast<double>(stock.memory_limit()) - stock.memory_expected();
  if (job.carve.max_memory > 0)
    left = (left - stock.list_room() - kThreadRoom * resolve_threads(job.mesh.threads)) / kMeshErr;
  plan.max_memory = static_cast<std::size_t>(std::max(left, 1.0));  // 0 is no limit
  return plan;
}

// The plan of a grid after a mesh within the tolerance was given up. It is a stage of its own for
// the progress, because the time of the first try does not predict its time.
MeshPlan grid_plan(const Job& job, const Stock& stock, const MeshChoice& choice) {
  MeshPlan plan = chosen_plan(job, stock, choice);
  if (job.mesh.progress)
    plan.progress = [&job](const char*, double share) {
      return job.mesh.progress("grid meshing", share);
    };
  return plan;
}

}  // namespace

std::string no_slabs(const Job& job, double tolerance) {
  if (tolerance > 0)
    return "a mesh with a tolerance is made in one piece: with --voxel and no --tolerance the run "
           "is done in slabs";
  if (job.max_triangles > 0)
    return "--max-triangles needs the whole mesh: without it the run is done in slabs";
  if (job.whole_mesh || job.inspect)
    return "a comparison or report needs the whole mesh: without it the run is done in slabs";
  return whole_output(job.outputs);
}

MeshReport MeshMaker::make() {
  const MeshPlan plan = chosen_plan(job_, stock_, choice_);
  MeshReport found = plan.tolerance > 0 ? extract(plan) : extract_grid(plan);
  memory_ = std::max(memory_, stock_.memory_expected() + found.memory);
  if (found.tolerance > choice_.tolerance) raise_tolerance(choice_, found.tolerance);
  if (found.given_up.empty()) return found;
  give_up_tolerance(choice_, found.given_up);
  release_freed_memory();
  stock_.plan_grid_mesh(choice_.voxel, choice_.cut_cells, no_slabs(job_, 0));
  memory_ = std::max(memory_, stock_.memory_expected());
  return extract_grid(grid_plan(job_, stock_, choice_));
}

MeshReport MeshMaker::extract(MeshPlan plan) {
  plan.tile_room = static_cast<std::size_t>(stock_.tile_room());
  part_.reset();
  part_.emplace(stock_.in_slabs() ? std::optional(spill_folder(job_.outputs)) : std::nullopt,
                plan.tolerance > 0 ? kUnlimited : stock_.mesh_room(), threads_, next_);
  MeshReport found;
  mesh_part(stock_.field(), choice_.voxel, plan, *part_, &found);
  return found;
}

// An estimate may err: what does not fit in one piece is made again in slabs.
MeshReport MeshMaker::extract_grid(const MeshPlan& plan) {
  try {
    return extract(plan);
  } catch (const Error&) {
    if (!part_->is_full()) throw;
  }
  part_->restart();
  part_.reset();
  release_freed_memory();
  memory_ = static_cast<double>(stock_.memory_limit());
  stock_.plan_slabs();
  return extract(plan);
}

double volume_before(const Job& job, const StockShape& shape, const MeshChoice& choice) {
  if (!shape.history.motions.empty()) {
    CarvePlan plan = carve_plan(job.carve);
    plan.keep_grid = false;  // only the volume of this stock is needed
    const Stock stock = carve(shape, shape.history.motions, shape.history.tools, plan);
    MeshPlan mesh = mesh_plan(job.mesh);
    mesh.tolerance = choice.tolerance;
    mesh.measure = is_measured(job, choice);
    mesh.most_nodes = choice.most_nodes, mesh.most_tolerance = choice.most_tolerance;
    MeshReport found;
    MeshAudit audit(mesh.threads);
    extract_mesh(stock, mesh, audit, &found);
    if (!found.given_up.empty()) {
      mesh.tolerance = 0;
      mesh_part(stock.field(), choice.fallback_voxel, mesh, audit, &found);
    }
    return audit.summary().volume - found.volume_excess;
  }
  const Vec3 size = shape.box.hi - shape.box.lo;
  if (shape.kind == StockShape::Kind::box) return size.x * size.y * size.z;
  if (shape.kind == StockShape::Kind::mesh) return signed_volume(shape.mesh);
  const double outer = shape.outer_radius, inner = shape.inner_radius;
  return kPi * (outer * outer - inner * inner) * size.z;
}

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
  const HausdorffBound apart = surface_distance(after, before, kUsualError, job.mesh.threads);
  result.reduction = {before.triangles.size(), apart.lower, apart.upper, apart.place};
  part.replace(std::move(after));
  outputs.replace_mesh();
  return true;
}

}  // namespace mrsim
