#include "interp/control/haas_cycles.h"

#include "core/trig.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kMostHoles = 10'000;
constexpr double kMostCircles = 100'000;

}  // namespace

bool HaasCycles::wants_block() const {
  return block_.oneshot &&
         (block_.oneshot_code == Code::circle_pocket || block_.oneshot_code == Code::hole_pattern);
}

bool HaasCycles::run() { return block_.oneshot_code == Code::circle_pocket ? pocket() : holes(); }

// A whole number of at least 1; without the word `out` stays.
bool HaasCycles::count(char letter, double most, long& out) {
  const Word* word = take(letter);
  if (!word) return true;
  if (word->value < 1 || word->value > most || word->value != std::floor(word->value))
    return error("value-range", fmt::format("{} is a whole number from 1 to {:g}", letter, most),
                 *word);
  out = static_cast<long>(word->value);
  return true;
}

double HaasCycles::length_of(char letter) {
  const Word* word = take(letter);
  return word ? word->value * length_unit(*word) : 0;
}

// G70 I radius, J first angle, L holes; G71 also K, from hole to hole; G72 I from hole to hole,
// J angle of the line.
bool HaasCycles::holes() {
  const int g = static_cast<int>(block_.oneshot->value);
  for (const char c : {'I', 'L'})
    if (!peek(c)) return error("value-missing", fmt::format("G{} needs {}", g, c), *block_.oneshot);
  if (modal_.plane != 0)
    return error("value-range", fmt::format("G{} needs the plane G17", g), *block_.oneshot);
  long number = 1;
  if (!count('L', kMostHoles, number)) return false;
  const double size = length_of('I');
  const Word* first = take('J');
  const Word* between = g == 71 ? take('K') : nullptr;
  if (g == 71 && !between) return error("value-missing", "G71 needs K", *block_.oneshot);
  const double angle = first ? first->value : 0;
  const double step = between ? between->value : 360.0 / static_cast<double>(number);
  Target center;
  if (!axes_.target(center, position_.programmed)) return false;
  std::vector<Vec3> points;
  for (long i = 0; i < number; ++i) {
    const double turn = static_cast<double>(i);
    const SinCos sc = sincos_deg(g == 72 ? angle : angle + turn * step);
    const double far = g == 72 ? turn * size : size;
    points.push_back(center.programmed + Vec3{far * sc.cos, far * sc.sin, 0});
  }
  return drilling_.at_points(points, *block_.oneshot);
}

// I is the first radius, or the only one; K the last, in steps of Q. D is the tool's radius.
bool HaasCycles::read_pocket(Pocket& out) {
  if (modal_.comp != Code::comp_off)
    return error("cycle-compensation", "a circular pocket under radius compensation",
                 *block_.oneshot);
  const Word* i = peek('I');
  const Word* z = take('Z');
  if (!i || !z)
    return error("value-missing", fmt::format("a circular pocket needs {}", i ? 'Z' : 'I'),
                 *block_.oneshot);
  const double tool = compensation_.register_radius(*block_.oneshot);
  out.first = out.last = length_of('I') - tool;
  if (peek('K') && peek('Q')) {
    out.last = length_of('K') - tool;
    out.step = length_of('Q');
  }
  out.depth = z->value * length_unit(*z);
  if (!count('L', 9999, out.times)) return false;
  const bool steps = out.last > out.first;
  if (!(out.first > 0) || out.last < out.first || (steps && !(out.step > 0)) ||
      (steps && (out.last - out.first) / out.step > kMostCircles))
    return error("value-range",
                 "a circular pocket needs I larger than the tool's radius and less than K, and Q "
                 "above 0",
                 *i);
  if (out.first > 2 * tool + 1e-9 && tool > 0)
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
  to.named = 4;
  moves_.step(to, *block_.oneshot, MotionKind::line);
}

// An arc in the plane about `center`, half a turn to `to` or a whole one; G13 counter-clockwise.
bool HaasCycles::half_circle(Vec2 center, Vec2 to, bool whole) {
  const Basis b = basis();
  ArcBlock block;
  block.from = block.to.programmed = position_.programmed;
  block.to.programmed.x = to.x;
  block.to.programmed.y = to.y;
  block.to.named = 3;
  block.basis = b;
  const Vec2 start{block.from.x, block.from.y};
  const double side = block_.oneshot->value == 13 ? 1 : -1;
  SolvedArc arc;
  set_plane_arc(block, {center, length(start - center), side * (whole ? kTwoPi : kPi)}, arc);
  arc.where = block_.oneshot;
  return moves_.solved_arc(arc);
}

// Down in the middle, in with a half circle, a circle for each radius, back with a half circle.
bool HaasCycles::circles(const Pocket& pocket) {
  const Vec2 middle{position_.programmed.x, position_.programmed.y};
  for (double r = pocket.first;;) {
    const Vec2 at = middle + Vec2{r, 0};
    if (r == pocket.first && !half_circle(middle + Vec2{r / 2, 0}, at, false)) return false;
    if (!half_circle(middle, at, true)) return false;
    if (r >= pocket.last - 1e-9) return half_circle(middle + Vec2{r / 2, 0}, middle, false);
    r = std::min(r + pocket.step, pocket.last);
    Target next;
    next.programmed = position_.programmed;
    next.programmed.x = middle.x + r;
    next.named = 3;
    moves_.step(next, *block_.oneshot, MotionKind::line);
  }
}

bool HaasCycles::pocket() {
  if (modal_.plane != 0)
    return error("value-range", "a circular pocket needs the plane G17", *block_.oneshot);
  Pocket pocket;
  if (!read_pocket(pocket)) return false;
  Target center;
  if (!axes_.target(center, position_.programmed)) return false;
  center.programmed.z = position_.programmed.z;  // Z is the depth
  center.named &= 3U;
  if (center.named) moves_.step(center, *block_.oneshot, MotionKind::rapid);
  for (long i = 0; i < pocket.times; ++i) {
    to_level(modal_.incremental ? position_.programmed.z + pocket.depth : pocket.depth);
    if (!circles(pocket)) return false;
  }
  return true;
}

}  // namespace mrsim
