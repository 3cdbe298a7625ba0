#include "interp/milling/mill_values.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

// Loops no farther apart than this share of the radius leave nothing between them, not even where
// a corner is sharp: the square root of 2, a little less.
constexpr double kWidest = 1.4;

}  // namespace

Vec2 polar(double radius, double degrees) {
  const SinCos sc = sincos_deg(degrees);
  return {radius * sc.cos, radius * sc.sin};
}

bool MillValues::begin(const CycleCall& call, const Word& where, bool at_position) {
  call_ = &call;
  where_ = where;
  at_position_ = at_position;
  mover_.begin(where);
  if (modal_.comp != Code::comp_off)
    return fail("cycle-compensation", "a milling cycle under radius compensation: G40 before it");
  if (std::abs(plane_factor() - 1) > kTurnRounding)
    return fail("not-supported",
                "a milling cycle under a scale: whether the control scales the cutter's radius, "
                "too, is not known; write the sizes that are to be cut");
  radius_ = tools_.radius_for(call.shown(), modal_.edge, where_);
  return radius_ > 0;
}

void MillValues::warn_once(const char* code, const std::string& text) {
  reporter_.once(Severity::warning, code, text, where_,
                 fmt::format("{}:{}:{}", code, call_->place.file, call_->place.line));
}

bool MillValues::depth(MillPlan& plan) {
  const auto planes = cycle_planes(*call_, call_->digit("AMODE", 0), scale());
  if (!planes)
    return fail("value-missing",
                fmt::format("{} needs RTP, RFP and DP, its planes and its depth", call_->shown()));
  if (!planes->cuts())
    return fail("value-range",
                fmt::format("{}: the depth does not lie below the reference plane (alarm 61101)",
                            call_->shown()));
  plan.top = planes->top;
  plan.reference = planes->reference;
  plan.safe = planes->safe;
  plan.bottom = planes->bottom;
  return true;
}

// The unit of VARI says what is cut, and its ten how the tool goes down. POCKET1, POCKET2 and slots
// have 0, both roughing and finishing.
bool MillValues::modes(MillPlan& plan) {
  const double vari = call_->name == "LONGHOLE" ? 0 : value("VARI");  // its VARI is not read
  const int kind = static_cast<int>(vari) % 10;
  if (kind == 5 && !chamfer(plan)) return false;
  plan.rough = kind <= 1;
  plan.finish = kind != 1;
  if (kind == 0) plan.rough = plan.finish = true;
  if (kind >= 4) plan.floor = 0;
  const int entry = static_cast<int>(vari) / 10 % 10;
  if (call_->lists("RAD1")) {
    if (entry > 3) return fail("value-range", "the way of going down is 0 to 3");
    plan.entry = static_cast<MillEntry>(entry);
    plan.helix_radius = value("RAD1") * scale();
    plan.helix_lead = value("DP1") * scale();
    plan.swing_angle = value("RAD1");  // under MillEntry::swing it is an angle
  } else if (call_->name == "SLOT1" && entry == 3) {
    plan.entry = MillEntry::swing;
    plan.swing_angle = std::abs(value("STA2"));
  }
  const int direction = static_cast<int>(value("CDIR"));
  plan.clockwise = direction == 1 || direction == 2;
  return true;
}

// A chamfer is one cut along the wall, FS wide, with the tip of the tool at ZFS (by AMODE a level,
// or a depth below the edge).
bool MillValues::chamfer(MillPlan& plan) {
  if (!call_->lists("FS"))
    return fail("not-supported",
                fmt::format("{}: chamfering is not supported yet", call_->shown()));
  const auto cut =
      chamfering_.cut(*call_, plan.reference, plan.top < plan.reference ? 1 : -1, where_);
  if (!cut) return false;
  radius_ = cut->aside;
  plan.bottom = cut->bottom;
  plan.infeed = plan.finish_infeed = plan.side = 0;
  return true;
}

bool MillValues::read_plan(MillPlan& plan) {
  if (!depth(plan)) return false;
  const double unit = scale();
  plan.infeed = std::abs(value("MID")) * unit;
  plan.finish_infeed = std::abs(value("MIDF")) * unit;
  plan.side = std::abs(value("FAL")) * unit;
  plan.floor = std::abs(value("FALD")) * unit;
  plan.feed = value("FFP1") * feed_scale();
  plan.plunge = value("FFD") * feed_scale();
  if (plan.plunge <= 0) plan.plunge = plan.feed;
  double width = std::abs(value("MIDA")) * unit;
  if (call_->digit("AMODE", 1) == 1)
    width = width / unit * radius_ / 50;  // per cent of the diameter
  plan.width = width > 0 ? std::clamp(width, 0.02 * radius_, kWidest * radius_) : kWidest * radius_;
  if (plan.feed < 0 || plan.plunge < 0) return fail("feed-range", "the feeds must be above 0");
  if (std::abs(plan.bottom - plan.reference) <= plan.floor)
    return fail("value-range", "the allowance at the floor is larger than the depth");
  return modes(plan);
}

// The reference point is PA PO or CPA CPO; where MCALL runs the cycle, it is the place of the tool.
bool MillValues::reference_point(Vec2& out) {
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

// GMODE says whether the reference point is the centre, a corner or an end.
bool MillValues::center(double length, double width, double degrees, Vec2& out) {
  if (!reference_point(out)) return false;
  const int from = call_->digit("GMODE", 3);
  if (from > 5) return fail("value-range", "GMODE: the reference point is 0 to 5");
  if (from < 2) return true;
  const double x = from % 2 == 0 ? 0.5 : -0.5, y = from < 4 ? 0.5 : -0.5;
  const Vec2 along = polar(x * length, degrees), across = polar(y * width, degrees + 90);
  out = out + along + across;
  return true;
}

}  // namespace mrsim
