#include "core/process/ordered.h"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

TEST(MakeInOrderOnThreads, TakesEachPartOnceInItsOrder) {
  for (const int threads : {1, 2, 7})
    for (const std::size_t count : {0u, 1u, 2u, 7u, 8u, 100u})
      for (const std::size_t together : {1u, 3u, 16u}) {
        std::vector<std::size_t> taken;
        make_in_order(
            count, threads, [](std::size_t k) { return 3 * k; },
            [&](std::size_t part) { taken.push_back(part); }, together);
        ASSERT_EQ(taken.size(), count);
        for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(taken[k], 3 * k);
      }
}

// Parts of very different length, some of them waiting for their turn: no more than told are there.
TEST(MakeInOrderOnThreads, KeepsFewParts) {
  for (const int threads : {1, 2, 7})
    for (const std::size_t together : {1u, 5u}) {
      std::atomic<int> there{0}, most{0};
      make_in_order(
          200, threads,
          [&](std::size_t k) {
            const int now = ++there;
            for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) {
            }
            if (k % 13 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
            return k;
          },
          [&](std::size_t) { --there; }, together);
      EXPECT_EQ(there, 0);
      EXPECT_LE(most, 2 * (static_cast<int>(together) + threads) - 2);
    }
}

TEST(MakeInOrderOnThreads, EndsWhenTakingFails) {
  for (const int threads : {1, 2, 7})
    EXPECT_THROW(make_in_order(
                     100, threads, [](std::size_t k) { return k; },
                     [](std::size_t k) {
                       if (k == 30) throw std::runtime_error("full");
                     },
                     4),
                 std::runtime_error);
}

TEST(MakeInOrderOnThreads, ThrowsWhatTheFirstPartAtFaultThrows) {
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
