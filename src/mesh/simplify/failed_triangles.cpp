#include "mesh/simplify/failed_triangles.h"

#include "core/process/parallel.h"
#include "mesh/simplify/labelled_mesh.h"
#include "mesh/simplify/mesh_certifier.h"
#include "mesh/surface/input_hash.h"

#include <algorithm>
#include <cmath>

namespace mrsim::detail {
namespace {

std::uint64_t triangle_hash(const LabelledMesh& mesh, std::size_t t) {
  InputHash hash;
  hash.add(mesh.faces[mesh.labels[t]]);
  for (const std::uint32_t v : mesh.triangles[t]) hash.add(mesh.vertices[v]);
  return hash.value();
}

// A vertex lies far from the face that the triangle is measured by: what lies between is not seen
// in these cells, however finely the surface is drawn in them.
bool misses_crease(const LabelledMesh& mesh, std::size_t t, double tolerance,
                   FaceDistances& distances) {
  const auto& x = mesh.triangles[t];
  return std::any_of(x.begin(), x.end(), [&](std::uint32_t v) {
    return std::abs(distances(mesh.vertices[v], mesh.faces[mesh.labels[t]])) > tolerance;
  });
}

// How finely the surface about a crossing has to be drawn where a triangle there is `factor` times
// too far off. Each step of detail halves the distance, which falls with the square of the length
// of edges. Flat: no detail is enough, and the cells must be split. In late rounds they always are,
// because detail about one edge can need detail about the next, all along a curve.
Detail detail_for(const Crossing& crossing, double factor, const FailureRules& rules) {
  if (!rules.may_draw) return Detail::flat;
  if (crossing.detail == Detail::flat && factor <= 2 && !rules.is_late) return Detail::fan;
  return crossing.detail != Detail::full && factor <= 4 ? Detail::full : Detail::flat;
}

}  // namespace

FailedTriangles failed_triangles(const ExactField& field, const CellOctree& tree,
                                 const DualSurface& surface, const FlatMap& passed,
                                 const FailureRules& rules) {
  const LabelledMesh mesh = labelled_mesh(surface);
  const MeshCertifier certifier(field, tree, rules.tolerance, rules.threads);
  const std::size_t count = mesh.triangles.size();
  FailedTriangles out{std::vector<std::uint64_t>(count), std::vector<Detail>(count, Detail::flat),
                      std::vector<std::vector<std::int32_t>>(count)};
  parallel_for_chunks(
      count, rules.threads, MeshCertifier::kChunk, [&](std::size_t begin, std::size_t end) {
        FaceDistances distances(field);
        for (std::size_t t = begin; t < end; ++t) {
          out.hashes[t] = triangle_hash(mesh, t);
          if (passed.find(out.hashes[t]) >= 0) continue;
          const FieldSample& face = mesh.faces[mesh.labels[t]];
          const double bound =
              certifier.certified(corners_of(mesh, t), face, rules.tolerance, distances).distance;
          if (bound <= rules.tolerance) continue;
          if (!misses_crease(mesh, t, rules.tolerance, distances))
            out.wanted[t] = detail_for(at(surface.crossings(), surface.mesh().crossings[t]),
                                       bound / rules.tolerance, rules);
          if (out.wanted[t] == Detail::flat)
            out.guilty[t] = guilty_cells(field, tree, surface, mesh, t, rules.is_late);
        }
      });
  for (const auto& cells : out.guilty) out.cells += cells.size();
  return out;
}

}  // namespace mrsim::detail
