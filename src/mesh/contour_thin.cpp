#include "mesh/contour_thin.h"

#include "mesh/contour_vertex.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace mrsim::detail {
namespace {

constexpr int kSearchSteps = 14;
constexpr int kBlock = 8;  ///< voxels

struct EdgeEnd {
  Vec3 position;
  double distance = 0;
};

// A point between a and b that lies on the other side than both, by sections of the golden rule on
// |d|; false where none is found. As d is 1-Lipschitz, its values tell early that there is none in
// what is left.
bool find_between(const Probe& probe, const EdgeEnd& a, const EdgeEnd& b, bool ends_inside,
                  Vec3& out) {
  constexpr double kGolden = 0.3819660112501051;
  const double size = distance(a.position, b.position), side = ends_inside ? -1 : 1;
  double low = 0, high = 1, depth[2], t[2] = {kGolden, 1 - kGolden};
  double at_low = side * a.distance, at_high = side * b.distance;
  const auto measure = [&](double at) {
    out = lerp(a.position, b.position, at);
    return side * probe.sample(out).distance;
  };
  const auto through = [&](double d) {
    return ends_inside ? d <= kInsideTolerance : d < -kInsideTolerance;
  };
  const auto may_pass = [&](double from, double to, double share) {
    return from + to - share * size < 4 * kInsideTolerance;
  };
  for (int k = 0; k < 2; ++k) {
    depth[k] = measure(t[k]);
    if (through(depth[k])) return true;
  }
  for (int k = 0; k < kSearchSteps; ++k) {
    if (!may_pass(at_low, depth[0], t[0] - low) && !may_pass(depth[0], depth[1], t[1] - t[0]) &&
        !may_pass(depth[1], at_high, high - t[1]))
      return false;
    const bool left = depth[0] < depth[1];
    (left ? high : low) = left ? t[1] : t[0];
    (left ? at_high : at_low) = left ? depth[1] : depth[0];
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

std::vector<FoundThin> thin_features(const ExactField& field, const ContourCells& cells,
                                     std::span<const MinimalEdge> doubtful) {
  std::vector<FoundThin> out;
  const std::int32_t block = kBlock * cells.lattice().per_voxel();
  for (const MinimalEdge& e : doubtful) {
    const EdgeEnds ends = cells.ends(e);
    const Vec3 a = ends.low, b = high_end(ends, e.axis);
    const Probe probe{field, cells.candidates(e.cells[0]), 0};
    const FieldSample at_a = probe.sample(a), at_b = probe.sample(b);
    const std::int32_t low = at_a.owner, high = at_b.owner;
    Vec3 middle;
    if (low == high ||
        !find_between(probe, {a, at_a.distance}, {b, at_b.distance}, e.low_inside, middle))
      continue;
    const Vec3 from =
        e.low_inside ? find_crossing(probe, a, middle) : find_crossing(probe, middle, a);
    const Vec3 to =
        e.low_inside ? find_crossing(probe, b, middle) : find_crossing(probe, middle, b);
    const LatticePoint place{e.start.x / block, e.start.y / block, e.start.z / block};
    out.push_back(
        {{middle, !e.low_inside, distance(from, to), {std::min(low, high), std::max(low, high)}},
         key(place)});
  }
  return out;
}

std::vector<ThinFeature> distinct(std::span<const FoundThin> found) {
  std::vector<ThinFeature> out;
  std::set<std::tuple<std::int32_t, std::int32_t, std::uint64_t>> known;
  for (const FoundThin& f : found)
    if (known.emplace(f.feature.owner[0], f.feature.owner[1], f.block).second)
      out.push_back(f.feature);
  return out;
}

}  // namespace mrsim::detail
