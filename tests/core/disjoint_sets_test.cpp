#include "core/numbers/disjoint_sets.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

TEST(DisjointSets, EachNumberIsASetAtFirst) {
  DisjointSets sets(3);
  ASSERT_EQ(sets.size(), 3u);
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(sets.least(i), i);
}

TEST(DisjointSets, JoinedNumbersHaveTheSameLeastNumber) {
  DisjointSets sets(6);
  EXPECT_EQ(sets.join(5, 3), 3u);
  sets.join(4, 5);
  sets.join(0, 2);
  for (const std::uint32_t i : {3u, 4u, 5u}) EXPECT_EQ(sets.least(i), 3u);
  for (const std::uint32_t i : {0u, 2u}) EXPECT_EQ(sets.least(i), 0u);
  EXPECT_EQ(sets.least(1), 1u);
  sets.join(2, 4);
  EXPECT_EQ(sets.least(5), 0u);
}

TEST(DisjointSets, GrowingKeepsWhatWasJoined) {
  DisjointSets sets(2);
  sets.join(0, 1);
  sets.grow(4);
  EXPECT_EQ(sets.least(1), 0u);
  EXPECT_EQ(sets.least(2), 2u);
  EXPECT_EQ(sets.least(3), 3u);
}

}  // namespace
}  // namespace mrsim
