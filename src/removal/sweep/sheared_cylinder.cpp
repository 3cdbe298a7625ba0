#include "removal/sweep/sheared_cylinder.h"

#include "core/numbers/trig.h"
#include "core/numbers/units.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr double kLeastSlope = 1e-4;  ///< of a path that draws a sheared cylinder
constexpr double kFlat = 0.5;         ///< |normal.z| of a floor

struct ShearedCylinder {
  const PathColumn& paths;
  std::size_t row;
  const CornerCircle& corner;
  double z = 0, rise = 0, plan = 0;  ///< start, and way a unit of the path's parameter

  bool is_line() const { return paths.is_line(row); }
  PathPoint at(double t) const { return paths.point(row, t); }
  /// The parameter of the path where the circle has that height, mm.
  double place_at_height(double height) const { return (height - corner.at.y - z) / rise; }
};

std::optional<ShearedCylinder> cylinder_of(const PathColumn& paths, std::size_t row,
                                           const CornerCircle& corner) {
  ShearedCylinder s{paths, row, corner};
  if (s.is_line()) {
    const auto& [start, travel] = paths.line(row);
    s.z = start.z, s.rise = travel.z;
    s.plan = std::sqrt(travel.x * travel.x + travel.y * travel.y);
  } else {
    const ToolPath& path = paths.arc(row);
    if (!path.horizontal) return std::nullopt;
    s.z = path.center.z, s.rise = path.rise.z, s.plan = path.radius;
  }
  if (!(std::abs(s.rise) > kLeastSlope * s.plan)) return std::nullopt;
  return s;
}

// The normal at p, a point of the circle of the position `at`. None at the circle's centre.
std::optional<Vec3> normal_at(const ShearedCylinder& s, const PathPoint& at, const Vec3& p) {
  const double x = p.x - at.position.x, y = p.y - at.position.y;
  const double rho = std::sqrt(x * x + y * y);
  if (!(rho > 0)) return std::nullopt;
  const double lean = -(x * at.direction.x + y * at.direction.y) / (rho * s.rise);
  const double scale = 1 / std::sqrt(1 + lean * lean);
  return Vec3{scale * x / rho, scale * y / rho, scale * lean};
}

// The positions whose circles pass over or below p: from middle - half to middle + half. Where
// none does, half = 0 and the middle is the place that is nearest to p in plan.
struct Passing {
  double middle = 0, half = 0;
};

Passing passing_line(const ShearedCylinder& s, const Vec3& p) {
  const auto& [start, travel] = s.paths.line(s.row);
  const double x = p.x - start.x, y = p.y - start.y;
  const double per_plan = 1 / (s.plan * s.plan);
  const double off = x * travel.y - y * travel.x;
  const double left = s.corner.at.x * s.corner.at.x - off * off * per_plan;
  return {(x * travel.x + y * travel.y) * per_plan, std::sqrt(std::max(0.0, left) * per_plan)};
}

Passing passing_helix(const ShearedCylinder& s, const Vec3& p) {
  const ToolPath& path = s.paths.arc(s.row);
  const double x = p.x - path.center.x, y = p.y - path.center.y, far2 = x * x + y * y;
  const double cosine = (path.radius * path.radius + far2 - s.corner.at.x * s.corner.at.x) /
                        (2 * path.radius * std::sqrt(far2));
  const double angle = mrsim::atan2(x * path.v.x + y * path.v.y, x * path.u.x + y * path.u.y);
  const double turn =
      std::round((std::clamp(s.place_at_height(p.z), 0.0, path.sweep) - angle) / kTwoPi);
  const double sine2 = 1 - cosine * cosine;
  return {angle + kTwoPi * turn, sine2 > 0 ? mrsim::atan2(std::sqrt(sine2), cosine) : 0};
}

// Beside the path the floor goes on as a plane from the edge of its strip, `t` being the place of
// the path that is nearest to p in plan.
std::optional<FacePlane> floor_beside(const ShearedCylinder& s, double t, const Vec3& p) {
  const PathPoint at = s.at(t);
  const Vec3 way{at.direction.x, at.direction.y, 0};
  const Vec3 off{p.x - at.position.x, p.y - at.position.y, 0};
  const double beside = length(off), slope = s.rise / s.plan;
  if (!(beside > s.corner.at.x)) return std::nullopt;
  const double up = -s.corner.side * std::abs(slope);  // away from the path
  const Vec3 gradient = slope / s.plan * way + up / beside * off;
  const Vec3 normal = normalized(s.corner.side * (Vec3{0, 0, 1} - gradient));
  const double height = at.position.z + s.corner.at.y + up * (beside - s.corner.at.x);
  return FacePlane{normal, normal.z * (p.z - height)};
}

// Where the surface is flat its height over the plan tells the distance: the circle at p's height
// may be on the other side of the path, as the upper half of a cylinder of a slight slope lies some
// micrometres above the lower one, and Newton's method would jump between them.
std::optional<FacePlane> floor_plane(const ShearedCylinder& s, const Vec3& p) {
  if (s.corner.side == 0) return std::nullopt;
  const auto [middle, half] = s.is_line() ? passing_line(s, p) : passing_helix(s, p);
  std::optional<FacePlane> floor;
  if (half > 0) {
    const PathPoint at = s.at(s.corner.side * s.rise > 0 ? middle + half : middle - half);
    if (const std::optional<Vec3> normal = normal_at(s, at, p))
      floor = FacePlane{*normal, normal->z * (p.z - at.position.z - s.corner.at.y)};
  } else {
    floor = floor_beside(s, middle, p);
  }
  return floor && std::abs(floor->normal.z) > kFlat ? floor : std::nullopt;
}

}  // namespace

std::optional<FacePlane> sheared_cylinder(const PathColumn& paths, std::size_t row,
                                          const CornerCircle& corner, const Vec3& p) {
  const std::optional<ShearedCylinder> s = cylinder_of(paths, row, corner);
  if (!s) return std::nullopt;
  if (const auto floor = floor_plane(*s, p)) return floor;
  const PathPoint at = s->at(s->place_at_height(p.z));
  const std::optional<Vec3> normal = normal_at(*s, at, p);
  if (!normal) return std::nullopt;
  const double x = p.x - at.position.x, y = p.y - at.position.y;
  const double scale = std::sqrt(normal->x * normal->x + normal->y * normal->y);
  return FacePlane{*normal, scale * (std::sqrt(x * x + y * y) - corner.at.x)};
}

}  // namespace mrsim
