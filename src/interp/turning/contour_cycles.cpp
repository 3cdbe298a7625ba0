#include "interp/turning/contour_cycles.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kLongDepth = 50;   // from here on a depth is thousandths: D4000
constexpr double kLongShift = 500;  // from here on a shift of G73 is: U14000
constexpr double kLapEscape = 0.5;  // mm: a parameter of Okuma's control

}  // namespace

// Reads the first of two lines, whose values hold for the cycles that follow.
bool ContourCycles::settings() {
  TurnSettings& set = modal_.turn_settings;
  set.thousandths = block_.turn_cycle == 73 ? counts_thousandths("UW", kLongShift)
                                            : counts_thousandths("UWR", kLongDepth);
  const Word* u = take('U');
  const Word* w = take('W');
  const Word* r = take('R');
  if (take('H')) set.pockets = true;  // Mitsubishi: whether there are pockets
  const auto length = [&](const Word* word) { return word->value * cycle_unit(*word); };
  if (block_.turn_cycle == 73) {
    if (u) set.shift_x = length(u);
    if (w) set.shift_z = length(w);
    return !r || read_repeats(*r);
  }
  if (const Word* depth = block_.turn_cycle == 71 ? u : w) set.depth = std::abs(length(depth));
  if (r) set.escape = std::abs(length(r));
  return true;
}

// R4 or D4 says how often G73 runs its contour; R0.004 counts thousandths. In code system C G73
// roughs.
bool ContourCycles::read_repeats(const Word& word) {
  TurnSettings& set = modal_.turn_settings;
  const double count = word.value < 0.1 ? std::round(1e6 * word.value) / 1000 : word.value;
  const std::string text = text_of(word) + " of G73 is how often the contour is run";
  const char* const hint = "; where G73 roughs along Z (code system C), write G71";
  if (count < 1 || count > 1e5 || count != std::floor(count))
    return error("value-range", text + ", a whole number" + hint, word);
  set.repeats = static_cast<int>(count);
  if (count == 1 && word.point && (set.shift_x != 0 || set.shift_z != 0))
    warning("code-system", text + ": once, so that U and W beside it have no effect" + hint, word);
  return true;
}

// Reads D I K of a cycle in one line. A long D without a point counts least increments.
bool ContourCycles::old_words(bool given, Vec3& semi_finish) {
  TurnSettings& set = modal_.turn_settings;
  const Word* d = take('D');
  const Word* i = take('I');
  const Word* k = take('K');
  if (!given) return true;
  if (block_.turn_cycle == 73) {
    if (d && !read_repeats(*d)) return false;
    if (i) set.shift_x = i->value * length_unit(*i);
    if (k) set.shift_z = k->value * length_unit(*k);
    return true;
  }
  if (i) semi_finish.x = i->value * length_unit(*i);
  if (k) semi_finish.z = k->value * length_unit(*k);
  if (d) set.depth = std::abs(d->value * cycle_unit(*d));
  return true;
}

// "U2000 R500", "D4000": no pass is that deep, so numbers without a point count least increments.
bool ContourCycles::counts_thousandths(std::string_view letters, double least) {
  if (options_.least_increments) return false;
  for (const char c : letters) {
    const Word* word = peek(c);
    if (!word || word->point || std::abs(word->value) < least) continue;
    note_increments(*word);
    return true;
  }
  return false;
}

// A computed value, as in D[#1*1000], has no decimal point: a large one counts least increments.
double ContourCycles::cycle_unit(const Word& word) {
  const double long_value = block_.turn_cycle == 73 ? kLongShift : kLongDepth;
  const bool computed = is_computed(word) && std::abs(word.value) >= long_value;
  if (computed) note_increments(word);
  const bool least = computed || (modal_.turn_settings.thousandths && !word.point);
  return length_unit(word) * (!least ? 1 : modal_.least_increment());
}

