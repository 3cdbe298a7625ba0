// Bounds of triangles with a side on a crease hold.
#include "core/units.h"
#include "core/vec.h"
#include "mesh/contour_certify.h"
#include "support/analytic_field.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

// Two slots whose walls turn by 5 degrees, and a triangle over both with a side in the plane of the
// block's top: d = 0 all along it, and yet it is off the walls by its sagitta.
TEST(Certify, SideOnACreaseIsMeasuredFromTheCrease) {
  constexpr double kTop = 10, kLength = 1, kRadius = 1;
  const double turn = radians(5), sagitta = kLength * std::sin(turn / 2);
  const Vec2 bend{10, 10}, along{std::cos(turn), std::sin(turn)};
  const AnalyticField part(
      {{0, 0, 0}, {20, 20, kTop}}, false,
      {flat_line({2, 10}, bend, kRadius, 5), flat_line(bend, bend + 8 * along, kRadius, 5)});
  const detail::ContourOctree tree(part, detail::Lattice(part.bounds(), 0.5, 4), 0.1, 1);
  const Vec3 edge{bend.x - kRadius * std::tan(turn / 2), bend.y + kRadius, kTop};
  const Vec3 a = edge - Vec3{kLength, 0, 0}, b = edge + kLength * Vec3{along.x, along.y, 0};
  for (const double height : {0.3, 1.0, 3.0}) {
    const Vec3 c = edge - Vec3{0, 0, height};
    const double bound = detail::part_bound(part, tree, b, a, c, 0.1);
    EXPECT_GE(bound, 0.999 * sagitta) << height;
    EXPECT_LE(bound, 2 * sagitta) << height;
    EXPECT_GT(detail::part_bound(part, tree, b, a, c, 0.9 * sagitta), 0.9 * sagitta) << height;
  }
}

}  // namespace
}  // namespace mrsim
