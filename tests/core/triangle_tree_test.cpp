#include "core/numbers/triangle_tree.h"

#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "core/numbers/wide_box_tree.h"
#include "support/random.h"
#include "support/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

double box_distance(const Box3& b, const Vec3& p) {
  const Vec3 q = max(b.lo - p, p - b.hi);
  const Vec3 outside = max(q, {0, 0, 0});
  return length(outside) + std::min(std::max({q.x, q.y, q.z}), 0.0);
}

TEST(TriangleTree, IsExactForABox) {
  const Box3 box{{-1, -2, -3}, {4, 5, 6}};
  const TriangleTree tree(testing::box_mesh(box.lo, box.hi));
  std::mt19937_64 random(testing::salted(1));
  std::uniform_real_distribution<double> u(-8, 10);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p{u(random), u(random), u(random)};
    ASSERT_NEAR(tree.signed_distance(p), box_distance(box, p), 1e-12);
  }
}

// Needles and points are their sides: of every order of the corners, and where two or three of
// these are equal.
TEST(TriangleTree, TrianglesWithoutAreaHaveDistances) {
  std::mt19937_64 random(testing::salted(3));
  std::uniform_real_distribution<double> u(-5, 5);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 a{u(random), u(random), u(random)}, way{u(random), u(random), u(random)};
    const double from = i % 3 == 0 ? 0 : 0.25, to = i % 5 == 0 ? 0 : 1;  // of the line's corners
    std::array<Vec3, 3> corners{a, a + from * way, a + to * way};
    std::rotate(corners.begin(), corners.begin() + i % 2, corners.end());
    const Vec3 p{u(random), u(random), u(random)};
    const double square = dot(way, way), most = std::max(from, to);
    const double t = std::min(std::max(dot(p - a, way) / square, 0.0), most);
    const TrianglePoint found = nearest_on_triangle(p, corners[0], corners[1], corners[2]);
    ASSERT_NEAR(std::sqrt(found.distance2), distance(p, a + t * way), 1e-6) << i;
  }
}

// Any count of boxes, with places as far away as they are large and others: nothing is overlooked.
TEST(WideBoxTree, SearchesAndVisitsMissNothing) {
  std::mt19937_64 random(testing::salted(4));
  std::uniform_real_distribution<double> u(-5, 5), size(0, 1);
  for (std::uint32_t count = 1; count < 90; ++count) {
    std::vector<FloatBox> boxes(count);
    std::vector<std::uint32_t> names(count);
    for (std::uint32_t k = 0; k < count; ++k) {
      names[k] = 2 * k;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        boxes[k].lo[axis] = static_cast<float>(u(random));
        boxes[k].hi[axis] = boxes[k].lo[axis] + static_cast<float>(size(random));
      }
    }
    const WideBoxTree tree(boxes, names);
    const Vec3 p{u(random), u(random), u(random)};
    const double most = std::fabs(u(random)) * std::fabs(u(random));
    std::vector<std::uint32_t> found, near, plan, near_in_plan, met, touching;
    tree.search(p, most, [&](std::uint32_t name) { return found.push_back(name), most; });
    tree.search_in_plan(p, most, [&](std::uint32_t name) { return plan.push_back(name), most; });
    const Box3 box{p, p + Vec3{1, 2, 3}};
    tree.visit(box, [&](std::uint32_t name) { return met.push_back(name), true; });
    for (std::uint32_t k = 0; k < count; ++k) {
      const FloatBox& b = boxes[k];
      const Vec3 lo{b.lo[0], b.lo[1], b.lo[2]}, hi{b.hi[0], b.hi[1], b.hi[2]};
      const Vec3 out = max(max(lo - p, p - hi), {0, 0, 0});
      if (dot(out, out) <= most) near.push_back(names[k]);
      if (out.x * out.x + out.y * out.y <= most && hi.z > p.z) near_in_plan.push_back(names[k]);
      if (box_distance({lo, hi}, min(max(lo, box.lo), box.hi)) <= 0) touching.push_back(names[k]);
    }
    for (auto* list : {&found, &plan, &met}) std::sort(list->begin(), list->end());
    EXPECT_EQ(found, near) << count;
    EXPECT_EQ(plan, near_in_plan) << count;
    EXPECT_EQ(met, touching) << count;
  }
}

TEST(TriangleTree, FindsTheNearestOfAll) {
  const TriMesh mesh = testing::sphere_mesh(40, 5, {1, 2, 3});
  const TriangleTree tree(mesh);
  std::mt19937_64 random(testing::salted(2));
  std::uniform_real_distribution<double> u(-6, 9);
  std::uint32_t hint = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec3 p{u(random), u(random), u(random)};
    TriangleTree::Hit best;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto corner = [&](std::size_t k) {
        const auto& v = mesh.vertices[mesh.triangles[t][k]];
        return Vec3{v[0], v[1], v[2]};
      };
      const TrianglePoint point = nearest_on_triangle(p, corner(0), corner(1), corner(2));
      if (point.distance2 < best.distance2) {
        static_cast<TrianglePoint&>(best) = point;
        best.triangle = t;
      }
    }
    const auto hit = tree.nearest(p, hint);
    EXPECT_EQ(hit.triangle, best.triangle);
    EXPECT_EQ(hit.distance2, best.distance2);
    const double r = distance(p, {1, 2, 3});
    if (std::abs(r - 5) > 0.1) {  // 0.1: facets
      EXPECT_EQ(tree.signed_distance(p, hit) < 0, r < 5) << i;
    }
    hint = hit.triangle;
  }
}

// The caps of a cylinder are fans of long triangles side by side.
TEST(TriangleTree, PiecesOfLongTrianglesChangeNothing) {
  const TriMesh mesh = testing::cylinder_mesh(150, 40, -3, 0);
  const TriangleTree whole(mesh), pieces(mesh, TriangleTree::Boxes::pieces);
  std::mt19937_64 random(testing::salted(4));
  std::uniform_real_distribution<double> u(-45, 45), z(-4, 1);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 p{u(random), u(random), z(random)};
    const auto a = whole.nearest(p), b = pieces.nearest(p);
    ASSERT_EQ(a.triangle, b.triangle);
    ASSERT_EQ(a.distance2, b.distance2);
    ASSERT_EQ(whole.is_near(p, 0.5), pieces.is_near(p, 0.5));
  }
}

TEST(NearestOnTriangle, AgreesWithDenseSampling) {
  std::mt19937_64 random(testing::salted(3));
  std::uniform_real_distribution<double> u(-1, 1);
  const auto point = [&] { return Vec3{u(random), u(random), u(random)}; };
  for (int i = 0; i < 200; ++i) {
    const Vec3 a = point(), b = point(), c = point(), p = 2.0 * point();
    const TrianglePoint found = nearest_on_triangle(p, a, b, c);
    double least = 1e9;
    constexpr int kSteps = 60;
    for (int s = 0; s <= kSteps; ++s)
      for (int t = 0; s + t <= kSteps; ++t) {
        const Vec3 q = a + (double(s) / kSteps) * (b - a) + (double(t) / kSteps) * (c - a);
        least = std::min(least, distance(p, q));
      }
    const double d = std::sqrt(found.distance2);
    EXPECT_LE(d, least + 1e-12);
    EXPECT_GE(d, least - 0.06);
    EXPECT_NEAR(distance(p, found.point), d, 1e-12);
  }
}

}  // namespace
}  // namespace mrsim
