#include "core/numbers/trig.h"

#include "core/numbers/units.h"
#include "support/random.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

constexpr double kUlp = 2.3e-16;

TEST(Trig, SinCosAgreeWithLongDouble) {
  std::mt19937_64 random(testing::salted(1));
  std::uniform_real_distribution<double> angle(-1000, 1000);
  for (int i = 0; i < 100000; ++i) {
    const double a = angle(random);
    const SinCos sc = sincos(a);
    EXPECT_NEAR(sc.sin, static_cast<double>(std::sin(static_cast<long double>(a))), 2 * kUlp);
    EXPECT_NEAR(sc.cos, static_cast<double>(std::cos(static_cast<long double>(a))), 2 * kUlp);
  }
}

TEST(Trig, DegreesAreExactAtRightAngles) {
  for (int k = -8; k <= 8; ++k) {
    const SinCos sc = sincos_deg(90.0 * k);
    EXPECT_EQ(sc.sin, k % 2 == 0 ? 0.0 : ((k % 4 + 4) % 4 == 1 ? 1.0 : -1.0));
    EXPECT_EQ(sc.cos, k % 2 != 0 ? 0.0 : ((k % 4 + 4) % 4 == 0 ? 1.0 : -1.0));
  }
}

TEST(Trig, Atan2AgreesWithLongDouble) {
  std::mt19937_64 random(testing::salted(2));
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int i = 0; i < 100000; ++i) {
    const double x = coordinate(random), y = coordinate(random);
    EXPECT_NEAR(
        mrsim::atan2(y, x),
        static_cast<double>(std::atan2(static_cast<long double>(y), static_cast<long double>(x))),
        4 * kUlp);
  }
  EXPECT_EQ(mrsim::atan2(0, 0), 0);
  EXPECT_EQ(mrsim::atan2(0, -1), kPi);
}

}  // namespace
}  // namespace mrsim
