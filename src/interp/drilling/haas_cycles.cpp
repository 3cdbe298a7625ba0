#include "interp/drilling/haas_cycles.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kMostHolesOfCall = 10'000;
constexpr double kMostCircles = 100'000;

}  // namespace

bool HaasCycles::wants_block() const {
  return block_.oneshot &&
         (block_.oneshot_code == Code::circle_pocket || block_.oneshot_code == Code::hole_pattern);
}

bool HaasCycles::run() { return block_.oneshot_code == Code::circle_pocket ? pocket() : holes(); }

// Reads a whole number of at least 1. Without the word `out` does not change.
bool HaasCycles::count(char letter, double most, long& out, bool negative) {
  const Word* word = take(letter);
  if (!word) return true;
  const double value = negative ? -word->value : word->value;
  if (value < 1 || value > most || value != std::floor(value))
    return error("value-range", fmt::format("{} is a whole number from 1 to {:g}", letter, most),
                 *word);
  out = static_cast<long>(value);
  return true;
}

double HaasCycles::length_of(char letter) {
  const Word* word = take(letter);
  return word ? word->value * length_unit(*word) : 0;
}

double HaasCycles::value_of(char letter) {
  const Word* word = take(letter);
  return word ? word->value : 0;
}

bool HaasCycles::holes() {
  const Word& where = *block_.oneshot;
  if (modal_.plane != kPlaneXY)
    return error("value-range", fmt::format("{} needs the plane G17", text_of(where)), where);
  Target first;
  std::vector<Vec3> points;
  const bool haas = where.value >= 70;
  if (!(haas ? haas_holes(points) : mitsubishi_holes(points)) ||
      !axes_.target(first, position_.programmed))
    return false;
  for (Vec3& point : points) point += first.programmed;
  return drilling_.at_points(points, where, !haas);
}

bool HaasCycles::needs(std::string_view letters) {
  for (const char c : letters)
    if (!peek(c))
      return error("value-missing", fmt::format("{} needs {}", text_of(*block_.oneshot), c),
                   *block_.oneshot);
  return true;
}

// G70: I is the radius, J the first angle, L the number of holes. G71 also has K, the angle from
// hole to hole. G72: I is the distance from hole to hole, J the angle of the line.
bool HaasCycles::haas_holes(std::vector<Vec3>& points) {
  const double g = block_.oneshot->value;
  long number = 1;
  if (!needs(g == 71 ? "ILK" : "IL") || !count('L', kMostHolesOfCall, number)) return false;
  const double size = length_of('I');
  const double angle = value_of('J');
  if (g == 72)
    add_line(points, size, angle, number);
  else
    add_arc(points, size, angle, g == 71 ? value_of('K') : 360.0 / double(number), number);
  return true;
}

// Mitsubishi: G34 is a circle with the radius I, the first angle J and K holes, clockwise if K is
// below 0. G35 is a line: I from hole to hole, J its angle. G36 is an arc as G34, with P from hole
// to hole. G37.1 is a grid of P by K holes at the distances I and J.
bool HaasCycles::mitsubishi_holes(std::vector<Vec3>& points) {
  const double g = block_.oneshot->value;
  if (!needs(g >= 36 ? "IJKP" : "IJK")) return false;
  long number = 1, across = 1;
  const bool clockwise = g == 34 && peek('K')->value < 0;
  if (!count('K', kMostHolesOfCall, number, clockwise) ||
      (g > 37 && !count('P', kMostHolesOfCall, across)))
    return false;
  const double size = length_of('I');
  if (g > 37) {
    if (double(number) * double(across) > kMostHolesOfCall)
      return error("value-range", "too many holes in the grid", *block_.oneshot);
    const double row = length_of('J');
    for (long k = 0; k < number; ++k)
      for (long i = 0; i < across; ++i)
        points.push_back({double(k % 2 == 0 ? i : across - 1 - i) * size, double(k) * row, 0});
  } else if (g == 35) {
    add_line(points, size, value_of('J'), number);
  } else {
    const double step = g == 36 ? value_of('P') : (clockwise ? -360.0 : 360.0) / double(number);
    add_arc(points, size, value_of('J'), step, number);
  }
  return true;
}

void HaasCycles::add_line(std::vector<Vec3>& points, double step, double angle, long number) {
  const SinCos sc = sincos_deg(angle);
  for (long i = 0; i < number; ++i) {
    const double far = double(i) * step;
    points.push_back({far * sc.cos, far * sc.sin, 0});
  }
}

void HaasCycles::add_arc(std::vector<Vec3>& points, double radius, double angle, double step,
                         long number) {
  for (long i = 0; i < number; ++i) {
    const SinCos sc = sincos_deg(angle + double(i) * step);
    points.push_back({radius * sc.cos, radius * sc.sin, 0});
  }
}

