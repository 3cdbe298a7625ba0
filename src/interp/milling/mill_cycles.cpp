#include "interp/milling/mill_cycles.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::array<std::string_view, 13> kMillCycles = {
    "POCKET1", "POCKET2", "POCKET3", "POCKET4", "SLOT1",    "SLOT2",  "LONGHOLE",
    "CYCLE61", "CYCLE71", "CYCLE76", "CYCLE77", "CYCLE899", "CYCLE90"};
constexpr double kMostSlots = 10'000;

Vec2 turned(Vec2 p, double degrees) {
  const SinCos sc = sincos_deg(degrees);
  return {p.x * sc.cos - p.y * sc.sin, p.x * sc.sin + p.y * sc.cos};
}

// The distance between two equal straight slots along radii of a circle, from middle line to middle
// line. These begin and end at the radii `inner` and `outer`.
double between_radial(double inner, double outer, double degrees) {
  if (inner <= 0 && outer >= 0) return 0;  // they cross in the centre
  const auto from_first = [&](double radius) {
    const Vec2 end = polar(radius, degrees);
    return length(end - Vec2{std::clamp(end.x, inner, outer), 0});
  };
  return std::min(from_first(inner), from_first(outer));
}

// The same for two slots along one circle, each of them `angle` long (radians).
double between_arcs(double radius, double angle, double degrees) {
  const double gap = std::abs(std::remainder(radians(degrees), 2 * kPi)) - angle;
  return gap <= 0 ? 0 : 2 * radius * sincos(gap / 2).sin;
}

}  // namespace

bool MillCycles::knows(std::string_view name) {
  return std::find(kMillCycles.begin(), kMillCycles.end(), name) != kMillCycles.end();
}

bool MillCycles::run(const CycleCall& call, const Word& where, bool at_position) {
  if (!begin(call, where, at_position)) return false;
  if (call.name == "POCKET1" || call.name == "POCKET3") return rectangle();
  if (call.name == "POCKET2" || call.name == "POCKET4") return circle();
  if (call.name == "SLOT1" || call.name == "LONGHOLE") return slots();
  if (call.name == "SLOT2") return arc_slots();
  if (call.name == "CYCLE76" || call.name == "CYCLE77") return spigot();
  if (call.name == "CYCLE899") return open_slot();
  return call.name == "CYCLE90" ? thread() : face();
}

bool MillCycles::clear(const MillPlan& plan, const MillArea& area) {
  return cutter_.clear(plan, area) ||
         fail("value-range", fmt::format("more than {} loops", AreaCutter::kMostLoops));
}

std::vector<Loop> MillCycles::nested(const MillPlan& plan, double last, Vec2 at, double degrees,
                                     const std::function<Loop(double)>& make) {
  last = std::max(0.0, last);
  const int n = last < kRounding ? 0 : steps_of(last, plan.width);
  std::vector<Loop> loops;
  for (int k = 0; k <= n; ++k) {
    const Loop loop = make(n == 0 ? 0 : last * k / n);
    if (!loop.empty())
      loops.push_back(transformed(plan.clockwise ? reversed(loop) : loop, at, degrees));
  }
  return loops;
}

// Whether a rectangle of this smaller side, in mm, can have the corners of CRAD.
bool MillCycles::has_corner(double side) {
  const double unit = scale(), corner = std::abs(value("CRAD")) * unit;
  return corner <= side / 2 + kPosted ||
         fail(
             "value-range",
             fmt::format("{}: the corner radius CRAD of {:g} is more than half of the smaller side "
                         "(alarm 61113): write {:g} at most",
                         call_->shown(), corner / unit, side / 2 / unit));
}

