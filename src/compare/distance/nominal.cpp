#include "compare/distance/nominal.h"

#include "core/numbers/solid_angle.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "core/process/error.h"
#include "core/process/memory_limit.h"
#include "core/process/parallel.h"
#include "mesh/format/mesh_builder.h"
#include "mesh/solid/check.h"
#include "mesh/solid/half_edges.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr std::size_t kBatch = 512;  // points that share one chain of hints

// Bits 0, 3, 6, ... of the low 21.
std::uint64_t spread_bits(std::uint64_t x) {
  x &= 0x1FFFFF;
  x = (x | x << 32) & 0x1F00000000FFFF;
  x = (x | x << 16) & 0x1F0000FF0000FF;
  x = (x | x << 8) & 0x100F00F00F00F00F;
  x = (x | x << 4) & 0x10C30C30C30C30C3;
  return (x | x << 2) & 0x1249249249249249;
}

// Vertices whose triangles form more than one fan, or none that closes.
std::vector<std::uint8_t> doubtful_vertices(const TriMesh& mesh,
                                            const std::vector<std::uint32_t>& opposite) {
  const VertexFans fans = half_edges_by_vertex(mesh);
  std::vector<std::uint8_t> doubtful(mesh.vertices.size(), 0);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const std::uint32_t begin = fans.begin[v], end = fans.begin[v + 1];
    if (begin == end) continue;
    std::uint32_t turned = 0, h = fans.items[begin];
    do {
      const std::uint32_t across = opposite[previous_half_edge(h)];
      if (!is_half_edge(across)) break;
      h = across;
    } while (++turned < end - begin && h != fans.items[begin]);
    doubtful[v] = turned != end - begin || h != fans.items[begin];
  }
  return doubtful;
}

bool has_area(const TriMesh& mesh, std::size_t f) {
  const Vec3 n = area_normal(mesh, f);
  return dot(n, n) > 0;
}

// Bit i of a triangle: its corner i (0..2), edge i - 3 (3..5) or face (6) cannot decide the sign.
std::vector<std::uint8_t> doubtful_features(const TriMesh& mesh, int threads) {
  const std::vector<std::uint32_t> opposite = find_opposites(mesh, threads);
  const std::vector<std::uint8_t> vertices = doubtful_vertices(mesh, opposite);
  std::vector<std::uint8_t> bits(mesh.triangles.size(), 0);
  bool any = false;
  for (std::size_t f = 0; f < bits.size(); ++f) {
    const bool flat = !has_area(mesh, f);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t across = opposite[3 * f + k];
      const bool edge = flat || !is_half_edge(across) || !has_area(mesh, across / 3);
      bits[f] = std::uint8_t(bits[f] | (edge ? 8u << k : 0u) |
                             (vertices[mesh.triangles[f][k]] ? 1u << k : 0u));
    }
    if (flat) bits[f] |= 1u << kTriangleFace;
    any = any || bits[f] != 0;
  }
  if (!any) bits.clear();
  return bits;
}

std::string describe(const std::string& role, const std::string& name) {
  return name.empty() ? "the " + role : name;
}

}  // namespace

std::vector<std::uint32_t> spatial_order(std::span<const Vec3> points, const Box3& bounds) {
  const Vec3 size = bounds.hi - bounds.lo;
  const double longest = std::max({size.x, size.y, size.z});
  const double scale = longest > 0 ? 2097151.0 / longest : 0;
  const auto code = [&](double x, double lo) {
    return spread_bits(static_cast<std::uint64_t>(std::clamp((x - lo) * scale, 0.0, 2097151.0)));
  };
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(points.size());
  for (std::uint32_t i = 0; i < keys.size(); ++i) {
    const Vec3& p = points[i];
    keys[i] = {code(p.x, bounds.lo.x) | code(p.y, bounds.lo.y) << 1 | code(p.z, bounds.lo.z) << 2,
               i};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) order[i] = keys[i].second;
  return order;
}

NominalSurface::NominalSurface(const TriMesh& mesh, int threads)
    : tree_(mesh), doubtful_(doubtful_features(mesh, threads)) {}

SurfaceHit NominalSurface::signed_hit(const Vec3& p, const TriangleTree::Hit& hit) const {
  if (doubtful_.empty() || !(doubtful_[hit.triangle] >> hit.feature & 1))
    return {tree_.signed_distance(p, hit), hit.triangle};
  const double d = std::sqrt(hit.distance2);
  return {winding_number(p) > 0.5 ? -d : d, hit.triangle};
}

// Of all triangles, each under the solid angle that p sees.
double NominalSurface::winding_number(const Vec3& p) const {
  double sum = 0;
  for (std::uint32_t t = 0; t < tree_.size(); ++t) {
    const TriangleTree::Corners k = tree_.corners(t);
    sum += half_solid_angle(k.a - p, k.b - p, k.c - p);
  }
  return sum / kTwoPi;
}

SurfaceHit NominalSurface::at(const Vec3& p, std::uint32_t hint) const {
  return signed_hit(p, tree_.nearest(p, hint));
}

void NominalSurface::query(std::span<const Vec3> points, std::span<SurfaceHit> out,
                           int threads) const {
  MRSIM_ASSERT(points.size() == out.size());
  Box3 bounds;
  for (const Vec3& p : points) extend(bounds, p);
  const std::vector<std::uint32_t> order = spatial_order(points, bounds);
  const std::size_t batches = (points.size() + kBatch - 1) / kBatch;
  parallel_for(batches, threads, [&](std::size_t batch) {
    std::uint32_t hint = 0;
    const std::size_t end = std::min(points.size(), (batch + 1) * kBatch);
    for (std::size_t i = batch * kBatch; i < end; ++i) {
      const std::uint32_t point = order[i];
      out[point] = at(points[point], hint);
      hint = out[point].triangle;
    }
  });
}

std::size_t NominalSurface::memory() const { return tree_.memory() + doubtful_.capacity(); }

double require_comparable(const TriMesh& mesh, const std::string& role, const std::string& name,
                          int threads) {
  const std::string who = describe(role, name);
  if (mesh.triangles.empty() || mesh.vertices.empty())
    throw Error("compare-empty", who + " has no triangles: there is nothing to compare");
  for (const auto& v : mesh.vertices)
    for (const float x : v) {
      if (!std::isfinite(x))
        throw Error("compare-not-finite", who + " has a vertex that is not a finite number");
      if (std::fabs(x) > detail::kFarthest)
        throw Error("compare-too-far", who + " has " + detail::too_far(double(x)));
    }
  require_memory(kCheckBytes * double(mesh.triangles.size()), "checking " + who,
                 "a coarser mesh takes less");
  try {
    require_solid(mesh, who, threads);
  } catch (const Error& error) {
    throw Error("compare-" + role + "-open",
                std::string(error.what()) +
                    "; inside and outside cannot be told apart, so deviations would have no sign");
  }
  return signed_volume(mesh);
}

}  // namespace mrsim
