#include "mesh/contour.h"

#include "core/error.h"
#include "mesh/contour_surface.h"

#include <chrono>

namespace mrsim {
namespace {

using detail::BaseMesh;
using detail::ContourOctree;
using detail::ContourSurface;
using detail::Lattice;

TriMesh to_mesh(const BaseMesh& base, const ContourSurface& surface) {
  TriMesh mesh;
  mesh.vertices.reserve(base.vertices.size());
  for (const Vec3& p : base.vertices)
    mesh.vertices.push_back(
        {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  mesh.triangles = base.triangles;
  mesh.owners.reserve(base.triangles.size());
  for (const std::int32_t c : base.crossings)
    mesh.owners.push_back(surface.crossings()[static_cast<std::size_t>(c)].at.owner);
  return mesh;
}

}  // namespace

TriMesh contour(const ExactField& field, double voxel, const MeshOptions& options,
                ContourReport* report) {
  ContourReport ignored;
  ContourReport& out = report ? *report : ignored;
  out = {};
  const bool adaptive = options.tolerance > 0;
  const Lattice lattice(field.bounds(), voxel, detail::kFineLevels);
  ContourOctree tree(field, lattice, adaptive, options.threads);
  ContourSurface surface(field, tree, options.threads);
  for (;;) {
    ++out.passes;
    std::vector<std::int32_t> bad = surface.find_loops();
    if (tree.split(bad) == 0) break;
  }
  const BaseMesh& base = surface.make_triangles();
  out.cells = surface.loops().size();
  out.triangles_before = base.triangles.size();
  return to_mesh(base, surface);
}

}  // namespace mrsim
