#include "interp/turning/turn_words.h"

#include "core/numbers/exponential.h"
#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "interp/cycles/hole_maker.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kLongThread = 50;  // from here on a height is thousandths: K920
constexpr double kLeastCount = 10;  // from here on a computed value is: P[#1*1000]

double sign_of(double v) { return v < 0 ? -1 : 1; }

double tangent(double degrees) {
  const SinCos sc = sincos_deg(degrees);
  return sc.sin / sc.cos;
}

}  // namespace

const Word& TurnWords::where() const {
  if (block_.oneshot) return *block_.oneshot;
  return block_.motion_code ? *block_.motion_code : block_.words.front();
}

bool TurnWords::has_axes() const { return peek('X') || peek('Z') || peek('U') || peek('W'); }

bool TurnWords::wants_block() const {
  return modal_.turn.number != 0 && !block_.oneshot && !block_.frame_code &&
         !block_.suppress_frames && (has_axes() || peek('R'));
}

// P and Q of the cycles, and R beside them, count least increments where they have no point.
double TurnWords::least(const Word& word) const {
  return word.value * (word.point ? scale() : scale() * modal_.least_increment());
}

// A computed P or Q (P#1, P[#1*1000]) counts them, too, as FANUC allows no point there. Below 10
// it is a length, as on controls that allow a point: so few thousandths make no sense.
double TurnWords::count(const Word& word) {
  if (!is_computed(word)) return least(word);
  if (std::abs(word.value) < kLeastCount) return word.value * scale();
  note_increments(word);
  return word.value * scale() * modal_.least_increment();
}

void TurnWords::go(double x, double z, MotionKind kind, double lead) {
  Target to;
  to.programmed = {x, position_.programmed.y, z};
  to.named = kAxisX | kAxisZ;
  if (length(to.programmed - position_.programmed) > kRounding)
    moves_.step(to, where(), kind, lead, 0);
}

// X and Z stay in force, and so does the start of the cycle.
bool TurnWords::axis_end(Target& to) {
  TurnCycle& cycle = modal_.turn;
  if (!axes_.target(to, position_.programmed)) return false;
  if (to.named.has(kAxisX)) cycle.x = to.programmed.x;
  if (to.named.has(kAxisZ)) cycle.z = to.programmed.z;
  cycle.named |= to.named;
  if (!cycle.named.has(kAxisX | kAxisZ))
    return error("value-missing",
                 fmt::format("G{} needs both coordinates of its end", cycle.number), where());
  return true;
}

// G77 of Haas mills flats, for which a live tool is needed. True: it was reported as an error.
bool TurnWords::mills_flats() {
  if (!block_.has_code('G', 77) || has_axes() || !peek('L')) return false;
  error("not-supported",
        "G77 with L mills flats with a live tool (Haas), which is not supported: write the moves",
        where());
  return true;
}

bool TurnWords::pass() {
  TurnCycle& cycle = modal_.turn;
  if (mills_flats()) return false;
  Target to;
  if (!axis_end(to)) return false;
  for (const char c : {'R', cycle.number == 94 ? 'K' : 'I'})
    if (const Word* word = take(c)) cycle.taper = word->value * length_unit(*word);
  if (cycle.number == 92) take('Q');  // the spindle's angle at the start
  if (cycle.number != 92)
    take('F');
  else if (const auto lead = thread_lead())
    cycle.lead = *lead;
  else if (feed_as_lead() > 0)
    cycle.lead = feed_as_lead();
  const Vec3 from = position_.programmed;
  if (cycle.number == 94) {
    go(from.x, cycle.z + cycle.taper, kRapid);
    go(cycle.x, cycle.z, kLine);
    go(cycle.x, from.z, kLine);
    go(from.x, from.z, kRapid);
    return true;
  }
  if (cycle.number == 92 && cycle.lead <= 0)
    return error("thread-lead", "G92 cuts a thread, which needs its lead F", where());
  go(cycle.x + cycle.taper, from.z, kRapid);
  go(cycle.x, cycle.z, kLine, cycle.number == 92 ? cycle.lead : 0);
  go(from.x, cycle.z, cycle.number == 92 ? kRapid : kLine);
  go(from.x, from.z, kRapid);
  return true;
}

