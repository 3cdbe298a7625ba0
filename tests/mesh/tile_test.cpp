// What a tile makes of a cell depends on the cell's place alone, so that tiles fit each other.
#include "mesh/cells/tile.h"

#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "mesh/mesh_part.h"
#include "mesh/solid/check.h"
#include "mesh/surface/dual_surface.h"
#include "mesh/tiles/uniform.h"
#include "removal/part/part_field.h"
#include "support/analytic_field.h"
#include "support/cgal_mesh.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace detail;

// A raster of short lines with steps in it.
PartField raster(const Vec3& origin, const Tool& tool, bool steep) {
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
  return {StockSolid(testing::box_stock(origin - Vec3{1, 1, 4}, origin + Vec3{9, 8, 1})),
          SweepTable(motions, {&tool, 1})};
}
PartField raster(const Vec3& origin, double diameter, bool steep) {
  Tool ball;
  ball.type = ToolType::ballmill;
  ball.diameter = diameter;
  return raster(origin, ball, steep);
}

using Place = std::tuple<int, int, int, int>;

using Found = std::map<Place, std::vector<std::tuple<double, double, double, int, int>>>;

// All of a surface, by place: crossings by edge, vertices by cell (axis -1).
Found all_of(const DualSurface& surface, const SurfaceCells& cells) {
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

DualSurface::Options options(const Lattice& lattice) {
  return {.shallow = lattice.voxel() / 64, .threads = 1};
}

Found found(const PartField& field, const Lattice& lattice, const LatticePoint& first) {
  CellTile tile(field, lattice);
  DualSurface surface(field, tile, options(lattice));
  tile.build(first, field.all(), CellTile::FlatCells::kept);
  surface.find_loops(tile);
  surface.make_triangles();
  return all_of(surface, tile);
}

// The same cells, as a tree with leaves of one size.
Found found_by_tree(const PartField& field, const Lattice& lattice, const LatticePoint& first) {
  const std::int32_t unit = lattice.per_voxel();
  OctreePart part;
  part.origin = {first.x * unit, first.y * unit, first.z * unit};
  part.size = CellTile::kCells * unit;
  const Candidates all = field.all();
  part.candidates = all;
  part.complete[0] = unit, part.complete[1] = part.size - unit;
  part.owned[0] = CellTile::kFirstOwned * unit, part.owned[1] = CellTile::kEndOwned * unit;
  CellOctree tree(field, lattice, part);
  DualSurface surface(field, tree, options(lattice));
  surface.find_loops(split_badly_crossed(tree));
  surface.make_triangles();
  return all_of(surface, tree);
}

TEST(CellTile, TilesAgreeOnWhatTheyShare) {
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

// Cells of tools whose heights prune long lists, which tiles share otherwise.
TEST(CellTile, TilesAgreeOnLongLists) {
  Tool flat;
  flat.diameter = 4;
  Tool taper;
  taper.type = ToolType::taper;
  taper.diameter = 6, taper.tip_diameter = 1, taper.corner_radius = 0.5;
  taper.taper_angle = 0.2;
  Tool v;
  v.type = ToolType::chamfer;
  v.diameter = 6;
  for (const Tool& tool : {flat, taper, v})
    for (const bool steep : {false, true}) {
      const PartField field = raster({-3.3, 100.37, -20.1}, tool, steep);
      const Lattice lattice(field.bounds(), 0.17, 2, 4);
      const auto one = found(field, lattice, {2, 1, 0});
      const auto other = found(field, lattice, {3, 2, 1});
      std::size_t shared = 0, differ = 0;
      for (const auto& [place, values] : one) {
        const auto known = other.find(place);
        if (known == other.end()) continue;
        ++shared;
        differ += values != known->second;
      }
      EXPECT_EQ(differ, 0u) << "of " << shared;
      EXPECT_GT(shared, 6000u);
    }
}

// Tiles next to one of which cells are split are made by a tree.
TEST(CellTile, FindsWhatATreeFinds) {
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

struct TileMeasure {
  double area = 0, volume = 0;  ///< of the cones from a point
  std::size_t triangles = 0;
  std::map<std::pair<Place, Place>, int> sides;  ///< of triangles, less those of neighbours
};

TileMeasure measured(const PartField& field, const Lattice& lattice, const LatticePoint& first,
                     CellTile::FlatCells flat) {
  CellTile tile(field, lattice);
  DualSurface surface(field, tile, options(lattice));
  tile.build(first, field.all(), flat);
  surface.find_loops(tile);
  const BaseMesh& mesh = surface.make_triangles();
  const Vec3 middle = field.bounds().lo;
  TileMeasure out;
  const auto place = [&](std::uint32_t v) {
    const Vec3& p = mesh.vertices[v];
    const auto steps = [](double x) { return static_cast<int>(x * (1 << 20)); };
    return Place{steps(p.x), steps(p.y), steps(p.z), 0};
  };
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[0]] - middle, b = mesh.vertices[t[1]] - middle,
               c = mesh.vertices[t[2]] - middle;
    out.area += 0.5 * length(cross(b - a, c - a));
    out.volume += dot(a, cross(b, c)) / 6;
    for (std::size_t k = 0; k < 3; ++k) {
      const Place from = place(t[k]), to = place(t[(k + 1) % 3]);
      if (--out.sides[{to, from}] == 0) out.sides.erase({to, from});
      if (++out.sides[{from, to}] == 0) out.sides.erase({from, to});
    }
  }
  out.triangles = mesh.triangles.size();
  return out;
}

// Squares of cells cover what their cells would: the border of the tile's surface stays, and so do
// its area and what lies beneath it.
TEST(CellTile, FlatCellsAreMergedWithoutATrace) {
  int round = 0;
  double before = 0, after = 0;
  for (const Vec3& origin : {Vec3{}, Vec3{1000, -500, 3}, Vec3{-3.3, 100.37, -20.1}})
    for (const double voxel : {0.17, 0.05}) {
      ++round;
      const PartField field = raster(origin, 0.9, round % 2 == 0);
      const Lattice lattice(field.bounds(), voxel, 2, 4);
      for (const LatticePoint first : {LatticePoint{2, 1, 0}, LatticePoint{40, 20, 40}}) {
        const TileMeasure all = measured(field, lattice, first, CellTile::FlatCells::kept);
        const TileMeasure some = measured(field, lattice, first, CellTile::FlatCells::merged);
        if (all.triangles == 0) continue;
        EXPECT_EQ(all.sides, some.sides);
        EXPECT_NEAR(all.area, some.area, 1e-9 * all.area) << "round " << round;
        EXPECT_NEAR(all.volume, some.volume, 1e-9 * std::abs(all.volume));
        before += static_cast<double>(all.triangles);
        after += static_cast<double>(some.triangles);
      }
    }
  EXPECT_LT(after, 0.8 * before);
}

// A plate of many tiles, with slots beside which a thin wall stays: tiles that no cut reaches have
// one square on a side, so that there are far fewer triangles than cells on the sides. The cells of
// the wall are split, and tiles that hold them draw all cells.
TEST(CellTile, SidesThatNoCutReachesAreOneSquareATile) {
  Tool mill;
  mill.diameter = 1;
  for (const Vec3& origin : {Vec3{}, Vec3{-3.3, 100.37, -20.1}})
    for (const double wall : {2.0, 0.07, 0.02}) {
      std::vector<Motion> slots(2);
      for (Motion& m : slots) m.kind = MotionKind::line, m.tool = 0;
      for (const int k : {0, 1}) {
        slots[k].start = origin + Vec3{23, 24 + k * (1 + wall), -1};
        slots[k].end = slots[k].start + Vec3{3, 0, 0};
      }
      const StockShape plate = testing::box_stock(origin - Vec3{0, 0, 5}, origin + Vec3{60, 45, 0});
      const PartField field{StockSolid(plate), SweepTable(slots, {&mill, 1})};
      const TriMesh mesh = mesh_part(field, 0.1, MeshPlan{});
      testing::expect_closed_manifold(mesh);
      EXPECT_EQ(testing::self_intersections(mesh), 0u) << wall;
      const double slot = 3 + kPi / 4;
      EXPECT_NEAR(check_mesh(mesh).volume, 60 * 45 * 5 - 2 * slot, 0.02 * slot + 4 * wall * wall)
          << wall;
      EXPECT_LT(mesh.triangles.size(), 2 * 2 * (2 * 60 * 45 + 2 * 105 * 5) / 0.01 / 20) << wall;
      for (const std::size_t room : {0u, 100'000u, 100'000'000u}) {
        MeshPlan two;
        two.threads = 2;
        two.tile_room = room;
        const TriMesh same = mesh_part(field, 0.1, two);
        EXPECT_EQ(mesh.triangles, same.triangles) << wall << ", room " << room;
        EXPECT_EQ(mesh.vertices, same.vertices) << wall << ", room " << room;
      }
    }
}

// Beyond the reach of a cell its list may lack sweeps, so nothing is concluded from samples there.
TEST(CellTile, ASearchThatIsLedOutOfItsCellEnds) {
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

// A field whose lists hang on how they were come by, and its answers away from the surface on the
// list that it is asked with, as far as its promises allow: every other list has a sweep too many,
// and every other one lacks what decides d there.
class FarOffField final : public ExactField {
 public:
  explicit FarOffField(const PartField& part) : part_(part) {}
  Candidates all() const override { return part_.all(); }
  Region restrict_to(const Box3& box, double band, std::span<const std::uint32_t> in,
                     Candidates& out) const override {
    const Region region = part_.restrict_to(box, band, in, out);
    if (in.size() % 2 == 0 || out.empty()) return region;
    const auto more = std::find_if(in.begin(), in.end(), [&](std::uint32_t i) {
      return !std::binary_search(out.begin(), out.end(), i);
    });
    if (more != in.end()) out.insert(std::upper_bound(out.begin(), out.end(), *more), *more);
    return region;
  }
  FieldSample sample(const Vec3& p, std::span<const std::uint32_t> list) const override {
    const FieldSample s = part_.sample(p, list);
    if (std::abs(s.distance) <= 1e-4 || s.owner == kStockOwner || list.size() % 2 == 0) return s;
    Candidates others(list.begin(), list.end());
    std::erase(others, part_.candidate(s.owner));
    const FieldSample other = part_.sample(p, others);
    return is_inside(other.distance) == is_inside(s.distance) ? other : s;
  }
  Vec3 gradient(const Vec3& p, const FieldSample& at) const override {
    return part_.gradient(p, at);
  }
  double patch_distance(const Vec3& p, const FieldSample& at) const override {
    return part_.patch_distance(p, at);
  }
  FacePlane face_plane(const Vec3& p, const FieldSample& at) const override {
    return part_.face_plane(p, at);
  }
  std::uint32_t candidate(std::int32_t owner) const override { return part_.candidate(owner); }
  bool expand_packs(const Box3& box, double band, std::span<const std::uint32_t> list,
                    Candidates& out) const override {
    return part_.expand_packs(box, band, list, out);
  }
  bool has_box_stock() const override { return part_.has_box_stock(); }
  Box3 bounds() const override { return part_.bounds(); }

 private:
  const PartField& part_;
};

TEST(CellTile, TilesMeetWhateverTheirListsLeaveOutFarOff) {
  Tool flat;
  flat.diameter = 1.2;
  for (const bool steep : {false, true}) {
    const PartField part = raster({-3.3, 100.37, -20.1}, flat, steep);
    const FarOffField field(part);
    const auto triangles = [&](std::size_t room) {
      MeshPlan plan;
      plan.tile_room = room;
      MeshReport report;
      MeshCollector mesh;
      mesh_uniform(field, 0.06, 2, plan, mesh, report);
      EXPECT_EQ(check_mesh(mesh.mesh()).first_fault, "");
      EXPECT_GT(report.passes, 1u) << "the field is as usual: nothing is tested";
      return mesh.mesh().triangles;
    };
    EXPECT_EQ(triangles(0), triangles(100'000'000));
  }
}

}  // namespace
}  // namespace mrsim
