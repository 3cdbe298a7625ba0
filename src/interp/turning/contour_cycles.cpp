#include "interp/turning/contour_cycles.h"

#include "core/numbers/rounding.h"
#include "interp/cycles/hole_maker.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kMostMotions = 1e7;  // of a G73
constexpr double kLongDepth = 50;     // D4000 counts thousandths
constexpr double kLongShift = 500;    // and so does U14000 of G73

}  // namespace

// The first of two lines: what it says holds for the cycles that follow.
bool ContourCycles::settings() {
  TurnSettings& set = modal_.turn_settings;
  set.thousandths = block_.turn_cycle == 73 ? counts_thousandths("UW", kLongShift)
                                            : counts_thousandths("UWR", kLongDepth);
  const Word* u = take('U');
  const Word* w = take('W');
  const Word* r = take('R');
  take('H');  // Mitsubishi: whether there are pockets
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

// How often G73 runs its contour: R4, D4; R0.004 counts thousandths. In code system C it roughs.
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

// D I K of the cycle in one line. D without a point counts least increments where it is long.
bool ContourCycles::old_words(bool given) {
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
  if (i) semi_finish_.x = i->value * length_unit(*i);
  if (k) semi_finish_.z = k->value * length_unit(*k);
  if (d) set.depth = std::abs(d->value * cycle_unit(*d));
  return true;
}

// "U2000 R500", "D4000": no pass is that deep, so what has no point counts least increments.
bool ContourCycles::counts_thousandths(std::string_view letters, double least) {
  if (options_.least_increments) return false;
  for (const char c : letters) {
    const Word* word = peek(c);
    if (!word || word->point || std::abs(word->value) < least) continue;
    note_once("number-without-point",
              fmt::format("{} without a decimal point counts least increments", text_of(*word)),
              *word, "D");
    return true;
  }
  return false;
}

double ContourCycles::cycle_unit(const Word& word) const {
  const bool least = modal_.turn_settings.thousandths && !word.point;
  return length_unit(word) * (!least ? 1 : modal_.least_increment());
}

bool ContourCycles::run() {
  semi_finish_ = {};
  if (!block_.contour.empty()) return lap();
  const Word* first = take('P');
  const Word* last = take('Q');
  const int g = block_.turn_cycle;
  if (out_.captures())
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
  if (!old_words(peek('D') || peek('I') || peek('K'))) return false;
  call_ = {};
  if (const Word* u = take('U'))
    call_.allowance.x = axis_value(0, *u, true) * cycle_unit(*u) / length_unit(*u);
  if (const Word* w = take('W')) call_.allowance.z = w->value * cycle_unit(*w);
  take('R');  // Haas: R1 says that there are pockets
  call_.number = g;
  call_.where = *block_.oneshot;
  call_.first = *first;
  call_.last = *last;
  if (const Word* program = take('A')) call_.program = *program;
  if ((g == 71 || g == 72) && modal_.turn_settings.depth <= 0)
    return error("value-missing", fmt::format("G{} needs the depth of a pass, U, W or D", g),
                 call_.where);
  waits_ = true;
  return true;
}

void ContourCycles::end_block() {
  if (block_.lap_begins) return pass_over_lap();
  if (!waits_) return;
  waits_ = false;
  CallRequest request;
  if (!find_contour(request)) return;
  place_ = block_.place();
  position_before_ = position_;
  modal_before_ = modal_;
  const bool finishing = call_.number == 70;
  if (!finishing) request.on_start = [this] { begin_contour(); };
  request.on_end = [this, finishing] { finishing ? finish() : end_contour(); };
  const Word where = call_.where;
  reader_.enter(std::move(request), where);
}

// The blocks P to Q of this program, which goes on behind them, or of the program A.
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
    if (found && call_.number == 70) prefer_contour_before(first, last, request.begin, end);
  }
  request.end = end.offset;
  if (!found)
    return error(
        "jump-target",
        fmt::format("there are no blocks N{} to N{} behind one another in {}", first, last,
                    call_.program ? text_of(*call_.program).replace(0, 1, "O") : "this program"),
        call_.first);
  const bool jumps = call_.number != 70 && !call_.program && reader_.place_at(0) < end;
  return !jumps || reader_.jump(end);
}

// Of contours with the same numbers, which the manuals forbid, G70 finishes that of the last
// roughing cycle, the nearest one before.
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

