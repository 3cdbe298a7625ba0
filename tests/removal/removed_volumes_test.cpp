// What each motion removes: closed forms of single moves, sums, threads.
#include "removal/history/removed_volumes.h"

#include "core/units.h"
#include "support/moves.h"
#include "support/shapes.h"
#include "support/tools.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

struct Scene {
  StockShape stock;
  Tool tool;
  std::vector<Motion> motions;

  std::vector<double> removed(double voxel, int threads = 1) const {
    const PartField field(StockSolid(stock), SweepTable(motions, std::span(&tool, 1)));
    return removed_volumes(field, history_lattice(field, voxel), motions.size(), threads);
  }
};

// Relative errors at the default voxel and at half of it. They fall with the voxel on the whole, so
// that of half the voxel may be that of the default less a margin for chance.
void expect_closed_form(const Scene& scene, double exact, double voxel) {
  const auto error = [&](double h) { return std::abs(scene.removed(h)[0] / exact - 1); };
  EXPECT_LT(error(voxel), 0.02);
  EXPECT_LT(error(voxel / 2), 0.01);
  EXPECT_LT(error(voxel / 4), 0.005);
}

const StockShape kBlock = box_stock({0, 0, -20}, {100, 60, 0});

TEST(RemovedVolumes, SlotWithRoundEnd) {
  const Scene scene{kBlock, endmill(10), {line({-10, 30, -5}, {50, 30, -5})}};
  expect_closed_form(scene, 5 * (10 * 50 + kPi * 25 / 2), 0.25);
}
TEST(RemovedVolumes, HalfImmersionSideCut) {
  const Scene scene{kBlock, endmill(10), {line({-10, 0, -5}, {110, 0, -5})}};
  expect_closed_form(scene, 5 * 5 * 100.0, 0.25);
}
TEST(RemovedVolumes, FullPlunge) {
  const Scene scene{kBlock, endmill(10), {line({50, 30, 5}, {50, 30, -8})}};
  expect_closed_form(scene, kPi * 25 * 8, 0.25);
}
TEST(RemovedVolumes, BallSlot) {
  const Scene scene{kBlock, ballmill(6), {line({-10, 30, -3}, {110, 30, -3})}};
  expect_closed_form(scene, kPi * 9 / 2 * 100, 0.25);
}
TEST(RemovedVolumes, TurningPass) {
  Tool tool = mill(ToolType::turning, 0);
  tool.insert = "R", tool.nose_radius = 0, tool.diameter = 4;
  const Scene scene{round_stock(30, 0, 0, 80), tool, {line({27, 0, 90}, {27, 0, -10})}};
  const double exact = kPi * (30 * 30 - 27 * 27) * 80;
  expect_closed_form(scene, exact, 0.2);
}

// A spiral of overlapping slots: later ones remove what is left.
Scene pocket() {
  Scene scene{kBlock, endmill(8), {}};
  Vec3 from{30, 30, -4};
  for (int i = 0; i < 24; ++i) {
    const double side = 3 * (1 + i / 2);
    const Vec3 to = from + side * (i % 4 == 0   ? Vec3{1, 0, 0}
                                   : i % 4 == 1 ? Vec3{0, 1, 0}
                                   : i % 4 == 2 ? Vec3{-1, 0, 0}
                                                : Vec3{0, -1, 0});
    scene.motions.push_back(line(from, to, i));
    from = to;
  }
  return scene;
}

TEST(RemovedVolumes, SecondPassOnTheSamePathRemovesNothing) {
  const Scene scene{
      kBlock, endmill(10), {line({-10, 30, -5}, {50, 30, -5}), line({50, 30, -5}, {0, 30, -5})}};
  const std::vector<double> removed = scene.removed(0.5);
  EXPECT_GT(removed[0], 2000);
  EXPECT_EQ(removed[1], 0);
}

TEST(RemovedVolumes, SumIsThatOfTheVoxelsGone) {
  const Scene scene = pocket();
  const std::vector<double> removed = scene.removed(0.25);
  for (const double volume : removed) EXPECT_GT(volume, 0);
  // The order of the moves does not change what they remove together.
  Scene reversed = scene;
  std::reverse(reversed.motions.begin(), reversed.motions.end());
  const std::vector<double> other = reversed.removed(0.25);
  const double sum = std::accumulate(removed.begin(), removed.end(), 0.0);
  EXPECT_NEAR(sum, std::accumulate(other.begin(), other.end(), 0.0), 1e-6 * sum);
  EXPECT_NE(removed[5], other[18]);
}

TEST(RemovedVolumes, SameOnAnyNumberOfThreads) {
  const Scene scene = pocket();
  const std::vector<double> one = scene.removed(0.3, 1);
  for (const int threads : {2, 3, 7}) EXPECT_EQ(one, scene.removed(0.3, threads));
}

}  // namespace
}  // namespace mrsim
