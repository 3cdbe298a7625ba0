// A place is where the tip was in plan, no higher than the rapid. The cutter's slice at any height
// is a disc of radius r, at least that of its flat end, and the slice that a place has cleared at
// that height is no smaller. With w from a position on the rapid to a place, the place leaves no
// more than the touch t of the points of the disc in direction u where
//     |r u - w| <= r + t, so where u.w >= |w|^2 / (2 r) - t:
// a sector of directions about w, narrowest for the smallest r. |r u - w| is convex along a
// straight rapid, so what a place covers at both ends of a piece, it covers all along. Where the
// sectors of all places make up the circle, the piece is clear. Of a ball, u is a direction in
// space: a place with |w|^2 <= 2 r t covers those below the middle as it does those in plan.
#include "removal/collision/recent_places.h"

#include "core/numbers/motions.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "removal/collision/collision_movers.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mrsim {
namespace {

constexpr std::size_t kMotionsBack = 256;  ///< motions back
constexpr int kMostHalvings = 8;           ///< of a rapid
constexpr double kAngleError = 1e-9;       ///< rad

// The directions in plan within `half` of `middle`, rad. From half = pi on these are all
// directions.
struct Sector {
  double middle = 0, half = 0;
};

// The same angle in (-pi, pi].
double wrapped(double angle) {
  while (angle > kPi) angle -= kTwoPi;
  while (angle <= -kPi) angle += kTwoPi;
  return angle;
}

// The directions that both have. Where they overlap at both ends, one of the two overlaps.
Sector common(const Sector& a, const Sector& b) {
  if (a.half >= kPi) return b;
  if (b.half >= kPi) return a;
  const double apart = wrapped(b.middle - a.middle);
  const double low = std::max(-a.half, apart - b.half), high = std::min(a.half, apart + b.half);
  return {wrapped(a.middle + 0.5 * (low + high)), 0.5 * (high - low)};
}

bool make_up_circle(std::vector<Sector>& sectors) {
  std::sort(sectors.begin(), sectors.end(),
            [](const Sector& a, const Sector& b) { return a.middle - a.half < b.middle - b.half; });
  if (sectors.empty()) return false;
  const double begin = sectors.front().middle - sectors.front().half;
  double reached = begin;
  for (const Sector& s : sectors) {
    if (s.middle - s.half > reached) return false;
    reached = std::max(reached, s.middle + s.half);
  }
  return reached >= begin + kTwoPi;
}

class RecentPlaces {
 public:
  RecentPlaces(const Profile& cutter, double touch)
      : touch_(touch),
        radius_(cutter.core() > 0 ? cutter.core() : cutter.round()),
        farthest_(cutter.core() > 0 ? radius_ : std::min(radius_, std::sqrt(2 * radius_ * touch))) {
  }

  void add_cut(const Motion& cut, const Motion& rapid);
  bool cover(const Vec3& a, const Vec3& b, int halvings);

 private:
  bool cover_piece(const Vec3& a, const Vec3& b);
  void add_places(const Motion& cut, const Vec3& p, double z, const Vec3& a, const Vec3& b);
  void add_place(const Vec3& place, double z, const Vec3& a, const Vec3& b);
  Sector sector(double x, double y) const;

