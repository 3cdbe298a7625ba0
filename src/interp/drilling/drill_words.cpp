#include "interp/drilling/drill_words.h"

#include "core/numbers/rounding.h"
#include "core/numbers/units.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr long kMostRepeats = 99'999;
constexpr double kLeastLead = 0.1;  // mm: the least lead of a tap

}  // namespace

bool DrillWords::wants_block() const {
  if (modal_.drill.number == 0 || block_.oneshot || block_.frame_code || block_.suppress_frames)
    return false;
  for (const char c : {'X', 'Y', 'Z', 'R', '@', '^'})
    if (block_.unused(letter(c))) return true;
  if (block_.unused(Address::ap)) return true;
  return lathe() && (block_.unused(letter('U')) || block_.unused(letter('W')));
}

void DrillWords::read_level(const Word* word, CycleLevel& out) {
  if (word) out = {word->value * length_unit(*word), modal_.incremental, true};
}

// Whether I is the depth. I of G73 and G83 beside R or K is the first stroke of Haas.
bool DrillWords::depth_in_i() const {
  const int g = modal_.drill.number;
  return peek('I') && g > 80 && (g != 83 || (peek('J') && !peek('K') && !peek('R')));
}

// On Fagor Z is the level to which others give R, and I is the depth; G83 makes J strokes of I. K
// is a dwell, and R the kind of a tap.
bool DrillWords::read_fagor(const Basis& b) {
  DrillCycle& cycle = modal_.drill;
  cycle.fagor = true;
  for (int i = 0; i < 3; ++i)
    if (component(b.w, i) != 0) read_level(take("XYZ"[i]), cycle.safe);
  take('R');
  if (const Word* q = peek('Q'))
    return error("not-supported",
                 "Q (a polar angle) beside the data of a cycle is not supported yet: write the "
                 "place into a block of its own",
                 *q);
  if (const Word* k = take('K')) cycle.dwell = dwell_.of_cycle(*k);
  const Word* depth = take('I');
  const Word* strokes = take('J');
  if (depth && cycle.number == 83) {
    if (!strokes || strokes->value < 1 || strokes->value > static_cast<double>(kMostStrokes) ||
        strokes->value != std::floor(strokes->value))
      return error("value-missing", "G83 with I needs J, the number of strokes", *depth);
    const double stroke = depth->value * length_unit(*depth);
    cycle.peck = std::abs(stroke);
    cycle.bottom = {stroke * strokes->value, true, true};
  } else {
    read_level(depth, cycle.bottom);
  }
  return true;
}

// Reads R, the level along the normal, Q and P. Each stays in force for the points that follow.
bool DrillWords::read_words(const Basis& b) {
  DrillCycle& cycle = modal_.drill;
  if (is(Dialect::iso) && (cycle.fagor || depth_in_i())) return read_fagor(b);
  read_level(take('R'), cycle.safe);
  for (int i = 0; i < 3; ++i) {
    if (component(b.w, i) == 0) continue;
    read_level(take("XYZ"[i]), cycle.bottom);
    if (cycle.plane < 0) continue;
    if (i == 0 && peek('X')) cycle.bottom.value = axis_value(0, *peek('X'), modal_.incremental);
    const Word* relative = take("UVW"[i]);
    if (relative) cycle.bottom = {axis_value(i, *relative, true), true, true};
  }
  if (block_.unused(letter('P'))) cycle.dwells = true, cycle.dwell = dwell_.of_cycle(*take('P'));
  const int g = cycle.number;
  if ((g == 74 || g == 84) && !is(Dialect::ngc) && !read_tap()) return false;
  if (is(Dialect::ngc) && !cycle.dwells && (g == 82 || g == 86 || g == 89))
    reporter_.once(
        Severity::warning, "dwell-missing",
        fmt::format("G{} has no P, its dwell: read as 0 s; LinuxCNC refuses the block", g),
        block_.words.front(), "cycle");
  const Word* q = take('Q');
  return !q || pecks_.read(*q);
}

