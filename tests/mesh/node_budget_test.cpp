// What rounds of splitting may take before the tolerance is raised.
#include "mesh/cells/node_budget.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using detail::NodeBudget;

constexpr std::size_t kMost = 80'000, kSmall = 500;  ///< nodes
constexpr double kWish = 0.01, kMostTolerance = 0.04;

NodeBudget after_rounds(int rounds, std::size_t drawn) {
  NodeBudget budget(kMost, kMostTolerance, false);
  budget.begin(kSmall);
  budget.add_failed(1);
  for (int k = 0; k < rounds; ++k) budget.add_round(drawn);
  return budget;
}

TEST(NodeBudget, ARoundCountsByWhatIsDrawnInIt) {
  EXPECT_TRUE(after_rounds(4, kMost).fits(1, kSmall, kWish));
  EXPECT_FALSE(after_rounds(5, kMost).fits(1, kSmall, kWish));
  EXPECT_TRUE(after_rounds(8, kMost / 2).fits(1, kSmall, kWish));
  EXPECT_FALSE(after_rounds(9, kMost / 2).fits(1, kSmall, kWish));
}

TEST(NodeBudget, ARoundThatDrawsLittleCountsAsAnEighthOfTheMostNodes) {
  EXPECT_TRUE(after_rounds(32, 1).fits(1, kSmall, kWish));
  EXPECT_FALSE(after_rounds(33, 1).fits(1, kSmall, kWish));
}

TEST(NodeBudget, FewCellsAreSplitHoweverLongTheRoundsWhereTheToleranceMayNotBeRaised) {
  const NodeBudget budget = after_rounds(33, 1);
  EXPECT_TRUE(budget.may_raise(kWish));
  EXPECT_FALSE(budget.may_raise(kMostTolerance));
  EXPECT_TRUE(budget.fits(1, kSmall, kMostTolerance));
  EXPECT_FALSE(budget.fits(kSmall, kSmall, kMostTolerance));
}

TEST(NodeBudget, EverythingFitsWithoutALimit) {
  NodeBudget budget(0, 0, false);
  budget.begin(kSmall);
  for (int k = 0; k < 100; ++k) budget.add_round(kMost);
  EXPECT_TRUE(budget.fits(kMost, 100 * kMost, kWish));
}

}  // namespace
}  // namespace mrsim