void ContourCycles::end_program() {
  if (!out_.captures()) return;
  out_.capture(nullptr);
  reporter_.set_place(place_.file, place_.line, place_.call, {});
  error("program-end-missing", "the program ends inside the contour of this cycle", call_.where);
}

// G70 ends where it began. Radius compensation is off on the way back and starts again with the
// next move, as FANUC's manuals say: the contour is finished to its end.
void ContourCycles::finish() {
  block_.forget_words();
  block_.begin();
  const Code comp = std::exchange(modal_.comp, Code::comp_off);
  go(position_before_.physical, kRapid);
  modal_.comp = comp;
}

void ContourCycles::begin_contour() {
  contour_.clear();
  errors_before_ = reporter_.errors();
  out_.capture(&contour_);
}

void ContourCycles::end_contour() {
  out_.capture(nullptr);
  modal_ = modal_before_;
  position_ = position_before_;
  modal_.comp = Code::comp_off;  // roughing does not regard it
  put_back_block(place_);
  if (contour_.size() >= MotionEmitter::kMostCaptured)
    error("value-range", fmt::format("the contour has {} motions or more", contour_.size()),
          call_.where);
  if (reporter_.errors() == errors_before_) call_.number == 73 ? repeat_pattern() : rough();
  modal_.comp = modal_before_.comp;
}

void ContourCycles::go(const Vec3& to, MotionKind kind) {
  if (distance(to, position_.physical) <= kRounding) return;
  Target target;
  target.programmed = apply_inverse(frames_.total, to);
  target.named = 5;
  moves_.compensated_step(target, call_.where, 0, kind);
}

// G73: the whole contour, each time nearer.
bool ContourCycles::repeat_pattern() {
  const TurnSettings& set = modal_.turn_settings;
  if (static_cast<double>(set.repeats) * static_cast<double>(contour_.size()) > kMostMotions)
    return error("value-range", fmt::format("more than {:g} motions", kMostMotions), call_.where);
  const Vec3 from = position_.physical;
  for (int i = 0; i < set.repeats; ++i) {
    const double share = set.repeats > 1 ? 1 - static_cast<double>(i) / (set.repeats - 1) : 0;
    const Vec3 shift = call_.allowance + share * Vec3{set.shift_x, 0, set.shift_z};
    go(from + shift, kRapid);
    for (const Motion& m : contour_) moves_.follow(m, shift, call_.where);
  }
  go(from, kRapid);
  return true;
}

// "N20 G0 G40 Z0.1", back to where the cycle began, with nothing of the contour farther out.
void ContourCycles::leave_out_return() {
  if (contour_.size() < 3) return;
  const Motion& last = contour_.back();
  const int u = call_.number == 72 ? 2 : 0, v = 2 - u;
  const Vec3 from = position_.physical, begin = contour_.front().end;
  const double out = component(from, u) - component(begin, u);  // away from the contour
  const bool back = component(last.end - last.start, v) * component(last.start - from, v) < 0;
  const double low = std::min(component(last.start, u) * out, component(last.end, u) * out);
  for (std::size_t i = 0; i + 1 < contour_.size(); ++i)
    if (component(contour_[i].end, u) * out > low + kRounding) return;
  if (last.kind != kRapid || !back) return;
  reporter_.add_at(Severity::warning, "cycle-contour",
                   "the last block of the contour goes back with a rapid: FANUC stops there (alarm "
                   "064), Haas goes on; roughing leaves it out",
                   last);
  contour_.pop_back();
}

