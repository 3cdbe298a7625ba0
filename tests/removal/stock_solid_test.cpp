#include "removal/stock/stock_solid.h"

#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "support/random.h"
#include "support/shapes.h"

#include <random>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

// The defining properties, on random points: 1-Lipschitz, and gradient of the patch = the numeric
// one where the patch is the nearest.
void expect_distance_function(const StockSolid& solid) {
  std::mt19937_64 random(testing::salted(7));
  std::uniform_real_distribution<double> u(-0.3, 1.3), small(-1e-3, 1e-3);
  const Vec3 lo = solid.bounds().lo, size = solid.bounds().hi - lo;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p = lo + Vec3{u(random) * size.x, u(random) * size.y, u(random) * size.z};
    const Vec3 q = p + Vec3{small(random), small(random), small(random)};
    const auto at = solid.sample(p);
    EXPECT_LE(std::abs(at.distance - solid.distance(q)), distance(p, q) * (1 + 1e-12) + 1e-12);
    if (at.distance > 0) continue;
    EXPECT_NEAR(solid.patch_distance(p, at.patch), at.distance, 1e-9);
    const Vec3 n = solid.gradient(p, at.patch);
    EXPECT_NEAR(solid.distance(p - at.distance * n), 0, 1e-9);  // the foot lies on the surface
  }
}

TEST(StockSolid, BoxIsExact) {
  const StockSolid solid(testing::box_stock({0, -60, 0}, {100, 0, 10}));
  EXPECT_EQ(solid.distance({50, -30, 5}), -5);
  EXPECT_EQ(solid.distance({50, -30, 12}), 2);
  EXPECT_EQ(solid.distance({103, 4, 5}), 5);
  EXPECT_EQ(solid.sample({50, -30, 9}).patch, kBoxZHigh);
  EXPECT_EQ(solid.gradient({50, -30, 9}, kBoxZHigh), (Vec3{0, 0, 1}));
  EXPECT_EQ(solid.volume(), 60000);
  EXPECT_EQ(solid.area(), 2 * (6000 + 1000 + 600));
  expect_distance_function(solid);
}

TEST(StockSolid, CylinderAndTubeAreExact) {
  const StockSolid bar(testing::round_stock(25, 0, 0, 51));
  EXPECT_EQ(bar.distance({0, 0, 25.5}), -25);
  EXPECT_EQ(bar.distance({28, 0, 55}), 5);
  EXPECT_NEAR(bar.volume(), kPi * 625 * 51, 1e-9);
  expect_distance_function(bar);
  const StockSolid pipe(testing::round_stock(25, 10, -5, 5));
  EXPECT_EQ(pipe.distance({0, 0, 0}), 10);
  EXPECT_EQ(pipe.sample({0, 11, 0}).patch, kRoundBore);
  EXPECT_EQ(pipe.gradient({0, 11, 0}, kRoundBore), (Vec3{0, -1, 0}));
  EXPECT_NEAR(pipe.area(), 2 * kPi * 35 * 10 + 2 * kPi * (625 - 100), 1e-9);
  expect_distance_function(pipe);
}

TEST(StockSolid, MeshIsExact) {
  StockShape shape;
  shape.kind = StockShape::Kind::mesh;
  shape.mesh = testing::box_mesh({0, -60, 0}, {100, 0, 10});
  shape.box = {{0, -60, 0}, {100, 0, 10}};
  const StockSolid mesh(shape), exact(testing::box_stock({0, -60, 0}, {100, 0, 10}));
  EXPECT_NEAR(mesh.volume(), 60000, 1e-9);
  EXPECT_NEAR(mesh.area(), exact.area(), 1e-9);
  expect_distance_function(mesh);
  std::mt19937_64 random(testing::salted(3));
  std::uniform_real_distribution<double> u(-0.5, 1.5);
  for (int i = 0; i < 10000; ++i) {
    const Vec3 p{100 * u(random), -60 * u(random), 10 * u(random)};
    ASSERT_NEAR(mesh.distance(p), exact.distance(p), 1e-10);
  }
  EXPECT_EQ(mesh.sample({20, -20, 9.5}).patch,
            mesh.sample({80, -50, 9.5}).patch);  // two triangles, one face
  EXPECT_NE(mesh.sample({20, -20, 9.5}).patch, mesh.sample({20, -20, 0.5}).patch);
}

// Of a mesh, also right after another solid was asked, whose last place must not count.
TEST(StockSolid, DistancesThatDecideAreExact) {
  StockShape shape;
  shape.kind = StockShape::Kind::mesh;
  const auto sphere = [&](double radius) {
    shape.mesh = testing::sphere_mesh(24, radius, {});
    shape.box = {{-radius, -radius, -radius}, {radius, radius, radius}};
    return StockSolid(shape);
  };
  const StockSolid large = sphere(20), small = sphere(6);
  std::mt19937_64 random(testing::salted(5));
  std::uniform_real_distribution<double> u(-20, 20), step(-0.5, 0.5);
  Vec3 p;
  std::size_t lower = 0;
  for (int i = 0; i < 20000; ++i) {
    p = i % 10 == 0 ? Vec3{u(random), u(random), u(random)}
                    : p + Vec3{step(random), step(random), step(random)};
    const double least = 0.5 * u(random);
    const StockSolid& solid = i / 50 % 2 == 0 ? large : small;
    const double found = solid.sample(p, least).distance, exact = solid.distance(p);
    ASSERT_EQ(found >= least, exact >= least);
    if (exact >= least) {
      ASSERT_EQ(found, exact);
    }
    lower += found != exact;
  }
  EXPECT_GT(lower, 0u);
}

// Large flat faces are none: those of a box, and the caps of a cylinder.
TEST(StockSolid, FacetsAreWhatIsNotFlat) {
  StockShape shape;
  shape.kind = StockShape::Kind::mesh;
  shape.mesh = testing::box_mesh({0, 0, 0}, {30, 20, 10});
  shape.box = {{0, 0, 0}, {30, 20, 10}};
  EXPECT_EQ(StockSolid(shape).facets().area, 0);
  EXPECT_EQ(StockSolid(shape).facets().edges, 0);
  shape.mesh = testing::cylinder_mesh(200, 10, 0, 5);
  shape.box = {{-10, -10, 0}, {10, 10, 5}};
  const StockFacets wall = StockSolid(shape).facets();
  EXPECT_NEAR(wall.area, 100 * kPi, 0.1);
  EXPECT_EQ(wall.edges, 200);
  EXPECT_NEAR(wall.bend, 5 * kTwoPi, 0.01);  // height times the whole turn
}

TEST(StockSolid, RefusesWhatHasNoVolume) {
  EXPECT_THROW(StockSolid(testing::box_stock({0, 0, 0}, {1, 1, 0})), Error);
  EXPECT_THROW(StockSolid(testing::round_stock(5, 5, 0, 1)), Error);
}

}  // namespace
}  // namespace mrsim
