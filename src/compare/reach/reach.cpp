#include "compare/reach/reach.h"

#include "core/numbers/vec.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace mrsim {
namespace {

constexpr std::size_t kMostBoxes = 200000;  // of one place
constexpr std::size_t kRemembered = 16;     // centres of tools that came to other places
// An edge: what leaves half as much is smaller by more than this.
constexpr double kEdge = 0.75;

// D, at most `most`, and the solid's point that is as near.
struct Room {
  double distance = 0;
  Vec3 point;
};
using Free = std::function<Room(const Vec3& center)>;

class ReachSearch {
 public:
  ReachSearch(Free free, bool is_flat, const ReachTask& task)
      : free_(std::move(free)), task_(task), is_flat_(is_flat) {}

  Reach run(std::span<const SurfacePlace> places);

 private:
  // A cube, or a square in plan, of centres.
  struct Box {
    Vec3 center;
    double half = 0, bound = 0;  // of D in it
    bool operator<(const Box& o) const { return bound < o.bound; }
  };
  struct Radius {
    double least = 0, most = 0;
  };
  // The best tool that comes to one place, as far as it has been searched.
  struct Best {
    Vec3 root;  // that tools are tried about: center_over() of the place
    double leaves = 0, enough = 0;
    double radius = 0;
  };
  Radius radius_at(const SurfacePlace& place, double leaves, double enough);
  bool is_enough(const Best& best) const { return best.radius >= best.enough - gap(); }
  void try_center(Best& best, const Vec3& center, double room);
  void try_outwards(Best& best, Vec3 normal);
  bool try_known_centers(Best& best);
  Radius search_boxes(Best& best);
  Vec3 center_over(const Vec3& place, double leaves) const {
    return is_flat_ ? place + Vec3{0, 0, leaves} : place;
  }
  double gap() const { return task_.error / 2; }  // of a radius: least to most
  double reach(double half) const { return half * std::sqrt(is_flat_ ? 2.0 : 3.0); }
  bool comes_near(const Vec3& place, const Vec3& center, double r, const Room& room,
                  double leaves) const;

