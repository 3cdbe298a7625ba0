// How the areas of milling cycles are cleared: level by level, loop by loop; spigots, faces, open
// slots and threads.
#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "interp/milling/mill_cycles.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kSteepest = 2;      // degrees, of swinging without an angle
constexpr double kMostPasses = 1e5;  // of one cycle

Vec2 turned(Vec2 p, double degrees) {
  const SinCos sc = sincos_deg(degrees);
  return {p.x * sc.cos - p.y * sc.sin, p.x * sc.sin + p.y * sc.cos};
}

}  // namespace

// Roughing leaves the allowances; finishing takes the wall, then the floor.
bool MillCycles::clear(const Levels& l, const Area& area) {
  const double up = l.bottom < l.reference ? 1 : -1;
  const bool leaves = l.side > 0 || l.floor > 0;
  const double passes = l.infeed > 0 ? std::abs(l.bottom - l.reference) / l.infeed : 1;
  mover_.rapid_height(l.top);
  const std::vector<Loop> exact = area.loops(0);
  if (passes * static_cast<double>(exact.size() + 1) > kMostPasses)
    return fail("value-range", "more than 100000 loops");
  if (l.rough) {
    const double bottom = l.bottom + up * l.floor;
    const bool last = l.finish && !leaves;  // nothing is left for finishing
    cut(l, area, last ? exact : area.loops(l.side), l.infeed, bottom);
  }
  if (l.finish && (leaves || !l.rough)) {
    const std::vector<Loop> wall(exact.empty() ? exact.end() : exact.end() - 1, exact.end());
    cut(l, area, wall, l.finish_infeed > 0 ? l.finish_infeed : l.infeed, l.bottom);
    if (l.floor > 0) cut(l, area, exact, 0, l.bottom);
  }
  return true;
}

void MillCycles::cut(const Levels& l, const Area& area, const std::vector<Loop>& loops,
                     double infeed, double bottom) {
  const double whole = bottom - l.reference;
  const int n = steps_of(std::abs(whole), infeed);
  double from = l.safe;
  mover_.rapid(area.entry);
  mover_.rapid_height(l.safe);
  for (int i = 1; i <= n; ++i) {
    const double to = i == n ? bottom : l.reference + whole * i / n;
    descend(l, area, from, to);
    for (const Loop& loop : loops) {
      mover_.line(loop.front().start, l.feed);
      mover_.loop(loop, l.feed);
    }
    from = to + (l.safe - l.reference);
    mover_.rapid_height(i == n ? l.top : from);
    mover_.rapid(area.entry);
  }
}

void MillCycles::descend(const Levels& l, const Area& area, double from, double to) {
  if (l.entry == 0) return mover_.rapid_height(to);
  const double radius = std::min(l.helix * scale(), area.helix);
  if (l.entry == 3 && area.swing > 1e-3) return swing_down(l, area, from, to);
  if (l.entry != 2 || radius < 1e-3) return mover_.line_height(to, l.plunge);
  const double deep = std::abs(to - from);
  PlanePiece turn;
  turn.arc = true;
  turn.center = area.entry;
  turn.radius = radius;
  const Vec2 start = area.entry + Vec2{radius, 0};
  const double turns = l.helix_lead > 0 ? deep / l.helix_lead : 1;
  const double sweep = 2 * kPi * std::min(turns, 1e5) * (l.clockwise ? -1 : 1);
  const SinCos sc = sincos(sweep);
  mover_.line(start, l.feed);
  turn.sweep = sweep;
  turn.start = start;
  turn.end = area.entry + Vec2{radius * sc.cos, radius * sc.sin};
  mover_.piece(turn, to - from, l.plunge);
  turn.sweep = l.clockwise ? -2 * kPi : 2 * kPi;
  turn.start = turn.end;
  mover_.piece(turn, 0, l.feed);
  mover_.line(area.entry, l.feed);
}

// To and fro along the middle, at most as steep as the cycle allows.
void MillCycles::swing_down(const Levels& l, const Area& area, double from, double to) {
  const SinCos sc = sincos_deg(area.degrees);
  const SinCos slope = sincos_deg(l.helix > 0 ? std::min(l.helix, 80.0) : kSteepest);
  const Vec2 aside = area.swing * Vec2{sc.cos, sc.sin};
  const int n = steps_of(std::abs(to - from), 2 * area.swing * slope.sin / slope.cos);
  mover_.line(area.entry - aside, l.feed);
  double side = 1;
  for (int i = 1; i <= n; ++i, side = -side)
    mover_.slope(area.entry + side * aside, from + (to - from) * i / n, l.plunge);
  mover_.line(area.entry + side * aside, l.feed);
  mover_.line(area.entry, l.feed);
}

