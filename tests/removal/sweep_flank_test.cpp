// Tools with a conical flank on helices and on arcs in upright planes against brute force.
#include "removal/forms/cone_helix.h"
#include "removal/forms/flank_sweep.h"
#include "removal/forms/upright_sweep.h"
#include "sweep_support.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

Tool taper(double d, double ball, double degrees) {
  Tool t = mill(ToolType::taper, d, ball);
  t.tip_diameter = 2 * ball;
  t.taper_angle = radians(degrees);
  return t;
}

Tool any_tool(Random& r) {
  const double d = r(2, 12);
  switch (r.pick(5)) {
    case 0:
      return mill(ToolType::chamfer, d);  // a point
    case 1:
      return mill(ToolType::drill, d);
    case 2: {
      Tool t = mill(ToolType::chamfer, d);
      t.tip_diameter = r(0.01, 0.8) * d;
      return t;
    }
    case 3: {  // bull-nose
      Tool t = taper(d, r(0.05, 0.2) * d, r(1, 30));
      t.tip_diameter = r(0.45, 0.7) * d;
      return t;
    }
    default:
      return taper(d, r(0.05, 0.4) * d, r(1, 30));
  }
}

ToolPath flanked(const Motion& m) {
  ToolPath path = path_of(m);
  path.flanked = true;
  set_upright_plane(path);
  return path;
}

double at_rest(const Profile& tool, const Vec3& q) {
  return tool.distance({std::hypot(q.x, q.y), q.z});
}

TEST(Flanks, EqualTheLeastDistanceOverAllPositions) {
  Random r(21);
  int found = 0, asked = 0, round_tips = 0, found_round = 0;
  for (int round = 0; round < 800; ++round) {
    const Motion m = upright_arc(r);
    const Tool tool = any_tool(r);
    const Profile cutter = make_cutter(tool).extended_up();
    if (!has_flank(cutter)) continue;  // a nose without a flank
    const ToolPath path = flanked(m);
    const bool sharp = tool.tip_diameter == 2 * tool.corner_radius;
    for (int k = 0; k < 12; ++k) {
      const Vec3 p = point_near(r, m, 0.7 * tool.diameter + 2);
      const auto got = flank_minimum(cutter, path, p, 0, path.sweep);
      ++asked, round_tips += sharp;
      if (!got) continue;
      ++found, found_round += sharp;
      const double want = least([&](double t) { return at_rest(cutter, p - at(m, t)); }, 600);
      ASSERT_NEAR(got->distance, want, 1e-9) << "round " << round << " point " << k;
      ASSERT_TRUE(got->t >= 0 && got->t <= path.sweep);
      EXPECT_NEAR(at_rest(cutter, p - path_point(path, got->t).position), want, 1e-9);
      EXPECT_EQ(flank_value(cutter, path, p), got->distance);
    }
  }
  EXPECT_GT(asked, 8000);
  EXPECT_GT(found, asked / 2);
  EXPECT_GT(found_round, 2 * round_tips / 3);
}

// Falling, rising and level, whole and in part, with the axis and places far from it.
TEST(Flanks, OnHelicesEqualTheLeastDistanceOverAllPositions) {
  Random r(22);
  int found = 0, asked = 0;
  for (int round = 0; round < 600; ++round) {
    const Vec3 start{r(-5, 5), r(-5, 5), r(-2, 2)}, center{r(-5, 5), r(-5, 5), start.z};
    const double turn = (r.pick(2) ? 1 : -1) * (r.pick(4) == 0 ? kTwoPi : r(0.1, 6.2));
    const Motion m = arc(start, center, {0, 0, 1}, turn);
    const Profile cutter = make_cutter(any_tool(r));
    if (!cutter.is_convex()) continue;
    ToolPath path = path_of(m);
    path.horizontal = true;
    path.rise = {0, 0, r.pick(3) == 0 ? 0 : r(-1.5, 1.5)};
    path.last = {std::cos(path.sweep), std::sin(path.sweep)};
    const bool whole = r.pick(2) != 0;
    const double begin = whole ? 0 : r(0, 0.6) * path.sweep,
                 end = whole ? path.sweep : r(begin, path.sweep);
    for (int k = 0; k < 12; ++k) {
      const Vec3 at = path_point(path, r(0, path.sweep)).position;
      Vec3 p = at + Vec3{r(-5, 5), r(-5, 5), r(-3, 6)};
      if (k == 0) p = path.center + Vec3{0, 0, r(-1, 4)};
      const auto got = ConeHelix(path, p, begin, end).minimum(cutter);
      ++asked;
      if (!got.is_exact) continue;
      ++found;
      const auto distance = [&](double t) {
        return at_rest(cutter, p - path_point(path, t).position);
      };
      const double want = least([&](double s) { return distance(begin + s * (end - begin)); }, 300);
      ASSERT_NEAR(got.least.distance, want, 1e-9) << "round " << round << " point " << k;
      ASSERT_TRUE(got.least.t >= begin && got.least.t <= end);
      EXPECT_NEAR(distance(got.least.t), got.least.distance, 1e-11);
    }
  }
  EXPECT_GT(asked, 5000);
  EXPECT_GT(found, asked / 2);
}

}  // namespace
}  // namespace mrsim
