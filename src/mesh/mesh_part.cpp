#include "mesh/mesh_part.h"

#include "core/process/error.h"
#include "mesh/adaptive.h"
#include "mesh/cells/cell_halvings.h"
#include "mesh/cells/thin_features.h"
#include "mesh/tiles/uniform.h"
#include "mesh/turned/turned_mesh.h"

#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr int kMostGrids = 4;  ///< tried one after the other where pieces meet

// By default a grid whose cells can not be split far enough gives way to one that is a little
// finer.
void mesh_grid(const ExactField& field, double voxel, const MeshPlan& options, MeshSink& sink,
               MeshReport& report) {
  for (int k = 1;; ++k) {
    try {
      const int halvings = detail::voxel_halvings(field.bounds(), voxel, 0);
      detail::mesh_uniform(field, voxel, halvings, options, sink, report);
      return;
    } catch (const Error& error) {
      if (error.code() != "mesh-unresolved" || !options.measure || k == kMostGrids) throw;
      sink.restart();
      report = {};
      voxel *= 1 - 1.0 / 64;
    }
  }
}

}  // namespace

void mesh_part(const ExactField& field, double voxel, const MeshPlan& options, MeshSink& sink,
               MeshReport* report) {
  if (!(voxel > 0) || !std::isfinite(voxel))
    throw Error("voxel-invalid", fmt::format("a voxel of {} mm is not a positive length", voxel));
  if (!(options.tolerance >= 0) || !std::isfinite(options.tolerance))
    throw Error("tolerance-invalid",
                fmt::format("--tolerance {} is not a length in mm", options.tolerance),
                Error::Kind::usage);
  MeshReport ignored;
  MeshReport& out = report ? *report : ignored;
  out = {};
  if (options.tolerance > 0 && field.is_turned(field.all()))
    if (const std::optional<TriMesh> turned = detail::turned_mesh(field, voxel, options, out))
      return sink.take(whole_block(*turned));
  detail::require_resolved(field.bounds(), voxel);
  if (options.tolerance == 0) return mesh_grid(field, voxel, options, sink, out);
  if (const std::optional<TriMesh> mesh = adaptive_mesh(field, voxel, options, out))
    sink.take(whole_block(*mesh));
}

TriMesh mesh_part(const ExactField& field, double voxel, const MeshPlan& options,
                  MeshReport* report) {
  MeshCollector collector;
  mesh_part(field, voxel, options, collector, report);
  if (collector.mesh().triangles.empty()) refuse_empty(field, voxel);
  return std::move(collector.mesh());
}

void refuse_empty(const ExactField& field, double voxel) {
  const std::optional<ThinFeature> left = detail::find_material(field, voxel);
  if (!left) throw Error("part-empty", "nothing is left of the stock");
  throw Error(
      "part-thin",
      fmt::format("what is left of the stock is thinner than a voxel, {:.3g} mm at ({:.3f}, "
                  "{:.3f}, {:.3f}), so that no mesh was made; --voxel {:.2g} --tolerance "
                  "{:.2g} shows it",
                  left->thickness, left->place.x, left->place.y, left->place.z,
                  0.45 * left->thickness, std::min(voxel / 8, left->thickness / 2)));
}

}  // namespace mrsim
