#include "interp/words/modal_words.h"

#include "core/numbers/rounding.h"
#include "interp/text/characters.h"
#include "interp/text/code_names.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr Code kMotions[] = {
    Code::rapid,   Code::line,           Code::arc_cw,           Code::arc_ccw,
    Code::thread,  Code::thread_growing, Code::thread_shrinking, Code::tap_in,
    Code::tap_out, Code::tap_return,     Code::spline_cubic,     Code::spline_quadratic,
    Code::nurbs,   Code::nurbs_end};

bool is_motion(Code code) {
  return std::find(std::begin(kMotions), std::end(kMotions), code) != std::end(kMotions);
}

}  // namespace

bool ModalWords::apply() {
  bool ok = true;
  block_.comp_before = modal_.comp;
  for (const Word& word : block_.words) {
    if (word.address != letter('G') && word.address != Address::function) continue;
    if (unread_.begins_or_ends(word)) continue;
    const CodeEntry entry = lookup(word);
    if (!claim_group(word, entry) || !apply_code(word, entry)) ok = false;
  }
  return ok;
}

CodeEntry ModalWords::lookup(const Word& word) const {
  if (word.address == Address::function) {
    CodeEntry entry = is(Dialect::sinumerik) ? find_function(upper_case(word.text)) : CodeEntry{};
    entry.code = word.code;
    return entry;
  }
  const double by_10 = word.value * 10;
  if (by_10 < 0 || by_10 >= 1e5 || by_10 != std::floor(by_10)) return {};
  const int number = unread_.read_as(static_cast<int>(by_10));
  if (number % 10 == 0 && number < 10000) return codes_[static_cast<std::size_t>(number / 10)];
  return find_g_code(control_.dialect, program_.machine, number);
}

// Two words of one modal group contradict each other; the dialect decides what happens then.
bool ModalWords::claim_group(const Word& word, const CodeEntry& entry) {
  if (entry.code == Code::motion_off || entry.code == Code::cycle_off) return true;
  const bool dynamics = entry.group == Group::exact || entry.group == Group::path;
  if (entry.group == Group::none || entry.group == Group::other ||
      (dynamics && !is(Dialect::sinumerik)))
    return true;
  if (!block_.has_group(entry.group)) {
    block_.add_group(entry.group);
    return true;
  }
  if (is(Dialect::fanuc)) return true;
  if (is(Dialect::sinumerik))
    return error("group-twice",
                 entry.group == Group::frame
                     ? "two frame words in one block (alarm 12070)"
                     : "two words of one G group in one block (alarm 12060)",
                 word);
  if (is(Dialect::ngc)) return error("group-twice", "two words of one G group in one block", word);
  warning("group-twice", "two words of one G group in one block: the last one counts", word);
  return true;
}

// G92 and G94 of a lathe are cycles. But without an axis G92 S limits the speed, and G94 is the
// feed per minute of code systems B and C, which write the cycles as G77 G78 G79.
bool ModalWords::select_turning(const Word& word, int number) {
  if (number >= 77 && number <= 79) number = number == 79 ? 94 : 90 + 2 * (number - 77);
  const bool has_axes = peek('X') || peek('Z') || peek('U') || peek('W');
  if (!has_axes && number == 94) return plain_.apply_feed(Code::per_minute, word);
  if (!has_axes && number == 92) return for_oneshot(word, Code::set_position);
  keep_turning_end(word, number);
  modal_.turn.number = number;
  modal_.drill.number = 0;
  return true;
}

// X, Z and the taper are common to the three cycles, so a change from one to another keeps them.
void ModalWords::keep_turning_end(const Word& word, int number) {
  TurnCycle& cycle = modal_.turn;
  if (cycle.number == 0) cycle = {};
  if (cycle.number != number && cycle.taper != 0 && !peek('R') && !peek('I') && !peek('K'))
    warning("cycle-taper",
            "the taper R of the cycle before stays in force, as R is common to G90, G92 and G94; "
            "write R0 for none",
            word);
}