  Free free_;
  ReachTask task_;
  bool is_flat_;
  std::vector<Vec3> centers_;  // of tools found, the last ones
};

// Whether |c - place| <= D(c) + leaves may hold within r of the centre. With q the solid's nearest
// point D(c) <= |c - q|, and |c - place| - |c - q| changes by at most 2 |place - q| / (|c - place|
// + |c - q|) a millimetre.
bool ReachSearch::comes_near(const Vec3& place, const Vec3& center, double r, const Room& room,
                             double leaves) const {
  const double away = distance(center, place);
  if (away - r > std::min(room.distance + r, task_.most) + leaves) return false;
  if (room.distance >= task_.most) return true;
  const double other = distance(center, room.point), both = away + other - 2 * r;
  const double change = both > 0 ? std::min(2 * distance(place, room.point) / both, 2.0) : 2;
  return away - other - r * change <= leaves;
}

// `room`: D of the centre.
void ReachSearch::try_center(Best& best, const Vec3& center, double room) {
  if (distance(center, best.root) > room + best.leaves || room <= best.radius) return;
  best.radius = room;
  if (!is_enough(best)) return;
  if (centers_.size() == kRemembered) centers_.erase(centers_.begin());
  centers_.push_back(center);
}

// Tools that touch the place, from the largest on.
void ReachSearch::try_outwards(Best& best, Vec3 normal) {
  if (is_flat_) normal = normalized(Vec3{normal.x, normal.y, 0});
  for (double far = best.enough; far > best.leaves && !is_enough(best); far /= 2) {
    const Vec3 center = best.root + far * normal;
    try_center(best, center, free_(center).distance);
    if (best.radius > far / 2) break;
  }
}

// Tools that came to other places, until one is enough.
bool ReachSearch::try_known_centers(Best& best) {
  const std::vector<Vec3> known = centers_;
  for (Vec3 center : known) {
    if (is_flat_) center.z = best.root.z;
    if (distance(center, best.root) <= best.enough + best.leaves)
      try_center(best, center, free_(center).distance);
    if (is_enough(best)) return true;
  }
  return false;
}

// Branch and bound over all centres that may come to the place.
ReachSearch::Radius ReachSearch::search_boxes(Best& best) {
  std::vector<Box> heap{{best.root, task_.most + best.leaves, task_.most}};
  for (std::size_t boxes = 0; !heap.empty(); ++boxes) {
    std::pop_heap(heap.begin(), heap.end());
    const Box box = heap.back();
    heap.pop_back();
    if (box.bound <= best.radius + gap() || is_enough(best) || boxes > kMostBoxes)
      return {best.radius, std::max(box.bound, best.radius + gap())};
    const double half = box.half / 2;
    for (int k = 0; k < (is_flat_ ? 4 : 8); ++k) {
      const Vec3 c = box.center + half * Vec3{k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0,
                                              is_flat_ ? 0.0
                                              : k & 4  ? 1.0
                                                       : -1.0};
      const double r = reach(half);
      if (distance(c, best.root) - r > box.bound + best.leaves) continue;
      const Room room = free_(c);
      const double bound = std::min(room.distance + r, box.bound);
      try_center(best, c, room.distance);
      if (bound <= best.radius + gap() || !comes_near(best.root, c, r, room, best.leaves)) continue;
      heap.push_back({c, half, bound});
      std::push_heap(heap.begin(), heap.end());
    }
  }
  return {best.radius, best.radius + gap()};
}

// Bounds of the largest radius at one place. Ends as soon as it is known to be `enough`.
ReachSearch::Radius ReachSearch::radius_at(const SurfacePlace& place, double leaves,
                                           double enough) {
  Best best{center_over(place.point, leaves), leaves, enough};
  try_outwards(best, place.normal);
  if (try_known_centers(best)) return {best.radius, enough};
  return search_boxes(best);
}

Reach ReachSearch::run(std::span<const SurfacePlace> places) {
  Radius all{task_.most, task_.most};
  const SurfacePlace* decides = nullptr;
  for (const SurfacePlace& place : places) {
    const Radius one = radius_at(place, task_.leaves, all.least);
    if (one.least >= all.least - gap()) continue;
    all = {one.least, std::min(one.most, all.most)};
    decides = &place;
  }
  // A place that was left out may have a radius that is less by the gap.
  Reach out{all.least + all.most - gap(), all.most - all.least + gap(), decides == nullptr, false};
  if (out.is_least) return out;
  const double half = radius_at(*decides, task_.leaves / 2, all.least).least;
  out.is_most = half < kEdge * all.least;
  return out;
}

}  // namespace

Reach largest_ball(const NominalSurface& solid, std::span<const SurfacePlace> places,
                   const ReachTask& task) {
  std::uint32_t hint = 0;
  const auto free = [&](const Vec3& c) {
    const TriangleTree::Hit near = solid.tree().nearest(c, hint);
    hint = near.triangle;
    return Room{std::clamp(solid.signed_hit(c, near).distance, 0.0, task.most), near.point};
  };
  return ReachSearch(free, false, task).run(places);
}

Reach largest_flat(const NominalSurface& solid, std::span<const SurfacePlace> places,
                   const ReachTask& task) {
  const auto free = [&](const Vec3& c) {
    const TrianglePoint near = solid.tree().nearest_in_plan(c, task.most);
    return Room{std::min(std::sqrt(near.distance2), task.most), {near.point.x, near.point.y, c.z}};
  };
  return ReachSearch(free, true, task).run(places);
}

std::vector<SurfacePlace> surface_places(const NominalSurface& solid,
                                         std::span<const Vec3> points) {
  const TriangleTree& tree = solid.tree();
  std::vector<SurfacePlace> places;
  std::uint32_t hint = 0;
  for (const Vec3& p : points) {
    const TriangleTree::Hit hit = tree.nearest(p, hint);
    hint = hit.triangle;
    places.push_back({hit.point, normalized(tree.pseudonormal(hit))});
  }
  return places;
}

}  // namespace mrsim
