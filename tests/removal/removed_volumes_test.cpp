// What each motion removes: closed forms of single moves, sums, threads.
#include "removal/history/removed_volumes.h"

#include "core/numbers/units.h"
#include "support/mesh_asserts.h"
#include "support/moves.h"
#include "support/shapes.h"
#include "support/tools.h"
#include "sweep_support.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

struct VolumeScene {
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
void expect_closed_form(const VolumeScene& scene, double exact, double voxel) {
  const auto error = [&](double h) { return std::abs(scene.removed(h)[0] / exact - 1); };
  EXPECT_LT(error(voxel), 0.02);
  EXPECT_LT(error(voxel / 2), 0.01);
  EXPECT_LT(error(voxel / 4), 0.005);
}

const StockShape kBlock = box_stock({0, 0, -20}, {100, 60, 0});

TEST(RemovedVolumes, ASlotRemovesItsRoundEndToo) {
  const VolumeScene scene{kBlock, endmill(10), {line({-10, 30, -5}, {50, 30, -5})}};
  expect_closed_form(scene, 5 * (10 * 50 + kPi * 25 / 2), 0.25);
}
TEST(RemovedVolumes, ASideCutRemovesHalfTheToolsWidth) {
  const VolumeScene scene{kBlock, endmill(10), {line({-10, 0, -5}, {110, 0, -5})}};
  expect_closed_form(scene, 5 * 5 * 100.0, 0.25);
}
TEST(RemovedVolumes, APlungeRemovesACylinder) {
  const VolumeScene scene{kBlock, endmill(10), {line({50, 30, 5}, {50, 30, -8})}};
  expect_closed_form(scene, kPi * 25 * 8, 0.25);
}
TEST(RemovedVolumes, ABallRemovesAHalfCylinder) {
  const VolumeScene scene{kBlock, ballmill(6), {line({-10, 30, -3}, {110, 30, -3})}};
  expect_closed_form(scene, kPi * 9 / 2 * 100, 0.25);
}
TEST(RemovedVolumes, ATurningPassRemovesARing) {
  Tool tool = mill(ToolType::turning, 0);
  tool.insert = "R", tool.nose_radius = 0, tool.diameter = 4;
  const VolumeScene scene{round_stock(30, 0, 0, 80), tool, {line({27, 0, 90}, {27, 0, -10})}};
  const double exact = kPi * (30 * 30 - 27 * 27) * 80;
  expect_closed_form(scene, exact, 0.2);
}

// A spiral of overlapping slots: later ones remove what is left.
VolumeScene pocket() {
  VolumeScene scene{kBlock, endmill(8), {}};
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
  const VolumeScene scene{
      kBlock, endmill(10), {line({-10, 30, -5}, {50, 30, -5}), line({50, 30, -5}, {0, 30, -5})}};
  const std::vector<double> removed = scene.removed(0.5);
  EXPECT_GT(removed[0], 2000);
  EXPECT_EQ(removed[1], 0);
}

TEST(RemovedVolumes, SumIsThatOfTheVoxelsGone) {
  const VolumeScene scene = pocket();
  const std::vector<double> removed = scene.removed(0.25);
  for (const double volume : removed) EXPECT_GT(volume, 0);
  // The order of the moves does not change what they remove together.
  VolumeScene reversed = scene;
  std::reverse(reversed.motions.begin(), reversed.motions.end());
  const std::vector<double> other = reversed.removed(0.25);
  const double sum = std::accumulate(removed.begin(), removed.end(), 0.0);
  EXPECT_NEAR(sum, std::accumulate(other.begin(), other.end(), 0.0), 1e-6 * sum);
  EXPECT_NE(removed[5], other[18]);
}

TEST(RemovedVolumes, VolumesAreTheSameOnAnyNumberOfThreads) {
  const VolumeScene scene = pocket();
  const std::vector<double> one = scene.removed(0.3, 1);
  for (const int threads : {2, 3, 7}) EXPECT_EQ(one, scene.removed(0.3, threads));
}

// What a V tool cuts along a line: a groove, with half a cone at each end.
TEST(RemovedVolumes, AVToolRemovesItsGroove) {
  Tool tool = mill(ToolType::chamfer, 6);
  tool.tip_angle = radians(60);
  const VolumeScene scene{kBlock, tool, {line({20, 30, -0.4}, {80, 30, -0.4})}};
  const double half = 0.4 * std::tan(radians(30));
  const double exact = 60 * 0.4 * half + kPi * half * half * 0.4 / 3;
  for (const double voxel : {0.3, 0.15}) EXPECT_NEAR(scene.removed(voxel)[0], exact, 1e-3 * exact);
}

// Slots as wide as a few columns: columns are halved at their walls.
TEST(RemovedVolumes, NarrowSlotsKeepTheirVolumes) {
  VolumeScene scene{kBlock, endmill(1), {}};
  for (int i = 0; i < 20; ++i)
    scene.motions.push_back(line({10, 3 + 2.7 * i, -2}, {90, 3.4 + 2.7 * i, -2}, i));
  const std::vector<double> removed = scene.removed(0.4);
  const double exact = 2 * (std::sqrt(80 * 80 + 0.4 * 0.4) + kPi / 4);
  for (const double volume : removed) EXPECT_NEAR(volume, exact, 0.01 * exact);
  EXPECT_NEAR(std::accumulate(removed.begin(), removed.end(), 0.0), 20 * exact, 0.02 * exact);
}

// A slanted pass over another one, in a round stock: both by the definition, column by column.
// Walls that lie anywhere between the columns, along them, across and round.
TEST(RemovedVolumes, WallsMayLieBetweenColumns) {
  constexpr double kColumn = 0.49;
  const auto error = [&](std::vector<Motion> moves, double exact) {
    const std::vector<double> removed =
        VolumeScene{kBlock, endmill(5.3), std::move(moves)}.removed(kColumn);
    return std::abs(std::accumulate(removed.begin(), removed.end(), 0.0) / exact - 1);
  };
  EXPECT_LT(error({line({-10, -1.95, -3}, {110, -1.95, -3})}, 100 * 0.7 * 3), 1e-3);
  EXPECT_LT(error({line({-10, 31.37, -1.5}, {110, 31.37, -1.5}),
                   line({110, 31.37, -3}, {-10, 31.37, -3})},
                  100 * 5.3 * 3),
            1e-3);
  EXPECT_LT(error({line({30.2, 20.1, 5}, {30.2, 20.1, -5})}, 5 * kPi * 5.3 * 5.3 / 4), 1e-3);
  EXPECT_LT(error({line({20, 20, -2}, {70, 37, -2})},
                  2 * (5.3 * std::hypot(50, 17) + kPi * 5.3 * 5.3 / 4)),
            1e-3);
}

TEST(RemovedVolumes, AMotionRemovesWhatItLowersInEachColumn) {
  for (const Tool& tool : {endmill(6), endmill(6, 1), ballmill(6)}) {
    VolumeScene scene{round_stock(10, 0, -12, 0), tool, {}};
    scene.motions = {line({-15, 3, -1}, {15, -4, -6}), line({2, -15, -5}, {-3, 15, -2}, 1),
                     arc({6, 0, -4}, {0, 0, -4}, {0, 0, 1}, 2 * kPi),
                     line({5, 5, 2}, {5, 5, -7}, 3)};
    const SweepTable sweeps(scene.motions, std::span(&tool, 1));
    std::vector<double> want(scene.motions.size());
    constexpr double kStep = 0.05;
    for (double x = -10 + kStep / 2; x < 10; x += kStep)
      for (double y = -10 + kStep / 2; y < 10; y += kStep) {
        if (x * x + y * y > 100) continue;
        double low = 0;
        for (std::size_t i = 0; i < want.size(); ++i) {
          if (sweeps.distance(i, {x, y, low}) > 0) continue;
          double z = -12, top = low;  // where the distance changes its sign
          for (int k = 0; k < 24; ++k) {
            const double middle = (z + top) / 2;
            (sweeps.distance(i, {x, y, middle}) > 0 ? z : top) = middle;
          }
          want[i] += kStep * kStep * (low - top);
          low = top;
        }
      }
    const std::vector<double> got = scene.removed(0.1);
    for (std::size_t i = 0; i < want.size(); ++i)
      EXPECT_NEAR(got[i], want[i], 0.005 * want[i]) << "motion " << i;
  }
}

// Asked with the share that is done, which grows; and stops for good where the answer is no.
TEST(RemovedVolumes, ThreadsAskWhetherToGoOn) {
  const VolumeScene heights = pocket(),
                    space{kBlock, ballmill(6), {line({-10, 30, 9}, {50, 30, -9})}};
  Tool tool = mill(ToolType::turning, 0);
  tool.insert = "R", tool.diameter = 4;
  const VolumeScene turned{round_stock(30, 0, 0, 80), tool, {line({27, 0, 90}, {27, 0, -10})}};
  for (const VolumeScene* scene : {&heights, &space, &turned}) {
    const PartField field(StockSolid(scene->stock),
                          SweepTable(scene->motions, std::span(&scene->tool, 1)));
    double share = 0;
    int asked = 0, most = 1 << 20;
    const auto removed = [&] {
      return removed_volumes(field, history_lattice(field, 0.5), scene->motions.size(), 2, nullptr,
                             [&](const char*, double done) {
                               EXPECT_GT(done, share);
                               share = done;
                               return ++asked < most;
                             });
    };
    EXPECT_EQ(removed(), scene->removed(0.5));
    EXPECT_EQ(share, 1);
    ASSERT_GT(asked, 1);
    share = 0, asked = 0, most = 1;
    EXPECT_EQ(error_code(removed), "cancelled");
    EXPECT_LE(asked, 2);  // one for each thread
  }
}

}  // namespace
}  // namespace mrsim
