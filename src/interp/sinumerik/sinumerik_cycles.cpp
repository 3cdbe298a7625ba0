#include "interp/sinumerik/sinumerik_cycles.h"

#include "core/rounding.h"
#include "core/text_io.h"
#include "core/trig.h"
#include "core/units.h"
#include "interp/cycles/iso_pitch.h"
#include "interp/text/characters.h"
#include "interp/words/unread_modes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::array<std::string_view, 10> kCycles = {"CYCLE81", "CYCLE82", "CYCLE83", "CYCLE84",
                                                      "CYCLE85", "CYCLE86", "CYCLE87", "CYCLE88",
                                                      "CYCLE89", "CYCLE840"};
constexpr std::array<std::string_view, 5> kPatterns = {"HOLES1", "HOLES2", "CYCLE800", "CYCLE801",
                                                       "CYCLE802"};
constexpr std::array<std::string_view, 13> kMeasuring = {
    "CYCLE971", "CYCLE973", "CYCLE974", "CYCLE976", "CYCLE977", "CYCLE978", "CYCLE979",
    "CYCLE982", "CYCLE994", "CYCLE995", "CYCLE996", "CYCLE997", "CYCLE998"};

// Where the call has its mode (AMODE): how depth and dwell are written. GMODE and DMODE stand
// before it.
std::size_t mode_of(std::string_view cycle) {
  static constexpr std::array<std::pair<std::string_view, std::size_t>, 7> kModes = {
      {{"CYCLE81", 8},
       {"CYCLE82", 8},
       {"CYCLE83", 19},
       {"CYCLE84", 23},
       {"CYCLE85", 10},
       {"CYCLE86", 13},
       {"CYCLE840", 19}}};
  for (const auto& [name, mode] : kModes)
    if (cycle == name) return mode;
  return 99;
}

bool is_cycle(std::string_view name) {
  return std::find(kCycles.begin(), kCycles.end(), name) != kCycles.end();
}

// Whether value `i` of a cycle may be a text: the name of its contour, of a program or of the
// swivel data, the text to engrave, the hidden places of a pattern.
bool takes_text(std::string_view cycle, std::size_t i) {
  struct Texts {
    std::string_view cycle;
    std::size_t first, last;
  };
  static constexpr Texts kTexts[] = {{"CYCLE60", 0, 0},  {"CYCLE62", 0, 3},    {"CYCLE63", 0, 0},
                                     {"CYCLE72", 0, 0},  {"CYCLE95", 0, 0},    {"CYCLE952", 0, 2},
                                     {"CYCLE800", 1, 1}, {"CYCLE801", 11, 11}, {"HOLES1", 8, 8},
                                     {"HOLES2", 8, 8}};
  for (const Texts& row : kTexts)
    if (row.cycle == cycle) return i >= row.first && i <= row.last;
  return false;
}

bool measures(std::string_view name) {
  return std::find(kMeasuring.begin(), kMeasuring.end(), name) != kMeasuring.end();
}

}  // namespace

bool SinumerikCycles::knows(std::string_view name) {
  return is_cycle(name) || is_of_802(name) || MillCycles::knows(name) ||
         SinumerikContours::knows(name) || TurnCycles::knows(name) || measures(name) ||
         SinumerikEngraving::knows(name) ||
         std::find(kPatterns.begin(), kPatterns.end(), name) != kPatterns.end();
}

Word SinumerikCycles::where() const {
  Word word;
  const std::size_t at = upper_case(block_.line).find(block_.function_name);
  word.column = at == std::string::npos ? 0 : static_cast<int>(at);
  word.length = static_cast<int>(block_.function_name.size());
  return word;
}

bool SinumerikCycles::read_call(Call& call) {
  call.name = std::string(block_.function_name);
  call.place = block_.place();
  if (is_of_802(block_.function_name)) return read_802(block_.function_name, call);
  if (!statements_ || !statements_->call_values(block_.argument, call.values)) return false;
  for (std::size_t i = 0; i < call.values.size(); ++i)
    if (!call.text(i).empty() && !takes_text(call.name, i))
      return error("expression",
                   fmt::format("{}: value {} is a text or an axis, and not a number (alarm 12150)",
                               call.name, i + 1),
                   where());
  return true;
}

