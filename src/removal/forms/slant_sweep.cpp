#include "removal/forms/slant_sweep.h"

#include "removal/simd/scalar_forms.h"

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

PathSample slant_minimum(const SlantRecord& line, const Vec3& p) {
  const lane::SlantLeast least =
      lane::slant_least(lane::SlantStretch(line, p.x, p.y, p.z), line.round, true);
  const double share = least.way / line.length;
  return {least.distance, line.falls ? 1 - share : share};
}

}  // namespace mrsim