  double touch_;
  double radius_;    // of the smallest slice
  double farthest_;  // mm: places beyond this cover nothing
  std::vector<const Motion*> cuts_;
  std::vector<Sector> sectors_;
};

Box3 box_of(const Motion& m) { return {min(m.start, m.end), max(m.start, m.end)}; }

void RecentPlaces::add_cut(const Motion& cut, const Motion& rapid) {
  const double bend = cut.kind == MotionKind::arc ? 2 * cut.radius : 0;
  const Box3 along = box_of(cut), way = box_of(rapid);
  const auto apart = [&](int axis) {
    return std::max(component(way.lo, axis) - component(along.hi, axis),
                    component(along.lo, axis) - component(way.hi, axis)) > farthest_ + bend;
  };
  if (!apart(0) && !apart(1)) cuts_.push_back(&cut);
}

// Empty (half <= 0) where the place covers nothing.
Sector RecentPlaces::sector(double x, double y) const {
  const double size = std::sqrt(x * x + y * y);
  if (size > farthest_) return {};
  const double least = size * size / (2 * radius_) - touch_;
  if (least <= -size) return {0, kPi};
  if (least >= size) return {};
  return {mrsim::atan2(y, x),
          mrsim::atan2(std::sqrt(size * size - least * least), least) - kAngleError};
}

void RecentPlaces::add_place(const Vec3& place, double z, const Vec3& a, const Vec3& b) {
  if (place.z > z + kSameTip) return;
  const Sector at_a = sector(place.x - a.x, place.y - a.y);
  const Sector at_b = sector(place.x - b.x, place.y - b.y);
  if (at_a.half <= 0 || at_b.half <= 0) return;
  const Sector both = common(at_a, at_b);
  if (both.half > 0) sectors_.push_back(both);
}

// The place of the cut that is nearest to p in plan, of a helix in its first turn.
void RecentPlaces::add_places(const Motion& cut, const Vec3& p, double z, const Vec3& a,
                              const Vec3& b) {
  if (cut.kind != MotionKind::arc) {
    const Vec3 travel = cut.end - cut.start, w = p - cut.start;
    const double size = travel.x * travel.x + travel.y * travel.y;
    const double along = size > 0 ? (w.x * travel.x + w.y * travel.y) / size : 0;
    return add_place(cut.start + std::clamp(along, 0.0, 1.0) * travel, z, a, b);
  }
  if (cut.axis.z != 1) return;
  const Vec3 from = cut.start - cut.center, w = p - cut.center;
  const double size = std::sqrt(w.x * w.x + w.y * w.y);
  if (size == 0 || cut.sweep == 0) return;
  const double side = cut.sweep > 0 ? 1 : -1;
  double turn = side * (mrsim::atan2(w.y, w.x) - mrsim::atan2(from.y, from.x));
  while (turn < 0) turn += kTwoPi;
  while (turn >= kTwoPi) turn -= kTwoPi;
  if (turn > std::fabs(cut.sweep)) return;
  const double height = cut.start.z + cut.rise * turn / std::fabs(cut.sweep);
  add_place(
      {cut.center.x + cut.radius * w.x / size, cut.center.y + cut.radius * w.y / size, height}, z,
      a, b);
}

bool RecentPlaces::cover_piece(const Vec3& a, const Vec3& b) {
  sectors_.clear();
  const double z = std::min(a.z, b.z);
  for (const Motion* cut : cuts_) {
    for (const Vec3& p : {a, 0.5 * (a + b), b}) add_places(*cut, p, z, a, b);
    for (const Vec3& end : {cut->start, cut->end}) add_place(end, z, a, b);
  }
  const auto is_whole = [](const Sector& s) { return s.half >= kPi; };
  return std::any_of(sectors_.begin(), sectors_.end(), is_whole) || make_up_circle(sectors_);
}

bool RecentPlaces::cover(const Vec3& a, const Vec3& b, int halvings) {
  if (cover_piece(a, b)) return true;
  if (halvings == 0) return false;
  const Vec3 middle = 0.5 * (a + b);
  return cover(a, middle, halvings - 1) && cover(middle, b, halvings - 1);
}

}  // namespace

bool keeps_to_recent_places(std::span<const Motion> motions, std::size_t at, const Profile& cutter,
                            double stock_top, double touch) {
  const Motion& rapid = motions[at];
  if (!cutter.is_end_mill() || rapid.tool_axis.z != 1) return false;
  RecentPlaces places(cutter, touch);
  for (std::size_t back = 1; back <= std::min(kMotionsBack, at); ++back) {
    const Motion& m = motions[at - back];
    if (m.tool != rapid.tool || !(m.tool_axis == rapid.tool_axis)) break;
    if (!is_cut(m) || !moves(m)) continue;
    const double lowest = std::min(m.start.z, m.end.z);
    if (!cutter.open_top() && lowest + cutter.top() < stock_top) continue;
    places.add_cut(m, rapid);
  }
  return places.cover(rapid.start, rapid.end, kMostHalvings);
}

}  // namespace mrsim
