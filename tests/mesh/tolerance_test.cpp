// The bound that is reported, against dense samples of every triangle: random tools and moves, and
// places where a face ends or its curvature changes within a triangle.
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "mesh/mesh_part.h"
#include "mesh/solid/check.h"
#include "removal/part/part_field.h"
#include "support/field_distance.h"
#include "support/moves.h"
#include "support/random.h"
#include "support/rounds.h"
#include "support/shapes.h"
#include "support/tools.h"

#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using testing::line;
using testing::mill;

constexpr double kFloats = 1e-5;  // mm: coordinates of the corners

Motion arc(Vec3 center, double radius, double from, double sweep) {
  const Vec3 start = center + radius * Vec3{std::cos(from), std::sin(from), 0};
  return testing::arc(start, center, {0, 0, 1}, sweep);
}

// The report of a mesh of these moves in a block of 20 x 20 x 8 mm.
MeshReport expect_bound_holds(const std::vector<Motion>& motions, const Tool& tool,
                              double tolerance, const std::string& what) {
  const StockShape shape = testing::box_stock({0, 0, 0}, {20, 20, 8});
  const PartField field(StockSolid(shape), SweepTable(motions, std::span(&tool, 1)));
  MeshPlan options;
  options.tolerance = tolerance;
  MeshReport report;
  const TriMesh mesh = mesh_part(field, 0.5, options, &report);
  EXPECT_LE(testing::largest_distance(field, mesh), report.bound + kFloats) << what;
  if (report.unresolved == 0) {
    EXPECT_LE(report.bound, tolerance) << what;
  }
  return report;
}

Tool random_mill(std::mt19937_64& random) {
  std::uniform_real_distribution<double> u(0, 1);
  switch (random() % 5) {
    case 0:
      return mill(ToolType::endmill, 2 + 4 * u(random));
    case 1:
      return mill(ToolType::ballmill, 2 + 4 * u(random));
    case 2: {
      Tool tool = mill(ToolType::bullmill, 3 + 3 * u(random));
      tool.corner_radius = 0.2 + 0.9 * u(random);
      return tool;
    }
    case 3: {
      Tool tool = mill(ToolType::drill, 2 + 4 * u(random));
      tool.tip_angle = radians(60 + 80 * u(random));
      return tool;
    }
    default: {
      Tool tool = mill(ToolType::chamfer, 4 + 3 * u(random));
      tool.tip_angle = radians(90), tool.tip_diameter = 1;
      return tool;
    }
  }
}

TEST(Tolerance, BoundHoldsOnRandomPrograms) {
  std::mt19937_64 random(testing::salted(5));
  std::uniform_real_distribution<double> u(0, 1);
  for (unsigned k = 0; k < testing::rounds(10); ++k) {
    const Tool tool = random_mill(random);
    const auto at = [&](double z) { return Vec3{20 * u(random), 20 * u(random), z}; };
    std::vector<Motion> motions;
    for (int m = 0; m < 4; ++m) {
      const double z = 4 + 3 * u(random);
      const Vec3 a = at(z);
      if (m == 0) motions.push_back(line({a.x, a.y, 9}, a));
      if (m == 1) motions.push_back(line(a, at(z)));
      if (m == 2) motions.push_back(line(a, at(4 + 3 * u(random))));
      if (m == 3)
        motions.push_back(arc(a, 0.5 + 8 * u(random), kTwoPi * u(random), 6 * u(random) + 0.2));
    }
    const double tolerance = k % 2 ? 0.02 : 0.005;
    expect_bound_holds(motions, tool, tolerance, "program " + std::to_string(k));
  }
}

// In the air |d| may be less than the distance from the part: within a ramp that a flat mill has
// cut, and beside sharp edges, as where a flank leaves the stock.
void expect_material_is_near(const PartField& field, double voxel, double tolerance) {
  MeshPlan options;
  options.tolerance = tolerance;
  MeshReport report;
  const TriMesh mesh = mesh_part(field, voxel, options, &report);
  const auto vec = [&](std::uint32_t v) {
    const auto& x = mesh.vertices[v];
    return Vec3{x[0], x[1], x[2]};
  };
  double most = 0;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const Vec3 p = 0.5 * (vec(t[k]) + vec(t[(k + 1) % 3]));
      if (field.sample(p, field.all()).distance > 0.3 * report.bound)
        most = std::max(most, testing::distance_from_material(field, p));
    }
  EXPECT_LE(most, 1.002 * report.bound + kFloats);
}

