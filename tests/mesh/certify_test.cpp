// What a tolerance costs where short moves end at the stock's sides, and that bounds hold there.
#include "core/units.h"
#include "core/vec.h"
#include "mesh/contour.h"
#include "mesh/contour_certify.h"
#include "removal/part_field.h"
#include "support/analytic_field.h"
#include "support/mesh_asserts.h"
#include "support/moves.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;
using test::line;

ContourReport report_of(const PartField& field, double tolerance) {
  MeshOptions options;
  options.tolerance = tolerance;
  ContourReport report;
  expect_closed_manifold(contour(field, 0.4, options, &report));
  EXPECT_LE(report.bound, tolerance);
  return report;
}

// Rows of loops of short moves, as adaptive clearing makes them: where their walls meet the side of
// the stock, tips of thin material end on the floor.
TEST(Certify, LoopsThatLeaveTheStockTakeFewCells) {
  StockShape shape;
  shape.box = {{0, 0, 0}, {20, 24, 12}};
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
  const PartField field(StockSolid(shape), SweepTable(motions, std::span(&tool, 1), 12));
  const ContourReport report = report_of(field, 0.034);
  EXPECT_LE(report.passes, 8u);
  EXPECT_LE(report.cells, 1000u);
}

}  // namespace
}  // namespace mrsim
