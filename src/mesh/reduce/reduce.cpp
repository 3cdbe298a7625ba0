#include "mesh/reduce/reduce.h"

#include "core/numbers/triangle_tree.h"
#include "core/numbers/vec.h"
#include "core/process/error.h"
#include "core/process/memory_limit.h"
#include "core/process/parallel.h"
#include "mesh/reduce/decimation.h"
#include "mesh/solid/half_edges.h"
#include "mesh/solid/self_intersection.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mrsim {
namespace {

constexpr int kRounds = 4;  // of one step, each with more vertices that stay
// Share of its mesh's triangles that a step keeps; the second where a step with the first leads
// nowhere.
constexpr double kLeastShares[] = {0.2, 0.5};
constexpr double kBytesPerTriangle = 450;  // of its half edges, quadrics and queue
constexpr std::size_t kTellEach = 4096;    // collapses

// Counts the collapses of a reduction, and reports to the caller how far it is.
class Counter {
 public:
  Counter(const Progress& tell, std::size_t wanted)
      : tell_(tell), wanted_(static_cast<double>(wanted)) {}
  // Throws Error "cancelled".
  void collapsed() {
    if (++done_ % kTellEach != 0 || !tell_) return;
    if (!tell_("reduce", std::min(static_cast<double>(done_) / wanted_, 1.0)))
      throw Error("cancelled", "the run was stopped");
  }

 private:
  const Progress& tell_;
  double wanted_;
  std::size_t done_ = 0;
};

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Pairs crossings(const TriMesh& mesh, int threads) {
  std::vector<Vec3> points;
  points.reserve(mesh.vertices.size());
  for (const auto& v : mesh.vertices) points.push_back(to_vec(v));
  return detail::self_intersections(points, mesh.triangles, threads);
}

Box3 box_of(const TriMesh& mesh, std::uint32_t triangle) {
  Box3 box;
  for (const std::uint32_t v : mesh.triangles[triangle]) extend(box, to_vec(mesh.vertices[v]));
  return box;
}

// Vertices of the mesh that was given stay where triangles of the small one cross: those near the
// common part of their boxes, in later rounds of both boxes.
void keep_about(const Pairs& pairs, const TriMesh& small, const TriMesh& mesh,
                const TriangleTree& tree, int round, std::vector<char>& stays) {
  for (const auto& [i, j] : pairs) {
    Box3 a = box_of(small, i);
    const Box3 b = box_of(small, j);
    if (round < kRounds / 2) {
      a.lo = {std::max(a.lo.x, b.lo.x), std::max(a.lo.y, b.lo.y), std::max(a.lo.z, b.lo.z)};
      a.hi = {std::min(a.hi.x, b.hi.x), std::min(a.hi.y, b.hi.y), std::min(a.hi.z, b.hi.z)};
    } else {
      extend(a, b.lo);
      extend(a, b.hi);
    }
    tree.visit(a, [&](std::uint32_t t) {
      for (const std::uint32_t v : mesh.triangles[t]) stays[v] = 1;
      return true;
    });
  }
}

void set_owners(const TriMesh& mesh, int threads, TriMesh& small) {
  small.origin = mesh.origin;
  if (mesh.owners.empty()) return;
  const TriangleTree tree(mesh);
  small.owners.resize(small.triangles.size());
  parallel_for(small.triangles.size(), threads, [&](std::size_t i) {
    const auto& t = small.triangles[i];
    const Vec3 sum =
        to_vec(small.vertices[t[0]]) + to_vec(small.vertices[t[1]]) + to_vec(small.vertices[t[2]]);
    small.owners[i] = mesh.owners[tree.nearest((1.0 / 3) * sum).triangle];
  });
}

// One step of the reduction: `mesh` with `most` triangles, or with more where no edge is left that
// may collapse; without triangles where all that were tried cross themselves.
TriMesh step(const TriMesh& mesh, std::size_t most, int threads, Counter& counter) {
  std::optional<TriangleTree> tree;
  std::vector<char> stays(mesh.vertices.size(), 0);
  for (int round = 0; round < kRounds; ++round) {
    TriMesh small = decimated(mesh, most, stays, [&] { counter.collapsed(); });
    const Pairs pairs = crossings(small, threads);
    if (pairs.empty()) return small;
    if (!tree) tree.emplace(mesh);
    keep_about(pairs, small, mesh, *tree, round, stays);
  }
  return {};
}

}  // namespace

double reduction_memory(std::size_t triangles) {
  return kBytesPerTriangle * static_cast<double>(triangles);
}

TriMesh reduce_mesh(const TriMesh& mesh, std::size_t most, const MeshOptions& options) {
  if (mesh.triangles.size() <= most) return mesh;
  require_memory(reduction_memory(mesh.triangles.size()), "--max-triangles");
  TriMesh reduced = mesh;
  Counter counter(options.progress, (mesh.triangles.size() - most) / 2 + 1);
  while (reduced.triangles.size() > most) {
    const std::size_t size = reduced.triangles.size();
    TriMesh next;
    for (const double share : kLeastShares) {
      const auto least = static_cast<std::size_t>(share * static_cast<double>(size));
      next = step(reduced, std::max(most, least), options.threads, counter);
      if (!next.triangles.empty()) break;
    }
    if (next.triangles.empty() || next.triangles.size() == size) break;
    reduced = std::move(next);
  }
  set_owners(mesh, options.threads, reduced);
  return reduced;
}

}  // namespace mrsim
