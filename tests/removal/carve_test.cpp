#include "carve_support.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "core/process/error.h"
#include "removal/field/lattice.h"
#include "removal/part/stock.h"
#include "removal/part/stock_grid.h"
#include "support/moves.h"
#include "support/random.h"
#include "support/rounds.h"
#include "support/shapes.h"
#include "support/tools.h"
#include "turn_scenes.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

Motion half_circle(Vec3 a, double radius, double sweep) {
  Motion m;
  m.kind = MotionKind::arc;
  m.start = a;
  m.center = a + Vec3{radius, 0, 0};
  m.end = a + Vec3{2 * radius, 0, 0};
  m.radius = std::abs(radius);
  m.sweep = sweep;
  m.tool = 0;
  return m;
}

// Volume of the level set by counting, sub-voxel by the distance: good to a few tenths of a percent
// of the cut.
double counted_volume(const Stock& stock) {
  const double h = stock.voxel();
  double sum = 0;
  const auto& tree = grids(stock).distance->tree();
  const openvdb::CoordBBox box = grids(stock).distance->evalActiveVoxelBoundingBox();
  openvdb::tree::ValueAccessor<const openvdb::FloatTree> at(tree);
  for (auto it = box.begin(); it; ++it) sum += std::clamp(0.5 - at.getValue(*it) / h, 0.0, 1.0);
  return sum * h * h * h;
}

std::vector<Motion> random_motions(std::uint64_t seed, int count) {
  std::mt19937_64 random(testing::salted(seed));
  std::uniform_int_distribution<int> x(0, 20), z(2, 9);
  std::vector<Motion> motions;
  Vec3 at{10, 10, 8};
  for (int i = 0; i < count; ++i) {
    const bool slanted = random() % 4 == 0;
    const Vec3 to{double(x(random)), double(x(random)), slanted ? double(z(random)) : at.z};
    if (to == at) continue;
    motions.push_back(random() % 3 ? line(at, to, i)
                                   : half_circle(at, 2, random() % 2 ? kPi : -kPi));
    at = motions.back().end;
  }
  return motions;
}

TEST(Carve, EqualsTheReferenceToTheLastBit) {
  for (const ToolType type : {ToolType::endmill, ToolType::ballmill})
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const std::vector<Tool> tools{mill(type, 3)};
      const std::vector<Motion> motions = random_motions(seed, 40);
      const StockShape shape = box_stock({0, 0, 0}, {20, 20, 9});
      const Stock stock = carve(shape, motions, tools, {.voxel = 0.5});
      EXPECT_EQ(voxels(stock), reference(shape, motions, tools, 0.5)) << "seed " << seed;
    }
}

// Many short moves, as finishing rasters and adaptive clearing are made of: where dominance drops
// most of every list. Some coincide.
std::vector<Motion> short_moves(std::uint64_t seed, int count, bool horizontal) {
  std::mt19937_64 random(testing::salted(seed));
  std::uniform_real_distribution<double> step(-0.6, 0.6);
  std::vector<Motion> motions;
  Vec3 at{10, 10, 5};
  for (int i = 0; i < count; ++i) {
    if (i % 60 == 0)
      at = {double(random() % 20), double(random() % 20), 3.0 + double(random() % 4)};
    const Vec3 to{std::clamp(at.x + step(random), 0.0, 20.0),
                  std::clamp(at.y + step(random), 0.0, 20.0),
                  horizontal ? at.z : std::clamp(at.z + 0.3 * step(random), 2.0, 8.0)};
    motions.push_back(line(at, to, i));
    if (i % 7 == 0) motions.push_back(line(to, at, i));
    at = to;
  }
  return motions;
}

void expect_reference(const Tool& tool, const std::vector<Motion>& motions) {
  const StockShape shape = box_stock({0, 0, 0}, {20, 20, 9});
  const std::vector<Tool> tools{tool};
  EXPECT_EQ(voxels(carve(shape, motions, tools, {.voxel = 0.5})),
            reference(shape, motions, tools, 0.5))
      << "tool type " << int(tool.type);
}

