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
  Radius radius_at(const SurfacePlace& place, double leaves, double enough);
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

// Bounds of the largest radius at one place. Ends as soon as it is known to be `enough`.
ReachSearch::Radius ReachSearch::radius_at(const SurfacePlace& place, double leaves,
                                           double enough) {
  const Vec3 root = center_over(place.point, leaves);
  double found = 0;
  const auto try_center = [&](const Vec3& c, double d) {
    if (distance(c, root) > d + leaves || d <= found) return;
    found = d;
    if (d < enough - gap()) return;
    if (centers_.size() == kRemembered) centers_.erase(centers_.begin());
    centers_.push_back(c);
  };
  Vec3 out = place.normal;
  if (is_flat_) out = normalized(Vec3{out.x, out.y, 0});
  for (double far = enough; far > leaves && found < enough - gap(); far /= 2) {
    const Vec3 c = root + far * out;
    try_center(c, free_(c).distance);
    if (found > far / 2) break;
  }
  const std::vector<Vec3> known = centers_;
  for (Vec3 c : known) {
    if (is_flat_) c.z = root.z;
    if (distance(c, root) <= enough + leaves) try_center(c, free_(c).distance);
    if (found >= enough - gap()) return {found, enough};
  }
  std::vector<Box> heap{{root, task_.most + leaves, task_.most}};
  for (std::size_t boxes = 0; !heap.empty(); ++boxes) {
    std::pop_heap(heap.begin(), heap.end());
    const Box box = heap.back();
    heap.pop_back();
    if (box.bound <= found + gap() || found >= enough - gap() || boxes > kMostBoxes)
      return {found, std::max(box.bound, found + gap())};
    const double half = box.half / 2;
    for (int k = 0; k < (is_flat_ ? 4 : 8); ++k) {
      const Vec3 c = box.center + half * Vec3{k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0,
                                              is_flat_ ? 0.0
                                              : k & 4  ? 1.0
                                                       : -1.0};
      const double r = reach(half);
      if (distance(c, root) - r > box.bound + leaves) continue;
      const Room room = free_(c);
      const double bound = std::min(room.distance + r, box.bound);
      try_center(c, room.distance);
      if (bound <= found + gap() || !comes_near(root, c, r, room, leaves)) continue;
      heap.push_back({c, half, bound});
      std::push_heap(heap.begin(), heap.end());
    }
  }
  return {found, found + gap()};
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
