// What the values of a milling cycle mean, and the areas that they describe.
#include "interp/milling/mill_cycles.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "interp/cycles/cycle_planes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

// Loops no farther apart than this share of the radius leave nothing between them, not even where
// a corner is sharp: the square root of 2, a little less.
constexpr double kWidest = 1.4;
constexpr std::array<std::string_view, 13> kMillCycles = {
    "POCKET1", "POCKET2", "POCKET3", "POCKET4", "SLOT1",    "SLOT2",  "LONGHOLE",
    "CYCLE61", "CYCLE71", "CYCLE76", "CYCLE77", "CYCLE899", "CYCLE90"};
constexpr double kMostSlots = 10'000;

Vec2 polar(double radius, double degrees) {
  const SinCos sc = sincos_deg(degrees);
  return {radius * sc.cos, radius * sc.sin};
}

}  // namespace

bool MillCycles::knows(std::string_view name) {
  return std::find(kMillCycles.begin(), kMillCycles.end(), name) != kMillCycles.end();
}

bool MillCycles::run(const CycleCall& call, const Word& where, bool at_position) {
  call_ = &call;
  where_ = where;
  at_position_ = at_position;
  mover_.begin(where);
  if (modal_.comp != Code::comp_off)
    return fail("cycle-compensation", "a milling cycle under radius compensation: G40 before it");
  radius_ = tools_.radius_for(call.shown(), modal_.edge, where_);
  if (radius_ <= 0) return false;
  if (call.name == "POCKET1" || call.name == "POCKET3") return rectangle();
  if (call.name == "POCKET2" || call.name == "POCKET4") return circle();
  if (call.name == "SLOT1" || call.name == "LONGHOLE") return slots();
  if (call.name == "SLOT2") return arc_slots();
  if (call.name == "CYCLE76" || call.name == "CYCLE77") return spigot();
  if (call.name == "CYCLE899") return open_slot();
  return call.name == "CYCLE90" ? thread() : face();
}

bool MillCycles::depth(Levels& l) {
  const auto planes = cycle_planes(*call_, call_->digit("AMODE", 0), scale());
  if (!planes)
    return fail("value-missing",
                fmt::format("{} needs RTP, RFP and DP, its planes and its depth", call_->shown()));
  if (!planes->cuts())
    return fail("value-range",
                fmt::format("{}: the depth does not lie below the reference plane (alarm 61101)",
                            call_->shown()));
  l.top = planes->top;
  l.reference = planes->reference;
  l.safe = planes->safe;
  l.bottom = planes->bottom;
  return true;
}

// The unit of MODE says what is cut, its ten how the tool goes down; POCKET1, POCKET2 and slots
// know 0, both roughing and finishing.
bool MillCycles::modes(Levels& l) {
  const double vari = call_->name == "LONGHOLE" ? 0 : value("VARI");  // there it is not read
  const int kind = static_cast<int>(vari) % 10;
  if (kind == 5 && !chamfer(l)) return false;
  l.rough = kind <= 1;
  l.finish = kind != 1;
  if (kind == 0) l.rough = l.finish = true;
  if (kind >= 4) l.floor = 0;
  l.entry = static_cast<int>(vari) / 10 % 10;
  if (!call_->lists("RAD1")) l.entry = call_->name == "SLOT1" && l.entry == 3 ? 3 : 1;
  if (l.entry > 3) return fail("value-range", "the way of going down is 0 to 3");
  l.helix = value("RAD1");
  l.helix_lead = (call_->lists("RAD1") ? value("DP1") : 0) * scale();
  const int direction = static_cast<int>(value("CDIR"));
  l.clockwise = direction == 1 || direction == 2;
  return true;
}

