// Bottoms by branch and bound: against the closed ones of convex tools, against dense samples of
// the path, and bounds against bottoms.
#include "removal/sweep/rising_heights.h"

#include "core/numbers/units.h"
#include "removal/sweep/arc_heights.h"
#include "sweep_support.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

// Corner rounding, one of two steps with a fillet, a cone that flattens.
std::vector<Underside> hollow_tools() {
  const double quarter = std::tan(kPi / 8);
  std::vector<Underside> out;
  for (const std::vector<ProfilePoint>& profile :
       {std::vector<ProfilePoint>{{0, 0, 0}, {1.6, 0, 0}, {1.6, 0.5, -quarter}, {3.6, 2.5, 0}},
        {{0, 0, 0}, {1, 0, quarter}, {2, 1, 0}, {2, 3, 0}, {2.5, 3, 0}, {4, 4, 0}},
        {{0, 0, 0}, {1, 3, 0}, {3, 4, 0}, {3.5, 4, 0}}}) {
    Tool tool = mill(ToolType::form, 0);
    tool.profile = profile;
    out.emplace_back(make_cutter(tool));
  }
  return out;
}

std::vector<Underside> convex_tools() {
  std::vector<Underside> out;
  for (const Tool& tool : {endmill(6), endmill(6, 1), ballmill(6), mill(ToolType::drill, 5)})
    out.emplace_back(make_cutter(tool));
  return out;
}

ToolPath some_helix(Random& r) {
  const double radii[] = {r(0.001, 0.1), r(0.1, 1), r(1, 6), r(6, 30)};
  const double sweeps[] = {kTwoPi, r(0.1, 3), r(3, 9), r(9, 20)};
  const double turned = r(0, kTwoPi), way = r.pick(2) == 0 ? 1 : -1;
  ToolPath path{.arc = true, .radius = radii[r.pick(4)], .horizontal = true};
  path.sweep = sweeps[r.pick(4)];
  path.u = path.radius * Vec3{std::cos(turned), std::sin(turned), 0};
  path.v = way * path.radius * Vec3{-std::sin(turned), std::cos(turned), 0};
  path.rise = {0, 0, r.pick(5) == 0 ? 0 : std::pow(10.0, r(-3, 1)) * r(-1, 1)};
  return path;
}

Vec2 place_beside(Random& r, const ToolPath& helix) {
  const double angle = r(0, kTwoPi), from = std::max(0.0, helix.radius + r(-4, 4));
  return {from * std::cos(angle), from * std::sin(angle)};
}

Underside::Slant some_slant(Random& r) {
  const double length = r(0, 12);
  return {r(-4, length + 4), r.pick(4) == 0 ? 0 : r(0, 4), length,
          r.pick(5) == 0 ? 0 : std::pow(10.0, r(-2, 2))};
}

void expect_near(double found, double expected, double error) {
  ASSERT_EQ(std::isinf(found), std::isinf(expected));
  if (std::isfinite(expected)) {
    ASSERT_NEAR(found, expected, error);
  }
}

TEST(RisingHeights, AreTheClosedOnesOfConvexTools) {
  for (const Underside& tool : convex_tools()) {
    Random r(1);
    for (int round = 0; round < 2000; ++round) {
      const Underside::Slant at = some_slant(r);
      expect_near(rising_bottom(tool, at, kInfinity), tool.bottom(at), 1e-8 * (1 + at.slope));
      const ToolPath helix = some_helix(r);
      const Vec2 p = place_beside(r, helix);
      expect_near(rising_bottom(tool, helix, p.x, p.y, kInfinity),
                  arc_bottom(tool, helix, p.x, p.y), 1e-8);
    }
  }
}

TEST(RisingHeights, AreTheLeastOfDenseSamples) {
  int met = 0;
  for (const Underside& tool : hollow_tools()) {
    ASSERT_FALSE(tool.is_convex());
    Random r(2);
    for (int round = 0; round < 60; ++round) {
      const ToolPath helix = some_helix(r);
      const Vec2 p = place_beside(r, helix);
      const double found = rising_bottom(tool, helix, p.x, p.y, kInfinity);
      const double sampled = least([&](double t) {
        const Vec3 tip = path_point(helix, t * helix.sweep).position;
        return std::min(tip.z + tool.height(std::hypot(p.x - tip.x, p.y - tip.y)), 1e6);
      });
      if (std::isinf(found)) {
        ASSERT_EQ(sampled, 1e6);
        continue;
      }
      ++met;
      ASSERT_LE(found, sampled + 1e-8) << "helix of " << helix.radius << ", " << helix.sweep;
      // Samples may miss the last places before a wall.
      const double fall = std::fabs(helix.rise.z) * helix.sweep;
      ASSERT_GE(found, sampled - fall / 4000 - 1e-8);
      const Underside::Slant at = some_slant(r);
      const double low = least([&](double t) {
        const double e = at.u - t * at.length;
        return std::min(at.slope * t * at.length + tool.height(std::hypot(e, at.v)), 1e6);
      });
      const double bottom = rising_bottom(tool, at, kInfinity);
      if (std::isinf(bottom)) continue;
      ASSERT_NEAR(bottom, low, 1e-6) << "slope " << at.slope;
    }
  }
  EXPECT_GT(met, 60);
}

TEST(RisingHeights, BoundsHoldOverACircle) {
  int finite = 0;
  for (const Underside& tool : hollow_tools()) {
    Random r(3);
    for (int round = 0; round < 1000; ++round) {
      const ToolPath helix = some_helix(r);
      const Vec2 p = place_beside(r, helix);
      const double wide = std::pow(10.0, r(-5, 0.5));
      const Underside::Bounds bounds = rising_bounds(tool, helix, p.x, p.y, wide, kInfinity);
      for (int k = 0; k < 6; ++k) {
        const double turn = r(0, kTwoPi), off = (1 - 1e-12) * wide;
        const double z = rising_bottom(tool, helix, p.x + off * std::cos(turn),
                                       p.y + off * std::sin(turn), kInfinity);
        finite += std::isfinite(z);
        ASSERT_LE(bounds.lower, z + 1e-8);
        ASSERT_GE(bounds.upper, z - 1e-8);
      }
    }
  }
  EXPECT_GT(finite, 3000);
}

// What is not below `below` need not be found; what is, is.
TEST(RisingHeights, AreFoundBelowAHeight) {
  for (const Underside& tool : hollow_tools()) {
    Random r(4);
    for (int round = 0; round < 1000; ++round) {
      const ToolPath helix = some_helix(r);
      const Vec2 p = place_beside(r, helix);
      const double z = rising_bottom(tool, helix, p.x, p.y, kInfinity);
      if (std::isinf(z)) continue;
      ASSERT_NEAR(rising_bottom(tool, helix, p.x, p.y, z + 0.1), z, 2e-9);
      ASSERT_GE(rising_bottom(tool, helix, p.x, p.y, z - 0.1), z - 0.1);
      const Underside::Bounds bounds = rising_bounds(tool, helix, p.x, p.y, 0.01, z - 0.1);
      ASSERT_LE(bounds.lower, z);
    }
  }
}

}  // namespace
}  // namespace mrsim
