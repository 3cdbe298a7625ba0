// Straight moves of convex tools against the search over positions and against dense samples.
#include "removal/forms/chain_sweep.h"

#include "core/numbers/units.h"
#include "removal/simd/sweep_kernels.h"
#include "support/rounds.h"
#include "sweep_support.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

Tool with_angle(Tool tool, double lean, double tip = 0) {
  (tool.type == ToolType::taper ? tool.taper_angle : tool.tip_angle) = lean;
  tool.tip_diameter = tip;
  return tool;
}

std::vector<Tool> convex_tools() {
  std::vector<Tool> t = {
      with_angle(mill(ToolType::chamfer, 6), radians(60)),          // V
      with_angle(mill(ToolType::chamfer, 6, 0, 2), radians(90)),    // cut off on the cone
      with_angle(mill(ToolType::chamfer, 8, 0.4), radians(90), 2),  // torus between disc and cone
      with_angle(mill(ToolType::chamfer, 8, 0.4), radians(120)),    // ball and cone
      with_angle(mill(ToolType::drill, 5), radians(118)),
      with_angle(mill(ToolType::taper, 1, 0.5, 12), radians(3)),  // ball, cone, disc
      with_angle(mill(ToolType::taper, 6, 0.5, 5), radians(10),
                 2),  // disc, torus, cone, wall, disc
      endmill(4, 1, 7),
      with_angle(mill(ToolType::chamfer, 6), radians(30), 0.2),  // a small disc and cone
      mill(ToolType::tslot, 8, 0, 3),
      mill(ToolType::lollipop, 6),
      mill(ToolType::barrel, 8, 2, 16),
      mill(ToolType::form, 0)};
  t[10].neck_diameter = 3;
  t[11].profile_radius = 30;
  t[12].profile = {{0, 0, 0},   {1, 0, 0.15}, {2, 1, 0}, {3, 3, 0},
                   {3.2, 5, 0}, {1, 6, 0},    {0, 6, 0}};
  return t;
}

// Also such as hardly move in plan or in height.
ToolPath slant(Random& r) {
  ToolPath path;
  path.start = {r(-3, 3), r(-3, 3), r(-3, 3)};
  const double flat = r.pick(5) == 0 ? 1e-5 : r.pick(4) == 0 ? 0.03 : 1;
  const double steep = r.pick(5) == 0 ? 1e-5 : r.pick(4) == 0 ? 0.1 : 1;
  path.travel = {flat * r(-5, 5), flat * r(-5, 5), steep * r(-5, 5)};
  path.speed = length(path.travel);
  return path;
}

double chain_bound(const ChainTool& tool, const ChainLine& line, const Vec3& p) {
  const std::uint32_t row = 0;
  double out[PointColumns::kPad];
  sweep_kernels().chain_bounds(tool, &line, &row, 1, p, std::numeric_limits<double>::infinity(),
                               out);
  return out[0];
}

Vec3 point_near(Random& r, const ToolPath& path, double reach) {
  const Vec3 at = path.start + r(0, 1) * path.travel;
  Vec3 p = at + Vec3{r(-reach, reach), r(-reach, reach), r(-0.5 * reach, reach)};
  if (r.pick(10) == 0) p.x = at.x, p.y = at.y;           // on the axis
  if (r.pick(10) == 0) p = at + r(-1, 2) * path.travel;  // on the path of the tip
  if (r.pick(10) == 0) p = path.start + Vec3{0, 0, r(0, reach)};
  return p;
}

class Chains : public ::testing::TestWithParam<int> {};

TEST_P(Chains, EqualTheSearchAndDenseSamples) {
  const Profile cutter = make_cutter(convex_tools()[static_cast<std::size_t>(GetParam())]);
  const ChainTool tool = chain_tool(cutter);
  ASSERT_GT(tool.count, 0u);
  Random r(static_cast<std::uint64_t>(40 + GetParam()));
  unsigned inside = 0, outside = 0;
  for (unsigned round = 0; round < rounds(240); ++round) {
    const ToolPath path = slant(r);
    const ChainLine line = chain_line(tool, path);
    for (int k = 0; k < 12; ++k) {
      const Vec3 p = point_near(r, path, 1.5 * tool.radius + 1);
      const auto at_rest = [&](double t) {
        const Vec3 q = p - path_point(path, t).position;
        return cutter.distance({std::sqrt(q.x * q.x + q.y * q.y), q.z});
      };
      const PathSample got = chain_minimum(tool, line, p);
      ASSERT_NEAR(got.distance, path_distance(cutter, path, p).distance, 1e-11) << round;
      if (k < 3) {
        ASSERT_NEAR(got.distance, least(at_rest, 300), 1e-9) << round;
      }
      ASSERT_TRUE(got.t >= 0 && got.t <= 1);
      ASSERT_NEAR(got.distance, at_rest(got.t), 1e-11) << "the place is where the distance is";
      ASSERT_LE(chain_bound(tool, line, p), got.distance + 1e-9);
      ++(got.distance < 0 ? inside : outside);
    }
  }
  EXPECT_GT(inside, rounds(240));
  EXPECT_GT(outside, rounds(240));
}

