#include "removal/part/part_field.h"

#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "removal/part/stock.h"
#include "support/moves.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/tools.h"

#include <random>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using testing::arc;
using testing::line;

bool is_face_at(const PartField& field, const Vec3& p, const FieldSample& face) {
  const FieldSample at = field.sample(p, field.all());
  return at.owner == face.owner && at.patch == face.patch;
}

// Newton's method by face_plane leads to where patch_distance is 0, with the same normal.
void expect_same_surface(const PartField& field, Vec3 p, const FieldSample& at) {
  for (int k = 0; k < 12; ++k) {
    const FacePlane plane = field.face_plane(p, at);
    EXPECT_NEAR(length(plane.normal), 1, 1e-9);
    p = p - plane.distance * plane.normal;
  }
  if (!is_face_at(field, p, at)) return;
  EXPECT_NEAR(field.patch_distance(p, at), 0, 1e-9)
      << "owner " << at.owner << " patch " << at.patch;
  EXPECT_LT(distance(field.face_plane(p, at).normal, field.gradient(p, at)), 1e-6)
      << "owner " << at.owner << " patch " << at.patch;
}

// At random points near the surface: gradient has unit length and is the numeric gradient of
// patch_distance, and patch_distance is d where the face is the nearest one.
void expect_faces_agree(const PartField& field) {
  std::mt19937_64 random(testing::salted(11));
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
    if (std::abs(at.distance) < 0.1) expect_same_surface(field, p, at);
  }
  EXPECT_GT(faces, 100);
}

TEST(PartField, FacesOfMillingSweepsAgreeWithTheDistance) {
  const StockShape shape = testing::box_stock({0, 0, 0}, {40, 40, 20});
  for (const Tool& tool : {testing::endmill(6), testing::ballmill(6)}) {
    const std::vector<Motion> motions{
        line({-5, 10, 12}, {45, 14, 12}),                            // level
        line({5, 30, 18}, {35, 32, 8}),                              // slanted
        arc({30, 20, 10}, {22, 20, 10}, {0, 0, 1}, kPi),             // horizontal arc
        arc({12, 34, 16}, {8, 34, 16}, {0, 0, 1}, -2 * kTwoPi, -6),  // helix
    };
    expect_faces_agree(PartField(StockSolid(shape), SweepTable(motions, std::span(&tool, 1))));
  }
}

// Beyond the foot of the wall the wall is a cylinder about the path in plan, the floor a surface of
// its own: both continuations are needed where a mesh looks for their crease.
TEST(PartField, WallAndFloorOfRampsGoOnByThemselves) {
  const StockShape shape = testing::box_stock({0, 0, 0}, {40, 40, 20});
  Tool tool;
  tool.diameter = 6;
  const std::vector<Motion> motions{line({5, 10, 18}, {35, 10, 15}),
                                    arc({28, 26, 18}, {20, 26, 18}, {0, 0, 1}, 5.0, -4)};
  for (const Motion& m : motions) {
    const PartField field(StockSolid(shape), SweepTable(std::span(&m, 1), std::span(&tool, 1)));
    const bool is_arc = m.kind == MotionKind::arc;
    const auto to_path = [&](const Vec3& p) {
      return is_arc ? std::abs(std::hypot(p.x - 20, p.y - 26) - 8) : std::abs(p.y - 10);
    };
    const Vec3 middle =
        is_arc ? Vec3{20 + 8 * std::cos(2.0), 26 + 8 * std::sin(2.0), 16.4} : Vec3{20, 10, 16.5};
    const Vec3 out = is_arc ? Vec3{std::cos(2.0), std::sin(2.0), 0} : Vec3{0, 1, 0};
    const FieldSample wall = field.sample(middle + 3.001 * out + Vec3{0, 0, 0.5}, field.all());
    const FieldSample floor = field.sample(middle + 2.0 * out + Vec3{0, 0, -0.3}, field.all());
    ASSERT_FALSE(wall.owner == floor.owner && wall.patch == floor.patch);
    for (double v = -2.9; v < 2.95; v += 0.1) {
      const Vec3 p = middle + v * out + Vec3{0, 0, -0.2};
      EXPECT_NEAR(field.patch_distance(p, wall), 3 - to_path(p), 1e-9) << v;
      EXPECT_NEAR(std::abs(field.gradient(p, wall).z), 0, 1e-12) << v;
      EXPECT_GT(field.face_plane(p, floor).normal.z, 0.05) << v;
    }
  }
}

