#include "mesh/simplify/mesh_certifier.h"

#include "core/numbers/triangle_tree.h"
#include "core/process/parallel.h"
#include "removal/field/face_range.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mrsim::detail {
namespace {

constexpr double kMissed = 1e-4;       ///< mm: a vertex farther off its face has missed a crease
constexpr double kLimitGrowth = 1.25;  ///< a bound above T is told within a quarter
constexpr double kLostReach = 2;       ///< voxels from a triangle to a place in a wall it passes
constexpr int kCreaseCells = 8;        ///< on each side of a cell that has missed a crease

int longest_axis(const Vec3& v) {
  const Vec3 size{std::abs(v.x), std::abs(v.y), std::abs(v.z)};
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

// A crease that a cell has missed, and that finer cells beside it have shown, goes on in the next
// cells along it, one round for each.
void add_ahead(const ExactField& field, const CellOctree& tree, const FieldSample& face,
               std::vector<std::int32_t>& cells) {
  for (std::size_t k = 0, count = cells.size(); k < count; ++k) {
    const std::int32_t c = cells[k];
    const Box3 box = tree.box(c);
    const Vec3 center = 0.5 * (box.lo + box.hi);
    const FieldSample other = tree.sample_at(center, c);
    const int axis =
        longest_axis(cross(field.gradient(center, face), field.gradient(center, other)));
    for (const int way : {-1, 1})
      for (int step = 1; step <= kCreaseCells; ++step) {
        Vec3 p = center;
        component(p, axis) += way * step * (box.hi.x - box.lo.x);
        const std::int32_t next = tree.locate(p, c);
        if (!tree.node(next).signs_differ || tree.node(next).size != tree.node(c).size) break;
        cells.push_back(next);
      }
  }
}

}  // namespace

TriangleBound MeshCertifier::bound(const Corners3& t, const FieldSample& face, double limit,
                                   FaceDistances& distances) const {
  const auto& [a, b, c] = t;
  TriangleBound found = triangle_bound(distances, face, a, b, c, limit);
  std::int32_t cell = 0;
  if (found.distance <= limit)
    found.distance =
        std::max(found.distance, largest_distance(distances, tree_, face, a, b, c, limit, cell));
  if (found.distance <= tolerance_) return found;
  const double part = part_bound(distances, tree_, a, b, c, limit);
  return part < found.distance ? TriangleBound{part, false} : found;
}

TriangleBound MeshCertifier::certified(const Corners3& t, const FieldSample& face, double limit,
                                       FaceDistances& distances) const {
  const auto& [a, b, c] = t;
  const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
  const TriangleBound found = bound(t, face, limit, distances);
  const double corner = kNearestCorner * longest;
  return corner <= found.distance ? TriangleBound{corner, true} : found;
}

// certified() stops at the first distance above its limit, and looks closely only at what may be
// below it: the limit grows until it holds.
TriangleBound MeshCertifier::least_bound(const Corners3& t, const FieldSample& face,
                                         FaceDistances& distances) const {
  for (double limit = tolerance_;; limit *= kLimitGrowth)
    if (const TriangleBound found = certified(t, face, limit, distances); !(found.distance > limit))
      return found;
}

// A triangle across the foot of a wall is inside it by half its thickness at most. The wall is
// known by its places on edges of the lattice, a voxel apart; between these it is at most as deep
// as half a voxel, or they would show it.
bool MeshCertifier::passes_lost(const Corners3& t, double bound,
                                std::span<const FoundThin> lost) const {
  const double voxel = tree_.lattice().voxel();
  return std::ranges::any_of(lost, [&](const FoundThin& found) {
    const Vec3& p = found.feature.place;
    return bound <= 0.5 * std::max(found.feature.thickness, voxel) &&
           distance(p, nearest_on_triangle(p, t[0], t[1], t[2]).point) <= kLostReach * voxel;
  });
}

MeshCertifier::Total MeshCertifier::total(LabelledMesh& mesh,
                                          std::span<const FoundThin> lost) const {
  std::vector<TriangleBound> bounds(mesh.triangles.size());
  std::vector<char> counts(mesh.triangles.size(), 1);
  std::vector<std::optional<FieldSample>> nearer(mesh.triangles.size());
  parallel_for_chunks(bounds.size(), threads_, kChunk, [&](std::size_t begin, std::size_t end) {
    FaceDistances distances(field_);
    for (std::size_t t = begin; t < end; ++t) {
      const Corners3 corners = corners_of(mesh, t);
      bounds[t] = least_bound(corners, mesh.faces[mesh.labels[t]], distances);
      if (bounds[t].distance <= tolerance_) continue;
      if (const auto face = nearer_face(field_, tree_, mesh, t)) {
        const TriangleBound other = least_bound(corners, *face, distances);
        if (other.distance < bounds[t].distance) bounds[t] = other, nearer[t] = face;
      }
      counts[t] =
          bounds[t].distance <= tolerance_ || !passes_lost(corners, bounds[t].distance, lost);
    }
  });
  Total total;
  for (std::size_t t = 0; t < bounds.size(); ++t) {
    if (counts[t]) total.bound = std::max(total.bound, bounds[t].distance);
    total.sampled += !bounds[t].is_proven;
    if (!nearer[t]) continue;
    mesh.labels[t] = static_cast<std::uint32_t>(mesh.faces.size());
    mesh.faces.push_back(*nearer[t]);
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

std::vector<std::int32_t> guilty_cells(const ExactField& field, const CellOctree& tree,
                                       const DualSurface& surface, const LabelledMesh& mesh,
                                       std::size_t t, bool ahead) {
  std::vector<std::int32_t> cells;
  const FieldSample& face = mesh.faces[mesh.labels[t]];
  const std::vector<Loop>& loops = surface.loops();
  for (const std::uint32_t v : mesh.triangles[t])
    if (v < loops.size() && std::abs(field.patch_distance(mesh.vertices[v], face)) > kMissed)
      cells.push_back(loops[v].cell);
  if (!cells.empty()) {
    if (ahead) add_ahead(field, tree, face, cells);
    return cells;
  }
  const Crossing& c = at(surface.crossings(), surface.mesh().crossings[t]);
  std::int32_t largest = 0;
  for (const std::int32_t cell : c.edge.cells) largest = std::max(largest, tree.node(cell).size);
  for (const std::int32_t cell : c.edge.cells)
    if (tree.node(cell).size == largest) cells.push_back(cell);
  return cells;
}

std::optional<FieldSample> nearer_face(const ExactField& field, const CellOctree& tree,
                                       const LabelledMesh& mesh, std::size_t t) {
  const Corners3 corners = corners_of(mesh, t);
  const Vec3 middle = (1.0 / 3) * (corners[0] + corners[1] + corners[2]);
  const auto farthest = [&](const FieldSample& face) {
    double most = 0;
    for (const Vec3& v : corners) most = std::max(most, std::abs(field.patch_distance(v, face)));
    return most;
  };
  double least = farthest(mesh.faces[mesh.labels[t]]);
  std::optional<FieldSample> nearer;
  const auto look_at = [&](const Vec3& p) {
    const FieldSample face = tree.sample_at(p, tree.locate(p));
    if (const double d = farthest(face); d < least) least = d, nearer = face;
  };
  look_at(middle);
  // Where the edge of a face passes the middle, another face may decide beside it.
  for (const Vec3& v : corners)
    if (!nearer && least > kMissed) look_at(0.5 * (middle + v));
  return nearer;
}

}  // namespace mrsim::detail
