#include "mesh/solid/owner_set.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

TEST(OwnerSet, GivesEachOwnerOnceAscending) {
  OwnerSet set;
  EXPECT_TRUE(set.sorted().empty());
  set.add(std::vector<std::int32_t>{7, 7, -1, 3, 64, 63, 7});
  set.add(std::vector<std::int32_t>{3, 1000000});
  EXPECT_EQ(set.sorted(), (std::vector<std::int32_t>{-1, 3, 7, 63, 64, 1000000}));
  set.clear();
  EXPECT_TRUE(set.sorted().empty());
}

// A mesh from elsewhere may name any number.
TEST(OwnerSet, TakesWildNumbers) {
  constexpr std::int32_t kLow = std::numeric_limits<std::int32_t>::min(),
                         kHigh = std::numeric_limits<std::int32_t>::max();
  OwnerSet set;
  set.add(std::vector<std::int32_t>{kHigh, 5, -1, kLow, -2, 1 << 26, kHigh, kLow});
  EXPECT_EQ(set.sorted(), (std::vector<std::int32_t>{kLow, -2, -1, 5, 1 << 26, kHigh}));
}

}  // namespace
}  // namespace mrsim
