// The bounds against CGAL's bounded-error Hausdorff distance.
#include "compare/distance/hausdorff.h"

#include "compare/distance/align.h"
#include "compare/distance/sampling.h"
#include "core/numbers/trig.h"
#include "mesh/solid/half_edges.h"
#include "support/cgal_mesh.h"
#include "support/shapes.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

HausdorffBound ours(const TriMesh& from, const TriMesh& to, double error,
                    std::size_t budget = 300'000) {
  const NominalSurface surface(to);
  const Vec3 start = to_vec(from.vertices[from.triangles[0][0]]);
  return directed_hausdorff(from, surface, FlatPatches(to, surface, 0),
                            std::abs(surface.at(start).distance), start, error, budget, 0);
}

void expect_as_cgal(const TriMesh& from, const TriMesh& to, double error = 1e-3) {
  const HausdorffBound bound = ours(from, to, error);
  const double oracle = testing::directed_hausdorff_by_cgal(from, to, error);
  EXPECT_LE(bound.upper - bound.lower, 1.001 * error);
  EXPECT_GE(oracle, bound.lower - error);
  EXPECT_LE(oracle, bound.upper + error);
}

TriMesh turned(const TriMesh& mesh, double degrees, const Vec3& shift) {
  const SinCos a = sincos_deg(degrees);
  RigidTransform t;
  t.rotation = {{{a.cos, 0, a.sin}, {0, 1, 0}, {-a.sin, 0, a.cos}}};
  t.shift = shift;
  return transformed(mesh, t);
}

TEST(Hausdorff, AgreesWithCgal) {
  const TriMesh box = testing::box_mesh({-5, -5, -5}, {5, 5, 5});
  const TriMesh ball = testing::sphere_mesh(24, 6);
  const TriMesh tube = testing::tube_mesh(30, 8, 5, -4, 4);
  expect_as_cgal(box, ball);
  expect_as_cgal(ball, box);
  expect_as_cgal(tube, ball);
  expect_as_cgal(box, turned(box, 7, {0.2, 0, 0.1}));
  expect_as_cgal(tube, turned(tube, 3, {0, 0.1, 0}));
}

TEST(Hausdorff, AgreesWithCgalOnSliversBesideCreases) {
  // Rings of a plane, cut into thin triangles in two ways, with chords for circles: the borders
  // run close beside each other all around.
  const TriMesh coarse = testing::tube_mesh(47, 20, 15, 0, 2);
  const TriMesh fine = testing::tube_mesh(240, 20, 15, 0, 2);
  expect_as_cgal(coarse, fine, 1e-4);
  expect_as_cgal(fine, coarse, 1e-4);
}

TEST(Hausdorff, SmoothSurfacesNeedFewPieces) {
  const TriMesh ball = testing::sphere_mesh(120, 20), other = testing::sphere_mesh(127, 20.05);
  // Before any of 13 000 triangles is split: a triangle with those about it strays by 0.03 mm from
  // its plane, and is 1 mm wide.
  const HausdorffBound bound = ours(ball, other, 1e-4, 0);
  EXPECT_LE(bound.upper - bound.lower, 0.03);
  expect_as_cgal(ball, other);
}

TEST(Hausdorff, MoreTrianglesThanTheBudgetHaveABound) {
  const TriMesh ball = testing::sphere_mesh(24, 6), larger = testing::sphere_mesh(25, 6.01);
  const HausdorffBound bound = ours(ball, larger, 1e-4, 10);
  EXPECT_GE(bound.upper, ours(ball, larger, 1e-4).lower);
  EXPECT_LT(bound.upper, 3);
}

TEST(Hausdorff, FindsWhatSamplesMiss) {
  // A pit of 0.02 mm in a large plate: one vertex among 10 000 mm2.
  TriMesh plate = testing::box_mesh({0, 0, 0}, {100, 100, 5});
  TriMesh pit = plate;
  pit.vertices.push_back({50, 50, 4.8f});
  pit.triangles[2] = {4, 5, 8};  // the top's two triangles become four about the pit
  pit.triangles[3] = {5, 7, 8};
  pit.triangles.push_back({7, 6, 8});
  pit.triangles.push_back({6, 4, 8});
  const HausdorffBound bound = ours(plate, pit, 1e-4);
  // The nominal's centre over a pyramid of depth 0.2 and half width 50.
  const double exact = 0.2 * 50 / std::hypot(50, 0.2);
  EXPECT_GE(bound.upper, exact - 1e-6);
  EXPECT_LE(bound.lower, exact + 1e-6);
  EXPECT_LE(bound.upper - bound.lower, 1.01e-4);
}

TEST(Hausdorff, FlatFacesOfOtherTrianglesTakeFewPieces) {
  // Equal boxes, one with its top fanned into many: no piece may cost area / error^2.
  const TriMesh box = testing::box_mesh({0, 0, 0}, {200, 100, 10});
  TriMesh fan = box;
  fan.vertices.push_back({61.803f, 38.197f, 10});
  fan.triangles[2] = {4, 5, 8};
  fan.triangles[3] = {5, 7, 8};
  fan.triangles.push_back({7, 6, 8});
  fan.triangles.push_back({6, 4, 8});
  const HausdorffBound bound = ours(box, fan, 1e-4);
  EXPECT_LE(bound.upper, 2e-4);
}

}  // namespace
}  // namespace mrsim
