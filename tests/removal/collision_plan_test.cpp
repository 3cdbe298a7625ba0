// The search for collisions in plan: its distances and layers, and that it finds what dense
// sampling finds between passes at levels.
#include "removal/collision/collision_plan.h"

#include "collision_support.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "removal/collision/collision_search.h"
#include "support/moves.h"
#include "support/random.h"
#include "support/rounds.h"

#include <algorithm>
#include <optional>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using testing::arc;
using testing::line;
using testing::Moves;
using testing::Random;
using testing::turned;

constexpr double kDepth = 0.01, kCell = 0.2;
constexpr Box3 kBlock = {{0, 0, -3}, {8, 6, 0}};

StockShape small_block() { return testing::box_stock(kBlock.lo, kBlock.hi); }

Tool plan_mill(double diameter, double corner, double flutes = 0) {
  Tool tool = testing::endmill(diameter, corner, flutes);
  tool.id = "1";
  return tool;
}

// What the search in plan makes of all rapids and cuts of some moves.
class LayerScene {
 public:
  LayerScene(std::vector<Motion> motions, const Tool& tool, ToolPart part = ToolPart::cutter)
      : motions_(std::move(motions)),
        tools_{tool},
        part_(StockSolid(small_block()), SweepTable(motions_, tools_)),
        blocks_(part_, kCell, 3 * kCell, std::size_t(1) << 30) {
    std::vector<int> shapeless;
    movers_.emplace(find_movers(part, motions_, tools_, 0, kBlock, kDepth, 1, shapeless));
    scene_.emplace(CollisionScene{part_, blocks_, *movers_, kDepth, kDepth / 2});
    for (std::uint32_t i = 0; i < part_.sweeps().size(); ++i) cuts_.push_back(i);
    for (std::uint32_t i = 0; i < movers_->motions.size(); ++i) all_.push_back(i);
    plan_.emplace(*scene_, cuts_, all_);
    found_ = groups_of(200);
  }
  PlanGroups groups_of(std::size_t most) const { return plan_->groups(plan_->movers(), most); }
  const SweepTable& cuts() const { return part_.sweeps(); }
  const SweepTable& movers() const { return movers_->sweeps; }
  const std::vector<PlanGroup>& groups() const { return found_.groups; }
  std::size_t others() const { return plan_->others().size() + found_.others.size(); }
  std::size_t heights() const { return plan_->heights(); }
  PlanView view(std::size_t group) const {
    return plan_->view(groups()[group], groups()[group].layers[0]);
  }

 private:
  std::vector<Motion> motions_;
  std::vector<Tool> tools_;
  PartField part_;
  BlockIndex blocks_;
  std::optional<Movers> movers_;
  std::optional<CollisionScene> scene_;
  Candidates cuts_, all_;
  std::optional<PlanSearch> plan_;
  PlanGroups found_;
};

// Two passes at z = -1, and a way back between them that is lifted, over a wall.
std::vector<Motion> two_passes(double lift) {
  Moves m({1, 1, -1});
  m.cut({7, 1, -1}).cut({7, 2, -1}).cut({1, 2, -1});
  m.rapid({1, 2, -1 + lift}).rapid({6, 4, -1 + lift});
  return m.motions;
}

// Ways back over a floor, each at another height: of a few groups each counts from its lowest.
TEST(CollisionPlan, MoversOfManyHeightsMayShareAGroup) {
  Moves m({1, 1, -1});
  m.cut({7, 1, -1}).cut({7, 2, -1}).cut({1, 2, -1}).cut({1, 3, -1}).cut({7, 3, -1});
  for (int k = 0; k < 40; ++k) {
    const double z = -0.9 + 0.01 * k;
    m.rapid({k % 2 ? 6.5 : 1.5, k % 2 ? 2.5 : 1.5, z});
  }
  const LayerScene scene(m.motions, plan_mill(2, 0));
  EXPECT_GE(scene.heights(), 40u);
  const PlanGroups few = scene.groups_of(4);
  ASSERT_GT(few.groups.size(), 1u);
  EXPECT_LE(few.groups.size(), 5u);
  EXPECT_TRUE(few.others.empty());
  std::size_t movers = 0;
  for (const PlanGroup& group : few.groups) {
    movers += group.movers.sweeps.size();
    for (const std::uint32_t mover : group.movers.sweeps)
      EXPECT_LE(group.lowest, scene.movers().bounds(mover).lo.z + 1e-9);
  }
  std::size_t all = 0;
  for (const PlanGroup& group : scene.groups()) all += group.movers.sweeps.size();
  EXPECT_EQ(movers, all);
}

