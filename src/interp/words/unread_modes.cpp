#include "interp/words/unread_modes.h"

#include "interp/text/characters.h"
#include "interp/text/code_table.h"

#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

/// A mode by its G numbers * 10. A mode that its own word ends is ended by C0 or P0.
struct ModeWords {
  int begin, end;
};

/// A mode that follows the rotary axes, and what is the same while these stand at 0.
struct UprightMode {
  int begin, end, as;
};

constexpr ModeWords kFanucModes[] = {
    {71, 71},   {121, 131}, {434, 490},   {435, 490},   {542, 542},  {544, 544},  {682, 690},
    {683, 690}, {684, 690}, {1070, 1070}, {1120, 1130}, {1430, 490}, {2340, 490}, {2540, 2550}};
constexpr UprightMode kUprightModes[] = {
    {434, 490, 430}, {1430, 490, 430}, {2340, 490, 430}, {2540, 2550, 2550}};
constexpr int kLeast = 71;  // the least of the numbers above
constexpr int kTiltedPlane = 682;
constexpr int kRotationOff = 690;
constexpr int kTiltedMove = 531, kMoveAboutTip = 536;  // of the axes into a tilted plane
constexpr std::string_view kSinumerikModes[] = {"TRAORI", "TRANSMIT", "TRACYL", "TRAANG"};
constexpr int kTrafoof = 1;  // in place of a G number: TRAFOOF ends the mode
constexpr int kSwivel = 2;   // the next CYCLE800 ends it
constexpr int kIsoMode = 2910, kSiemensMode = 2900;

int number_by_10(const Word& word) {
  return word.address == letter('G') && word.value >= 0 && word.value < 1e4
             ? static_cast<int>(std::lround(word.value * 10))
             : -1;
}

}  // namespace

// Whether the word ends the mode in force, or says that there is none.
bool UnreadModes::ends(int g) {
  for (const ModeWords& mode : kFanucModes) {
    if (mode.end != g) continue;
    if (mode.begin != g) return control_.unread_end == g;
    for (const char c : {'C', 'P'})
      if (const Word* value = peek(c); value && value->value == 0) return take(c) != nullptr;
  }
  return false;
}

// G68.2 has the angles of Euler (about Z, X, Z), of which the second tilts, or behind P1 the angles
// about X, Y and Z, of which the first two tilt.
bool UnreadModes::is_untilted() const {
  if (lathe()) return false;
  const auto zero = [&](char c) {
    const Word* w = peek(c);
    return w && w->value == 0;
  };
  const Word* p = peek('P');
  return zero('J') && (!p || p->value == 0 || (p->value == 1 && zero('I')));
}

bool UnreadModes::begins_or_ends(const Word& word) {
  if (is(Dialect::ngc) || is(Dialect::codesys)) return false;
  if (is(Dialect::sinumerik)) {
    return note_name(word) || begins_iso_mode(word);
  }
  const int g = number_by_10(word);
  if (g < kLeast) return false;
  if (g == kTiltedPlane && is_untilted()) {
    control_.untilted_plane = true;
    block_.frame_code = &word;
    block_.frame_op = Code::rotation_on;
    return true;
  }
  const bool moves = g == kTiltedMove || g == kMoveAboutTip;
  if (moves && (control_.unread_end != 0 || control_.untilted_plane)) return true;
  if (g == kRotationOff) control_.untilted_plane = false;
  const bool ended = ends(g);
  if (ended) control_.unread_end = 0;
  if (g == control_.upright_end) control_.upright_end = 0;
  if (begins_upright(g, word)) return false;
  for (const ModeWords& mode : kFanucModes) {
    if (mode.begin != g) continue;
    if (!ended) control_.unread_end = mode.end;
    return ended;
  }
  return false;
}

bool UnreadModes::begins_upright(int g, const Word& word) {
  for (const UprightMode& mode : kUprightModes) {
    if (mode.begin != g || lathe() || control_.tilted || control_.unread_end != 0) continue;
    begin_upright(mode.end, word);
    return true;
  }
  return false;
}

void UnreadModes::begin_upright(int end, const Word& word) {
  control_.upright_end = end;
  note_once("tool-upright",
            fmt::format("{} is read as with a tool along Z, while all rotary axes stand at 0",
                        text_of(word)),
            word, "upright");
}

int UnreadModes::read_as(int number) const {
  if (control_.upright_end == 0) return number;
  for (const UprightMode& mode : kUprightModes)
    if (mode.begin == number) return mode.as;
  return number;
}

bool UnreadModes::tilts(const Word& word) {
  const std::string text = text_of(word);
  const char axis = upper(text.front()), kind = text.size() > 1 ? text[1] : ' ';
  const bool zero = word.value == 0, along = axis == 'C' && word.value > 0;
  if (control_.upright_end != 0 &&
      (kind == '3' ? (axis == 'C' ? along : zero) : kind == '2' && zero))
    return false;
  turn();
  return true;
}

void UnreadModes::turn() {
  control_.tilted = true;
  if (control_.upright_end != 0) control_.unread_end = std::exchange(control_.upright_end, 0);
}

// The text between G291 and G290 is FANUC's, with FANUC's characters.
bool UnreadModes::begins_iso_mode(const Word& word) {
  if (number_by_10(word) != kIsoMode) return false;
  error("not-supported",
        fmt::format("{} ({}) is not supported yet: nothing is read up to G290", text_of(word),
                    unsupported_code(control_.dialect, kIsoMode)),
        word);
  control_.unread_end = kSiemensMode;
  forget_place(kAllAxes);
  reporter_.set_muted(true);
  return true;
}

bool UnreadModes::skips_iso_mode() {
  if (control_.unread_end != kSiemensMode) return false;
  for (const Word& word : block_.words)
    if (number_by_10(word) == kSiemensMode) {
      control_.unread_end = 0;
      reporter_.set_muted(false);
    }
  return true;
}

// Looks at the name of a mode. True: TRAORI, which is done with.
bool UnreadModes::note_name(const Word& word) {
  if (word.address != Address::function) return false;
  const std::string name = upper_case(word.text);
  if (name == "TRAFOOF") control_.unread_end = control_.upright_end = 0;
  if (name == "TRAORI" && !control_.tilted && !lathe()) {
    if (control_.unread_end == 0) begin_upright(kTrafoof, word);
    return true;
  }
  for (const std::string_view one : kSinumerikModes)
    if (name == one) control_.unread_end = kTrafoof;
  return false;
}

void UnreadModes::begin_swivel() { control_.unread_end = kSwivel; }

bool UnreadModes::ends_swivel() {
  if (control_.unread_end != kSwivel || block_.function_name != "CYCLE800") return false;
  control_.unread_end = 0;
  return true;
}

void UnreadModes::pass_over() {
  for (const Word& word : block_.words) {
    take(word.address);
    const auto c = static_cast<char>(word.address);
    if ((c >= 'U' && c <= 'W') || (c >= 'X' && c <= 'Z')) forget_place(kAllAxes);
  }
}

}  // namespace mrsim