TEST(Carve, DominanceNeverChangesABit) {
  Tool bull = mill(ToolType::bullmill, 5), taper = mill(ToolType::taper, 5);
  bull.corner_radius = 1;
  taper.taper_angle = 0.2;
  taper.tip_diameter = 2;
  const Tool flat = mill(ToolType::endmill, 5), ball = mill(ToolType::ballmill, 5);
  for (std::uint64_t seed = 1; seed <= testing::rounds(3); ++seed) {
    for (const Tool& tool : {flat, bull, taper, ball})
      expect_reference(tool, short_moves(seed, 400, true));
    expect_reference(ball, short_moves(seed, 400, false));
  }
  expect_reference(flat, short_moves(4, 60, false));  // no closed form: the reference is slow
}

// Rows of short moves along smooth curves, some of them twice, which lists hold in packs.
std::vector<Motion> smooth_rows(std::uint64_t seed, bool horizontal) {
  std::mt19937_64 random(testing::salted(seed));
  std::uniform_real_distribution<double> bend(-0.3, 0.3);
  std::vector<Motion> motions;
  for (int row = 0; row < 16; ++row) {
    const std::size_t first = motions.size();
    const double turn = bend(random), lift = horizontal ? 0 : bend(random);
    double heading = 2 * bend(random) + (row % 2 ? kPi : 0);
    Vec3 at{row % 2 ? 15.0 : 5.0, 2.0 + row, 3.0 + double(random() % 3)};
    for (int i = 0; i < 60; ++i, heading += 0.15 * turn) {
      const Vec3 to = at + Vec3{0.15 * std::cos(heading), 0.15 * std::sin(heading),
                                0.1 * lift * std::cos(0.2 * i)};
      motions.push_back(line(at, to, i));
      at = to;
    }
    if (row % 5 == 0)
      for (std::size_t i = 0; i < 60; ++i) motions.push_back(motions[first + i]);
  }
  return motions;
}

TEST(Carve, PacksNeverChangeABit) {
  Tool bull = mill(ToolType::bullmill, 5);
  bull.corner_radius = 1;
  const Tool flat = mill(ToolType::endmill, 5), ball = mill(ToolType::ballmill, 5);
  for (std::uint64_t seed = 1; seed <= testing::rounds(3); ++seed) {
    for (const Tool& tool : {flat, bull, ball}) expect_reference(tool, smooth_rows(seed, true));
    expect_reference(ball, smooth_rows(seed, false));
  }
}

// A spiral of narrow arcs at two levels, with lines across: arcs beat arcs, and lines them.
TEST(Carve, ArcsAreDroppedWithoutChangingABit) {
  for (const ToolType type : {ToolType::endmill, ToolType::bullmill}) {
    Tool tool = mill(type, 4);
    tool.corner_radius = type == ToolType::bullmill ? 1 : 0;
    std::vector<Motion> motions;
    Vec3 at{10, 10, 5};
    for (int i = 0; i < 120; ++i) {
      if (i == 60) at = {9, 11, 4};
      if (i % 13 == 0) motions.push_back(line(at, at + Vec3{1, 0.5, 0}, i));
      motions.push_back(half_circle(at, (i % 2 ? -1 : 1) * (0.2 + 0.1 * (i % 60)), kPi));
      at = motions.back().end;
    }
    expect_reference(tool, motions);
  }
}

