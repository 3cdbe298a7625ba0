// Turning inserts on lines and arcs against brute force over positions.
#include "core/numbers/units.h"
#include "sweep_support.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

// Signed distance to a convex polygon from its corners: brute over points of its sides.
double polygon(const std::vector<Vec2>& c, Vec2 q) {
  if (c.size() == 1) return std::hypot(q.x - c[0].x, q.y - c[0].y);
  double out = 1e300, in = -1e300;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Vec2 a = c[i], b = c[(i + 1) % c.size()], d = b - a;
    const double t = std::clamp(dot(q - a, d) / dot(d, d), 0.0, 1.0);
    out = std::min(out, std::hypot(q.x - a.x - t * d.x, q.y - a.y - t * d.y));
    in = std::max(in, cross(q - a, d) / std::hypot(d.x, d.y));
  }
  return in > 0 ? out : in;
}

double brute(const Motion& m, const InsertOutline& o, const Vec3& p) {
  const double rho = std::hypot(p.x, p.y);
  const auto side = [&](double x) {
    return least(
               [&](double t) {
                 const Vec3 c = at(m, t);
                 return polygon(o.core, {x - c.x, p.z - c.z});
               },
               1500) -
           o.round;
  };
  return o.inside ? side(rho) : std::min(side(rho), side(-rho));
}

TEST(TurnSweep, OutsideEqualsTheLeastDistanceOverAllPositions) {
  Random r(3);
  const char* shapes[] = {"V", "CNMG", "D", "T", "W", "S", "R", "KNUX"};
  for (int round = 0; round < 64; ++round) {
    Tool tool = insert(shapes[round % 8], round % 3 == 0 ? 0 : 0.4 + 0.4 * (round % 2));
    if (round % 8 == 6) tool.nose_radius = 3;
    const Vec3 a = {r(4, 20), 0, r(-20, 0)};
    Motion m = line(a, {r(-1, 20), 0, r(-20, 0)});
    if (round % 2 == 1) m = arc(a, {a.x + r(-6, 6), 0, a.z + r(-6, 6)}, {0, 1, 0}, r(-6.2, 6.2));
    const SweepTable s({&m, 1}, {&tool, 1});
    const InsertOutline o = make_insert(tool);
    for (int k = 0; k < 12; ++k) {
      const Vec3 p = {r(-40, 40), r(-10, 10), r(-40, 30)};
      const double want = brute(m, o, p), got = s.distance(0, p);
      if (want > -o.round + 1e-9)
        EXPECT_NEAR(got, want, 1e-6) << "round " << round << " inside " << o.inside;
      else  // inside the core: any depth between that of one position and the true one
        EXPECT_LE(got, want + 1e-6) << "round " << round;
    }
  }
}

// A round insert on a line covers a segment, thickened: beyond its ends, too, where a point lies
// exactly on the line.
TEST(TurnSweep, NothingIsCutOnTheLineBeyondItsEnds) {
  const Tool tool = insert("R", 0.2, 9);
  const Motion m = line({18, 0, 16}, {19, 0, 16});
  const SweepTable s({&m, 1}, {&tool, 1});
  for (const double x : {14.5, 17.0, 20.0, 30.0})
    EXPECT_NEAR(s.distance(0, {x, 0, 16}), std::max(18 - x, x - 19) - 0.2, 1e-12) << x;
  EXPECT_NEAR(s.distance(0, {18.5, 0, 16}), -0.2, 1e-12);
}

// A corner that draws nothing but one point of the path has no line through the centre either.
TEST(TurnSweep, NothingIsCutBehindAnArcThatEndsSquare) {
  Tool tool = insert("V", 0.8);
  tool.type = ToolType::grooving;
  tool.width = 3.027433;
  tool.edge_length = 3.300770;
  const Motion m = arc({10.5, 0, 29}, {10.5, 0, 25}, {0, 1, 0}, kPi / 2);
  const SweepTable s({&m, 1}, {&tool, 1});
  const InsertOutline o = make_insert(tool);
  for (const double x : {8.0, 9.35, 10.0})
    for (const double z : {25.0, 25.8, 25.9}) {
      const Vec3 p{x, 0, z};
      EXPECT_NEAR(s.distance(0, p), brute(m, o, p), 1e-4) << x << ' ' << z;
    }
}

// A blade whose end is half a circle is a segment, thickened: it has no inside at any one position,
// and yet it sweeps all that lies between the ends of its path.
Tool round_blade(double width, double edge, int tip) {
  Tool tool = insert("V", width / 2, tip);
  tool.type = ToolType::grooving;
  tool.width = width;
  tool.edge_length = edge;
  return tool;
}

TEST(TurnSweep, RoundBladeLeavesNothingWithinWhatItSweepsOnAnArc) {
  const Tool tool = round_blade(2, 11, 8);
  const Motion m = arc({20, 0, 0}, {20, 0, -10}, {0, 1, 0}, -kPi / 2);
  const SweepTable s({&m, 1}, {&tool, 1});
  // At Z-5 the middle of the blade is at Z-5 from X12.34 to X21.34. X18 is 3 mm off the curve that
  // its upper end draws (13 mm from (30, -10), radius 10), farther off all others.
  EXPECT_NEAR(s.distance(0, {18, 0, -5}), -3 - 1, 1e-9);
  EXPECT_NEAR(s.distance(0, {0, 12, -5}), std::hypot(9, 5) - 10 - 1, 1e-9);
}