TEST(CollisionPlan, DistancesOfFlatEndsAreThoseFarAboveThem) {
  Random r(3);
  std::vector<Motion> motions;
  for (int k = 0; k < 30; ++k) {
    const Vec3 a{r(0, 8), r(0, 6), -1}, b{r(0, 8), r(0, 6), -1};
    motions.push_back(k % 2 ? line(a, b) : arc(a, b, {0, 0, 1}, r(-6, 6)));
  }
  motions.push_back(line({0.3, 5.5, -0.7}, {7.7, 0.4, -0.7}));
  motions.back().kind = MotionKind::rapid;
  const LayerScene scene(motions, plan_mill(2, 0));
  ASSERT_EQ(scene.groups().size(), 1u);
  ASSERT_EQ(scene.groups()[0].layers.size(), 1u);
  const PlanView view = scene.view(0);
  ASSERT_EQ(view.cuts().size(), 30u);
  int rising = 0;
  for (int k = 0; k < 200; ++k) {
    const Vec3 p{r(-2, 10), r(-2, 8), 0}, above = p + Vec3{0, 0, 100};
    EXPECT_NEAR(view.mover_distance(0, p), scene.movers().distance(0, above), 1e-9);
    for (const std::uint32_t cut : view.cuts()) {
      const double d = view.cut_distance(cut, p);
      EXPECT_NEAR(d, scene.cuts().distance(cut, above), 1e-9);
      const double beside = view.cut_distance(cut, p + 1e-3 * view.out_of_cut(cut, p));
      EXPECT_LE(std::abs(beside - d), 1e-3 + 1e-9);
      rising += beside > d + 0.99e-3;  // not where two parts of a path are equally near
    }
    const Vec3 on = view.drawn_onto(0, p);
    EXPECT_LE(view.mover_distance(0, on), 1e-9);
  }
  EXPECT_GT(rising, 5900);  // of 6 000
}

TEST(CollisionPlan, TheStockIsTheRectangleAboutIt) {
  const PlanView view(kBlock, {}, {});
  EXPECT_EQ(view.stock_distance({4, 3, 50}), -3);
  EXPECT_EQ(view.stock_distance({7, 3, 50}), -1);
  EXPECT_EQ(view.stock_distance({11, 10, -50}), 5);
  EXPECT_EQ(view.out_of_stock({7, 3, 0}), (Vec3{1, 0, 0}));
  EXPECT_EQ(view.out_of_stock({4, 1, 0}), (Vec3{0, -1, 0}));
}

TEST(CollisionPlan, HasALayerForEachLiftThatACornerIsHigh) {
  const auto layers = [](double corner, double lift) {
    const LayerScene scene(two_passes(lift), plan_mill(2, corner));
    std::size_t most = 0;
    for (const PlanGroup& group : scene.groups()) most = std::max(most, group.layers.size());
    return most;
  };
  EXPECT_EQ(layers(0, 0.3), 1u);
  EXPECT_EQ(layers(0.2, 0.3), 1u);
  EXPECT_EQ(layers(0.8, 0.3), 3u);
  EXPECT_EQ(layers(0.8, 0.01), 0u);
}

TEST(CollisionPlan, LeavesOutCutsThatEndBelowTheTop) {
  EXPECT_EQ(LayerScene(two_passes(0.3), plan_mill(2, 0, 2)).groups().size(), 1u);
  const LayerScene low(two_passes(0.3), plan_mill(2, 0, 0.5));
  EXPECT_EQ(low.groups().size(), 0u);
  EXPECT_GT(low.others(), 0u);
}

