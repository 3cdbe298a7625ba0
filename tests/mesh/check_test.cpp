#include "mesh/solid/check.h"

#include "mesh/solid/half_edges.h"
#include "mesh/solid/weld.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

TEST(CheckMesh, KnowsSolids) {
  const MeshSummary box = check_mesh(box_mesh({0, -60, 0}, {100, 0, 10}));
  EXPECT_EQ(box.first_fault, "");
  EXPECT_TRUE(box.closed && box.oriented && box.manifold && !box.inverted);
  EXPECT_EQ(box.euler, 2);
  EXPECT_EQ(box.components, 1u);
  EXPECT_DOUBLE_EQ(box.volume, 60000);
  EXPECT_DOUBLE_EQ(box.area, 2 * (6000 + 1000 + 600));
  EXPECT_EQ(box.bounds, (Box3{{0, -60, 0}, {100, 0, 10}}));
  EXPECT_EQ(check_mesh(tube_mesh(64, 10, 5, 0, 7)).euler, 0);
  EXPECT_EQ(check_mesh(tube_mesh(64, 10, 5, 0, 7)).first_fault, "");
}

TEST(CheckMesh, VolumeAndAreaComeCloseToTheSphere) {
  const MeshSummary s = check_mesh(sphere_mesh(400, 5, {100, -20, 3}));
  EXPECT_EQ(s.first_fault, "");
  EXPECT_NEAR(s.volume, 4.0 / 3 * kPi * 125, 0.001 * 523.6);
  EXPECT_NEAR(s.area, 100 * kPi, 0.001 * 314);
}

TEST(CheckMesh, TellsAnOpenEdgeWithItsPlace) {
  TriMesh m = box_mesh({0, 0, 0}, {2, 2, 2});
  m.triangles.pop_back();
  const MeshSummary s = check_mesh(m);
  EXPECT_FALSE(s.closed || s.oriented || s.manifold);
  EXPECT_NE(s.first_fault.find("open edge at (2, "), std::string::npos) << s.first_fault;
  EXPECT_NE(s.first_fault.find("3 open edges"), std::string::npos) << s.first_fault;
  EXPECT_EQ(error_code([&] { require_solid(m, "a.stl"); }), "mesh-open");
}

TEST(CheckMesh, TellsInvertedOrientation) {
  const TriMesh m = flipped(box_mesh({0, 0, 0}, {2, 2, 2}));
  const MeshSummary s = check_mesh(m);
  EXPECT_TRUE(s.closed && s.inverted && !s.oriented);
  EXPECT_NE(s.first_fault.find("inverted orientation"), std::string::npos);
  EXPECT_EQ(error_code([&] { require_solid(m, "a.stl"); }), "mesh-inverted");
}

TEST(CheckMesh, TellsOneTurnedTriangle) {
  TriMesh m = box_mesh({0, 0, 0}, {2, 2, 2});
  std::swap(m.triangles[5][0], m.triangles[5][1]);
  const MeshSummary s = check_mesh(m);
  EXPECT_TRUE(s.closed);
  EXPECT_FALSE(s.oriented);
  EXPECT_EQ(error_code([&] { require_solid(m, "a.stl"); }), "mesh-not-oriented");
}

TEST(CheckMesh, TellsEdgesOfFourTriangles) {
  const TriMesh m = weld(joined(box_mesh({0, 0, 0}, {1, 1, 1}), box_mesh({1, 1, 0}, {2, 2, 1})));
  const MeshSummary s = check_mesh(m);
  EXPECT_FALSE(s.closed && s.manifold);
  EXPECT_NE(s.first_fault.find("more than two triangles"), std::string::npos) << s.first_fault;
  EXPECT_EQ(error_code([&] { require_solid(m, "a.stl"); }), "mesh-not-manifold");
}

TEST(CheckMesh, TellsSolidsThatTouchInAPoint) {
  const TriMesh m = weld(joined(box_mesh({0, 0, 0}, {1, 1, 1}), box_mesh({1, 1, 1}, {2, 2, 2})));
  const MeshSummary s = check_mesh(m);
  EXPECT_TRUE(s.closed && s.oriented && !s.manifold);
  EXPECT_NE(s.first_fault.find("(1, 1, 1)"), std::string::npos) << s.first_fault;
  EXPECT_EQ(error_code([&] { require_solid(m, "a.stl"); }), "");
}

TEST(CheckMesh, CountsPiecesAndCavities) {
  const TriMesh cavity =
      joined(box_mesh({0, 0, 0}, {9, 9, 9}), flipped(box_mesh({1, 1, 1}, {2, 2, 2})));
  EXPECT_EQ(check_mesh(cavity).components, 2u);
  EXPECT_EQ(check_mesh(cavity).euler, 4);
  EXPECT_DOUBLE_EQ(check_mesh(cavity).volume, 728);
}

TEST(CheckMesh, FindsTrianglesWithoutArea) {
  TriMesh m = box_mesh({0, 0, 0}, {2, 2, 2});
  // Splits the edge 0-1 of two triangles at its middle, and puts a sliver between.
  m.vertices.push_back({1, 0, 0});
  m.triangles[1] = {0, 3, 8};
  m.triangles.push_back({8, 3, 1});
  m.triangles.push_back({0, 8, 1});
  const MeshSummary s = check_mesh(m);
  EXPECT_TRUE(s.closed && s.manifold) << s.first_fault;
  EXPECT_EQ(s.degenerate, 1u);
  EXPECT_NE(s.first_fault.find("without area"), std::string::npos);
}

TEST(CheckMesh, SurvivesWrongContent) {
  TriMesh m = box_mesh({0, 0, 0}, {2, 2, 2});
  m.triangles[4][2] = 77;
  EXPECT_NE(check_mesh(m).first_fault.find("names vertex 78"), std::string::npos);
  m.triangles[4][2] = m.triangles[4][1];
  EXPECT_FALSE(check_mesh(m).manifold);
  m.vertices[1][2] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(error_code([&] { require_solid(m, "a.stl"); }), "mesh-invalid");
  EXPECT_FALSE(check_mesh({}).closed);
}

TEST(CheckMesh, IsTheSameForAnyNumberOfThreads) {
  const TriMesh m = sphere_mesh(600, 12.34, {1, 2, 3});
  const MeshSummary a = check_mesh(m, 1), b = check_mesh(m, 2), c = check_mesh(m, 7);
  EXPECT_EQ(a.volume, b.volume);
  EXPECT_EQ(a.volume, c.volume);
  EXPECT_EQ(a.area, c.area);
}

TEST(HalfEdges, OppositesAreMutual) {
  const TriMesh m = sphere_mesh(40, 3);
  const std::vector<std::uint32_t> opposite = find_opposites(m);
  for (std::uint32_t h = 0; h < opposite.size(); ++h) {
    ASSERT_TRUE(is_half_edge(opposite[h]));
    EXPECT_EQ(opposite[opposite[h]], h);
    EXPECT_EQ(origin_of(m, h), target_of(m, opposite[h]));
  }
}

}  // namespace
}  // namespace mrsim