bool ContourCycles::run() {
  if (!block_.contour.empty()) return lap();
  const Word* first = take('P');
  const Word* last = take('Q');
  const int g = block_.turn_cycle;
  if (contour_.is_read())
    return error("not-supported", fmt::format("G{} inside the contour of a cycle", g),
                 *block_.oneshot);
  if (!first && !last && g != 70) return settings();
  if (!first || !last)
    return error("value-missing", fmt::format("G{} needs P and Q, the blocks of its contour", g),
                 *block_.oneshot);
  if (!goes_on(*block_.oneshot)) return false;
  TurnSettings& set = modal_.turn_settings;
  set.thousandths =
      counts_thousandths(g == 73 ? "UW" : "UWD", kLongDepth) || (set.thousandths && !peek('D'));
  Call call;
  if (!old_words(peek('D') || peek('I') || peek('K'), call.cut.semi_finish)) return false;
  if (const Word* u = take('U'))
    call.cut.allowance.x = axis_value(0, *u, true) * cycle_unit(*u) / length_unit(*u);
  if (const Word* w = take('W')) call.cut.allowance.z = w->value * cycle_unit(*w);
  call.cut.pockets = take('R') || modal_.turn_settings.pockets;  // Haas: R1
  call.cut.number = g;
  call.cut.where = *block_.oneshot;
  call.first = *first;
  call.last = *last;
  if (const Word* program = take('A')) call.program = *program;
  call_ = call;
  if ((g == 71 || g == 72) && modal_.turn_settings.depth <= 0)
    return error("value-missing", fmt::format("G{} needs the depth of a pass, U, W or D", g),
                 call_.cut.where);
  waits_ = true;
  return true;
}

void ContourCycles::end_block() {
  if (block_.lap_begins) return pass_over_lap();
  if (first_block_ && contour_.is_read()) read_first_block();
  if (!waits_) return;
  waits_ = false;
  CallRequest request;
  if (!find_contour(request)) return;
  contour_.keep_state(block_.place());
  const bool finishing = call_.cut.number == 70;
  if (!finishing) request.on_start = [this] { begin_contour(); };
  request.on_end = [this, finishing] { finishing ? finish() : end_contour(); };
  const Word where = call_.cut.where;
  reader_.enter(std::move(request), where);
}

// Finds the blocks P to Q of this program, which goes on behind them, or of the program A.
bool ContourCycles::find_contour(CallRequest& request) {
  const long first = static_cast<long>(call_.first.value),
             last = static_cast<long>(call_.last.value);
  Place end;
  bool found = false;
  request.file = reader_.file();
  if (call_.lap) {
    request.begin = call_.lap->begin;
    request.end = call_.lap->end.offset;
    return true;
  }
  if (call_.program) {
    const auto place =
        reader_.locate({static_cast<long>(call_.program->value), {}}, *call_.program);
    if (!place) return false;
    request.file = place->file;
    found =
        statements_ && statements_->places().find_blocks(*place, first, last, request.begin, end);
  } else {
    found = statements_ && statements_->places().find_blocks(first, last, request.begin, end);
    if (found && call_.cut.number == 70) prefer_contour_before(first, last, request.begin, end);
  }
  request.end = end.offset;
  if (!found)
    return error(
        "jump-target",
        fmt::format("there are no blocks N{} to N{} behind one another in {}", first, last,
                    call_.program ? text_of(*call_.program).replace(0, 1, "O") : "this program"),
        call_.first);
  const bool jumps = call_.cut.number != 70 && !call_.program && reader_.place_at(0) < end;
  if (!jumps) return true;
  warn_of_blocks_before(request.begin);
  return reader_.jump(end);
}

// A contour at the end of the program, behind M30, as other controls have it: the finishing cycle
// and the way out between the cycle and its contour are not run.
void ContourCycles::warn_of_blocks_before(const Place& contour) {
  const Place here = reader_.place_at(0);
  if (contour.line <= here.line + 1 || !looked_between_.emplace(reader_.file(), here.offset).second)
    return;
  const std::vector<ActiveBlock> blocks =
      active_blocks(reader_.file(), statements_->places().behind_line(here), contour);
  if (blocks.empty()) return;
  warning(
      "blocks-passed-over",
      fmt::format("the control goes on behind N{0}, so {2} between this cycle and N{1} {3} never "
                  "run: write N{1} to N{0} right behind the cycle",
                  static_cast<long>(call_.last.value), static_cast<long>(call_.first.value),
                  lines_text(blocks), blocks.size() == 1 ? "is" : "are"),
      call_.cut.where);
}

