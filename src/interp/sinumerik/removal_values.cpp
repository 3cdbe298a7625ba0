#include "interp/sinumerik/removal_values.h"

#include "core/numbers/rounding.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr int kAlongZ = 1, kAlongX = 2, kAlongContour = 3;
constexpr int kBlankCylinder = 1, kBlankContour = 3;

double value_farthest(const std::vector<Motion>& contour, int axis, double sense) {
  double far = component(contour.front().end, axis);
  for (const Motion& m : contour)
    if ((component(m.end, axis) - far) * sense > 0) far = component(m.end, axis);
  return far;
}

}  // namespace

std::optional<RemovalPlan> RemovalValues::read() {
  RemovalPlan out;
  if (!(call_.name == "CYCLE952" ? removal_modes(out) : turn_modes(out))) return std::nullopt;
  out.contour = std::move(contour_);
  return out;
}

// The values of CYCLE952: PRG CON CONR VARI F FR RP D DX DZ UX UZ U U1 BL XD ZD XA ZA XB ZB XDA XDB
// N DP DI SC DN GMODE DMODE AMODE PK DCH FS.
bool RemovalValues::removal_values() {
  const auto refuse = [&](const char* what) {
    return error("not-supported", fmt::format("CYCLE952: {} is not supported yet", what), where_);
  };
  if (!call_.given("VARI"))
    return error("value-missing", "CYCLE952 needs VARI, how it cuts", where_);
  if (call_.values.size() > 34) return refuse("a list of more than 34 values");
  if (call_.digit("DMODE", 1) > 1)
    return refuse("grooving or plunge turning along a contour (DMODE) for its tool's two corners");
  if (call_.get("U1") != 0) return refuse("an allowance for finishing (U1)");
  for (const ValueName limit : std::initializer_list<ValueName>{"XA", "ZA", "XB", "ZB"})
    if (call_.get(limit) != 0) return refuse("a limit of the area (XA, ZA, XB, ZB)");
  const double blank = call_.get("BL", kBlankCylinder);
  if (blank < 1 || blank > 3 || blank != std::floor(blank))
    return error("value-range", "CYCLE952: BL, the blank, is 1 to 3", where_);
  if (blank == kBlankContour && contours_.size() < 2)
    return error("value-missing",
                 "CYCLE952 with BL=3 needs two contours before it: CYCLE62 of the blank, then of "
                 "the part",
                 where_);
  return true;
}

// The unit of VARI says whether cuts are along Z, along X or along the contour; its hundreds give
// the direction of the cut and its thousands that of the infeed: X-, X+, Z-, Z+.
bool RemovalValues::removal_ways(RemovalPlan& r) {
  const int type = call_.digit("VARI", 0), work = call_.digit("VARI", 1);
  const int cut = call_.digit("VARI", 2), infeed = call_.digit("VARI", 3);
  const bool across = infeed >= 3;
  const bool known = type >= kAlongZ && type <= kAlongContour && work >= 1 && work <= 3 &&
                     infeed >= 1 && infeed <= 4 && cut >= 1 && cut <= 4;
  if (!known || (type == kAlongZ && across) || (type == kAlongX && !across) ||
      (type != kAlongContour && (cut >= 3) == across))
    return error("not-supported",
                 fmt::format("CYCLE952: VARI {:g} is not supported: the ways of cut and infeed in "
                             "its hundreds and thousands do not go with its unit",
                             call_.get("VARI")),
                 where_);
  r.u = across ? 2 : 0;
  r.v = 2 - r.u;
  r.down = infeed % 2 == 1 ? -1 : 1;
  r.rough = work != 2;
  r.finish = work != 1;
  r.reliefs = call_.digit("VARI", 6) == 2;
  const double along = component(contour_.back().end, r.v) - component(contour_.front().end, r.v);
  r.run = type == kAlongContour ? (along < 0 ? -1 : 1) : (cut % 2 == 1 ? -1 : 1);
  if (along * r.run < 0) turn_contour();
  return true;
}

// The allowances are UX and UZ, or U beside the contour. The ten thousands of VARI decide if a
// program has both.
void RemovalValues::removal_allowances(RemovalPlan& r) {
  const double unit = scale();
  const double x = std::abs(call_.get("UX")) * unit, z = std::abs(call_.get("UZ")) * unit;
  const double beside = std::abs(call_.get("U")) * unit;
  const bool both = beside > 0 && (x > 0 || z > 0);
  const bool parallel = both ? call_.digit("VARI", 4) == 1 : beside > 0;
  if (both && r.rough && !r.finish)
    note_once("cycle-allowance",
              parallel ? "CYCLE952 leaves U beside the contour; UX and UZ do not count (VARI)"
                       : "CYCLE952 leaves UX and UZ on the contour; U does not count (VARI)",
              where_, "CYCLE952");
  r.parallel = parallel ? beside : 0;
  if (parallel) return;
  component(r.allowance, r.u) = -r.down * (r.u == 0 ? x : z);
  component(r.allowance, r.v) = -r.run * (r.u == 0 ? z : x);
}

