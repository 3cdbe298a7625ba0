#include "removal/part_field.h"

#include "core/units.h"
#include "core/vec.h"

#include <random>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

Motion line(Vec3 a, Vec3 b) {
  Motion m;
  m.kind = MotionKind::line;
  m.start = a;
  m.end = b;
  m.tool = 0;
  return m;
}

Motion arc(Vec3 a, Vec3 center, Vec3 axis, double radius, double sweep, double rise) {
  Motion m;
  m.kind = MotionKind::arc;
  m.start = a;
  m.end = a;  // sweeps follow center, axis and sweep
  m.center = center;
  m.axis = axis;
  m.radius = radius;
  m.sweep = sweep;
  m.rise = rise;
  m.tool = 0;
  return m;
}

// At random points near the surface: gradient has unit length and is the numeric gradient of
// patch_distance, and patch_distance is d where the face is the nearest one.
void expect_faces_agree(const PartField& field) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> u(0, 1);
  const Candidates all = field.all();
  const Vec3 lo = field.bounds().lo, size = field.bounds().hi - lo;
  int faces = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec3 p = lo + Vec3{u(random) * size.x, u(random) * size.y, u(random) * size.z};
    const FieldSample at = field.sample(p, all);
    if (std::abs(at.distance) > 0.5 || std::abs(at.distance) < 1e-3) continue;
    const Vec3 n = field.gradient(p, at);
    EXPECT_NEAR(length(n), 1, 1e-9);
    constexpr double kStep = 1e-5;
    Vec3 numeric;
    bool same = true;
    for (int a = 0; a < 3; ++a) {
      Vec3 q = p, r = p;
      component(q, a) += kStep;
      component(r, a) -= kStep;
      component(numeric, a) =
          (field.patch_distance(q, at) - field.patch_distance(r, at)) / (2 * kStep);
      for (const Vec3& s : {q, r}) {
        const FieldSample there = field.sample(s, all);
        same = same && there.owner == at.owner && there.patch == at.patch;
      }
    }
    if (!same) continue;
    ++faces;
    // Faces drawn by a sharp corner of the tool are exact to first order in the distance: their
    // normal turns by about distance / radius of curvature, here at least 1 mm.
    EXPECT_LT(distance(numeric, n), 2e-4 + std::abs(at.distance))
        << "owner " << at.owner << " patch " << at.patch;
    if (at.distance < 0) {
      EXPECT_LE(std::abs(field.patch_distance(p, at)), std::abs(at.distance) + 1e-6)
          << "owner " << at.owner << " patch " << at.patch;
    }
  }
  EXPECT_GT(faces, 100);
}

TEST(PartField, FacesOfMillingSweeps) {
  StockShape shape;
  shape.box = {{0, 0, 0}, {40, 40, 20}};
  for (const ToolType type : {ToolType::endmill, ToolType::ballmill}) {
    Tool tool;
    tool.diameter = 6;
    tool.type = type;
    const std::vector<Motion> motions{
        line({-5, 10, 12}, {45, 14, 12}),                               // level
        line({5, 30, 18}, {35, 32, 8}),                                 // slanted
        arc({30, 20, 10}, {22, 20, 10}, {0, 0, 1}, 8, kPi, 0),          // level arc
        arc({12, 34, 16}, {8, 34, 16}, {0, 0, 1}, 4, -2 * kTwoPi, -6),  // helix
    };
    expect_faces_agree(PartField(StockSolid(shape), SweepTable(motions, std::span(&tool, 1), 20)));
  }
}

TEST(PartField, FacesOfTurningSweeps) {
  StockShape shape;
  shape.kind = StockShape::Kind::cylinder;
  shape.outer_radius = 25;
  shape.box = {{-25, -25, 0}, {25, 25, 51}};
  Tool tool;
  tool.type = ToolType::turning;
  tool.insert_angle = radians(35);
  tool.lead_angle = radians(93);
  tool.edge_length = 16;
  for (const double nose : {0.0, 0.4}) {
    tool.nose_radius = nose;
    const std::vector<Motion> motions{
        line({-1, 0, 50}, {10, 0, 50}), arc({10, 0, 50}, {10, 0, 45}, {0, 1, 0}, 5, kPi / 2, 0),
        line({15, 0, 45}, {15, 0, 31}), arc({15, 0, 31}, {21, 0, 31}, {0, 1, 0}, 6, -kPi / 2, 0),
        line({21, 0, 25}, {26, 0, 25})};
    expect_faces_agree(PartField(StockSolid(shape), SweepTable(motions, std::span(&tool, 1), 51)));
  }
}

// Arcs that meet their neighbours in corners: there the nose leaves its own circle on the part.
TEST(PartField, NamesTurningSweepsAndKnowsTurnedParts) {
  Tool tool;
  tool.type = ToolType::turning;
  tool.insert_angle = radians(35);
  tool.lead_angle = radians(93);
  tool.edge_length = 16;
  tool.nose_radius = 0.4;
  std::vector<Motion> motions;
  for (int i = 0; i < 40; ++i)
    motions.push_back(
        line({20 + 0.2 * (i % 2), 0, 50.0 - i}, {20 + 0.2 * (1 - i % 2), 0, 49.0 - i}));
  StockShape shape;
  shape.kind = StockShape::Kind::cylinder;
  shape.outer_radius = 25;
  shape.box = {{-25, -25, 0}, {25, 25, 51}};
  const PartField field(StockSolid(shape), SweepTable(motions, std::span(&tool, 1), 51));
  const Candidates all = field.all();
  EXPECT_TRUE(field.is_turned(all));
  EXPECT_FALSE(field.is_turned(std::vector<std::uint32_t>{0}));
  Candidates list, names;
  for (const double z : {15.2, 30.0, 44.9}) {
    const Vec3 center{12, 16, z};
    ASSERT_EQ(field.restrict_to(center, 0.5, 1e-5, all, list), ExactField::Region::mixed);
    ASSERT_TRUE(field.by_name(center, 0.5, 1e-5, list, names));
    ASSERT_LE(names.size(), 8u);
    for (int k = -4; k <= 4; ++k) {
      const Vec3 p = center + Vec3{0.05 * k, -0.05 * k, 0.08 * k};
      const FieldSample s = field.sample(p, list);
      EXPECT_EQ(s.distance, field.sample(p, names).distance);
      const std::uint32_t alone = field.candidate(s.owner);
      EXPECT_EQ(s.distance, field.sample(p, {&alone, 1}).distance);
    }
  }
}

TEST(PartField, FacesOfArcsThatBeginAndEndInCorners) {
  StockShape shape;
  shape.kind = StockShape::Kind::cylinder;
  shape.outer_radius = 12;
  shape.box = {{-12, -12, 0}, {12, 12, 20}};
  Tool tool;
  tool.type = ToolType::turning;
  tool.insert = "D";
  for (const double nose : {0.4, 0.8}) {
    tool.nose_radius = nose;
    const std::vector<Motion> motions{
        line({4, 0, 21}, {4.68, 0, 19.5}),
        arc({4.68, 0, 19.5}, {4.68, 0, 17.5}, {0, 1, 0}, 2, kPi / 2, 0),
        arc({6.68, 0, 17.5}, {6.68, 0, 14.5}, {0, 1, 0}, 3, kPi / 2, 0),
        arc({9.68, 0, 13}, {12.68, 0, 13}, {0, 1, 0}, 3, -kPi / 2, 0)};
    expect_faces_agree(PartField(StockSolid(shape), SweepTable(motions, std::span(&tool, 1), 20)));
  }
}

}  // namespace
}  // namespace mrsim
