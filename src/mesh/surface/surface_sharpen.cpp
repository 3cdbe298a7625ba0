// Ridges whose tips pass between the edges of the grid: the crease lies outside of the cells that
// see both flanks, and the corner in which it ends outside of those that see three faces. Their
// vertices are moved there, where that makes no triangles meet; it is the one step that leaves the
// envelopes, so it is tested exactly.
#include "core/parallel.h"
#include "mesh/solid/exact_predicates.h"
#include "mesh/solid/self_intersection.h"
#include "mesh/surface/surface.h"

#include <cmath>

namespace mrsim::detail {
namespace {

constexpr int kRounds = 6;

}  // namespace

void DualSurface::sharpen(const CellOctree& tree) {
  std::vector<char> moved(mesh_.vertices.size(), 0);
  const std::vector<Vec3> before = mesh_.vertices;
  bool any = false;
  const auto move = [&](std::size_t v, const SurfacePoint& to) {
    if (to.count == 0) return;
    // Other sweeps may matter there than in the cell that it was found from.
    const std::int32_t cell = tree.locate(to.position);
    if (tree.node(cell).region != ExactField::Region::mixed ||
        !probe(cell).is_on_surface(to.position))
      return;
    mesh_.vertices[v] = snap(to.position);
    moved[v] = 1;
    any = true;
  };
  std::vector<SurfacePoint> tips = outside_;
  parallel_for(
      tips.size(), options_.threads,
      [&](std::size_t k) {
        const Loop& loop = loops_[k];
        if (tips[k].count > 0 || loop.point.count >= 3) return;
        static thread_local std::vector<FieldSample> faces;
        faces.clear();
        for (const std::int32_t c : crossings_of(loop))
          faces.push_back(crossings_[static_cast<std::size_t>(c)].at);
        tips[k] = corner_near(probe(loop.cell), cells_.box(loop.cell), loop.point.position, faces);
      },
      64);
  for (std::size_t k = 0; k < tips.size(); ++k) move(k, tips[k]);
  for (const Crease& c : creases_)
    if (const std::int32_t v = segments_[static_cast<std::size_t>(c.segment)].vertex; v >= 0)
      move(static_cast<std::size_t>(v), c.outside);
  std::vector<char> chosen(mesh_.triangles.size());  // triangles that the last round has changed
  for (std::uint32_t t = 0; t < chosen.size(); ++t)
    for (const std::uint32_t v : mesh_.triangles[t]) chosen[t] |= moved[v];
  for (int round = 0; any; ++round) {
    any = false;
    std::vector<char> back(mesh_.vertices.size(), 0);
    const auto put_back = [&](std::uint32_t t) {
      for (const std::uint32_t v : mesh_.triangles[t])
        if (moved[v]) {
          mesh_.vertices[v] = before[v];
          moved[v] = 0;
          back[v] = 1;
          any = true;
        }
    };
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto& x = mesh_.triangles[t];
      if ((moved[x[0]] || moved[x[1]] || moved[x[2]]) &&
          (round == kRounds ||
           is_degenerate(mesh_.vertices[x[0]], mesh_.vertices[x[1]], mesh_.vertices[x[2]])))
        put_back(t);
    }
    if (round == kRounds) return;
    for (const auto& [i, j] :
         self_intersections(mesh_.vertices, mesh_.triangles, options_.threads, chosen)) {
      put_back(i);
      put_back(j);
    }
    for (std::uint32_t t = 0; t < chosen.size(); ++t) {
      chosen[t] = 0;
      for (const std::uint32_t v : mesh_.triangles[t]) chosen[t] |= back[v];
    }
  }
}

}  // namespace mrsim::detail