// Finds where the passes begin. The blank has an effect on how many there are, not on the part's
// shape.
void RemovalValues::removal_blank(RemovalPlan& r) {
  const int kind = static_cast<int>(call_.get("BL", kBlankCylinder));
  if (kind == kBlankContour) {
    r.blank = value_farthest(contours_.front(), r.u, -r.down);
    return;
  }
  const double given = call_.get(r.u == 0 ? ValueName("XD") : ValueName("ZD")) * scale();
  const double edge = value_farthest(contour_, r.u, -r.down);
  const double size = r.u == 0 ? given / 2 : given;
  const bool absolute = kind == kBlankCylinder && call_.digit("AMODE", r.u == 0 ? 5 : 6) == 0 &&
                        (edge - size) * r.down >= 0 && given != 0;
  r.blank = absolute ? size : edge - r.down * std::abs(given);
}

bool RemovalValues::removal_modes(RemovalPlan& r) {
  if (!removal_values() || !removal_ways(r)) return false;
  const double unit = scale();
  r.clear = call_.get("SC") > 0 ? call_.get("SC") * unit : 1;
  r.depth = std::abs(call_.get("D")) * unit;
  if (r.depth <= 0)
    r.depth = std::abs(call_.get(r.u == 0 ? ValueName("DX") : ValueName("DZ"))) * unit;
  r.feed = call_.get("F") * feed_scale();
  r.plunge = call_.get("FR") * feed_scale();
  r.last_feed = (call_.get("FS") > 0 && r.rough ? call_.get("FS") : call_.get("F")) * feed_scale();
  removal_allowances(r);
  removal_blank(r);
  return true;
}

// The values of CYCLE95: NPP MID FALZ FALX FAL FF1 FF2 FF3 VARI DT DAM VRT.
bool RemovalValues::turn_modes(RemovalPlan& r) {
  const double unit = scale(), number = call_.get("VARI");
  if (number < 1 || number > 12 || number != std::floor(number))
    return error("value-range", "CYCLE95: VARI is 1 to 12", where_);
  const int kind = (static_cast<int>(number) - 1) % 4;  // outside, face outside, inside, face
  r.rough = number <= 4 || number > 8;
  r.finish = number > 4;
  const bool face = kind % 2 == 1;
  r.u = face ? 2 : 0;
  r.v = 2 - r.u;
  r.clear = call_.get("VRT") > 0 ? call_.get("VRT") * unit : 1;
  r.depth = std::abs(call_.get("MID")) * unit;
  r.feed = call_.get("FF1") * feed_scale();
  r.plunge = call_.get("FF2") * feed_scale();
  r.last_feed = call_.get("FF3") * feed_scale();
  const double first = component(contour_.front().end, r.u);
  const double last = component(contour_.back().end, r.u);
  const double now = component(position_.physical, r.u);
  r.down = face ? ((first + last) / 2 < now ? -1 : 1) : (kind >= 2 ? 1 : -1);
  const double along = std::abs(call_.get("FAL")) * unit;
  const double x = std::abs(call_.get("FALX")) * unit + along,
               z = std::abs(call_.get("FALZ")) * unit + along;
  if (r.rough) orient(r);  // only finishing runs the contour as it is written
  r.run = component(contour_.back().end, r.v) > component(contour_.front().end, r.v) ? 1 : -1;
  component(r.allowance, r.u) = -r.down * (face ? z : x);
  component(r.allowance, r.v) = -r.run * (face ? x : z);
  return true;
}

// Turns the contour round if necessary, so that it begins at its deepest end.
void RemovalValues::orient(const RemovalPlan& r) {
  const double first = component(contour_.front().end, r.u);
  const double last = component(contour_.back().end, r.u);
  if ((first - last) * r.down < 0) turn_contour();
}

void RemovalValues::turn_contour() {
  std::vector<Motion> turned{contour_.front()};
  turned.front().end = contour_.back().end;
  for (std::size_t i = contour_.size() - 1; i > 0; --i) {
    turned.push_back(contour_[i]);
    std::swap(turned.back().start, turned.back().end);
    turned.back().sweep = -turned.back().sweep;
  }
  contour_ = std::move(turned);
}

}  // namespace mrsim
