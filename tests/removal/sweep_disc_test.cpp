// Closed cutters on helices against brute force.
#include "removal/forms/disc_sweep.h"
#include "sweep_support.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

Tool any_disc(Random& r) {
  const double d = r(1, 10);
  if (r.pick(2) == 0) return endmill(d, r.pick(2) * r(0, 0.5) * d, r(1.1, 2) * d);
  Tool t = mill(ToolType::tslot, d, 0, r(0.05, 0.9) * d);
  t.corner_radius = r.pick(2) * r(0, 0.5) * t.flute_length;
  t.neck_diameter = 0.2 * d;
  return t;
}

// Pitches from less than the tool's height to more than its diameter.
Motion any_helix(Random& r) {
  const double radius = r(0.1, 6), from = r(0, kTwoPi), turns = r(0.05, 8);
  const Vec3 center = {r(-3, 3), r(-3, 3), r(-3, 3)};
  const Vec3 start = center + radius * Vec3{std::cos(from), std::sin(from), 0};
  const double rise = (r.pick(2) ? 1 : -1) * turns * r(0.05, 5);
  return arc(start, center, {0, 0, 1}, (r.pick(2) ? 1 : -1) * turns * kTwoPi, rise);
}

TEST(Discs, EqualTheLeastDistanceOverAllPositions) {
  Random r(23);
  for (int round = 0; round < 120; ++round) {
    const Motion m = any_helix(r);
    const Tool tool = any_disc(r);
    const Profile cutter = make_cutter(tool);
    ASSERT_TRUE(cutter.disc());
    const SweepTable s({&m, 1}, {&tool, 1});
    EXPECT_LT(s.max_error(), 1e-9);
    for (int k = 0; k < 12; ++k) {
      Vec3 p = point_near(r, m, 1.2 * tool.diameter + 1);
      if (k % 3 == 0) p.z = at(m, r(0, 1)).z + r(-0.2, 1.2) * cutter.top();
      const double want = least(
          [&](double t) {
            const Vec3 q = p - at(m, t);
            return cutter.distance({std::hypot(q.x, q.y), q.z});
          },
          1500);
      ASSERT_NEAR(s.distance(0, p), want, 1e-9) << "round " << round << " point " << k;
    }
  }
}

// The place is where the distance is, and the quarter turns of a path share its least distance.
TEST(Discs, PlacesAndPiecesAgree) {
  Random r(24);
  for (int round = 0; round < 200; ++round) {
    const Motion m = any_helix(r);
    const Profile cutter = make_cutter(any_disc(r));
    ToolPath path = path_of(m);
    path.horizontal = true, path.rise = {0, 0, m.rise / path.sweep};
    path.disc = is_disc_helix(cutter, path);
    ASSERT_TRUE(path.disc);
    for (int k = 0; k < 10; ++k) {
      const Vec3 p = point_near(r, m, 6);
      const PathSample whole = path_distance(cutter, path, p);
      EXPECT_EQ(path_value(cutter, path, p), whole.distance);
      ASSERT_TRUE(whole.t >= 0 && whole.t <= path.sweep);
      const Vec3 q = p - path_point(path, whole.t).position;
      EXPECT_NEAR(cutter.distance({std::hypot(q.x, q.y), q.z}), whole.distance, 1e-9);
      double best = 1e300;
      for (int branch = 0; branch * (kPi / 2) < path.sweep; ++branch)
        best = std::min(best, branch_distance(cutter, path, p, branch).distance);
      EXPECT_NEAR(best, whole.distance, 1e-9);
      EXPECT_NEAR(branch_distance(cutter, path, p, path_branch(path, whole.t)).distance,
                  whole.distance, 1e-9);
    }
  }
}

// A path of whole quarter turns has a last branch of one position, where the cutter stands still.
TEST(Discs, BranchesOfOnePositionAreTheCutter) {
  Random r(25);
  for (int round = 0; round < 100; ++round) {
    Motion m = any_helix(r);
    const Profile cutter = make_cutter(any_disc(r));
    ToolPath path = path_of(m);
    path.horizontal = true, path.sweep = 4 * (kPi / 2), path.rise = {0, 0, m.rise / path.sweep};
    path.disc = true;
    for (int k = 0; k < 10; ++k) {
      const Vec3 end = path_point(path, path.sweep).position;
      const Vec3 q{r(-6, 6), r(-6, 6), r(-1, 2) * cutter.top()};
      EXPECT_NEAR(branch_distance(cutter, path, end + q, 4).distance,
                  cutter.distance({std::hypot(q.x, q.y), q.z}), 1e-9);
    }
  }
}

}  // namespace
}  // namespace mrsim
