#include "interp/turning/groove_cycles.h"

#include "core/numbers/rounding.h"
#include "core/numbers/units.h"
#include "core/words/tool_types.h"
#include "interp/path/clearing.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {

// The values of CYCLE93: SPD SPL WIDG DIAG STA1 ANG1 ANG2 RCO1 RCO2 RCI1 RCI2 FAL1 FAL2 IDEP DTB
// VARI VRT DN.
bool GrooveCycles::groove_values(Groove& g) {
  const double unit = scale();
  if (!call_.given({"SPD", "SPL", "WIDG", "DIAG", "VARI"}))
    return fail("value-missing", "CYCLE93 needs SPD, SPL, WIDG, DIAG and VARI");
  if (call_.values.size() > 18) return refuse("a list of more than 18 values");
  const double vari = call_.get("VARI"), kind = vari > 10 ? vari - 10 : vari;
  if (kind < 1 || kind > 8 || kind != std::floor(kind))
    return fail("value-range", "CYCLE93: VARI is 1 to 8 or 11 to 18 (alarm 61002)");
  if (std::fmod(kind, 2) == 0) return refuse("a groove in a face (VARI)");
  if (call_.get("STA1") != 0) return refuse("a groove in a cone (STA1)");
  if (call_.get("ANG1") != 0 || call_.get("ANG2") != 0)
    return refuse("an oblique flank (ANG1, ANG2)");
  const bool inside = kind == 3 || kind == 7, right = kind > 4;
  const double in = inside ? 1 : -1, depth = std::abs(call_.get("DIAG")) * unit;
  Word diameter;
  diameter.value = call_.get("SPD");
  g.top = std::abs(axis_value(0, diameter, false));
  g.bottom = g.top + in * depth;
  g.retract = call_.get("VRT") > 0 ? call_.get("VRT") * unit : 1;
  g.clear = g.top - in;
  g.base_allowance = std::abs(call_.get("FAL1")) * unit;
  g.flank_allowance = std::abs(call_.get("FAL2")) * unit;
  g.infeed = std::abs(call_.get("IDEP")) * unit;
  g.dwell = call_.get("DTB");
  const double width = std::abs(call_.get("WIDG")) * unit, at = call_.get("SPL") * unit;
  if (depth <= g.base_allowance || g.bottom < 0)
    return fail("value-range", "CYCLE93: DIAG is the depth, above FAL1 and not beyond the axis");
  const double low = right ? at - width : at;
  if (!blade(g, low, low + width)) return false;
  if (right) std::swap(g.flanks[0], g.flanks[1]);
  g.side = right ? -1 : 1;
  return groove_corners(g, width);
}

// RCO1 RCO2 are the corners at the edge, RCI1 RCI2 those at the bottom: a radius above 0, a chamfer
// below 0, given by its length (VARI below 10) or by its leg. The centre of the blade's corner
// stays its radius away from them.
bool GrooveCycles::groove_corners(Groove& g, double width) {
  const double apart =
      g.nose * (2 - std::sqrt(2.0));  // by which the legs of a chamfer change when it is offset
  static constexpr ValueName kEdges[] = {"RCO1", "RCO2"}, kCorners[] = {"RCI1", "RCI2"};
  double beside[2] = {0, 0}, below = 0;
  for (const std::size_t side : {0, 1}) {
    Flank& flank = g.flanks[side];
    const auto size = [&](const ValueName(&names)[2], bool& round, bool convex) {
      const double value = call_.get(names[side]) * scale();
      round = value > 0;
      if (value == 0) return 0.0;
      if (round) return convex ? value + g.nose : std::max(0.0, value - g.nose);
      const double leg = call_.get("VARI") > 10 ? -value : -value / std::sqrt(2.0);
      return convex ? leg + apart : std::max(0.0, leg - apart);
    };
    flank.edge = size(kEdges, flank.edge_round, true);
    flank.corner = size(kCorners, flank.corner_round, false);
    beside[side] = flank.corner;
    below = std::max(below, flank.edge + flank.corner);
  }
  if (below > std::abs(g.bottom - g.top) || beside[0] + beside[1] > width)
    return fail("value-range", "CYCLE93: the corners (RCO, RCI) are larger than the groove");
  if (beside[0] + beside[1] > std::abs(g.flanks[1].z - g.flanks[0].z) + kRounding)
    return fail("value-range", "CYCLE93: the blade is too wide between the corners of the bottom");
  return true;
}

