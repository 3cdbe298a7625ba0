#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "removal/part/part_field.h"
#include "removal/part/stock.h"
#include "support/moves.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/tools.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using testing::arc;
using testing::line;

constexpr double kListBand = 0.01;  // mm

// Within the band of the surface, or everywhere, both are the same; deeper the list has what is
// nearer to the surface in its box, on the same side.
void expect_list_holds(const FieldSample& whole, const FieldSample& list, bool everywhere) {
  if (everywhere || std::abs(whole.distance) <= kListBand) {
    EXPECT_EQ(whole.distance, list.distance);
    EXPECT_EQ(whole.owner, list.owner);
    return;
  }
  EXPECT_EQ(whole.distance < 0, list.distance < 0);
  EXPECT_GE(std::abs(list.distance), std::abs(whole.distance));
}

// A list that was narrowed for a box, or tier by tier towards it, gives the same bits in it:
// `everywhere`, so deep in the material as well, where the mesher's searches begin.
void expect_lists_hold(const PartField& field, const Vec3& room, std::size_t least,
                       bool everywhere) {
  const Candidates all = field.all();
  std::mt19937_64 random(testing::salted(5));
  std::uniform_real_distribution<double> u(-1, 1);
  std::size_t mixed = 0;
  for (int round = 0; round < 400; ++round) {
    const Vec3 center{room.x * u(random), room.y * u(random), room.z * u(random)};
    const Vec3 half = (round % 2 ? 0.3 : 0.1) * Vec3{1, round % 5 ? 1.001 : 0.6, 1};
    const Box3 box{center - half, center + half};
    const auto descent = field.descent(center, all);
    Candidates lists[2];
    if (descent->enter(1, inflated(box, 0.2), kListBand, true) != ExactField::Region::mixed)
      continue;
    const auto region = descent->finish(2, box, kListBand, lists[1]);
    EXPECT_EQ(field.restrict_to(box, kListBand, all, lists[0]), region);
    if (region != ExactField::Region::mixed) continue;
    ++mixed;
    for (int k = 0; k < 40; ++k) {
      const Vec3 p = center + Vec3{half.x * u(random), half.y * u(random), half.z * u(random)};
      const FieldSample s = field.sample(p, all);
      for (const Candidates& list : lists) expect_list_holds(s, field.sample(p, list), everywhere);
    }
  }
  EXPECT_GT(mixed, least);
}

TEST(PartFieldLists, HoldInTheWholeBox) {
  std::vector<Motion> motions;
  for (int row = 0; row < 40; ++row)
    for (int k = 0; k < 40; ++k) {
      const auto at = [&](int i) {
        return Vec3{-4 + 0.2 * i, -4 + 0.2 * row, 0.3 * std::sin(0.2 * i + 0.1 * row)};
      };
      motions.push_back(line(at(k), at(k + 1)));
    }
  motions.push_back(arc({3, 0, -0.5}, {0, 0, -0.5}, {0, 0, 1}, 5));
  const Tool ball = testing::ballmill(6);
  const StockShape shape = testing::box_stock({-8, -8, -5}, {8, 8, 4});
  expect_lists_hold(PartField(StockSolid(shape), SweepTable(motions, {&ball, 1})), {6, 6, 2}, 50,
                    true);
}

// A thread mill of eight teeth: up, in by a quarter turn, around, out.
TEST(PartFieldLists, OfThreadMillsHoldInTheWholeBox) {
  const std::vector<Motion> motions{line({0, 0, 2}, {0, 0, -12}),
                                    line({0, 0, -12}, {1, -1, -12}),
                                    arc({1, -1, -12}, {1, 0, -12}, {0, 0, 1}, kPi / 2),
                                    arc({2, 0, -12}, {0, 0, -12}, {0, 0, 1}, kTwoPi, 1.5),
                                    line({2, 0, -10.5}, {0, 0, -10.5}),
                                    line({0, 0, -10.5}, {0, 0, 5})};
  const Tool tool = testing::thread_mill(2.1, 2.95);
  const StockShape shape = testing::box_stock({-8, -8, -15}, {8, 8, 0});
  // The undersides of undercutting tools narrow lists, which tells nothing of deeper places.
  expect_lists_hold(PartField(StockSolid(shape), SweepTable(motions, {&tool, 1})), {5, 5, 13}, 30,
                    false);
}

}  // namespace
}  // namespace mrsim
