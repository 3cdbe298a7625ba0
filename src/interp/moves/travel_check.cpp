#include "interp/moves/travel_check.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "interp/path/arc.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kAtLimit = 1e-4;  // mm: so far beyond a limit is rounding

// The least and the largest coordinate of the motion, without its start, where another motion
// ended.
std::pair<double, double> reach(const Motion& m, int axis) {
  const double end = component(m.end, axis);
  std::pair<double, double> found{end, end};
  if (m.kind != MotionKind::arc) return found;
  // The coordinate turns back at the angle `turn` and each half turn behind it; the first and the
  // last turn of the arc hold its extremes.
  const Vec3 radial = m.start - m.center;
  const double whole = std::abs(m.sweep), sign = m.sweep < 0 ? -1 : 1;
  const double turn = sign * atan2(component(cross(m.axis, radial), axis), component(radial, axis));
  for (const double from : {0.0, std::max(0.0, whole - kTwoPi)}) {
    double angle = turn + std::ceil((from - turn) / kPi) * kPi;
    for (; angle < std::min(from + kTwoPi, whole); angle += kPi) {
      const double at = component(arc_point(m, angle / whole), axis);
      found = {std::min(found.first, at), std::max(found.second, at)};
    }
  }
  return found;
}

}  // namespace

// Whether machine coordinates of the block are known: it is written in them, or in a work offset
// whose zero is known.
bool TravelCheck::knows_offset() const {
  const bool to_reference =
      block_.home || (block_.oneshot && (block_.oneshot_code == Code::reference ||
                                         block_.oneshot_code == Code::reference_second ||
                                         block_.oneshot_code == Code::reference_approach ||
                                         block_.oneshot_code == Code::fixed_point));
  return block_.suppress_frames || to_reference ||
         (frames_.work_given && !frames_.work_name.empty());
}

AxisSet TravelCheck::axes(const Motion& motion) {
  if (!options_.places.limits || !control_.machine_known) return {};
  AxisSet moved = position_.known - known_;
  known_ = position_.known;
  for (int i = 0; i < 3; ++i)
    if (motion.kind == MotionKind::arc ||
        std::abs(component(motion.end, i) - component(motion.start, i)) > kAtLimit)
      moved.add(i);
  if (modal_.comp != Code::comp_off) moved = kAllAxes;
  if (control_.tool.below) moved -= kAxisX;
  if (knows_offset()) return moved & position_.known;
  ++unchecked_;
  return {};
}

void TravelCheck::check(const Motion& motion, AxisSet axes) {
  for (int i = 0; i < 3; ++i) {
    if (!axes.has(i)) continue;
    const auto [low, high] = reach(motion, i);
    const double zero = component(control_.machine_shift, i);
    const Box3& limits = *options_.places.limits;
    const double beyond[2] = {component(limits.lo, i) + zero - low,
                              high - zero - component(limits.hi, i)};
    for (const std::size_t side : {0U, 1U}) {
      if (!(beyond[side] > kAtLimit)) continue;
      Excess& found = found_[static_cast<std::size_t>(i)][side];
      if (found.motions++ == 0) found.first = motion;
      if (beyond[side] <= found.most) continue;
      found.most = beyond[side];
      found.worst = motion;
    }
  }
}

void TravelCheck::finish() {
  if (!options_.places.limits) return;
  if (!control_.machine_known)
    return reporter_.add_general(
        Severity::note, "travel-unchecked",
        "the limits of [machine] are not checked: where its zero lies is unknown; give the place "
        "of the work zero in machine coordinates, zero.G54 = [x, y, z]");
  for (std::size_t i = 0; i < 3; ++i)
    for (const std::size_t side : {0U, 1U}) {
      const Excess& found = found_[i][side];
      if (found.motions == 0) continue;
      const Box3& limits = *options_.places.limits;
      std::string text = fmt::format(
          "{} leaves the machine's travel: {:.4g} mm {} its limit of {:g}", "XYZ"[i], found.most,
          side == 0 ? "below" : "above", component(side == 0 ? limits.lo : limits.hi, int(i)));
      if (found.motions > 1)
        text +=
            fmt::format(", in {} motions, farthest in line {}", found.motions, found.worst.line);
      reporter_.add_at(Severity::warning, "beyond-travel", text, found.first);
    }
  if (unchecked_ > 0)
    reporter_.add_general(
        Severity::note, "travel-unchecked",
        fmt::format(
            "the limits of [machine] are not checked for {} motions: where the work zero in "
            "force lies on the machine is unknown",
            unchecked_));
}

}  // namespace mrsim