// I is the first or the only radius, K the last one, in steps of Q. D is the radius of the tool.
// Without Z the pocket is cut where the tool stands.
bool HaasCycles::read_pocket(Pocket& out) {
  if (modal_.comp != Code::comp_off)
    return error("cycle-compensation", "a circular pocket under radius compensation",
                 *block_.oneshot);
  const Word* i = peek('I');
  const Word* z = take('Z');
  const bool is_haas = peek('K') || peek('Q') || peek('D');
  if (!i || (!z && !is_haas))
    return error("value-missing", fmt::format("a circular pocket needs {}", i ? 'Z' : 'I'),
                 *block_.oneshot);
  const double factor = plane_factor();  // G51 scales I and K, not the tool
  if (!(factor > 0))
    return error("arc-scaled-unequally", "a circular pocket in a plane that is scaled unequally",
                 *block_.oneshot);
  const double tool = compensation_.register_radius(*block_.oneshot) / factor;
  out.first = out.last = length_of('I') - tool;
  if (peek('K') && peek('Q')) {
    out.last = length_of('K') - tool;
    out.step = length_of('Q');
  }
  const double here = modal_.incremental ? 0 : position_.programmed.z;
  out.depth = z ? z->value * length_unit(*z) : here;
  if (!count('L', 9999, out.times)) return false;
  const bool steps = out.last > out.first;
  if (steps &&
      std::abs(out.first) < kRounding)  // no room for a circle, because I is the tool's radius
    out.first = std::min(out.step, out.last);
  if (!(out.first > 0) || out.last < out.first || (steps && !(out.step > 0)) ||
      (steps && (out.last - out.first) / out.step > kMostCircles))
    return error("value-range",
                 "a circular pocket needs I not less than the tool's radius and less than K, and Q "
                 "above 0",
                 *i);
  if (out.first > 2 * tool + kRounding && tool > 0)
    note_once("cycle-entry",
              "I is larger than the tool's diameter: the way in, a half circle that ends towards "
              "+X, cuts where the control's own may lie elsewhere",
              *i, "entry");
  return true;
}

void HaasCycles::to_level(double level) {
  Target to;
  to.programmed = position_.programmed;
  to.programmed.z = level;
  to.named = kAxisZ;
  moves_.step(to, *block_.oneshot, MotionKind::line);
}

// Runs an arc in the plane about `center`: half a turn to `to`, or a full turn. G13 is
// counter-clockwise.
bool HaasCycles::half_circle(Vec2 center, Vec2 to, bool whole) {
  const Basis b = basis();
  ArcBlock block;
  block.from = block.to.programmed = position_.programmed;
  block.to.programmed.x = to.x;
  block.to.programmed.y = to.y;
  block.to.named = kAxisX | kAxisY;
  block.basis = b;
  const Vec2 start{block.from.x, block.from.y};
  const double side = block_.oneshot->value == 13 ? 1 : -1;
  SolvedArc arc;
  set_plane_arc(block, {center, length(start - center), side * (whole ? kTwoPi : kPi)}, arc);
  arc.where = block_.oneshot;
  return moves_.solved_arc(arc);
}

// Goes down in the middle, in by a half circle, once round for each radius, and back by a half
// circle.
bool HaasCycles::circles(const Pocket& pocket) {
  const Vec2 middle{position_.programmed.x, position_.programmed.y};
  for (double r = pocket.first;;) {
    const Vec2 at = middle + Vec2{r, 0};
    if (r == pocket.first && !half_circle(middle + Vec2{r / 2, 0}, at, false)) return false;
    if (!half_circle(middle, at, true)) return false;
    if (r >= pocket.last - kRounding) return half_circle(middle + Vec2{r / 2, 0}, middle, false);
    r = std::min(r + pocket.step, pocket.last);
    Target next;
    next.programmed = position_.programmed;
    next.programmed.x = middle.x + r;
    next.named = kAxisX | kAxisY;
    moves_.step(next, *block_.oneshot, MotionKind::line);
  }
}

// From the middle, where the tool is, goes along X by I (without regard to the tool's radius),
// round, and back.
bool HaasCycles::circle_of_mach() {
  if (!needs("I")) return false;
  if (peek('X') || peek('Y') || peek('Z'))
    return error("not-supported", "G12 and G13 of Mach beside an axis: write the axis before them",
                 *block_.oneshot);
  if (!(peek('I')->value > 0))
    return error("value-range", "G12 and G13 of Mach need I, the radius, above 0", *peek('I'));
  const Vec3 middle = position_.programmed;
  Target to;
  to.programmed = middle;
  to.programmed.x += length_of('I');
  to.named = kAxisX;
  moves_.step(to, *block_.oneshot, MotionKind::line);
  const Vec2 begin{to.programmed.x, middle.y};
  if (!half_circle({middle.x, middle.y}, begin, true)) return false;
  to.programmed = middle;
  moves_.step(to, *block_.oneshot, MotionKind::line);
  note_once("mach-circle", "G12 and G13 are Mach's: I is the radius of the tool's own path",
            *block_.oneshot, "G12");
  return true;
}

bool HaasCycles::pocket() {
  if (modal_.plane != kPlaneXY)
    return error("value-range", "a circular pocket needs the plane G17", *block_.oneshot);
  if (is(Dialect::ngc) || (is(Dialect::iso) && !peek('Z'))) return circle_of_mach();
  Pocket pocket;
  if (!read_pocket(pocket)) return false;
  Target center;
  if (!axes_.target(center, position_.programmed)) return false;
  center.programmed.z = position_.programmed.z;  // Z is the depth
  center.named -= kAxisZ;
  if (!center.named.empty()) moves_.step(center, *block_.oneshot, MotionKind::rapid);
  for (long i = 0; i < pocket.times; ++i) {
    to_level(modal_.incremental ? position_.programmed.z + pocket.depth : pocket.depth);
    if (!circles(pocket)) return false;
  }
  return true;
}

}  // namespace mrsim
