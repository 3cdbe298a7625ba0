#include "interp/milling/area_cutter.h"

#include "core/numbers/trig.h"
#include "core/numbers/units.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr double kSteepest = 2;   // degrees, of swinging without an angle
constexpr double kNoRoom = 1e-3;  // mm: too little for a helix, or for swinging

}  // namespace

bool AreaCutter::clear(const MillLevels& l, const MillArea& area) {
  const double up = l.bottom < l.reference ? 1 : -1;
  const bool leaves = l.side > 0 || l.floor > 0;
  const double passes = l.infeed > 0 ? std::abs(l.bottom - l.reference) / l.infeed : 1;
  mover_.rapid_height(l.top);
  const std::vector<Loop> exact = area.loops(0);
  if (passes * static_cast<double>(exact.size() + 1) > kMostLoops) return false;
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

void AreaCutter::cut(const MillLevels& l, const MillArea& area, const std::vector<Loop>& loops,
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

void AreaCutter::descend(const MillLevels& l, const MillArea& area, double from, double to) {
  if (l.entry == 0) return mover_.rapid_height(to);
  const double radius = std::min(l.helix * scale(), area.helix);
  if (l.entry == 3 && area.swing > kNoRoom) return swing_down(l, area, from, to);
  if (l.entry != 2 || radius < kNoRoom) return mover_.line_height(to, l.plunge);
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

// Swings along the middle, at most as steep as the cycle allows.
void AreaCutter::swing_down(const MillLevels& l, const MillArea& area, double from, double to) {
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

void AreaCutter::tracks(const MillLevels& l, const std::vector<std::pair<Vec2, Vec2>>& lines,
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
}

}  // namespace mrsim