bool TurnWords::run() {
  if (block_.turn_cycle == 76) return is(Dialect::ngc) ? linuxcnc_thread() : thread();
  return pecks();
}

// G74 makes strokes along Z at places along X; G75 makes strokes along X at places along Z.
bool TurnWords::pecks() {
  TurnSettings& set = modal_.turn_settings;
  const Word* r = take('R');
  if (!has_axes()) {
    if (!r) return error("value-missing", "the cycle needs X or Z", where());
    set.peck_return = std::abs(r->value * length_unit(*r));
    return true;
  }
  const Vec3 from = position_.programmed;
  Target to;
  if (!axes_.target(to, from)) return false;
  double along_x = 0, along_z = 0;
  if (const Word* p = take('P')) along_x = std::abs(count(*p));
  if (const Word* q = take('Q')) along_z = std::abs(count(*q));
  if (const Word* i = take('I')) along_x = std::abs(i->value * length_unit(*i));
  if (const Word* k = take('K')) along_z = std::abs(k->value * length_unit(*k));
  double relief = r ? r->value * length_unit(*r) : 0;
  if (const Word* d = take('D')) relief = d->value * length_unit(*d);
  const bool face = block_.turn_cycle == 74;
  const double stroke = face ? along_z : along_x, shift = face ? along_x : along_z;
  const double depth = std::abs(face ? to.programmed.z - from.z : to.programmed.x - from.x);
  const double width = std::abs(face ? to.programmed.x - from.x : to.programmed.z - from.z);
  if ((stroke > 0 && depth / stroke > static_cast<double>(kMostStrokes)) ||
      (shift > 0 && width / shift > static_cast<double>(kMostStrokes)))
    return error("value-range", fmt::format("P or Q makes more than {} strokes", kMostStrokes),
                 where());
  grooves(from, to.programmed, shift, stroke, relief);
  return true;
}

void TurnWords::grooves(const Vec3& from, const Vec3& to, double shift, double stroke,
                        double relief) {
  const bool face = block_.turn_cycle == 74;
  const auto at = [&](double side, double deep, MotionKind kind) {
    face ? go(side, deep, kind) : go(deep, side, kind);
  };
  const double side0 = face ? from.x : from.z, side1 = face ? to.x : to.z;
  const double top = face ? from.z : from.x, bottom = face ? to.z : to.x;
  const double aside = sign_of(side1 - side0), down = sign_of(bottom - top);
  const double depth = std::abs(bottom - top), width = std::abs(side1 - side0);
  for (int n = 0;; ++n) {
    const double done = shift > 0 ? std::min(n * shift, width) : n > 0 ? width : 0;
    const double side = side0 + aside * done;
    at(side, top, kRapid);
    for (int i = 1; stroke > 0 && i * stroke < depth - kRounding; ++i) {
      at(side, top + down * i * stroke, kLine);
      at(side, top + down * (i * stroke - std::min(modal_.turn_settings.peck_return, i * stroke)),
         kRapid);
    }
    at(side, bottom, kLine);
    const double away = width > 0 ? side - aside * relief : side - relief;
    at(away, bottom, kRapid);
    at(away, top, kRapid);
    if (done >= width - kRounding) break;
  }
  at(side0, top, kRapid);
}

// Reads the first line of two: P mmrraa (finishing passes, chamfer in tenths of the lead, tip
// angle), Q, the least depth of a pass, and R, the finishing allowance.
bool TurnWords::thread_settings() {
  TurnSettings& set = modal_.turn_settings;
  if (const Word* p = take('P')) {
    if (p->value < 0 || p->value > 999999 || p->value != std::floor(p->value))
      return error("value-range", "P of G76 has six digits", *p);
    const int digits = static_cast<int>(p->value);
    set.finishes = std::max(1, digits / 10000);
    set.chamfer = digits / 100 % 100 * 0.1;
    set.angle = digits % 100;
  }
  if (const Word* q = take('Q')) set.least_depth = std::abs(count(*q));
  if (const Word* r = take('R')) set.finish = std::abs(least(*r));
  return true;
}