// It cuts nothing, and what it finds only the machine knows: offsets stay as they are.
bool SinumerikCycles::measure() {
  position_.known = lathe() ? 2 : 0;
  note_once("probe",
            fmt::format("{} measures with a probe: it is not run, and the axes' position is "
                        "unknown until they are given again",
                        block_.function_name),
            where(), "measuring");
  return true;
}

bool SinumerikCycles::run() {
  if (measures(block_.function_name)) return measure();
  Call call;
  if (!read_call(call)) return false;
  if (contours_.reads_contour())
    return error("not-supported", fmt::format("{} inside the contour of a cycle", call.name),
                 where());
  if (MillCycles::knows(call.name)) return mills_.run(call, where(), false);
  if (SinumerikContours::knows(call.name)) return contours_.run(call, where());
  if (TurnCycles::knows(call.name)) return turns_.run(call, where());
  if (SinumerikEngraving::knows(call.name)) return engraving_.run(call, where());
  if (is_cycle(call.name)) return drill(call);
  return call.written.empty() ? pattern(call) : pattern_802(call);
}

bool SinumerikCycles::modal_call() {
  modal_call_.reset();
  if (block_.function_name.empty()) return true;
  Call call;
  if (!read_call(call)) return false;
  Hole test;
  if (!MillCycles::knows(call.name) && !hole(call, test)) return false;
  modal_call_ = call;
  return true;
}

bool SinumerikCycles::run_modal(const Vec3& from) {
  if (!modal_call_) return true;
  const Basis b = basis();
  const Vec3 d = position_.programmed - from;
  if (dot(d, b.u) == 0 && dot(d, b.v) == 0 && !block_.find(letter('X')) &&
      !block_.find(letter('Y')))
    return true;
  return drill(*modal_call_);
}

// The motions name the line of MCALL, called from that of the place.
bool SinumerikCycles::mill(const Call& call) {
  const int line = block_.line_number, file = block_.file, site = block_.call;
  block_.call = reader_.call_site(line);
  block_.file = call.place.file;
  block_.line_number = call.place.line;
  const bool ok = mills_.run(call, where(), true);
  block_.line_number = line;
  block_.file = file;
  block_.call = site;
  return ok;
}

bool SinumerikCycles::drill(const Call& call) {
  if (MillCycles::knows(call.name)) return mill(call);
  const int plane = modal_.plane;
  Hole made;
  const bool ok = choose_plane(call) && hole(call, made);
  if (ok) holes_.drill(made, call.place, where());
  modal_.plane = plane;
  return ok;
}

// AXN: along the plane's first or second axis; the unit of DMODE: in G17, G18 or G19. Otherwise
// along the normal of the plane in force, which is Y in G18.
bool SinumerikCycles::choose_plane(const Call& call) {
  constexpr int kNormalTo[3][2] = {{2, 1}, {0, 2}, {1, 0}};
  const std::size_t axn = call.name == "CYCLE83" || call.name == "CYCLE84" ? 12 : 11;
  const int axis = axn == 12 || call.name == "CYCLE840" ? static_cast<int>(call.get(axn)) : 0;
  const int plane = call.digit(mode_of(call.name) - 1, 0);
  if (plane >= 1 && plane <= 3) modal_.plane = plane - 1;
  if (axis == 1 || axis == 2) modal_.plane = kNormalTo[modal_.plane][axis - 1];
  if (!lathe() || modal_.plane != 1) return true;
  return error("cycle-plane",
               fmt::format("{} drills along the normal of the plane, which is Y in G18: say G17 "
                           "before it, for a hole along Z, and G18 behind it",
                           call.name),
               where());
}

