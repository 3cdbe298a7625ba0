#include "mesh/contour_thin.h"

#include "mesh/contour_vertex.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace mrsim::detail {
namespace {

constexpr int kSearchSteps = 14;
constexpr int kBlock = 8;  ///< voxels

// A point between a and b that lies on the other side than both, by sections of the golden rule on
// |d|; false where none is found.
bool find_between(const Probe& probe, const Vec3& a, const Vec3& b, bool ends_inside, Vec3& out) {
  constexpr double kGolden = 0.3819660112501051;
  double low = 0, high = 1, depth[2], t[2] = {kGolden, 1 - kGolden};
  const auto measure = [&](double at) {
    out = lerp(a, b, at);
    const double d = probe.sample(out).distance;
    return ends_inside ? -d : d;
  };
  const auto through = [&](double d) {
    return ends_inside ? d <= kInsideTolerance : d < -kInsideTolerance;
  };
  for (int k = 0; k < 2; ++k) {
    depth[k] = measure(t[k]);
    if (through(depth[k])) return true;
  }
  for (int k = 0; k < kSearchSteps; ++k) {
    const bool left = depth[0] < depth[1];
    (left ? high : low) = left ? t[1] : t[0];
    const int keep = left ? 0 : 1;
    t[1 - keep] = t[keep];
    depth[1 - keep] = depth[keep];
    t[keep] = left ? low + kGolden * (high - low) : high - kGolden * (high - low);
    depth[keep] = measure(t[keep]);
    if (through(depth[keep])) return true;
  }
  return false;
}

}  // namespace

std::vector<ThinFeature> thin_features(const ExactField& field, const ContourOctree& tree) {
  std::vector<ThinFeature> out;
  std::set<std::tuple<std::int32_t, std::int32_t, std::uint64_t>> known;
  const std::int32_t block = kBlock * tree.lattice().per_voxel();
  for (const MinimalEdge& e : tree.doubtful_edges()) {
    const FieldSample &low = tree.sample(e.low), &high = tree.sample(e.high);
    LatticePoint end = e.start;
    component(end, e.axis) += e.length;
    const Vec3 a = tree.lattice().position(e.start), b = tree.lattice().position(end);
    const Probe probe{field, tree.candidates(e.cells[0]), 0};
    const bool inside = is_inside(low.distance);
    Vec3 middle;
    if (!find_between(probe, a, b, inside, middle)) continue;
    const std::int32_t first = std::min(low.owner, high.owner),
                       last = std::max(low.owner, high.owner);
    const LatticePoint place{e.start.x / block, e.start.y / block, e.start.z / block};
    if (!known.emplace(first, last, key(place)).second) continue;
    const Vec3 from = inside ? find_crossing(probe, a, middle) : find_crossing(probe, middle, a);
    const Vec3 to = inside ? find_crossing(probe, b, middle) : find_crossing(probe, middle, b);
    out.push_back({middle, !inside, distance(from, to), {first, last}});
  }
  return out;
}

}  // namespace mrsim::detail
