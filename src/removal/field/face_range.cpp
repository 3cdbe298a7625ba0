#include "removal/field/face_range.h"

#include "removal/field/record_slots.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

double squared(Vec2 a) { return dot(a, a); }
double squared(const Vec3& a) { return dot(a, a); }

Vec2 in_plan(const Vec3& p, const double* c) {
  return {p.x - c[LineSlot::x], p.y - c[LineSlot::y]};
}

// The envelope of a function that has these values at the corners and differs from their linear
// interpolation by up to `strays`, mm.
Envelope bent_envelope(const std::array<double, 3>& at, double strays) {
  Envelope e{at, at, at, true};
  for (int k = 0; k < 3; ++k) e.low[k] -= strays, e.high[k] += strays;
  return e;
}

double least(const std::array<double, 3>& v) { return std::min({v[0], v[1], v[2]}); }
double most(const std::array<double, 3>& v) { return std::max({v[0], v[1], v[2]}); }

}  // namespace

SmallestCircle smallest_circle(double a, double b, double c) {
  const double most = std::max({a, b, c});
  if (a + b + c <= 2 * most) {  // right or obtuse: about the longest side
    const double half = 0.5;
    if (most == a) return {{0, half, half}, 0.25 * a};
    if (most == b) return {{half, 0, half}, 0.25 * b};
    return {{half, half, 0}, 0.25 * c};
  }
  const double wa = a * (b + c - a), wb = b * (c + a - b), wc = c * (a + b - c);
  const double sum = wa + wb + wc;  // 16 times the square of the area
  return {{wa / sum, wb / sum, wc / sum}, a * b * c / sum};
}

SmallestCircle smallest_circle(const Corners3& t) {
  return smallest_circle(squared(t[2] - t[1]), squared(t[0] - t[2]), squared(t[1] - t[0]));
}

SmallestCircle smallest_circle(const Corners2& t) {
  return smallest_circle(squared(t[2] - t[1]), squared(t[0] - t[2]), squared(t[1] - t[0]));
}

FaceRange range_of(const std::array<double, 3>& linear) { return {least(linear), most(linear)}; }

ArcView arc_view(const double* c, std::span<const Vec2> w) {
  const double cosine = c[ArcSlot::cosine], sine = c[ArcSlot::sine];
  if (sine == 0 && cosine < 0) return {ArcView::Part::arc, 0};
  bool left = true, right = true, under_left = true, under_right = true, beyond_left = true,
       beyond_right = true;
  for (const Vec2& q : w) {
    const double along = q.x * c[ArcSlot::mx] + q.y * c[ArcSlot::my],
                 off = c[ArcSlot::mx] * q.y - c[ArcSlot::my] * q.x;
    const double past_left = cosine * off - sine * along, past_right = -cosine * off - sine * along;
    left = left && off >= 0, right = right && off <= 0;
    under_left = under_left && past_left <= kBorder;
    under_right = under_right && past_right <= kBorder;
    beyond_left = beyond_left && past_left >= -kBorder;
    beyond_right = beyond_right && past_right >= -kBorder;
  }
  if (cosine >= 0 ? under_left && under_right : under_left || under_right)
    return {ArcView::Part::arc, 0};
  if (left) return {beyond_left ? ArcView::Part::end : ArcView::Part::both, 1};
  if (right) return {beyond_right ? ArcView::Part::end : ArcView::Part::both, -1};
  return {};
}

Vec2 arc_end(const double* c, int side) {
  const double a = c[ArcSlot::radius] * c[ArcSlot::cosine],
               b = side * c[ArcSlot::radius] * c[ArcSlot::sine];
  return {a * c[ArcSlot::mx] - b * c[ArcSlot::my], a * c[ArcSlot::my] + b * c[ArcSlot::mx]};
}

Envelope length_envelope(const Corners2& w) {
  Envelope e;
  e.is_known = true;
  const Vec2 m = weighted(smallest_circle(w), w);
  const double n = length(m);
  const Vec2 u = n > 0 ? (1 / n) * m : Vec2{};
  for (int k = 0; k < 3; ++k) e.at[k] = e.high[k] = length(w[k]), e.low[k] = dot(w[k], u);
  return e;
}

