// What a tolerance costs where short moves end at the stock's sides, and that bounds hold there.
#include "mesh/simplify/triangle_bounds.h"

#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "mesh/mesh_part.h"
#include "removal/part/part_field.h"
#include "support/analytic_field.h"
#include "support/mesh_asserts.h"
#include "support/moves.h"
#include "support/random.h"
#include "support/shapes.h"

#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;
using testing::line;

MeshReport report_of(const PartField& field, double tolerance) {
  MeshPlan options;
  options.tolerance = tolerance;
  MeshReport report;
  expect_closed_manifold(mesh_part(field, 0.4, options, &report));
  EXPECT_LE(report.bound, tolerance);
  return report;
}

// Two slots whose walls turn by 5 degrees, and a triangle over both with a side in the plane of the
// block's top: d = 0 all along it, and yet it is off the walls by its sagitta.
TEST(Certify, SideOnACreaseIsMeasuredFromTheCrease) {
  constexpr double kTop = 10, kLength = 1, kRadius = 1;
  const double turn = radians(5), sagitta = kLength * std::sin(turn / 2);
  const Vec2 bend{10, 10}, along{std::cos(turn), std::sin(turn)};
  const AnalyticField part(
      {{0, 0, 0}, {20, 20, kTop}}, false,
      {flat_line({2, 10}, bend, kRadius, 5), flat_line(bend, bend + 8 * along, kRadius, 5)});
  const detail::CellOctree tree(part, detail::Lattice(part.bounds(), 0.5, 4), 0.1, 1);
  const Vec3 edge{bend.x - kRadius * std::tan(turn / 2), bend.y + kRadius, kTop};
  const Vec3 a = edge - Vec3{kLength, 0, 0}, b = edge + kLength * Vec3{along.x, along.y, 0};
  for (const double height : {0.3, 1.0, 3.0}) {
    const Vec3 c = edge - Vec3{0, 0, height};
    detail::FaceDistances distances(part);
    const double bound = detail::part_bound(distances, tree, b, a, c, 0.1);
    EXPECT_GE(bound, 0.999 * sagitta) << height;
    EXPECT_LE(bound, 2 * sagitta) << height;
    EXPECT_GT(detail::part_bound(distances, tree, b, a, c, 0.9 * sagitta), 0.9 * sagitta);
  }
}

// More places than are remembered, each asked for twice in a row and again at the end.
TEST(Certify, RememberedDistancesAreThoseOfTheField) {
  const AnalyticField part({{0, 0, 0}, {20, 20, 10}}, false, {flat_line({2, 10}, {18, 12}, 3, 5)});
  detail::FaceDistances distances(part);
  Random r(5);
  std::vector<std::pair<Vec3, FieldSample>> asked;
  for (int k = 0; k < 20000; ++k) {
    const Vec3 p{r(0, 20), r(0, 20), r(0, 10)};
    asked.emplace_back(p, part.sample({r(0, 20), r(0, 20), r(0, 10)}, {}));
    const double want = part.patch_distance(p, asked.back().second);
    ASSERT_EQ(distances(p, asked.back().second), want);
    ASSERT_EQ(distances(p, asked.back().second), want);
  }
  for (const auto& [p, face] : asked) ASSERT_EQ(distances(p, face), part.patch_distance(p, face));
}

// Rows of loops of short moves, as adaptive clearing makes them: where their walls meet the side of
// the stock, tips of thin material end on the floor.
TEST(Certify, LoopsThatLeaveTheStockTakeFewCells) {
  const StockShape shape = box_stock({0, 0, 0}, {20, 24, 12});
  Tool tool;
  tool.type = ToolType::endmill;
  tool.diameter = 10;
  std::vector<Motion> motions;
  for (const double y : {4.0, 12.0, 20.0}) {
    Vec3 last{4, y, 6};
    for (int i = 1; i <= 20; ++i) {
      const double turn = kTwoPi * i / 20;
      const Vec3 next{2.0 * i + 4 * std::cos(turn), y + 4 * std::sin(turn), 6};
      motions.push_back(line(last, next));
      last = next;
    }
  }
  const PartField field(StockSolid(shape), SweepTable(motions, std::span(&tool, 1)));
  const MeshReport report = report_of(field, 0.034);
  EXPECT_LE(report.passes, 8u);
  EXPECT_LE(report.cells, 1000u);
  EXPECT_TRUE(report.thin.empty());
}

}  // namespace
}  // namespace mrsim