// The floor of a slight slope is the lower half of a sheared cylinder some micrometres thick: seen
// from above and below, over the path and beside it, Newton's method leads to one surface.
TEST(PartField, FloorsOfSlightSlopesAreFound) {
  const StockShape shape = testing::box_stock({0, 0, 0}, {40, 40, 20});
  Tool vee = testing::mill(ToolType::chamfer, 6);
  vee.tip_angle = radians(90), vee.tip_diameter = 0.4;
  const std::vector<Motion> motions{line({5, 10, 15.1}, {35, 10, 15}),
                                    arc({28, 26, 15}, {20, 26, 15}, {0, 0, 1}, 5.0, -0.1)};
  for (const Motion& m : motions) {
    const PartField field(StockSolid(shape), SweepTable(std::span(&m, 1), std::span(&vee, 1)));
    const bool is_arc = m.kind == MotionKind::arc;
    const Vec3 out = is_arc ? Vec3{std::cos(2.0), std::sin(2.0), 0} : Vec3{0, 1, 0};
    const Vec3 middle = is_arc ? Vec3{20, 26, 15 - 0.2 / 5} + 8 * out : Vec3{20, 10, 15.05};
    const FieldSample floor = field.sample(middle + Vec3{0, 0, -0.05}, field.all());
    for (double v = -0.29; v < 0.3; v += 0.02)
      for (const double up : {-0.1, -0.01, -0.001, 0.001, 0.01, 0.1}) {
        const Vec3 start = middle + v * out + Vec3{0, 0, up};
        Vec3 p = start;
        FacePlane plane;
        for (int k = 0; k < 12; ++k) {
          plane = field.face_plane(p, floor);
          p = p - plane.distance * plane.normal;
        }
        EXPECT_GT(plane.normal.z, 0.9) << is_arc << ' ' << v << ' ' << up;
        EXPECT_LT(distance(p, start), 0.11) << is_arc << ' ' << v << ' ' << up;
        if (std::abs(v) < 0.2) {
          EXPECT_NEAR(field.sample(p, field.all()).distance, 0, 1e-8)
              << is_arc << ' ' << v << ' ' << up;
        }
      }
  }
}

TEST(PartField, FacesOfTurningSweepsAgreeWithTheDistance) {
  const StockShape shape = testing::round_stock(25, 0, 0, 51);
  Tool tool;
  tool.type = ToolType::turning;
  tool.insert_angle = radians(35);
  tool.lead_angle = radians(93);
  tool.edge_length = 16;
  for (const double nose : {0.0, 0.4}) {
    tool.nose_radius = nose;
    const std::vector<Motion> motions{
        line({-1, 0, 50}, {10, 0, 50}), arc({10, 0, 50}, {10, 0, 45}, {0, 1, 0}, kPi / 2),
        line({15, 0, 45}, {15, 0, 31}), arc({15, 0, 31}, {21, 0, 31}, {0, 1, 0}, -kPi / 2),
        line({21, 0, 25}, {26, 0, 25})};
    expect_faces_agree(PartField(StockSolid(shape), SweepTable(motions, std::span(&tool, 1))));
  }
}

