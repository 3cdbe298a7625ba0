// Flat, bull-nose and ball mills on lines and horizontal arcs against brute force.
#include "core/numbers/units.h"
#include "sweep_support.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

Motion random_line(Random& r, int kind) {
  const Vec3 a = {r(-10, 10), r(-10, 10), r(-5, 5)};
  Vec3 b = {r(-10, 10), r(-10, 10), r(-5, 5)};
  if (kind == 0) b.z = a.z;
  if (kind == 1) b.x = a.x, b.y = a.y;
  return line(a, b);
}

double brute(const Motion& m, double radius, double corner, const Vec3& p) {
  return least([&](double t) { return mill_at_rest(radius, corner, p - at(m, t)); }, 800);
}

class MillSweep : public ::testing::TestWithParam<double> {};  // corner radius / radius

TEST_P(MillSweep, EqualsTheLeastDistanceOverAllPositions) {
  Random r(7);
  for (int round = 0; round < 60; ++round) {
    const double radius = r(0.5, 5), corner = GetParam() * radius;
    const Vec3 start = {r(-10, 10), r(-10, 10), r(-5, 5)};
    const Vec3 center = {start.x + r(-8, 8), start.y + r(-8, 8), start.z};
    const Motion m =
        round % 4 == 3 ? arc(start, center, {0, 0, 1}, r(-7, 7)) : random_line(r, round % 4);
    const Tool tool = endmill(2 * radius, corner);
    const SweepTable s({&m, 1}, {&tool, 1});
    ASSERT_EQ(s.size(), 1u);
    for (int k = 0; k < 12; ++k) {
      const Vec3 p = {r(-18, 18), r(-18, 18), r(-12, 12)};
      const double want = brute(m, radius, corner, p);
      EXPECT_NEAR(s.distance(0, p), want, 1e-7) << "round " << round;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(FlatBullBall, MillSweep, ::testing::Values(0.0, 0.3, 1.0));

// Horizontal and upright moves of cutters that reach up or end.
TEST(SweepTable, FlatFloorsAreWithinWhatTheySweep) {
  Random r(11);
  int known = 0;
  for (int round = 0; round < 300; ++round) {
    const double radius = r(0.5, 5), corner = r.pick(2) * 0.3 * radius;
    const Vec3 start = {r(-10, 10), r(-10, 10), r(-5, 5)};
    const Vec3 center = {start.x + r(-8, 8), start.y + r(-8, 8), start.z};
    const Motion m =
        round % 3 == 2 ? arc(start, center, {0, 0, 1}, r(-7, 7)) : random_line(r, round % 3);
    const bool ends = r.pick(2) == 1;
    const Tool tool = endmill(2 * radius, corner, ends ? r(2 * radius, 4 * radius) : 0);
    const SweepTable s({&m, 1}, {&tool, 1});
    for (int k = 0; k < 20; ++k) {
      const Vec3 column = at(m, r(0, 1)) + Vec3{r(-5, 5), r(-5, 5), 0};
      const auto flat = s.flat_floor(0, column);
      ASSERT_TRUE(flat) << "round " << round;
      EXPECT_EQ(std::isinf(flat->top), !ends);
      if (flat->inside <= 0) continue;
      ++known;
      EXPECT_NEAR(flat->z, s.bounds(0).lo.z, 1e-12);
      if (ends) {
        EXPECT_NEAR(flat->top, s.bounds(0).hi.z, 1e-12);
      }
      const double up = r(0, 1) * (ends ? flat->top - flat->z : 50);
      EXPECT_LE(s.distance(0, {column.x, column.y, flat->z + up}), 1e-9) << "round " << round;
    }
  }
  EXPECT_GT(known, 1000);
}

TEST(SweepTable, FlatSlotHasFloorAndWall) {
  const Motion m = line({0, 0, -2}, {10, 0, -2});
  const Tool tool = endmill(5);
  const SweepTable s({&m, 1}, {&tool, 1});
  EXPECT_NEAR(s.distance(0, {5, 0, -3}), 1, 1e-14);
  EXPECT_NEAR(s.distance(0, {5, 3, 0}), 0.5, 1e-14);
  EXPECT_NEAR(s.distance(0, {-2, 0, -1}), -0.5, 1e-14);
  EXPECT_NEAR(s.distance(0, {5, 5.5, -6}), 5, 1e-14);
  EXPECT_NE(s.sample(0, {5, 0, -2}).patch, s.sample(0, {5, 2.5, 0}).patch);
  EXPECT_EQ(s.gradient(0, {5, 0, -2}, s.sample(0, {5, 0, -2}).patch), (Vec3{0, 0, -1}));
  EXPECT_EQ(s.gradient(0, {5, 2.5, -2}, s.sample(0, {5, 2.5, 0}).patch), (Vec3{0, 1, 0}));
  EXPECT_EQ(s.bounds(0).lo, (Vec3{-2.5, -2.5, -2}));
  EXPECT_TRUE(std::isinf(s.bounds(0).hi.z));
  EXPECT_EQ(s.smallest_radius(), 2.5);
}

TEST(SweepTable, ArcSmallerThanTheToolHasNoInnerWall) {
  const Motion m = arc({2, 0, 0}, {0, 0, 0}, {0, 0, 1}, kTwoPi);
  const Tool tool = endmill(10);
  const SweepTable s({&m, 1}, {&tool, 1});
  EXPECT_NEAR(s.distance(0, {0, 0, 1}), -1, 1e-14);
  EXPECT_NEAR(s.distance(0, {0, 0, 10}), -3, 1e-14);
  EXPECT_NEAR(s.distance(0, {0, 7, 10}), 0, 1e-14);
}

TEST(SweepTable, SkipsRapidsAssumedStartsAndMovesWithoutExtent) {
  std::vector<Motion> m(4, line({0, 0, 0}, {1, 0, 0}));
  m[0].kind = MotionKind::rapid;
  m[1].assumed_start = true;
  m[2].end = m[2].start;
  const Tool tool = endmill(5);
  const SweepTable s(m, {&tool, 1});
  ASSERT_EQ(s.size(), 1u);
  EXPECT_EQ(s.motion(0), 3);
}

TEST(SweepTable, ShankHolderAndRapidsAreSelected) {
  std::vector<Motion> m(2, line({0, 0, 0}, {10, 0, 0}));
  m[0].kind = MotionKind::rapid;
  Tool tool = endmill(6, 0, 10);
  tool.shank = {{5, 5, 20}};
  tool.holder = {{20, 30, 10}, {30, 30, 20}};
  const auto select = [&](SweepSelection::Part part, bool cuts, bool rapids) {
    return SweepTable(m, {&tool, 1}, {part, cuts, rapids});
  };
  EXPECT_EQ(select(SweepSelection::Part::cutter, true, false).motion(0), 1);
  EXPECT_EQ(select(SweepSelection::Part::cutter, false, true).motion(0), 0);
  const SweepTable shank = select(SweepSelection::Part::shank, true, true);
  ASSERT_EQ(shank.size(), 2u);
  EXPECT_NEAR(shank.distance(0, {0, 0, 5}), 5, 1e-12);
  EXPECT_LT(shank.distance(0, {0, 0, 12}), -1.9);
  const SweepTable holder = select(SweepSelection::Part::holder, true, false);
  ASSERT_EQ(holder.size(), 2u);
  EXPECT_EQ(holder.motion(0), 1);
  EXPECT_EQ(holder.motion(1), 1);
  EXPECT_NEAR(holder.distance(1, {0, 0, 30}), 10, 1e-9);
}

// More motions than one part holds, of many forms; each is what it is on its own.
TEST(SweepTable, LongProgramsAreMadeInParts) {
  Random r(5);
  const std::vector<Tool> tools = {ballmill(6), endmill(8), endmill(6, 1, 5)};
  std::vector<Motion> motions;
  Vec3 at;
  for (int i = 0; i < 140000; ++i) {
    const int kind = i % 1000 < 900 ? 0 : r.pick(5);
    const Vec3 to = at + Vec3{r(-0.2, 0.2), r(-0.2, 0.2), kind == 1 ? 0.5 : kind == 2 ? 0.1 : 0};
    Motion m = kind == 3 ? arc(at, to, {0, 0, 1}, 1) : line(at, to);
    if (kind == 4) m.tool_axis = normalized(Vec3{0.1 * r.pick(3), 0, 1});
    m.tool = i / 50000;
    motions.push_back(m);
    at = m.end;
  }
  const SweepTable table(motions, tools), parts(motions, tools, {}, 2);
  ASSERT_EQ(table.size(), parts.size());
  for (int round = 0; round < 3000; ++round) {
    const auto i = static_cast<std::size_t>(r.pick(static_cast<int>(table.size())));
    const Motion& m = motions[static_cast<std::size_t>(table.motion(i))];
    const Vec3 p = m.start + Vec3{r(-5, 5), r(-5, 5), r(-5, 5)};
    const SweepTable alone({&m, 1}, tools);
    ASSERT_EQ(alone.size(), 1u);
    ASSERT_EQ(table.motion(i), parts.motion(i));
    ASSERT_EQ(table.distance(i, p), alone.distance(0, p));
    ASSERT_EQ(parts.distance(i, p), alone.distance(0, p));
    ASSERT_EQ(table.bounds(i).lo, alone.bounds(0).lo);
    ASSERT_EQ(table.bounds(i).hi, alone.bounds(0).hi);
  }
}

TEST(SweepTable, MissingToolIsAnError) {
  Motion m = line({0, 0, 0}, {1, 0, 0});
  m.tool = -1;
  try {
    const SweepTable s({&m, 1}, {});
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), "tool-missing");
  }
}

}  // namespace
}  // namespace mrsim