TEST(Tolerance, HoldsWithinTheRampOfAFlatMill) {
  const Tool tool = mill(ToolType::endmill, 8.2633);
  const std::vector<Motion> ramp{line({15.93, 9.62, 20}, {15.93, 9.62, 4}),
                                 line({15.93, 9.62, 4}, {7.586, 16.04, 2.69})};
  const PartField field(StockSolid(testing::box_stock({0, 0, 0}, {20, 20, 8})),
                        SweepTable(ramp, std::span(&tool, 1)));
  for (const double tolerance : {0.005, 0.01, 0.02}) expect_material_is_near(field, 0.5, tolerance);
}

TEST(Tolerance, HoldsWhereAFlankLeavesTheStock) {
  Tool tool = mill(ToolType::chamfer, 11.9306);
  tool.tip_angle = radians(48), tool.tip_diameter = 6.7662;
  const std::vector<Motion> plunges{
      line({31.580453, 18.750454, 20}, {31.580453, 18.750454, -2.42579}),
      line({31.580453, 25.297256, 20}, {31.580453, 25.297256, -4.93497})};
  const StockShape stock = testing::box_stock({-1, 3, -7.1512}, {35.9932, 34.61, 0});
  const PartField field(StockSolid(stock), SweepTable(plunges, std::span(&tool, 1)));
  expect_material_is_near(field, 0.1, 0.00628883);
}

// The floor of a flat mill turns into the wall within half a micron: a crease, not a face to
// refine.
TEST(Tolerance, RampsOfFlatMillsTakeFewCells) {
  Motion helix = arc({10, 10, 7}, 6, 0, 1.6 * kPi);
  helix.rise = -2, helix.end.z -= 2;
  const std::pair<Motion, std::size_t> most[] = {{helix, 9000},
                                                 {line({3, 6, 7}, {17, 13, 6}), 4500}};
  for (const auto& [m, cells] : most) {
    const MeshReport report = expect_bound_holds({m}, mill(ToolType::endmill, 4), 0.01, "ramp");
    EXPECT_EQ(report.unresolved, 0u);
    EXPECT_LT(report.cells, cells) << "rise " << m.rise;
  }
}

// What no sweep reaches of a plate takes cells of half its thickness, and few triangles, however
// small the voxel is. Of 1.6 mm, 64 voxels, they would be 100 000.
TEST(Tolerance, SidesOfAPlateTakeFewCells) {
  Tool vee = mill(ToolType::chamfer, 6);
  vee.tip_angle = radians(60);
  const std::vector<Motion> groove{line({20, 20, 9.85}, {24, 23, 9.85})};
  const double depth = 0.15, radius = depth * std::tan(radians(30));
  const double cone = kPi * radius * radius * depth / 3, wedge = radius * depth * 5;
  for (const double side : {40.0, 400.0}) {
    const StockShape plate = testing::box_stock({0, 0, 0}, {side, 0.75 * side, 10});
    const PartField part{StockSolid(plate), SweepTable(groove, std::span(&vee, 1))};
    MeshPlan options;
    options.tolerance = 0.05;
    MeshReport report;
    const TriMesh mesh = mesh_part(part, 0.025, options, &report);
    EXPECT_TRUE(check_mesh(mesh).closed) << side;
    EXPECT_LE(report.bound, 0.05) << side;
    EXPECT_LE(report.cells, 8000u) << side;
    EXPECT_LE(mesh.triangles.size(), 250u) << side;
    EXPECT_NEAR(7.5 * side * side - check_mesh(mesh).volume, wedge + cone, 0.05 * wedge) << side;
  }
}

// The tip's groove is a crease on a helix and on an arc in an upright plane, too.
TEST(Tolerance, CurvedGroovesTakeFewCells) {
  Tool vee = mill(ToolType::chamfer, 6);
  vee.tip_angle = radians(90);
  Motion helix = arc({10, 10, 7}, 6, 0, 1.6 * kPi);
  helix.rise = -2, helix.end.z -= 2;
  Motion trough = line({4, 10, 7}, {16, 10, 7});
  trough.kind = MotionKind::arc, trough.axis = {0, 1, 0};
  trough.center = {10, 10, 15}, trough.radius = 10, trough.sweep = -2 * std::asin(0.6);
  const std::pair<Motion, std::size_t> most[] = {{helix, 3600}, {trough, 1300}};
  for (const auto& [m, cells] : most) {
    const MeshReport report = expect_bound_holds({m}, vee, 0.01, "groove");
    EXPECT_EQ(report.unresolved, 0u);
    EXPECT_LT(report.cells, cells) << "rise " << m.rise;
  }
}