bool MillCycles::rectangle() {
  MillPlan plan;
  if (!read_plan(plan)) return false;
  const double unit = scale(), degrees = call_->name == "POCKET1" ? value("STA1") : value("STA");
  double length = value("LENG") * unit, width = value("WID") * unit, turn = degrees;
  if (length <= 0 || width <= 0)
    return fail("value-range", "the length and the width of a pocket must be above 0");
  Vec2 at;
  if (!center(length, width, degrees, at)) return false;
  if (width > length) {
    std::swap(length, width);
    turn += 90;
  }
  const double a = length / 2 - radius_, b = width / 2 - radius_;
  if (!has_corner(width)) return false;
  const double corner = std::min(std::abs(value("CRAD")) * unit, width / 2);
  const double round = std::max(0.0, corner - radius_);
  if (b - plan.side < -kRounding)
    return fail("value-range", "the cutter is too large for the pocket (alarm 61105)");
  MillArea area;
  area.entry = at;
  area.swing_direction = turn;
  area.swing_room = a - b;
  area.helix_room = b;
  area.loops = [=](double aside) {
    return nested(plan, b - aside, at, turn, [=](double half) {
      const double in = b - half;
      return rounded_rectangle(a - in, half, std::min(std::max(0.0, round - in), half));
    });
  };
  return clear(plan, area);
}

bool MillCycles::circle() {
  MillPlan plan;
  Vec2 at;
  if (!read_plan(plan) || !reference_point(at)) return false;
  if (call_->name == "POCKET4" && value("DMODE") >= 100)
    return fail("not-supported",
                "POCKET4 with a DMODE of 100 and more, by which its fifth value may be a diameter, "
                "is not supported yet: write the list up to DP1, with a radius");
  if (value("PRAD") < 0) return fail("value-range", "the radius PRAD of a pocket has no sign");
  const double reach = value("PRAD") * scale() - radius_;
  if (reach - plan.side < -kRounding)
    return fail("value-range", "the cutter is too large for the pocket (alarm 61105)");
  MillArea area;
  area.entry = at;
  area.helix_room = reach;
  area.loops = [=](double aside) { return nested(plan, reach - aside, at, 0, circle_loop); };
  return clear(plan, area);
}

int MillCycles::count(double& first, double& step, double whole) {
  const double number = call_->get("NUM", 1);
  if (number < 1 || number > kMostSlots) return 0;
  const int n = static_cast<int>(number);
  first = value("STA1");
  step = value("INDA");
  if (step == 0) step = whole / n;
  return n;
}

// Warns if slots of the pattern run into one another. `between` gives the distance of the first
// slot and the one `i` places behind it; any two slots so far apart in the pattern have the same.
void MillCycles::tell_overlap(int count, double width, const std::function<double(int)>& between) {
  for (int i = 1; i < count; ++i) {
    if (between(i) >= width - kPosted) continue;
    return warn_once(
        "slots-overlap",
        fmt::format("{0}: slots of the pattern run into one another, where the control "
                    "may stop with alarm 61104: check NUM, INDA, RAD and the size of "
                    "the slots",
                    call_->shown()));
  }
}

// Slots along the radii of a circle, with their inner ends on it. Those of LONGHOLE are as wide as
// the cutter.
bool MillCycles::slots() {
  MillPlan plan;
  Vec2 middle;
  if (!read_plan(plan) || !reference_point(middle)) return false;
  double first = 0, step = 0;
  const int n = count(first, step, 360);
  const double unit = scale(), length = std::abs(value("LENG")) * unit;
  const double width = !call_->lists("WID") ? 2 * radius_ : std::abs(value("WID")) * unit;
  const double b = width / 2 - radius_, a = length / 2 - radius_;
  const int from = call_->digit("GMODE", 3);
  if (n == 0 || from > 5) return fail("value-range", "the number of slots is 1 to 10000");
  if (b - plan.side < -kRounding || length < width)
    return fail("value-range", "the cutter is too large for the slot (alarm 61105)");
  // The centre of the slot: behind its inner end, or as GMODE says.
  static constexpr double kEnd[] = {1, 0, 1, -1, 1, -1};
  const double inset = from == 2 || from == 3 ? width / 2 : 0;
  const double out = std::abs(value("RAD")) * unit + kEnd[from] * (length / 2 - inset);
  const double reach = (length - width) / 2;
  tell_overlap(n, width, [=](int i) { return between_radial(out - reach, out + reach, i * step); });
  for (int i = 0; i < n; ++i) {
    const double turn = first + i * step;
    MillArea area;
    area.entry = middle + polar(out, turn);
    area.swing_direction = turn;
    area.swing_room = a - b;
    const Vec2 at = area.entry;
    area.loops = [=](double aside) {
      return nested(plan, b - aside, at, turn,
                    [=](double half) { return rounded_rectangle(a - b + half, half, half); });
    };
    if (!clear(plan, area)) return false;
  }
  return true;
}

