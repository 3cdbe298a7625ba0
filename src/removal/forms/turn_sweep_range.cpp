// Enclosures of the faces that an insert turns: functions of (rho, z), rho convex in space.
#include "removal/field/face_range.h"
#include "removal/forms/turn_sweep.h"
#include "removal/simd/scalar_forms.h"

#include <algorithm>

namespace mrsim {
namespace {

using Side = ConvexPolygon::Side;

bool all_of(const Section& s, auto holds) {
  return std::all_of(s.hull.begin(), s.hull.end(), holds);
}

FaceRange side_range(const Side& side, const Section& s, double round) {
  const double across = right_of(side.direction).x;
  const FaceRange plane = range_of({side_of(side, s.at[0]) - round, side_of(side, s.at[1]) - round,
                                    side_of(side, s.at[2]) - round});
  return widened(plane, s, {across, across});
}

// Within one side's strip, outside of it, the polygon is that side.
bool is_beside(const Side& side, const Section& s) {
  return all_of(s, [&](Vec2 q) {
    const double along = dot(side.direction, q - side.a);
    return along >= -kBorder && along <= side.length + kBorder && side_of(side, q) >= 0;
  });
}

FaceRange polygon_range(const TurnSweep& sweep, const Section& s) {
  const ConvexPolygon& polygon = sweep.polygon;
  if (!polygon.sides.empty()) {
    const Side& side = polygon.sides[static_cast<std::size_t>(polygon_side(polygon, s.at[0]))];
    if (is_beside(side, s)) return side_range(side, s, sweep.round);
  }
  return convex_section_range(
      s, sweep.round, [&](Vec2 q) { return polygon_distance(polygon, q) - sweep.round; },
      [&](Vec2 q) { return polygon_gradient(polygon, q); });
}

// An insert's side at rest, its ends rounded by the nose.
FaceRange rest_range(const Side& side, const Section& s, double round) {
  if (round == 0 || is_beside(side, s)) return side_range(side, s, round);
  if (!all_of(s, [&](Vec2 q) { return side_of(side, q) > 0; })) return {};
  return convex_section_range(
      s, round, [&](Vec2 q) { return side_distance(side, q) - round; },
      [&](Vec2 q) {
        const Vec2 off = q - foot_on(side, q);
        return (1 / length(off)) * off;
      });
}

FaceRange circle_range(Vec2 center, double radius, const Section& s) {
  return convex_section_range(
      s, radius, [&](Vec2 q) { return length(q - center) - radius; },
      [&](Vec2 q) {
        const double n = length(q - center);
        return n > 0 ? (1 / n) * (q - center) : Vec2{};
      });
}

double least_distance(Vec2 from, const Section& s) {
  const Vec2 m = weighted(smallest_circle(s.at), s.at) - from;
  const double n = length(m);
  double least = n;
  for (const Vec2& q : s.hull)
    if (n > 0) least = std::min(least, dot(q - from, m) / n);
  return n > 0 ? least : 0;
}

// A function with second derivatives up to 1 / closest.
FaceRange bent_range(const Section& s, const std::array<double, 3>& values, double closest) {
  const double strays = 0.5 * smallest_circle(s.at).squared / closest;
  const FaceRange corners = range_of(values);
  return widened({corners.lo - strays, corners.hi + strays}, s, {});
}

// The arc that a corner draws, which ends in the nose's circle about its end.
FaceRange arc_range(const CircularArc& a, const Section& s, double round) {
  const double c[] = {a.center.x, a.center.y, a.radius,  a.middle.x,
                      a.middle.y, a.cos_half, a.sin_half};
  const double nearest = least_distance(a.center, s);
  const bool outside = nearest >= a.radius;
  const bool inside = all_of(s, [&](Vec2 q) { return length(q - a.center) <= a.radius; });
  if (a.way == 0 && !outside && !inside) return {};
  const bool out = a.way > 0 || (a.way == 0 && outside);
  std::array<Vec2, 6> w;
  for (std::size_t k = 0; k < w.size(); ++k) w[k] = s.hull[k] - a.center;
  const ArcView view = round > 0 ? arc_view(c, w) : ArcView{ArcView::Part::arc, 0};
  const Vec2 end = a.center + arc_end(c, view.side);
  const auto offset = [](FaceRange r, double by) { return FaceRange{r.lo - by, r.hi - by}; };
  if (view.part == ArcView::Part::unknown) return {};
  if (view.part == ArcView::Part::end) return offset(circle_range(end, 0, s), round);
  if (view.part == ArcView::Part::arc) {
    const FaceRange circle = circle_range(a.center, a.radius, s);
    return offset(out ? circle : negated(circle), round);
  }
  const double closest = std::min(nearest, least_distance(end, s));
  if (!(out ? outside : inside) || !(closest > 0)) return {};
  std::array<double, 3> to_arc;
  for (std::size_t k = 0; k < 3; ++k) to_arc[k] = lane::arc_rho(c, s.at[k].x, s.at[k].y) - round;
  return bent_range(s, to_arc, closest);
}

}  // namespace

FaceRange turn_face_range(const TurnSweep& s, const Corners3& t, std::int32_t patch) {
  const bool mirrored = patch >= kMirrorPatch;
  const auto index = static_cast<std::size_t>(mirrored ? patch - kMirrorPatch : patch);
  Envelope rho = length_envelope({Vec2{t[0].x, t[0].y}, {t[1].x, t[1].y}, {t[2].x, t[2].y}});
  if (mirrored) {
    for (std::array<double, 3>* v : {&rho.at, &rho.low, &rho.high})
      for (double& x : *v) x = -x;
    std::swap(rho.low, rho.high);
  }
  const Section section = section_of(rho, {t[0].z, t[1].z, t[2].z});
  if (!s.arc) {
    const bool sharp = s.round == 0 && index < s.polygon.sides.size();
    return sharp ? side_range(s.polygon.sides[index], section, 0) : polygon_range(s, section);
  }
  if (index >= s.arcs.size()) return rest_range(s.sides[index - s.arcs.size()], section, s.round);
  return arc_range(s.arcs[index], section, s.round);
}

}  // namespace mrsim
