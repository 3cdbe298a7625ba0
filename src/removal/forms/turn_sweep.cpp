// Sweeps of turning inserts.
//
// Line: the Minkowski sum of the core polygon and the path is a convex polygon; the nose radius is
// subtracted from its distance. Arc: the sum's boundary consists of arcs drawn by corners, where
// the path's normal lies in the corner's normal cone, and of sides at the ends of the path and
// where the path is parallel to them. Outside, the distance to those curves is exact. Inside, two
// lower bounds of the depth are known, the distance to the curves and the depth in the deepest
// single position; the larger one counts.
#include "removal/forms/turn_sweep.h"

#include "core/numbers/angles.h"
#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "core/process/error.h"
#include "removal/simd/scalar_forms.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mrsim {
namespace {

using Side = ConvexPolygon::Side;

constexpr double kSquareSine = 1e-12;   // between unit vectors that are square to each other
constexpr double kNoLength = 1e-12;     // mm
constexpr double kSameCurve = 1e-10;    // mm: by rounding, of one curve that is drawn twice
constexpr double kSameSide = 1e-12;     // mm: by rounding, of two sides that coincide
constexpr std::size_t kMostSides = 16;  // of an insert

double arc_distance(const CircularArc& a, Vec2 q) {
  const double c[] = {a.center.x, a.center.y, a.radius,  a.middle.x,
                      a.middle.y, a.cos_half, a.sin_half};
  return lane::arc_rho(c, q.x, q.y);
}

bool in_sector(const CircularArc& a, Vec2 w) {
  const double along = dot(w, a.middle), off = cross(a.middle, w);
  return a.cos_half * (off < 0 ? -off : off) - a.sin_half * along <= 0;
}

Vec2 path_end(const CircularArc& a, double side) {
  return a.radius * (a.cos_half * a.middle + side * a.sin_half * Vec2{-a.middle.y, a.middle.x});
}

// Depth of q in the insert at its deepest position along the arc, 0 when it is in none: least over
// the path of the greatest signed distance from a side. Its minima lie at the ends, where a side's
// distance is least, or where two sides are equally far.
double deepest(const TurnSweep& s, Vec2 q) {
  const std::vector<Side>& sides = s.polygon.sides;
  const Vec2 at = q - s.path.center;
  std::array<double, kMostSides> from_center;  // of each side, with the insert on the centre
  for (std::size_t i = 0; i < sides.size(); ++i) from_center[i] = side_of(sides[i], at);
  double best = 0;
  const auto probe = [&](Vec2 w) {
    double most = -kInfinity;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      most = std::max(most, from_center[i] - dot(right_of(sides[i].direction), w));
      if (most >= best) return;
    }
    best = most;
  };
  const auto probe_within = [&](Vec2 w, std::size_t side) {
    const bool hopeless = from_center[side] - dot(right_of(sides[side].direction), w) >= best;
    if (!hopeless && in_sector(s.path, w)) probe(w);
  };
  probe(path_end(s.path, 1));
  probe(path_end(s.path, -1));
  for (std::size_t i = 0; i < sides.size(); ++i)
    probe_within(s.path.radius * right_of(sides[i].direction), i);
  for (const SidePair& pair : s.pairs) {
    const double k = from_center[pair.first] - from_center[pair.second];  // m . w = k
    const double rest = s.path.radius * s.path.radius - k * k * pair.inverse;
    if (rest < 0) continue;
    const Vec2 foot = k * pair.inverse * pair.m;
    const Vec2 off = std::sqrt(rest * pair.inverse) * Vec2{-pair.m.y, pair.m.x};
    probe_within(foot + off, pair.first);
    probe_within(foot - off, pair.first);
  }
  return best;
}

struct NearestCurve {
  double distance = kInfinity;
  std::int32_t index = 0;  // arcs first, then sides
};

// Whether q lies in what a core without width sweeps: where the path, seen from q, crosses the
// core.
bool within_segments(const TurnSweep& s, Vec2 q) {
  const Side& core = s.polygon.sides.front();
  const Vec2 at = q - s.path.center - core.a, n = right_of(core.direction);
  const double across = dot(n, at), r = s.path.radius, rest = r * r - across * across;
  if (rest < 0) return false;
  const auto covers = [&](double along) {
    const double on = dot(core.direction, at) - along;
    return on >= 0 && on <= core.length && in_sector(s.path, across * n + along * core.direction);
  };
  const double along = std::sqrt(rest);
  return covers(along) || covers(-along);
}