// The depth of each rapid by a dense grid of points.
std::vector<double> sampled_depths(const std::vector<Motion>& motions, const Tool& tool) {
  const std::vector<Tool> tools{tool};
  const SweepTable cuts(motions, tools);
  const SweepTable rapids(motions, tools, {SweepSelection::Part::cutter, false, true});
  std::vector<double> deepest(motions.size(), 0);
  constexpr double kStep = 0.1;
  for (double x = kStep / 2; x < kBlock.hi.x; x += kStep)
    for (double y = kStep / 2; y < kBlock.hi.y; y += kStep)
      for (double z = kBlock.lo.z + kStep / 2; z < 0; z += kStep) {
        const Vec3 p{x, y, z};
        double least = std::min({x, kBlock.hi.x - x, y, kBlock.hi.y - y, -z, z - kBlock.lo.z});
        std::size_t cut = 0;
        for (std::size_t r = 0; r < rapids.size() && least > kDepth; ++r) {
          for (; cut < cuts.size() && cuts.motion(cut) < rapids.motion(r); ++cut)
            least = std::min(least, cuts.distance(cut, p));
          double& best = deepest[static_cast<std::size_t>(rapids.motion(r))];
          if (least > best && rapids.distance(r, p) <= 0) best = least;
        }
      }
  return deepest;
}

// Passes of arcs and lines at three levels, and rapids between places of them that are lifted.
std::vector<Motion> passes(Random& r, double diameter, double lift) {
  Moves m({0, 0, 1});
  std::vector<Vec3> been;
  for (double z = -0.8; z > -2.5; z -= 0.8) {
    const double step = r(0.3, 0.9) * diameter;
    for (double x = r(0, 1); x < kBlock.hi.x; x += step) {
      m.rapid({x, 1, z + lift}).rapid({x, 1, z});
      const Vec3 center{x, 2.5, z};
      const double sweep = -kTwoPi * r(0.3, 1);
      if (r.pick(2))
        m.cut({x, 4.5, z});
      else
        m.arc(center + turned({0, -1.5, 0}, {0, 0, 1}, sweep), center, sweep);
      been.push_back(m.motions.back().end);
      if (r.pick(3)) continue;
      const Vec3 to = been[static_cast<std::size_t>(r.pick(static_cast<int>(been.size())))];
      m.rapid(been.back() + Vec3{-0.2, 0, lift}).rapid({to.x, to.y, z + lift});
    }
  }
  return m.motions;
}

void expect_agrees(const std::vector<Motion>& motions, const Tool& tool, unsigned scene) {
  const std::vector<double> proved = sampled_depths(motions, tool);
  const std::vector<Tool> tools{tool};
  CarvePlan carving;
  carving.voxel = kCell;
  CollisionOptions options;
  options.depth = kDepth;
  options.lines = motions.size();
  const CollisionReport report =
      find_collisions(carve(small_block(), motions, tools, carving), motions, tools, 0, options);
  std::vector<double> found(motions.size(), 0);
  for (const Collision& c : report.lines)
    if (c.part == ToolPart::cutter) found[c.motion] = c.depth;
  for (std::size_t i = 0; i < proved.size(); ++i) {
    if (proved[i] > kDepth + kCell / 8) {
      EXPECT_GE(found[i], proved[i] * (1 - 1.0 / 32)) << scene << " " << i;
    }
    EXPECT_LE(found[i], proved[i] + 0.15) << scene << " " << i;
  }
}

TEST(CollisionPlan, LiftedRapidsAgreeWithDenseSampling) {
  Random r(17);
  constexpr double kLifts[] = {0.3, 0.15, 0, 0.3};
  for (unsigned scene = 0; scene < testing::rounds(8); ++scene) {
    const double diameter = r(1, 2.5), corner = scene % 2 ? r(0.2, 0.45) * diameter : 0;
    const Tool tool = plan_mill(diameter, corner, scene % 4 == 2 ? 3.5 : 0);
    expect_agrees(passes(r, diameter, kLifts[scene % 4]), tool, scene);
  }
}

