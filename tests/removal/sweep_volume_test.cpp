// Volumes of sweeps against closed forms (Steiner, Pappus), patches, dominance, refusals.
#include "core/numbers/units.h"
#include "sweep_support.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

SweepTable table(const Motion& m, const Tool& tool) { return SweepTable({&m, 1}, {&tool, 1}); }

// Volume below `top`: a cell counts by how much of it the surface cuts off, to second order.
double volume(const SweepTable& s, double top, double h = 0.2) {
  const Box3 b = inflated(s.bounds(0), h);
  const double high = std::min(b.hi.z, top);
  const int layers = static_cast<int>(std::ceil((high - b.lo.z) / h));
  double sum = 0;
  for (int k = 0; k < layers; ++k)
    for (double y = b.lo.y + h / 2; y < b.hi.y; y += h)
      for (double x = b.lo.x + h / 2; x < b.hi.x; x += h)
        sum += std::clamp(0.5 - s.distance(0, {x, y, high - (k + 0.5) * h}) / h, 0.0, 1.0);
  return sum * h * h * h;
}

// The same for a solid of revolution about Z.
double turned_volume(const SweepTable& s, double outer, double h = 0.05) {
  const Box3 b = inflated(s.bounds(0), h);
  double sum = 0;
  for (double z = b.lo.z + h / 2; z < b.hi.z; z += h)
    for (double x = h / 2; x < outer; x += h)
      sum += kTwoPi * x * std::clamp(0.5 - s.distance(0, {x, 0, z}) / h, 0.0, 1.0);
  return sum * h * h;
}

TEST(SweepVolume, HorizontalLinesHaveTheClosedForm) {
  const Motion m = line({0, 0, 0}, {6, 8, 0});
  const double l = 10, r = 3, h = 4;
  EXPECT_NEAR(volume(table(m, endmill(6)), h), (kPi * r * r + 2 * r * l) * h, 2);
  const double below = 2 * kPi * r * r * r / 3 + kPi * r * r * l / 2;
  EXPECT_NEAR(volume(table(m, ballmill(6)), r + h), below + (kPi * r * r + 2 * r * l) * h, 2);
  Tool slot = endmill(6, 0, 2);
  slot.type = ToolType::tslot;
  EXPECT_NEAR(volume(table(m, slot), 100), (kPi * r * r + 2 * r * l) * 2, 2);
  Tool pop = endmill(6);
  pop.type = ToolType::lollipop;
  EXPECT_NEAR(volume(table(m, pop), 100), 4 * kPi * r * r * r / 3 + kPi * r * r * l, 2);
}

// Minkowski sum of a convex body and a segment: body + length * shadow along the segment.
TEST(SweepVolume, SlantedLinesHaveTheClosedForm) {
  const Motion m = line({0, 0, 0}, {6, 6, 3});
  const double l = 9, r = 3, h = 5, plan = std::sqrt(72), rise = 3;
  EXPECT_NEAR(volume(table(m, endmill(6, 0, h)), 100),
              kPi * r * r * h + 2 * r * h * plan + kPi * r * r * rise, 3);
  Tool pop = endmill(6);
  pop.type = ToolType::lollipop;
  EXPECT_NEAR(volume(table(m, pop), 100), 4 * kPi * r * r * r / 3 + kPi * r * r * l, 3);
}

TEST(SweepVolume, CirclesAndHelicesHaveTheClosedForm) {
  const double big = 7, r = 2, h = 3;
  const Motion full = arc({big, 0, 0}, {0, 0, 0}, {0, 0, 1}, kTwoPi);
  EXPECT_NEAR(volume(table(full, endmill(2 * r)), h), 4 * kPi * big * r * h, 3);
  EXPECT_NEAR(volume(table(full, ballmill(2 * r)), r), kPi * kPi * big * r * r, 3);
  Tool pop = endmill(2 * r);
  pop.type = ToolType::lollipop;
  EXPECT_NEAR(volume(table(full, pop), 100), 2 * kPi * kPi * big * r * r, 3);
  // The same torus upright: an arc in G18, no horizontal section is a ring there.
  const Motion upright = arc({big, 0, 0}, {0, 0, 0}, {0, 1, 0}, kTwoPi);
  EXPECT_NEAR(volume(table(upright, pop), 100), 2 * kPi * kPi * big * r * r, 3);
  // A helical bore is a cylinder down to its last turn, and half a pitch of ramp below.
  const Motion helix = arc({2, 0, 0}, {0, 0, 0}, {0, 0, 1}, 4 * kTwoPi, -4);
  const double bore = volume(table(helix, endmill(10)), -3);
  EXPECT_LT(bore, kPi * 49);
  EXPECT_NEAR(volume(table(helix, endmill(10)), 2) - bore, kPi * 49 * 5, 5);
}

TEST(SweepVolume, PlungesOfDrillsAndEndmillsHaveTheirVolume) {
  Tool drill = endmill(6);
  drill.type = ToolType::drill;
  const double r = 3, cone = r / std::tan(radians(59));
  const Motion m = line({1, 2, 5}, {1, 2, -4});
  EXPECT_NEAR(volume(table(m, drill), 2, 0.1), kPi * r * r * (6 - cone * 2 / 3), 1);
  EXPECT_NEAR(volume(table(m, endmill(6, 0, 2)), 100, 0.1), kPi * r * r * 11, 1);
}

