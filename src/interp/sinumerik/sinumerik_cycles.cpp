#include "interp/sinumerik/sinumerik_cycles.h"

#include "interp/cycles/cycle_call.h"
#include "interp/sinumerik/hole_pattern.h"
#include "interp/sinumerik/hole_values.h"
#include "interp/statements/statements.h"
#include "interp/text/characters.h"
#include "interp/words/unread_modes.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

namespace mrsim {
namespace {

// Cycles of SINUMERIK 802S and 802C, LCYC82 and its kin, read R parameters. Each one is a later
// cycle with these values.
struct CycleOf802 {
  std::string_view name, cycle;
  std::string_view values;  ///< of the later cycle's list; behind that of CYCLE83 its feed
};

constexpr CycleOf802 kCycles802[] = {
    {"LCYC60", "HOLES1", "R116,R117,R120,R118,R121,R119"},
    {"LCYC61", "HOLES2", "R116,R117,R118,R120,R121,R119"},
    {"LCYC75", "POCKET3",
     "R101,R103,R102,R104,R118,R119,R120,R116,R117,0,R121,R124,R125,R123,R122,R126,R127+10"},
    {"LCYC82", "CYCLE82", "R101,R103,R102,R104,,R105"},
    {"LCYC83", "CYCLE83", "R101,R103,R102,R104,,R110,,R111,R105,R109,1,R127,,,,,,,,,R107"},
    {"LCYC84", "CYCLE84", "R101,R103,R102,R104,,R105,5,,R106,0,R112,R113"},
    {"LCYC840", "CYCLE840", "R101,R103,R102,R104,,0,0,R126,0,,R106"},
    {"LCYC85", "CYCLE85", "R101,R103,R102,R104,,R105,R107,R108"},
    {"LCYC95", "CYCLE95", "_CNAME,R108,0,0,R106,R111,R111,R112,R105,,,R110"},
    {"LCYC97", "CYCLE97",
     "R104,,R101,R103,R100,R102,R109,R110,R111,R106,0,R112,R113,0,R105+2,R114"}};

const CycleOf802* find_cycle_of_802(std::string_view name) {
  const auto* const found = std::find_if(std::begin(kCycles802), std::end(kCycles802),
                                         [&](const CycleOf802& c) { return c.name == name; });
  return found == std::end(kCycles802) ? nullptr : found;
}

bool is_cycle_of_802(std::string_view name) { return find_cycle_of_802(name) != nullptr; }

// Fills in the name and the values of the later cycle. Requires: is_cycle_of_802(name). False: an
// error was reported at `where`.
bool read_cycle_of_802(std::string_view name, Statements* statements, const Word& where,
                       CycleCall& call) {
  const CycleOf802& row = *find_cycle_of_802(name);
  call.name = std::string(row.cycle);
  call.written = std::string(name);
  for (std::string_view rest = row.values;;) {
    const std::string_view value = rest.substr(0, rest.find(','));
    call.values.emplace_back();
    if (!value.empty()) {
      call.values.back().emplace();
      if (!statements || !statements->value_of(value, *call.values.back(), where)) return false;
    }
    if (value.size() == rest.size()) return true;
    rest.remove_prefix(value.size() + 1);
  }
}

constexpr std::array<std::string_view, 13> kMeasuring = {
    "CYCLE971", "CYCLE973", "CYCLE974", "CYCLE976", "CYCLE977", "CYCLE978", "CYCLE979",
    "CYCLE982", "CYCLE994", "CYCLE995", "CYCLE996", "CYCLE997", "CYCLE998"};

bool measures(std::string_view name) {
  return std::find(kMeasuring.begin(), kMeasuring.end(), name) != kMeasuring.end();
}

}  // namespace

bool SinumerikCycles::knows(std::string_view name) {
  return HoleValues::knows(name) || is_cycle_of_802(name) || MillCycles::knows(name) ||
         SinumerikContours::knows(name) || TurnCycles::knows(name) || measures(name) ||
         SinumerikEngraving::knows(name) || HolePattern::knows(name) || name == "CYCLE800";
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
  if (is_cycle_of_802(block_.function_name))
    return read_cycle_of_802(block_.function_name, statements_, where(), call);
  if (!statements_ || !statements_->call_values(block_.argument, call.values)) return false;
  std::string_view rest = list_of_cycle(call.name);
  for (std::size_t i = 0; i < call.values.size(); ++i) {
    bool text = false;
    const std::string_view name = next_value_name(rest, text);
    if (call.values[i] && !call.values[i]->text.empty() && !text)
      return error("expression",
                   fmt::format("{}: value {}{} is a text or an axis, and not a number (alarm "
                               "12150)",
                               call.name, i + 1, name.empty() ? "" : fmt::format(", {},", name)),
                   where());
  }
  return true;
}

// Lists of newer software are longer. The meaning of their last values is not known here.
void SinumerikCycles::tell_unread(const Call& call) {
  if (!MillCycles::knows(call.name) && !HoleValues::knows(call.name)) return;
  std::string_view rest = list_of_cycle(call.name);
  bool text = false;
  std::size_t known = 0;
  for (; !rest.empty(); ++known) next_value_name(rest, text);
  for (std::size_t i = known; known > 0 && i < call.values.size(); ++i) {
    const std::optional<Value>& value = call.values[i];
    if (!value || (value->is_number() ? value->number == 0 : value->text.empty())) continue;
    warning(
        "word-without-effect",
        fmt::format("{}: value {} stands behind the last one that is known ({}) and is not read",
                    call.name, i + 1, known),
        where());
    return;
  }
}

// A measuring cycle cuts nothing, and only the machine knows what it finds, so offsets do not
// change.
bool SinumerikCycles::measure() {
  forget_place(kAllAxes);
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
  tell_unread(call);
  if (contours_.reads_contour())
    return error("not-supported", fmt::format("{} inside the contour of a cycle", call.name),
                 where());
  if (MillCycles::knows(call.name)) return run_mill(call, false);
  if (SinumerikContours::knows(call.name)) return contours_.run(call, where());
  if (TurnCycles::knows(call.name)) return turns_.run(call, where());
  if (SinumerikEngraving::knows(call.name)) return engraving_.run(call, where());
  if (HoleValues::knows(call.name)) return drill(call);
  if (call.name == "CYCLE800") return swivel(call);
  return call.written.empty() ? pattern(call) : pattern_802(call);
}

bool SinumerikCycles::modal_call() {
  modal_call_.reset();
  if (block_.function_name.empty()) return true;
  Call call;
  if (!read_call(call)) return false;
  Hole test;
  if (!MillCycles::knows(call.name) && !HoleValues(control_, tools_, call, where()).read(test))
    return false;
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

// The unit of DMODE puts the cycle in G17, G18 or G19, whichever plane is in force.
bool SinumerikCycles::run_mill(const Call& call, bool at_position) {
  const int plane = modal_.plane, own = call.digit("DMODE", 0);
  if (own >= 1 && own <= 3) modal_.plane = own - 1;
  const bool ok = mills_.run(call, where(), at_position);
  modal_.plane = plane;
  return ok;
}

// The motions name the line of MCALL, as called from the line of the place.
bool SinumerikCycles::mill(const Call& call) {
  const int line = block_.line_number, file = block_.file, site = block_.call;
  block_.call = reader_.call_site(line);
  block_.file = call.place.file;
  block_.line_number = call.place.line;
  const bool ok = run_mill(call, true);
  block_.line_number = line;
  block_.file = file;
  block_.call = site;
  return ok;
}

bool SinumerikCycles::drill(const Call& call) {
  if (MillCycles::knows(call.name)) return mill(call);
  const int plane = modal_.plane;
  const Word at = where();
  HoleValues values(control_, tools_, call, at);
  Hole made;
  const bool ok = values.choose_plane() && values.read(made);
  if (ok) holes_.drill(made, call.place, at);
  modal_.plane = plane;
  return ok;
}

bool SinumerikCycles::pattern(const Call& call) {
  const Word at = where();
  HolePattern pattern(control_, call, at);
  if (!pattern.reads_all_of()) return false;
  std::vector<Vec2> places;
  if (!pattern.places(places)) return false;
  return statements_ && statements_->has_modal_call() ? call_at(places) : at_points(places);
}

// The values of CYCLE800: FR TC ST MODE X0 Y0 Z0 A B C X1 Y1 Z1. Pairs of bits of MODE say about
// which axes A B C turn.
bool SinumerikCycles::swivel(const Call& call) {
  const auto mode = static_cast<unsigned>(std::clamp(call.get("MODE"), 0.0, 255.0));
  double angle = 0;
  static constexpr ValueName kTurns[] = {"A", "B", "C"};
  for (unsigned i = 0; i < 3; ++i) {
    const double turn = call.get(kTurns[i]);
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
  const auto shift = [&](ValueName x, ValueName y, ValueName z) {
    return shift_frame(scale() * Vec3{call.get(x), call.get(y), call.get(z)});
  };
  const Frame turned = angle != 0 ? rotation_frame(2, angle) : Frame{};
  frame_words_.transforms().swivel(
      compose(compose(shift("X0", "Y0", "Z0"), turned), shift("X1", "Y1", "Z1")),
      call.digit("ST", 0) == 1, where());
  return true;
}

// A rapid in the plane, at the current level.
void SinumerikCycles::go_to(const Vec2& place, const Word& at) {
  const Basis b = basis();
  holes_.approach(from_plane(b, place, holes_.level()), axes_along(b.u) | axes_along(b.v), at);
}

// Without MCALL the pattern is a row of rapids.
bool SinumerikCycles::at_points(const std::vector<Vec2>& points) {
  for (const Vec2 p : points) {
    go_to(p, where());
    if (modal_call_ && !drill(*modal_call_)) return false;
  }
  return true;
}

// Under MCALL of a program this runs at each place. The rapids name the line of the pattern.
bool SinumerikCycles::call_at(const std::vector<Vec2>& points) {
  const BlockPlace pattern{block_.file, block_.line_number, block_.call};
  const auto approach = [this, points, pattern, at = where()](std::size_t i) {
    const BlockPlace now{block_.file, block_.line_number, block_.call};
    const auto set = [this](const BlockPlace& place) {
      block_.file = place.file;
      block_.line_number = place.line;
      block_.call = place.call;
    };
    set(pattern);
    go_to(points[i], at);
    set(now);
  };
  return statements_->call_modal(points.size(), approach, where());
}

// LCYC60 and LCYC61 are patterns; R115 is the number of the cycle that drills each hole.
bool SinumerikCycles::pattern_802(const Call& places) {
  Value number;
  if (!statements_->value_of("R115", number, where())) return false;
  Call drilling;
  drilling.place = places.place;
  const std::string name = fmt::format("LCYC{:g}", number.number);
  if (!is_cycle_of_802(name) || number.number < 82)
    return error("value-range", "R115 is the number of a drilling cycle: 82, 83, 84, 840 or 85",
                 where());
  if (!read_cycle_of_802(name, statements_, where(), drilling)) return false;
  modal_call_ = drilling;
  const bool ok = pattern(places);
  modal_call_.reset();
  return ok;
}

}  // namespace mrsim
