#include "reference/repair.h"

#include "mesh/solid/weld.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

TEST(MakeManifold, LeavesGoodMeshesAlone) {
  const TriMesh before = tube_mesh(64, 10, 5, 0, 7);
  TriMesh m = before;
  make_manifold(m);
  EXPECT_EQ(m.vertices, before.vertices);
  EXPECT_EQ(m.triangles, before.triangles);
}

TEST(MakeManifold, TakesSolidsApartThatTouch) {
  for (const Vec3& at : {Vec3{1, 1, 0}, Vec3{1, 1, 1}}) {
    TriMesh m = weld(joined(box_mesh({0, 0, 0}, {1, 1, 1}), box_mesh(at, {2, 2, at.z + 1})));
    m.owners.assign(m.triangles.size(), 7);
    ASSERT_FALSE(check_mesh(m).manifold);
    make_manifold(m);
    expect_closed_manifold(m);
    expect_closed_manifold(weld(m));  // also for readers that know coordinates only
    EXPECT_EQ(check_mesh(m).components, 2u);
    EXPECT_NEAR(check_mesh(m).volume, 2, 0.1);
    EXPECT_EQ(m.owners.size(), m.triangles.size());
  }
}

TEST(MakeManifold, TakesApartARingThatClosesInAnEdge) {
  // Four boxes in a square ring of which two touch along one edge only: both sheets share the ends.
  TriMesh m = joined(box_mesh({0, 0, 0}, {1, 1, 1}), box_mesh({1, 1, 0}, {2, 2, 1}));
  m = weld(joined(m, box_mesh({0, 1, 1}, {1, 2, 2})));
  make_manifold(m);
  expect_closed_manifold(m);
  expect_closed_manifold(weld(m));
}

}  // namespace
}  // namespace mrsim
