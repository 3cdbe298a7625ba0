#include "removal/forms/tool_at_rest.h"

#include "removal/simd/scalar_forms.h"

#include <cmath>

namespace mrsim {

ProfileSample tool_sample(const Profile& tool, double rho, double z) {
  if (!tool.is_end_mill()) return tool.sample({rho, z});
  const bool upper = z >= 0.5 * tool.top();
  const double dr = rho - (upper ? tool.max_radius() : tool.core());
  const double dz = upper ? z - tool.top() : tool.round() - z, way = upper ? 1 : -1;
  const std::int32_t wall = tool.round() > 0 ? 0 : 1, end = upper ? wall + 1 : 0;
  ProfileSample s{tool_distance(tool, rho, z), {}, dr > dz ? wall : end};
  if (dr > 0 && dz > 0) {
    const double n = std::sqrt(dr * dr + dz * dz);
    s.gradient = {dr / n, way * dz / n};
    s.curvature = 1 / n;
  } else {
    s.gradient = dr > dz ? Vec2{1, 0} : Vec2{0, way};
  }
  return s;
}

double tool_distance(const Profile& tool, double rho, double z) {
  if (!tool.is_end_mill()) return tool.distance({rho, z});
  return lane::rounded_slab(rho, z, tool.round(), tool.core(), tool.round(), tool.top());
}

Vec2 slab_face_gradient(const Profile& tool, double rho, double z, std::int32_t patch) {
  const std::int32_t wall = tool.round() > 0 ? 0 : 1;
  if (patch > wall) return {0, 1};
  if (tool.round() == 0) return patch == wall ? Vec2{1, 0} : Vec2{0, -1};
  const double dr = rho - tool.core(), dz = tool.round() - z;
  if (!(dr > 0 && dz > 0)) return dr > dz ? Vec2{1, 0} : Vec2{0, -1};
  const double n = std::sqrt(dr * dr + dz * dz);
  return {dr / n, -dz / n};
}

double slab_face_distance(const Profile& tool, double rho, double z, std::int32_t patch) {
  const std::int32_t wall = tool.round() > 0 ? 0 : 1;
  if (patch > wall) return z - tool.top();
  if (tool.round() == 0) return patch == wall ? rho - tool.core() : -z;
  const double dr = rho - tool.core(), dz = tool.round() - z;
  const double to_core = dr > 0 && dz > 0 ? std::sqrt(dr * dr + dz * dz) : dr > dz ? dr : dz;
  return to_core - tool.round();
}

}  // namespace mrsim
