#include "removal/forms/path_sweep.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "removal/forms/disc_sweep.h"
#include "removal/forms/flank_sweep.h"
#include "removal/forms/helix_sweep.h"
#include "removal/forms/path_search.h"
#include "removal/forms/slant_sweep.h"
#include "removal/forms/upright_sweep.h"
#include "removal/simd/scalar_forms.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace mrsim {
namespace {

// Tools with forms of their own, from `begin` to `end` of the path.
std::optional<PathSample> solved(const Profile& tool, const ToolPath& path, const Vec3& p,
                                 double begin, double end) {
  if (path.disc) return disc_minimum(tool, path, p, begin, end);
  return path.flanked ? flank_minimum(tool, path, p, begin, end) : std::nullopt;
}

}  // namespace

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

PathSample path_distance(const Profile& tool, const ToolPath& path, const Vec3& p) {
  if (is_slant(tool, path)) return slant_minimum(slant_record(tool, path), p);
  if (const auto least = solved(tool, path, p, 0, path.sweep)) return *least;
  if (path.upright) return upright_minimum(tool, path, p);
  if (has_stretches(tool, path)) return helix_minimum(tool, path, p);
  if (path.lowest_turn) return search_lowest_turn(tool, path, p);
  return search_path(tool, path, p, 0, path.arc ? path.sweep : 1);
}

double path_value(const Profile& tool, const ToolPath& path, const Vec3& p) {
  if (path.upright) return upright_value(tool, path, p);
  if (path.bored)
    if (const lane::Bore wall = lane::bore(bore_record(tool, path).c, p.x, p.y, p.z); wall.decided)
      return wall.distance;
  if (path.flanked)
    if (const auto least = flank_value(tool, path, p)) return *least;
  return path_distance(tool, path, p).distance;
}

int path_branch(const ToolPath& path, double t) {
  if (path.upright) return upright_branch(path, t);
  const int last = static_cast<int>(path.sweep / (kPi / 2));
  const int branch = static_cast<int>(t / (kPi / 2));
  return branch < last ? branch : last;
}

std::pair<double, double> branch_ends(const ToolPath& path, int branch) {
  const double end = std::min((branch + 1) * (kPi / 2), path.sweep);
  return {std::min(branch * (kPi / 2), end), end};
}

PathSample branch_distance(const Profile& tool, const ToolPath& path, const Vec3& p, int branch) {
  if (path.upright) return upright_branch_minimum(tool, path, p, branch);
  const auto [begin, end] = branch_ends(path, branch);
  if (const auto least = solved(tool, path, p, begin, end)) return *least;
  if (has_stretches(tool, path)) return helix_branch_minimum(tool, path, p, branch);
  return search_path(tool, path, p, begin, end);
}

PathSample piece_distance(const Profile& piece, const ToolPath& path, const Vec3& p, int branch) {
  const auto [begin, end] = path.arc ? branch_ends(path, branch) : std::pair(0.0, 1.0);
  return search_path(piece, path, p, begin, end);
}

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
