// Simplification that makes a mesh meet itself: what stays of it.
#include "mesh/simplify/simplify_apart.h"

#include "core/numbers/vec.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

namespace mrsim::detail {
namespace {

// Two sheets of n squares a side, 1 mm apart, each bent by 2 mm along x.
LabelledMesh bent_sheets(std::uint32_t n) {
  LabelledMesh mesh;
  for (const double z : {0.0, 1.0})
    for (std::uint32_t x = 0; x <= n; ++x)
      for (std::uint32_t y = 0; y <= n; ++y) {
        const double t = 2.0 * x / n - 1;
        mesh.vertices.push_back({double(x), double(y), z + 2 * (1 - t * t)});
      }
  for (std::uint32_t s = 0; s < 2; ++s)
    for (std::uint32_t x = 0; x < n; ++x)
      for (std::uint32_t y = 0; y < n; ++y) {
        const std::uint32_t a = (s * (n + 1) + x) * (n + 1) + y, b = a + n + 1;
        mesh.triangles.push_back({a, b, b + 1});
        mesh.triangles.push_back({a, b + 1, a + 1});
      }
  mesh.labels.resize(mesh.triangles.size());
  mesh.faces.emplace_back();
  return mesh;
}

// Flattens what it may of the lower sheet, so that it meets the upper one at its ends.
LabelledMesh flattened(const LabelledMesh& mesh, const std::vector<char>& locked) {
  LabelledMesh out = mesh;
  for (std::size_t v = 0; v < mesh.vertices.size() / 2; ++v)
    if (!locked[v]) out.vertices[v].z = 1.75;
  return out;
}

TEST(SimplifyApart, KeepsTheVerticesAboutAPlaceThatMeets) {
  const LabelledMesh mesh = bent_sheets(12);
  const ApartMesh found = simplify_apart(
      mesh, 1.5, 1, [&](const std::vector<char>& locked) { return flattened(mesh, locked); });
  EXPECT_GT(found.kept, 0u);
  EXPECT_LT(found.kept, mesh.vertices.size());
  EXPECT_EQ(found.mesh.vertices[6 * 13 + 6].z, 1.75);
}

TEST(SimplifyApart, GivesTheMeshItselfWhereNothingHelps) {
  const LabelledMesh mesh = bent_sheets(4);
  const ApartMesh found = simplify_apart(mesh, 0.1, 1, [&](const std::vector<char>&) {
    return flattened(mesh, std::vector<char>(mesh.vertices.size(), 0));
  });
  EXPECT_EQ(found.kept, mesh.vertices.size());
  EXPECT_EQ(found.mesh.vertices, mesh.vertices);
}

TEST(SimplifyApart, KeepsNothingWhereNothingMeets) {
  const LabelledMesh mesh = bent_sheets(4);
  EXPECT_EQ(simplify_apart(mesh, 1, 1, [&](const std::vector<char>&) { return mesh; }).kept, 0u);
}

}  // namespace
}  // namespace mrsim::detail