// Finds where the tool's point stands at the two flanks. The point is a corner of the blade or its
// middle.
bool GrooveCycles::blade(Groove& g, double low, double high) {
  tools_.require(where_, true);
  const Tool* tool = tools_.current();
  if (!tool || tool->type != ToolType::grooving || tool->width <= 0)
    return fail("tool-unknown",
                call_.name + " needs a grooving tool and its width: give --tool or --tools");
  const double w = tool->width;
  if (w > high - low + kRounding)
    return fail("value-range", call_.name + ": the tool is wider than the groove (alarm 61602)");
  const int tip = tip_orientation(*tool);
  const bool inside = g.bottom > g.top;
  const bool fits = inside ? tip == 1 || tip == 2 || tip == 6 : tip == 3 || tip == 4 || tip == 8;
  if (!fits || tool->tip_is_nose_centre)
    return fail("value-range", fmt::format("{}: the tip orientation {} does not reach this groove",
                                           call_.name, tip));
  const bool middle = tip == 6 || tip == 8, right = tip == 1 || tip == 4;
  const double from = middle  ? w / 2
                      : right ? w
                              : 0;  // distance of the point from the blade's low corner
  g.flanks[0].z = low + from;
  g.flanks[1].z = high - w + from;
  g.nose = tool->nose_radius;
  g.step = 0.95 * (w - 2 * tool->nose_radius);
  if (g.step <= 0)
    return fail("value-range", call_.name + ": the blade has no flat between its corners");
  return true;
}

void GrooveCycles::plunge(const Groove& g, double z, double bottom) {
  const double in = sign_of(g.bottom - g.top), whole = std::abs(bottom - g.top);
  to(g.clear, z, MotionKind::rapid);
  const int n = steps_of(whole, g.infeed);
  for (int i = 1; i <= n; ++i) {
    const double at = g.top + in * whole * i / n;
    to(at, z, MotionKind::line);
    if (i < n) to(at - in * g.retract, z, MotionKind::rapid);
  }
  moves_.dwell(g.dwell);
  to(g.clear, z, MotionKind::rapid);
}

// Runs a quarter of a circle to X, Z. It begins along Z at the edge (`from_top`), or ends along Z
// at the bottom.
void GrooveCycles::quarter(double x, double z, double radius, double turn, bool from_top) {
  const Vec2 from{position_.programmed.z, position_.programmed.x}, end{z, x};
  const Vec2 center = from_top ? Vec2{from.x, end.y} : Vec2{end.x, from.y};
  mover_.begin(where_);
  mover_.piece({true, from, end, center, radius, turn * kPi / 2}, 0, 0);
}

// Finishes down the flank, with the corner at its edge, and along the bottom to the middle, with
// the corner there. `side`: which side of the groove along Z.
void GrooveCycles::finish_flank(const Groove& g, const Flank& f, double side, double middle) {
  const double in = sign_of(g.bottom - g.top), above = std::abs(g.clear - g.top);
  const double edge = g.top + in * f.edge, corner = g.bottom - in * f.corner;
  const bool chamfer = f.edge > 0 && !f.edge_round;
  to(g.clear, f.z - side * (chamfer ? f.edge + above : f.edge), MotionKind::rapid);
  if (chamfer) to(edge, f.z, MotionKind::line);
  if (f.edge > 0 && f.edge_round) {
    to(g.top, f.z - side * f.edge, MotionKind::line);
    quarter(edge, f.z, f.edge, side * in, true);
  }
  to(corner, f.z, MotionKind::line);
  if (f.corner > 0 && f.corner_round)
    quarter(g.bottom, f.z + side * f.corner, f.corner, -side * in, false);
  to(g.bottom, f.z + side * f.corner, MotionKind::line);
  to(g.bottom, middle, MotionKind::line);
  to(g.clear, middle, MotionKind::rapid);
}