Envelope line_envelope(const double* c, const Corners3& t) {
  const Vec2 way{c[LineSlot::dx], c[LineSlot::dy]};
  const double size = dot(way, way), border = kBorder * std::sqrt(size);
  Corners2 w;
  bool between = true, left = true, right = true;
  for (int k = 0; k < 3; ++k) {
    w[k] = in_plan(t[k], c);
    const double along = dot(w[k], way), off = cross(way, w[k]);
    between = between && along >= -border && along <= size + border;
    left = left && off >= 0, right = right && off <= 0;
  }
  const auto foot = [&](Vec2 q) {
    const double along = size > 0 ? dot(q, way) / size : 0;
    return (along < 0 ? 0 : along > 1 ? 1 : along) * way;
  };
  Envelope e;
  e.is_known = true;
  for (int k = 0; k < 3; ++k) e.at[k] = e.high[k] = length(w[k] - foot(w[k]));
  e.low = e.at;
  if (between && (left || right) && size > 0) return e;  // beside a straight edge: affine
  const Vec2 m = weighted(smallest_circle(w), w), off = m - foot(m);
  const double n = length(off);
  const Vec2 u = n > 0 ? (1 / n) * off : Vec2{};
  for (int k = 0; k < 3; ++k) e.low[k] = n + dot(w[k] - m, u);
  return e;
}

Envelope arc_envelope(const double* c, const Corners3& t, bool is_signed, int side) {
  const Corners2 w{in_plan(t[0], c), in_plan(t[1], c), in_plan(t[2], c)};
  const ArcView view = arc_view(c, w);
  if (view.part == ArcView::Part::unknown) return {};
  if (view.part != ArcView::Part::arc && side != 0 && view.side != side) return {};
  const Vec2 end = arc_end(c, view.side);
  const Corners2 from_end{w[0] - end, w[1] - end, w[2] - end};
  if (view.part == ArcView::Part::end) return length_envelope(from_end);
  Envelope e = length_envelope(w);
  const double radius = c[ArcSlot::radius], nearest = least(e.low);
  const bool outside = nearest >= radius, inside = most(e.high) <= radius;
  if (view.part == ArcView::Part::arc) {
    if (!is_signed && !outside && !inside) return {};
    const bool turned = !is_signed && inside;
    for (std::array<double, 3>* v : {&e.at, &e.low, &e.high})
      for (double& x : *v) x = turned ? radius - x : x - radius;
    if (turned) std::swap(e.low, e.high);
    return e;
  }
  const Envelope to_end = length_envelope(from_end);
  const double closest = std::min(nearest, least(to_end.low));
  if (!(outside || inside) || !(closest > 0)) return {};
  for (int k = 0; k < 3; ++k) {
    const double off = e.at[k] - radius;
    e.at[k] = arc_view(c, {&w[k], 1}).part == ArcView::Part::arc ? std::fabs(off) : to_end.at[k];
  }
  return bent_envelope(e.at, 0.5 * smallest_circle(w).squared / closest);
}

Section section_of(const Envelope& v, const std::array<double, 3>& y) {
  Section s;
  for (int k = 0; k < 3; ++k) {
    s.at[k] = {v.at[k], y[k]};
    s.hull[k] = {v.low[k], y[k]}, s.hull[k + 3] = {v.high[k], y[k]};
    s.below = std::max(s.below, v.at[k] - v.low[k]);
    s.above = std::max(s.above, v.high[k] - v.at[k]);
  }
  return s;
}

FaceRange widened(const FaceRange& plane, const Section& s, const Slopes& slopes) {
  const double up = std::max(slopes.hi, 0.0), down = std::max(-slopes.lo, 0.0);
  return {plane.lo - s.below * up - s.above * down, plane.hi + s.above * up + s.below * down};
}

Slopes slopes_about(const Section& s, Vec2 centre, Vec2 slope, double bend) {
  double farthest = 0;
  for (const Vec2& q : s.hull) farthest = std::max(farthest, squared(q - centre));
  const double change = bend * std::sqrt(farthest);
  if (!(change < 2)) return {};
  return {std::max(-1.0, slope.x - change), std::min(1.0, slope.x + change)};
}

}  // namespace mrsim
