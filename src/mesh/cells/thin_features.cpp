#include "mesh/cells/thin_features.h"

#include "core/numbers/triangle_tree.h"
#include "core/process/parallel.h"
#include "mesh/points/vertex.h"

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>
#include <unordered_map>

namespace mrsim::detail {
namespace {

constexpr int kSearchSteps = 14;
constexpr int kBeside = 4;        ///< lines beside an edge are apart by this share of its length
constexpr int kMostPassages = 4;  ///< of the surface through one edge that a mesh may hold
constexpr int kHiddenSteps = 24;
constexpr double kGridDepth = 1.0 / 16;  ///< of a voxel: of what a grid holds beside its edges

struct EdgeEnd {
  Vec3 position;
  FieldSample at;
};
EdgeEnd sampled(const Probe& probe, const Vec3& p) { return {p, probe.sample(p)}; }

/// What passes a segment whose ends lie on one side of the surface.
struct Passage {
  Vec3 from, to;  ///< where the segment enters and leaves it
  Vec3 middle;    ///< between them, on the other side
};

// A point between a and b that lies on the other side than both, by sections of the golden rule on
// |d|; false where none is found. As d is 1-Lipschitz, the search stops early when no such point
// can lie in the remaining interval.
bool find_between(const Probe& probe, const EdgeEnd& a, const EdgeEnd& b, bool ends_inside,
                  Vec3& out) {
  constexpr double kGolden = 0.3819660112501051;
  const double size = distance(a.position, b.position), side = ends_inside ? -1 : 1;
  double low = 0, high = 1, depth[2], t[2] = {kGolden, 1 - kGolden};
  double at_low = side * a.at.distance, at_high = side * b.at.distance;
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

// `ends_inside`: the side on which both ends lie.
std::optional<Passage> find_passage(const Probe& probe, const EdgeEnd& a, const EdgeEnd& b,
                                    bool ends_inside) {
  Passage found;
  if (a.at.owner == b.at.owner || !find_between(probe, a, b, ends_inside, found.middle)) return {};
  const auto crossing = [&](const Vec3& end) {
    return ends_inside ? find_crossing(probe, end, found.middle)
                       : find_crossing(probe, found.middle, end);
  };
  found.from = crossing(a.position);
  found.to = crossing(b.position);
  return found;
}

ThinFeature feature_of(const EdgeEnd& a, const EdgeEnd& b, const Passage& passage, bool is_wall) {
  const auto [low, high] = std::minmax(a.at.owner, b.at.owner);
  return {passage.middle, is_wall, distance(passage.from, passage.to), {low, high}};
}
std::uint64_t block_of(const SurfaceCells& cells, const MinimalEdge& e) {
  const std::int32_t block = kThinBlock * cells.lattice().per_voxel();
  return key({e.start.x / block, e.start.y / block, e.start.z / block});
}
FoundThin feature_of(const SurfaceCells& cells, const MinimalEdge& e, const EdgeEnd& a,
                     const EdgeEnd& b, const Passage& passage, bool is_wall) {
  return {feature_of(a, b, passage, is_wall), block_of(cells, e)};
}

// The part of a cell that is no farther from the edge than the edge is long.
Box3 room_about(const SurfaceCells& cells, const MinimalEdge& e, std::int32_t cell) {
  const EdgeEnds ends = cells.ends(e);
  const Box3 near = inflated(Box3{ends.low, high_end(ends, e.axis)},
                             ends.high - mrsim::component(ends.low, e.axis));
  const Box3 box = cells.box(cell);
  return {max(box.lo, near.lo), min(box.hi, near.hi)};
}

Vec3 clamped(const Vec3& p, const Box3& room) { return max(room.lo, min(p, room.hi)); }

// A point in the room that lies at least `depth` mm on the other side of the surface, found by
// projections in turn onto what the deepest sweep leaves and onto the room [Cheney, Goldstein
// 1959]: they end in what all sweeps leave, where that is convex and not empty.
std::optional<Vec3> find_hidden(const Probe& probe, const Box3& room, bool ends_inside,
                                double depth) {
  const double side = ends_inside ? -1 : 1;
  Vec3 p = 0.5 * (room.lo + room.hi);
  for (int k = 0; k < kHiddenSteps; ++k) {
    const FieldSample at = probe.sample(p);
    const double above = side * at.distance;
    if (above <= -depth) return p;
    // A little farther than needed, or the last steps become ever shorter.
    const Vec3 next = clamped(p - side * (above + 1.5 * depth) * probe.field.gradient(p, at), room);
    if (distance(p, next) < 0.1 * depth) return {};
    p = next;
  }
  return {};
}

// The feature at p with its thickness: twice the first maximum of |d| on the way from p away from
// the surface, if there is one in the room.
ThinFeature measured(const Probe& probe, const Box3& room, const Vec3& p) {
  constexpr int kSamples = 32;
  const FieldSample first = probe.sample(p);
  const double side = is_inside(first.distance) ? 1 : -1;
  ThinFeature found{p, side > 0, 2 * std::abs(first.distance), {first.owner, first.owner}};
  const Vec3 way = length(room.hi - room.lo) * probe.field.gradient(p, first);
  const Vec3 end = clamped(p - side * way, room);
  double deepest = std::abs(first.distance);
  for (int k = 1; k <= kSamples; ++k) {
    const FieldSample at = probe.sample(lerp(p, end, static_cast<double>(k) / kSamples));
    if (-side * at.distance >= deepest) {
      deepest = -side * at.distance;
      continue;
    }
    found.thickness = 2 * deepest;
    found.owner[1] = at.owner;
    break;
  }
  if (found.owner[0] > found.owner[1]) std::swap(found.owner[0], found.owner[1]);
  return found;
}

// The feature that stands amid the cells about an edge without crossing one of theirs: what
// `hidden` finds in the room of the first of them that the surface may pass.
template <class Hidden>
std::optional<ThinFeature> first_hidden(const SurfaceCells& cells, const MinimalEdge& e,
                                        const Hidden& hidden) {
  for (int k = 0; k < 4; ++k) {
    const std::int32_t cell = e.cells[k];
    if (!cells.is_mixed(cell) || std::find(e.cells, e.cells + k, cell) != e.cells + k) continue;
    if (const std::optional<ThinFeature> found = hidden(cell, room_about(cells, e, cell)))
      return found;
  }
  return {};
}

// Looks for what a mesh has lost. A closed mesh has a point on the side to which the
// pseudonormal at its nearest point looks. A wall is held on an edge of the grid where the two
// points in which the edge passes the wall's sides are no farther than the tolerance from the mesh,
// and a point in it is in the mesh, or no farther from it either: the crests between the rows of a
// raster are walls that a mesh may cut off. That the tip of a wall is held on one edge does not say
// how much of it is, so lines beside the edge are searched too, in all cells about it.
class LostSearch {
 public:
  LostSearch(const ExactField& field, const SurfaceCells& cells, const TriMesh& mesh,
             double tolerance, double thinnest)
      : field_(field), cells_(cells), mesh_(mesh), tolerance_(tolerance), thinnest_(thinnest) {}

  std::optional<FoundThin> on_edge(const MinimalEdge& e) const {
    const EdgeEnds ends = cells_.ends(e);
    const Vec3 low = ends.low, high = high_end(ends, e.axis);
    bool found = false;
    std::optional<FoundThin> lost = on_line(e, e.cells[0], low, high, found);
    const double step = (ends.high - mrsim::component(low, e.axis)) / kBeside;
    for (int i = 1 - kBeside; found && i < kBeside; ++i)
      for (int j = 1 - kBeside; !lost && j < kBeside; ++j) {
        Vec3 beside;
        mrsim::component(beside, (e.axis + 1) % 3) = i * step;
        mrsim::component(beside, (e.axis + 2) % 3) = j * step;
        const std::int32_t cell = e.cells[(i >= 0 ? 1 : 0) | (j >= 0 ? 2 : 0)];
        lost = on_line(e, cell, low + beside, high + beside, found);
      }
    return lost ? lost : beside_edge(e);
  }

 private:
  // Something thicker than the tolerance that passes no edge.
  std::optional<FoundThin> beside_edge(const MinimalEdge& e) const {
    const auto found = first_hidden(
        cells_, e, [&](std::int32_t cell, const Box3& room) -> std::optional<ThinFeature> {
          const Probe probe{field_, cells_.candidates(cell), 0};
          const auto p = find_hidden(probe, room, e.low_inside, tolerance_ / 2);
          if (!p || is_held(*p, !e.low_inside)) return {};
          return measured(probe, room, *p);
        });
    if (!found) return {};
    return FoundThin{*found, block_of(cells_, e)};
  }

  // `found`: set where the line passes something thin.
  std::optional<FoundThin> on_line(const MinimalEdge& e, std::int32_t cell, const Vec3& low,
                                   const Vec3& high, bool& found) const {
    if (!cells_.is_mixed(cell)) return {};
    const Probe probe{field_, cells_.candidates(cell), 0};
    const EdgeEnd a = sampled(probe, low), b = sampled(probe, high);
    if (is_inside(a.at.distance) != is_inside(b.at.distance)) return at_end(e, probe, a, b);
    return between(e, probe, a, b, kMostPassages, found);
  }

  // For a line with ends on different sides: the end that the mesh has on the wrong side.
  std::optional<FoundThin> at_end(const MinimalEdge& e, const Probe& probe, const EdgeEnd& a,
                                  const EdgeEnd& b) const {
    for (const EdgeEnd* end : {&a, &b}) {
      const bool is_wall = is_inside(end->at.distance);
      if (is_held(end->position, is_wall)) continue;
      const Vec3 &p = end->position, &q = end == &a ? b.position : a.position;
      const Vec3 from = is_wall ? find_crossing(probe, p, q) : find_crossing(probe, q, p);
      return feature_of(cells_, e, a, b, {from, p, p}, is_wall);
    }
    return {};
  }

  std::optional<FoundThin> between(const MinimalEdge& e, const Probe& probe, const EdgeEnd& a,
                                   const EdgeEnd& b, int most, bool& found) const {
    const bool ends_inside = is_inside(a.at.distance);
    const std::optional<Passage> passage = find_passage(probe, a, b, ends_inside);
    if (!passage || distance(passage->from, passage->to) < thinnest_) return {};
    found = true;
    if (most == 0 || !is_held(probe, *passage, !ends_inside))
      return feature_of(cells_, e, a, b, *passage, !ends_inside);
    const auto rest = [&](const EdgeEnd& end, const Vec3& side) -> std::optional<FoundThin> {
      const double left = distance(side, end.position);
      if (left <= kSurfaceBand) return {};
      const EdgeEnd next = sampled(probe, lerp(side, end.position, kSurfaceBand / left));
      if (is_inside(next.at.distance) != ends_inside) return {};
      return between(e, probe, end, next, most - 1, found);
    };
    const std::optional<FoundThin> lost = rest(a, passage->from);
    return lost ? lost : rest(b, passage->to);
  }

  bool is_held(const Probe& probe, const Passage& passage, bool is_wall) const {
    const Vec3 half = 0.5 * (passage.from + passage.to);
    const bool is_in = is_inside(probe.sample(half).distance) == is_wall;
    return is_near(passage.from) && is_near(passage.to) &&
           is_held(is_in ? half : passage.middle, is_wall);
  }
  // The mesh has p on this side, or lies no farther off than the tolerance.
  bool is_held(const Vec3& p, bool inside) const {
    return is_near(p) || (mesh_.signed_distance(p) < 0) == inside;
  }
  bool is_near(const Vec3& p) const { return mesh_.is_near(p, tolerance_); }

  const ExactField& field_;
  const SurfaceCells& cells_;
  TriangleTree mesh_;
  double tolerance_, thinnest_;  ///< mm
};

}  // namespace

namespace {

// In most blocks that hold nothing of a depth the first projections show it.
std::optional<ThinFeature> find_material(const ExactField& field, const Box3& box, double voxel,
                                         std::span<const std::uint32_t> candidates) {
  Candidates own;
  const auto region = field.restrict_to(inflated(box, kQuantum), kSurfaceBand, candidates, own);
  if (region == ExactField::Region::air) return {};
  const Probe probe{field, own, 0};
  if (const auto p = find_hidden(probe, box, /*ends_inside=*/false, kGridDepth * voxel))
    return measured(probe, box, *p);
  if (box.hi.x - box.lo.x <= voxel) return {};
  for (int k = 0; k < 8; ++k)
    if (const auto found = find_material(field, octant(box, k), voxel, own)) return found;
  return {};
}

}  // namespace

std::optional<ThinFeature> find_material(const ExactField& field, double voxel) {
  const Box3 cube = cube_about(field.bounds());
  // A voxel as large as the stock would look at a few places of it.
  return find_material(field, cube, std::min(voxel, (cube.hi.x - cube.lo.x) / 64), field.all());
}

std::optional<ThinFeature> thin_between(const Probe& probe, const Vec3& low, const Vec3& high) {
  const EdgeEnd a = sampled(probe, low), b = sampled(probe, high);
  const bool ends_inside = is_inside(a.at.distance);
  const std::optional<Passage> found = find_passage(probe, a, b, ends_inside);
  if (!found) return {};
  return feature_of(a, b, *found, !ends_inside);
}

namespace {

// What single cells hide. The room about most edges is the whole cell, so that its twelve edges ask
// for the same: it is remembered for the cell.
class HiddenInCells {
 public:
  HiddenInCells(const ExactField& field, const SurfaceCells& cells)
      : field_(field), cells_(cells), depth_(kGridDepth * cells.lattice().voxel()) {}

