#include "interp/sinumerik/sinumerik_cycles.h"

#include "core/rounding.h"
#include "core/text_io.h"
#include "core/trig.h"
#include "core/units.h"
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
constexpr double kMostHoles = 10'000;

// Where the call has its mode (AMODE): how depth and dwell are written.
std::size_t mode_of(std::string_view cycle) {
  if (cycle == "CYCLE81" || cycle == "CYCLE82") return 8;
  return cycle == "CYCLE83" ? 19 : 99;
}

bool is_cycle(std::string_view name) {
  return std::find(kCycles.begin(), kCycles.end(), name) != kCycles.end();
}

bool measures(std::string_view name) {
  return std::find(kMeasuring.begin(), kMeasuring.end(), name) != kMeasuring.end();
}

}  // namespace

double iso_pitch(double thread) {
  static constexpr std::array<std::pair<double, double>, 22> kPitches = {
      {{3, 0.5}, {4, 0.7},  {5, 0.8},  {6, 1},    {8, 1.25}, {10, 1.5}, {12, 1.75}, {14, 2},
       {16, 2},  {18, 2.5}, {20, 2.5}, {22, 2.5}, {24, 3},   {27, 3},   {30, 3.5},  {33, 3.5},
       {36, 4},  {39, 4},   {42, 4.5}, {45, 4.5}, {48, 5},   {52, 5}}};
  for (const auto& [size, pitch] : kPitches)
    if (thread == size) return pitch;
  return 0;
}

bool SinumerikCycles::knows(std::string_view name) {
  return is_cycle(name) || MillCycles::knows(name) || SinumerikContours::knows(name) ||
         TurnCycles::knows(name) || measures(name) ||
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
  call.place = {block_.file, block_.line_number, block_.call};
  return statements_ && statements_->call_values(block_.argument, call.values);
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
  return is_cycle(call.name) ? drill(call) : pattern(call);
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
  if (!depth(call, mode_of(call.name), rfp, down, out.bottom)) return false;
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

// FDEP or FDPR: the first stroke; DAM: how much less each next one is, or by which factor; the last
// two are equal.
bool SinumerikCycles::strokes(const Call& call, double reference, Hole& hole) {
  const double unit = scale(), total = std::abs(hole.bottom - reference);
  const double down = hole.bottom < reference ? -1 : 1;
  const bool relative = call.given(6) && call.get(6) != 0;
  double stroke =
      relative ? std::abs(call.get(6)) * unit : std::abs(call.get(5) * unit - reference);
  if (!relative && !call.given(5)) stroke = total;
  const double dam = call.get(7), least = std::abs(call.get(13)) * unit;
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

bool SinumerikCycles::pattern(const Call& call) {
  if (call.name == "HOLES1") return row(call);
  if (call.name == "HOLES2") return circle(call);
  if (call.name == "CYCLE800") return swivel(call);
  return call.name == "CYCLE801" ? grid(call) : points(call);
}

// FR TC ST MODE X0 Y0 Z0 A B C X1 Y1 Z1; MODE says in pairs of bits about which axes A B C turn.
bool SinumerikCycles::swivel(const Call& call) {
  const auto mode = static_cast<unsigned>(std::clamp(call.get(3), 0.0, 255.0));
  double angle = 0;
  for (unsigned i = 0; i < 3; ++i) {
    const double turn = call.get(7 + i);
    if (turn != 0 && (mode >= 64 || (mode >> (2 * i) & 3U) != 3)) {
      UnreadModes(control_).begin_swivel();
      return error(
          "not-supported",
          "CYCLE800 with a tilt (a swivelled plane) is not supported: no move is run up to "
          "the next CYCLE800",
          where());
    }
    angle += turn;
  }
  const auto shift = [&](std::size_t i) {
    return shift_frame(scale() * Vec3{call.get(i), call.get(i + 1), call.get(i + 2)});
  };
  const Frame turned = angle != 0 ? rotation_frame(2, angle) : Frame{};
  frame_words_.swivel(compose(compose(shift(4), turned), shift(10)), call.digit(2, 0) == 1,
                      where());
  return true;
}

// SPCA SPCO STA1 FDIS DBH NUM: holes on a line.
bool SinumerikCycles::row(const Call& call) {
  const double count = call.get(5), unit = scale();
  if (count < 0 || count > kMostHoles)
    return error("value-range", "HOLES1: the number of holes is 1 to 10000", where());
  const SinCos sc = sincos_deg(call.get(2));
  std::vector<Vec2> list;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const double along = (call.get(3) + i * call.get(4)) * unit;
    list.push_back({call.get(0) * unit + along * sc.cos, call.get(1) * unit + along * sc.sin});
  }
  const Vec2 from = in_plane(basis(), position_.programmed);  // it begins at the end that is nearer
  if (!list.empty() && length(list.back() - from) < length(list.front() - from) - kRounding)
    std::reverse(list.begin(), list.end());
  return at_points(list);
}

// CPA CPO RAD STA1 INDA NUM: holes on a circle; INDA 0: all round.
bool SinumerikCycles::circle(const Call& call) {
  const double count = call.get(5), unit = scale();
  if (count < 1 || count > kMostHoles)
    return error("value-range", "HOLES2: the number of holes is 1 to 10000", where());
  const double step = call.get(4) != 0 ? call.get(4) : 360 / std::floor(count);
  std::vector<Vec2> list;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const SinCos sc = sincos_deg(call.get(3) + i * step);
    list.push_back(
        {(call.get(0) + call.get(2) * sc.cos) * unit, (call.get(1) + call.get(2) * sc.sin) * unit});
  }
  return at_points(list);
}

