// The distance from a tool as a function of its position on a path: its derivatives, and the search
// for its minimum.
#include "removal/forms/path_objective.h"

#include "removal/tool/tool.h"
#include "support/tools.h"
#include "sweep_support.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

Profile any_convex_tool(Random& r) {
  const double d = r(2, 12);
  switch (r.pick(4)) {
    case 0:
      return make_cutter(ballmill(d));
    case 1:
      return make_cutter(endmill(d, r(0, 0.4) * d));
    case 2:
      return make_cutter(mill(ToolType::drill, d)).extended_up();
    default: {  // a tooth with flanks on both sides
      Tool tooth = mill(ToolType::form, 0);
      tooth.profile = {{0, 0, 0}, {0.3 * d, 0, 0}, {0.5 * d, 1, 0}, {0.5 * d, 1.2, 0}};
      tooth.profile.push_back({0.3 * d, 2, 0});
      tooth.profile.push_back({0, 2, 0});
      return make_cutter(tooth);
    }
  }
}

ToolPath any_line(Random& r) {
  ToolPath path;
  path.travel = {r(-20, 20), r(-20, 20), r(-20, 20)};
  path.speed = length(path.travel);
  return path;
}

ToolPath any_helical_path(Random& r) {
  const Vec3 centre{r(-3, 3), r(-3, 3), r(-3, 3)};
  ToolPath path = path_of(arc(centre + Vec3{r(1, 10), r(-1, 1), 0}, centre, {0, 0, 1}, r(0.3, 7)));
  path.rise = {0, 0, r(-1, 1)};
  path.horizontal = true;
  path.last = {std::cos(path.sweep), std::sin(path.sweep)};
  return path;
}

// Where F has no kink within the step, differences tell its derivatives.
TEST(PathObjective, DerivativesAreThoseOfDifferences) {
  Random r(31);
  int compared = 0;
  for (int round = 0; round < 4000; ++round) {
    const ToolPath path = r.pick(3) == 0 ? any_line(r) : any_helical_path(r);
    const Profile tool = any_convex_tool(r);
    const double end = path.arc ? path.sweep : 1, t = r(0.1, 0.9) * end, h = 1e-4 * end;
    const Vec3 p = path_point(path, t).position + Vec3{r(-8, 8), r(-8, 8), r(-4, 6)};
    const PathObjective F(tool, path, p);
    const PathValue low = F(t - h), at = F(t), high = F(t + h);
    const double size = 1 + std::fabs(at.bend);
    if (std::fabs(low.bend - high.bend) > 0.01 * size) continue;  // a kink, or an edge's end
    ++compared;
    ASSERT_NEAR((high.f - low.f) / (2 * h), at.slope, 1e-5 * size) << round;
    ASSERT_NEAR((high.slope - low.slope) / (2 * h), at.bend, 0.01 * size) << round;
  }
  EXPECT_GT(compared, 3000);
}

// The bracket holds the least value of all positions, whatever the search begins with, and the
// tangents at its ends leave no room for less.
TEST(PathObjective, BracketsHoldTheLeastValue) {
  Random r(32);
  for (int round = 0; round < 1500; ++round) {
    const ToolPath path = any_line(r);
    const Profile tool = any_convex_tool(r);
    const Vec3 p = path_point(path, r(-0.2, 1.2)).position + Vec3{r(-8, 8), r(-8, 8), r(-4, 6)};
    const PathObjective F(tool, path, p);
    const double want = least([&](double t) { return F(t).f; }, 300);
    for (const double guess : {-1.0, 0.0, r(0, 1), 1.0, F.towards()})
      ASSERT_NEAR(descend(F, 0, 1, guess).distance, want, 1e-9) << round << " from " << guess;
    const double limit = want - r(0, 1);
    EXPECT_GE(descend(F, 0, 1, r(0, 1), limit).distance, want - 1e-12);
  }
}

Profile any_waisted_tool(Random& r) {
  const double d = r(3, 12), waist = r(0.2, 0.4) * d;
  Tool tool = mill(ToolType::form, 0);
  tool.profile = {{0, 0, 0}, {0.5 * d, 0.5, 0}, {waist, 2, 0}, {waist, 3, 0}, {0.5 * d, 5, 0}};
  tool.profile.push_back({0, 6, 0});
  return make_cutter(tool);
}

// A limit spares searches, but changes no distance below it by a bit.
TEST(PathSearch, FindsTheSameBitsBelowAnyLimit) {
  Random r(33);
  int spared = 0;
  for (int round = 0; round < 3000; ++round) {
    const ToolPath path = r.pick(4) == 0 ? any_line(r) : any_helical_path(r);
    const Profile tool = r.pick(3) == 0 ? any_waisted_tool(r) : any_convex_tool(r);
    const double end = path.arc ? path.sweep : 1;
    const Vec3 p = path_point(path, r(0, 1) * end).position + Vec3{r(-8, 8), r(-8, 8), r(-4, 6)};
    const PathSample want = search_path(tool, path, p, 0, end);
    const double above = want.distance + r(1e-6, 1), below = want.distance - r(1e-6, 3);
    const PathSample same = search_path(tool, path, p, 0, end, above);
    ASSERT_EQ(same.distance, want.distance) << round;
    ASSERT_EQ(same.t, want.t) << round;
    const double beyond = search_path(tool, path, p, 0, end, below).distance;
    ASSERT_GT(beyond, below) << round;
    spared += beyond != want.distance;
  }
  EXPECT_GT(spared, 500);
}

}  // namespace
}  // namespace mrsim