// P of G4 is the time of a dwell. Alone in the block, WinCNC writes it as X, Marlin and RepRap as
// S.
bool ModalWords::pause(const Word& word) {
  block_.pause = take('P');
  if (block_.pause) return true;
  if (block_.words.size() == 2) block_.pause = peek('X') ? take('X') : take('S');
  if (!block_.pause) return error("value-missing", "G4 needs P, its seconds", word);
  reporter_.once(Severity::warning, "dwell-unit",
                 "X or S beside G4 is read as seconds; LinuxCNC refuses the block", word, "G4");
  return true;
}

bool ModalWords::refuse_unknown(const Word& word) {
  const std::string_view alarm = is(Dialect::sinumerik) ? " (alarm 12470)"
                                 : is(Dialect::fanuc)   ? " (alarm 010)"
                                                        : "";
  return error("g-unknown", fmt::format("G{:g} is not known to this control{}", word.value, alarm),
               word);
}

// G70 and G71 without other words are units, not patterns.
bool ModalWords::hole_pattern(const Word& word, Code code) {
  const bool is_unit = (word.value == 70 || word.value == 71) && !peek('I') && !peek('L');
  return is_unit ? set_units(word) : for_oneshot(word, code);
}

// G22 has places of its own. Axes and F beside G103 and G187 (Haas), and axes beside G131 (Okuma),
// are those of a move.
bool ModalWords::ignore_words(const Word& word) {
  const std::string_view left = word.value == 103 || word.value == 187 ? "GMNTSXYZIJKRUVWABCF"
                                : word.value == 131                    ? "GMNTSXYZ"
                                                                       : "GM";
  for (const Word& other : block_.words)
    if (left.find(static_cast<char>(other.address)) == std::string_view::npos) take(other.address);
  return true;
}

bool ModalWords::select_motion(const Word& word, Code code) {
  modal_.drill.number = 0;
  modal_.turn.number = 0;
  block_.motion_code = &word;
  modal_.motion = code;
  return true;
}

bool ModalWords::end_cycle(const Word& word, Code code) {
  modal_.drill.number = 0;
  block_.ends_cycle = &word;
  if (code == Code::motion_off && !block_.motion_code) modal_.motion = code;
  return true;
}

// Cycles of turning, drilling and milling. Nothing: the word is no word of a cycle.
std::optional<bool> ModalWords::apply_cycle(const Word& word, const CodeEntry& entry) {
  switch (entry.code) {
    case Code::turn_pass:
      return select_turning(word, entry.number);
    case Code::turn_cycle:
      if (units_of_mach(word)) return true;
      block_.turn_cycle = entry.number;
      return for_oneshot(word, entry.code);
    case Code::engrave:
      if (!peek('P')) return refuse(word);
      return for_oneshot(word, entry.code);
    case Code::circle_pocket:
    case Code::contour_pocket:
    case Code::figure_copy:
      return for_oneshot(word, entry.code);
    case Code::hole_pattern:
      return hole_pattern(word, entry.code);
    case Code::drill_cycle:
      select_cycle(word, entry.number);
      return true;
    case Code::cycle_off:
    case Code::motion_off:
      return end_cycle(word, entry.code);
    case Code::return_initial:
    case Code::return_r:
      modal_.return_told = true;
      modal_.hole_return = entry.code == Code::return_r ? HoleReturn::safe : HoleReturn::initial;
      return true;
    default:
      return std::nullopt;
  }
}

