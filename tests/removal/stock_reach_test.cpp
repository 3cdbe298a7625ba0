// How much of a program cuts beside the stock that it states.
#include "removal/part/stock_reach.h"

#include "support/moves.h"

#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using testing::line;

TEST(StockReach, CountsWhatPassesByAtMoreThanTheTool) {
  Tool tool;
  tool.diameter = 6;
  const std::vector<Tool> tools{tool};
  const Box3 stock{{0, 0, -10}, {100, 50, 0}};
  const auto share = [&](std::vector<Motion> motions) {
    return share_beside(motions, tools, stock);
  };
  EXPECT_EQ(share({line({-5, 10, -1}, {105, 10, -1})}), 0);
  EXPECT_EQ(share({line({-5, -5, -1}, {105, -5, -1})}), 0) << "runs out beside the edge";
  EXPECT_EQ(share({line({0, -7, -1}, {100, -7, -1})}), 1);
  EXPECT_EQ(share({line({0, -7, 1}, {100, -7, 1})}), 0) << "above the top";
  EXPECT_EQ(share({line({0, 5, -11}, {100, 5, -11})}), 0) << "into the table";
  EXPECT_EQ(share({line({0, 5, -17}, {100, 5, -17})}), 1);
  EXPECT_EQ(share({line({0, 0, -1}, {60, 0, -1}), line({200, 0, -1}, {220, 0, -1})}), 0.25);
  EXPECT_EQ(share({}), 0);
}

}  // namespace
}  // namespace mrsim
