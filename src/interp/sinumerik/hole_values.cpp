#include "interp/sinumerik/hole_values.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "interp/cycles/chamfering.h"
#include "interp/cycles/iso_pitch.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::array<std::string_view, 10> kCycles = {"CYCLE81", "CYCLE82", "CYCLE83", "CYCLE84",
                                                      "CYCLE85", "CYCLE86", "CYCLE87", "CYCLE88",
                                                      "CYCLE89", "CYCLE840"};

}  // namespace

bool HoleValues::knows(std::string_view name) {
  return std::find(kCycles.begin(), kCycles.end(), name) != kCycles.end();
}

// AXN drills along the first or second axis of the plane, and the unit of DMODE in G17, G18 or G19.
// Otherwise the hole is along the normal of the plane in force, which is Y in G18.
bool HoleValues::choose_plane() {
  constexpr int kNormalTo[3][2] = {
      {kPlaneYZ, kPlaneZX}, {kPlaneXY, kPlaneYZ}, {kPlaneZX, kPlaneXY}};
  const int axis = static_cast<int>(call_.get("AXN"));
  const int plane = call_.digit("DMODE", 0);
  if (plane >= 1 && plane <= 3) modal_.plane = plane - 1;
  if (axis == 1 || axis == 2) modal_.plane = kNormalTo[modal_.plane][axis - 1];
  if (!lathe() || modal_.plane != kPlaneZX) return true;
  return error("cycle-plane",
               fmt::format("{} drills along the normal of the plane, which is Y in G18: say G17 "
                           "before it, for a hole along Z, and G18 behind it",
                           call_.name),
               where_);
}

// RTP RFP SDIS DP DPR are the retraction plane, the reference plane, the safety clearance, and the
// depth, absolute or from RFP.
bool HoleValues::read(Hole& out) {
  if (!knows(call_.name))
    return error("not-supported", fmt::format("MCALL {} is not supported yet", call_.name), where_);
  if (!call_.given("RTP") || !call_.given("RFP"))
    return error(
        "value-missing",
        fmt::format("{} needs RTP and RFP, the planes of retraction and reference", call_.name),
        where_);
  const double unit = scale(), rtp = call_.get("RTP") * unit, rfp = call_.get("RFP") * unit;
  const double down = rtp < rfp ? 1 : -1;
  out.safe = rfp - down * std::abs(call_.get("SDIS")) * unit;
  out.end = rtp;
  dwells(out);
  const bool by_shape = call_.digit("GMODE", 1) == 1;
  if (by_shape && call_.name == "CYCLE81") return to_diameter(rfp, down, out.bottom);
  if (!depth(rfp, down, out.bottom)) return false;
  if (by_shape && (call_.name == "CYCLE82" || call_.name == "CYCLE83"))
    out.bottom += down * point_length();
  if (!call_.written.empty() && call_.name == "CYCLE83") out.feed = call_.get("FFR") * feed_scale();
  if (call_.name == "CYCLE83") return strokes(rfp, out);
  if (call_.name == "CYCLE84" || call_.name == "CYCLE840") tapping(out);
  if (call_.name == "CYCLE85") {
    out.feed = call_.get("FFR") * feed_scale();
    out.feed_back = call_.get("RFF") * feed_scale();
  }
  out.feed_out = out.lead != 0 || call_.name == "CYCLE85" || call_.name == "CYCLE89";
  if (call_.name == "CYCLE86" &&
      (call_.get("RPA") != 0 || call_.get("RPO") != 0 || call_.get("RPAP") != 0)) {
    const Basis b = basis();
    out.lift = call_.get("RPA") * unit * b.u + call_.get("RPO") * unit * b.v +
               call_.get("RPAP") * unit * b.w;
  }
  return true;
}