// CYCLE76 and CYCLE77: loops from the blank inwards; the tool goes down outside of the blank.
bool MillCycles::spigot() {
  Levels l;
  if (!levels(l)) return false;
  const bool round = call_->name == "CYCLE77";
  const double unit = scale(), degrees = value("STA");
  const double length = std::abs(round ? value("CDIAM") : value("LENG")) * unit;
  const double width = round ? length : std::abs(value("WID")) * unit;
  const double corner =
      round ? length / 2 : std::min(std::abs(value("CRAD")) * unit, std::min(length, width) / 2);
  const double blank_length = std::max(length, std::abs(value("AP1")) * unit);
  const double blank_width = round ? blank_length : std::max(width, std::abs(value("AP2")) * unit);
  if (length <= 0 || width <= 0)
    return fail("value-range", "the length and the width of a spigot must be above 0");
  if (!round && (value("LENG") < 0 || value("WID") < 0))
    return fail("not-supported",
                "CYCLE76: a length below 0 counts from a corner (_ZSD[2]), which is not supported: "
                "write the centre and lengths above 0");
  Vec2 at;
  if (!(round ? reference_point(at) : center(length, width, degrees, at))) return false;
  const double aside0 = std::max(blank_length - length, blank_width - width) / 2;
  // The corners of a rectangular blank lie farther out than its sides.
  const double reach = round ? aside0 : aside0 * 1.4143 + 0.4143 * corner;
  Area area;
  const double out = length / 2 + reach + 2 * radius_ + std::abs(l.safe - l.reference);
  area.entry = at + turned({out, 0}, degrees);
  const int direction = static_cast<int>(value("CDIR"));
  const bool opposite = direction == 1 || direction == 3;  // climbing goes clockwise outside
  area.loops = [=, r = radius_](double aside) {
    const double most = std::max(0.0, reach - aside);
    std::vector<Loop> loops;
    for (int n = steps_of(most, l.width), k = n - 1; k >= 0; --k) {
      const double d = aside + most * k / n + r;
      const Loop loop = round ? circle_loop(length / 2 + d)
                              : rounded_rectangle(length / 2 + d, width / 2 + d, corner + d);
      loops.push_back(transformed(opposite ? loop : reversed(loop), at, degrees));
    }
    return loops;
  };
  return clear(l, area);
}

// Lines at the levels, from outside; to and fro, or each from the same side.
bool MillCycles::tracks(const Levels& l, const std::vector<std::pair<Vec2, Vec2>>& lines,
                        bool one_way) {
  const double up = l.bottom < l.reference ? 1 : -1;
  const double bottom = l.bottom + (l.rough && !l.finish ? up * l.floor : 0);
  const double first = l.rough ? l.reference : l.bottom + up * l.floor;
  const int n = l.rough ? steps_of(std::abs(bottom - first), l.infeed) : 1;
  const double clear = l.safe - l.reference;
  mover_.rapid_height(l.top);
  for (int i = 1; i <= n; ++i) {
    const double level = i == n ? bottom : first + (bottom - first) * i / n;
    mover_.rapid(lines.front().first);
    if (i == 1) mover_.rapid_height(l.safe);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const bool back = !one_way && k % 2 == 1;
      if (one_way && k > 0) {
        mover_.rapid_height(level + clear);
        mover_.rapid(lines[k].first);
      }
      if (one_way || k == 0) mover_.line_height(level, l.plunge);
      mover_.line(back ? lines[k].second : lines[k].first, l.feed);
      mover_.line(back ? lines[k].first : lines[k].second, l.feed);
    }
    mover_.rapid_height(i == n ? l.top : level + clear);
  }
  return true;
}

