// The path of a horizontal or upright move as seen from above, and the point of it that is nearest
// to a point in plan. One code for every form whose distance follows from the distance in plan and
// the height above the tip.
#pragma once

#include "removal/columns/sweep_columns.h"

namespace mrsim {

/// Nearest point of a horizontal path, on one half of an arc when asked for.
struct PlanFoot {
  double x = 0, y = 0, rho = 0;
  int half = 0;
};

/// Halves of an arc.
enum class Half { any = -1, first = 0, second = 1 };

/// A horizontal or upright move of any tool: plan path, its lowest tip height, vertical travel.
struct HorizontalView {
  bool arc = false;
  const double* plan = nullptr;
  double z = 0;  // of the tip
};

/// Requires: a horizontal or upright move. Points into the columns.
HorizontalView horizontal_view(const SweepColumns& columns, const SweepRef& ref);
/// p in the tool's frame, mm.
PlanFoot plan_foot(const HorizontalView& v, const Vec3& p, Half half);

}  // namespace mrsim
