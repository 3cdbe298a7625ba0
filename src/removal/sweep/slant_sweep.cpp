#include "removal/sweep/slant_sweep.h"

#include "removal/simd/lane_scalar.h"

#include <algorithm>
#include <cmath>

namespace mrsim {

SlantRecord slant_record(const Profile& tool, const ToolPath& path) {
  const bool falls = path.travel.z < 0;
  const Vec3 low = falls ? path.start + path.travel : path.start;
  const Vec3 up = falls ? -path.travel : path.travel;
  const double plan = std::sqrt(up.x * up.x + up.y * up.y), length = std::sqrt(dot(up, up));
  SlantRecord r;
  r.x = low.x, r.y = low.y, r.z = low.z + tool.round();
  r.ux = up.x / plan, r.uy = up.y / plan;
  r.length = length, r.plan = plan / length, r.rise = up.z / length;
  r.core = tool.core(), r.round = tool.round();
  r.falls = falls;
  return r;
}

// The tool stays within its radius of the line in plan, above its lower end, and above the plane
// along the line that its core's rim touches at the back.
double slant_bound(const SlantRecord& r, const Vec3& p) {
  const double dx = p.x - r.x, dy = p.y - r.y, below = r.z - p.z;
  const double along = dx * r.ux + dy * r.uy, off = dx * r.uy - dy * r.ux;
  const double beyond = along - std::clamp(along, 0.0, r.length * r.plan);
  const double aside = std::sqrt(off * off + beyond * beyond) - r.core;
  const double under = r.plan * below + r.rise * (along - r.core);
  return std::max({aside, under, below}) - r.round;
}

PathSample slant_minimum(const SlantRecord& line, const Vec3& p) {
  const lane::SlantLeast least =
      lane::slant_least(lane::SlantStretch(line, p.x, p.y, p.z), line.round, true);
  const double share = least.way / line.length;
  return {least.distance, line.falls ? 1 - share : share};
}

}  // namespace mrsim
