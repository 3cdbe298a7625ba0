#include "interp/path/clearing.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr double kMostLoopSteps = 1e5;

void add_line(Loop& loop, Vec2 from, Vec2 to) {
  if (length(to - from) < kRounding) return;
  PlanePiece piece;
  piece.start = from;
  piece.end = to;
  loop.push_back(piece);
}

void add_arc(Loop& loop, Vec2 from, Vec2 to, Vec2 center, double sweep) {
  PlanePiece piece;
  piece.arc = true;
  piece.start = from;
  piece.end = to;
  piece.center = center;
  piece.radius = length(from - center);
  piece.sweep = sweep;
  if (piece.radius > kRounding) loop.push_back(piece);
}

}  // namespace

Loop rounded_rectangle(double a, double b, double r) {
  Loop loop;
  add_line(loop, {a, 0}, {a, b - r});
  add_arc(loop, {a, b - r}, {a - r, b}, {a - r, b - r}, kPi / 2);
  add_line(loop, {a - r, b}, {r - a, b});
  add_arc(loop, {r - a, b}, {-a, b - r}, {r - a, b - r}, kPi / 2);
  add_line(loop, {-a, b - r}, {-a, r - b});
  add_arc(loop, {-a, r - b}, {r - a, -b}, {r - a, r - b}, kPi / 2);
  add_line(loop, {r - a, -b}, {a - r, -b});
  add_arc(loop, {a - r, -b}, {a, r - b}, {a - r, r - b}, kPi / 2);
  add_line(loop, {a, r - b}, {a, 0});
  return loop;
}

Loop circle_loop(double radius) {
  Loop loop;
  add_arc(loop, {radius, 0}, {radius, 0}, {0, 0}, 2 * kPi);
  return loop;
}

Loop arc_slot(double middle, double angle, double aside) {
  const SinCos sc = sincos(angle);
  const auto at = [&](double radius) { return Vec2{radius * sc.cos, radius * sc.sin}; };
  Loop loop;
  add_arc(loop, {middle + aside, 0}, at(middle + aside), {0, 0}, angle);
  add_arc(loop, at(middle + aside), at(middle - aside), at(middle), kPi);
  add_arc(loop, at(middle - aside), {middle - aside, 0}, {0, 0}, -angle);
  add_arc(loop, {middle - aside, 0}, {middle + aside, 0}, {middle, 0}, kPi);
  return loop;
}

Loop reversed(const Loop& loop) {
  Loop out(loop.rbegin(), loop.rend());
  for (PlanePiece& piece : out) {
    std::swap(piece.start, piece.end);
    piece.sweep = -piece.sweep;
  }
  return out;
}

Loop transformed(const Loop& loop, Vec2 shift, double degrees) {
  const SinCos sc = sincos_deg(degrees);
  const auto at = [&](Vec2 p) {
    return shift + Vec2{p.x * sc.cos - p.y * sc.sin, p.x * sc.sin + p.y * sc.cos};
  };
  Loop out = loop;
  for (PlanePiece& piece : out) {
    piece.start = at(piece.start);
    piece.end = at(piece.end);
    piece.center = at(piece.center);
  }
  return out;
}

int steps_of(double length, double step) {
  if (step <= 0 || length <= step) return 1;
  return static_cast<int>(std::min(kMostLoopSteps, std::ceil(length / step - kShareRounding)));
}

}  // namespace mrsim