bool ModalWords::apply_code(const Word& word, const CodeEntry& entry) {
  if (is(Dialect::iso) && word.value >= 20 && word.value <= 29 && block_.number_behind(word))
    return error("not-supported",
                 fmt::format("{} with N (a call or a jump of Fagor's 8025) is not supported yet",
                             text_of(word)),
                 word);
  if (const std::optional<bool> read = makers_.read(word, entry.code)) return *read;
  if (const std::optional<bool> read = apply_cycle(word, entry)) return *read;
  switch (entry.code) {
    case Code::dwell:
      if (!is(Dialect::ngc)) return apply_modal_code(word, entry);
      return pause(word);
    case Code::unknown:
      return refuse_unknown(word);
    case Code::statement:
    case Code::unsupported:
      return refuse(word);
    case Code::fagor_mirror:
    case Code::fagor_scale:
    case Code::fagor_turn:
      return frame_words_.transforms().fagor(entry.code, word);
    case Code::reference_store:
      if (position_.known == kAllAxes)
        control_.stored_places[word.value < 30 ? 0 : 1] = position_.physical;
      return true;
    case Code::ignored:
      return true;
    case Code::path_continuous:
    case Code::path_exact:
    case Code::path_stops:
    case Code::path_stops_once:
      return path_modes_.select(word, entry.code);
    case Code::ignored_words:
      return ignore_words(word);
    case Code::high_speed:
      return path_modes_.look_ahead(word);
    case Code::probe:
      if (!peek('X') && !peek('Y') && !peek('Z') &&
          !(lathe() && (peek('U') || peek('W') || peek('B'))))
        return error("motion-missing", "a probing move needs an axis", word);
      return entry.group == Group::motion ? select_motion(word, entry.code)
                                          : for_one_block(word, entry.code);
    case Code::arc_point:
    case Code::arc_tangent:
      return is(Dialect::iso) ? for_one_block(word, entry.code) : select_motion(word, entry.code);
    default:
      return is_motion(entry.code) ? select_motion(word, entry.code)
                                   : apply_modal_code(word, entry);
  }
}

bool ModalWords::for_oneshot(const Word& word, Code code) {
  if (block_.oneshot && block_.oneshot_code != code)
    return error("group-twice",
                 fmt::format("{} beside {}: a block carries out only one of them; write them into "
                             "blocks of their own",
                             text_of(word), text_of(*block_.oneshot)),
                 word);
  block_.oneshot = &word;
  block_.oneshot_code = code;
  return true;
}

// A motion for this block only. After it the motion before holds again.
bool ModalWords::for_one_block(const Word& word, Code code) {
  block_.motion_code = &word;
  block_.motion = code;
  return true;
}

// Mach and Vectric write G70 and G71 for the units. LinuxCNC's cycles of these numbers have words.
bool ModalWords::units_of_mach(const Word& word) {
  const bool is_unit = is(Dialect::ngc) && (word.value == 70 || word.value == 71) && !peek('Q');
  return is_unit && set_units(word);
}

bool ModalWords::set_units(const Word& word) {
  return plain_.apply(word.value == 70 ? Code::inch_feed : Code::metric_feed, word);
}

bool ModalWords::refuse(const Word& word) {
  const auto by_10 = static_cast<int>(std::lround(word.value * 10));
  const std::string_view what =
      word.address == letter('G') ? unsupported_code(control_.dialect, by_10) : "";
  const std::string named = what.empty() ? "" : fmt::format(" ({})", what);
  return error("not-supported", text_of(word) + named + " is not supported yet", word);
}

// A cycle behind another keeps its values (LinuxCNC: only R), and the level before both of them.
void ModalWords::select_cycle(const Word& word, int number) {
  modal_.turn.number = 0;
  DrillCycle& cycle = modal_.drill;
  if (cycle.number == 0) cycle = {};
  if (is(Dialect::ngc) && cycle.number != number) {  // another cycle keeps only R
    cycle.bottom.given = cycle.dwells = false;
    cycle.peck = 0;
  }
  cycle.number = number;
  cycle.first = cycle.lead = cycle.out_every = 0;
  cycle.pitched = word.value == 77 || word.value == 78;
  // FANUC lathes drill along Z, or along X from the side, whatever the plane.
  const bool turned = lathe() && is(Dialect::fanuc);
  cycle.plane = !turned ? -1 : number >= 87 && (peek('X') || peek('U')) ? kPlaneYZ : kPlaneXY;
  cycle.file = block_.file;
  cycle.line = block_.line_number;
  cycle.call = block_.call;
}