bool HoleValues::depth(double reference, double down, double& bottom) {
  const int amode = static_cast<int>(call_.get("AMODE")) % 10;
  const bool relative = amode == 1 || (amode == 0 && call_.given("DPR") && call_.get("DPR") != 0);
  if (!relative && !call_.given("DP"))
    return error("value-missing", fmt::format("{} needs DP or DPR, the depth", call_.name), where_);
  // With a mode, DP holds the value. Without one, DPR has precedence over DP.
  const double value = amode == 1 && call_.given("DP") ? call_.get("DP") : call_.get("DPR");
  bottom = relative ? reference + down * std::abs(value) * scale() : call_.get("DP") * scale();
  if ((bottom - reference) * down < 0)
    return error("value-range",
                 fmt::format("{}: the depth lies on the side of the retraction plane (alarm 61101)",
                             call_.name),
                 where_);
  return true;
}

// By the tens of GMODE, DP of CYCLE81 is the diameter that the cone leaves on the face.
bool HoleValues::to_diameter(double reference, double down, double& bottom) {
  tools_.require(where_, true);
  const Tool* tool = tools_.current();
  const double half = tool ? cone_of(*tool) : 0,
               wide = std::abs(call_.given("DP") ? call_.get("DP") : call_.get("DPR"));
  if (half <= 0)
    return error("tool-unknown", "CYCLE81 to a diameter (GMODE) needs a tool that ends in a cone",
                 where_);
  const double aside = wide * scale() / 2 - tool->tip_diameter / 2;
  if (aside <= 0 || wide * scale() > tool->diameter + kRounding)
    return error("value-range",
                 fmt::format("CYCLE81: the tool's cone has no diameter of {:g} (GMODE)", wide),
                 where_);
  const SinCos cone = sincos(half);
  bottom = reference + down * aside * cone.cos / cone.sin;
  return true;
}

// By the tens of GMODE, DP of CYCLE82 and CYCLE83 is where the full diameter ends, not the point.
// Gives the length of the point, mm.
double HoleValues::point_length() {
  tools_.require(where_, true);
  const Tool* tool = tools_.current();
  const double half = tool ? cone_of(*tool) : 0;
  if (half <= 0) return 0;
  const SinCos cone = sincos(half);
  return (tool->diameter - tool->tip_diameter) / 2 * cone.cos / cone.sin;
}

// FDEP or FDPR is the first stroke, 0 where neither is given. False: an error was reported.
bool HoleValues::first_stroke(double reference, const Hole& hole, double& stroke) {
  const double unit = scale(), total = std::abs(hole.bottom - reference);
  const double down = hole.bottom < reference ? -1 : 1;
  const bool relative = call_.given("FDPR") && call_.get("FDPR") != 0;
  const bool said_relative =
      call_.digit("AMODE", 4) == 1 && call_.given("FDEP");  // a digit of AMODE
  stroke = total;
  if (relative) {
    stroke = std::abs(call_.get("FDPR")) * unit;
  } else if (said_relative) {
    stroke = std::abs(call_.get("FDEP")) * unit;
  } else if (call_.given("FDEP")) {
    stroke = down * (call_.get("FDEP") * unit - reference);
    if (stroke > total + kPosted)
      reporter_.once(Severity::warning, "cycle-first-depth",
                     fmt::format("{}: the first drilling depth FDEP of {:g} lies beyond the depth. "
                                 "The hole is drilled in one stroke; the control may stop with "
                                 "alarm 61107: write an FDEP between RFP and the depth",
                                 call_.shown(), call_.get("FDEP")),
                     where_, fmt::format("FDEP:{}:{}", call_.place.file, call_.place.line));
  }
  return stroke > 0 ||
         error("value-range",
               fmt::format("{}: the first drilling depth must lie below RFP (alarm 61107)",
                           call_.shown()),
               where_);
}