// Reads the words of taps. G77 and G78 of Brother have I or J, and L, the speed on the way back. J
// of Haas says how many times faster the way back is. Beside ,R1 of Mitsubishi, a rigid tap, F may
// be the lead.
bool DrillWords::read_tap() {
  DrillCycle& cycle = modal_.drill;
  const Word* rigid = take(Address::rnd);
  if (!cycle.pitched) {
    if (rigid && rigid->value == 1 && is_no_lead(tapping_lead())) cycle.lead = modal_.feed;
    take('J');
    return true;
  }
  take('L');
  const Word* lead = take('I');
  const Word* threads = take('J');
  for (const Word* word : {lead, threads})
    if (word && !(word->value > 0))
      return error("thread-lead", "the lead of a tap must be above 0", *word);
  if (lead) cycle.lead = lead->value * length_unit(*lead);
  if (threads) cycle.lead = kMmPerInch / threads->value;
  if (peek('Q'))
    return error("not-supported", "a tap in strokes (Q) is not supported yet", *peek('Q'));
  return cycle.lead > 0 ||
         error("value-missing", "the tap needs I, its lead, or J, threads per inch",
               block_.words.front());
}

// K (FANUC) or L is how often the block is run.
bool DrillWords::repeats(long& count) {
  if (modal_.drill.fagor)
    if (const auto n = block_.number_after(block_.words.front())) {
      count = *n;
      return (count > 0 && count <= kMostRepeats) ||
             error("value-range", fmt::format("N repeats from 1 to {} times", kMostRepeats),
                   block_.words.front());
    }
  const bool pitched = modal_.drill.pitched;  // I of such taps is the lead, and L a speed
  const Word* word = pitched ? nullptr : take('L');
  if (!is(Dialect::ngc) && (!peek('I') || pitched) && !modal_.drill.fagor)
    if (const Word* k = take('K'); k && !(modal_.drill.out_every > 0 && k->point)) word = k;
  if (!word) return true;
  const double least = is(Dialect::ngc) ? 1 : 0;
  if (word->value < least || word->value != std::floor(word->value) || word->value > kMostRepeats)
    return error(
        "value-range",
        fmt::format("the number of repeats is a whole number from {:g} to {}", least, kMostRepeats),
        *word);
  count = static_cast<long>(word->value);
  return true;
}

bool DrillWords::run() {
  const int plane = modal_.plane;
  if (modal_.drill.plane >= 0) modal_.plane = modal_.drill.plane;
  const bool ok = drill();
  modal_.plane = plane;
  return ok;
}

// Whether G87 bores down. On Haas it does, and the tool is taken out by hand; on FANUC it has a
// shift.
bool DrillWords::bores_down() const {
  const Word* level = peek('R');
  const Word* bottom = peek('Z');
  const bool shift = peek('Q') || peek('I') || peek('J');
  return is(Dialect::fanuc) && !lathe() && modal_.plane == kPlaneXY && !modal_.incremental &&
         !shift && level && bottom && bottom->value < level->value;
}

// Reports cycles that are not read. True: this is one.
bool DrillWords::refuses(const Word& where) {
  const DrillCycle& cycle = modal_.drill;
  const auto refuse = [&](const char* code, const std::string& text) {
    return !error(code, text, where);
  };
  if ((cycle.number == 87 && cycle.plane != kPlaneYZ) || (is(Dialect::ngc) && cycle.number == 88))
    return refuse(
        "not-supported",
        fmt::format("G{} ({}) is not supported yet", cycle.number,
                    cycle.number == 87 ? "back boring" : "boring with a way out by hand"));
  if (is(Dialect::ngc) && (cycle.number == 74 || cycle.number == 84) && modal_.plane != kPlaneXY)
    return refuse("not-supported",
                  fmt::format("G{} outside of G17: LinuxCNC exchanges its axes, and does not tap "
                              "where the hole is",
                              cycle.number));
  if (is(Dialect::ngc) && modal_.comp != Code::comp_off)
    return refuse("cycle-compensation", "a canned cycle under radius compensation");
  return false;
}

