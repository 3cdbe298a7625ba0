// Edges sharper than cells can see: the wedge's end passes between the edges of the grid.
#include "core/numbers/units.h"
#include "mesh/mesh_part.h"
#include "mesh/surface/dual_surface.h"
#include "removal/part/part_field.h"
#include "support/cgal_mesh.h"
#include "support/mesh_asserts.h"
#include "support/moves.h"
#include "support/shapes.h"
#include "support/tools.h"

#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using testing::expect_closed_manifold;
using testing::line;
using testing::mill;

constexpr double kRidgeTolerance = 0.0034;

struct Part {
  TriMesh mesh;
  MeshReport report;
};

Part meshed(const std::vector<Motion>& cuts, const Tool& tool, double height, double voxel) {
  const StockShape shape = testing::box_stock({-10, -10, -height}, {10, 10, 0});
  const PartField field{StockSolid(shape), SweepTable(cuts, std::span(&tool, 1))};
  MeshPlan options;
  options.tolerance = kRidgeTolerance;
  Part part;
  part.mesh = mesh_part(field, voxel, options, &part.report);
  return part;
}

void expect_sharp(const Part& part, std::size_t most_triangles, double volume) {
  EXPECT_LE(part.report.bound, kRidgeTolerance);
  EXPECT_TRUE(part.report.thin.empty());
  EXPECT_LE(part.mesh.triangles.size(), most_triangles);
  expect_closed_manifold(part.mesh);
  EXPECT_EQ(testing::self_intersections(part.mesh), 0U);
  if (volume > 0) {
    EXPECT_NEAR(check_mesh(part.mesh).volume, volume, 1e-3 * volume);
  }
}

// Grooves of an engraving cutter, deeper than the flank is wide, that run out at both sides; their
// bottoms are as sharp as the tip, and so are the ridges between them.
TEST(Ridge, BottomsOfEngravedGroovesAreSharp) {
  constexpr double kDepth = 3;
  for (const double tip : {15.0, 30.0, 45.0, 60.0, 90.0}) {
    Tool tool = mill(ToolType::chamfer, 20);
    tool.tip_angle = tip * kPi / 180;
    const Vec3 from{-22, -8.5, -kDepth}, to{22, 9.5, -kDepth};
    const double half = kDepth * std::tan(tool.tip_angle / 2);
    // A strip of that direction over the block, and the wedge of its cross section.
    const double slope = (to.y - from.y) / (to.x - from.x);
    const double volume = 20.0 * 20 * 5 - half * kDepth * 20 * std::sqrt(1 + slope * slope);
    SCOPED_TRACE(tip);
    expect_sharp(meshed({line(from, to)}, tool, 5, 0.1), 200, volume);
  }
}

TEST(Ridge, WedgesBetweenGroovesAreSharp) {
  for (const double tip : {30.0, 45.0, 60.0}) {
    Tool tool = mill(ToolType::chamfer, 6);
    tool.tip_angle = tip * kPi / 180;
    SCOPED_TRACE(tip);
    expect_sharp(meshed({line({-12, -5, -3}, {12, 5, -3}), line({-12, -4, -3}, {12, 6, -3}),
                         line({-12, -3, -3}, {12, 7.3, -3})},
                        tool, 5, 0.1),
                 600, 0);
  }
}

// The bottoms of two grooves cross in a point, about which a smallest cell holds two pieces of
// surface, both with that point.
TEST(Ridge, BottomsOfGroovesMayCrossInAPoint) {
  Tool tool = mill(ToolType::chamfer, 6);
  tool.tip_angle = kPi / 4;
  const std::vector<Motion> cuts{line({-5.918, 3.77, -1}, {-3.536, 3.181, -1}),
                                 line({-5.035, 2.693, -1}, {-5.562, 5.101, -1})};
  const StockShape shape = testing::box_stock({-20, -20, -5}, {20, 20, 0});
  const PartField field{StockSolid(shape), SweepTable(cuts, std::span(&tool, 1))};
  MeshPlan options;
  options.tolerance = 0.0068;
  MeshReport report;
  const TriMesh mesh = mesh_part(field, 0.1, options, &report);
  EXPECT_LE(report.bound, options.tolerance);
  expect_closed_manifold(mesh);
  EXPECT_EQ(testing::self_intersections(mesh), 0U);
}