// Slots along a circle. AFSL is the angle between the centres of their ends.
bool MillCycles::arc_slots() {
  MillPlan plan;
  Vec2 middle;
  if (!read_plan(plan) || !reference_point(middle)) return false;
  double first = 0, step = 0;
  const int n = count(first, step, 360);
  const double unit = scale(), round = std::abs(value("RAD")) * unit;
  const double b = std::abs(value("WID")) * unit / 2 - radius_;
  const double angle = radians(std::abs(value("AFSL")));
  if (n == 0) return fail("value-range", "the number of slots is 1 to 10000");
  if (b - plan.side < -kRounding)
    return fail("value-range", "the cutter is too large for the slot (alarm 61105)");
  if (angle <= 0 || angle > 2 * kPi || b >= round)
    return fail("value-range", "AFSL is an angle up to 360 and RAD larger than half the width");
  tell_overlap(n, std::abs(value("WID")) * unit,
               [=](int i) { return between_arcs(round, angle, i * step); });
  for (int i = 0; i < n; ++i) {
    const double turn = first + i * step;
    MillArea area;
    area.entry = middle + polar(round, turn);
    area.loops = [=](double aside) {
      return nested(plan, b - aside, middle, turn,
                    [=](double half) { return arc_slot(round, angle, half); });
    };
    if (!clear(plan, area)) return false;
  }
  return true;
}

// CYCLE76 and CYCLE77: loops from the blank inwards. The tool goes down outside of the blank.
bool MillCycles::spigot() {
  MillPlan plan;
  if (!read_plan(plan)) return false;
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
  if (!round && !has_corner(std::min(length, width))) return false;
  if (!round && (value("LENG") < 0 || value("WID") < 0))
    return fail("not-supported",
                "CYCLE76: a length below 0 counts from a corner (_ZSD[2]), which is not supported: "
                "write the centre and lengths above 0");
  Vec2 at;
  if (!(round ? reference_point(at) : center(length, width, degrees, at))) return false;
  const double aside0 = std::max(blank_length - length, blank_width - width) / 2;
  // The corners of a rectangular blank lie farther out than its sides.
  const double reach = round ? aside0 : aside0 * 1.4143 + 0.4143 * corner;
  MillArea area;
  const double out = length / 2 + reach + 2 * radius_ + std::abs(plan.safe - plan.reference);
  area.entry = at + turned({out, 0}, degrees);
  const int direction = static_cast<int>(value("CDIR"));
  const bool opposite = direction == 1 || direction == 3;  // climbing goes clockwise outside
  area.loops = [=, r = radius_](double aside) {
    const double most = std::max(0.0, reach - aside);
    std::vector<Loop> loops;
    for (int n = steps_of(most, plan.width), k = n - 1; k >= 0; --k) {
      const double d = aside + most * k / n + r;
      const Loop loop = round ? circle_loop(length / 2 + d)
                              : rounded_rectangle(length / 2 + d, width / 2 + d, corner + d);
      loops.push_back(transformed(opposite ? loop : reversed(loop), at, degrees));
    }
    return loops;
  };
  return clear(plan, area);
}