bool ModalWords::apply_modal_code(const Word& word, const CodeEntry& entry) {
  if (plain_.apply(entry.code, word) || compensation_.select(entry.code, word)) return true;
  switch (entry.code) {
    case Code::plane_xy:
    case Code::plane_2d:
      return select_plane(kPlaneXY, word);
    case Code::plane_zx:
      return select_plane(kPlaneZX, word);
    case Code::plane_yz:
      return select_plane(kPlaneYZ, word);
    case Code::plane_normal:
      return select_normal(word);
    case Code::absolute:
    case Code::incremental:
      return select_distance(entry.code, word);
    case Code::work_off:
    case Code::work_offset:
    case Code::work_extended:
      return frame_words_.select_work(entry, word);
    case Code::tap_floating:
      block_.motion_code = &word;
      block_.motion = entry.code;
      return true;
    case Code::one_way:
      if (modal_.drill.number != 0) return true;  // the axis words are places of the cycle
      [[fallthrough]];
    case Code::dwell:
    case Code::reference:
    case Code::reference_second:
    case Code::reference_check:
    case Code::reference_leave:
    case Code::data_setting:
    case Code::position_reset:
    case Code::position_suspend:
    case Code::position_resume:
    case Code::reference_approach:
    case Code::fixed_point:
    case Code::set_position:
    case Code::position_jump:
    case Code::decoder_length:
      return for_oneshot(word, entry.code);
    case Code::rotation_off:
      block_.ends_rotation = true;
      return true;
    case Code::scaling_off:
      block_.ends_scaling = true;
      return true;
    default:
      return for_frame(word, entry.code);
  }
}

// A shift, turn, scale or mirror, which takes the block's axes.
bool ModalWords::for_frame(const Word& word, Code code) {
  if (block_.frame_code && !is(Dialect::sinumerik))
    return error("frame-own-block",
                 fmt::format("{} beside {}: both would use the axes of the block; write them "
                             "into blocks of their own",
                             text_of(word), text_of(*block_.frame_code)),
                 word);
  block_.frame_code = &word;
  block_.frame_op = code;
  return true;
}

// On FANUC lathes G90 with axes is a turning cycle of code system A, unless a motion word stands
// beside it, or the program has said G91, which only systems B and C and Okuma have.
bool ModalWords::select_distance(Code code, const Word& word) {
  modal_.has_increments |= code == Code::incremental;
  if (is(Dialect::fanuc) && lathe() && (peek('X') || peek('Z') || peek('U') || peek('W'))) {
    const bool moves = std::any_of(block_.words.begin(), block_.words.end(), [&](const Word& w) {
      return w.address == letter('G') && lookup(w).group == Group::motion;
    });
    if (!moves && !modal_.has_increments) return select_turning(word, 90);
    note_once("code-system", "G90 and G91 are read as absolute and incremental (code systems B, C)",
              word, "code-system");
  }
  modal_.incremental = code == Code::incremental;
  return true;
}

bool ModalWords::select_plane(int plane, const Word& word) {
  if (plane != modal_.plane && modal_.comp != Code::comp_off && compensation_.started())
    return error("comp-plane",
                 fmt::format("the plane must not change under radius compensation{}",
                             is(Dialect::sinumerik) ? " (alarm 10757)"
                             : is(Dialect::fanuc)   ? " (alarm 037)"
                                                    : ""),
                 word);
  if (plane != modal_.plane) position_.has_polar_angle = false;
  modal_.plane = plane;
  return true;
}

// CODESYS G16 I J K: the plane by its normal.
bool ModalWords::select_normal(const Word& word) {
  Vec3 normal;
  for (int i = 0; i < 3; ++i)
    if (const Word* w = take("IJK"[i])) component(normal, i) = w->value;
  if (length(normal) < kTurnRounding)
    return error("value-missing", "G16 needs the normal vector I J K of the plane", word);
  modal_.normal = normalized(normal);
  modal_.plane = kPlaneOfNormal;
  return true;
}

}  // namespace mrsim
