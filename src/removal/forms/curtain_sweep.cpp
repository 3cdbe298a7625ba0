// The curtain is {left <= x <= right, y >= low(x)}, low(x) the lowest point of the arc at x. From
// outside, the nearest point lies on the arc or on one of the two upright edges, which all belong
// to the curtain, so the least of the three distances is exact.
#include "removal/forms/curtain_sweep.h"

#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "removal/field/face_range.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr double kHorizontalEnd =
    1e-9;  // of the radius: rounding of ends at the height of the centre

bool on_arc(const Curtain& c, double x, double y) {
  const double along = x * c.mid_x + y * c.mid_y, off = c.mid_x * y - c.mid_y * x;
  return c.cos_half * (off < 0 ? -off : off) - c.sin_half * along <= 0;
}

Vec2 curtain_end(const Curtain& c, double side) {
  const double a = c.radius * c.cos_half, b = side * c.radius * c.sin_half;
  return {a * c.mid_x - b * c.mid_y, a * c.mid_y + b * c.mid_x};
}

Vec2 nearest_on_arc(const Curtain& c, Vec2 q) {
  const double n = length(q);
  if (on_arc(c, q.x, q.y))
    return n > 0 ? (c.radius / n) * q : Vec2{c.radius * c.mid_x, c.radius * c.mid_y};
  return curtain_end(c, c.mid_x * q.y - c.mid_y * q.x < 0 ? -1 : 1);
}

bool is_above(const Curtain& c, Vec2 q) {
  if (q.x < c.left || q.x > c.right) return false;
  const double rest = c.radius * c.radius - q.x * q.x;
  const double high = rest > 0 ? std::sqrt(rest) : 0;
  if (on_arc(c, q.x, -high)) return q.y >= -high;
  // Between two ends of one x neither may count by a rounding; the higher one then bounds below.
  return q.y >= high;
}

void add_hem(Curtain& c, Vec2 p) {
  c.left = p.x < c.left ? p.x : c.left;
  c.right = p.x > c.right ? p.x : c.right;
  c.hems[c.hem_count++] = p;
}

struct Local {
  Vec2 q;             // in the plane
  double beside = 0;  // across it
};

Local local(const BallArc& s, const Vec3& p) {
  const Vec3 w = p - s.center;
  return {{w.x * s.along_x + w.y * s.along_y, w.z}, w.y * s.along_x - w.x * s.along_y};
}

}  // namespace

Curtain make_curtain(double radius, double from, double turn) {
  Curtain c;
  c.radius = radius;
  const SinCos mid = sincos(from + turn / 2), half = sincos(turn / 2);
  c.mid_x = mid.cos, c.mid_y = mid.sin;
  if (turn < kTwoPi) c.cos_half = half.cos, c.sin_half = half.sin;
  const Vec2 first = curtain_end(c, -1);
  c.left = c.right = first.x;
  add_hem(c, first);
  add_hem(c, curtain_end(c, 1));
  if (on_arc(c, -radius, 0)) add_hem(c, {-radius, 0});
  if (on_arc(c, radius, 0)) add_hem(c, {radius, 0});
  return c;
}

bool overhangs(const Curtain& c) {
  for (double side : {-1.0, 1.0}) {
    const Vec2 end = curtain_end(c, side);
    if (end.y < 0 && on_arc(c, end.x, -end.y)) return true;
  }
  return false;
}

CurtainFoot curtain_foot(const Curtain& c, Vec2 q) {
  if (is_above(c, q)) return {0, q};
  const auto to = [q](Vec2 v) { return CurtainFoot{dot(q - v, q - v), v}; };
  CurtainFoot best = to(nearest_on_arc(c, q));
  for (int i = 0; i < c.hem_count; ++i) {
    const Vec2 hem = c.hems[i];
    const CurtainFoot edge = to({hem.x, q.y > hem.y ? q.y : hem.y});
    if (edge.squared < best.squared) best = edge;
  }
  return best;
}

double ball_arc_distance(const BallArc& s, const Curtain& part, const Vec3& p) {
  const Local l = local(s, p);
  return std::sqrt(l.beside * l.beside + curtain_foot(part, l.q).squared) - s.ball;
}

Vec3 ball_arc_gradient(const BallArc& s, const Curtain& part, const Vec3& p) {
  const Local l = local(s, p);
  const Vec2 off = l.q - curtain_foot(part, l.q).point;
  const double n = std::sqrt(l.beside * l.beside + dot(off, off));
  const Vec3 across = {-s.along_y, s.along_x, 0};
  if (n == 0) return across;
  return (l.beside / n) * across + Vec3{off.x / n * s.along_x, off.x / n * s.along_y, off.y / n};
}

BallArcFoot ball_arc_foot(const BallArc& s, const Curtain& part, const Vec3& p) {
  const Local l = local(s, p);
  const CurtainFoot f = curtain_foot(part, l.q);
  return {l.beside * l.beside + f.squared,
          s.center + Vec3{f.point.x * s.along_x, f.point.x * s.along_y, f.point.y}};
}

bool is_valley(const Curtain& c) {
  return c.cos_half >= 0 && c.mid_y < 0 && std::all_of(c.hems, c.hems + c.hem_count, [&c](Vec2 h) {
           return h.y <= kHorizontalEnd * c.radius;
         });
}

// The circle is left by whatever rises from its upper half, so that under the path the path itself
// is nearest.
FaceRange hill_range(const BallArc& s, const Curtain& part, const Corners3& t) {
  if (!std::all_of(part.hems, part.hems + part.hem_count,
                   [&](Vec2 h) { return h.y >= -kHorizontalEnd * part.radius; }))
    return {};
  Corners2 q;
  std::array<double, 3> beside;
  for (int k = 0; k < 3; ++k) {
    const Local l = local(s, t[k]);
    q[k] = l.q, beside[k] = l.beside;
  }
  const double c[] = {0, 0, part.radius, part.mid_x, part.mid_y, part.cos_half, part.sin_half};
  if (arc_view(c, q).part != ArcView::Part::arc) return {};
  Envelope v = length_envelope(q);
  if (whole_range(v).hi > part.radius) return {};
  for (std::array<double, 3>* side : {&v.at, &v.low, &v.high})
    for (double& x : *side) x = part.radius - x;
  std::swap(v.low, v.high);
  return convex_section_range(
      section_of(v, beside), s.ball, [&](Vec2 w) { return length(w) - s.ball; },
      [](Vec2 w) {
        const double n = length(w);
        return n > 0 ? (1 / n) * w : Vec2{};
      });
}

int ball_arc_half(const BallArc& s, const Vec3& p) {
  return ball_arc_distance(s, s.halves[1], p) < ball_arc_distance(s, s.halves[0], p) ? 1 : 0;
}

}  // namespace mrsim