// Holes that meet one another, in pecks: each rapid goes back to a little above where the last peck
// ended, or below that.
std::vector<Motion> pecks(Random& r) {
  Moves m({0, 0, 1});
  for (int hole = 0; hole < 6; ++hole) {
    const double x = r(0, kBlock.hi.x), y = r(0, kBlock.hi.y), depth = r(1, 2.8);
    m.rapid({x, y, 1});
    for (double z = 0; z > -depth;) {
      m.rapid({x, y, z + (r.pick(4) ? 0.2 : -0.15)});
      z -= r(0.4, 0.9);
      m.cut({x, y, z}).rapid({x, y, 1});
    }
  }
  return m.motions;
}

TEST(CollisionPlan, PecksAgreeWithDenseSampling) {
  Random r(18);
  for (unsigned scene = 0; scene < testing::rounds(4); ++scene) {
    Tool tool = plan_mill(r(1, 2), 0, scene % 2 ? 1.6 : 4);
    tool.type = ToolType::drill;
    tool.tip_angle = r(1.6, 2.4);
    expect_agrees(pecks(r), tool, scene);
  }
}

// A drill with flutes shorter than its hole, and a shank that follows an end mill down a helix.
TEST(CollisionPlan, HoldsPecksAndHelices) {
  Moves drilled({4, 3, 1});
  for (double z = -0.5; z > -2.9; z -= 0.5)
    drilled.rapid({4, 3, z + 0.7}).cut({4, 3, z}).rapid({4, 3, 1});
  Tool drill = plan_mill(2, 0, 1.2);
  drill.type = ToolType::drill;
  drill.tip_angle = 2.06;
  EXPECT_EQ(LayerScene(drilled.motions, drill).others(), 0u);
  Moves bored({6, 3, 0});
  for (int turn = 0; turn < 6; ++turn)
    bored.arc({6, 3, -0.4 * (turn + 1)}, {4, 3, -0.4 * turn}, kTwoPi);
  for (Motion& m : bored.motions) m.rise = m.end.z - m.start.z;
  Tool boring = plan_mill(2, 0, 1.2);
  boring.shank = {{1.9, 1.9, 20}};
  const LayerScene helices(bored.motions, boring, ToolPart::shank);
  EXPECT_GT(helices.groups().size(), 1u);
  EXPECT_EQ(helices.others(), 0u);
}

// Below a counterbore a form with a neck cuts a tenth, and rises through what its neck left: a
// bulge below the widest place is no nose that a plunge has cleared for.
TEST(CollisionPlan, FindsTheBulgeBelowANeck) {
  Moves m({4, 3, 1});
  m.cut({4, 3, -0.6}).rapid({4, 3, 1}).rapid({4, 3, -2.0}).cut({4, 3, -2.1}).rapid({4, 3, 1});
  Tool form;
  form.id = "2";
  form.type = ToolType::form;
  form.profile = {{0, 0, 0},     {1, 0, 0},   {1, 0.5, 0}, {0.5, 0.6, 0},
                  {0.5, 1.5, 0}, {2, 1.6, 0}, {2, 8, 0},   {0, 8, 0}};
  for (std::size_t k = 2; k < m.motions.size(); ++k) m.motions[k].tool = 1;
  const std::vector<Tool> tools{plan_mill(4.2, 0), form};
  const PartField part(StockSolid(small_block()), SweepTable(m.motions, tools));
  std::vector<int> shapeless;
  const Movers movers =
      find_movers(ToolPart::cutter, m.motions, tools, 0, kBlock, kDepth, 1, shapeless);
  ASSERT_EQ(movers.motions.back(), 4);
  const std::uint32_t up = static_cast<std::uint32_t>(movers.motions.size()) - 1;
  const auto rise = plan_path(movers.sweeps, up);
  const auto plunge = plan_path(part.sweeps(), part.sweeps().size() - 1);
  ASSERT_TRUE(rise && plunge);
  EXPECT_FALSE(holds_nose(*plunge, *rise));
}

}  // namespace
}  // namespace mrsim