// Bores with a plunge at their start, helices of less and more than a turn, and arcs in G18 and
// G19.
TEST(Carve, HelicesAndUprightArcsEqualTheReference) {
  for (const ToolType type : {ToolType::endmill, ToolType::bullmill, ToolType::ballmill}) {
    Tool tool = mill(type, 3);
    tool.corner_radius = type == ToolType::bullmill ? 0.5 : 0;
    std::mt19937_64 random(testing::salted(5));
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Motion> motions;
    for (int i = 0; i < 14; ++i) {
      const Vec3 start{3 + 14 * unit(random), 3 + 14 * unit(random), 6 + 3 * unit(random)};
      if (i % 2 == 0) motions.push_back(line(start, start - Vec3{0, 0, 1}, i));
      const double radius = 0.3 + 3 * unit(random);
      Motion m = line(start, start, i);
      m.kind = MotionKind::arc;
      m.center = start - Vec3{radius, 0, 0};
      m.sweep = (i % 3 ? 6 : -1) * kPi * unit(random);
      m.rise = -5 * unit(random);
      if (i % 4 == 3) {
        m.rise = 0;
        m.axis = i % 8 == 3 ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
        m.center = start - radius * (i % 8 == 3 ? Vec3{0.6, 0, 0.8} : Vec3{0, -0.8, 0.6});
      }
      m.radius = radius;
      motions.push_back(m);
    }
    expect_reference(tool, motions);
  }
}

// Bars, off the axis too, square ones, and turned parts that are milled.
TEST(Carve, TurningEqualsTheReference) {
  testing::Random r(8);
  std::vector<Tool> tools = testing::inserts();
  tools.push_back(mill(ToolType::endmill, 3));
  for (int round = 0; round < 24; ++round) {
    std::vector<Motion> motions = testing::turning_moves(r, 150, 4, 8);
    if (round % 4 == 3)
      for (int i = 0; i < 6; ++i) {
        motions.push_back(line({r(-5, 5), r(-5, 5), 6}, {r(-5, 5), r(-5, 5), 6}));
        motions.back().tool = 5;
      }
    StockShape shape = box_stock({-4, -4, 0}, {4, 4, 8});
    const StockShape::Kind kinds[] = {StockShape::Kind::cylinder, StockShape::Kind::tube,
                                      StockShape::Kind::cylinder, StockShape::Kind::box};
    shape.kind = kinds[round / 4 % 4];
    shape.outer_radius = 4, shape.inner_radius = 1;
    if (round % 8 == 7) shape.axis_point = {0.25, 0, 0};
    EXPECT_EQ(voxels(carve(shape, motions, tools, {.voxel = 0.3, .threads = 1 + round % 3})),
              reference(shape, motions, tools, 0.3))
        << "round " << round;
  }
}

TEST(Carve, GivesTheSameForAnyNumberOfThreads) {
  const std::vector<Tool> tools{mill(ToolType::endmill, 3)};
  const std::vector<Motion> motions = random_motions(3, 100);
  const StockShape shape = box_stock({0, 0, 0}, {20, 20, 9});
  const auto one = voxels(carve(shape, motions, tools, {.voxel = 0.2, .threads = 1}));
  EXPECT_EQ(one, voxels(carve(shape, motions, tools, {.voxel = 0.2, .threads = 2})));
  EXPECT_EQ(one, voxels(carve(shape, motions, tools, {.voxel = 0.2, .threads = 7})));
}

TEST(Carve, ShapeDoesNotDependOnTheOrderOfMoves) {
  const std::vector<Tool> tools{mill(ToolType::ballmill, 3)};
  std::vector<Motion> motions = random_motions(4, 60);
  const StockShape shape = box_stock({0, 0, 0}, {20, 20, 9});
  auto strip = [](std::vector<Voxel> list) {
    for (Voxel& v : list) std::get<2>(v) = 0;
    return list;
  };
  const auto forward = strip(voxels(carve(shape, motions, tools, {.voxel = 0.4})));
  std::reverse(motions.begin(), motions.end());
  EXPECT_EQ(forward, strip(voxels(carve(shape, motions, tools, {.voxel = 0.4}))));
}

