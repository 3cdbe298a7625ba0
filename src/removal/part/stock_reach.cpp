#include "removal/part/stock_reach.h"

#include "core/numbers/motions.h"
#include "core/numbers/vec.h"
#include "removal/forms/sweep_motion.h"

#include <cmath>

namespace mrsim {
namespace {

bool passes_by(const Box3& path, const Box3& stock, double reach) {
  return path.hi.x < stock.lo.x - reach || path.lo.x > stock.hi.x + reach ||
         path.hi.y < stock.lo.y - reach || path.lo.y > stock.hi.y + reach ||
         path.hi.z < stock.lo.z - reach;
}

}  // namespace

double share_beside(std::span<const Motion> motions, std::span<const Tool> tools,
                    const Box3& stock) {
  double all = 0, beside = 0;
  for (const Motion& m : motions) {
    if (!is_cut(m) || m.tool < 0) continue;
    const Box3 path = path_bounds(localized(m, nullptr));
    if (path.lo.z >= stock.hi.z) continue;
    const bool is_arc = m.kind == MotionKind::arc;
    const double way = is_arc ? std::fabs(m.sweep) * m.radius : length(m.end - m.start);
    all += way;
    if (passes_by(path, stock, tools[static_cast<std::size_t>(m.tool)].diameter)) beside += way;
  }
  return all > 0 ? beside / all : 0;
}

}  // namespace mrsim
