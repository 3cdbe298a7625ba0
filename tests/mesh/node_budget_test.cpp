// What rounds of splitting may take before the tolerance is raised.
#include "mesh/cells/node_budget.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using detail::NodeBudget;

constexpr std::size_t kMost = 80'000, kSmall = 500;  ///< nodes
constexpr double kWish = 0.01, kMostTolerance = 0.04;

NodeBudget after_rounds(int rounds, std::size_t drawn, double tolerance = kWish) {
  NodeBudget budget(kMost, tolerance, kMostTolerance);
  budget.begin(kSmall);
  budget.add_failed(1);
  for (int k = 0; k < rounds; ++k) budget.add_round(drawn);
  return budget;
}

TEST(NodeBudget, ARoundCountsByWhatIsDrawnInIt) {
  EXPECT_TRUE(after_rounds(4, kMost).fits(1, kSmall));
  EXPECT_FALSE(after_rounds(5, kMost).fits(1, kSmall));
  EXPECT_TRUE(after_rounds(8, kMost / 2).fits(1, kSmall));
  EXPECT_FALSE(after_rounds(9, kMost / 2).fits(1, kSmall));
}

TEST(NodeBudget, ARoundThatDrawsLittleCountsAsAnEighthOfTheMostNodes) {
  EXPECT_TRUE(after_rounds(32, 1).fits(1, kSmall));
  EXPECT_FALSE(after_rounds(33, 1).fits(1, kSmall));
}

TEST(NodeBudget, FewCellsAreSplitHoweverLongTheRoundsWhereTheToleranceMayNotBeRaised) {
  EXPECT_TRUE(after_rounds(33, 1).may_raise());
  const NodeBudget budget = after_rounds(33, 1, kMostTolerance);
  EXPECT_FALSE(budget.may_raise());
  EXPECT_TRUE(budget.fits(1, kSmall));
  EXPECT_FALSE(budget.fits(kSmall, kSmall));
}

TEST(NodeBudget, AnotherOctreeHasTwiceTheToleranceAndFewerNodes) {
  NodeBudget budget(kMost, kWish, 8 * kWish);
  for (int k = 0; k < 2; ++k) {
    const double tolerance = budget.tolerance(), most = budget.most();
    ASSERT_TRUE(budget.begin_again(false));
    EXPECT_DOUBLE_EQ(budget.tolerance(), 2 * tolerance);
    EXPECT_DOUBLE_EQ(budget.most(), 0.7 * most);
  }
  EXPECT_FALSE(budget.begin_again(false));
}

TEST(NodeBudget, AnotherOctreeHasTheToleranceToWhichItWasRaisedInVain) {
  NodeBudget budget = after_rounds(1, kMost);
  budget.raise(kMost);
  ASSERT_TRUE(budget.begin_again(true));
  EXPECT_DOUBLE_EQ(budget.tolerance(), 2 * kWish);
  EXPECT_FALSE(budget.begin_again(true));  // 4 kWish are more than nodes may raise it to
}

TEST(NodeBudget, NoOtherOctreeIsMadeWhereCreasesAreCloserThanTheCells) {
  for (const bool is_dense : {false, true}) {
    NodeBudget budget(kMost, kWish, 16 * kWish);
    budget.begin(kMost / 2);
    budget.add_round(is_dense ? kMost * 2 / 3 : kMost / 2);
    EXPECT_EQ(budget.begin_again(true), !is_dense);
  }
}

TEST(NodeBudget, NoOtherOctreeIsMadeAfterManyRounds) {
  EXPECT_TRUE(after_rounds(4, kMost).begin_again(true));
  EXPECT_FALSE(after_rounds(5, kMost).begin_again(true));
}

TEST(NodeBudget, EverythingFitsWithoutALimit) {
  NodeBudget budget(0, kWish, 0);
  budget.begin(kSmall);
  for (int k = 0; k < 100; ++k) budget.add_round(kMost);
  EXPECT_TRUE(budget.fits(kMost, 100 * kMost));
}

}  // namespace
}  // namespace mrsim
