// Holes by turns of helices: many sweeps with one wall, of which lists keep and evaluate few.
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "removal/part/part_field.h"
#include "removal/prune/list_candidates.h"
#include "removal/simd/sweep_kernels.h"
#include "sweep_support.h"

#include <limits>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using testing::arc;
using testing::line;
using testing::Random;
using testing::same_bits;

constexpr double kBand = 0.5;  ///< mm: where lists give the distance
constexpr Box3 kStock = {{-20, -20, -20}, {20, 20, 0}};

// Bores that overlap, by whole turns or by parts of them, and a few lines through them.
std::vector<Motion> bores(Random& r, const Tool& tool) {
  std::vector<Motion> motions;
  for (int bore = 0; bore < 6; ++bore) {
    const Vec3 center = {r(-8, 8), r(-8, 8), 0};
    const double radius = r(0.2, 1.2) * tool.diameter, pitch = r(0.3, 2);
    const int parts = bore % 3 == 0 ? 2 : 1;
    double z = 0;
    for (int k = 0; k < 12 * parts; ++k, z -= pitch / parts) {
      const double side = k % parts ? -1 : 1;
      motions.push_back(arc({center.x + side * radius, center.y, z}, {center.x, center.y, z},
                            {0, 0, 1}, kTwoPi / parts, -pitch / parts));
    }
  }
  for (int k = 0; k < 4; ++k) {
    const double z = r(-8, -1);
    motions.push_back(line({-20, r(-9, 9), z}, {20, r(-9, 9), z}));
  }
  return motions;
}

std::vector<Tool> boring_mills() {
  std::vector<Tool> tools(3);
  for (Tool& tool : tools) tool.diameter = 4;
  tools[1].corner_radius = 0.7;
  tools[1].type = ToolType::bullmill;
  tools[2].type = ToolType::ballmill;
  return tools;
}

TEST(Bores, AreAsNearInListsAsOneByOne) {
  Random r(31);
  for (const Tool& tool : boring_mills()) {
    const SweepTable s(bores(r, tool), std::span(&tool, 1));
    for (int round = 0; round < 40; ++round) {
      std::vector<std::uint32_t> ids;
      for (std::uint32_t i = 0; i < s.size(); ++i)
        if (r(0, 1) < 0.8) ids.push_back(i);
      CandidateList list;
      list_candidates(s, ids, {0, 0, 0}, list);
      PointColumns points{};
      for (points.count = 0; points.count < PointColumns::kMost; ++points.count) {
        const std::size_t k = points.count;
        points.x[k] = r(-15, 15), points.y[k] = r(-15, 15), points.z[k] = r(-18, 2);
        points.least[k] = std::numeric_limits<double>::infinity();
      }
      least_distances(s, list, points);
      for (std::size_t k = 0; k < points.count; ++k) {
        const Vec3 p = {points.x[k], points.y[k], points.z[k]};
        double least = std::numeric_limits<double>::infinity();
        std::uint32_t nearest = 0;
        for (const std::uint32_t id : ids)
          if (const double d = s.distance(id, p); d < least) least = d, nearest = id;
        ASSERT_TRUE(same_bits(points.least[k], least));
        ASSERT_EQ(points.nearest[k], nearest);
        const SweepTable::Nearest one = s.nearest(ids, p);
        ASSERT_TRUE(same_bits(one.distance, least));
        ASSERT_EQ(one.sweep, nearest);
      }
    }
  }
}

TEST(Bores, KeepWhatDecidesInARegion) {
  Random r(32);
  StockShape shape;
  shape.box = kStock;
  for (const Tool& tool : boring_mills()) {
    const PartField field{StockSolid(shape), SweepTable(bores(r, tool), std::span(&tool, 1))};
    const Candidates all = field.all();
    for (int round = 0; round < 600; ++round) {
      const double half = r(0.05, 2);
      const Vec3 at = {r(-12, 12), r(-12, 12), r(-18, 0)}, corner = {half, half, r(0.5, 1) * half};
      Candidates left;
      if (field.restrict_to({at - corner, at + corner}, kBand, all, left) !=
          ExactField::Region::mixed)
        continue;
      for (int k = 0; k < 20; ++k) {
        const Vec3 p = at + Vec3{r(-1, 1) * corner.x, r(-1, 1) * corner.y, r(-1, 1) * corner.z};
        const FieldSample few = field.sample(p, left), whole = field.sample(p, all);
        ASSERT_EQ(is_inside(few.distance), is_inside(whole.distance));
        if (std::abs(whole.distance) > kBand) continue;
        ASSERT_TRUE(same_bits(few.distance, whole.distance));
        ASSERT_EQ(few.owner, whole.owner);
      }
    }
  }
}

TEST(Bores, NeedOneTurnBesideTheWallAboveThem) {
  Tool tool;
  tool.diameter = 4;
  std::vector<Motion> turns;
  for (int k = 0; k < 30; ++k)
    turns.push_back(arc({3, 0, -0.5 * k}, {0, 0, -0.5 * k}, {0, 0, 1}, kTwoPi, -0.5));
  StockShape shape;
  shape.box = kStock;
  const PartField field{StockSolid(shape), SweepTable(turns, std::span(&tool, 1))};
  const auto left = [&](double z) {
    Candidates sweeps;
    field.restrict_to({{4.9, -0.1, z - 0.1}, {5.1, 0.1, z + 0.1}}, kBand, field.all(), sweeps);
    return sweeps.size();
  };
  EXPECT_LE(left(-1.2), 4u);
  EXPECT_LE(left(-14), 4u);
}

}  // namespace
}  // namespace mrsim