// Where the path is steeper than the cone, the path of the point lies within the tool.
TEST(Chains, ThePathOfAPointIsWithinASteepSweep) {
  const Profile cutter = make_cutter(convex_tools()[1]);
  const ChainTool tool = chain_tool(cutter);
  ToolPath path;
  path.travel = {1.5, 0, 4.5};
  path.speed = length(path.travel);
  const ChainLine line = chain_line(tool, path);
  for (const double t : {0.6, 0.75, 0.9}) {
    const PathSample got = chain_minimum(tool, line, t * path.travel);
    EXPECT_LT(got.distance, -0.1) << t;
    EXPECT_NEAR(got.distance, path_distance(cutter, path, t * path.travel).distance, 1e-11) << t;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Chains, ::testing::Range(0, static_cast<int>(convex_tools().size())));

// Where the contact is on a cone, the planes of the flanks are the distance itself.
TEST(Chains, BoundIsTheDistanceBesideAFlank) {
  const Profile cutter = make_cutter(convex_tools()[0]);
  const ChainTool tool = chain_tool(cutter);
  ToolPath path;
  path.travel = {4, 0, 1};
  const ChainLine line = chain_line(tool, path);
  const Vec3 p{2, 1.5, 1.5};
  EXPECT_GT(chain_minimum(tool, line, p).distance, 0.1);
  EXPECT_NEAR(chain_bound(tool, line, p), chain_minimum(tool, line, p).distance, 1e-12);
}

// Likewise where the contact is on the ball at the tip.
TEST(Chains, BoundIsTheDistanceUnderTheTip) {
  const Profile cutter = make_cutter(convex_tools()[5]);
  const ChainTool tool = chain_tool(cutter);
  ToolPath path;
  path.travel = {4, 0, 1};
  const ChainLine line = chain_line(tool, path);
  for (const Vec3 p : {Vec3{2, 0.3, -0.4}, Vec3{-0.2, -0.1, -0.3}, Vec3{4.3, 0.2, 0.8}}) {
    EXPECT_GT(chain_minimum(tool, line, p).distance, 0.01);
    EXPECT_NEAR(chain_bound(tool, line, p), chain_minimum(tool, line, p).distance, 1e-12);
  }
}

// Lists of several tools: the nearest sweep, and of equally near ones the first.
TEST(Chains, NearestOfAListEqualsSingleQueries) {
  Random r(77);
  std::vector<Tool> tools = convex_tools();
  tools.push_back(endmill(3));
  tools.push_back(with_angle(mill(ToolType::drill, 5), radians(90)));
  std::vector<Motion> motions;
  for (int i = 0; i < 150; ++i) {
    const Vec3 a{r(-9, 9), r(-9, 9), r(-3, 3)};
    Motion m = line(a, {r(-9, 9), r(-9, 9), i % 4 == 0 ? a.z : r(-3, 3)});
    m.tool = r.pick(static_cast<int>(tools.size()));
    if (i % 12 == 1) m.tool_axis = {0.6, 0, 0.8};
    motions.push_back(m);
    if (i % 10 == 0) motions.push_back(m);
  }
  const SweepTable s(motions, tools);
  std::vector<std::uint32_t> ids;
  unsigned known = 0;  // places on the path
  for (unsigned round = 0; round < rounds(600); ++round) {
    ids.clear();
    for (std::uint32_t i = 0; i < s.size(); ++i)
      if (r(0, 1) < 0.3) ids.push_back(i);
    const Vec3 p{r(-9, 9), r(-9, 9), r(-4, 6)};
    SweepTable::Nearest want;
    for (const std::uint32_t id : ids)
      if (const double d = s.distance(id, p); d < want.distance) want = {d, id};
    const SweepTable::Nearest got = s.nearest(ids, p);
    ASSERT_EQ(got.distance, want.distance);
    ASSERT_EQ(got.sweep, want.sweep);
    if (!ids.empty()) {
      ASSERT_EQ(s.patch(got.sweep, p, got.t), s.patch(got.sweep, p));
      known += got.t ? 1 : 0;
    }
  }
  EXPECT_GT(known, rounds(200));
}

// The face that p sees from outside of the tool: p lies on its normal, at the sweep's distance, and
// so does what lies between p and a place just below the face.
TEST(Chains, FacesWithoutASearchAreThoseOfTheSweep) {
  Random r(78);
  unsigned closed = 0;
  for (const Tool& kind : convex_tools()) {
    const Profile cutter = make_cutter(kind);
    const ChainTool tool = chain_tool(cutter);
    for (unsigned round = 0; round < rounds(120); ++round) {
      const ToolPath path = slant(r);
      const ChainLine line = chain_line(tool, path);
      const Vec3 p = point_near(r, path, tool.radius + 1);
      const PathSample at = chain_minimum(tool, line, p);
      const Vec3 q = p - path_point(path, at.t).position;
      const Vec2 seen{std::sqrt(q.x * q.x + q.y * q.y), q.z};
      if (at.distance < 0.01 || cutter.foot_is_corner(seen)) continue;
      const std::int32_t patch = cutter.sample(seen).patch;
      // On steep moves the nearest place is a corner that a search comes near only.
      const Vec2 foot = seen - at.distance * cutter.gradient(seen, patch);
      const int corner = cutter.nearest_corner(foot);
      if (corner >= 0 && length(cutter.corner_point(corner) - foot) < 1e-5) continue;
      if (std::fabs(cutter.face_distance(seen, patch) - at.distance) > 1e-12) continue;  // the tip
      const auto face = chain_face(tool, line, p, patch);
      if (!face) continue;
      ++closed;
      ASSERT_NEAR(face->distance, at.distance, 1e-9) << round;
      ASSERT_NEAR(length(face->normal), 1, 1e-12);
      ASSERT_NEAR(chain_minimum(tool, line, p - 0.5 * at.distance * face->normal).distance,
                  0.5 * at.distance, 1e-6);
      const auto below = chain_face(tool, line, p - (at.distance + 1e-4) * face->normal, patch);
      if (below) {
        ASSERT_NEAR(below->distance, -1e-4, 1e-8);
      }
    }
  }
  EXPECT_GT(closed, rounds(400));
}

}  // namespace
}  // namespace mrsim
