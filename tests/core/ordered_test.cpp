#include "core/ordered.h"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

TEST(MakeInOrder, TakesEachPartOnceInItsOrder) {
  for (const int threads : {1, 2, 7})
    for (const std::size_t count : {0u, 1u, 2u, 7u, 8u, 100u}) {
      std::vector<std::size_t> taken;
      make_in_order(
          count, threads, [](std::size_t k) { return 3 * k; },
          [&](std::size_t part) { taken.push_back(part); });
      ASSERT_EQ(taken.size(), count);
      for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(taken[k], 3 * k);
    }
}

TEST(MakeInOrder, ThrowsWhatTheFirstPartAtFaultThrows) {
  for (const int threads : {1, 2, 7}) {
    std::size_t taken = 0;
    try {
      make_in_order(
          50, threads,
          [](std::size_t k) {
            if (k == 20 || k == 21 || k == 40) throw std::runtime_error(std::to_string(k));
            return k;
          },
          [&](std::size_t) { ++taken; });
      FAIL();
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "20");
    }
    EXPECT_EQ(taken, 20u);
  }
}

}  // namespace
}  // namespace mrsim
