#include "mesh/simplify/mesh_certifier.h"

#include "core/parallel.h"
#include "removal/field/face_range.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace mrsim::detail {

TriangleBound MeshCertifier::bound(const LabelledMesh& mesh, std::size_t t, double limit,
                                   FaceDistances& distances) const {
  const auto& x = mesh.triangles[t];
  const Vec3 &a = mesh.vertices[x[0]], &b = mesh.vertices[x[1]], &c = mesh.vertices[x[2]];
  const FieldSample& label = mesh.faces[mesh.labels[t]];
  TriangleBound found = triangle_bound(distances, label, a, b, c, limit);
  std::int32_t cell = 0;
  if (found.distance <= limit)
    found.distance =
        std::max(found.distance, largest_distance(field_, tree_, label, a, b, c, limit, cell));
  if (found.distance <= tolerance_) return found;
  const double part = part_bound(distances, tree_, a, b, c, limit);
  return part < found.distance ? TriangleBound{part, false} : found;
}

TriangleBound MeshCertifier::certified(const LabelledMesh& mesh, std::size_t t, double limit,
                                       FaceDistances& distances) const {
  const auto& x = mesh.triangles[t];
  const Vec3 &a = mesh.vertices[x[0]], &b = mesh.vertices[x[1]], &c = mesh.vertices[x[2]];
  const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
  const TriangleBound found = bound(mesh, t, limit, distances);
  const double corner = kNearestCorner * longest;
  return corner <= found.distance ? TriangleBound{corner, true} : found;
}

MeshCertifier::Total MeshCertifier::total(const LabelledMesh& mesh) const {
  std::vector<TriangleBound> bounds(mesh.triangles.size());
  parallel_for_chunks(bounds.size(), threads_, kChunk, [&](std::size_t begin, std::size_t end) {
    FaceDistances distances(field_);
    // certified() stops at the first distance above its limit; with none it gives the true
    // bound.
    for (std::size_t t = begin; t < end; ++t) {
      bounds[t] = certified(mesh, t, tolerance_, distances);
      if (bounds[t].distance > tolerance_)
        bounds[t] = certified(mesh, t, std::numeric_limits<double>::infinity(), distances);
    }
  });
  Total total;
  for (const TriangleBound& b : bounds) {
    total.bound = std::max(total.bound, b.distance);
    total.sampled += !b.is_proven;
  }
  return total;
}

double MeshCertifier::volume_excess(const LabelledMesh& mesh) const {
  std::vector<double> parts(mesh.triangles.size());
  parallel_for(
      parts.size(), threads_,
      [&](std::size_t t) {
        const auto& x = mesh.triangles[t];
        parts[t] = excess_over(field_, tree_, mesh.faces[mesh.labels[t]], mesh.vertices[x[0]],
                               mesh.vertices[x[1]], mesh.vertices[x[2]], tolerance_);
      },
      64);
  double sum = 0;
  for (const double part : parts) sum += part;
  return sum;
}

}  // namespace mrsim::detail
