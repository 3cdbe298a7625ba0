#include "interp/milling/mill_values.h"

#include "core/numbers/trig.h"
#include "interp/cycles/cycle_planes.h"

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
  radius_ = tools_.radius_for(call.shown(), modal_.edge, where_);
  return radius_ > 0;
}

bool MillValues::depth(MillLevels& l) {
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

// The unit of VARI says what is cut, and its ten how the tool goes down. POCKET1, POCKET2 and slots
// have 0, both roughing and finishing.
bool MillValues::modes(MillLevels& l) {
  const double vari = call_->name == "LONGHOLE" ? 0 : value("VARI");  // its VARI is not read
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

// A chamfer is one cut along the wall, FS wide, with the tip of the tool at ZFS (by AMODE a level,
// or a depth below the edge).
bool MillValues::chamfer(MillLevels& l) {
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

bool MillValues::levels(MillLevels& l) {
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