// RTP RFP SDIS DP DPR: retraction, reference, safety clearance, depth absolute or from RFP.
bool SinumerikCycles::hole(const Call& call, Hole& out) {
  if (!is_cycle(call.name))
    return error("not-supported", fmt::format("MCALL {} is not supported yet", call.name), where());
  if (!call.given(0) || !call.given(1))
    return error(
        "value-missing",
        fmt::format("{} needs RTP and RFP, the planes of retraction and reference", call.name),
        where());
  const double unit = scale(), rtp = call.get(0) * unit, rfp = call.get(1) * unit;
  const double down = rtp < rfp ? 1 : -1;
  out.safe = rfp - down * std::abs(call.get(2)) * unit;
  out.end = rtp;
  dwells(call, out);
  const bool by_shape = call.digit(mode_of(call.name) - 2, 1) == 1;
  if (by_shape && call.name == "CYCLE81") return to_diameter(call, rfp, down, out.bottom);
  if (!depth(call, mode_of(call.name), rfp, down, out.bottom)) return false;
  if (by_shape && (call.name == "CYCLE82" || call.name == "CYCLE83"))
    out.bottom += down * point_length();
  if (!call.written.empty() && call.name == "CYCLE83") out.feed = call.get(20) * feed_scale();
  if (call.name == "CYCLE83") return strokes(call, rfp, out);
  if (call.name == "CYCLE84" || call.name == "CYCLE840") tapping(call, out);
  if (call.name == "CYCLE85") {
    out.feed = call.get(6) * feed_scale();
    out.feed_back = call.get(7) * feed_scale();
  }
  out.feed_out = out.lead != 0 || call.name == "CYCLE85" || call.name == "CYCLE89";
  if (call.name == "CYCLE86" && (call.get(7) != 0 || call.get(8) != 0 || call.get(9) != 0)) {
    const Basis b = basis();
    out.lift = call.get(7) * unit * b.u + call.get(8) * unit * b.v + call.get(9) * unit * b.w;
  }
  return true;
}

bool SinumerikCycles::depth(const Call& call, std::size_t mode, double reference, double down,
                            double& bottom) {
  const int amode = static_cast<int>(call.get(mode)) % 10;
  const bool relative = amode == 1 || (amode == 0 && call.given(4) && call.get(4) != 0);
  if (!relative && !call.given(3))
    return error("value-missing", fmt::format("{} needs DP or DPR, the depth", call.name), where());
  // With a mode, the value stands in DP; without one, DPR counts before DP.
  const double value = amode == 1 && call.given(3) ? call.get(3) : call.get(4);
  bottom = relative ? reference + down * std::abs(value) * scale() : call.get(3) * scale();
  if ((bottom - reference) * down < 0)
    return error("value-range",
                 fmt::format("{}: the depth lies on the side of the retraction plane (alarm 61101)",
                             call.name),
                 where());
  return true;
}

// The tens of GMODE: DP of CYCLE81 is the diameter that the cone leaves on the face.
bool SinumerikCycles::to_diameter(const Call& call, double reference, double down, double& bottom) {
  tools_.require(where(), true);
  const Tool* tool = tools_.current();
  const double half = tool ? cone_of(*tool) : 0, wide = std::abs(call.get(call.given(3) ? 3 : 4));
  if (half <= 0)
    return error("tool-unknown", "CYCLE81 to a diameter (GMODE) needs a tool that ends in a cone",
                 where());
  const double aside = wide * scale() / 2 - tool->tip_diameter / 2;
  if (aside <= 0 || wide * scale() > tool->diameter + kRounding)
    return error("value-range",
                 fmt::format("CYCLE81: the tool's cone has no diameter of {:g} (GMODE)", wide),
                 where());
  const SinCos cone = sincos(half);
  bottom = reference + down * aside * cone.cos / cone.sin;
  return true;
}

// The tens of GMODE: DP of CYCLE82 and CYCLE83 is where the full diameter ends, not the point.
double SinumerikCycles::point_length() {
  tools_.require(where(), true);
  const Tool* tool = tools_.current();
  const double half = tool ? cone_of(*tool) : 0;
  if (half <= 0) return 0;
  const SinCos cone = sincos(half);
  return (tool->diameter - tool->tip_diameter) / 2 * cone.cos / cone.sin;
}

