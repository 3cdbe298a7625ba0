#include "interp/words/iso_words.h"

#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "core/text/text_io.h"
#include "interp/words/fagor_places.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace mrsim {
namespace {

/// What an unsupported G word does; empty for any other word.
std::string_view unread(int code) {
  switch (code) {
    case 32:
      return "zero offsets that G31 has kept";
    case 37:
      return "a tangential entry";
    case 38:
      return "a tangential exit";
    default:
      return {};
  }
}

}  // namespace

bool IsoWords::has_any(std::string_view letters) {
  for (const char c : letters)
    if (block_.search(c)) return true;
  return false;
}

bool IsoWords::has_motion() const { return block_.has_code('G', 0, 3); }

bool IsoWords::rewrite() {
  bool ok = true;
  for (std::size_t i = 0; i < block_.words.size();) {
    bool gone = false;
    if (block_.words[i].address == letter('G') && !rewrite_word(i, gone)) ok = false;
    if (gone)
      block_.words.erase(block_.words.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  }
  split_tool();
  return ok && rewrite_polar();
}

// T2.12 is tool 2 with the offset 12.
void IsoWords::split_tool() {
  Word* const tool = block_.search('T');
  if (!tool || tool->string || tool->value == std::floor(tool->value)) return;
  const std::string text = text_of(*tool);
  const auto offset = parse_number(text.substr(std::min(text.find('.'), text.size() - 1) + 1));
  if (!offset) return;
  Word edge = *tool;
  edge.address = letter('D');
  edge.value = *offset;
  tool->value = std::floor(tool->value);
  note_once("tool-station",
            fmt::format("{} is read as tool {:g} with offset {:g}, as Fagor writes them", text,
                        tool->value, edge.value),
            *tool, text);
  if (!block_.search('D')) block_.words.push_back(edge);
}

// Q, and R beside it, become AP and RP in a straight move, at the places of a cycle and in an arc
// about the polar origin. A value that is left out is that of the position. check_polar() reports
// all other uses.
bool IsoWords::rewrite_polar() {
  Word* const angle = block_.search('Q');
  Word* const radius = block_.search('R');
  constexpr std::string_view kOthers[] = {"XYLABCD", "XZLABCD", "YZLABCD"};
  constexpr std::string_view kCenters[] = {"IJ", "IK", "JK"}, kPitches[] = {"K", "J", "I"};
  if (!angle || lathe() || modal_.plane == kPlaneOfNormal) return true;
  const auto plane = static_cast<std::size_t>(modal_.plane);
  const bool centered = has_any(kCenters[plane]);
  if (has_any(kOthers[plane]) || (!centered && has_any(kPitches[plane]))) return true;
  Code motion = modal_.drill.number != 0 ? Code::line : modal_.motion;
  if (modal_.drill.number != 0 && !modal_.drill.fagor) return true;
  bool incremental = modal_.incremental;
  for (const Word& word : block_.words) {
    if (word.address == Address::function || word.address == letter('M')) return true;
    if (word.address != letter('G')) continue;
    const double g = word.value;
    if (g == 90 || g == 91) {
      incremental = g == 91;
    } else if (g >= 0 && g <= 3 && g == std::floor(g)) {
      constexpr Code kMotions[] = {Code::rapid, Code::line, Code::arc_cw, Code::arc_ccw};
      motion = kMotions[static_cast<std::size_t>(g)];
    } else if (!(g >= 40 && g <= 44) && !(g >= 54 && g <= 59) && g != 94 && g != 95 &&
               g != 17 + modal_.plane) {
      return true;
    }
  }
  const bool straight = motion == Code::rapid || motion == Code::line;
  if (centered ? straight : !straight && !is_circular(motion)) return true;
  if (!straight && radius) return true;
  if (centered) return to_end_of_angle(*angle, incremental), true;
  angle->address = Address::ap;
  if (radius) {
    radius->address = Address::rp;
    if (incremental) radius->form = Form::ic;
  }
  position_.has_polar_radius = position_.has_polar_angle = false;
  return true;
}

// G3 Q I J: the end lies at the angle Q about the centre; in G91 Q counts from the start.
void IsoWords::to_end_of_angle(Word& angle, bool incremental) {
  constexpr std::string_view kAxes[] = {"XY", "ZX", "YZ"};
  const Basis b = basis();
  Vec3 at = position_.programmed;
  for (int i = 0; i < 3; ++i) {
    const Word* const word = block_.search("IJK"[i]);
    if (!word || component(b.w, i) != 0) continue;
    component(at, i) =
        (word->form == Form::ac ? 0 : component(at, i)) + word->value * length_unit(*word);
  }
  const Vec2 center = in_plane(b, at), from = in_plane(b, position_.programmed) - center;
  const double turned = incremental ? degrees(atan2(from.y, from.x)) : 0;
  const SinCos sc = sincos_deg(turned + angle.value);
  const Vec2 end = center + length(from) * Vec2{sc.cos, sc.sin};
  const std::string_view axes = kAxes[static_cast<std::size_t>(modal_.plane)];
  angle.form = Form::ac;
  Word second = angle;
  angle.address = letter(axes[0]);
  angle.value = end.x / scale();
  second.address = letter(axes[1]);
  second.value = end.y / scale();
  block_.words.push_back(second);
}

// G words that leave the block: other words carry their meaning, or they have no effect on the
// part. `gone`: the word goes. Nothing: it is another word.
std::optional<bool> IsoWords::absorb(const Word& word, int code, bool& gone) {
  switch (code) {
    case 5:  // rounded and square corners; with P, or I J of its own, a word of another control
    case 7:
      gone = !has_any("P") && (has_motion() || !has_any("IJ"));
      return true;
    case 6:
      gone = true;
      return absolute_center(word);
    case 31:
      gone = !has_any("XYZ");
      return true;
    case 36:
    case 39:
      gone = true;
      return to_corner(code == 36 ? Address::rnd : Address::chr, word);
    case 51:  // Fagor's look-ahead, with its acceleration and tolerance
      gone = !has_any("XYZPIJK");
      for (const char c : {'A', 'B', 'E'})
        if (Word* const value = block_.search(c); value && gone) value->address = Address::data;
      return true;
    default:
      return std::nullopt;
  }
}

// `gone`: the G word has been read and is removed.
bool IsoWords::rewrite_word(std::size_t at, bool& gone) {
  Word& word = block_.words[at];
  const int code = word.value >= 0 && word.value < 100 ? static_cast<int>(word.value) : -1;
  if (code < 0 || word.value != code) return true;
  if (const std::optional<bool> read = absorb(word, code, gone)) return *read;
  const bool bare = block_.words.size() == 1;
  switch (code) {
    case 8:
      if (has_any("P") || !has_any("XYZ")) return true;
      word.address = Address::function;
      word.code = Code::arc_tangent;
      return true;
    case 9:
      return to_point_arc(word);
    case 10:
      if (!has_any("LP")) to_frame(Code::fagor_mirror, word);
      return true;
    case 11:
    case 12:
    case 13:
      if (code == 11 || !has_any("I")) to_frame(Code::fagor_mirror, word);
      return true;
    case 17:
    case 18:
    case 19:
      position_.pole = {};  // each plane begins with its own polar origin
      return true;
    case 87:
    case 88:
      if (has_any("JB")) return to_pocket(word);
      modal_.pocket = {};
      return true;
    case 93:
      return to_polar_origin(word);
    case 72:
      if (!has_any("S")) return true;
      if (has_any("XYZ")) return read_places(word, code);
      to_frame(Code::fagor_scale, word);
      return true;
    case 73:
      if (bare || (has_any("Q") && !has_any("XYZR"))) to_frame(Code::fagor_turn, word);
      return true;
    default:
      break;
  }
  const std::string_view what = unread(code);
  if (what.empty()) return read_places(word, code);
  return error("not-supported", fmt::format("{} ({}) is not supported yet", text_of(word), what),
               word);
}

// G60 to G65 repeat the cycle in force at places, G72 S X scales one axis.
bool IsoWords::read_places(Word& word, int code) {
  const char* what = "";
  const bool in_range = code >= 60 && code <= 65, cycle = modal_.drill.number != 0;
  if (in_range && cycle && FagorPlaces::knows(code) && has_any("XYIK"))
    return FagorPlaces(control_).read(word);
  if (in_range && has_any("XYZ") && has_any("IJKCDP") && (cycle || !is_circular(modal_.motion)))
    what = "the places of a cycle";
  else if (code == 72 && has_any("S"))
    what = "a scale of one axis";
  if (*what == '\0') return true;
  return error("not-supported", fmt::format("{} ({}) is not supported yet", text_of(word), what),
               word);
}

// G87 Z I J K B C D: the words are lengths of the pocket, not axes or registers. H, L and V say how
// it is finished.
bool IsoWords::to_pocket(Word& word) {
  const bool round = word.value == 88;
  bool incremental = modal_.incremental;
  for (const Word& other : block_.words)
    if (other.address == letter('G') && (other.value == 90 || other.value == 91))
      incremental = other.value == 91;
  for (const char c : std::string_view(round ? "IJB" : "IJKB"))
    if (!has_any({&c, 1}))
      return error("value-missing", fmt::format("{} needs {}", text_of(word), c), word);
  const auto length = [&](char c) {
    Word* const given = block_.search(c);
    if (!given) return 0.0;
    given->address = Address::data;
    return given->value * length_unit(*given);
  };
  FagorPocket pocket;
  pocket.number = static_cast<int>(word.value);
  const char normal = "ZYX"[modal_.plane % 3];
  const bool level = block_.search(normal) != nullptr;
  pocket.reference = {length(normal), incremental, level};
  pocket.depth = {length('I'), incremental, true};
  const double j = length('J');
  pocket.clockwise = j > 0;
  pocket.half_length = std::abs(j);
  pocket.half_width = std::abs(length('K'));
  pocket.infeed = std::abs(length('B'));
  pocket.width = std::abs(length('C'));
  pocket.above = std::abs(length('D'));
  for (const char c : {'H', 'L', 'V'}) length(c);
  modal_.pocket = pocket;
  to_frame(Code::fagor_pocket, word);
  return true;
}

void IsoWords::to_frame(Code code, Word& word) {
  word.address = Address::function;
  word.code = code;
}

bool IsoWords::to_corner(Address corner, const Word& word) {
  Word* const size = block_.search('R');
  if (!size) return error("value-missing", "the size of the corner is missing: R", word);
  size->address = corner;
  return true;
}

// I and J of G93 are abscissa and ordinate of the polar origin. G93 without them is a feed.
bool IsoWords::to_polar_origin(Word& word) {
  constexpr std::string_view kAxes[] = {"XY", "ZX", "YZ"};
  Word *const i = block_.search('I'), *const j = block_.search('J');
  if (!i && !j) return true;
  if (!i || !j || block_.words.size() != 3 || modal_.plane == kPlaneOfNormal)
    return error("value-missing",
                 "G93 I J, the origin of polar coordinates, stands alone with both", word);
  const std::string_view axes = kAxes[modal_.plane];
  i->address = letter(axes[0]);
  j->address = letter(axes[1]);
  to_frame(Code::pole_zero, word);
  return true;
}

// G9 X Y I J is an arc through the point I J. G9 without these words is an exact stop.
bool IsoWords::to_point_arc(Word& word) {
  if (!has_any("IJK")) return true;
  for (Word& other : block_.words)
    if (other.address >= letter('I') && other.address <= letter('K'))
      other.address = static_cast<Address>(static_cast<int>(Address::i1) +
                                           (static_cast<int>(other.address) - 'I'));
  word.address = Address::function;
  word.code = Code::arc_point;
  return true;
}

bool IsoWords::absolute_center(const Word& word) {
  int count = 0;
  for (Word& other : block_.words) {
    if (other.address < letter('I') || other.address > letter('K')) continue;
    other.form = Form::ac;
    ++count;
  }
  return count == 2 || error("arc-no-center", "G6 needs both coordinates of the centre", word);
}

bool IsoWords::check_polar() {
  const Code motion = current_motion();
  if (modal_.drill.number != 0 && !(modal_.drill.fagor && block_.unused(letter('Q')))) return true;
  const bool straight = motion == Code::rapid || motion == Code::line;
  for (const char c : {'Q', 'R'})
    if (block_.unused(letter(c)) && (straight || (c == 'Q' && is_circular(motion))))
      return error(
          "not-supported",
          fmt::format("{} is a polar coordinate here, which is read as Q alone, or Q and R "
                      "of a straight move, without axes and centres",
                      text_of(*peek(c))),
          *peek(c));
  return true;
}

}  // namespace mrsim
