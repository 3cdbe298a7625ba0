#include "mesh/solid/self_intersection.h"

#include "mesh/solid/solid_repair.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

bool is_sound(const TriMesh& mesh) {
  EXPECT_EQ(detail::is_sound(mesh, 1), detail::is_sound(mesh, 2));
  return detail::is_sound(mesh, 1);
}

TEST(IsSound, TakesSolidsApart) {
  EXPECT_TRUE(is_sound(box_mesh({0, 0, 0}, {10, 10, 10})));
  EXPECT_TRUE(
      is_sound(joined(box_mesh({0, 0, 0}, {10, 10, 10}), box_mesh({11, 0, 0}, {12, 1, 1}))));
  EXPECT_TRUE(is_sound(
      joined(box_mesh({0, 0, 0}, {10, 10, 10}), flipped(box_mesh({1, 1, 1}, {2.5, 9, 9})))));
}

TEST(IsSound, RefusesWhatCrossesOrTouches) {
  const TriMesh box = box_mesh({0, 0, 0}, {10, 10, 10});
  EXPECT_FALSE(is_sound(joined(box, box_mesh({9.5, 5, 5}, {20, 20, 20}))));
  EXPECT_FALSE(is_sound(joined(box, box_mesh({10, 10, 10}, {20, 20, 20}))));  // a corner
  EXPECT_NO_THROW(require_clean_bodies(joined(box, box_mesh({10, 10, 10}, {20, 20, 20})), "b"));
  EXPECT_THROW(require_clean_bodies(joined(box, box_mesh({9.5, 5, 5}, {20, 20, 20})), "b"), Error);
}

TEST(IsSound, KnowsOnlyCoordinatesOfTheMesher) {
  EXPECT_FALSE(is_sound(box_mesh({0, 0, 0}, {10, 10, 0.1})));      // 0.1 is no multiple of 2^-20
  EXPECT_FALSE(is_sound(box_mesh({0, 0, 0}, {10, 10, 8192})));     // larger than differences may be
  EXPECT_TRUE(is_sound(box_mesh({-4000, 0, 0}, {4000, 10, 10})));  // just below
  EXPECT_NO_THROW(require_clean_bodies(box_mesh({0, 0, 0}, {10, 10, 0.1}), "b"));
}

TEST(IsSound, RefusesTrianglesWithoutArea) {
  TriMesh box = box_mesh({0, 0, 0}, {10, 10, 10});
  const auto middle = static_cast<std::uint32_t>(box.vertices.size());
  box.vertices.push_back({5, 0, 0});
  box.triangles.push_back({0, 1, middle});
  EXPECT_FALSE(is_sound(box));
}

}  // namespace
}  // namespace mrsim