// FDEP or FDPR: the first stroke; DAM: how much less each next one is, or by which factor (below 0,
// or in percent by AMODE); the last two are equal.
bool SinumerikCycles::strokes(const Call& call, double reference, Hole& hole) {
  const double unit = scale(), total = std::abs(hole.bottom - reference);
  const double down = hole.bottom < reference ? -1 : 1;
  const bool relative = call.given(6) && call.get(6) != 0;
  const bool said_relative = call.digit(19, 4) == 1 && call.given(5);  // of AMODE
  double stroke = relative        ? std::abs(call.get(6)) * unit
                  : said_relative ? std::abs(call.get(5)) * unit
                                  : std::abs(call.get(5) * unit - reference);
  if (!relative && !call.given(5)) stroke = total;
  const bool percent = call.digit(19, 5) == 2;
  const double dam = percent ? -std::abs(call.get(7)) / 100 : call.get(7);
  const double least = std::abs(call.get(13)) * unit;
  hole.chips_out = call.get(11) >= 1;
  if (call.given(14) && call.get(14) > 0 && !hole.chips_out) hole.clearance = call.get(14) * unit;
  if (!hole.chips_out && !(call.get(14) > 0)) hole.clearance = 1;
  if (call.given(16) && call.get(16) > 0 && hole.chips_out) hole.clearance = call.get(16) * unit;
  if (stroke <= 0)
    return error("value-range", "CYCLE83: the first drilling depth must lie below RFP", where());
  const double smallest = dam > 0 ? std::max(dam * unit, least) : least;
  double at = 0;
  while (at + stroke < total - kRounding) {
    at += stroke;
    hole.strokes.push_back(reference + down * at);
    if (hole.strokes.size() > kMostStrokes)
      return error("value-range", "CYCLE83: too many strokes", where());
    if (dam > 0) stroke = std::max(stroke - dam * unit, smallest);
    if (dam < 0) stroke = std::max(stroke * -dam, std::max(smallest, 1e-3));
    const double rest = total - at;
    if (dam > 0 && rest > stroke && rest < 2 * stroke && stroke <= smallest) stroke = rest / 2;
  }
  return true;
}

// s of a dwell: below 0 it is in turns, unless a digit of the mode says 1 (seconds) or 2 (turns).
double SinumerikCycles::pause(const Call& call, std::size_t value, int mode_digit) {
  const double time = call.get(value);
  const int unit = mode_digit > 0 ? call.digit(mode_of(call.name), mode_digit) : 0;
  const bool turns = unit == 2 || (unit == 0 && time < 0);
  return turns ? dwell_.of_turns(std::abs(time), where()) : std::abs(time);
}

// DTB: at the bottom; CYCLE83: behind each stroke, DTD behind the last one, DTS where the chips are
// out.
void SinumerikCycles::dwells(const Call& call, Hole& hole) {
  if (call.name == "CYCLE87") return;
  if (call.name != "CYCLE83") {
    hole.dwell = pause(call, 5, 1);
    return;
  }
  const int other_units = call.digit(19, 2) + call.digit(19, 3);
  if (other_units != 0 && (call.get(9) > 0 || call.get(15) > 0))
    note_once("dwell-unit", "CYCLE83: DTS and DTD above 0 are read as seconds", where(), "CYCLE83");
  hole.dwell = hole.dwell_stroke = pause(call, 8, 1);
  hole.dwell_safe = pause(call, 9, 0);
  if (call.get(15) != 0) hole.dwell = pause(call, 15, 0);
}

// MPIT (size of the thread) or PIT (its pitch); the sign is the hand.
void SinumerikCycles::tapping(const Call& call, Hole& hole) {
  const bool rigid = call.name == "CYCLE84";
  const std::size_t mpit = rigid ? 7 : 9, pit = mpit + 1;
  double lead = call.get(pit) * scale();
  if (lead == 0) lead = std::copysign(iso_pitch(std::abs(call.get(mpit))), call.get(mpit));
  if (lead == 0 && modal_.speed > 0) lead = modal_.feed / modal_.speed;
  hole.lead = lead != 0 ? lead : 1;
  if (lead == 0)
    reporter_.add(Severity::warning, "thread-lead", "the pitch of the thread is not given",
                  where());
}

}  // namespace mrsim