TEST(TurnSweep, RoundBladeOnAnArcHasTheFacesOfItsSurface) {
  Random r(11);
  int faces = 0;
  for (int round = 0; round < 60; ++round) {
    const Tool tool = round_blade(r(0.6, 3), r(4, 12), round % 2 == 0 ? 8 : 7);
    InsertOutline o = make_insert(tool);
    const auto same = [](Vec2 a, Vec2 b) { return length(b - a) < 1e-9; };
    o.core.erase(std::unique(o.core.begin(), o.core.end(), same), o.core.end());
    if (same(o.core.front(), o.core.back())) o.core.pop_back();
    ASSERT_EQ(o.core.size(), 2u);
    // Every other arc begins where the blade goes along itself, or square to that.
    const double from = round % 4 < 2 ? r(0, kTwoPi) : kPi / 2 * r.pick(4), size = r(2, 9);
    const Vec3 center = {r(24, 30), 0, r(-5, 5)};
    const Motion m = arc(center + size * Vec3{std::cos(from), 0, std::sin(from)}, center, {0, 1, 0},
                         r.pick(3) == 0 ? kPi / 2 : r(-6.2, 6.2));
    const SweepTable s({&m, 1}, {&tool, 1});
    for (int k = 0; k < 24; ++k) {
      Vec3 p = {r(10, 50), 0, r(-25, 25)};
      const double want = brute(m, o, p), got = s.distance(0, p);
      if (want <= -o.round + 1e-7) {
        EXPECT_LE(got, -o.round + 1e-6) << "round " << round;
        continue;
      }
      EXPECT_NEAR(got, want, 1e-6) << "round " << round;
      // Down to the surface, whose face there is 0 and leads out.
      for (int step = 0; step < 60; ++step) {
        const SweepSample at = s.sample(0, p);
        p = p - at.distance * s.gradient(0, p, at.patch);
      }
      const SweepSample at = s.sample(0, p);
      if (std::fabs(at.distance) > 1e-9) continue;  // to and fro across a crease
      const Vec3 out = p + 1e-4 * s.gradient(0, p, at.patch);
      EXPECT_NEAR(s.patch_distance(0, p, at.patch), 0, 1e-6) << "round " << round;
      EXPECT_NEAR(s.patch_distance(0, out, at.patch), 1e-4, 1e-6) << "round " << round;
      EXPECT_GT(brute(m, o, out), 1e-5) << "round " << round;
      ++faces;
    }
  }
  EXPECT_GT(faces, 1000);
}

TEST(TurnSweep, SharpInsertFacesAndTurnsAtTheProgrammedPoint) {
  const Motion m = line({15, 0, -5}, {15, 0, -19});
  const Tool tool = insert("", 0);
  const SweepTable s({&m, 1}, {&tool, 1});
  EXPECT_NEAR(s.distance(0, {14, 0, -10}), 1, 1e-12);
  EXPECT_NEAR(s.distance(0, {0, 14.5, -10}), 0.5, 1e-12);
  EXPECT_LT(s.distance(0, {16, 0, -10}), -0.5);
  EXPECT_GT(s.distance(0, {16, 0, -19.5}), 0);
  EXPECT_EQ(s.smallest_radius(), 0);
}

TEST(TurnSweep, BoringBarStaysOnItsSideOfTheAxis) {
  Tool tool = insert("C", 0.4);
  tool.type = ToolType::boring;
  const Motion m = line({10, 0, 0}, {10, 0, -20});
  const SweepTable s({&m, 1}, {&tool, 1});
  EXPECT_NEAR(s.distance(0, {0, 10.5, -10}), 0.5, 1e-12);
  EXPECT_LT(s.distance(0, {9, 0, -10}), -0.9);
  EXPECT_GT(s.distance(0, {12, 0, -10}), 1.9);
}

TEST(TurnSweep, TipOrientationPlacesTheNose) {
  const Vec2 centres[] = {{0, 0},  {-1, -1}, {-1, 1}, {1, 1}, {1, -1},
                          {0, -1}, {-1, 0},  {0, 1},  {1, 0}, {0, 0}};
  for (int tip = 1; tip <= 9; ++tip) {
    const InsertOutline o = make_insert(insert("D", 0.8, tip));
    double nearest = 1e300;
    for (Vec2 c : o.core) nearest = std::min(nearest, length(c - 0.8 * centres[tip]));
    EXPECT_LT(nearest, 1e-12) << "tip " << tip;
    for (std::size_t i = 0; i < o.core.size(); ++i) {
      const Vec2 a = o.core[i], b = o.core[(i + 1) % o.core.size()];
      const Vec2 c = o.core[(i + 2) % o.core.size()];
      EXPECT_GT(cross(b - a, c - b), 0) << "convex, counter-clockwise; tip " << tip;
    }
  }
}

}  // namespace
}  // namespace mrsim