bool TurnWords::thread() {
  if (!has_axes()) return thread_settings();
  const Vec3 from = position_.programmed;
  Target to;
  if (!axes_.target(to, from)) return false;
  if (!to.named.has(kAxisX | kAxisZ))
    return error("value-missing", "G76 needs both coordinates of the thread's end", where());
  Thread t;
  t.lead = thread_lead().value_or(feed_as_lead());
  if (t.lead <= 0) return error("thread-lead", "G76 needs the lead F", where());
  if (!modal_.lead_apart) keep_lead_as_feed(t.lead);
  if (peek('K')) {
    if (!one_line_thread(t)) return false;
  } else {
    const TurnSettings& set = modal_.turn_settings;
    if (const Word* p = take('P')) t.height = std::abs(count(*p));
    if (const Word* q = take('Q')) t.first = std::abs(count(*q));
    if (const Word* r = take('R')) t.taper = least(*r);
    t.least = set.least_depth;
    t.finish = set.finish;
    t.finishes = set.finishes;
    t.chamfer = set.chamfer * t.lead;
    t.slope = tangent(set.angle / 2);
  }
  std::vector<double> depths;
  if (!thread_depths(t, depths)) return false;
  thread_passes(t, from, to.programmed, depths);
  return true;
}

// Reads G76 X Z I K D F A P: I is the taper, K the height, D the depth of the first pass, A the
// angle, P the kind of infeed.
bool TurnWords::one_line_thread(Thread& t) {
  t.height = std::abs(long_or_least(*take('K')));
  if (const Word* d = take('D')) t.first = std::abs(count(*d));
  if (const Word* i = take('I')) t.taper = long_or_least(*i);
  if (const Word* a = take('A')) t.slope = tangent(a->value / 2);
  if (const Word* p = take('P')) {
    if (p->value < 1 || p->value > 4 || p->value != std::floor(p->value))
      return error("value-range", "P of G76, the way of infeed, is 1 to 4", *p);
    t.constant_depth = p->value > 2;
    t.both_flanks = p->value == 2 || p->value == 4;
  }
  return true;
}

// "K920": no thread is that high, so the number counts least increments, as D300 beside it does.
double TurnWords::long_or_least(const Word& word) {
  const bool length = !is_computed(word) && (word.point || options_.least_increments);
  if (length || std::abs(word.value) < kLongThread) return word.value * length_unit(word);
  note_increments(word);
  return word.value * scale() * modal_.least_increment();
}

// Depths below the crest: first * sqrt(n), each pass at least `least` deeper than the one before,
// then the finishing passes.
bool TurnWords::thread_depths(const Thread& t, std::vector<double>& depths) {
  if (t.height <= 0 || t.first <= 0)
    return error("value-missing",
                 "G76 needs the height of the thread (P or K) and the depth of its first pass "
                 "(Q or D)",
                 where());
  const double rough = std::max(0.0, t.height - t.finish);
  double depth = 0;
  for (int n = 1; depth < rough - kRounding; ++n) {
    const double next = t.constant_depth ? n * t.first : std::sqrt(n) * t.first;
    depth = std::min(rough, std::max(next, depth + t.least));
    depths.push_back(depth);
    if (depths.size() > kMostStrokes)
      return error("value-range", fmt::format("more than {} passes", kMostStrokes), where());
  }
  const int last = t.finish > 0 ? t.finishes : t.finishes - 1;
  depths.insert(depths.end(), static_cast<std::size_t>(last), t.height);
  return true;
}

// Runs the passes. Each goes in X to its depth and along one flank in Z (or along both in turn),
// cuts the thread and its chamfer, goes out and back.
void TurnWords::thread_passes(const Thread& t, const Vec3& from, const Vec3& end,
                              const std::vector<double>& depths) {
  const double out = sign_of(from.x - end.x), along = sign_of(end.z - from.z);
  const double chamfer = std::min(t.chamfer, std::abs(end.z - from.z));
  bool other = false;
  for (const double depth : depths) {
    const double aside = other ? 2 * t.height - depth : depth;
    const double x = end.x + out * (t.height - depth), z = from.z + along * aside * t.slope;
    other = t.both_flanks && !other;
    go(from.x, z, kRapid);
    go(x + t.taper, z, kRapid);
    const double length = std::abs(end.z - z);
    const double before = length > 0 ? t.taper * chamfer / length : 0;
    go(x + before, end.z - along * chamfer, kLine, t.lead);
    const double lift = std::min(chamfer, std::abs(from.x - x));
    if (chamfer > 0) go(x + out * lift, end.z - along * (chamfer - lift), kLine, t.lead);
    go(from.x, position_.programmed.z, kRapid);
  }
  go(from.x, from.z, kRapid);
}