// A tip that just reaches the stock's underside leaves two edges on one line: no closed mesh has
// both, and cells were split all along them.
constexpr double kPlate = 3;  // mm: its thickness

Tool v_bit() {
  Tool tool = mill(ToolType::chamfer, 10);
  tool.tip_angle = kPi / 2;
  return tool;
}

TEST(Ridge, EdgesOnOneLineAreKeptApart) {
  const double volume = 400 * kPlate - 20 * kPlate * kPlate;
  for (const double x : {0.0, 0.7})
    expect_sharp(meshed({line({x, -15, -kPlate}, {x, 15, -kPlate})}, v_bit(), kPlate, 0.1), 100,
                 volume);
}

TEST(Ridge, EdgesOnOneCircleAreKeptApart) {
  Motion circle = line({5, 0, -kPlate}, {5, 0, -kPlate});
  circle.kind = MotionKind::arc;
  circle.center = {0, 0, -kPlate};
  circle.radius = 5;
  circle.sweep = kTwoPi;
  const double volume = 400 * kPlate - kTwoPi * 5 * kPlate * kPlate;
  expect_sharp(meshed({circle}, v_bit(), kPlate, 0.1), 20000, volume);
}

// The tooth of a form leaves a burr of 26 degrees below the stock's top.
Tool tooth() {
  Tool tool = mill(ToolType::form, 0);
  tool.profile = {{0, 0, 0}, {4, 0, 0}, {5, 0.5, 0}, {4, 1, 0}, {4, 20, 0}};
  return tool;
}

TEST(Ridge, BurrsBesideObliqueCutsAreSharp) {
  expect_sharp(meshed({line({-20, -11, -0.8}, {20, 9, -0.8})}, tooth(), 3, 0.2), 400, 0);
}

// Half a turn of radius 3 about the stock's middle.
Motion half_turn(double z, double rise) {
  Motion arc = line({3, 0, z}, {-3, 0, z + rise});
  arc.kind = MotionKind::arc;
  arc.center = {0, 0, z};
  arc.radius = 3;
  arc.sweep = kPi;
  arc.rise = rise;
  return arc;
}

TEST(Ridge, BurrsBesideArcsAreSharp) {
  const Motion arc = half_turn(-0.8, 0);
  expect_sharp(meshed({arc}, tooth(), 3, 0.2), 2000, 0);
}

// The corner where the tooth meets the shaft points inwards: each side of it is drawn by a solid of
// its own, which must not know of the other.
TEST(Ridge, CrestsOfMilledThreadsAreSharp) {
  const Motion helix = half_turn(-2, 0.5);
  const StockShape shape = testing::box_stock({-10, -10, -3}, {10, 10, 0});
  const Tool tool = tooth();
  const PartField field{StockSolid(shape), SweepTable(std::span(&helix, 1), std::span(&tool, 1))};
  MeshPlan options;
  options.tolerance = 0.02;
  MeshReport report;
  const TriMesh mesh = mesh_part(field, 0.5, options, &report);
  EXPECT_LE(report.bound, options.tolerance);
  EXPECT_LE(mesh.triangles.size(), 3000U);
  expect_closed_manifold(mesh);
}

// Crossings are kept from round to round by their edges: of the smallest cells, too.
TEST(Ridge, EdgesOfAllLengthsHaveKeysOfTheirOwn) {
  std::set<std::uint64_t> keys;
  std::size_t count = 0;
  for (const std::int32_t length : {1, 2, 4, 8})
    for (std::int32_t x = 0; x < 16; x += length)
      for (std::int32_t y = 0; y < 16; y += length)
        for (std::int32_t z = 0; z < 16; z += length)
          for (const std::int8_t axis : {0, 1, 2}) {
            detail::MinimalEdge edge;
            edge.start = {x, y, z};
            edge.length = length;
            edge.axis = axis;
            keys.insert(detail::edge_key(edge));
            ++count;
          }
  EXPECT_EQ(keys.size(), count);
}

}  // namespace
}  // namespace mrsim
