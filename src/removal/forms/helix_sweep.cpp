#include "removal/forms/helix_sweep.h"

#include "core/numbers/units.h"
#include "removal/simd/scalar_forms.h"

namespace mrsim {
namespace {

PathSample minimum(const HelixRecord& record, const Vec3& p) {
  const lane::HelixLeast least = lane::helix_least(record, p.x, p.y, p.z, true);
  return {least.distance, least.t};
}

}  // namespace

HelixRecord helix_record(const Profile& tool, const ToolPath& path) {
  return {path.center.x,
          path.center.y,
          path.center.z + tool.round(),
          path.u.x,
          path.u.y,
          path.v.x,
          path.v.y,
          path.radius,
          -path.rise.z,
          tool.core(),
          tool.round(),
          {},
          {path.sweep, path.last.y, path.last.x}};
}

LineRecord bore_record(const Profile& tool, const ToolPath& path) {
  const Vec3& at = path.center;
  const double low = at.z + tool.round();
  return {{at.x, at.y, path.radius, tool.core(), tool.round(), low, low + path.sweep * path.rise.z,
           path.bored ? 1.0 : 0.0}};
}

PathSample helix_minimum(const Profile& tool, const ToolPath& path, const Vec3& p) {
  const HelixRecord record = helix_record(tool, path);
  if (path.bored)
    if (const lane::Bore wall = lane::bore(bore_record(tool, path).c, p.x, p.y, p.z); wall.decided)
      return {wall.distance, lane::HelixView(record, p.x, p.y, p.z).facing()};
  return minimum(record, p);
}

PathSample helix_branch_minimum(const Profile& tool, const ToolPath& path, const Vec3& p,
                                int branch) {
  HelixRecord record = helix_record(tool, path);
  // Quarter turns end on u and v.
  const auto turned = [&path, &record](int k) {
    constexpr double kSine[4] = {0, 1, 0, -1};
    const HelixRecord::End at{k * (kPi / 2), kSine[k % 4], kSine[(k + 1) % 4]};
    return at.t < path.sweep ? at : record.end;
  };
  record.begin = turned(branch), record.end = turned(branch + 1);
  return minimum(record, p);
}

}  // namespace mrsim
