// Every tool on every move against brute force; gradients, Lipschitz constant, patches, bounds.
#include "core/numbers/units.h"
#include "removal/columns/sweep_columns.h"
#include "removal/forms/path_sweep.h"
#include "sweep_support.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

std::vector<Tool> all_tools() {
  std::vector<Tool> t = {endmill(6),       endmill(6, 1),    ballmill(6),
                         endmill(6, 0, 9), endmill(6, 1, 9), ballmill(6, 9)};
  t.push_back(mill(ToolType::chamfer, 8));
  t.back().tip_diameter = 1;
  t.push_back(mill(ToolType::chamfer, 8, 0, 3));
  t.push_back(mill(ToolType::drill, 5));
  t.push_back(mill(ToolType::drill, 5, 0, 12));
  t.push_back(mill(ToolType::taper, 9));
  t.back().taper_angle = radians(10);
  t.back().tip_diameter = 4;
  t.back().corner_radius = 2;
  t.push_back(mill(ToolType::taper, 4, 0, 14));
  t.back().taper_angle = radians(10);
  t.back().corner_radius = 0.5;
  t.push_back(mill(ToolType::tslot, 10, 0, 3));
  t.back().neck_diameter = 4;
  t.push_back(mill(ToolType::tslot, 10, 0, 3));
  t.back().corner_radius = 0.5;
  t.push_back(mill(ToolType::lollipop, 6));
  t.back().neck_diameter = 3;
  t.push_back(mill(ToolType::barrel, 8));
  t.back().profile_radius = 30;
  t.back().corner_radius = 2;
  t.push_back(mill(ToolType::barrel, 8, 0, 16));
  t.back().profile_radius = 30;
  t.back().corner_radius = 2;
  t.push_back(mill(ToolType::form, 0));
  t.back().profile = {{0, 0, 0}, {2, 0, 0}, {5, 3, 0}};  // chamfer as a form, open
  return t;
}

std::vector<Tool> form_tools() {
  std::vector<Tool> t(4, mill(ToolType::form, 0));
  const double quarter = std::tan(kPi / 8);
  t[0].profile = {{0, 0, 0}, {2, 0, 0}, {2, 1, -quarter}, {5, 4, 0}, {5, 6, 0}};  // corner rounding
  t[0].flute_length = 6;
  t[1].profile = {{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 3, 0}, {2, 5, 0}, {3.5, 6, 0}, {0, 6, 0}};
  t[2] = thread_mill(2, 2.9);
  t[3] = thread_mill(2, 2.9);  // with rounded roots
  for (ProfilePoint& p : t[3].profile)
    if (std::fmod(p.z, 1.5) > 1.3 && p.z < 11) p.bulge = -0.3;
  return t;
}

double brute(const Profile& tool, const Motion& m, const Vec3& p) {
  return least(
      [&](double t) {
        const Vec3 q = p - at(m, t);
        return tool.distance({std::hypot(q.x, q.y), q.z});
      },
      1000);
}

Vec3 near(Random& r, const Motion& m, double reach) {
  const Vec3 c = at(m, r(0, 1));
  return c + Vec3{r(-reach, reach), r(-reach, reach), r(-reach, 2 * reach)};
}

// The sign and, outside, the value are exact; inside any depth between the deepest single position
// and the true one is allowed (closed forms give the true one); of a union of convex pieces any
// depth.
void expect_equals_brute(const Tool& tool, int kind, int rounds, double tolerance) {
  Random r(100 + kind);
  const Profile profile = make_cutter(tool);
  for (int round = 0; round < rounds; ++round) {
    const Motion m = move_of_kind(r, kind);
    const SweepTable s({&m, 1}, {&tool, 1});
    ASSERT_EQ(s.size(), 1u);
    for (int k = 0; k < 8; ++k) {
      const Vec3 p = near(r, m, 8);
      const double want = brute(profile, m, p), got = s.distance(0, p);
      if (want > 0) {
        ASSERT_NEAR(got, want, tolerance) << "move " << kind << " round " << round;
      } else {
        const double most = profile.convex_pieces().empty() ? want : 0;
        ASSERT_LE(got, most + tolerance) << "move " << kind << " round " << round;
      }
      if (got < -1e-9) {
        const Box3 b = s.bounds(0);
        ASSERT_TRUE(p.x > b.lo.x - 1e-9 && p.y > b.lo.y - 1e-9 && p.z > b.lo.z - 1e-9 &&
                    p.x < b.hi.x + 1e-9 && p.y < b.hi.y + 1e-9 && p.z < b.hi.z + 1e-9);
      }
    }
  }
}