// Arcs that meet their neighbours in corners: there the nose leaves its own circle on the part.
// A drill on the axis leaves the part turned, one beside it or across it does not.
TEST(PartField, KnowsWhichDrilledPartsAreTurned) {
  Tool drill;
  drill.type = ToolType::drill;
  drill.diameter = 6;
  const StockShape shape = testing::round_stock(25, 0, 0, 51);
  const auto is_turned = [&](Motion m) {
    const PartField field(StockSolid(shape), SweepTable({&m, 1}, std::span(&drill, 1)));
    return field.is_turned(field.all());
  };
  EXPECT_TRUE(is_turned(line({0, 0, 60}, {0, 0, 20})));
  EXPECT_FALSE(is_turned(line({10, 0, 60}, {10, 0, 20})));
  EXPECT_FALSE(is_turned(line({0, 0, 60}, {1, 0, 20})));
  Motion across = line({0, 0, 60}, {0, 0, 20});
  across.tool_axis = {1, 0, 0};
  EXPECT_FALSE(is_turned(across));
}

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
  const StockShape shape = testing::round_stock(25, 0, 0, 51);
  const PartField field(StockSolid(shape), SweepTable(motions, std::span(&tool, 1)));
  const Candidates all = field.all();
  EXPECT_TRUE(field.is_turned(all));
  EXPECT_TRUE(field.is_turned(std::vector<std::uint32_t>{0}));
  Candidates list, names;
  for (const double z : {15.2, 30.0, 44.9}) {
    const Vec3 center{12, 16, z};
    const Vec3 half{0.35, 0.35, 0.35};
    const Box3 box{center - half, center + half};
    ASSERT_EQ(field.restrict_to(box, 1e-5, all, list), ExactField::Region::mixed);
    ASSERT_TRUE(field.expand_packs(box, 1e-5, list, names));
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
  const StockShape shape = testing::round_stock(12, 0, 0, 20);
  Tool tool;
  tool.type = ToolType::turning;
  tool.insert = "D";
  for (const double nose : {0.4, 0.8}) {
    tool.nose_radius = nose;
    const std::vector<Motion> motions{line({4, 0, 21}, {4.68, 0, 19.5}),
                                      arc({4.68, 0, 19.5}, {4.68, 0, 17.5}, {0, 1, 0}, kPi / 2),
                                      arc({6.68, 0, 17.5}, {6.68, 0, 14.5}, {0, 1, 0}, kPi / 2),
                                      arc({9.68, 0, 13}, {12.68, 0, 13}, {0, 1, 0}, -kPi / 2)};
    expect_faces_agree(PartField(StockSolid(shape), SweepTable(motions, std::span(&tool, 1))));
  }
}

// Whether a point is on the surface is told as by its distance, for tools of every kind of sweep:
// at random places, and at places that are moved there.
TEST(PartField, KnowsWhatIsOnTheSurface) {
  std::vector<Tool> tools(4);
  tools[0].type = ToolType::ballmill, tools[1].type = ToolType::endmill;
  tools[2].type = ToolType::chamfer, tools[2].tip_angle = radians(60);
  tools[3].type = ToolType::bullmill, tools[3].corner_radius = 0.7;
  for (Tool& tool : tools) tool.diameter = 5;
  std::mt19937_64 random(testing::salted(6));
  std::uniform_real_distribution<double> u(-1, 1);
  std::vector<Motion> motions;
  for (int k = 0; k < 60; ++k) {
    motions.push_back(line({6 * u(random), 6 * u(random), u(random)},
                           {6 * u(random), 6 * u(random), k % 3 == 0 ? 0 : u(random)}));
    motions.back().tool = k % 4;
  }
  motions.push_back(arc({3, 0, -0.5}, {0, 0, -0.5}, {0, 0, 1}, 5));
  const StockShape shape = testing::box_stock({-8, -8, -5}, {8, 8, 3});
  const PartField field(StockSolid(shape), SweepTable(motions, tools));
  const Candidates all = field.all();
  unsigned on = 0, off = 0;
  for (int round = 0; round < 3000; ++round) {
    Vec3 p{8.5 * u(random), 8.5 * u(random), 4 * u(random) - 1};
    for (int k = 0; k < 4; ++k) {
      const FieldSample at = field.sample(p, all);
      for (const double tolerance : {1e-9, 1e-3, 0.5}) {
        const bool is_on = std::fabs(at.distance) <= tolerance;
        ASSERT_EQ(field.is_on_surface(p, all, tolerance), is_on) << at.distance;
        ++(is_on ? on : off);
      }
      const FacePlane plane = field.face_plane(p, at);
      p = p - plane.distance * plane.normal;
    }
  }
  EXPECT_GT(on, 3000u);
  EXPECT_GT(off, 3000u);
  EXPECT_TRUE(field.is_on_surface({8, 0, -4}, {}, 1e-9)) << "the stock alone";
  EXPECT_FALSE(field.is_on_surface({8.1, 0, -4}, {}, 0.01));
}