// Reads G76 P Z I J K R Q H E L of LinuxCNC. I is the distance from the drive line to the crest
// (below 0 for an outside thread), J the first depth and K the full one (all three as diameters in
// G7). R is the degression, Q the angle of the slide, H the number of spring passes; E and L are
// the tapers at the ends.
bool TurnWords::drive_line(DriveLine& out, double& springs) {
  if (const Word* x = peek('X'))
    return error("not-supported",
                 "G76 with X is that of Mach3, whose other words mean something else than "
                 "LinuxCNC's P Z I J K: write it with these",
                 *x);
  for (const char c : {'P', 'Z', 'I', 'J', 'K'})
    if (!peek(c)) return error("value-missing", fmt::format("G76 needs {}", c), where());
  const auto value = [&](char c, double otherwise) {
    const Word* word = take(c);
    return word ? word->value : otherwise;
  };
  const double across = modal_.diameter == Code::diameter_on ? scale() / 2 : scale();
  out.pitch = value('P', 0) * scale();
  out.crest = value('I', 0) * across;
  out.first = value('J', 0) * across;
  out.full = value('K', 0) * across;
  out.degression = value('R', 1);
  out.taper = value('E', 0) * scale();
  const double angle = value('Q', 0), ends = value('L', 0);
  springs = value('H', 0);
  if (out.pitch <= 0 || out.crest == 0 || out.first <= 0 || out.full <= out.first ||
      out.degression < 1 || springs < 0 || springs > 1000 || angle < 0 || angle >= 90 || ends < 0 ||
      ends > 3 || out.taper < 0)
    return error("value-range",
                 "G76 needs P, J above 0, K above J, I not 0, R at least 1, Q from 0 to below 90, "
                 "L 0 to 3",
                 where());
  out.slide = tangent(angle);
  out.taper_in = (static_cast<int>(ends) & 1) != 0 && out.taper > 0;
  out.taper_out = (static_cast<int>(ends) & 2) != 0 && out.taper > 0;
  return true;
}

bool TurnWords::linuxcnc_thread() {
  DriveLine t;
  double springs = 0;
  if (!drive_line(t, springs)) return false;
  const Vec3 from = position_.programmed;
  Target to;
  if (!axes_.target(to, from)) return false;
  t.end = to.programmed.z;
  std::size_t passes = 0;
  for (double depth = t.first; depth < t.full;) {
    drive_line_pass(t, from, depth);
    if (++passes > kMostStrokes)
      return error("value-range", fmt::format("more than {} passes", kMostStrokes), where());
    depth = t.first * power(static_cast<double>(passes + 1), 1 / t.degression);
  }
  for (int i = 0; i <= static_cast<int>(springs); ++i) drive_line_pass(t, from, t.full);
  go(from.x, position_.programmed.z, kRapid);
  return true;
}

void TurnWords::drive_line_pass(const DriveLine& t, const Vec3& from, double depth) {
  const double s = sign_of(t.crest);
  const double x = from.x + t.crest + s * depth, clear = x - t.crest - s * t.full;
  const double z = from.z - depth * t.slide, last = t.end + (t.full - depth) * t.slide;
  const double slope =
      t.taper > 0 ? t.pitch * std::sqrt(t.taper * t.taper + t.full * t.full) / t.taper : t.pitch;
  go(clear, z, kRapid);
  go(t.taper_in ? x - s * t.full : x, z, t.taper_in ? kLine : kRapid, t.taper_in ? slope : 0);
  if (t.taper_in) go(x, z - t.taper, kLine, slope);
  go(x, t.taper_out ? last + t.taper : last, kLine, t.pitch);
  if (t.taper_out) go(x - s * t.full, last, kLine, slope);
  go(clear, last, kRapid);
}

}  // namespace mrsim
