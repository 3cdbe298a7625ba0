// The first motion that removes a place, by both walkers and by the definition.
#include "removal/history/cut_walk.h"

#include "carve_support.h"
#include "removal/history/cut_columns.h"
#include "removal/history/removed_volumes.h"
#include "removal/history/staircase_walker.h"
#include "removal/part/block_index.h"
#include "support/moves.h"
#include "support/rounds.h"
#include "support/shapes.h"
#include "support/tools.h"
#include "sweep_support.h"

#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

constexpr double kBesideSurface = 1e-6;  // mm: nearer places may be on either side

struct Collected final : CutSink {
  void tile(const CutCell& cell, std::int32_t cut) override {
    for_each(cell, [&](const auto& at, std::size_t) { add(at, cut); });
  }
  void leaf(const CutCell& cell, const std::int32_t* cut) override {
    for_each(cell, [&](const auto& at, std::size_t k) { add(at, cut[k]); });
  }
  template <typename Body>
  void for_each(const CutCell& cell, Body body) {
    std::size_t k = 0;
    for (int x = 0; x < cell.size; ++x)
      for (int y = 0; y < cell.size; ++y)
        for (int z = 0; z < cell.size; ++z)
          body(std::array<std::int32_t, 3>{cell.origin[0] + x, cell.origin[1] + y,
                                           cell.origin[2] + z},
               k++);
  }
  void add(const std::array<std::int32_t, 3>& at, std::int32_t cut) {
    ++count;
    if (cut != kNeverThere || count % 16 == 0) voxels.emplace_back(at, cut);
  }
  std::size_t count = 0;
  std::vector<std::pair<std::array<std::int32_t, 3>, std::int32_t>> voxels;  // of the stock, mostly
};

struct WalkScene {
  StockShape stock = box_stock({0, 0, -6}, {9, 8, 0});
  std::vector<Tool> tools;
  std::vector<Motion> motions;

  PartField field(std::size_t count) const {
    return {StockSolid(stock), SweepTable(std::span(motions).first(count), tools)};
  }
};

// Lines, level and slanted, plunges and arcs on a lattice of half millimetres.
WalkScene random_scene(Random& r, const Tool& tool, int count) {
  WalkScene scene{.tools = {tool}};
  const auto place = [&] {
    return Vec3{std::round(2 * r(0, 9)) / 2, std::round(2 * r(0, 8)) / 2,
                std::round(2 * r(-5, 1)) / 2};
  };
  Vec3 from = place();
  for (int i = 0; i < count; ++i) {
    Vec3 to = place();
    if (i % 3 == 0) to.z = from.z;
    if (i % 7 == 0) to = {from.x, from.y, to.z};
    scene.motions.push_back(line(from, to, i + 1));
    from = to;
  }
  return scene;
}

Collected walk(const PartField& field, double voxel, bool by_columns) {
  Collected found;
  const CutLattice lattice{voxel, false};
  const double near = 0.5 * voxel + field.slack();
  const BlockIndex index(field, voxel, near, std::size_t(1) << 30);
  for (std::size_t b = 0; b < index.size(); ++b) {
    const Candidates sweeps =
        field.sweeps().expanded(index.sweeps(b), inflated(index.box(b), near));
    std::vector<double> removed(sweeps.size(), 0.0);
    if (by_columns)
      walk_block(field, lattice, index.origin(b), sweeps, &found, removed);
    else
      CutWalker(field, lattice).walk({index.origin(b), kBlockVoxels}, sweeps, &found, removed);
  }
  EXPECT_EQ(found.count, index.size() * kBlockVoxels * kBlockVoxels * kBlockVoxels);
  return found;
}

