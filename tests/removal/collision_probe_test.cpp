// What the probe says of a mover is true by brute force; what it must not miss, it finds.
#include "removal/collision/collision_probe.h"

#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "support/random.h"
#include "support/shapes.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <random>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

constexpr double kTouch = 0.01, kVoxel = 0.5;

class ProbeScene {
 public:
  explicit ProbeScene(std::vector<Motion> motions, ToolType type = ToolType::endmill)
      : motions_(std::move(motions)) {
    tools_[0].id = "1";
    tools_[0].type = type;
    tools_[0].diameter = 6;
    const StockShape shape = testing::box_stock({0, 0, -20}, {60, 40, 0});
    part_ = std::make_unique<PartField>(StockSolid(shape), SweepTable(motions_, tools_));
    blocks_ = std::make_unique<BlockIndex>(*part_, kVoxel, kBand, std::size_t(1) << 30);
    std::vector<int> shapeless;
    movers_.emplace(
        find_movers(ToolPart::cutter, motions_, tools_, 0, shape.box, kTouch, 1, shapeless));
  }

  std::vector<CollisionHit> probe(int threads = 1) const {
    const CollisionScene scene{*part_, *blocks_, *movers_, kTouch, kVoxel / 16};
    const auto box_of = [&](std::uint32_t mover) {
      const Box3 bounds = movers_->sweeps.bounds(mover), &stock = part_->solid().bounds();
      return Box3{max(bounds.lo, stock.lo), min(bounds.hi, stock.hi)};
    };
    return probe_movers(scene, kBand, box_of, threads);
  }

  // The depth of p in the material of the mover's moment, every cut asked.
  double depth(std::uint32_t mover, const Vec3& p) const {
    double least = -part_->solid().distance(p);
    for (std::uint32_t cut = 0; cut < part_->sweeps().size(); ++cut)
      if (part_->sweeps().motion(cut) <= movers_->motions[mover])
        least = std::min(least, part_->sweeps().distance(cut, p));
    return least;
  }
  const Movers& movers() const { return *movers_; }

 private:
  static constexpr double kBand = 3 * kVoxel;
  std::vector<Motion> motions_;
  std::vector<Tool> tools_{1};
  std::unique_ptr<PartField> part_;
  std::unique_ptr<BlockIndex> blocks_;
  std::optional<Movers> movers_;
};

std::vector<Motion> path(const std::vector<std::pair<MotionKind, Vec3>>& moves, const Vec3& start) {
  std::vector<Motion> motions;
  Vec3 at = start;
  for (const auto& [kind, to] : moves) {
    Motion m;
    m.kind = kind;
    m.start = at;
    m.end = at = to;
    m.tool = 0;
    motions.push_back(m);
  }
  return motions;
}

TEST(CollisionProbe, FindsRapidsThroughMaterial) {
  using enum MotionKind;
  const ProbeScene scene(
      path({{rapid, {30, 20, -3}}, {line, {50, 20, -3}}, {rapid, {50, 30, -3}}}, {30, 20, 10}));
  const std::vector<CollisionHit> hits = scene.probe();
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_EQ(hits[0].mover, 0u);
  EXPECT_EQ(hits[1].mover, 1u);
}

// A raster without retracts: each row begins with a step of a tenth into what is not cut yet, at
// the edge of the stock.
TEST(CollisionProbe, FindsStepsBetweenRows) {
  using enum MotionKind;
  std::vector<std::pair<MotionKind, Vec3>> moves;
  for (int row = 0; row < 40; ++row) {
    const double y = 10 + 0.1 * row, from = row % 2 ? 60 : 0;
    moves.push_back({rapid, {from, y, -8}});
    moves.push_back({line, {60 - from, y, -8}});
  }
  const ProbeScene scene(path(moves, {0, 10, 10}), ToolType::ballmill);
  EXPECT_EQ(scene.movers().motions.size(), 40u);
  EXPECT_GE(scene.probe().size(), 38u);
}

TEST(CollisionProbe, TellsTheTruthWithAnyThreads) {
  using enum MotionKind;
  std::mt19937 random(testing::salted(5));
  const auto pick = [&](double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(random() % 1000) / 999;
  };
  std::vector<std::pair<MotionKind, Vec3>> moves;
  for (int i = 0; i < 400; ++i)
    moves.push_back({i % 3 == 0 ? rapid : line, {pick(0, 60), pick(0, 40), pick(-10, 3)}});
  const ProbeScene scene(path(moves, {30, 20, 10}));
  const std::vector<CollisionHit> hits = scene.probe();
  EXPECT_GE(hits.size(), 20u);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (i > 0) {
      EXPECT_LT(hits[i - 1].mover, hits[i].mover);
    }
    EXPECT_LE(scene.movers().sweeps.distance(hits[i].mover, hits[i].place), 1e-6);
    EXPECT_GT(scene.depth(hits[i].mover, hits[i].place), kTouch);
  }
  const std::vector<CollisionHit> others = scene.probe(7);
  ASSERT_EQ(others.size(), hits.size());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    EXPECT_EQ(others[i].mover, hits[i].mover);
    EXPECT_EQ(others[i].place, hits[i].place);
  }
}

// The flank of a V tool ends above the stock: nothing above the end of its cut is left. Where it
// ends below, the way up is looked at, and where the rapid goes aside.
TEST(CollisionMovers, LeaveOutTheRetractOfAConeThatReachesAboveTheStock) {
  using enum MotionKind;
  const auto movers = [](double flutes, const Vec3& out) {
    Tool cone;
    cone.id = "1", cone.type = ToolType::taper, cone.taper_angle = kPi / 4;
    cone.diameter = 0.02, cone.flute_length = flutes;
    const std::vector<Motion> motions =
        path({{line, {20, 20, -2}}, {line, {30, 25, -3}}, {rapid, out}}, {20, 20, 5});
    std::vector<int> shapeless;
    const Box3 stock{{0, 0, -20}, {60, 40, 0}};
    const std::vector<Tool> tools{cone};
    return find_movers(ToolPart::cutter, motions, tools, 0, stock, kTouch, 1, shapeless)
        .motions.size();
  };
  EXPECT_EQ(movers(4, {30, 25, 5}), 0u);
  EXPECT_EQ(movers(2, {30, 25, 5}), 1u);
  EXPECT_EQ(movers(4, {30, 26, 5}), 1u);
}

}  // namespace
}  // namespace mrsim