  std::optional<ThinFeature> find(std::int32_t cell, const Box3& room, bool ends_inside) {
    if (!cells_.is_far(cell)) return {};
    const Box3 box = cells_.box(cell);
    if (!(room.lo == box.lo && room.hi == box.hi)) return look(cell, room, ends_inside);
    const auto [at, is_new] = known_[ends_inside].try_emplace(cell);
    if (is_new) at->second = look(cell, room, ends_inside);
    return at->second;
  }

 private:
  std::optional<ThinFeature> look(std::int32_t cell, const Box3& room, bool ends_inside) const {
    const Probe probe{field_, cells_.candidates(cell), 0};
    const std::optional<Vec3> p = find_hidden(probe, room, ends_inside, depth_);
    if (!p) return {};
    return measured(probe, room, *p);
  }

  const ExactField& field_;
  const SurfaceCells& cells_;
  double depth_;                                                           ///< mm
  std::unordered_map<std::int32_t, std::optional<ThinFeature>> known_[2];  ///< by side and cell
};

}  // namespace

std::vector<FoundThin> thin_features(const ExactField& field, const SurfaceCells& cells,
                                     std::span<const MinimalEdge> doubtful) {
  std::vector<FoundThin> out;
  HiddenInCells hidden(field, cells);
  for (const MinimalEdge& e : doubtful) {
    const EdgeEnds ends = cells.ends(e);
    const Probe probe{field, cells.candidates(e.cells[0]), 0};
    const EdgeEnd a = sampled(probe, ends.low), b = sampled(probe, high_end(ends, e.axis));
    if (const std::optional<Passage> found = find_passage(probe, a, b, e.low_inside))
      out.push_back(feature_of(cells, e, a, b, *found, !e.low_inside));
    else if (const auto feature = first_hidden(cells, e, [&](std::int32_t cell, const Box3& room) {
               return hidden.find(cell, room, e.low_inside);
             }))
      out.push_back({*feature, block_of(cells, e)});
  }
  return out;
}

std::vector<FoundThin> lost_features(const ExactField& field, const SurfaceCells& cells,
                                     std::span<const MinimalEdge> doubtful, const TriMesh& mesh,
                                     double tolerance, double thinnest, int threads) {
  if (doubtful.empty()) return {};
  if (mesh.triangles.empty()) return thin_features(field, cells, doubtful);
  const LostSearch search(field, cells, mesh, tolerance, thinnest);
  std::vector<std::optional<FoundThin>> lost(doubtful.size());
  parallel_for(
      doubtful.size(), threads, [&](std::size_t k) { lost[k] = search.on_edge(doubtful[k]); }, 16);
  std::vector<FoundThin> out;
  for (const std::optional<FoundThin>& f : lost)
    if (f) out.push_back(*f);
  return out;
}

std::vector<FoundThin> one_of_each(std::span<const FoundThin> found) {
  std::vector<FoundThin> out;
  std::set<std::tuple<std::int32_t, std::int32_t, std::uint64_t>> known;
  for (const FoundThin& f : found)
    if (known.emplace(f.feature.owner[0], f.feature.owner[1], f.block).second) out.push_back(f);
  return out;
}

std::vector<ThinFeature> distinct(std::span<const FoundThin> found) {
  std::vector<ThinFeature> out;
  for (const FoundThin& f : one_of_each(found)) out.push_back(f.feature);
  return out;
}

}  // namespace mrsim::detail
