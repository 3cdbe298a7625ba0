// What default settings stand on: the survey of the cut surface, the distance of a mesh on the
// voxels, and the grid that takes the place of a tolerance.
#include "core/numbers/units.h"
#include "core/process/error.h"
#include "mesh/cells/survey.h"
#include "mesh/mesh_part.h"
#include "mesh/solid/check.h"
#include "removal/part/part_field.h"
#include "support/field_distance.h"
#include "support/moves.h"
#include "support/shapes.h"
#include "support/tools.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using testing::ballmill;
using testing::endmill;
using testing::line;

// A slot along x through the middle of a block of 20 x 20 x 8 mm, 3 mm deep.
PartField slot(const Tool& tool) {
  const StockShape shape = testing::box_stock({0, 0, 0}, {20, 20, 8});
  const Motion cut = line({-10, 10, 5}, {30, 10, 5});
  return PartField(StockSolid(shape), SweepTable(std::span(&cut, 1), std::span(&tool, 1)));
}

// Walls and floor of a slot of Ø4: 20 * (4 + 2 * 3) mm^2.
TEST(DefaultMesh, SurveyTellsTheCutSurfaceWithinAFactorOfTwo) {
  const PartField field = slot(endmill(4));
  const double cells = 200 / 0.01;
  const detail::SurfaceSurvey survey = detail::survey_surface(field, field.all(), 2);
  EXPECT_GT(survey.cells(0.1), cells / 2);
  EXPECT_LT(survey.cells(0.1), cells * 2);
  EXPECT_EQ(detail::survey_surface(field, field.all(), 1).blocks, survey.blocks);
}

// Slots of Ø0.5 with walls of 0.4 mm between them, several in one block: each wall counts. A slot
// alone is told as well.
TEST(DefaultMesh, SurveyCountsEverySheetOfSurface) {
  const StockShape shape = testing::box_stock({0, 0, 0}, {40, 40, 8});
  std::vector<Motion> cuts;
  for (int k = 0; k < 40; ++k) cuts.push_back(line({-10, 1 + 0.9 * k, 3}, {50, 1 + 0.9 * k, 3}));
  const Tool narrow = endmill(0.5);
  const PartField slots{StockSolid(shape), SweepTable(cuts, std::span(&narrow, 1))};
  const double cells = 40 * 40 * (0.5 + 2 * 5) / 0.01;
  const double told = detail::survey_surface(slots, slots.all(), 2).crossed_cells(0.1);
  EXPECT_GT(told, 0.75 * cells);
  EXPECT_LT(told, 1.25 * cells);
  const PartField one = slot(endmill(4));
  EXPECT_NEAR(detail::survey_surface(one, one.all(), 2).crossed_cells(0.1), 200 / 0.01, 50 / 0.01);
}

// Slots and walls of 0.5 mm, many in one block.
TEST(DefaultMesh, CellsAsLargeAsGapsAndWallsTakeMore) {
  const StockShape shape = testing::box_stock({0, 0, 0}, {200, 200, 8});
  std::vector<Motion> cuts;
  for (int k = 0; k < 200; ++k) cuts.push_back(line({-10, 0.5 + k, 3}, {210, 0.5 + k, 3}));
  const Tool narrow = endmill(0.5);
  const PartField slots{StockSolid(shape), SweepTable(cuts, std::span(&narrow, 1))};
  const auto survey = detail::survey_surface(slots, slots.all(), 2);
  EXPECT_NEAR(survey.crossed_cells(0.05), 100 * survey.sheets * survey.cells(0.5), 1);
  EXPECT_GT(survey.crossed_cells(0.5), 1.5 * survey.sheets * survey.cells(0.5));
}

// Twenty pecks share a wall; twenty passes of a ball beside one another leave creases everywhere.
TEST(DefaultMesh, SurveyTellsSweepsThatLeaveCreases) {
  const StockShape shape = testing::box_stock({0, 0, 0}, {20, 20, 20});
  std::vector<Motion> pecks, passes;
  for (int k = 0; k < 20; ++k) {
    pecks.push_back(line({10, 10, 22.0 - k}, {10, 10, 19.0 - k}));
    passes.push_back(line({-5, 1.0 * k, 17}, {25, 1.0 * k, 17}));
  }
  const auto survey = [&](const std::vector<Motion>& motions, const Tool& tool) {
    const PartField field{StockSolid(shape), SweepTable(motions, std::span(&tool, 1))};
    return detail::survey_surface(field, field.all(), 2);
  };
  const detail::SurfaceSurvey hole = survey(pecks, endmill(8)),
                              raster = survey(passes, ballmill(4));
  EXPECT_GT(hole.sweeps, 6);
  EXPECT_LT(hole.creasing, 1.5);
  EXPECT_GT(raster.creasing, 0.5 * raster.sweeps);
}