class EveryTool : public ::testing::TestWithParam<int> {};

TEST_P(EveryTool, EqualsTheLeastDistanceOverAllPositions) {
  for (int kind = 0; kind < 7; ++kind) expect_equals_brute(all_tools()[GetParam()], kind, 6, 1e-6);
}

TEST_P(EveryTool, IsOneLipschitz) {
  const Tool tool = all_tools()[GetParam()];
  for (int kind = 0; kind < 7; ++kind) {
    Random r(50 + kind);
    for (int round = 0; round < 5; ++round) {
      const Motion m = move_of_kind(r, kind);
      const SweepTable s({&m, 1}, {&tool, 1});
      for (int k = 0; k < 60; ++k) {
        const Vec3 p = near(r, m, 6), q = p + Vec3{r(-1, 1), r(-1, 1), r(-1, 1)};
        ASSERT_LE(std::fabs(s.distance(0, p) - s.distance(0, q)),
                  distance(p, q) + 2 * s.max_error())
            << "move " << kind;
      }
    }
  }
}

// Walks to the surface from outside along the gradient, then compares with differences there.
TEST_P(EveryTool, GradientIsTheDerivative) {
  const Tool tool = all_tools()[GetParam()];
  int creases = 0, points = 0;
  for (int kind = 0; kind < 7; ++kind) {
    Random r(70 + kind);
    for (int round = 0; round < 6; ++round) {
      const Motion m = move_of_kind(r, kind);
      const SweepTable s({&m, 1}, {&tool, 1});
      for (int k = 0; k < 6; ++k) {
        Vec3 p = near(r, m, 5);
        for (int step = 0; step < 40; ++step)
          p = p - s.distance(0, p) * s.gradient(0, p, s.sample(0, p).patch);
        if (std::fabs(s.distance(0, p)) > 1e-9) continue;
        const Vec3 g = s.gradient(0, p, s.sample(0, p).patch);
        ASSERT_NEAR(length(g), 1, 1e-9);
        const Vec3 n = numeric_gradient(s, 0, p);
        ++points;
        if (length(n) < 0.999) {  // on a crease
          ++creases;
          continue;
        }
        EXPECT_NEAR(distance(g, n), 0, 2e-3) << "move " << kind << " round " << round;
      }
    }
  }
  EXPECT_GT(points, 60);
  EXPECT_LT(creases, points / 2);
}

// Beside the end of a slanted move the tool at rest decides, with its own faces.
TEST(SweepTools, TheTipAtTheEndOfAMoveIsItsOwnFace) {
  for (const Tool& tool : {endmill(6, 1, 9), all_tools()[10]}) {
    const Motion rising = line({6.4078417894596846, -7.430406562767331, 0.4207116645649176},
                               {7.9547266833132682, -6.3087628956490649, 3.4752383569632919});
    Motion falling = rising;
    std::swap(falling.start, falling.end);
    for (const Motion& m : {rising, falling}) {
      const SweepTable s({&m, 1}, {&tool, 1});
      // Ahead of the upper end; its share of the way is 1 but for rounding.
      const Vec3 p{10.043701775378537, -4.2218370735912394, 4.1711219252503724};
      EXPECT_LT(s.sample(0, p).patch, kCornerPatch);
      const Vec3 g = s.gradient(0, p, s.sample(0, p).patch);
      EXPECT_NEAR(distance(g, numeric_gradient(s, 0, p)), 0, 1e-6);
    }
  }
}

// Where no more is asked than what lies below the end of the flutes, a tool without end has the
// same distances outside of what it sweeps, and the same inside.
TEST_P(EveryTool, FlutesThatEndAboveAllThatIsAskedHaveNoEnd) {
  const Tool tool = all_tools()[GetParam()];
  const double top = make_cutter(tool).top();
  if (std::isinf(top)) return;
  for (int kind = 0; kind < 7; ++kind) {
    Random r(90 + kind);
    for (int round = 0; round < 12; ++round) {
      const Motion m = move_of_kind(r, kind);
      double lowest = 1e9;
      for (int k = 0; k <= 1000; ++k) lowest = std::min(lowest, at(m, k / 1000.0).z);
      const double asked = lowest + top + r(-0.5, -0.01);
      const SweepTable finite({&m, 1}, {&tool, 1}), without({&m, 1}, {&tool, 1}, {.top = asked});
      for (int k = 0; k < 20; ++k) {
        Vec3 p = near(r, m, 6);
        p.z = std::min(p.z, asked);
        const double want = finite.distance(0, p), got = without.distance(0, p);
        if (want > 0)
          ASSERT_NEAR(got, want, 2 * kPathError) << "move " << kind;
        else
          ASSERT_LE(got, want + 2 * kPathError) << "move " << kind;
      }
    }
  }
}

