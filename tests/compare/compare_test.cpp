// Pairs of meshes whose distance is known in closed form.
#include "compare/distance/align.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"
#include <mrsim/compare.h>

#include <cmath>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

CompareOptions accept(double lo, double hi) {
  CompareOptions options;
  options.accept = Acceptance{lo, hi};
  options.samples = 20000;
  options.hausdorff_error = 1e-4;
  return options;
}

RigidTransform turn(double degrees_about_z, const Vec3& shift) {
  const SinCos a = sincos_deg(degrees_about_z);
  RigidTransform t;
  t.rotation = {{{a.cos, -a.sin, 0}, {a.sin, a.cos, 0}, {0, 0, 1}}};
  t.shift = shift;
  return t;
}

TEST(Compare, SpheresOfTwoRadiiAreAsFarApartAsTheRadii) {
  // The same tessellation: corresponding facets are parallel, cos(pi / 200) off at most.
  const TriMesh part = testing::sphere_mesh(200, 10.01), nominal = testing::sphere_mesh(200, 10);
  const Comparison c = compare(part, nominal, accept(-0.02, 0.02));
  EXPECT_NEAR(c.part.mean, 0.01, 1e-4);
  EXPECT_NEAR(c.part.max, 0.01, 1e-4);
  EXPECT_NEAR(c.part.min, 0.01, 1e-4);
  EXPECT_NEAR(c.nominal.mean, 0.01, 1e-4);
  EXPECT_NEAR(c.hausdorff.lower, 0.01, 1e-4);
  EXPECT_LE(c.hausdorff.upper, c.hausdorff.lower + 1.01e-4);
  EXPECT_NEAR(c.excess_volume, c.part_volume - c.nominal_volume, 1e-6 * c.excess_volume);
  EXPECT_NEAR(c.gouge_volume, 0, 1e-3);
  EXPECT_TRUE(*c.accepted);
  EXPECT_FALSE(*compare(part, nominal, accept(-0.005, 0.005)).accepted);
  EXPECT_NEAR(compare(nominal, part, accept(-1, 1)).part.mean, -0.01, 1e-4);
}

// "found ... +0.0500" beside a tolerance of 0.05 would hide why.
TEST(Compare, VerdictShowsWhatIsJustBeyond) {
  Comparison c;
  c.band = {-0.05, 0.05};
  c.part.min = -0.02, c.part.max = 0.050003;
  c.accepted = false;
  EXPECT_NE(comparison_text(c).find("found -0.0200 .. +0.050003 mm"), std::string::npos);
  c.part.max = 0.04;
  c.accepted = true;
  EXPECT_NE(comparison_text(c).find("found -0.0200 .. +0.0400 mm"), std::string::npos);
}

TEST(Compare, APlateOffsetBy50MicronsIsMeasuredSo) {
  const TriMesh nominal = testing::box_mesh({0, 0, 0}, {80, 50, 5});
  const TriMesh part = testing::box_mesh({0, 0, 0}, {80, 50, 5.05});
  const Comparison c = compare(part, nominal, accept(-0.02, 0.02));
  EXPECT_NEAR(c.part.max, 0.05, 1e-6);
  EXPECT_NEAR(c.part.p99, 0.05, 1e-6);
  EXPECT_NEAR(c.part.min, 0, 1e-6);
  EXPECT_NEAR(c.hausdorff.lower, 0.05, 1e-6);
  EXPECT_NEAR(c.hausdorff.upper, 0.05, 1.1e-4);
  EXPECT_NEAR(c.excess_volume, 80 * 50 * 0.05, 0.05);
  EXPECT_NEAR(c.part.excess_area, 80 * 50 + 260 * 0.03, 40);
  EXPECT_EQ(c.region_count, 1u);
  EXPECT_NEAR(c.regions[0].worst, 0.05, 1e-6);
  EXPECT_NEAR(c.regions[0].volume, 200, 3);
  EXPECT_FALSE(*c.accepted);
  const Comparison thin = compare(nominal, part, accept(-0.02, 0.02));
  EXPECT_NEAR(thin.part.min, -0.05, 1e-6);
  EXPECT_NEAR(thin.gouge_volume, 200, 0.05);
}

// Lines along Z meet few of the layers that lie on upright walls.
TEST(Compare, LayersOnUprightWallsHaveTheirVolumes) {
  const TriMesh nominal = testing::box_mesh({0, 0, 0}, {80, 50, 5});
  const Comparison left = compare(testing::box_mesh({0, 0, 0}, {80.0078125, 50, 5}), nominal, {});
  EXPECT_NEAR(left.excess_volume, 50 * 5 / 128.0, 1e-6);
  EXPECT_NEAR(left.gouge_volume, 0, 1e-6);
  // One wall stands out by 0.05, the next is cut back by 0.02.
  const Comparison both = compare(testing::box_mesh({0, 0.02, 0}, {80.05, 50, 5}), nominal, {});
  EXPECT_NEAR(both.excess_volume - both.gouge_volume, both.part_volume - both.nominal_volume, 1e-6);
  EXPECT_NEAR(both.excess_volume, 0.05 * 49.98 * 5, 5 * both.volume_error);
  EXPECT_LT(both.volume_error, 0.1 * both.excess_volume);
}