TEST(DefaultMesh, MeasuredDistanceIsNotExceeded) {
  const PartField field = slot(ballmill(6));
  MeshPlan options;
  options.measure = true;
  MeshReport report;
  const TriMesh mesh = mesh_part(field, 0.5, options, &report);
  EXPECT_LE(testing::largest_distance(field, mesh), report.bound + 1e-5);
  EXPECT_LT(report.bound, 0.05);
  EXPECT_LE(report.usual, report.bound);
  // Of the mesh's own volume, which is wrong by chords, a hundredth of the error is left.
  const double exact = 20.0 * 20 * 8 - 20 * kPi * 9 / 2, made = check_mesh(mesh).volume;
  EXPECT_GT(std::abs(made - exact), 0.5);
  EXPECT_NEAR(made - report.volume_excess, exact, 0.01 * std::abs(made - exact));
}

TEST(DefaultMesh, AToleranceThatTakesTooMuchIsGivenUp) {
  const PartField field = slot(ballmill(6));
  MeshPlan options;
  options.tolerance = 0.001;
  options.max_memory = 100000;
  EXPECT_THROW(mesh_part(field, 0.5, options), Error);
  options.most_nodes = 250000;
  MeshReport report;
  MeshCollector collector;
  mesh_part(field, 0.5, options, collector, &report);
  EXPECT_TRUE(collector.mesh().triangles.empty());
  EXPECT_FALSE(report.given_up.empty());
  EXPECT_GT(report.memory, options.max_memory);
}

// Passes of a ball, 5 mm apart, over the whole block: cells about their crests are small.
PartField crests() {
  const StockShape shape = testing::box_stock({0, 0, 0}, {20, 20, 8});
  std::vector<Motion> passes;
  for (int k = 0; k < 5; ++k) {
    const double y = 1.3 + 4.3 * k;
    passes.push_back(line({-10, y, 5}, {30, y + 2, 6}));
  }
  const Tool ball = ballmill(6);
  return {StockSolid(shape), SweepTable(passes, std::span(&ball, 1))};
}

struct RaisedMesh {
  MeshReport report;
  TriMesh mesh;
};

// A mesh that wishes for a fine tolerance and may have a coarser one.
RaisedMesh raised_mesh(const PartField& field, std::size_t most_nodes, bool makes_new_octrees) {
  MeshPlan options;
  options.tolerance = 0.001;
  options.most_nodes = most_nodes;
  options.most_tolerance = 0.032;
  options.makes_new_octrees = makes_new_octrees;
  RaisedMesh out;
  MeshCollector collector;
  mesh_part(field, 0.5, options, collector, &out.report);
  out.mesh = std::move(collector.mesh());
  return out;
}

void expect_raised(const PartField& field, const RaisedMesh& found) {
  ASSERT_TRUE(found.report.given_up.empty()) << found.report.given_up;
  EXPECT_GT(found.report.tolerance, 0.001);
  EXPECT_LE(found.report.tolerance, 0.032);
  EXPECT_DOUBLE_EQ(std::exp2(std::round(std::log2(found.report.tolerance / 0.001))),
                   found.report.tolerance / 0.001);
  EXPECT_LE(found.report.bound, found.report.tolerance);
  EXPECT_LE(testing::largest_distance(field, found.mesh), found.report.bound + 1e-5);
  EXPECT_TRUE(check_mesh(found.mesh).closed);
}

TEST(DefaultMesh, AnOctreeWithTooManyNodesIsMadeAnewWithACoarserTolerance) {
  const PartField field = crests();
  expect_raised(field, raised_mesh(field, 30000, true));
  EXPECT_FALSE(raised_mesh(field, 30000, false).report.given_up.empty());
}

TEST(DefaultMesh, TheToleranceIsRaisedWhereTooManyCellsFail) {
  const PartField field = crests();
  expect_raised(field, raised_mesh(field, 95000, false));
}

}  // namespace
}  // namespace mrsim