// SPCA SPCO STA DIS1 DIS2 NUM1 NUM2: a grid, or its frame alone (VARI 1).
bool SinumerikCycles::grid(const Call& call) {
  const double columns = call.get(5), rows = call.get(6), unit = scale();
  if (columns < 1 || rows < 1 || columns * rows > kMostHoles)
    return error("value-range", "CYCLE801: the number of holes is 1 to 10000", where());
  const bool frame = static_cast<int>(call.get(7)) % 10 == 1;
  const int nu = static_cast<int>(columns), nv = static_cast<int>(rows);
  const SinCos sc = sincos_deg(call.get(2));
  std::vector<Vec2> list;
  for (int j = 0; j < nv; ++j)
    for (int k = 0; k < nu; ++k) {
      const int i = j % 2 ? nu - 1 - k : k;  // there and back
      if (frame && i > 0 && i < nu - 1 && j > 0 && j < nv - 1) continue;
      const Vec2 d{i * call.get(3) * unit, j * call.get(4) * unit};
      list.push_back({call.get(0) * unit + d.x * sc.cos - d.y * sc.sin,
                      call.get(1) * unit + d.x * sc.sin + d.y * sc.cos});
    }
  return at_points(list);
}

// CYCLE802: up to nine points, behind the two masks.
bool SinumerikCycles::points(const Call& call) {
  std::vector<Vec2> list;
  for (std::size_t i = 2; i + 1 < 20; i += 2)
    if (call.given(i) && call.given(i + 1))
      list.push_back({call.get(i) * scale(), call.get(i + 1) * scale()});
  return at_points(list);
}

// Without MCALL the pattern is a row of rapids.
bool SinumerikCycles::at_points(const std::vector<Vec2>& points) {
  const Basis b = basis();
  unsigned named = 0;
  for (int i = 0; i < 3; ++i)
    if (component(b.u, i) != 0 || component(b.v, i) != 0) named |= 1U << i;
  for (const Vec2 p : points) {
    const Vec3 at = from_plane(b, p, holes_.level());
    holes_.approach(at, named, where());
    if (modal_call_ && !drill(*modal_call_)) return false;
  }
  return true;
}

}  // namespace mrsim
