#include "interp/control/control.h"

#include "core/numbers/units.h"
#include "core/text/text_io.h"

#include <algorithm>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kAngleIncrement = 1e-3;   // degrees: the unit of a number without a point
constexpr double kLargestLead[] = {6, 2};  // mm, inches; a larger E is threads an inch

}  // namespace

std::string Control::offset_name(std::string_view written) const {
  std::string name;
  for (const char c : written)
    if (c != ' ') name += c;
  if (dialect != Dialect::fanuc && dialect != Dialect::iso) return name;
  if (name.starts_with("G154P")) return "G54.1" + name.substr(4);
  if (name.size() != 4 || !name.starts_with("G1")) return name;
  const auto number = parse_number(name.substr(1));
  return number && *number >= 110 && *number <= 129 ? fmt::format("G54.1P{:g}", *number - 109)
                                                    : name;
}

// The first work offset (G54 if there is one) lies where the tool table says, else at the stock's
// zero. That ties the machine's coordinates to those of the stock. The other offsets follow from
// it, unless the tool table has them.
void Control::shift_machine() {
  for (WorkOffset& offset : work) offset.name = offset_name(offset.name);
  std::vector<WorkOffset> zeros = options.places.zero;
  if (zeros.empty()) return;
  for (WorkOffset& zero : zeros) zero.name = offset_name(zero.name);
  const auto find = [](const auto& list, const std::string& name) {
    return std::find_if(list.begin(), list.end(),
                        [&](const WorkOffset& one) { return one.name == name; });
  };
  auto base = find(zeros, "G54");
  if (base == zeros.end()) base = zeros.begin();
  const auto known = find(work, base->name);
  machine_shift = (known == work.end() ? Vec3{} : known->shift) - base->shift;
  machine_known = true;
  for (const WorkOffset& zero : zeros)
    if (find(work, zero.name) == work.end())
      work.push_back({zero.name, zero.shift + machine_shift});
}

OffsetRegister& Control::change_register(const std::string& name) {
  ++register_changes;
  for (OffsetRegister& reg : registers)
    if (reg.name == name) return reg;
  OffsetRegister fresh;
  fresh.name = name;
  fresh.wear = bare_wear(name);
  return registers.emplace_back(fresh);
}

double& Control::change_wear(const std::string& name) {
  ++register_changes;
  for (OffsetRegister& reg : registers)
    if (reg.name == name) return reg.wear;
  return bare_wears[name];
}

double Control::bare_wear(const std::string& name) const {
  const auto at = bare_wears.find(name);
  return at == bare_wears.end() ? 0 : at->second;
}

bool is_circular(Code c) {
  return c == Code::arc_cw || c == Code::arc_ccw || c == Code::arc_point || c == Code::arc_tangent;
}
bool is_thread(Code c) {
  return c == Code::thread || c == Code::thread_growing || c == Code::thread_shrinking ||
         c == Code::tap_in || c == Code::tap_return || c == Code::tap_out ||
         c == Code::tap_floating;
}

bool ControlPart::goes_on(const Word& cycle) {
  return !block_.leaves() ||
         error("call-not-alone",
               fmt::format("{} reads its contour behind this block, which calls or ends the "
                           "program: write that in the next one",
                           text_of(cycle)),
               cycle);
}

bool ControlPart::error(const char* code, const std::string& text, const Word& word) {
  reporter_.add(Severity::error, code, text, word);
  return false;
}

void ControlPart::warning(const char* code, const std::string& text, const Word& word) {
  reporter_.add(Severity::warning, code, text, word);
}

void ControlPart::note_once(const char* code, const std::string& text, const Word& word,
                            const std::string& key) {
  reporter_.once(Severity::note, code, text, word, key);
}

bool ControlPart::angle_of_slope(const Word& angle) {
  if (!is(Dialect::fanuc)) return false;
  reporter_.once(
      Severity::warning, "angle-behind",
      fmt::format("the line runs the other way than {} points: FANUC's angle is its slope",
                  text_of(angle)),
      angle, "angle of slope");
  return true;
}

void ControlPart::note_increments(const Word& word) {
  note_once("number-without-point",
            is_computed(word)
                ? fmt::format("{} = {:g} counts least increments", text_of(word), word.value)
                : fmt::format("{} without a decimal point counts least increments", text_of(word)),
            word, std::string("increments ") + static_cast<char>(word.address));
}

double ControlPart::length_unit(const Word& word) const {
  const double unit = modal_.inch ? 25.4 : 1.0;
  if (!options_.least_increments || word.point || !is(Dialect::fanuc)) return unit;
  return unit * modal_.least_increment();
}

double ControlPart::angle_value(const Word& word) const {
  const bool counts = options_.least_increments && !word.point && is(Dialect::fanuc);
  return counts ? word.value * kAngleIncrement : word.value;
}

double ControlPart::axis_value(int axis, const Word& word, bool incremental) const {
  const double value = word.value * length_unit(word);
  if (axis != 0) return value;
  switch (word.form) {
    case Form::dac:
    case Form::dic:
      return value / 2;
    case Form::rac:
    case Form::ric:
      return value;
    default:
      break;
  }
  if (modal_.diameter == Code::diameter_on) return value / 2;
  if (modal_.diameter == Code::diameter_absolute && !incremental) return value / 2;
  return value;
}

Basis ControlPart::stock_basis() const {
  const Basis b = basis();
  const Frame& f = frames_.total;
  if (f.plain) return b;
  return {normalized(turn(f, b.u)), normalized(turn(f, b.v)), normalized(turn(f, b.w))};
}

// E of FANUC's lathes is a lead with more digits than F (0T and Haas, and programs of Mastercam in
// inches). In the format of series 10, 11 and 15, E is the number of threads in an inch.
std::optional<double> ControlPart::thread_lead() {
  if (const Word* f = take('F')) {
    modal_.lead_apart = false;
    return f->value * feed_scale();
  }
  const Word* e = is(Dialect::fanuc) && lathe() ? take('E') : nullptr;
  if (!e) return std::nullopt;
  modal_.lead_apart = true;
  const bool counts = e->value > kLargestLead[modal_.inch_feed ? 1 : 0];
  note_once("thread-lead",
            fmt::format("{} is read as {}", text_of(*e),
                        counts ? "the number of threads in an inch" : "the lead of the thread"),
            *e, "lead-in-e");
  return counts ? kMmPerInch / e->value : e->value * feed_scale();
}

// F200 of G98 is no lead after G99, though its number stays in force.
double ControlPart::feed_as_lead() const {
  const bool common = is(Dialect::fanuc) && lathe() && !modal_.lead_apart && modal_.feed_of_turn;
  return common && modal_.feed_unit == FeedUnit::mm_per_rev ? modal_.feed : 0;
}

void ControlPart::keep_lead_as_feed(double lead) {
  if (!is(Dialect::fanuc) || !lathe() || modal_.feed_unit != FeedUnit::mm_per_rev) return;
  modal_.feed = lead;
  modal_.feed_of_turn = true;
}

}  // namespace mrsim
