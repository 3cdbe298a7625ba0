// Areas between contours: insets in closed form, and loops that leave nothing between them.
#include "interp/path/region.h"

#include "core/numbers/units.h"
#include "support/random.h"
#include "support/rounds.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

Loop polygon(const std::vector<Vec2>& corners) {
  Loop loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    PlanePiece piece;
    piece.start = corners[i];
    piece.end = corners[(i + 1) % corners.size()];
    loop.push_back(piece);
  }
  return loop;
}

Loop box(double x0, double y0, double x1, double y1) {
  return polygon({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

double inset_area(const Region& region, double distance) {
  std::vector<Loop> loops;
  EXPECT_TRUE(region.inset(distance, loops));
  double area = 0;
  for (const Loop& loop : loops) area += signed_area(loop);
  return area;
}

TEST(Region, InsetOfARectangleHasSharpCorners) {
  EXPECT_NEAR(inset_area(Region(box(0, 0, 40, 20), {}), 5), 30 * 10, 1e-9);
  // Given clockwise it is the same area.
  EXPECT_NEAR(inset_area(Region(reversed(box(0, 0, 40, 20)), {}), 5), 30 * 10, 1e-9);
  EXPECT_EQ(inset_area(Region(box(0, 0, 40, 20), {}), 10.01), 0);
}

TEST(Region, AroundAnIslandCornersAreArcs) {
  // Less a square of 10, grown by 3 with round corners.
  const double grown = 10 * 10 + 4 * 10 * 3 + kPi * 9;
  EXPECT_NEAR(inset_area(Region(box(0, 0, 60, 60), {box(20, 20, 30, 30)}), 3), 54 * 54 - grown,
              1e-9);
  EXPECT_NEAR(inset_area(Region(std::nullopt, {box(20, 20, 30, 30)}), 3), -grown, 1e-9);
  // Islands that overlap are one, and so are an island and the border that it reaches over.
  EXPECT_NEAR(inset_area(Region(box(0, 0, 60, 60), {box(20, 20, 25, 30), box(24, 20, 30, 30)}), 3),
              54 * 54 - grown, 1e-9);
  EXPECT_NEAR(
      inset_area(Region(box(0, 0, 60, 60), {box(-10, 20, 10, 70)}), 5),
      inset_area(Region(polygon({{0, 0}, {60, 0}, {60, 60}, {10, 60}, {10, 20}, {0, 20}}), {}), 5),
      1e-9);
}

TEST(Region, ArcsOfTheContourAreOffsetExactly) {
  EXPECT_NEAR(inset_area(Region(circle_loop(20), {}), 5), kPi * 225, 1e-9);
  EXPECT_NEAR(inset_area(Region(circle_loop(20), {circle_loop(5)}), 2), kPi * (324 - 49), 1e-9);
  // Fillets as round as the cutter, and smaller ones: sharp corners of its path.
  EXPECT_NEAR(inset_area(Region(rounded_rectangle(30, 20, 5), {}), 5), 50 * 30, 1e-6);
  EXPECT_NEAR(inset_area(Region(rounded_rectangle(30, 20, 3), {}), 5), 50 * 30, 1e-6);
  EXPECT_NEAR(inset_area(Region(rounded_rectangle(30, 20, 8), {}), 5), 50 * 30 - (4 - kPi) * 9,
              1e-6);
}

TEST(Region, ANeckTooNarrowDividesThePocket) {
  const Loop bone = polygon({{0, 0},
                             {20, 0},
                             {20, 8},
                             {40, 8},
                             {40, 0},
                             {60, 0},
                             {60, 20},
                             {40, 20},
                             {40, 12},
                             {20, 12},
                             {20, 20},
                             {0, 20}});
  std::vector<Loop> loops;
  ASSERT_TRUE(Region(bone, {}).inset(3, loops));
  EXPECT_EQ(loops.size(), 2U);
  ASSERT_TRUE(Region(bone, {}).inset(1.9, loops));
  EXPECT_EQ(loops.size(), 1U);
  // As wide as the cutter: there and back.
  ASSERT_TRUE(Region(box(0, 0, 40, 10), {}).inset(5, loops));
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_NEAR(signed_area(loops[0]), 0, 1e-9);
}

TEST(Region, StraightWaysKeepToTheRegion) {
  const Region region(box(0, 0, 60, 60), {circle_loop(10)});
  EXPECT_TRUE(region.keeps({20, 5}, {50, 50}, 5));
  EXPECT_FALSE(region.keeps({5, 30}, {30, 5}, 12));
  EXPECT_TRUE(region.keeps({5, 30}, {30, 5}, 5));
  EXPECT_FALSE(region.keeps({5, 30}, {70, 30}, 5));
}

// Star-shaped contours of lines, with an island: every place that the cutter can reach lies within
// its radius of a loop, and no loop is nearer to a contour than the radius.
TEST(Region, LoopsLeaveNothingBetweenThem) {
  std::mt19937 random(testing::salted(7));
  std::uniform_real_distribution<double> share(0.5, 1), any(-45, 45);
  for (unsigned round = 0; round < testing::rounds(60); ++round) {
    std::vector<Vec2> corners, island;
    for (int i = 0; i < 14; ++i) {
      const double angle = kTwoPi * i / 14, r = 45 * share(random), s = 6 * share(random);
      corners.push_back({r * std::cos(angle), r * std::sin(angle)});
      island.push_back({s * std::cos(angle), s * std::sin(angle)});
    }
    const Region region(polygon(corners), {polygon(island)});
    std::vector<Loop> loops, border;
    ASSERT_TRUE(clearing_loops(region, 3, 0, 2.5, loops));
    ASSERT_TRUE(region.inset(3, border));
    for (int i = 0; i < 400; ++i) {
      const Vec2 p{any(random), any(random)};
      if (!region.keeps(p, p, 3) && !region.keeps(p, p + Vec2{1e-5, 0}, 3)) continue;
      // Inside of the border, by the turns that it makes about the place.
      double turns = 0;
      for (const Loop& loop : border)
        for (const PlanePiece& piece : loop)
          for (int k = 0; k < 50; ++k) {
            const auto at = [&](double along) {
              if (!piece.arc) return piece.start + along * (piece.end - piece.start);
              const double a = along * piece.sweep;
              const Vec2 d = piece.start - piece.center;
              return piece.center + Vec2{d.x * std::cos(a) - d.y * std::sin(a),
                                         d.x * std::sin(a) + d.y * std::cos(a)};
            };
            const Vec2 a = at(k / 50.0) - p, b = at((k + 1) / 50.0) - p;
            turns += std::atan2(cross(a, b), dot(a, b));
          }
      if (turns < kPi) continue;
      double nearest = 1e9;
      for (const Loop& loop : loops) {
        const Loop begun = begun_near(loop, p);
        nearest = std::min(nearest, length(begun.front().start - p));
      }
      EXPECT_LE(nearest, 3) << round << ": " << p.x << ' ' << p.y;
    }
    for (const Loop& loop : loops)
      for (const PlanePiece& piece : loop)
        EXPECT_TRUE(region.keeps(piece.start, piece.start + Vec2{1e-5, 0}, 3 - 1e-3));
  }
}

}  // namespace
}  // namespace mrsim
