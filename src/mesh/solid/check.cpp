#include "mesh/solid/check.h"

#include "core/process/error.h"
#include "mesh/solid/half_edges.h"
#include "mesh/solid/mesh_audit.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

// Faults that make the later checks meaningless.
std::string invalid_content(const TriMesh& mesh) {
  if (mesh.triangles.empty()) return "the mesh has no triangles";
  if (mesh.triangles.size() > 1'400'000'000) return "the mesh has more than 1.4e9 triangles";
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
    for (const std::uint32_t v : mesh.triangles[f])
      if (v >= mesh.vertices.size())
        return fmt::format("triangle {} names vertex {}, there are {}", f + 1, std::uint64_t(v) + 1,
                           mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    for (const float x : mesh.vertices[v])
      if (!std::isfinite(x))
        return fmt::format("vertex {} has a coordinate that is not a number", v + 1);
  return {};
}

}  // namespace

MeshSummary check_mesh(const TriMesh& mesh, int threads) {
  MeshSummary out;
  out.first_fault = invalid_content(mesh);
  if (!out.first_fault.empty()) return out;
  MeshAudit audit(threads);
  audit.take(whole_block(mesh));
  return audit.summary();
}

void require_solid(const TriMesh& mesh, const std::string& name, int threads) {
  const MeshSummary summary = check_mesh(mesh, threads);
  const bool valid = summary.components > 0;
  // Surfaces that touch in a point still bound a solid: a stock may, a part that is written may
  // not.
  if (valid && summary.oriented) return;
  const auto fail = [&](const char* code, const char* advice) {
    throw Error(code, fmt::format("{}: {}; {}", name, summary.first_fault, advice));
  };
  if (!valid) fail("mesh-invalid", "export it again");
  if (summary.inverted)
    fail("mesh-inverted", "the triangles must be counter-clockwise seen from outside: flip them");
  if (!summary.closed && summary.first_fault.starts_with("open"))
    fail("mesh-open", "a solid has no open edges: repair or export it again");
  if (summary.closed && !summary.oriented)
    fail("mesh-not-oriented",
         "all triangles must be counter-clockwise seen from outside: repair it");
  fail("mesh-not-manifold", "repair or export it again");
}

double signed_volume(const TriMesh& mesh) {
  if (mesh.triangles.empty()) return 0;
  const Vec3 center = corner(mesh, 0, 0);
  OrderlessSum volume6;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const Vec3 a = corner(mesh, f, 0) - center;
    volume6.add(dot(a, cross(corner(mesh, f, 1) - center - a, corner(mesh, f, 2) - center - a)));
  }
  return volume6.value() / 6;
}

double surface_area(const TriMesh& mesh) {
  double area = 0;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) area += length(area_normal(mesh, f)) / 2;
  return area;
}

Box3 mesh_bounds(const TriMesh& mesh) {
  Box3 box;
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t) extend(box, to_vec(mesh.vertices[v]));
  return box;
}

}  // namespace mrsim
