#include "removal/forms/tool_path.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"

#include <cmath>

namespace mrsim {

PathPoint path_point(const ToolPath& path, double t) {
  if (!path.arc) return {path.start + t * path.travel, path.travel};
  const SinCos sc = sincos(t);
  return {path.center + sc.cos * path.u + sc.sin * path.v + t * path.rise,
          sc.cos * path.v - sc.sin * path.u + path.rise};
}

bool is_two_sided(const ToolPath& arc) {
  constexpr double kUpright = kTurnRounding;
  const double normal_z = arc.u.x * arc.v.y - arc.u.y * arc.v.x, square = arc.radius * arc.radius;
  return arc.horizontal || (arc.rise == Vec3{} && std::abs(normal_z) <= kUpright * square);
}

}  // namespace mrsim