// Arcs of a few degrees, which end within triangles; arcs smaller than the tool, whose torus passes
// its own axis; cone tips; balls that begin and end in the material.
TEST(Tolerance, BoundHoldsWhereFacesEndWithinTriangles) {
  Tool bull = mill(ToolType::bullmill, 5);
  bull.corner_radius = 1;
  Tool drill = mill(ToolType::drill, 6);
  drill.tip_angle = radians(118);
  for (const Tool& tool : {mill(ToolType::endmill, 4), mill(ToolType::ballmill, 4), bull, drill}) {
    std::vector<Motion> chain, small, tips;
    for (int k = 0; k < 6; ++k) chain.push_back(arc({10, 10, 5}, 6, 0.1 * k, 0.1));
    for (const double radius : {0.3, 1.0, 1.9, 2.0, 2.1})
      small.push_back(arc({4 + 6 * radius, 10, 5}, radius, 0.3, 4));
    for (int k = 0; k < 3; ++k)
      tips.push_back(line({5.0 + 5 * k, 10, 9}, {5.0 + 5 * k, 10.1 * k, 4 + 0.1 * k}));
    const std::string name = "tool " + std::to_string(static_cast<int>(tool.type));
    expect_bound_holds(chain, tool, 0.01, name + ", chain of arcs");
    expect_bound_holds(small, tool, 0.01, name + ", small arcs");
    expect_bound_holds(tips, tool, 0.01, name + ", tips");
  }
}

// The bottom of a V-bit's groove is an edge of the mesh: no cells are small along it.
TEST(Tolerance, GroovesOfASharpTipTakeFewTriangles) {
  Tool vee = mill(ToolType::chamfer, 8);
  vee.tip_angle = kPi / 2;
  const StockShape shape = testing::box_stock({0, 0, 0}, {20, 20, 8});
  const Motion cut = line({-10, 9.7, 6}, {30, 9.7, 6});
  const PartField field(StockSolid(shape), SweepTable(std::span(&cut, 1), std::span(&vee, 1)));
  MeshPlan options;
  options.tolerance = 0.005;
  MeshReport report;
  const TriMesh mesh = mesh_part(field, 0.5, options, &report);
  EXPECT_LT(mesh.triangles.size(), 40u);
  EXPECT_LT(report.cells, 12000u);
  EXPECT_LT(report.bound, 1e-5);
  EXPECT_NEAR(check_mesh(mesh).volume, 20.0 * 20 * 8 - 20 * 4, 1e-3);
}

// Flat, ball and bull-nose mills on lines and horizontal arcs leave nothing to samples.
TEST(Tolerance, IsProvenOnLinesAndArcs) {
  Tool bull = mill(ToolType::bullmill, 5);
  bull.corner_radius = 1;
  const std::vector<Motion> motions{line({-5, 4, 6}, {25, 6, 6}), line({3, 12, 7}, {9, 15, 4}),
                                    arc({13, 12, 5}, 4, 0.4, 2.5)};
  for (const Tool& tool : {mill(ToolType::endmill, 4), mill(ToolType::ballmill, 4), bull})
    EXPECT_EQ(expect_bound_holds(motions, tool, 0.01, "lines and arcs").sampled, 0u);
}

// Small circles side by side leave cusps lower than the tolerance: what is taken off there may not
// turn the triangles of an upright wall out of the upright.
TEST(Tolerance, TrianglesLieAlongTheirFaces) {
  const Tool tool = mill(ToolType::endmill, 8);
  std::vector<Motion> motions;
  Vec3 at{60, 40, -12};
  for (int k = 0; k < 72; ++k) {
    const double t = kTwoPi * k / 24, r = 30.4 + k / 24 * 1.2 + 0.05 * (k % 24), x = std::cos(t),
                 y = std::sin(t);
    const Vec3 to{60 + r * x, 40 + 0.9 * r * y, -12};
    motions.push_back(line(at, to));
    motions.push_back(arc(to - 0.5 * Vec3{x, y, 0}, 0.5, t, -kPi));
    at = to - Vec3{x, y, 0};
  }
  const StockShape shape = testing::box_stock({0, 0, -20}, {120, 80, 0});
  const PartField field(StockSolid(shape), SweepTable(motions, std::span(&tool, 1)));
  MeshPlan options;
  options.tolerance = 0.0204;
  const TriMesh mesh = mesh_part(field, 0.5, options);
  for (const auto& t : mesh.triangles) {
    const auto corner = [&](int k) {
      const auto& v = mesh.vertices[t[static_cast<std::size_t>(k)]];
      return Vec3{v[0], v[1], v[2]};
    };
    const Vec3 n = cross(corner(1) - corner(0), corner(2) - corner(0));
    const double lean = std::abs(n.z) / length(n);
    EXPECT_TRUE(lean < 0.2 || lean > 0.98) << lean << " at " << corner(0).x << ' ' << corner(0).y;
  }
}

}  // namespace
}  // namespace mrsim
