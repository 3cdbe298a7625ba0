// A part of the surface, drawn about cells that have changed, is the same as there in the whole.
#include "core/numbers/vec.h"
#include "mesh/surface/dual_surface.h"
#include "removal/part/part_field.h"
#include "support/shapes.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace detail;

// Grooves of a ball and pockets of a flat end mill that cross at odd angles.
PartField crossing_grooves() {
  std::vector<Tool> tools(2);
  tools[0].type = ToolType::ballmill;
  tools[0].diameter = 3;
  tools[1].diameter = 4;
  std::vector<Motion> motions;
  for (int k = 0; k < 12; ++k) {
    Motion m;
    m.kind = MotionKind::line;
    m.tool = k % 2;
    const double at = 1.7 * k;
    m.start = k % 3 ? Vec3{-2, at, -1 - 0.1 * k} : Vec3{at, -2, -1.5};
    m.end = k % 3 ? Vec3{22, 20 - 0.8 * at, -1 - 0.2 * k} : Vec3{19 - at, 22, -2};
    motions.push_back(m);
  }
  const StockShape shape = testing::box_stock({0, 0, -6}, {20, 20, 0});
  return {StockSolid(shape), SweepTable(motions, tools)};
}

using Triangle = std::vector<std::tuple<double, double, double>>;

// The triangles about each edge, as corners from the least one on; only of edges that are owned.
std::map<std::uint64_t, std::set<Triangle>> triangles_of(const DualSurface& surface) {
  std::map<std::uint64_t, std::set<Triangle>> out;
  const BaseMesh& mesh = surface.mesh();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Triangle corners;
    for (const std::uint32_t v : mesh.triangles[t]) {
      const Vec3& p = mesh.vertices[v];
      corners.emplace_back(p.x, p.y, p.z);
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    out[edge_key(at(surface.crossings(), mesh.crossings[t]).edge)].insert(corners);
  }
  return out;
}

std::vector<std::int32_t> every_nth_leaf(const CellOctree& tree, std::size_t n, std::size_t from) {
  std::vector<std::int32_t> leaves;
  std::size_t seen = 0;
  for (std::size_t k = 0; k < tree.size(); ++k) {
    const auto cell = static_cast<std::int32_t>(k);
    if (tree.node(cell).child < 0 && tree.node(cell).signs_differ && seen++ % n == from)
      leaves.push_back(cell);
  }
  return leaves;
}

TEST(PartOfSurface, HasAllTrianglesThatChange) {
  const PartField field = crossing_grooves();
  const double tolerance = 0.02;
  const Lattice lattice(field.bounds(), 0.5, 6);
  CellOctree tree(field, lattice, tolerance, 1);
  const DualSurface::Options options{
      .shallow = tolerance / 8, .sharpen = true, .remember = true, .threads = 1};
  DualSurface part(field, tree, options), whole(field, tree, options);
  const auto draw = [](DualSurface& surface, CrossedGrid grid) {
    surface.find_loops(std::move(grid));
    surface.make_triangles();
    return triangles_of(surface);
  };
  auto before = draw(whole, split_badly_crossed(tree));
  for (std::size_t round = 0; round < 4; ++round) {
    const std::size_t nodes = tree.size();
    tree.split(every_nth_leaf(tree, 97, 13 * round));
    std::vector<char> changed(tree.size());
    std::fill(changed.begin() + static_cast<std::ptrdiff_t>(nodes), changed.end(), 1);
    const auto some = draw(part, split_badly_crossed(tree, changed));
    const auto all = draw(whole, split_badly_crossed(tree));
    EXPECT_LT(some.size(), all.size());
    for (const auto& [edge, triangles] : some) {
      ASSERT_EQ(all.count(edge), 1u) << "round " << round;
      ASSERT_EQ(triangles, all.at(edge)) << "round " << round;
    }
    std::size_t fresh = 0;
    for (const auto& [edge, triangles] : all) {
      if (before.count(edge) != 0 && before.at(edge) == triangles) continue;
      ++fresh;
      ASSERT_EQ(some.count(edge), 1u) << "round " << round;
    }
    EXPECT_GT(fresh, 50u);
    before = all;
  }
}

}  // namespace
}  // namespace mrsim