// If several contours have the same numbers, which the manuals forbid, G70 finishes the nearest one
// before it: that of the last roughing cycle.
void ContourCycles::prefer_contour_before(long first, long last, Place& begin, Place& end) {
  Place nearest, behind;
  if (!statements_->places().find_blocks_before(first, last, nearest, behind) || nearest == begin)
    return;
  begin = nearest;
  end = behind;
  warning("contour-twice",
          fmt::format("N{} stands in this program more than once: G70 runs the contour of line {}, "
                      "the nearest before it; give each contour numbers of its own",
                      first, nearest.line + 1),
          call_.first);
}

void ContourCycles::end_program() { contour_.end_program(call_.cut.where); }

// G70 ends where it began. By FANUC's manuals radius compensation is off on the way back and starts
// again with the next move, so that the contour is finished to its end.
void ContourCycles::finish() {
  block_.forget_words();
  block_.begin();
  const Code comp = std::exchange(modal_.comp, Code::comp_off);
  ContourPasses(control_, moves_, call_.cut, contour_.motions())
      .go(contour_.position_before().physical, kRapid);
  modal_.comp = comp;
}

// FANUC: both axes in the first block of the contour say that it may have pockets (type II).
void ContourCycles::read_first_block() {
  const bool x = peek('X') || peek('U'), z = peek('Z') || peek('W');
  first_block_ = !x && !z;
  if (x && z) call_.cut.pockets = true;
}

void ContourCycles::begin_contour() {
  first_block_ = true;
  contour_.begin();
}

void ContourCycles::end_contour() {
  const bool faultless = contour_.end();
  block_.turn_cycle = call_.cut.number;
  const Code comp = std::exchange(modal_.comp, Code::comp_off);  // roughing ignores compensation
  const std::size_t size = contour_.motions().size();
  if (size >= MotionEmitter::kMostCaptured)
    error("value-range", fmt::format("the contour has {} motions or more", size), call_.cut.where);
  else if (faultless)
    ContourPasses(control_, moves_, call_.cut, contour_.motions()).run();
  modal_.comp = comp;
}

std::optional<LapContour> ContourCycles::lap_contour(std::string_view name, const Word& where) {
  std::optional<LapContour> found;
  if (statements_) {
    const auto [begin, end] = statements_->places().section();
    found = find_lap_contour(reader_.file(), begin, end, name);
  }
  if (!found)
    error("jump-target",
          fmt::format("there is no block {} with G81 or G82, and G80 behind it, in this program",
                      name),
          where);
  return found;
}

bool ContourCycles::lap() {
  const Word& where = *block_.oneshot;
  const auto contour = lap_contour(block_.contour, where);
  if (!contour || !goes_on(where)) return false;
  if (contour->number == 83)
    return error("not-supported",
                 fmt::format("{} begins with the shape of the blank (G83), which is not supported "
                             "yet: call its finished shape by a block with G81 or G82",
                             block_.contour),
                 where);
  call_ = {};
  call_.lap = contour;
  call_.cut.lap = true;
  call_.cut.where = where;
  call_.cut.number = block_.turn_cycle == 70 ? 70 : contour->number == 82 ? 72 : 71;
  const Word* u = take('U');
  const Word* w = take('W');
  if (u) call_.cut.allowance.x = std::abs(axis_value(0, *u, true));
  if (w) call_.cut.allowance.z = std::abs(w->value) * length_unit(*w);
  take('E');
  if (call_.cut.number != 70 && !lap_depth()) return false;
  if (call_.cut.number == 70 && length(call_.cut.allowance) > 0)
    return error("not-supported", "U and W of G87 (a stock that finishing leaves)", where);
  waits_ = true;
  return true;
}

// D of passes along Z is how much they take off the diameter.
bool ContourCycles::lap_depth() {
  const Word* d = take('D');
  if (!d || d->value == 0)
    return error("value-missing", "G85 needs D, the depth of a pass", call_.cut.where);
  TurnSettings& set = modal_.turn_settings;
  set.depth = std::abs(d->value) * length_unit(*d) * (call_.cut.number == 71 ? 0.5 : 1);
  set.escape = kLapEscape;
  return true;
}

// The program reaches a contour that no cycle calls here: it goes on behind G80.
void ContourCycles::pass_over_lap() {
  const Word where = *block_.lap_begins;
  if (const auto contour = lap_contour(block_.name, where)) reader_.jump(contour->behind);
}

}  // namespace mrsim