TEST(Carve, CuttingTwiceChangesNothing) {
  const std::vector<Tool> tools{mill(ToolType::endmill, 3)};
  std::vector<Motion> motions = random_motions(5, 40);
  const StockShape shape = box_stock({0, 0, 0}, {20, 20, 9});
  const auto once = voxels(carve(shape, motions, tools, {.voxel = 0.4}));
  const std::size_t n = motions.size();
  for (std::size_t i = 0; i < n; ++i) motions.push_back(motions[i]);
  EXPECT_EQ(once, voxels(carve(shape, motions, tools, {.voxel = 0.4})));
}

TEST(Carve, VolumeNeverGrows) {
  const std::vector<Tool> tools{mill(ToolType::endmill, 3)};
  const std::vector<Motion> motions = random_motions(6, 40);
  const StockShape shape = box_stock({0, 0, 0}, {20, 20, 9});
  double last = 1e9;
  for (std::size_t n = 0; n <= motions.size(); n += 8) {
    const double volume =
        counted_volume(carve(shape, std::span(motions).first(n), tools, {.voxel = 0.5}));
    EXPECT_LE(volume, last);
    last = volume;
  }
}

TEST(Carve, CoincidentSurfacesAreDecided) {
  const std::vector<Tool> tools{mill(ToolType::endmill, 4)};
  const StockShape shape = box_stock({0, 0, 0}, {20, 10, 5});
  const auto inside = [&](const Stock& s, Vec3 p) { return is_inside(s.distance(p)); };
  // A floor exactly on the bottom leaves no skin.
  const Stock hole =
      carve(shape, std::vector{line({-5, 5, 0}, {25, 5, 0})}, tools, {.voxel = 0.25});
  for (const double z : {0.0, 1e-7, 1e-3, 1.0}) EXPECT_FALSE(inside(hole, {10, 5, z})) << z;
  // A pass along a face removes nothing.
  const Stock whole =
      carve(shape, std::vector{line({-5, 12, 0}, {25, 12, 0})}, tools, {.voxel = 0.25});
  EXPECT_EQ(whole.owner({10, 10, 2.5}), kStockOwner);
  EXPECT_TRUE(inside(whole, {10, 9.999, 2.5}));
  // Touching passes leave no fin.
  const Stock fin =
      carve(shape, std::vector{line({-5, 3, 2}, {25, 3, 2}), line({-5, 7, 2}, {25, 7, 2})}, tools,
            {.voxel = 0.25});
  for (const double z : {2.001, 3.0, 4.999}) EXPECT_FALSE(inside(fin, {10, 5, z})) << z;
}

TEST(Carve, EveryActiveVoxelKnowsItsOwner) {
  const std::vector<Tool> tools{mill(ToolType::endmill, 4)};
  const std::vector<Motion> motions{line({-5, 5, 3}, {25, 5, 3}, 10),
                                    line({10, -5, 2}, {10, 15, 2}, 20)};
  const Stock stock = carve(box_stock({0, 0, 0}, {20, 10, 5}), motions, tools, {.voxel = 0.25});
  EXPECT_EQ(stock.owner({3, 5, 3}), 0);
  EXPECT_EQ(stock.owner({10, 5, 2}), 1);
  EXPECT_EQ(stock.owner({3, 1, 5}), kStockOwner);
  for (const auto& [at, d, owner] : voxels(stock)) {
    const Vec3 p{lattice_position(0.25, at.x(), kLatticeShift.x),
                 lattice_position(0.25, at.y(), kLatticeShift.y),
                 lattice_position(0.25, at.z(), kLatticeShift.z)};
    ASSERT_EQ(stock.owner(p), owner);
    ASSERT_EQ(float(stock.distance(p)), d);
  }
}