// FS wide, the tip of the tool at ZFS (AMODE: absolute, or below the edge): one cut along the wall.
bool MillCycles::chamfer(Levels& l) {
  if (!call_->lists("FS"))
    return fail("not-supported",
                fmt::format("{}: chamfering is not supported yet", call_->shown()));
  const auto cut = chamfering_.cut(*call_, l.reference, l.top < l.reference ? 1 : -1, where_);
  if (!cut) return false;
  radius_ = cut->aside;
  l.bottom = cut->bottom;
  l.infeed = l.finish_infeed = l.side = 0;
  return true;
}

bool MillCycles::levels(Levels& l) {
  if (!depth(l)) return false;
  const double unit = scale();
  l.infeed = std::abs(value("MID")) * unit;
  l.finish_infeed = std::abs(value("MIDF")) * unit;
  l.side = std::abs(value("FAL")) * unit;
  l.floor = std::abs(value("FALD")) * unit;
  l.feed = value("FFP1") * feed_scale();
  l.plunge = value("FFD") * feed_scale();
  if (l.plunge <= 0) l.plunge = l.feed;
  double width = std::abs(value("MIDA")) * unit;
  if (call_->digit("AMODE", 1) == 1)
    width = width / unit * radius_ / 50;  // per cent of the diameter
  l.width = width > 0 ? std::clamp(width, 0.02 * radius_, kWidest * radius_) : kWidest * radius_;
  if (l.feed < 0 || l.plunge < 0) return fail("feed-range", "the feeds must be above 0");
  if (std::abs(l.bottom - l.reference) <= l.floor)
    return fail("value-range", "the allowance at the floor is larger than the depth");
  return modes(l);
}

// PA PO or CPA CPO; by MCALL without them the place of the tool.
bool MillCycles::reference_point(Vec2& out) {
  const bool center = call_->lists("CPA");
  const ValueName u = center ? ValueName("CPA") : ValueName("PA");
  const ValueName v = center ? ValueName("CPO") : ValueName("PO");
  out = {value(u) * scale(), value(v) * scale()};
  const bool given = value(u) != 0 || value(v) != 0;
  if (at_position_ && given)
    return fail("not-supported",
                fmt::format("MCALL {} with a place of its own is not supported yet", call_->name));
  if (at_position_ || (!call_->given(u) && !call_->given(v))) out = mover_.position();
  return true;
}

// The centre, where a corner or an end is given.
bool MillCycles::center(double length, double width, double degrees, Vec2& out) {
  if (!reference_point(out)) return false;
  const int from = call_->digit("GMODE", 3);
  if (from > 5) return fail("value-range", "GMODE: the reference point is 0 to 5");
  if (from < 2) return true;
  const double x = from % 2 == 0 ? 0.5 : -0.5, y = from < 4 ? 0.5 : -0.5;
  const Vec2 along = polar(x * length, degrees), across = polar(y * width, degrees + 90);
  out = out + along + across;
  return true;
}

std::vector<Loop> MillCycles::nested(const Levels& l, double last, Vec2 at, double degrees,
                                     const std::function<Loop(double)>& make) {
  last = std::max(0.0, last);
  const int n = last < kRounding ? 0 : steps_of(last, l.width);
  std::vector<Loop> loops;
  for (int k = 0; k <= n; ++k) {
    const Loop loop = make(n == 0 ? 0 : last * k / n);
    if (!loop.empty())
      loops.push_back(transformed(l.clockwise ? reversed(loop) : loop, at, degrees));
  }
  return loops;
}

bool MillCycles::rectangle() {
  Levels l;
  if (!levels(l)) return false;
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
  const double corner = std::min(std::abs(value("CRAD")) * unit, width / 2);
  const double round = std::max(0.0, corner - radius_);
  if (b - l.side < -kRounding)
    return fail("value-range", "the cutter is too large for the pocket (alarm 61105)");
  Area area;
  area.entry = at;
  area.degrees = turn;
  area.swing = a - b;
  area.helix = b;
  area.loops = [=](double aside) {
    return nested(l, b - aside, at, turn, [=](double half) {
      const double in = b - half;
      return rounded_rectangle(a - in, half, std::min(std::max(0.0, round - in), half));
    });
  };
  return clear(l, area);
}