// A cube is told from what the surface passes by its shape, not by the ball about it, and never
// wrongly.
TEST(PartField, CubesBesideTheSurfaceAreAirOrMaterial) {
  std::mt19937_64 random(testing::salted(5));
  std::uniform_real_distribution<double> u(-1, 1);
  std::vector<Motion> motions;
  for (int row = 0; row < 9; ++row)
    for (int k = -20; k < 20; ++k) {
      const auto at = [&](int i) {
        return Vec3{0.25 * i, 0.4 * row - 1.6, 0.3 * std::sin(0.6 * i) + 0.05 * row};
      };
      motions.push_back(line(at(k), at(k + 1)));
    }
  Tool ball;
  ball.type = ToolType::ballmill;
  ball.diameter = 4;
  const StockShape shape = testing::box_stock({-5, -5, -4}, {5, 5, 2});
  const PartField field(StockSolid(shape), SweepTable(motions, {&ball, 1}));
  const Candidates all = field.all();
  Candidates left;
  constexpr double kHalf = 0.1, kBand = 1e-3, kRadius = kHalf * 1.7320508075688774;
  int decided = 0, beside = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 c{5.2 * u(random), 5.2 * u(random), -1 + 3.2 * u(random)};
    const double d = field.sample(c, all).distance;
    if (std::abs(d) > kRadius + kBand || std::abs(d) < kHalf) continue;
    ++beside;  // where the ball about the cube meets the surface
    const auto region = field.restrict_to(
        {c - Vec3{kHalf, kHalf, kHalf}, c + Vec3{kHalf, kHalf, kHalf}}, kBand, all, left);
    if (region == ExactField::Region::mixed) continue;
    ++decided;
    for (int k = 0; k < 27; ++k) {
      const Vec3 corner{kHalf * (k % 3 - 1), kHalf * (k / 3 % 3 - 1), kHalf * (k / 9 - 1)};
      const double there = field.sample(c + corner, all).distance;
      ASSERT_GT(region == ExactField::Region::air ? there : -there, kBand);
    }
  }
  EXPECT_GT(beside, 500);
  EXPECT_GT(decided, beside / 3);
}

// Flutes that end above the stock are as good as endless ones; shorter ones leave what is above.
TEST(PartField, FlutesThatReachAboveTheStockReachUp) {
  const StockShape block = testing::box_stock({0, 0, -10}, {30, 20, 0});
  std::vector<Motion> motions{line({5, 10, -8}, {25, 12, -3}), line({5, 10, -8}, {5, 10, -1})};
  motions.push_back(arc({18, 10, -2}, {15, 10, -2}, {0, 0, 1}, 2 * kTwoPi, -4 / (2 * kTwoPi)));
  for (Motion& m : motions) m.tool = 0;
  const auto part = [&](double flutes) {
    Tool mill;
    mill.id.assign(1, '1');  // GCC 12 warns of overlap on = "1"
    mill.type = ToolType::bullmill;
    mill.diameter = 4;
    mill.corner_radius = 0.5;
    mill.flute_length = flutes;
    return carve(block, motions, std::vector<Tool>{mill}, {.voxel = 0.5});
  };
  const Stock endless = part(0), above = part(8), below = part(4);
  const auto at = [](const Stock& stock, const Vec3& p) {
    return stock.field().sample(p, stock.field().all()).distance;
  };
  std::mt19937_64 random(testing::salted(3));
  std::uniform_real_distribution<double> u(0, 1);
  int overhung = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec3 p{30 * u(random), 20 * u(random), -10 * u(random)};
    ASSERT_EQ(at(endless, p), at(above, p)) << p.x << " " << p.y << " " << p.z;
    overhung += at(below, p) < -0.1 && at(endless, p) > 0.1 ? 1 : 0;
  }
  EXPECT_GT(overhung, 10);
}

}  // namespace
}  // namespace mrsim