// CYCLE71 has length, width and angle; LIM of CYCLE61 keeps the cutter inside of edges.
bool MillCycles::face() {
  MillPlan plan;
  Vec2 corner;
  if (!read_plan(plan) || !reference_point(corner)) return false;
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
  // Coordinates in the face count from its lower left corner.
  const double lu = std::abs(along_v ? width : length), lv = std::abs(along_v ? length : width);
  const auto limit = [&](bool second, bool high) {
    const int digit = (second ? 2 : 0) + (high ? 1 : 0);
    return !old && call_->digit("LIM", digit) == 1;
  };
  const double out = radius_ + std::abs(plan.safe - plan.reference);
  const double u0 = limit(along_v, false) ? radius_ : -out - (old ? value("FDP1") * unit : 0);
  const double u1 =
      limit(along_v, true) ? lu - radius_ : lu + out + (old ? value("FDP") * unit : 0);
  const double v0 = limit(!along_v, false) ? radius_ : 0;
  const double v1 = limit(!along_v, true) ? lv - radius_ : lv;
  if (u1 <= u0 || v1 < v0) return fail("value-range", "the cutter is too large for the face");
  const bool shut = v0 > 0 || v1 < lv;
  const int n = steps_of(v1 - v0, plan.width) + (shut ? 1 : 0);
  const Vec2 low{std::min(length, 0.0), std::min(width, 0.0)};
  const auto at = [&](double u, double v) {
    return corner + turned(low + (along_v ? Vec2{v, u} : Vec2{u, v}), degrees);
  };
  std::vector<std::pair<Vec2, Vec2>> lines;
  for (int i = 0; i < n; ++i) {
    const double v = shut ? v0 + (v1 - v0) * i / (n - 1) : v0 + (v1 - v0) * (i + 0.5) / n;
    lines.emplace_back(at(u0, v), at(u1, v));
  }
  cutter_.tracks(plan, lines, one_way);
  return true;
}

// CYCLE899: a slot that is open at both ends, cut in lines side by side.
bool MillCycles::open_slot() {
  MillPlan plan;
  Vec2 at;
  if (!read_plan(plan) || !reference_point(at)) return false;
  if (call_->digit("GMODE", 3) > 1)
    return fail("not-supported", "CYCLE899: a reference point other than the centre");
  const double unit = scale(), length = std::abs(value("LENG")) * unit;
  const double b = std::abs(value("WID")) * unit / 2 - radius_ - (plan.finish ? 0 : plan.side);
  if (length <= 0 || b < -kRounding)
    return fail("value-range", "the cutter is too large for the slot (alarm 61105)");
  const double half = length / 2 + radius_ + std::abs(plan.safe - plan.reference);
  const int n = b < kRounding ? 0 : steps_of(2 * b, plan.width);
  const auto point = [&](double u, double v) { return at + turned({u, v}, value("STA")); };
  std::vector<std::pair<Vec2, Vec2>> lines;
  for (int i = 0; i <= n; ++i) {
    const double v = n == 0 ? 0 : -b + 2 * b * i / n;
    lines.emplace_back(point(-half, v), point(half, v));
  }
  cutter_.tracks(plan, lines, false);
  return true;
}

// CYCLE90: a helix with the pitch of the thread, from above the face to the depth. It cuts to the
// nominal diameter of an inside thread, and to the core of an outside one.
bool MillCycles::thread() {
  MillPlan plan;
  Vec2 at;
  if (!depth(plan) || !reference_point(at)) return false;
  const double unit = scale(), pitch = std::abs(call_->get("PIT")) * unit;
  const bool outside = call_->get("TYPTH") == 1;
  const double nominal = std::abs(call_->get("DIATH")) * unit / 2;
  const double wall =
      outside ? std::abs(call_->get("KDIAM")) * unit / 2 + radius_ : nominal - radius_;
  if (pitch <= 0) return fail("thread-lead", "CYCLE90 needs the pitch of the thread, PIT");
  if (wall <= kRounding) return fail("value-range", "the cutter is too large for the thread");
  const double feed = value("FFR") * feed_scale();
  const double down = plan.bottom < plan.reference ? -1 : 1;
  // The helix has whole turns, so that it begins above the face.
  const double turns = std::ceil(std::abs(plan.bottom - plan.safe) / pitch);
  if (turns > 1e5) return fail("value-range", "more than 100000 turns");
  PlanePiece helix;
  helix.arc = true;
  helix.center = at;
  helix.radius = wall;
  helix.start = helix.end = at + Vec2{wall, 0};
  helix.sweep = 2 * kPi * turns * (call_->get("CDIR") == 2 ? -1 : 1);
  const Vec2 rest = outside ? at + Vec2{wall + nominal + radius_, 0} : at;
  mover_.rapid_height(plan.top);
  mover_.rapid(rest);
  mover_.rapid_height(plan.bottom - down * turns * pitch);
  mover_.line(helix.start, feed);
  mover_.piece(helix, down * turns * pitch, feed);
  mover_.line(rest, feed);
  mover_.rapid_height(plan.top);
  return true;
}

}  // namespace mrsim
