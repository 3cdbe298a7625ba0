#include "removal/forms/upright_sweep.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "removal/simd/scalar_forms.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

constexpr Vec2 kAxes[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};

int quadrant(Vec2 w) {
  if (w.y >= 0) return w.x > 0 ? 0 : 1;
  return w.x < 0 ? 2 : 3;
}

bool is_mirrored(const ToolPath& path, int branch) {
  const int k = (path.first_quarter + branch) % 4;
  return k == 1 || k == 2;
}

UprightRecord record(double core, double round, const ToolPath& path, int branch) {
  const int k = (path.first_quarter + branch) % 4;
  const bool mirrored = is_mirrored(path, branch);
  const auto folded = [mirrored](Vec2 w) {
    return Vec2{std::max(0.0, mirrored ? -w.x : w.x), w.y};
  };
  const Vec2 begin = folded(branch == 0 ? path.begin : kAxes[k]);
  const Vec2 end = folded(branch == path.quarters - 1 ? path.end : kAxes[(k + 1) % 4]);
  const Vec2 high = mirrored ? begin : end, low = mirrored ? end : begin;
  const Vec3& at = path.center;
  const double side = mirrored ? -1 : 1;
  return {at.x,
          at.y,
          at.z,
          side * path.along.x,
          side * path.along.y,
          path.radius,
          high.x,
          high.y,
          low.x,
          low.y,
          core,
          round,
          k >= 2 ? -1.0 : 1.0};
}

struct Found {
  double distance = std::numeric_limits<double>::infinity();
  int branch = 0;
  Vec2 w;  // place on the quarter, mirrored
};

Found least(double core, double round, const ToolPath& path, const Vec3& p, int from, int to) {
  Found best;
  for (int branch = from; branch < to; ++branch) {
    const UprightRecord quarter = record(core, round, path, branch);
    const auto* columns = reinterpret_cast<const double*>(&quarter);
    const lane::UprightLeast found =
        lane::upright_least(columns, p.x, p.y, p.z, best.distance, true);
    if (found.distance < best.distance) best = {found.distance, branch, {found.at.wx, found.at.wy}};
  }
  return best;
}

Found least(const Profile& tool, const ToolPath& path, const Vec3& p, int from, int to) {
  return least(tool.core(), tool.round(), path, p, from, to);
}

Vec2 direction(const ToolPath& path, const Found& found) {
  return {is_mirrored(path, found.branch) ? -found.w.x : found.w.x, found.w.y};
}

// The path's parameter; exact at its ends.
double parameter(const ToolPath& path, const Found& found) {
  const Vec2 w = direction(path, found);
  // After a whole turn the quarter of the start comes again.
  const bool again = path.quarters > 4 && found.branch == path.quarters - 1;
  double t = mrsim::atan2(cross(path.begin, w), dot(path.begin, w));
  if (t < (again ? kAtPathEnd : -kAtPathEnd)) t += kTwoPi;
  return t < kAtPathEnd ? 0 : t > path.sweep - kAtPathEnd ? path.sweep : t;
}

}  // namespace

void set_upright_plane(ToolPath& path) {
  path.sweep = std::min(path.sweep, kTwoPi);
  const Vec3 axis = cross(path.u, path.v);
  const double plan = std::sqrt(axis.x * axis.x + axis.y * axis.y);
  // `along` is turned so that the motion goes from it towards +z.
  path.along = {-axis.y / plan, axis.x / plan};
  const auto in_plane = [&path](const Vec3& w) {
    const Vec2 at = {w.x * path.along.x + w.y * path.along.y, w.z};
    return (1 / length(at)) * at;
  };
  if (const Vec2 u = in_plane(path.u), v = in_plane(path.v); cross(u, v) < 0)
    path.along = -1.0 * path.along;
  path.begin = in_plane(path.u);
  path.end = in_plane(path_point(path, path.sweep).position - path.center);
  set_quarters(path);
}

void set_quarters(ToolPath& path) {
  path.first_quarter = quadrant(path.begin);
  path.quarters = (quadrant(path.end) - path.first_quarter + 4) % 4 + 1;
  while (path.sweep > path.quarters * (kPi / 2) + kTurnRounding) path.quarters += 4;
}

void append_quarters(const Profile& tool, const ToolPath& path, std::vector<UprightRecord>& out) {
  for (int branch = 0; branch < path.quarters; ++branch)
    out.push_back(record(tool.core(), tool.round(), path, branch));
}

Vec2 upright_place(double core, double round, const ToolPath& path, const Vec3& p) {
  return direction(path, least(core, round, path, p, 0, path.quarters));
}

double upright_value(const Profile& tool, const ToolPath& path, const Vec3& p) {
  return least(tool, path, p, 0, path.quarters).distance;
}

PathSample upright_minimum(const Profile& tool, const ToolPath& path, const Vec3& p) {
  const Found found = least(tool, path, p, 0, path.quarters);
  return {found.distance, parameter(path, found)};
}

PathPoint upright_branch_point(const Profile& tool, const ToolPath& path, const Vec3& p,
                               int branch) {
  const Vec2 at = path.radius * direction(path, least(tool, path, p, branch, branch + 1));
  return {path.center + Vec3{at.x * path.along.x, at.x * path.along.y, at.y},
          {-at.y * path.along.x, -at.y * path.along.y, at.x}};
}

int upright_branch(const ToolPath& path, double t) {
  const SinCos sc = sincos(t);
  const Vec2 u = path.begin;
  const int k = quadrant({sc.cos * u.x - sc.sin * u.y, sc.cos * u.y + sc.sin * u.x});
  const int branch = (k - path.first_quarter + 4) % 4;
  // The quarter of the start comes again after a whole turn; rounding may step over an end.
  if (branch == 0 && t > kPi) return path.quarters - 1;
  return std::min(branch, path.quarters - 1);
}

PathSample upright_branch_minimum(const Profile& tool, const ToolPath& path, const Vec3& p,
                                  int branch) {
  const Found found = least(tool, path, p, branch, branch + 1);
  return {found.distance, parameter(path, found)};
}

}  // namespace mrsim
