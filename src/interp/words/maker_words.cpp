#include "interp/words/maker_words.h"

#include "interp/text/characters.h"

#include <algorithm>

#include <fmt/format.h>

namespace mrsim {

std::optional<bool> MakerWords::read(const Word& word, Code code) {
  if (is_pocket_of_gsk(word)) return refuse_pocket(word);
  if (is(Dialect::ngc) && (code == Code::circle_pocket || code == Code::scaling_on ||
                           code == Code::rotation_on || (code == Code::probe && word.value == 31)))
    note_once("word-of-mach",
              fmt::format("G{:g} is read as Mach has it; LinuxCNC refuses it", word.value), word,
              fmt::format("G{:g}", word.value));
  const bool polar = code == Code::polar_on || code == Code::polar_off;
  if (polar && peek('H') && !has_length_word()) return okuma_offset(word);
  if (code == Code::suppress_frames && modal_.okuma) {
    modal_.length = Code::length_off;
    block_.length_changed = true;
    return true;
  }
  if (const std::optional<bool> refused = refuse(word)) return refused;
  if (is(Dialect::fanuc) && lathe() && word.value == 105)  // the servo bar feeder of Haas
    note_once("bar-fed", "G105 feeds the bar: it is read as being in its place", word, "G105");
  if (modal_.okuma && word.value >= 101 && word.value <= 120 && word.value != 116)
    return okuma_macro(word);
  const bool mirror = word.value == 101 || (word.value == 100 && !peek('T'));
  if (is(Dialect::fanuc) && !lathe() && mirror && names_zero_places()) return haas_mirror(word);
  if (code == Code::absolute || code == Code::incremental) warn_of_mixed(word);
  if (code == Code::fagor_pocket) {
    modal_.drill = {};
    modal_.drill.number = modal_.pocket.number;
    return true;
  }
  if (is(Dialect::fanuc) && lathe())
    if (const std::optional<bool> lap = okuma_lap(word)) return lap;
  if (is(Dialect::fanuc) && okuma_home(word)) return true;
  if (is(Dialect::fanuc) && !lathe())
    if (const std::optional<bool> local = okuma_frame(word)) return local;
  if (!is(Dialect::fanuc) || lathe() || !peek(word.value == 71 ? 'Z' : 'T')) return std::nullopt;
  if (word.value == 116 && !has_m6()) {  // G116 of Okuma changes the tool
    block_.tool_change = true;
    return true;
  }
  if (word.value == 100) return brother_change(word);
  if (word.value == 71 && stands_for_level(word)) return okuma_level();
  return std::nullopt;
}

// Words that cut or move in ways that are not read. Nothing: it is none of them.
std::optional<bool> MakerWords::refuse(const Word& word) {
  if (is_cycle_of_system_c(word))
    return error("not-supported",
                 fmt::format("{} beside axes and F is a turning cycle of code system C, which is "
                             "not supported: write those of system A, G90, G92 and G94",
                             text_of(word)),
                 word);
  if (!is(Dialect::fanuc)) return std::nullopt;
  if (lathe() && word.value == 95 && peek('R') && (peek('Z') || peek('W')))
    return error("not-supported",
                 "G95 with R taps with a live tool (Haas), which is not supported: tap on the axis "
                 "with G84",
                 word);
  if (const Word* p = peek('P'); p && lathe() && word.value == 105)
    return error("not-supported",
                 "P of G105 runs a program that cuts off, which is not supported: call it by M98",
                 *p);
  // G41.1 of LinuxCNC has the diameter in D, also in programs that are read as FANUC's.
  const bool follows_path = word.value == 41.1 || word.value == 42.1;
  if (follows_path && !peek('D'))
    return error("not-supported",
                 fmt::format("{} without D is normal direction control, where an axis turns the "
                             "tool along the path, which is not supported",
                             text_of(word)),
                 word);
  return std::nullopt;
}

// G22 X Y Z R I L of GSK's mills clears a circle, and G23 to G26 are pockets, too. FANUC's G22 has
// X Y Z I J K, and its G23, G25 and G26 have no axes.
bool MakerWords::is_pocket_of_gsk(const Word& word) const {
  if (is(Dialect::sinumerik) || is(Dialect::codesys) || is(Dialect::ngc)) return false;
  if (word.value == 22) return peek('R') && (peek('X') || peek('Y') || peek('Z'));
  return (word.value == 23 || word.value == 25 || word.value == 26) &&
         (peek('X') || peek('Y') || peek('Z'));
}

bool MakerWords::refuse_pocket(const Word& word) {
  return error("not-supported",
               fmt::format("{} with places (a pocket of GSK's mills and others) is not supported",
                           text_of(word)),
               word);
}

// G20 X46. Z-30. F.25 without a motion word is a cycle of code system C.
bool MakerWords::is_cycle_of_system_c(const Word& word) const {
  if (!lathe() || !is(Dialect::fanuc) || (word.value != 20 && word.value != 21)) return false;
  if (!peek('F') || !(peek('X') || peek('Z') || peek('U') || peek('W'))) return false;
  return std::none_of(block_.words.begin(), block_.words.end(), [&](const Word& other) {
    return other.address == letter('G') && other.value != word.value &&
           (other.value < 4 || (other.value >= 28 && other.value <= 34) || other.value >= 70);
  });
}

bool MakerWords::has_m6() const { return block_.has_code('M', 6); }

// Whether H of the block is that of G43, G44 or G49.
bool MakerWords::has_length_word() const {
  return std::any_of(block_.words.begin(), block_.words.end(), [](const Word& w) {
    return w.address == letter('G') && (w.value == 43 || w.value == 44 || w.value == 49);
  });
}

// Whether places of 0 (X0 Y0) stand beside the G word, and nothing else.
bool MakerWords::names_zero_places() const {
  bool named = false;
  for (const Word& w : block_.words) {
    const bool axis = w.address >= letter('X') && w.address <= letter('Z') && w.value == 0;
    if (!axis && w.address != letter('G') && w.address != letter('N')) return false;
    named |= axis;
  }
  return named;
}

// G101 X0 of Haas mirrors X about the zero, and G100 X0 ends that.
bool MakerWords::haas_mirror(const Word& word) {
  block_.frame_code = &word;
  block_.frame_op = word.value == 101 ? Code::mirror_on : Code::mirror_off;
  return true;
}

// G15 H2 of Okuma's OSP selects a work offset; G16 H does for one block.
bool MakerWords::okuma_offset(const Word& word) {
  if (word.value == 15) return frame_words_.select_numbered(*take('H'));
  return error(
      "not-supported",
      fmt::format("{} H (a work offset of Okuma's OSP for one block) is not supported: write G15 H",
                  text_of(word)),
      word);
}

// G11 with words is a local frame of Okuma, and G10 ends it; FANUC writes G10 and G11 around data.
// G62 X1 is a mirror image.
std::optional<bool> MakerWords::okuma_frame(const Word& word) {
  const bool places = peek('X') || peek('Y') || peek('Z');
  if (word.value == 62 && modal_.okuma && places)
    return error("not-supported", "G62 (a mirror image of Okuma's OSP) is not supported yet", word);
  const bool on = word.value == 11 && (places || peek('P'));
  if (!on && !(word.value == 10 && frames_.turned_locally() && !peek('L'))) return std::nullopt;
  block_.frame_code = &word;
  block_.frame_op = on ? Code::local_turned : Code::local_turned_off;
  return true;
}

// "G90 X10. G91 Y5.": on Mitsubishi and Mazak the G word before an axis holds for that axis.
void MakerWords::warn_of_mixed(const Word& word) {
  const Word* other = nullptr;
  for (const Word& before : block_.words) {
    if (before.address == letter('G') && (before.value == 90 || before.value == 91)) {
      const bool differs = before.value != word.value;
      if (&before == &word) break;
      other = differs ? &before : nullptr;
    } else if (other && before.address >= letter('X') && before.address <= letter('Z')) {
      warning(
          "group-twice",
          fmt::format("{} and {} in one block: the last one counts for all axes; Mitsubishi and "
                      "Mazak read each axis by the word before it, so write two blocks",
                      text_of(*other), text_of(word)),
          word);
      return;
    }
  }
}

// G101 to G120 of Okuma's mills are macros of the machine's owner. G110 and G111 of its lathes say
// which turret the constant surface speed follows.
bool MakerWords::okuma_macro(const Word& word) {
  if (lathe() && (word.value == 110 || word.value == 111)) return true;
  return error(
      "not-supported",
      fmt::format("{} is not supported: on Okuma's controls it is a macro of the machine's "
                  "owner{}",
                  text_of(word), lathe() ? ", or a path on the face of the part" : ""),
      word);
}

// LAP: "G85 NLAP1 D U W" roughs a contour, "G87 NLAP1" finishes it, "NLAP1 G81" begins it.
std::optional<bool> MakerWords::okuma_lap(const Word& word) {
  const int g = static_cast<int>(word.value);
  const bool named = !block_.name.empty() && !peek('X') && !peek('Z') && !peek('F');
  if (named && g >= 81 && g <= 83) {
    block_.lap_begins = &word;
    return true;
  }
  if (block_.contour.empty() || g < 85 || g > 88) return std::nullopt;
  if (g == 86 || g == 88)
    return error("not-supported",
                 fmt::format("G{} {} ({} of Okuma's LAP) is not supported yet", g, block_.contour,
                             g == 86 ? "copy turning" : "threads"),
                 word);
  block_.oneshot = &word;
  block_.oneshot_code = Code::turn_cycle;
  block_.turn_cycle = g == 85 ? 71 : 70;
  return true;
}

// G20 HP=1 and G21 HP=2 go to home positions. The parser has put HP= into P.
bool MakerWords::okuma_home(const Word& word) {
  const Word* p = peek('P');
  if ((word.value != 20 && word.value != 21) || !p || upper(text_of(*p).front()) != 'H')
    return false;
  block_.oneshot = &word;
  block_.oneshot_code = Code::reference_second;
  return true;
}

// Whether G71 Z is the return level: Z stands alone, with no other G word. Otherwise G71 is a
// pattern of holes or the unit.
bool MakerWords::stands_for_level(const Word& word) const {
  return std::all_of(block_.words.begin(), block_.words.end(), [&](const Word& w) {
    return &w == &word || w.address == letter('Z') || w.address == letter('M');
  });
}

// Sets the level to which drilling cycles return under M53.
bool MakerWords::okuma_level() {
  const Word& z = *take('Z');
  modal_.return_level = z.value * length_unit(z);
  return true;
}

// G100 T1 X Y Z G43 H1 of Brother changes the tool above the part, then goes to the place.
bool MakerWords::brother_change(const Word& word) {
  for (const char c : {'L', 'R'}) take(c);  // the next tool, and the position of the door
  block_.tool_change = true;
  block_.home = &word;
  block_.motion_code = &word;
  block_.motion = Code::rapid;
  return true;
}

}  // namespace mrsim