bool MillCycles::circle() {
  Levels l;
  Vec2 at;
  if (!levels(l) || !reference_point(at)) return false;
  if (call_->name == "POCKET4" && value("DMODE") >= 100)
    return fail("not-supported",
                "POCKET4 with a DMODE of 100 and more, by which its fifth value may be a diameter, "
                "is not supported yet: write the list up to DP1, with a radius");
  const double reach = std::abs(value("PRAD")) * scale() - radius_;
  if (reach - l.side < -kRounding)
    return fail("value-range", "the cutter is too large for the pocket (alarm 61105)");
  Area area;
  area.entry = at;
  area.helix = reach;
  area.loops = [=](double aside) { return nested(l, reach - aside, at, 0, circle_loop); };
  return clear(l, area);
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

// Slots along the radii of a circle, their inner ends on it; LONGHOLE's are as wide as the cutter.
bool MillCycles::slots() {
  Levels l;
  Vec2 middle;
  if (!levels(l) || !reference_point(middle)) return false;
  double first = 0, step = 0;
  const int n = count(first, step, 360);
  const double unit = scale(), length = std::abs(value("LENG")) * unit;
  const double width = !call_->lists("WID") ? 2 * radius_ : std::abs(value("WID")) * unit;
  const double b = width / 2 - radius_, a = length / 2 - radius_;
  const int from = call_->digit("GMODE", 3);
  if (n == 0 || from > 5) return fail("value-range", "the number of slots is 1 to 10000");
  if (b - l.side < -kRounding || length < width)
    return fail("value-range", "the cutter is too large for the slot (alarm 61105)");
  if (call_->name == "SLOT1") l.helix = std::abs(value("STA2"));  // the angle of swinging
  // The centre of the slot: behind its inner end, or as GMODE says.
  static constexpr double kEnd[] = {1, 0, 1, -1, 1, -1};
  const double inset = from == 2 || from == 3 ? width / 2 : 0;
  const double out = std::abs(value("RAD")) * unit + kEnd[from] * (length / 2 - inset);
  for (int i = 0; i < n; ++i) {
    const double turn = first + i * step;
    Area area;
    area.entry = middle + polar(out, turn);
    area.degrees = turn;
    area.swing = a - b;
    const Vec2 at = area.entry;
    area.loops = [=](double aside) {
      return nested(l, b - aside, at, turn,
                    [=](double half) { return rounded_rectangle(a - b + half, half, half); });
    };
    if (!clear(l, area)) return false;
  }
  return true;
}

// Slots along a circle; AFSL is the angle between the centres of their ends.
bool MillCycles::arc_slots() {
  Levels l;
  Vec2 middle;
  if (!levels(l) || !reference_point(middle)) return false;
  double first = 0, step = 0;
  const int n = count(first, step, 360);
  const double unit = scale(), round = std::abs(value("RAD")) * unit;
  const double b = std::abs(value("WID")) * unit / 2 - radius_;
  const double angle = radians(std::abs(value("AFSL")));
  if (n == 0) return fail("value-range", "the number of slots is 1 to 10000");
  if (b - l.side < -kRounding)
    return fail("value-range", "the cutter is too large for the slot (alarm 61105)");
  if (angle <= 0 || angle > 2 * kPi || b >= round)
    return fail("value-range", "AFSL is an angle up to 360 and RAD larger than half the width");
  for (int i = 0; i < n; ++i) {
    const double turn = first + i * step;
    Area area;
    area.entry = middle + polar(round, turn);
    area.loops = [=](double aside) {
      return nested(l, b - aside, middle, turn,
                    [=](double half) { return arc_slot(round, angle, half); });
    };
    if (!clear(l, area)) return false;
  }
  return true;
}

}  // namespace mrsim
