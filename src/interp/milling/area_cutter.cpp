#include "interp/milling/area_cutter.h"

#include "core/numbers/trig.h"
#include "core/numbers/units.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr double kUsualSwing = 2, kLargestSwing = 80;  // degrees
constexpr double kNoRoom = 1e-3;    // mm: too little for a helix, or for swinging
constexpr double kMostTurns = 1e5;  // of a helix

}  // namespace

bool AreaCutter::clear(const MillPlan& plan, const MillArea& area) {
  const double up = plan.bottom < plan.reference ? 1 : -1;
  const bool leaves = plan.side > 0 || plan.floor > 0;
  const double passes = plan.infeed > 0 ? std::abs(plan.bottom - plan.reference) / plan.infeed : 1;
  mover_.rapid_height(plan.top);
  const std::vector<Loop> exact = area.loops(0);
  if (passes * static_cast<double>(exact.size() + 1) > kMostLoops) return false;
  if (plan.rough) {
    const double bottom = plan.bottom + up * plan.floor;
    const bool last = plan.finish && !leaves;  // nothing is left for finishing
    cut(plan, area, last ? exact : area.loops(plan.side), plan.infeed, bottom);
  }
  if (plan.finish && (leaves || !plan.rough)) {
    const std::vector<Loop> wall(exact.empty() ? exact.end() : exact.end() - 1, exact.end());
    cut(plan, area, wall, plan.finish_infeed > 0 ? plan.finish_infeed : plan.infeed, plan.bottom);
    if (plan.floor > 0) cut(plan, area, exact, 0, plan.bottom);
  }
  return true;
}

void AreaCutter::cut(const MillPlan& plan, const MillArea& area, const std::vector<Loop>& loops,
                     double infeed, double bottom) {
  const double whole = bottom - plan.reference;
  const int n = steps_of(std::abs(whole), infeed);
  double from = plan.safe;
  mover_.rapid(area.entry);
  mover_.rapid_height(plan.safe);
  for (int i = 1; i <= n; ++i) {
    const double to = i == n ? bottom : plan.reference + whole * i / n;
    descend(plan, area, from, to);
    for (const Loop& loop : loops) {
      mover_.line(loop.front().start, plan.feed);
      mover_.loop(loop, plan.feed);
    }
    from = to + (plan.safe - plan.reference);
    mover_.rapid_height(i == n ? plan.top : from);
    mover_.rapid(area.entry);
  }
}

void AreaCutter::descend(const MillPlan& plan, const MillArea& area, double from, double to) {
  if (plan.entry == MillEntry::rapid) return mover_.rapid_height(to);
  const double radius = std::min(plan.helix_radius, area.helix_room);
  if (plan.entry == MillEntry::swing && area.swing_room > kNoRoom)
    return swing_down(plan, area, from, to);
  if (plan.entry != MillEntry::helix || radius < kNoRoom)
    return mover_.line_height(to, plan.plunge);
  const double deep = std::abs(to - from);
  PlanePiece turn;
  turn.arc = true;
  turn.center = area.entry;
  turn.radius = radius;
  const Vec2 start = area.entry + Vec2{radius, 0};
  const double turns = plan.helix_lead > 0 ? deep / plan.helix_lead : 1;
  const double sweep = 2 * kPi * std::min(turns, kMostTurns) * (plan.clockwise ? -1 : 1);
  const SinCos sc = sincos(sweep);
  mover_.line(start, plan.feed);
  turn.sweep = sweep;
  turn.start = start;
  turn.end = area.entry + Vec2{radius * sc.cos, radius * sc.sin};
  mover_.piece(turn, to - from, plan.plunge);
  turn.sweep = plan.clockwise ? -2 * kPi : 2 * kPi;
  turn.start = turn.end;
  mover_.piece(turn, 0, plan.feed);
  mover_.line(area.entry, plan.feed);
}

// Swings along the middle, at most as steep as the cycle allows.
void AreaCutter::swing_down(const MillPlan& plan, const MillArea& area, double from, double to) {
  const SinCos sc = sincos_deg(area.swing_direction);
  const SinCos slope =
      sincos_deg(plan.swing_angle > 0 ? std::min(plan.swing_angle, kLargestSwing) : kUsualSwing);
  const Vec2 aside = area.swing_room * Vec2{sc.cos, sc.sin};
  const int n = steps_of(std::abs(to - from), 2 * area.swing_room * slope.sin / slope.cos);
  mover_.line(area.entry - aside, plan.feed);
  double side = 1;
  for (int i = 1; i <= n; ++i, side = -side)
    mover_.slope(area.entry + side * aside, from + (to - from) * i / n, plan.plunge);
  mover_.line(area.entry + side * aside, plan.feed);
  mover_.line(area.entry, plan.feed);
}

void AreaCutter::tracks(const MillPlan& plan, const std::vector<std::pair<Vec2, Vec2>>& lines,
                        bool one_way) {
  const double up = plan.bottom < plan.reference ? 1 : -1;
  const double bottom = plan.bottom + (plan.rough && !plan.finish ? up * plan.floor : 0);
  const double first = plan.rough ? plan.reference : plan.bottom + up * plan.floor;
  const int n = plan.rough ? steps_of(std::abs(bottom - first), plan.infeed) : 1;
  const double clear = plan.safe - plan.reference;
  mover_.rapid_height(plan.top);
  for (int i = 1; i <= n; ++i) {
    const double level = i == n ? bottom : first + (bottom - first) * i / n;
    mover_.rapid(lines.front().first);
    if (i == 1) mover_.rapid_height(plan.safe);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const bool back = !one_way && k % 2 == 1;
      if (one_way && k > 0) {
        mover_.rapid_height(level + clear);
        mover_.rapid(lines[k].first);
      }
      if (one_way || k == 0) mover_.line_height(level, plan.plunge);
      mover_.line(back ? lines[k].second : lines[k].first, plan.feed);
      mover_.line(back ? lines[k].first : lines[k].second, plan.feed);
    }
    mover_.rapid_height(i == n ? plan.top : level + clear);
  }
}

}  // namespace mrsim