// G71 along Z, G72 along X: passes at levels down to the contour, then in its pockets, then once
// along it.
bool ContourCycles::rough() {
  leave_out_return();
  if (contour_.size() < 2)
    return error("value-missing", "the contour of the cycle has no motions", call_.where);
  if (contour_.front().kind == MotionKind::arc) {
    reporter_.add_at(
        Severity::error, "cycle-contour",
        "the contour begins with an arc: G0 or G1 must lead to it, as the passes do to "
        "their levels (alarm 065)",
        contour_.front());
    return false;
  }
  if (call_.lap) orient_allowance();
  const Vec3 from = position_.physical, shift = call_.allowance;
  const Vec3 top = call_.lap ? from : from + shift;
  Rough r;
  r.u = call_.number == 72 ? 2 : 0;
  r.v = 2 - r.u;
  r.top = component(top, r.u);
  r.start = component(top, r.v);
  r.down = -1;
  double farthest = 0;
  for (const Motion& m : contour_) {
    const double travel = component(m.end + shift, r.u) - r.top;
    if (std::abs(travel) <= farthest) continue;
    farthest = std::abs(travel);
    r.down = travel > 0 ? 1 : -1;
  }
  r.along = component(contour_.back().end + shift, r.v) > r.start ? 1 : -1;
  if (component(shift, r.u) * r.down > kRounding)
    warning("cycle-allowance",
            fmt::format("{} of G{} leads into the finished shape, which is cut too deep: of a bore "
                        "it is below 0",
                        r.u == 0 ? 'U' : 'W', call_.number),
            call_.where);
  std::vector<PlanePiece> pieces;
  for (std::size_t i = 1; i < contour_.size(); ++i)
    pieces.push_back(turned_piece(contour_[i], r.u, r.v, shift + semi_finish_));
  const RoughContour shape(std::move(pieces), -r.down, r.along);
  if (const int bad = shape.runs_back(); bad >= 0) {
    const Motion& m = contour_[static_cast<std::size_t>(bad) + 1];
    const bool home =
        m.kind == MotionKind::rapid && static_cast<std::size_t>(bad) + 2 == contour_.size();
    reporter_.add_at(Severity::error, "not-supported",
                     home ? "the last block of the contour goes back with a rapid, where controls "
                            "stop (alarm 064): let Q name the block before it"
                          : "the contour of the cycle runs back here (an undercut), which is not "
                            "supported yet",
                     m);
    return false;
  }
  go(top, kRapid);
  if (!levels(r, shape)) return false;
  for (const Motion& m : contour_) moves_.follow(m, shift, call_.where);
  go(from, kRapid);
  return true;
}

// First the stretches that the start sees, from the top down; then the pockets, from the top down.
bool ContourCycles::levels(const Rough& r, const RoughContour& shape) {
  const double depth = modal_.turn_settings.depth;
  const double whole = r.down * (shape.deepest() - r.top);
  if (whole / depth > static_cast<double>(kMostStrokes))
    return error("value-range", fmt::format("more than {} passes", kMostStrokes), call_.where);
  std::vector<std::pair<double, FreeStretch>> pockets;
  for (int i = 1; i * depth < whole - kRounding; ++i) {
    const double at = r.top + r.down * i * depth;
    for (const FreeStretch& stretch : shape.free_at(at)) {
      if (stretch.first)
        pass(r, at, stretch.to);
      else
        pockets.emplace_back(at, stretch);
    }
    if (pockets.size() > kMostStrokes)
      return error("value-range", fmt::format("more than {} passes", kMostStrokes), call_.where);
  }
  for (const auto& [at, stretch] : pockets) pocket_pass(r, at, stretch);
  if (pockets.empty()) return true;
  Vec3 p = position_.physical;
  component(p, r.u) = r.top;
  go(p, kRapid);
  component(p, r.v) = r.start;
  go(p, kRapid);
  return true;
}

// To the level, along it to the contour, off at 45 degrees, back.
void ContourCycles::pass(const Rough& r, double at, double end) {
  if ((end - r.start) * r.along <= kRounding) return;
  Vec3 p = position_.physical;
  component(p, r.u) = at;
  go(p, contour_.front().kind);
  cut(r, at, r.start, end);
  p = position_.physical;
  component(p, r.v) = r.start;
  go(p, kRapid);
}

// Over the pocket at the height of the start, down to the pass before, into the material.
void ContourCycles::pocket_pass(const Rough& r, double at, const FreeStretch& stretch) {
  const TurnSettings& set = modal_.turn_settings;
  if ((stretch.to - stretch.from) * r.along <= kRounding) return;
  Vec3 p = position_.physical;
  component(p, r.u) = r.top;
  go(p, kRapid);
  component(p, r.v) = stretch.from;
  go(p, kRapid);
  const double above = std::min(set.depth + set.escape, r.down * (at - r.top));
  component(p, r.u) = at - r.down * above;
  go(p, kRapid);
  component(p, r.u) = at;
  go(p, kLine);
  cut(r, at, stretch.from, stretch.to);
}

void ContourCycles::cut(const Rough& r, double at, double begin, double end) {
  Vec3 p = position_.physical;
  component(p, r.v) = end;
  go(p, kLine);
  const double escape = std::min(modal_.turn_settings.escape, (end - begin) * r.along);
  component(p, r.u) = at - r.down * escape;
  component(p, r.v) = end - r.along * escape;
  go(p, kRapid);
}

}  // namespace mrsim
