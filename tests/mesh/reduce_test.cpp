// Reduced meshes keep all promises; CGAL judges crossings, closed forms the shape.
#include "mesh/reduce/reduce.h"

#include "mesh/solid/check.h"
#include "support/cgal_mesh.h"
#include "support/shapes.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using testing::box_mesh;
using testing::cylinder_mesh;
using testing::tube_mesh;

void expect_sound(const TriMesh& mesh) {
  const MeshSummary s = check_mesh(mesh);
  EXPECT_TRUE(s.closed && s.oriented && s.manifold && s.degenerate == 0) << s.first_fault;
  EXPECT_EQ(testing::self_intersections(mesh), 0U);
}

// Each triangle in four, `times` times; coordinates stay multiples of 2^-20 mm.
TriMesh divided(TriMesh mesh, int times) {
  for (; times > 0; --times) {
    TriMesh out;
    const auto add = [&](const std::array<float, 3>& p) {
      for (std::size_t i = 0; i < out.vertices.size(); ++i)
        if (out.vertices[i] == p) return static_cast<std::uint32_t>(i);
      out.vertices.push_back(p);
      return static_cast<std::uint32_t>(out.vertices.size() - 1);
    };
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      std::array<std::uint32_t, 3> c{}, m{};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& a = mesh.vertices[mesh.triangles[i][k]];
        const auto& b = mesh.vertices[mesh.triangles[i][(k + 1) % 3]];
        c[k] = add(a);
        m[k] = add({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2});
      }
      out.triangles.insert(
          out.triangles.end(),
          {{c[0], m[0], m[2]}, {m[0], c[1], m[1]}, {m[2], m[1], c[2]}, {m[0], m[1], m[2]}});
      if (!mesh.owners.empty()) out.owners.insert(out.owners.end(), 4, mesh.owners[i]);
    }
    mesh = std::move(out);
  }
  return mesh;
}

TEST(Reduce, FlatFacesComeBackAsTheyWere) {
  TriMesh box = box_mesh({0, 0, 0}, {16, 8, 4});
  box.owners = {0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5};
  const TriMesh small = reduce_mesh(divided(box, 3), 12, {});
  ASSERT_EQ(small.triangles.size(), 12U);
  expect_sound(small);
  EXPECT_DOUBLE_EQ(signed_volume(small), 16 * 8 * 4);
  std::array<int, 6> faces{};
  for (const std::int32_t owner : small.owners) ++faces.at(static_cast<std::size_t>(owner));
  EXPECT_EQ(faces, (std::array<int, 6>{2, 2, 2, 2, 2, 2}));
}

TEST(Reduce, CylindersKeepTheirVolume) {
  const TriMesh fine = cylinder_mesh(512, 10, 0, 20);
  for (const std::size_t most : {800U, 300U, 100U}) {
    const TriMesh small = reduce_mesh(fine, most, {});
    ASSERT_LE(small.triangles.size(), most);
    expect_sound(small);
    // A prism of most / 4 sides: 1 - V / V0 is about (2 pi / n)^2 / 6; uneven sides lose more.
    const double side = 2 * 3.14159 / (static_cast<double>(most) / 4);
    EXPECT_NEAR(signed_volume(small) / signed_volume(fine), 1, side * side / 2) << most;
  }
}

// The walls are 0.1 mm apart: coarse chords of one would pass through the other.
TEST(Reduce, ThinWallsDoNotCross) {
  const TriMesh fine = tube_mesh(512, 10, 9.9, 0, 20);
  for (const std::size_t most : {1500U, 600U, 260U}) {
    const TriMesh small = reduce_mesh(fine, most, {});
    ASSERT_FALSE(small.triangles.empty());
    expect_sound(small);
  }
}

TEST(Reduce, ThreadsDoNotMatter) {
  const TriMesh fine = tube_mesh(256, 10, 9.5, 0, 20);
  MeshOptions one, four;
  one.threads = 1;
  four.threads = 4;
  const TriMesh a = reduce_mesh(fine, 300, one), b = reduce_mesh(fine, 300, four);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.triangles, b.triangles);
}

TEST(Reduce, SmallMeshesStay) {
  const TriMesh box = box_mesh({0, 0, 0}, {1, 2, 3});
  EXPECT_EQ(reduce_mesh(box, 12, {}).triangles, box.triangles);
}

}  // namespace
}  // namespace mrsim