// {cut <= i} is the air of the part after motion i at every voxel away from surfaces.
void expect_history(const WalkScene& scene, const Collected& found, double voxel) {
  const PartField whole = scene.field(scene.motions.size());
  const SweepTable& sweeps = whole.sweeps();
  const CutLattice lattice{voxel, false};
  std::size_t wrong = 0, cut_voxels = 0;
  for (std::size_t k = 0; k < found.voxels.size(); k += 3) {
    const auto& [at, cut] = found.voxels[k];
    const Vec3 p = lattice.position(at);
    const double stock = whole.solid().distance(p);
    double least = std::numeric_limits<double>::infinity(), sharp = std::abs(stock);
    std::int32_t expected = stock < 0 ? kStillThere : kNeverThere;
    for (std::size_t i = 0; i < sweeps.size() && expected == kStillThere; ++i) {
      const double d = sweeps.distance(i, p);
      sharp = std::min(sharp, std::abs(d)), least = std::min(least, d);
      if (d <= 0) expected = sweeps.motion(i);
    }
    if (sharp < kBesideSurface) continue;
    wrong += cut != expected;
    cut_voxels += cut >= 0;
  }
  EXPECT_EQ(wrong, 0u);
  EXPECT_GT(cut_voxels, 100u);
}

TEST(CutWalk, IsTheFirstMotionThatHoldsThePlace) {
  Random r(7);
  for (unsigned round = 0; round < rounds(3); ++round)
    for (const Tool& tool :
         {endmill(3), ballmill(3), endmill(4, 1), endmill(3, 0.5, 4), mill(ToolType::drill, 3)}) {
      const WalkScene scene = random_scene(r, tool, 16);
      const PartField field = scene.field(scene.motions.size());
      expect_history(scene, walk(field, 0.3, true), 0.3);
      expect_history(scene, walk(field, 0.45, false), 0.45);
    }
}

TEST(CutWalk, StaircasesAreTheFirstMotionsThatHoldThePlace) {
  Random r(13);
  for (unsigned round = 0; round < rounds(3); ++round)
    for (const Tool& tool : {endmill(3), ballmill(3), endmill(4, 1), mill(ToolType::drill, 3)})
      for (const StockShape& stock :
           {box_stock({0, 0, -6}, {9, 8, 0}), round_stock(4.2, 0.5, -6, 0)}) {
        WalkScene scene = random_scene(r, tool, 30);
        scene.stock = stock;
        const PartField field = scene.field(scene.motions.size());
        ASSERT_TRUE(has_height_history(field));
        Collected found;
        const StaircaseWalker walker(field, 0.3);
        for (std::size_t t = 0; t < walker.tiles(); ++t) walker.walk(t, found);
        expect_history(scene, found, 0.3);
      }
}

// The part that a shorter program leaves, as its own field tells it.
TEST(CutWalk, AirUntilAMotionIsWhatIsCutUpToIt) {
  Random r(11);
  const double voxel = 0.25;
  const WalkScene scene = random_scene(r, ballmill(3), 30);
  const Collected found = walk(scene.field(30), voxel, true);
  for (const int until : {1, 8, 17, 30}) {
    const PartField part = scene.field(static_cast<std::size_t>(until));
    const Candidates all = part.all();
    std::size_t wrong = 0;
    for (const auto& [at, cut] : found.voxels) {
      const FieldSample d = part.sample(CutLattice{voxel, false}.position(at), all);
      if (std::abs(d.distance) < kBesideSurface) continue;
      const bool air = cut == kNeverThere || (cut >= 0 && cut < until);
      wrong += air != (d.distance > 0);
    }
    EXPECT_EQ(wrong, 0u) << until;
  }
}

TEST(CutWalk, ColumnsAndCellsRemoveTheSame) {
  Random r(5);
  for (const Tool& tool : {endmill(3), ballmill(3), endmill(4, 1)}) {
    const WalkScene scene = random_scene(r, tool, 40);
    const PartField field = scene.field(40);
    const double voxel = 0.25;
    const BlockIndex index(field, voxel, voxel, std::size_t(1) << 30);
    for (std::size_t b = 0; b < index.size(); ++b) {
      const Candidates sweeps =
          field.sweeps().expanded(index.sweeps(b), inflated(index.box(b), voxel));
      std::vector<double> columns(sweeps.size(), 0.0), cells(sweeps.size(), 0.0);
      walk_block(field, {voxel, false}, index.origin(b), sweeps, nullptr, columns);
      CutWalker(field, {voxel, false})
          .walk({index.origin(b), kBlockVoxels}, sweeps, nullptr, cells);
      for (std::size_t i = 0; i < sweeps.size(); ++i) EXPECT_NEAR(columns[i], cells[i], 2e-5) << i;
    }
  }
}

}  // namespace
}  // namespace mrsim