// DAM says by how much each stroke is shorter than the one before, or by which factor (below 0, or
// in percent by AMODE). The last two are equal.
bool HoleValues::strokes(double reference, Hole& hole) {
  const double unit = scale(), total = std::abs(hole.bottom - reference);
  const double down = hole.bottom < reference ? -1 : 1;
  double stroke = 0;
  if (!first_stroke(reference, hole, stroke)) return false;
  const bool percent = call_.digit("AMODE", 5) == 2;
  const double dam = percent ? -std::abs(call_.get("DAM")) / 100 : call_.get("DAM");
  const double least = std::abs(call_.get("MDEP")) * unit;
  hole.chips_out = call_.get("VARI") >= 1;
  if (call_.given("VRT") && call_.get("VRT") > 0 && !hole.chips_out)
    hole.clearance = call_.get("VRT") * unit;
  if (!hole.chips_out && !(call_.get("VRT") > 0)) hole.clearance = 1;
  if (call_.given("DIS1") && call_.get("DIS1") > 0 && hole.chips_out)
    hole.clearance = call_.get("DIS1") * unit;
  const double smallest = dam > 0 ? std::max(dam * unit, least) : least;
  double at = 0;
  while (at + stroke < total - kRounding) {
    at += stroke;
    hole.strokes.push_back(reference + down * at);
    if (hole.strokes.size() > kMostStrokes)
      return error("value-range", "CYCLE83: too many strokes", where_);
    if (dam > 0) stroke = std::max(stroke - dam * unit, smallest);
    if (dam < 0) stroke = std::max(stroke * -dam, std::max(smallest, 1e-3));
    const double rest = total - at;
    if (dam > 0 && rest > stroke && rest < 2 * stroke && stroke <= smallest) stroke = rest / 2;
  }
  return true;
}

// The seconds of a dwell. A value below 0 is in turns, unless a digit of the mode says 1 (seconds)
// or 2 (turns).
double HoleValues::pause(ValueName value, int mode_digit) {
  const double time = call_.get(value);
  const int unit = mode_digit > 0 ? call_.digit("AMODE", mode_digit) : 0;
  const bool turns = unit == 2 || (unit == 0 && time < 0);
  return turns ? dwell_.of_turns(std::abs(time), where_) : std::abs(time);
}

// DTB is the dwell at the bottom. In CYCLE83 it follows each stroke; DTD follows the last one, and
// DTS is where the chips are out.
void HoleValues::dwells(Hole& hole) {
  if (call_.name == "CYCLE87") return;
  if (call_.name != "CYCLE83") {
    hole.dwell = pause("DTB", 1);
    return;
  }
  const int other_units = call_.digit("AMODE", 2) + call_.digit("AMODE", 3);
  if (other_units != 0 && (call_.get("DTS") > 0 || call_.get("DTD") > 0))
    note_once("dwell-unit", "CYCLE83: DTS and DTD above 0 are read as seconds", where_, "CYCLE83");
  hole.dwell = hole.dwell_stroke = pause("DTB", 1);
  hole.dwell_safe = pause("DTS", 0);
  if (call_.get("DTD") != 0) hole.dwell = pause("DTD", 0);
}

// The pitch PIT in mm. PITA says its unit: 1 mm, 2 threads per inch, 3 inches, 4 modules.
double HoleValues::pitch() const {
  const double pit = call_.get("PIT");
  const double unit = call_.get("PITA");
  if (unit == 2) return pit != 0 ? kMmPerInch / pit : 0;
  if (unit == 4) return pit * kPi;
  return pit * (unit == 1 ? 1 : unit == 3 ? kMmPerInch : scale());
}

// MPIT is the size of the thread, PIT its pitch. The sign is the hand of the thread.
void HoleValues::tapping(Hole& hole) {
  const double size = call_.get("MPIT");
  double lead = pitch();
  if (lead == 0) lead = std::copysign(iso_pitch(std::abs(size)), size);
  const bool told = lead != 0;
  if (!told && modal_.speed > 0) lead = modal_.feed / modal_.speed;
  hole.lead = lead != 0 ? lead : 1;
  if (lead == 0 || (!told && call_.name == "CYCLE84"))
    reporter_.add(Severity::warning, "thread-lead",
                  fmt::format("the pitch of the thread is not given{}",
                              lead != 0 ? ": that of the feed and the speed counts" : ""),
                  where_);
}

}  // namespace mrsim