// A core without width has two sides in one place: the one that q looks at counts.
NearestCurve nearest_curve(const TurnSweep& s, Vec2 q) {
  NearestCurve best;
  const bool two_sided = is_segment(s.polygon);
  bool facing = true;
  for (std::size_t i = 0; i < s.arcs.size(); ++i) {
    const double d = arc_distance(s.arcs[i], q);
    if (d < best.distance) best = {d, static_cast<std::int32_t>(i)};
  }
  for (std::size_t i = 0; i < s.sides.size(); ++i) {
    const double d = side_distance(s.sides[i], q);
    const bool faces = !two_sided || side_of(s.sides[i], q) > 0;
    const double ahead = faces == facing ? 0 : faces ? kSameCurve : -kSameSide;
    if (d >= best.distance + ahead) continue;
    best = {std::min(d, best.distance), static_cast<std::int32_t>(s.arcs.size() + i)};
    facing = faces;
  }
  return best;
}

// Signed distance from arc + polygon given the distance to its boundary curves.
double signed_by_depth(const TurnSweep& s, Vec2 q, double to_curves) {
  if (s.polygon.sides.empty()) return to_curves;
  if (is_segment(s.polygon)) return within_segments(s, q) ? -to_curves : to_curves;
  // Outside of one side at every position: outside, at the cost of a few products.
  const Vec2 at = q - s.path.center;
  for (std::size_t i = 0; i < s.reach.size(); ++i)
    if (side_of(s.polygon.sides[i], at) > s.reach[i]) return to_curves;
  const double inner = deepest(s, q);
  return inner < 0 ? -std::max(to_curves, -inner) : to_curves;
}

// A thick side is round at its ends, where the nose stood.
bool is_round(const TurnSweep& s, const Side& e, Vec2 q) {
  const double along = dot(q - e.a, e.direction);
  return s.round > 0 && (along < 0 || along > e.length);
}

// Unit gradient of the distance to one curve, out of the swept area.
Vec2 curve_gradient(const TurnSweep& s, std::int32_t index, Vec2 q) {
  const auto arcs = static_cast<std::int32_t>(s.arcs.size());
  if (index >= arcs) {
    const Side& e = s.sides[index - arcs];
    const Vec2 off = q - foot_on(e, q);
    const double n = length(off);
    return is_round(s, e, q) && n > kNoLength ? (1 / n) * off : right_of(e.direction);
  }
  const CircularArc& a = s.arcs[index];
  const Vec2 w = q - a.center;
  const double n = length(w);
  const Vec2 radial = n > 0 ? (1 / n) * w : Vec2{1, 0};
  if (a.way != 0 && (s.round == 0 || in_sector(a, w))) return static_cast<double>(a.way) * radial;
  if (in_sector(a, w)) return n > a.radius ? radial : -1.0 * radial;
  const Vec2 to_high = w - path_end(a, 1), to_low = w - path_end(a, -1);
  const Vec2 off = dot(to_high, to_high) < dot(to_low, to_low) ? to_high : to_low;
  const double m = length(off);
  return m > kNoLength ? (1 / m) * off : radial;
}

// The distance and the face that decides it.
SweepSample section_sample(const TurnSweep& s, Vec2 q) {
  if (s.arc) {
    const NearestCurve curve = nearest_curve(s, q);
    return {signed_by_depth(s, q, curve.distance) - s.round, curve.index};
  }
  return {polygon_distance(s.polygon, q) - s.round, s.round > 0 ? 0 : polygon_side(s.polygon, q)};
}

CircularArc make_arc(Vec2 center, double radius, double from, double turn) {
  CircularArc a{center, {}, radius, -1, 0, 0};
  const SinCos m = sincos(from + turn / 2);
  a.middle = {m.cos, m.sin};
  if (turn < kTwoPi) {
    const SinCos h = sincos(turn / 2);
    a.cos_half = h.cos, a.sin_half = h.sin;
  }
  return a;
}

