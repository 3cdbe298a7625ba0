#include "mesh/surface/crossing_finder.h"

#include "core/process/parallel.h"
#include "mesh/surface/sample_groups.h"

#include <algorithm>
#include <cmath>

namespace mrsim::detail {

// Lengths are powers of two and starts multiples of them, so twice the middle tells both.
std::uint64_t edge_key(const MinimalEdge& e) {
  const auto part = [&](int axis) { return static_cast<std::uint64_t>(component(e.start, axis)); };
  const std::uint64_t twice = 2 * part(e.axis) + static_cast<std::uint64_t>(e.length);
  return twice | part((e.axis + 1) % 3) << 21 | part((e.axis + 2) % 3) << 42 |
         static_cast<std::uint64_t>(e.axis) << 62;
}

void CrossingFinder::refine(const Crossing& crossing, Detail detail) {
  Detail& known = found_[static_cast<std::size_t>(known_.find(edge_key(crossing.edge)))].detail;
  known = std::max(known, detail);
}

void CrossingFinder::find(const std::vector<MinimalEdge>& edges) {
  crossings_.assign(edges.size(), {});
  std::vector<std::int32_t> ids(edges.size(), -1), fresh;
  parallel_for(
      edges.size(), options_.threads,
      [&](std::size_t k) {
        Crossing& c = crossings_[k];
        c.edge = edges[k];
        const EdgeEnds ends = cells_.ends(c.edge);
        c.position = ends.low;
        c.low = mrsim::component(ends.low, c.edge.axis);
        c.high = ends.high;
        if (options_.remember) ids[k] = known_.find(edge_key(c.edge));
        if (ids[k] < 0) return;
        const Found& found = at(found_, ids[k]);
        c.position = found.position;
        c.normal = found.normal;
        c.at = found.at;
        c.detail = found.detail;
      },
      256);
  for (std::size_t k = 0; k < edges.size(); ++k)
    if (ids[k] < 0) fresh.push_back(static_cast<std::int32_t>(k));
  if (options_.remember)
    for (const std::int32_t k : fresh) {
      ids[static_cast<std::size_t>(k)] =
          known_.insert(edge_key(at(crossings_, k).edge), static_cast<std::int32_t>(found_.size()))
              .first;
      found_.emplace_back();
    }
  const Groups groups(fresh, cells_.lists(), [&](std::int32_t k) {
    return cells_.list_of(at(crossings_, k).edge.smallest_cell());
  });
  parallel_for(
      groups.size(), options_.threads, [&](std::size_t g) { find_together(groups[g]); }, 32);
  if (!options_.remember) return;
  for (const std::int32_t k : fresh) {
    const Crossing& c = at(crossings_, k);
    found_[static_cast<std::size_t>(ids[static_cast<std::size_t>(k)])] = {c.position, c.normal,
                                                                          c.at};
  }
}

// Finds both ends of the edges of crossings with the same candidates. Offsets are rounded, because
// a tile knows rounded ones or none, and the result may not depend on that.
void CrossingFinder::find_ends(const Probe& p, std::span<const std::int32_t> crossings,
                               std::vector<SegmentEnd>& out) const {
  struct Memory {
    std::vector<std::size_t> unknown;
    std::vector<Vec3> points;
    std::vector<double> distances;
  };
  static thread_local Memory memory;
  auto& [unknown, points, distances] = memory;
  unknown.clear();
  points.clear();
  out.clear();
  for (const std::int32_t k : crossings) {
    const Crossing& c = at(crossings_, k);
    const auto [low, high] = cells_.offsets(c.edge);
    out.push_back({c.low_end(), static_cast<float>(low)});
    out.push_back({c.high_end(), static_cast<float>(high)});
    for (std::size_t i = out.size() - 2; i < out.size(); ++i) {
      if (std::isfinite(out[i].offset)) continue;
      unknown.push_back(i);
      points.push_back(out[i].position);
    }
  }
  if (unknown.empty()) return;
  distances.resize(points.size());
  field_.distances(points, p.candidates, distances.data());
  for (std::size_t i = 0; i < unknown.size(); ++i)
    out[unknown[i]].offset = static_cast<float>(distances[i] + kInsideTolerance);
}

// Crossings with the same candidates.
void CrossingFinder::find_together(std::span<const std::int32_t> crossings) {
  struct Memory {
    std::vector<CrossingSearch> searches;
    std::vector<SegmentEnd> ends;
  };
  static thread_local Memory memory;
  auto& [searches, ends] = memory;
  const Probe p = probe(at(crossings_, crossings[0]).edge.smallest_cell());
  find_ends(p, crossings, ends);
  searches.clear();
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const SegmentEnd &low = ends[2 * i], &high = ends[2 * i + 1];
    const bool low_inside = at(crossings_, crossings[i]).edge.low_inside;
    searches.emplace_back(low_inside ? low : high, low_inside ? high : low);
  }
  run_together(p, std::span(searches));
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    Crossing& c = crossings_[static_cast<std::size_t>(crossings[i])];
    c.at = searches[i].at();
    c.normal = searches[i].normal();
    const int axis = c.edge.axis;
    const Box3 inner = cells_.inner_box(c.edge.smallest_cell());
    mrsim::component(c.position, axis) =
        snap_between(mrsim::component(searches[i].position(), axis),
                     mrsim::component(inner.lo, axis), mrsim::component(inner.hi, axis));
  }
}

}  // namespace mrsim::detail
