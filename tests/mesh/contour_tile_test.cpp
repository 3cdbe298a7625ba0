// What a tile makes of a cell depends on the cell's place alone, so that tiles fit each other.
#include "mesh/contour_tile.h"

#include "core/vec.h"
#include "mesh/contour_surface.h"
#include "removal/part_field.h"
#include "support/analytic_field.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace detail;

// A raster of short lines with steps in it.
PartField raster(const Vec3& origin, double diameter, bool steep) {
  std::vector<Motion> motions;
  for (int row = 0; row < 24; ++row)
    for (int k = 0; k < 40; ++k) {
      const auto at = [&](int i) {
        const double x = 0.2 * (row % 2 ? 40 - i : i), y = 0.3 * row;
        const double step = steep && std::sin(1.7 * x) > 0.6 ? 1.2 : 0;
        return origin + Vec3{x, y, 0.6 * std::sin(0.9 * x) * std::cos(0.7 * y) - step};
      };
      Motion m;
      m.kind = MotionKind::line;
      m.tool = 0;
      m.start = at(k), m.end = at(k + 1);
      motions.push_back(m);
    }
  Tool ball;
  ball.type = ToolType::ballmill;
  ball.diameter = diameter;
  StockShape shape;
  shape.box = {origin - Vec3{1, 1, 4}, origin + Vec3{9, 8, 1}};
  return {StockSolid(shape), SweepTable(motions, {&ball, 1}, origin.z + 10)};
}

using Place = std::tuple<int, int, int, int>;

using Found = std::map<Place, std::vector<std::tuple<double, double, double, int, int>>>;

// All of a surface, by place: crossings by edge, vertices by cell (axis -1).
Found all_of(const ContourSurface& surface, const ContourCells& cells) {
  Found out;
  for (const Crossing& c : surface.crossings()) {
    const LatticePoint& p = c.edge.start;
    const Vec3& x = c.position;
    out[{p.x, p.y, p.z, c.edge.axis}].emplace_back(x.x, x.y, x.z, c.at.owner, c.at.patch);
  }
  for (const Loop& loop : surface.loops()) {
    if (!cells.is_complete(loop.cell)) continue;
    const LatticePoint p = cells.lattice().nearest(cells.box(loop.cell).lo);
    const Vec3& x = loop.point.position;
    out[{p.x, p.y, p.z, -1}].emplace_back(x.x, x.y, x.z, loop.point.count, 0);
  }
  for (auto& [place, values] : out) std::sort(values.begin(), values.end());
  return out;
}

ContourSurface::Options options(const Lattice& lattice) {
  return {.shallow = lattice.voxel() / 64, .threads = 1};
}

Found found(const PartField& field, const Lattice& lattice, const LatticePoint& first) {
  ContourTile tile(field, lattice);
  ContourSurface surface(field, tile, options(lattice));
  tile.build(first, field.all());
  surface.find_loops(tile);
  surface.make_triangles();
  return all_of(surface, tile);
}

// The same cells, as a tree with leaves of one size.
Found found_by_tree(const PartField& field, const Lattice& lattice, const LatticePoint& first) {
  const std::int32_t unit = lattice.per_voxel();
  OctreePart part;
  part.origin = {first.x * unit, first.y * unit, first.z * unit};
  part.size = ContourTile::kCells * unit;
  const Candidates all = field.all();
  part.candidates = all;
  part.complete[0] = unit, part.complete[1] = part.size - unit;
  part.owned[0] = ContourTile::kFirstOwned * unit, part.owned[1] = ContourTile::kEndOwned * unit;
  ContourOctree tree(field, lattice, part);
  ContourSurface surface(field, tree, options(lattice));
  surface.find_loops(split_badly_crossed(tree));
  surface.make_triangles();
  return all_of(surface, tree);
}

TEST(ContourTile, TilesAgreeOnWhatTheyShare) {
  int round = 0;
  for (const Vec3& origin : {Vec3{}, Vec3{1000, -500, 3}, Vec3{-3.3, 100.37, -20.1}})
    for (const double diameter : {6.0, 0.9}) {
      ++round;
      const PartField field = raster(origin, diameter, round % 2 == 0);
      const Lattice lattice(field.bounds(), 0.17, 2, 4);
      const auto one = found(field, lattice, {2, 1, 0});
      const auto other = found(field, lattice, {3, 1 + round % 3, round % 2});
      std::size_t shared = 0;
      for (const auto& [place, values] : one) {
        const auto known = other.find(place);
        if (known == other.end()) continue;
        ++shared;
        ASSERT_EQ(values, known->second) << "round " << round;
      }
      EXPECT_GT(shared, 8000u);
    }
}

// Tiles next to one of which cells are split are made by a tree.
TEST(ContourTile, FindsWhatATreeFinds) {
  int round = 0;
  for (const double diameter : {6.0, 0.9, 0.4}) {
    ++round;
    const PartField field = raster({-3.3, 100.37, -20.1}, diameter, round != 1);
    const Lattice lattice(field.bounds(), 0.17, 2, 4);
    const Found tile = found(field, lattice, {2, 1, 0});
    const Found tree = found_by_tree(field, lattice, {2, 1, 0});
    std::size_t creases = 0;
    for (const auto& [place, values] : tile) {
      const auto known = tree.find(place);
      ASSERT_NE(known, tree.end());
      ASSERT_EQ(values, known->second) << "round " << round;
      creases += std::get<3>(place) < 0 && std::get<3>(values[0]) > 1;
    }
    EXPECT_EQ(tile.size(), tree.size());
    EXPECT_GT(tile.size(), 8000u);
    EXPECT_GT(creases, 300u);
  }
}

// Beyond the reach of a cell its list may lack sweeps, so nothing is concluded from samples there.
TEST(ContourTile, ASearchThatIsLedOutOfItsCellEnds) {
  using namespace testing;
  const AnalyticField field({{-5, -5, -5}, {5, 5, 5}}, false,
                            {{Cut::Kind::half, {}, 0, 0.3, 0}, {Cut::Kind::half, {}, 0, 1.5, 0}});
  const Vec3 middle{0.5, 0.5, 0.5};
  const FieldSample near{-0.2, 0, 0}, beyond{-1, 1, 0};
  const Box3 room{{0, 0, 0}, {1, 1, 1}};
  SmoothSearch search(field, room, middle, &beyond);
  EXPECT_EQ(search.point().z, 1.5);
  FieldSample at = near;
  at.distance = field.patch_distance(search.point(), near);
  EXPECT_TRUE(search.take(field, at));
  EXPECT_EQ(search.result().count, 0);
}

}  // namespace
}  // namespace mrsim
