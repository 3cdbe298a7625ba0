#include "removal/part/stock_margin.h"

#include "core/numbers/motions.h"
#include "removal/tool/tool.h"

#include <algorithm>
#include <cmath>

namespace mrsim {

double margin_of(const Box3& cuts) {
  constexpr double kMargin = 0.05;
  const double longest =
      std::max({cuts.hi.x - cuts.lo.x, cuts.hi.y - cuts.lo.y, cuts.hi.z - cuts.lo.z});
  return std::ceil(std::max(kLeastMargin, kMargin * longest));
}

double round_down(double v) { return std::floor(v * 10) / 10; }
double round_up(double v) { return std::ceil(v * 10) / 10; }

std::vector<double> radii_of(std::span<const Motion> motions, std::span<const Tool> tools) {
  std::vector<double> radii(tools.size(), 0);
  for (const Motion& m : motions) {
    if (!is_cut(m) || m.tool < 0) continue;
    double& radius = radii[static_cast<std::size_t>(m.tool)];
    if (radius == 0) radius = make_tool_shape(tools[static_cast<std::size_t>(m.tool)]).radius;
  }
  return radii;
}

}  // namespace mrsim
