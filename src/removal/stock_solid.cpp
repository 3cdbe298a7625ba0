#include "removal/stock_solid.h"

#include "core/error.h"
#include "core/units.h"
#include "core/vec.h"

#include <algorithm>

namespace mrsim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

StockSolid::StockSolid(StockShape shape) : shape_(std::move(shape)) {
  const Vec3 size = shape_.box.hi - shape_.box.lo;
  const bool round =
      shape_.kind == StockShape::Kind::cylinder || shape_.kind == StockShape::Kind::tube;
  if (!(size.x > 0 && size.y > 0 && size.z > 0) ||
      (round && !(shape_.outer_radius > shape_.inner_radius)))
    throw Error("stock-empty", "the stock has no volume: " + shape_.description);
  if (shape_.kind == StockShape::Kind::mesh)
    throw Error("stock-unsupported",
                "a stock mesh that is no box, cylinder or tube is not supported yet");
}

StockSolid::Sample StockSolid::sample(const Vec3& p) const {
  return shape_.kind == StockShape::Kind::box ? sample_box(p) : sample_round(p);
}

StockSolid::Sample StockSolid::sample_box(const Vec3& p) const {
  const Box3& b = shape_.box;
  // Signed distances of the six half spaces; of each opposite pair the larger one counts.
  const double face[6] = {b.lo.x - p.x, p.x - b.hi.x, b.lo.y - p.y,
                          p.y - b.hi.y, b.lo.z - p.z, p.z - b.hi.z};
  std::int32_t patch = 0;
  for (std::int32_t i = 1; i < 6; ++i)
    if (face[i] > face[patch]) patch = i;
  if (face[patch] <= 0) return {face[patch], patch};
  const double x = std::max({face[0], face[1], 0.0}), y = std::max({face[2], face[3], 0.0}),
               z = std::max({face[4], face[5], 0.0});
  return {std::sqrt(x * x + y * y + z * z), patch};
}

StockSolid::Sample StockSolid::sample_round(const Vec3& p) const {
  const double dx = p.x - shape_.axis_point.x, dy = p.y - shape_.axis_point.y;
  const double rho = std::sqrt(dx * dx + dy * dy);
  const bool tube = shape_.kind == StockShape::Kind::tube;
  const double wall = rho - shape_.outer_radius,
               bore = tube ? shape_.inner_radius - rho : -kInfinity;
  const double bottom = shape_.box.lo.z - p.z, top = p.z - shape_.box.hi.z;
  const double radial = std::max(wall, bore), axial = std::max(bottom, top);
  const std::int32_t patch = radial >= axial ? (wall >= bore ? kRoundWall : kRoundBore)
                                             : (bottom >= top ? kRoundBottom : kRoundTop);
  if (radial > 0 && axial > 0) return {std::sqrt(radial * radial + axial * axial), patch};
  return {std::max(radial, axial), patch};
}

Vec3 StockSolid::gradient(const Vec3& p, std::int32_t patch) const {
  if (shape_.kind == StockShape::Kind::box) {
    Vec3 normal;
    component(normal, patch / 2) = patch % 2 ? 1 : -1;
    return normal;
  }
  if (patch == kRoundBottom) return {0, 0, -1};
  if (patch == kRoundTop) return {0, 0, 1};
  const Vec3 radial{p.x - shape_.axis_point.x, p.y - shape_.axis_point.y, 0};
  const double rho = length(radial);
  const double sign = patch == kRoundBore ? -1 : 1;
  return rho > 0 ? (sign / rho) * radial : Vec3{sign, 0, 0};
}

double StockSolid::volume() const {
  const Vec3 size = shape_.box.hi - shape_.box.lo;
  if (shape_.kind == StockShape::Kind::box) return size.x * size.y * size.z;
  const double ro = shape_.outer_radius,
               ri = shape_.kind == StockShape::Kind::tube ? shape_.inner_radius : 0;
  return kPi * (ro * ro - ri * ri) * size.z;
}

double StockSolid::area() const {
  const Vec3 size = shape_.box.hi - shape_.box.lo;
  if (shape_.kind == StockShape::Kind::box)
    return 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
  const double ro = shape_.outer_radius,
               ri = shape_.kind == StockShape::Kind::tube ? shape_.inner_radius : 0;
  return kTwoPi * ((ro + ri) * size.z + ro * ro - ri * ri);
}

}  // namespace mrsim