TEST(Flutes, LetThroughWhatTheyDoNotReach) {
  const Tool tool = endmill(6, 0, 4);
  const Motion m = line({0, 0, -5}, {10, 0, -5});
  const auto reaches_up = [&](double top) {
    const SweepTable s({&m, 1}, {&tool, 1}, {.top = top});
    return std::isinf(s.bounds(0).hi.z);
  };
  EXPECT_TRUE(reaches_up(-1));
  EXPECT_FALSE(reaches_up(-0.9));
  EXPECT_FALSE(reaches_up(std::numeric_limits<double>::infinity()));
}

INSTANTIATE_TEST_SUITE_P(All, EveryTool, ::testing::Range(0, static_cast<int>(all_tools().size())));

// A groove of 90 degrees: its flanks are planes, or cones about an arc's axis.
TEST(Grooves, FlanksOfASharpTipAreFacesOfTheirOwn) {
  Tool vee = mill(ToolType::chamfer, 8);
  vee.tip_angle = kPi / 2;
  const Motion moves[] = {line({0, 0, 0}, {20, 0, 0}), line({0, 0, 0}, {20, 0, 2}),
                          arc({10, 0, 0}, {0, 0, 0}, {0, 0, 1}, kPi)};
  const SweepTable table(moves, std::span(&vee, 1));
  const Vec3 left{10, 0.5, 1}, right{10, -0.5, 1};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::int32_t one = table.patch(i, left), other = table.patch(i, right);
    EXPECT_NE(one, other);
    EXPECT_LT(dot(table.gradient(i, left, one), table.gradient(i, right, other)), 0.1);
    // A flank seen from beyond the bottom is the same plane.
    EXPECT_NEAR(
        table.patch_distance(i, right, one),
        table.patch_distance(i, left, one) + dot(table.gradient(i, left, one), right - left), 1e-9);
    EXPECT_EQ(table.gradient(i, right, one), table.gradient(i, left, one));
  }
  EXPECT_NEAR(table.patch_distance(0, right, table.patch(0, left)), -1.5 * std::sqrt(0.5), 1e-9);
  const Vec3 within{0, 9.5, 1}, without{0, 10.5, 1};
  const std::int32_t inner = table.patch(2, within), outer = table.patch(2, without);
  EXPECT_NE(inner, outer);
  EXPECT_NEAR(table.patch_distance(2, without, inner), -1.5 * std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(table.patch_distance(2, within, outer), -1.5 * std::sqrt(0.5), 1e-9);
}

// A ball's and a flat mill's floors have no crease along the path.
TEST(Grooves, AreLeftBySharpTipsAlone) {
  for (const Tool& tool : {ballmill(6), endmill(6), endmill(6, 1)}) {
    const Motion move = line({0, 0, 0}, {20, 0, 2});
    const SweepTable table(std::span(&move, 1), std::span(&tool, 1));
    EXPECT_EQ(table.patch(0, {10, 0.5, 0.9}), table.patch(0, {10, -0.5, 0.9}));
  }
}

TEST(FormTool, EqualsTheLeastDistanceOverAllPositions) {
  for (const Tool& tool : form_tools())
    for (int kind = 0; kind < 7; ++kind) expect_equals_brute(tool, kind, 6, 1e-6);
}

// Between the convex pieces of a tool and a concave arc of it lie places that no piece is near.
TEST(SweepTools, ALimitChangesNoDistanceBelowIt) {
  std::vector<Tool> tools = all_tools();
  const std::vector<Tool> forms = form_tools();
  tools.insert(tools.end(), forms.begin(), forms.end());
  for (const Tool& tool : tools)
    for (int kind = 0; kind < 7; ++kind) {
      Random r(300 + kind);
      for (int round = 0; round < 6; ++round) {
        const Motion m = move_of_kind(r, kind);
        const SweepTable s({&m, 1}, {&tool, 1});
        for (int k = 0; k < 20; ++k) {
          const Vec3 p = near(r, m, 5);
          const double distance = s.distance(0, p);
          for (const double more : {1e-3, 0.1, 1.0})
            ASSERT_EQ(s.columns().distance(0, p, distance + more), distance) << "move " << kind;
          ASSERT_GT(s.columns().distance(0, p, distance - 0.1), distance - 0.1);
        }
      }
    }
}

}  // namespace
}  // namespace mrsim