// CYCLE71 by length, width and angle; CYCLE61, whose LIM keeps the cutter inside of edges.
bool MillCycles::face() {
  Levels l;
  Vec2 corner;
  if (!levels(l) || !reference_point(corner)) return false;
  const bool old = call_->name == "CYCLE71";
  const double unit = scale(), degrees = old ? value("STA") : 0;
  const auto extent = [&](ValueName size, int digit, double from) {
    const bool to = !old && call_->digit("AMODE", digit) == 2;
    return value(size) * unit - (to ? from : 0);
  };
  const double length = extent("LENG", 2, corner.x);
  const double width = extent("WID", 3, corner.y);
  const int way = static_cast<int>(value("VARI")) / 10 % 10;
  const bool along_v = way == 2 || way == 4, one_way = way == 1 || way == 2;
  if (length == 0 || width == 0) return fail("value-range", "the face has no length or no width");
  // In the face: from its lower left corner.
  const double lu = std::abs(along_v ? width : length), lv = std::abs(along_v ? length : width);
  const auto limit = [&](bool second, bool high) {
    const int digit = (second ? 2 : 0) + (high ? 1 : 0);
    return !old && call_->digit("LIM", digit) == 1;
  };
  const double out = radius_ + std::abs(l.safe - l.reference);
  const double u0 = limit(along_v, false) ? radius_ : -out - (old ? value("FDP1") * unit : 0);
  const double u1 =
      limit(along_v, true) ? lu - radius_ : lu + out + (old ? value("FDP") * unit : 0);
  const double v0 = limit(!along_v, false) ? radius_ : 0;
  const double v1 = limit(!along_v, true) ? lv - radius_ : lv;
  if (u1 <= u0 || v1 < v0) return fail("value-range", "the cutter is too large for the face");
  const bool shut = v0 > 0 || v1 < lv;
  const int n = steps_of(v1 - v0, l.width) + (shut ? 1 : 0);
  const Vec2 low{std::min(length, 0.0), std::min(width, 0.0)};
  const auto at = [&](double u, double v) {
    return corner + turned(low + (along_v ? Vec2{v, u} : Vec2{u, v}), degrees);
  };
  std::vector<std::pair<Vec2, Vec2>> lines;
  for (int i = 0; i < n; ++i) {
    const double v = shut ? v0 + (v1 - v0) * i / (n - 1) : v0 + (v1 - v0) * (i + 0.5) / n;
    lines.emplace_back(at(u0, v), at(u1, v));
  }
  return tracks(l, lines, one_way);
}

// CYCLE899: a slot open at both ends, centre lines side by side.
bool MillCycles::open_slot() {
  Levels l;
  Vec2 at;
  if (!levels(l) || !reference_point(at)) return false;
  if (call_->digit("GMODE", 3) > 1)
    return fail("not-supported", "CYCLE899: a reference point other than the centre");
  const double unit = scale(), length = std::abs(value("LENG")) * unit;
  const double b = std::abs(value("WID")) * unit / 2 - radius_ - (l.finish ? 0 : l.side);
  if (length <= 0 || b < -kRounding)
    return fail("value-range", "the cutter is too large for the slot (alarm 61105)");
  const double half = length / 2 + radius_ + std::abs(l.safe - l.reference);
  const int n = b < kRounding ? 0 : steps_of(2 * b, l.width);
  const auto point = [&](double u, double v) { return at + turned({u, v}, value("STA")); };
  std::vector<std::pair<Vec2, Vec2>> lines;
  for (int i = 0; i <= n; ++i) {
    const double v = n == 0 ? 0 : -b + 2 * b * i / n;
    lines.emplace_back(point(-half, v), point(half, v));
  }
  return tracks(l, lines, false);
}

// CYCLE90: a helix with the pitch from above the face to the depth; inside at the nominal
// diameter, outside at the core.
bool MillCycles::thread() {
  Levels l;
  Vec2 at;
  if (!depth(l) || !reference_point(at)) return false;
  const double unit = scale(), pitch = std::abs(call_->get("PIT")) * unit;
  const bool outside = call_->get("TYPTH") == 1;
  const double nominal = std::abs(call_->get("DIATH")) * unit / 2;
  const double wall =
      outside ? std::abs(call_->get("KDIAM")) * unit / 2 + radius_ : nominal - radius_;
  if (pitch <= 0) return fail("thread-lead", "CYCLE90 needs the pitch of the thread, PIT");
  if (wall <= kRounding) return fail("value-range", "the cutter is too large for the thread");
  const double feed = value("FFR") * feed_scale();
  const double down = l.bottom < l.reference ? -1 : 1;
  // Whole turns that begin above the face.
  const double turns = std::ceil(std::abs(l.bottom - l.safe) / pitch);
  if (turns > 1e5) return fail("value-range", "more than 100000 turns");
  PlanePiece helix;
  helix.arc = true;
  helix.center = at;
  helix.radius = wall;
  helix.start = helix.end = at + Vec2{wall, 0};
  helix.sweep = 2 * kPi * turns * (call_->get("CDIR") == 2 ? -1 : 1);
  const Vec2 rest = outside ? at + Vec2{wall + nominal + radius_, 0} : at;
  mover_.rapid_height(l.top);
  mover_.rapid(rest);
  mover_.rapid_height(l.bottom - down * turns * pitch);
  mover_.line(helix.start, feed);
  mover_.piece(helix, down * turns * pitch, feed);
  mover_.line(rest, feed);
  mover_.rapid_height(l.top);
  return true;
}

}  // namespace mrsim
