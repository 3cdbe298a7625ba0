// G85 and G87 of Okuma's LAP: the contour stands between "NLAP1 G81" and G80, wherever in the
// program.
#include "interp/turning/contour_cycles.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kLapEscape = 0.5;  // mm: a parameter of the control

}  // namespace

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
  call_.where = where;
  call_.number = block_.turn_cycle == 70 ? 70 : contour->number == 82 ? 72 : 71;
  const Word* u = take('U');
  const Word* w = take('W');
  if (u) call_.allowance.x = std::abs(axis_value(0, *u, true));
  if (w) call_.allowance.z = std::abs(w->value) * length_unit(*w);
  take('E');
  if (call_.number != 70 && !lap_depth()) return false;
  if (call_.number == 70 && length(call_.allowance) > 0)
    return error("not-supported", "U and W of G87 (a stock that finishing leaves)", where);
  waits_ = true;
  return true;
}

// D of passes along Z is what they take off the diameter.
bool ContourCycles::lap_depth() {
  const Word* d = take('D');
  if (!d || d->value == 0)
    return error("value-missing", "G85 needs D, the depth of a pass", call_.where);
  TurnSettings& set = modal_.turn_settings;
  set.depth = std::abs(d->value) * length_unit(*d) * (call_.number == 71 ? 0.5 : 1);
  set.escape = kLapEscape;
  return true;
}

// The allowances are left on the side that the passes come from.
void ContourCycles::orient_allowance() {
  const int u = call_.number == 72 ? 2 : 0, v = 2 - u;
  const Vec3 from = position_.physical;
  double deepest = 0;
  for (const Motion& m : contour_) {
    const double travel = component(m.end - from, u);
    if (std::abs(travel) > std::abs(deepest)) deepest = travel;
  }
  const double travel = contour_.empty() ? 0 : component(contour_.back().end - from, v);
  component(call_.allowance, u) = std::copysign(component(call_.allowance, u), -deepest);
  component(call_.allowance, v) = std::copysign(component(call_.allowance, v), -travel);
}

// The program has come to a contour on its way: it goes on behind G80.
void ContourCycles::pass_over_lap() {
  const Word where = *block_.lap_begins;
  if (const auto contour = lap_contour(block_.name, where)) reader_.jump(contour->behind);
}

}  // namespace mrsim
