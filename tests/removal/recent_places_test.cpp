// Rapids between places where the cutter has been: what is called clear is, at points of the cutter
// on the rapid.
#include "removal/collision/recent_places.h"

#include "collision_support.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "removal/collision/collision_movers.h"
#include "removal/sweep/sweep_table.h"
#include "removal/tool/tool.h"
#include "support/random.h"
#include "support/tools.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using testing::Moves;

constexpr double kAllowed = 0.01;

bool keeps(const std::vector<Motion>& motions, const Tool& tool) {
  return keeps_to_recent_places(motions, motions.size() - 1, make_tool_shape(tool).cutter, 0,
                                kAllowed);
}

// The most that any of the cuts is away from a point of the cutter on the last motion.
double deepest(const std::vector<Motion>& motions, const Tool& tool) {
  const std::vector<Tool> tools{tool};
  const SweepTable cuts(motions, tools);
  const Profile cutter = make_tool_shape(tool).cutter;
  const Motion& rapid = motions.back();
  double most = 0;
  for (int step = 0; step <= 24; ++step) {
    const Vec3 tip = rapid.start + step / 24.0 * (rapid.end - rapid.start);
    for (const double z : {0.0, 0.02, 0.1, 0.4, 1.0, 2.0, 3.5})
      for (int turn = 0; turn < 48; ++turn) {
        const auto [sin, cos] = sincos(kTwoPi * turn / 48);
        const double r = cutter.max_radius_below(cutter.bottom() + z);
        const Vec3 p = tip + Vec3{r * cos, r * sin, z};
        double least = 1e9;
        for (std::size_t i = 0; i < cuts.size(); ++i) least = std::min(least, cuts.distance(i, p));
        most = std::max(most, least);
      }
  }
  return most;
}

// Half circles one step beside another, each reached on the way of the last one and a little up.
std::vector<Motion> adaptive(double step) {
  Moves m({0, 10, -4});
  m.arc({0, 7, -4}, {0, 8.5, -4}, -kPi).rapid({-step, 7, -3.7}).rapid({-step, 10, -3.7});
  m.cut({-step, 10, -4}).cut({step, 10, -4}).arc({step, 7, -4}, {step, 8.5, -4}, -kPi);
  m.rapid({0, 7, -3.7});
  return m.motions;
}

// The cusp between two passes is step^2 / (8 r) high.
TEST(RecentPlaces, TheWayBackFromAPassIsClearWhereCuspsAreTouches) {
  for (const double r : {3.0, 6.0}) {
    const double step = std::sqrt(8 * r * kAllowed);
    EXPECT_TRUE(keeps(adaptive(0.98 * step), testing::endmill(2 * r))) << r;
    EXPECT_FALSE(keeps(adaptive(1.02 * step), testing::endmill(2 * r))) << r;
  }
}

TEST(RecentPlaces, TheWayOutAndTheWayAlongACutAreClear) {
  const Tool tool = testing::endmill(6);
  EXPECT_TRUE(keeps(Moves({0, 0, -4}).cut({9, 3, -4}).rapid({9, 3, 5}).motions, tool));
  EXPECT_TRUE(keeps(Moves({0, 0, -4}).cut({9, 3, -4}).rapid({3, 1, -4}).motions, tool));
  EXPECT_FALSE(keeps(Moves({0, 0, -4}).cut({9, 3, -4}).rapid({3, 1, -4.1}).motions, tool));
  EXPECT_FALSE(keeps(Moves({0, 0, -4}).cut({9, 3, -4}).rapid({9, 3.1, 5}).motions, tool));
  EXPECT_FALSE(keeps(Moves({0, 0, -4}).cut({9, 3, -5}).rapid({0, 0, -4.5}).motions, tool));
}

TEST(RecentPlaces, WhatIsCalledClearIs) {
  std::mt19937 random(testing::salted(31));
  const auto pick = [&](double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(random() % 1000) / 999;
  };
  std::size_t clear = 0;
  for (int scene = 0; scene < 3000; ++scene) {
    const double r = pick(1, 6);
    const Tool tool = scene % 3 == 0   ? testing::endmill(2 * r)
                      : scene % 3 == 1 ? testing::ballmill(2 * r)
                                       : testing::endmill(2 * r, pick(0.1, 0.9) * r);
    const double step = pick(0.02, 1.2) * std::sqrt(8 * r * kAllowed);
    const auto near = [&](double z) {
      return Vec3{pick(-1, 1) * step, pick(-1, 1) * step, z + (random() % 2 == 0 ? 0 : 0.3)};
    };
    Moves m(near(-4));
    for (int cut = 0; cut < 5; ++cut) {
      const double turn = pick(0, kTwoPi);
      const auto [sin, cos] = sincos(turn);
      const Vec3 from = m.motions.empty() ? Vec3{0, 0, -4} : m.motions.back().end;
      if (cut % 2 == 1)
        m.arc(from + Vec3{2 * cos, 2 * sin, 0}, from + Vec3{cos, sin, 0},
              pick(0, 1) < 0.5 ? kPi : -kPi);
      else
        m.cut(near(-4));
    }
    m.rapid(near(-4)).rapid(near(-3.9));
    if (!keeps(m.motions, tool)) continue;
    ++clear;
    EXPECT_LE(deepest(m.motions, tool), kAllowed + 1e-6) << scene;
  }
  EXPECT_GT(clear, 100u);
}

}  // namespace
}  // namespace mrsim
