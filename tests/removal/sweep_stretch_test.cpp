// Flat, bull-nose and ball mills on helices and on arcs in upright planes against brute force.
#include "core/numbers/units.h"
#include "removal/forms/path_sweep.h"
#include "removal/forms/slant_sweep.h"
#include "removal/forms/upright_sweep.h"
#include "removal/simd/sweep_kernels.h"
#include "support/rounds.h"
#include "sweep_support.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

Motion helix(Random& r) {
  const double radius = r(0.1, 6), from = r(0, kTwoPi);
  const Vec3 center = {r(-3, 3), r(-3, 3), r(-3, 3)};
  const Vec3 start = center + radius * Vec3{std::cos(from), std::sin(from), 0};
  return arc(start, center, {0, 0, 1}, r(-20, 20), r.pick(3) == 0 ? r(-60, 60) : r(-6, 6));
}

// Flat ones, and such that hardly move in plan.
Motion slanted_move(Random& r) {
  const double flat = r.pick(4) == 0 ? 1e-6 : r.pick(4) == 0 ? 1e-3 : 1;
  const double steep = flat == 1 && r.pick(4) == 0 ? 1e-5 : 1;
  const Vec3 start{r(-3, 3), r(-3, 3), r(-3, 3)};
  return line(start, start + Vec3{flat * r(-5, 5), flat * r(-5, 5), steep * r(-5, 5)});
}

double slant_bound(const SlantRecord& line, const Vec3& p) {
  const std::uint32_t row = 0;
  double out[PointColumns::kPad];
  sweep_kernels().slant_bounds(&line, &row, 1, p, out);
  return out[0];
}

class Stretches : public ::testing::TestWithParam<double> {};  // corner radius / radius

TEST_P(Stretches, EqualTheLeastDistanceOverAllPositions) {
  Random r(17);
  double worst = 0;
  for (unsigned round = 0; round < rounds(600); ++round) {
    const bool turning = round % 3 == 0, slanted = round % 3 == 1;
    const Motion m = turning ? helix(r) : slanted ? slanted_move(r) : upright_arc(r);
    const double radius = r(0.3, 6), corner = GetParam() * radius;
    const Tool tool = endmill(2 * radius, corner);
    const SweepTable s({&m, 1}, {&tool, 1});
    ASSERT_EQ(s.size(), 1u);
    EXPECT_LT(s.max_error(), 1e-9);
    for (int k = 0; k < 12; ++k) {
      const Vec3 p = point_near(r, m, 1.5 * radius + 2);
      const double want =
          least([&](double t) { return mill_at_rest(radius, corner, p - at(m, t)); }, 600);
      const double got = s.distance(0, p);
      // A ball on an upright arc has its depth in closed form, which is larger.
      if (corner == radius && !turning && !slanted && want < 0) {
        EXPECT_LE(got, want + 1e-9);
        continue;
      }
      worst = std::max(worst, std::fabs(got - want));
      EXPECT_NEAR(got, want, 1e-9) << "round " << round << " point " << k;
    }
  }
  RecordProperty("worst", std::to_string(worst));
}

INSTANTIATE_TEST_SUITE_P(FlatBullBall, Stretches, ::testing::Values(0.0, 0.3, 1.0));

// Beside the line and under its lower end the bound is the distance of a flat mill itself.
TEST(Slants, BoundIsNotAboveTheDistance) {
  Random r(19);
  for (int round = 0; round < 300; ++round) {
    const Motion m = slanted_move(r);
    const double radius = r(0.3, 6);
    const Profile mill = make_cutter(endmill(2 * radius, r(0, 1) * radius));
    ToolPath path;
    path.start = m.start, path.travel = m.end - m.start;
    const SlantRecord line = slant_record(mill, path);
    for (int k = 0; k < 20; ++k) {
      const Vec3 p = point_near(r, m, 1.5 * radius + 2);
      ASSERT_LE(slant_bound(line, p), slant_minimum(line, p).distance + 1e-9);
    }
  }
  const Profile flat = make_cutter(endmill(4));
  ToolPath path;
  path.travel = {10, 0, 5};
  const SlantRecord line = slant_record(flat, path);
  EXPECT_NEAR(slant_bound(line, {5, 7, 9}), 5, 1e-12);
  EXPECT_NEAR(slant_bound(line, {0, 1, -3}), 3, 1e-12);
}

// The place is where the distance is, and the pieces of a path share its least distance.
TEST(Stretches, PlacesAndPiecesAgree) {
  Random r(18);
  for (int round = 0; round < 300; ++round) {
    const Motion m = upright_arc(r);
    const Tool tool = endmill(r(1, 8), 0);
    const Profile mill = make_cutter(tool);
    ToolPath path = path_of(m);
    path.upright = true;
    set_upright_plane(path);
    for (int k = 0; k < 10; ++k) {
      const Vec3 p = point_near(r, m, 6);
      const PathSample whole = path_distance(mill, path, p);
      EXPECT_EQ(path_value(mill, path, p), whole.distance);
      ASSERT_TRUE(whole.t >= 0 && whole.t <= path.sweep);
      const Vec3 q = p - path_point(path, whole.t).position;
      EXPECT_NEAR(mill.distance({std::hypot(q.x, q.y), q.z}), whole.distance, 1e-9);
      double best = 1e300;
      for (int branch = 0; branch < path.quarters; ++branch)
        best = std::min(best, branch_distance(mill, path, p, branch).distance);
      EXPECT_EQ(best, whole.distance);
      EXPECT_NEAR(branch_distance(mill, path, p, path_branch(path, whole.t)).distance,
                  whole.distance, 1e-9);
    }
  }
}

}  // namespace
}  // namespace mrsim