bool DrillWords::drill() {
  DrillCycle& cycle = modal_.drill;
  const Basis b = basis();
  const Word& where = block_.motion_code ? *block_.motion_code : block_.words.front();
  if (cycle.number == 87 && bores_down()) cycle.number = 88;
  if (refuses(where)) return false;
  if (!cycle.begun) cycle.initial = holes_.level();
  cycle.begun = true;
  long count = 1;
  Hole hole;
  if (!read_words(b) || !repeats(count)) return false;
  const Vec3 from = position_.programmed;
  Target to;
  if (!axes_.target(to, from)) return false;
  if (!fill(hole)) return false;
  if (count == 0 && length(to.programmed - from - dot(to.programmed - from, b.w) * b.w) > kRounding)
    warning("cycle-not-run",
            "0 repeats: the tool stays where it is; some controls go to the point without drilling",
            where);
  const Vec3 step = to.programmed - from;
  for (long i = 0; i < count; ++i) {
    AxisSet named = to.named;
    meet_level(hole, named, where);
    Vec3 point = to.programmed;
    if (modal_.incremental && (modal_.polar || find(Address::ap)) &&
        i > 0) {  // the angle counts from the last one
      to = {};
      if (!axes_.target(to, position_.programmed)) return false;
      point = to.programmed;
    } else if (modal_.incremental && i > 0) {
      point = from + static_cast<double>(i + 1) * step;
    }
    point = point + (level_aside(hole) - dot(point, b.w)) * b.w;
    if (!named.empty()) holes_.approach(point, named, where);
    if (!block_.no_hole) holes_.drill(hole, {cycle.file, cycle.line, cycle.call}, where);
  }
  return true;
}

// The level at which the tool goes to the next hole. On LinuxCNC that is R, where R lies above the
// level before the first cycle. Otherwise a tool at R or below goes at R, or in G98 at the level
// before the first cycle; a higher one stays where it is.
double DrillWords::level_aside(const Hole& hole) const {
  const double level = holes_.level();
  if (!is(Dialect::ngc)) return level;
  if (hole.safe > modal_.drill.initial) return hole.safe;
  if (level > hole.safe + kRounding) return level;
  return modal_.hole_return == HoleReturn::initial ? modal_.drill.initial : hole.safe;
}

// LinuxCNC: goes to that level. It goes straight there where R lies above the level before the
// first cycle, else on the way to the hole, whose axes are `named`.
void DrillWords::meet_level(const Hole& hole, AxisSet& named, const Word& where) {
  const double level = level_aside(hole);
  if (std::abs(holes_.level() - level) <= kRounding) return;
  if (named.empty() || hole.safe > modal_.drill.initial) return holes_.move_to(level, where);
  named |= axes_along(basis().w);
}

bool DrillWords::at_points(const std::vector<Vec3>& points, const Word& where, bool own_p) {
  DrillCycle& cycle = modal_.drill;
  const Basis b = basis();
  if (cycle.number == 0 || cycle.number == 87)
    return error("value-missing", "a pattern of holes needs a drilling cycle in force", where);
  if (!cycle.begun) cycle.initial = holes_.level();
  cycle.begun = true;
  Hole hole;
  const DrillCycle before = cycle;
  if (!read_words(b)) return false;
  if (own_p) {
    cycle.dwells = before.dwells;
    cycle.dwell = before.dwell;
  }
  if (!fill(hole, false)) return false;
  for (const Vec3& point : points) {
    const Vec3 above = point + (holes_.level() - dot(point, b.w)) * b.w;
    holes_.approach(above, kAxisX | kAxisY, where);
    holes_.drill(hole, {cycle.file, cycle.line, cycle.call}, where);
  }
  return true;
}