// The parts of the path on which a corner with this normal cone draws the boundary.
void add_corner(TurnSweep& s, Vec2 corner, double from, double turn, double cone, double opening,
                int way) {
  for (int k = -2; k <= 2; ++k) {
    const double lo = std::max(from, cone + k * kTwoPi);
    const double hi = std::min(from + turn, cone + opening + k * kTwoPi);
    if (hi - lo < kNoLength) continue;  // one point, which a side ends in
    s.arcs.push_back(make_arc(s.path.center + corner, s.path.radius, lo, hi - lo));
    s.arcs.back().way = way;
  }
}

void add_curves(TurnSweep& s, double from, double turn) {
  const std::vector<Side>& sides = s.polygon.sides;
  if (sides.empty()) {
    s.arcs.push_back(make_arc(s.path.center + s.polygon.point, s.path.radius, from, turn));
    return;
  }
  const auto rest = [&](const Side& e, Vec2 w) {
    s.sides.push_back({e.a + s.path.center + w, e.direction, e.length});
  };
  const bool open = turn < kTwoPi;
  const SinCos b = sincos(from), e = sincos(from + turn);
  const Vec2 low = {b.cos, b.sin}, high = {e.cos, e.sin};
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Side& side = sides[i];
    const Side& before = sides[(i + sides.size() - 1) % sides.size()];
    const Vec2 n = right_of(side.direction), m = right_of(before.direction);
    const double angle = mrsim::atan2(m.y, m.x);
    const double opening = wrapped_angle(mrsim::atan2(n.y, n.x) - angle);
    const double outer = wrapped_angle(angle), inner = wrapped_angle(angle + kPi);
    add_corner(s, side.a, wrapped_angle(from), turn, outer, opening, 1);
    add_corner(s, side.a, wrapped_angle(from), turn, inner, opening, -1);
    // Leaving the low end counter-clockwise, the path moves along (-y, x) of its radius.
    if (open && dot(n, Vec2{-low.y, low.x}) <= kSquareSine) rest(side, s.path.radius * low);
    if (open && dot(n, Vec2{-high.y, high.x}) >= -kSquareSine) rest(side, s.path.radius * high);
    for (double sign : {1.0, -1.0})
      if (in_sector(s.path, sign * n)) rest(side, (sign * s.path.radius) * n);
  }
}

// What deepest() and its quick tests need of the arc, once.
void prepare_depth(TurnSweep& s) {
  const std::vector<Side>& sides = s.polygon.sides;
  MRSIM_ASSERT(sides.size() <= kMostSides);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Vec2 n = right_of(sides[i].direction);
    s.reach.push_back(in_sector(s.path, n)
                          ? s.path.radius
                          : std::max(dot(n, path_end(s.path, 1)), dot(n, path_end(s.path, -1))));
    for (std::size_t j = 0; j < i; ++j) {
      const Vec2 m = n - right_of(sides[j].direction);
      const double mm = dot(m, m);
      if (mm >= 1e-20) s.pairs.push_back({i, j, m, 1 / mm});
    }
  }
}

}  // namespace

TurnSweep turn_line(const InsertOutline& insert, Vec2 start, Vec2 end) {
  TurnSweep s;
  std::vector<Vec2> points;
  s.lo = {kInfinity, kInfinity}, s.hi = {-kInfinity, -kInfinity};
  for (Vec2 c : insert.core) {
    points.push_back(start + c);
    points.push_back(end + c);
  }
  for (Vec2 v : points) {
    s.lo = {std::min(s.lo.x, v.x - insert.round), std::min(s.lo.y, v.y - insert.round)};
    s.hi = {std::max(s.hi.x, v.x + insert.round), std::max(s.hi.y, v.y + insert.round)};
  }
  s.polygon = make_polygon(points);
  s.round = insert.round;
  s.inside = insert.inside;
  s.one_sided = s.inside || s.lo.x >= 0;
  s.start = start, s.end = end;
  return s;
}