// Exact questions need no grid.
TEST(Carve, SamplesNothingThatIsNotKept) {
  const std::vector<Tool> tools{mill(ToolType::endmill, 4)};
  const std::vector<Motion> motions{line({-5, 5, 3}, {25, 5, 3})};
  const StockShape shape = box_stock({0, 0, 0}, {20, 10, 5});
  const Stock kept = carve(shape, motions, tools, {.voxel = 0.25});
  EXPECT_GT(kept.active_voxels(), 0u);
  CarvePlan slabs{.voxel = 0.25, .threads = 1, .grid_mesh = true, .no_slabs = ""};
  slabs.max_memory =  // more than is expected, and less than a mesh in one piece may take
      static_cast<std::size_t>(carve(shape, motions, tools, slabs).memory_whole()) + 4'000'000;
  for (const CarvePlan& options : {CarvePlan{.voxel = 0.25, .keep_grid = false}, slabs}) {
    const Stock stock = carve(shape, motions, tools, options);
    EXPECT_EQ(stock.in_slabs(), options.keep_grid);
    EXPECT_EQ(stock.active_voxels(), 0u);
    EXPECT_EQ(stock.grid().voxels, nullptr);
    for (const Vec3& p : {Vec3{10, 5, 4}, Vec3{10, 2, 4}, Vec3{1, 9, 1}}) {
      EXPECT_EQ(stock.distance(p), kept.distance(p));
      EXPECT_EQ(stock.owner(p), kept.owner(p));
    }
  }
}

TEST(Carve, AMeshThatIsLargerThanExpectedGoesOnInSlabs) {
  const std::vector<Tool> tools{mill(ToolType::endmill, 4)};
  const std::vector<Motion> motions{line({-5, 5, 3}, {25, 5, 3})};
  const StockShape shape = box_stock({0, 0, 0}, {20, 10, 5});
  CarvePlan plan{.voxel = 0.25, .threads = 1, .max_memory = 100'000'000, .keep_grid = false};
  Stock stock = carve(shape, motions, tools, plan);
  stock.plan_grid_mesh(0.25, 1000, "");
  EXPECT_FALSE(stock.in_slabs());
  EXPECT_LT(stock.mesh_room(), 100e6);
  EXPECT_GT(stock.mesh_room(), 100e6 - stock.memory_expected());
  stock.plan_slabs();
  EXPECT_TRUE(stock.in_slabs());
  stock.plan_grid_mesh(0.25, 1000, "a report needs the whole mesh");
  EXPECT_FALSE(stock.in_slabs());
  try {
    stock.plan_slabs();
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), "memory");
    EXPECT_NE(std::string(e.what()).find("a report needs the whole mesh"), std::string::npos);
  }
}

TEST(DefaultVoxel, FollowsTheRule) {
  EXPECT_EQ(default_voxel(box_stock({0, -60, 0}, {100, 0, 10}), 2.5).voxel, 0.25);
  EXPECT_EQ(default_voxel(box_stock({0, 0, 0}, {51, 51, 51}), 0).voxel, 0.1);
  EXPECT_EQ(default_voxel(box_stock({0, 0, 0}, {200, 200, 40}), 1).voxel, 0.1);
  EXPECT_EQ(default_voxel(box_stock({0, 0, 0}, {400, 1, 1}), 0).voxel, 1.0);
  EXPECT_EQ(default_voxel(box_stock({0, 0, 0}, {10000, 1, 1}), 0).voxel, 25.0);
}

TEST(Carve, RefusesBadVoxels) {
  const std::vector<Tool> tools{mill(ToolType::endmill, 4)};
  const std::vector<Motion> motions{line({-5, 5, 3}, {25, 5, 3})};
  const StockShape shape = box_stock({0, 0, 0}, {100, 100, 50});
  for (const double voxel : {-1.0, 1e-9, 1e-4, 0.003, double(NAN), double(INFINITY)})
    EXPECT_THROW(carve(shape, motions, tools, {.voxel = voxel, .max_memory = std::size_t(1) << 30}),
                 Error)
        << voxel;
}

}  // namespace
}  // namespace mrsim