bool GrooveCycles::groove() {
  Groove g;
  if (!groove_values(g)) return false;
  const Flank &first = g.flanks[0], &last = g.flanks[1];
  const double in = sign_of(g.bottom - g.top), travel = last.z - first.z;
  if (std::abs(g.bottom - g.top) > kMostTurningPasses * g.infeed && g.infeed > 0)
    return fail("value-range", "too many passes");
  const double most = std::abs(travel), along = sign_of(travel);
  double before = std::max(g.flank_allowance - first.corner, 0.0),
         behind = std::max(g.flank_allowance - last.corner, 0.0);
  const double room = most - first.corner - last.corner, wanted = before + behind;
  if (wanted > room) {  // the allowances would meet
    before *= room / wanted;
    behind *= room / wanted;
  }
  const double begin = first.z + along * (first.corner + before),
               end = last.z - along * (last.corner + behind);
  if (std::abs(end - begin) > kMostTurningPasses * g.step)
    return fail("value-range", "too many passes");
  to(g.clear, position_.programmed.z, MotionKind::rapid);
  const int n = std::abs(end - begin) < kRounding ? 0 : steps_of(std::abs(end - begin), g.step);
  for (int i = 0; i <= n; ++i)
    plunge(g, n == 0 ? begin : begin + (end - begin) * i / n, g.bottom - in * g.base_allowance);
  const double corners = first.edge + first.corner + last.edge + last.corner;
  if (g.base_allowance == 0 && g.flank_allowance == 0 && corners == 0) return true;
  const double middle = (begin + end) / 2;
  finish_flank(g, first, g.side, middle);
  finish_flank(g, last, -g.side, middle);
  return true;
}

// The values of CYCLE92: SPD SPL DIAG1 DIAG2 RC SDIS SV1 SV2 SDAC FF1 FF2 SS2 DIAGM VARI DN DMODE
// AMODE.
bool GrooveCycles::parting_values(Groove& g) {
  const double unit = scale();
  if (!call_.given({"SPD", "SPL", "DIAG2"}))
    return fail("value-missing", "CYCLE92 needs X0, Z0 and X2: where it cuts, and how deep");
  if (call_.values.size() > 17) return refuse("a list of more than 17 values");
  if (call_.get("RC") != 0) return refuse("a rounding or a chamfer of the edge (RC)");
  if (call_.digit("AMODE", 0) > 1 || call_.digit("AMODE", 1) > 1) return refuse("this AMODE");
  g.top = std::abs(call_.get("SPD")) * unit / 2;
  const auto depth = [&](ValueName value, int digit) {
    const double size = call_.get(value) * unit;
    return call_.digit("AMODE", digit) == 1 ? g.top - std::abs(size) : size / 2;
  };
  g.bottom = depth("DIAG2", 1);
  g.infeed = call_.given("DIAG1") ? depth("DIAG1", 0) : g.bottom;  // where the feed changes
  g.clear = g.top + std::abs(call_.get("SDIS")) * unit;
  if (g.bottom >= g.top) return fail("value-range", "CYCLE92: X2 does not lie below X0");
  return true;
}

// Parts off: the right side of the blade cuts the face of the part at Z0, straight in, slower from
// X1 on, and back.
bool GrooveCycles::parting() {
  Groove g;
  tools_.require(where_, true);
  const Tool* tool = tools_.current();
  if (!parting_values(g)) return false;
  const double z = call_.get("SPL") * scale(), width = tool ? tool->width : 0;
  if (!blade(g, z - width, z)) return false;
  const double before = modal_.feed;
  to(g.clear, position_.programmed.z, MotionKind::rapid);
  to(g.clear, g.flanks[0].z, MotionKind::rapid);
  if (call_.get("FF1") > 0) modal_.feed = call_.get("FF1") * feed_scale();
  to(std::clamp(g.infeed, g.bottom, g.top), g.flanks[0].z, MotionKind::line);
  if (call_.get("FF2") > 0) modal_.feed = call_.get("FF2") * feed_scale();
  to(g.bottom, g.flanks[0].z, MotionKind::line);
  modal_.feed = before;
  to(g.clear, g.flanks[0].z, MotionKind::rapid);
  return true;
}

}  // namespace mrsim