TurnSweep turn_arc(const InsertOutline& insert, Vec2 start, Vec2 center, double turn) {
  TurnSweep s;
  s.arc = true;
  s.polygon = make_polygon(insert.core);
  s.round = insert.round;
  s.inside = insert.inside;
  const Vec2 v = start - center;
  const double size = std::min(turn < 0 ? -turn : turn, kTwoPi);
  const double from = mrsim::atan2(v.y, v.x) - (turn < 0 ? size : 0);
  s.path = make_arc(center, length(v), from, size);
  prepare_depth(s);
  add_curves(s, wrapped_angle(from), size);
  s.lo = {kInfinity, kInfinity}, s.hi = {-kInfinity, -kInfinity};
  const auto reach = [&](Vec2 w) {
    for (Vec2 c : insert.core) {
      const Vec2 q = center + w + c;
      s.lo = {std::min(s.lo.x, q.x - s.round), std::min(s.lo.y, q.y - s.round)};
      s.hi = {std::max(s.hi.x, q.x + s.round), std::max(s.hi.y, q.y + s.round)};
    }
  };
  reach(path_end(s.path, 1));
  reach(path_end(s.path, -1));
  const double r = s.path.radius;
  for (Vec2 w : {Vec2{r, 0}, Vec2{0, r}, Vec2{-r, 0}, Vec2{0, -r}})
    if (in_sector(s.path, w)) reach(w);
  s.one_sided = s.inside || s.lo.x >= 0;
  const bool flat =
      s.path.cos_half >= 0;  // at most half a turn: the sagitta; else all of the circle
  s.start = flat ? center + path_end(s.path, -1) : center;
  s.end = flat ? center + path_end(s.path, 1) : center;
  s.bulge = flat ? r - r * s.path.cos_half : r;
  return s;
}

double section_distance(const TurnSweep& s, Vec2 q) {
  if (!s.arc) return polygon_distance(s.polygon, q) - s.round;
  return signed_by_depth(s, q, nearest_curve(s, q).distance) - s.round;
}

double turn_distance(const TurnSweep& s, const Vec3& p) {
  const double rho = std::sqrt(p.x * p.x + p.y * p.y);
  const double front = section_distance(s, {rho, p.z});
  if (s.one_sided) return front;
  const double behind = section_distance(s, {-rho, p.z});
  return behind < front ? behind : front;
}

SweepSample turn_sample(const TurnSweep& s, const Vec3& p) {
  const double rho = std::sqrt(p.x * p.x + p.y * p.y);
  const SweepSample front = section_sample(s, {rho, p.z});
  if (s.one_sided) return front;
  const SweepSample behind = section_sample(s, {-rho, p.z});
  if (!(behind.distance < front.distance)) return front;
  return {behind.distance, behind.patch + kMirrorPatch};
}

Vec3 turn_gradient(const TurnSweep& s, const Vec3& p, std::int32_t patch) {
  const double rho = std::sqrt(p.x * p.x + p.y * p.y);
  const bool mirrored = patch >= kMirrorPatch;
  const std::int32_t index = mirrored ? patch - kMirrorPatch : patch;
  const Vec2 q = {mirrored ? -rho : rho, p.z};
  Vec2 g;
  if (s.arc) {
    g = curve_gradient(s, index, q);
  } else if (s.round == 0 && static_cast<std::size_t>(index) < s.polygon.sides.size()) {
    g = right_of(s.polygon.sides[index].direction);
  } else {
    g = polygon_gradient(s.polygon, q);
  }
  if (mirrored) g.x = -g.x;
  if (rho == 0) return {g.x, 0, g.y};
  return {g.x * p.x / rho, g.x * p.y / rho, g.y};
}

double turn_face_distance(const TurnSweep& s, const Vec3& p, std::int32_t patch) {
  const double rho = std::sqrt(p.x * p.x + p.y * p.y);
  const bool mirrored = patch >= kMirrorPatch;
  const auto index = static_cast<std::size_t>(mirrored ? patch - kMirrorPatch : patch);
  const Vec2 q = {mirrored ? -rho : rho, p.z};
  if (!s.arc) {
    const bool sharp = s.round == 0 && index < s.polygon.sides.size();
    return sharp ? side_of(s.polygon.sides[index], q) : polygon_distance(s.polygon, q) - s.round;
  }
  if (index >= s.arcs.size()) {
    const Side& e = s.sides[index - s.arcs.size()];
    return (is_round(s, e, q) ? side_distance(e, q) : side_of(e, q)) - s.round;
  }
  const CircularArc& a = s.arcs[index];
  const Vec2 w = q - a.center;
  if (s.round > 0 && !in_sector(a, w)) return arc_distance(a, q) - s.round;
  const double beyond = length(w) - a.radius;
  return (a.way > 0 ? beyond : a.way < 0 ? -beyond : beyond < 0 ? -beyond : beyond) - s.round;
}

}  // namespace mrsim