TEST(SweepVolume, TurnedVolumesAreThoseOfPappus) {
  Tool button;
  button.id.assign(1, '1');
  button.type = ToolType::turning;
  button.insert = "R";
  button.nose_radius = 2;
  button.tip_is_nose_centre = true;
  const Motion along = line({20, 0, 0}, {20, 0, -12});
  EXPECT_NEAR(turned_volume(table(along, button), 25), (4 * kPi + 4 * 12) * kTwoPi * 20, 10);
  const Motion circle = arc({25, 0, 0}, {20, 0, 0}, {0, 1, 0}, kTwoPi);
  EXPECT_NEAR(turned_volume(table(circle, button), 30), 4 * kPi * 5 * 2 * kTwoPi * 20, 10);
  Tool blade;
  blade.id.assign(1, '1');
  blade.type = ToolType::grooving;
  blade.width = 3;
  const Motion plunge = line({25, 0, -5}, {15, 0, -5});
  EXPECT_NEAR(turned_volume(table(plunge, blade), 25), kPi * (625 - 225) * 3, 10);
}

// Two points of one face are joined by ever closer ones whose normals approach each other; across a
// crease the difference stays. (A flat mill on a gentle slope s turns its normal within s^2 R.)
class Walker {
 public:
  explicit Walker(const SweepTable& s) : s_(s) {}
  Vec3 surface(Vec3 p) const {
    for (int k = 0; k < 60; ++k)
      p = p - s_.distance(0, p) * s_.gradient(0, p, s_.sample(0, p).patch);
    return p;
  }
  bool smooth(const Vec3& p, const Vec3& q, int depth = 0) const {
    const std::int32_t face = s_.sample(0, p).patch;
    if (std::fabs(s_.distance(0, p)) > 1e-8 || std::fabs(s_.distance(0, q)) > 1e-8) return true;
    if (face != s_.sample(0, q).patch) return true;
    if (distance(s_.gradient(0, p, face), s_.gradient(0, q, face)) < 0.3) return true;
    if (depth > 14) return false;
    const Vec3 m = surface(0.5 * (p + q));
    return smooth(p, m, depth + 1) && smooth(m, q, depth + 1);
  }

 private:
  const SweepTable& s_;
};

TEST(SweepPatch, NormalsAreContinuousOnOneFace) {
  Random r(31);
  std::vector<Tool> tools = {endmill(6), endmill(6, 1), ballmill(6), endmill(6, 0, 7)};
  Tool insert;
  insert.id.assign(1, '1');
  insert.type = ToolType::turning;
  tools.push_back(insert);
  for (int round = 0; round < 150; ++round) {
    const Tool& tool = tools[round % 5];
    const Vec3 a = {r(4, 12), round % 5 == 4 ? 0 : r(-3, 3), r(-3, 3)};
    Motion m = line(a, {r(4, 12), a.y, r(-3, 3)});
    if (round % 3 == 1) m = arc(a, {r(4, 12), a.y, r(-3, 3)}, {0, 1, 0}, r(-6, 6));
    if (round % 3 == 2 && round % 5 != 4)
      m = arc(a, {r(4, 12), r(-3, 3), a.z}, {0, 0, 1}, r(-6, 6), round % 2 * r(-2, 2));
    const SweepTable s = table(m, tool);
    const Walker walker(s);
    for (int k = 0; k < 40; ++k) {
      const Vec3 p = walker.surface(at(m, r(0, 1)) + Vec3{r(-5, 5), r(-5, 5), r(-4, 6)});
      const Vec3 q = walker.surface(p + Vec3{r(-0.02, 0.02), r(-0.02, 0.02), r(-0.02, 0.02)});
      EXPECT_TRUE(walker.smooth(p, q)) << "round " << round << " patch " << s.sample(0, p).patch;
    }
  }
}

void expect_unsupported(const Motion& m, const Tool& tool) {
  try {
    table(m, tool);
    ADD_FAILURE();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), "motion-unsupported");
    EXPECT_NE(std::string(e.what()).find("line 1"), std::string::npos);
  }
}

TEST(SweepTable, RefusesWhatATurningToolCannotDo) {
  Tool tool;
  tool.id.assign(1, '1');
  tool.type = ToolType::turning;
  expect_unsupported(line({10, 1, 0}, {10, 1, -5}), tool);
  expect_unsupported(arc({10, 0, 0}, {8, 0, 0}, {0, 0, 1}, 1), tool);
}

// Without its lead it would be a groove that the program does not mean.
TEST(SweepTable, LeavesThreadsOfTurningToolsOut) {
  Tool tool;
  tool.id.assign(1, '1');
  tool.type = ToolType::turning;
  Motion thread = line({10, 0, 0}, {10, 0, -5});
  EXPECT_EQ(table(thread, tool).size(), 1u);
  thread.lead = 1.5;
  EXPECT_EQ(table(thread, tool).size(), 0u);
}

TEST(SweepTable, TiltedToolIsTheUprightOneTurned) {
  Random r(51);
  const Tool tool = endmill(6, 1);
  const Vec3 axis = normalized(Vec3{0.3, -0.5, 0.8});
  const Vec3 side = normalized(cross(axis, Vec3{1, 0, 0}));
  Motion m = line({1, 2, 3}, Vec3{1, 2, 3} + 7 * side);
  m.tool_axis = axis;
  const SweepTable s = table(m, tool);
  for (int k = 0; k < 500; ++k) {
    const Vec3 p = {r(-10, 12), r(-10, 12), r(-10, 12)};
    const double want = least(
        [&](double t) {
          const Vec3 q = p - at(m, t);
          const double z = dot(q, axis);
          return mill_at_rest(3, 1, {length(q - z * axis), 0, z});
        },
        400);
    EXPECT_NEAR(s.distance(0, p), want, 1e-6);
    if (want > 0) continue;
    const Box3 b = s.bounds(0);
    EXPECT_TRUE(p.x > b.lo.x && p.y > b.lo.y && p.z > b.lo.z && p.x < b.hi.x && p.y < b.hi.y &&
                p.z < b.hi.z);
  }
}

}  // namespace
}  // namespace mrsim