TEST(Compare, ARotatedCubeIsOffByItsCorners) {
  // A cube of edge 20 turned by a about its axis: corners stand out by
  // 10 (cos a + sin a) - 10 beyond the faces.
  const double a = 0.5, out = 10 * (std::cos(radians(a)) + std::sin(radians(a)) - 1);
  const TriMesh nominal = testing::box_mesh({-10, -10, -10}, {10, 10, 10});
  const TriMesh part = transformed(nominal, turn(a, {}));
  const Comparison c = compare(part, nominal, accept(-0.5, 0.5));
  EXPECT_NEAR(c.part.max, out, 1e-4);
  EXPECT_NEAR(c.nominal.min, -out, 1e-4);
  EXPECT_NEAR(c.hausdorff.lower, out, 1e-4);
  EXPECT_GT(c.memory, 1e6);  // of the process, not of twelve triangles
}

TEST(Compare, IcpUndoesATurnAndAShift) {
  TriMesh nominal = testing::joined(testing::box_mesh({0, 0, 0}, {60, 40, 10}),
                                    testing::box_mesh({5, 5, 10.5}, {25, 15, 20}));
  const RigidTransform moved = turn(1.5, {0.4, -0.3, 0.2});
  const TriMesh part = transformed(nominal, moved);
  CompareOptions options = accept(-0.02, 0.02);
  EXPECT_FALSE(*compare(part, nominal, options).accepted);
  options.align = Alignment::icp;
  const Comparison c = compare(part, nominal, options);
  EXPECT_LT(c.part.rms, 1e-4);
  EXPECT_TRUE(*c.accepted);
  const Vec3 p{30, 20, 5}, back = apply(c.transform, apply(moved, p));
  EXPECT_NEAR(distance(back, p), 0, 1e-3);
}

// A shaft lies along Z on the lathe, and along any axis in CAD.
TEST(Compare, IcpFindsQuarterTurns) {
  const TriMesh nominal = testing::joined(testing::box_mesh({0, 0, 0}, {60, 40, 10}),
                                          testing::box_mesh({5, 5, 10.5}, {25, 15, 20}));
  CompareOptions options = accept(-0.02, 0.02);
  options.align = Alignment::icp;
  const Box3 box{{0, 0, 0}, {60, 40, 20}};
  const std::vector<RigidTransform> turns = quarter_turns(box, box);
  ASSERT_EQ(turns.size(), 24u);
  EXPECT_EQ(turns[0].rotation, RigidTransform{}.rotation);
  for (std::size_t i = 0; i < turns.size(); i += 5)
    EXPECT_TRUE(*compare(transformed(nominal, turns[i]), nominal, options).accepted) << i;
}

TEST(Compare, BoxAlignmentBridgesAKilometre) {
  const TriMesh nominal = testing::box_mesh({0, 0, 0}, {80, 50, 5});
  RigidTransform far;
  far.shift = {1e6, 0, 0};
  const TriMesh part = transformed(nominal, far);
  CompareOptions options = accept(-0.2, 0.2);
  EXPECT_EQ(testing::error_code([&] { compare(part, nominal, options); }), "compare-apart");
  options.align = Alignment::bbox;
  EXPECT_TRUE(*compare(part, nominal, options).accepted);
}

TEST(Compare, SuspectsUnits) {
  const TriMesh nominal = testing::box_mesh({0, 0, 0}, {80, 50, 5});
  for (const double factor : {25.4, 1000.0, 1 / 25.4, 1e-3}) {
    const TriMesh part = testing::box_mesh({0, 0, 0}, {80 * factor, 50 * factor, 5 * factor});
    EXPECT_EQ(testing::error_code([&] { compare(part, nominal); }), "compare-units") << factor;
  }
}

TEST(Compare, NumbersAreTheSameForAnyThreads) {
  const TriMesh part = testing::sphere_mesh(90, 10.01), nominal = testing::sphere_mesh(80, 10);
  CompareOptions options = accept(-0.005, 0.005);
  options.hausdorff_error = 5e-3;
  options.threads = 1;
  const std::string one = comparison_json(compare(part, nominal, options));
  options.threads = 3;
  EXPECT_EQ(one, comparison_json(compare(part, nominal, options)));
}

TEST(Compare, WithoutAToleranceThereIsNoVerdict) {
  const TriMesh box = testing::box_mesh({0, 0, 0}, {8, 5, 5});
  const Comparison c = compare(box, box);
  EXPECT_FALSE(c.accepted.has_value());
  EXPECT_NEAR(c.part.max, 0, 1e-12);
  EXPECT_LE(c.hausdorff.upper, 1.01e-4);
}

TEST(ParseAcceptance, TakesOneOrTwoNumbers) {
  EXPECT_EQ(parse_acceptance("0.05").lo, -0.05);
  EXPECT_EQ(parse_acceptance("-0.02,+0.05").hi, 0.05);
  EXPECT_EQ(parse_acceptance("-2e-2,5e-2").lo, -0.02);
  for (const char* bad : {"", "x", "0.1,0.2", "0,0", "0.1,", "nan", "-0.02", "0"})
    EXPECT_EQ(testing::error_code([&] { parse_acceptance(bad); }), "accept-invalid") << bad;
}

}  // namespace
}  // namespace mrsim