// Finds the levels. In G91 R counts from the level before the first cycle, and Z from R. LinuxCNC
// keeps the numbers of both and reads them again in each block, by the G90 or G91 that holds there.
bool DrillWords::fill_levels(Hole& hole, const Word& where) {
  const DrillCycle& cycle = modal_.drill;
  const auto relative = [&](const CycleLevel& level) {
    return is(Dialect::ngc) ? modal_.incremental : level.incremental;
  };
  if (!cycle.bottom.given)
    return error("value-missing", fmt::format("G{} needs the depth of the hole", cycle.number),
                 where);
  if (!cycle.safe.given && is(Dialect::ngc))
    return error("value-missing", fmt::format("G{} needs R", cycle.number), where);
  const bool from_initial = relative(cycle.safe) || cycle.plane == kPlaneYZ ||
                            (cycle.plane == kPlaneXY && cycle.safe.value <= 0);
  if (cycle.plane == kPlaneXY && cycle.safe.value > 0 && !relative(cycle.safe))
    note_once("cycle-level",
              "R above 0 is read as a level, as Haas does; others count it from the start", where,
              "R");
  hole.safe = !cycle.safe.given ? cycle.initial
              : from_initial    ? cycle.initial + cycle.safe.value
                                : cycle.safe.value;
  hole.bottom = relative(cycle.bottom) ? hole.safe + cycle.bottom.value : cycle.bottom.value;
  const bool up = hole.bottom > hole.safe;
  hole.end = end_level(hole.safe, up);
  if (is(Dialect::ngc) && !modal_.return_told && cycle.initial > hole.safe)
    note_once("cycle-level",
              "neither G98 nor G99 is given: the tool returns to R, as LinuxCNC and Mach do", where,
              "return");
  if (up && is(Dialect::ngc))
    return error("value-range", "R lies below the bottom of the hole", where);
  if (up && modal_.plane == kPlaneXY && !lathe())  // across the spindle both directions are down
    reporter_.add(Severity::warning, "cycle-upwards", "R lies below the bottom of the hole", where);
  return true;
}

// The levels, feeds, dwells and strokes of the cycle in force.
bool DrillWords::fill(Hole& hole, bool haas_words) {
  const DrillCycle& cycle = modal_.drill;
  const Word& where = block_.motion_code ? *block_.motion_code : block_.words.front();
  if (!fill_levels(hole, where)) return false;
  // G87 to G89 are as G83 to G85.
  const int g = cycle.plane == kPlaneYZ ? cycle.number - 4 : cycle.number;
  hole.feed_out = g == 74 || g == 84 || g == 85 || g == 89;
  hole.feed_to_end = hole.feed_out && g != 85 && is(Dialect::ngc);
  if (g == 74 || g == 84) {
    hole.lead = tapping_lead() * (g == 74 ? -1 : 1);
    if (is(Dialect::fanuc) && is_no_lead(tapping_lead()))
      reporter_.once(
          Severity::warning, "tap-lead",
          fmt::format("feed and speed make a lead of {:.2g} mm: where F is the lead, G95 "
                      "stands before it",
                      tapping_lead()),
          where, "tap-lead");
  }
  if (g == 76)
    note_once("cycle-shift", "G76: the shift by Q at the bottom is not run, its side is not known",
              where, "G76");
  fill_dwells(g, hole);
  if (g != 73 && g != 83) return true;
  hole.chips_out = g == 83;
  return pecks_.fill(hole, haas_words);
}

// Sets the dwells of the cycles that have P. Taps of FANUC also wait at R.
void DrillWords::fill_dwells(int g, Hole& hole) const {
  const bool taps = g == 74 || g == 84, pecks = g == 73 || g == 83;
  const bool bores = g == 76 || g == 82 || g == 86 || g == 88 || g == 89 || (g == 85 && lathe());
  if (!bores && !taps && (!pecks || is(Dialect::ngc))) return;
  hole.dwell = modal_.drill.dwell;
  if (taps && is(Dialect::fanuc)) hole.dwell_out = hole.dwell;
}

// The level at which the tool ends: never nearer to the hole than R. The hole is below R, or above
// it if `up`.
double DrillWords::end_level(double safe, bool up) const {
  const double initial = modal_.drill.initial;
  switch (modal_.hole_return) {
    case HoleReturn::safe:
      return safe;
    case HoleReturn::level:
      return *modal_.return_level;
    default:
      return up ? std::min(initial, safe) : std::max(initial, safe);
  }
}

bool DrillWords::is_no_lead(double lead) { return lead > 0 && lead < kLeastLead; }

double DrillWords::tapping_lead() const {
  if (modal_.drill.lead > 0) return modal_.drill.lead;
  if (modal_.feed_unit == FeedUnit::mm_per_rev) return modal_.feed;
  return modal_.speed > 0 ? modal_.feed / modal_.speed : 0;
}

}  // namespace mrsim
