#include "compare/distance/nominal.h"

#include "core/numbers/vec.h"
#include "support/mesh_asserts.h"
#include "support/random.h"
#include "support/shapes.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

std::vector<Vec3> random_points(std::size_t n, double lo, double hi) {
  std::mt19937_64 random(testing::salted(7));
  std::uniform_real_distribution<double> u(lo, hi);
  std::vector<Vec3> out(n);
  for (Vec3& p : out) p = {u(random), u(random), u(random)};
  return out;
}

TEST(NominalSurface, BatchEqualsSinglePointsForAnyThreads) {
  const NominalSurface surface(testing::sphere_mesh(60, 5));
  const auto points = random_points(5000, -7, 7);
  std::vector<SurfaceHit> one(points.size()), four(points.size());
  surface.query(points, one, 1);
  surface.query(points, four, 4);
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_EQ(one[i].distance, four[i].distance);
    ASSERT_EQ(one[i].triangle, four[i].triangle);
    ASSERT_EQ(one[i].distance, surface.at(points[i]).distance);
  }
}

TEST(NominalSurface, SignIsRightOnAThinWall) {
  // 2 um: nearest points are on either side, at edges and corners of the plate too.
  const Box3 wall{{0, 0, 0}, {50, 0.002, 20}};
  const NominalSurface surface(testing::box_mesh(wall.lo, wall.hi));
  for (double y = -0.0095; y < 0.012; y += 0.001)
    for (double x = -0.05; x < 50.1; x += 0.5) {
      const bool inside = x > 0 && x < 50 && y > 0 && y < 0.002;
      EXPECT_EQ(surface.at({x, y, 10}).distance < 0, inside) << x << " " << y;
    }
}

TEST(NominalSurface, WindingDecidesWhereCornersTouch) {
  // Two boxes that touch in one corner: pseudonormals of the shared vertex point nowhere.
  TriMesh mesh = testing::box_mesh({-1, -1, -1}, {0, 0, 0});
  const TriMesh other = testing::box_mesh({0, 0, 0}, {3, 3, 3});
  mesh = testing::joined(mesh, other);
  for (auto& t : mesh.triangles)
    for (auto& v : t)
      if (v == 8) v = 7;  // one vertex for both corners
  const NominalSurface surface(mesh);
  EXPECT_LT(surface.at({0.1, 0.1, 0.1}).distance, 0);
  EXPECT_LT(surface.at({-0.1, -0.1, -0.1}).distance, 0);
  for (const Vec3& p : {Vec3{-0.1, 0.1, 0.1}, {0.1, -0.1, -0.1}, {-0.1, 0.05, 0.1}})
    EXPECT_GT(surface.at(p).distance, 0);
}

TEST(RequireComparable, SaysWhatIsWrong) {
  const TriMesh box = testing::box_mesh({0, 0, 0}, {1, 2, 3});
  EXPECT_NEAR(require_comparable(box, "nominal", ""), 6, 1e-9);
  const auto code = [](const TriMesh& mesh) {
    return testing::error_code([&] { require_comparable(mesh, "nominal", ""); });
  };
  EXPECT_EQ(code({}), "compare-empty");
  TriMesh open = box;
  open.triangles.pop_back();
  EXPECT_EQ(code(open), "compare-nominal-open");
  TriMesh broken = box;
  broken.vertices[3][1] = std::nanf("");
  EXPECT_EQ(code(broken), "compare-not-finite");
  broken.vertices[3][1] = INFINITY;
  EXPECT_EQ(code(broken), "compare-not-finite");
  EXPECT_EQ(code(testing::flipped(box)), "compare-nominal-open");
}

}  // namespace
}  // namespace mrsim
