// Walls and gaps below the voxel: a mesh with a tolerance holds them, or the report names them.
#include "mesh/cells/thin_features.h"

#include "core/numbers/triangle_tree.h"
#include "core/numbers/vec.h"
#include "mesh/cells/octree.h"
#include "mesh/mesh_part.h"
#include "support/analytic_field.h"
#include "support/rounds.h"

#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;
using detail::CellOctree;
using detail::FoundThin;
using detail::Lattice;
using detail::MinimalEdge;

constexpr double kVoxel = 0.5, kTop = 10, kFloor = 5, kRadius = 3;
constexpr Box3 kStock{{0, 0, 0}, {30, 20, kTop}};
constexpr double kHalfWall = 0.075 * kVoxel;
constexpr int kPoints = 21;

struct Made {
  TriMesh mesh;
  MeshReport report;
};

Made made(const AnalyticField& part, double tolerance, double voxel = kVoxel) {
  MeshPlan options;
  options.tolerance = tolerance;
  Made out;
  out.mesh = mesh_part(part, voxel, options, &out.report);
  return out;
}

// A place in plan, and the direction of a wall through it.
struct Place {
  Vec2 middle, along;
  Vec2 across() const { return {-along.y, along.x}; }
};

Place place(int k, double turn) {
  return {{15 + 0.07 * k * kVoxel, 10 + 0.19 * k * kVoxel}, {std::cos(turn), std::sin(turn)}};
}

// A slot of 6 mm along `way` that comes no nearer to the middle than `off`, on the side of its
// sign.
Cut slot_beside(const Place& at, Vec2 way, double off) {
  const Vec2 side{-way.y, way.x};
  const Vec2 center = at.middle + (off + (off > 0 ? kRadius : -kRadius)) * side;
  return flat_line(center - 3.0 * way, center + 3.0 * way, kRadius, kFloor);
}

std::vector<Cut> wall(const Place& at, double half = kHalfWall) {
  return {slot_beside(at, at.along, -half), slot_beside(at, at.along, half)};
}

// What two slots across a wall leave of it.
std::vector<Cut> short_wall(const Place& at, double half_length) {
  std::vector<Cut> cuts = wall(at);
  cuts.push_back(slot_beside(at, at.across(), -half_length));
  cuts.push_back(slot_beside(at, at.across(), half_length));
  return cuts;
}

// How many of the points along a wall the mesh holds.
int held(const TriMesh& mesh, const Place& at, double half_length) {
  const TriangleTree tree(mesh);
  int count = 0;
  for (int i = 0; i < kPoints; ++i) {
    const Vec2 p = at.middle + (0.1 * i - 1) * half_length * at.along;
    count += tree.signed_distance({p.x, p.y, 0.5 * (kFloor + kTop)}) < 0;
  }
  return count;
}

// Wherever they lie in the cells, which may be larger than a voxel.
TEST(Thin, WallsAreReportedWhereTheyAreLostAndOnlyThere) {
  for (const double tolerance : {0.05, 0.2})
    for (const double turn : {0.0, 0.02, 0.4})
      for (unsigned k = 0; k < rounds(3); ++k) {
        const Place at = place(k, turn);
        const Made part = made({kStock, false, wall(at)}, tolerance);
        EXPECT_EQ(held(part.mesh, at, 2.5) == kPoints, part.report.thin.empty())
            << tolerance << " " << turn << " " << k;
      }
}

// No cell need have a corner or an edge near them: the lattice in large cells shows them.
TEST(Thin, ShortWallsAreKeptOrReported) {
  constexpr double kHalfLength = 0.9 * kVoxel;
  for (const double tolerance : {0.01, 0.05})
    for (const double turn : {0.0, 0.02, 0.4})
      for (unsigned k = 0; k < rounds(6); ++k) {
        const Place at = place(k, turn);
        const Made part = made({kStock, false, short_wall(at, kHalfLength)}, tolerance);
        EXPECT_TRUE(held(part.mesh, at, 0.8 * kHalfLength) == kPoints || !part.report.thin.empty())
            << tolerance << " " << turn << " " << k;
      }
}

// A pin between four cuts may stand amid a column of cells, so that it passes none of their edges;
// one that is as low as a cell does not even pass their sides.
TEST(Thin, PinsAreKept) {
  int k = 0;
  for (const double tolerance : {0.0, 0.01, 0.05})
    for (const double half : {0.1 * kVoxel, 0.3 * kVoxel})
      for (const double turn : {0.0, 0.02, 0.4}) {
        const Place at = place((k + k / 3) % 3, turn);  // each turn at each place
        ++k;
        std::vector<Cut> cuts = wall(at, half);
        cuts.push_back(slot_beside(at, at.across(), -half));
        cuts.push_back(slot_beside(at, at.across(), half));
        const Made part = made({kStock, false, cuts}, tolerance);
        const int count = held(part.mesh, at, 0.5 * half);
        // Cells are split until they hold a pin above the tolerance; a grid draws badly what is
        // thinner than its voxels.
        EXPECT_TRUE(tolerance > 0 ? count == kPoints && part.report.thin.empty()
                                  : count > 0 || !part.report.thin.empty())
            << tolerance << " " << half << " " << turn << " " << at.middle.x;
      }
}

// Default settings have room for so many nodes: pins of two widths stand between slots, and the
// thin ones take too many. They are named, and the bound is that of what was drawn.
TEST(Thin, TheThickestPinsAreKeptWhereNotAllFit) {
  constexpr double kTolerance = 0.01, kThick = 0.3 * kVoxel, kThin = 0.06 * kVoxel;
  std::vector<Cut> cuts;
  std::vector<Place> thick;
  for (int k = 0; k < 8; ++k) {
    const Place at{{10 + 14.07 * (k % 4), 10 + 16.2 * (k / 4)}, {1, 0}};
    if (k % 2 == 0) thick.push_back(at);
    const double half = k % 2 == 0 ? kThick : kThin;
    for (const Vec2 way : {at.along, at.across()})
      for (const double off : {-half, half}) cuts.push_back(slot_beside(at, way, off));
  }
  MeshPlan options;
  options.tolerance = kTolerance;
  options.most_nodes = 100'000;
  MeshReport report;
  const Box3 stock{{0, 0, 0}, {62, 36, kTop}};
  const TriMesh mesh = mesh_part(AnalyticField(stock, false, cuts), kVoxel, options, &report);
  for (const Place& at : thick) EXPECT_EQ(held(mesh, at, 0.5 * kThick), kPoints) << at.middle.x;
  EXPECT_FALSE(report.thin.empty());
  for (const ThinFeature& f : report.thin) EXPECT_LT(f.thickness, kThick);
  EXPECT_LE(report.bound, kTolerance);
}

TEST(Thin, LowPinsAreKeptOrReported) {
  constexpr double kHalf = 0.15 * kVoxel, kHeight = 0.6 * kVoxel;
  for (const double turn : {0.0, 0.4})
    for (unsigned k = 0; k < rounds(6); ++k) {
      const Place at = place(k, turn);
      std::vector<Cut> cuts = wall(at, kHalf);
      cuts.push_back(slot_beside(at, at.across(), -kHalf));
      cuts.push_back(slot_beside(at, at.across(), kHalf));
      const Vec2 a = at.middle - 4.0 * at.along, b = at.middle + 4.0 * at.along;
      cuts.push_back(flat_line(a, b, kRadius, kFloor + kHeight));
      const Made part = made({kStock, false, cuts}, 0.01);
      const TriangleTree tree(part.mesh);
      const Vec3 middle{at.middle.x, at.middle.y, kFloor + 0.5 * kHeight};
      EXPECT_TRUE(tree.signed_distance(middle) < 0 || !part.report.thin.empty())
          << turn << " " << k;
    }
}

// Slots whose round ends come through the side of the stock, by little, beside each other: thin
// edges at the side end on the floor.
std::vector<Cut> scallops() {
  std::vector<Cut> cuts;
  for (const double x : {4.0, 9.3, 14.6, 19.9, 25.2})
    cuts.push_back(flat_line({x, 10}, {x, kRadius - 0.15}, kRadius, kFloor));
  return cuts;
}

TEST(Thin, TipsThatTheMeshHoldsAreNotReported) {
  for (const double tolerance : {0.01, 0.034, 0.1})
    EXPECT_TRUE(made({kStock, false, scallops()}, tolerance).report.thin.empty()) << tolerance;
}

TEST(Thin, WallsBesideSuchTipsAreReported) {
  const Place at{{17.2, 15.1}, {0, 1}};
  for (const double tolerance : {0.01, 0.034, 0.1}) {
    std::vector<Cut> cuts = scallops();
    for (const Cut& cut : short_wall(at, 0.9 * kVoxel)) cuts.push_back(cut);
    const Made part = made({kStock, false, cuts}, tolerance);
    if (held(part.mesh, at, 0.8 * kVoxel) == kPoints) continue;
    ASSERT_FALSE(part.report.thin.empty()) << tolerance;
    for (const ThinFeature& f : part.report.thin)
      EXPECT_LT(length(Vec2{f.place.x, f.place.y} - at.middle), kVoxel) << tolerance;
  }
}

// What the grid shows of a part with walls or gaps, and what of it other parts' meshes have lost.
class Lost : public ::testing::Test {
 protected:
  static constexpr double kTolerance = 0.01;

  explicit Lost(const std::vector<Cut>& cuts = wall(place(1, 0)))
      : part_(kStock, false, cuts), tree_(part_, lattice_, 0, 1), edges_(tree_.doubtful_edges()) {}

  std::size_t shown() const { return detail::thin_features(part_, tree_, edges_).size(); }
  std::vector<FoundThin> lost(const std::vector<Cut>& cuts,
                              const std::vector<MinimalEdge>& edges) const {
    const TriMesh mesh = made({kStock, false, cuts}, kTolerance, kVoxel / 8).mesh;
    return detail::lost_features(part_, tree_, edges, mesh, kTolerance, 0, 1);
  }
  std::size_t lost(const std::vector<Cut>& cuts) const { return lost(cuts, edges_).size(); }

  Lattice lattice_{kStock, kVoxel, 4};
  AnalyticField part_;
  CellOctree tree_;
  std::vector<MinimalEdge> edges_;
};

TEST_F(Lost, NothingIsLostByItsOwnMesh) {
  EXPECT_GT(shown(), 20u);
  EXPECT_EQ(lost(wall(place(1, 0))), 0u);
}

TEST_F(Lost, WallThatIsNotThere) {
  std::vector<Cut> cuts = wall(place(1, 0));
  cuts.push_back(flat_line({12, 10}, {18, 10}, kRadius, kFloor));
  EXPECT_GE(lost(cuts), shown());  // edges beside it, too
}

TEST_F(Lost, AWallElsewhereIsNotTheWall) {
  Place moved = place(1, 0);
  moved.middle.y += 2 * kTolerance;
  EXPECT_GE(lost(wall(moved)), shown());
  EXPECT_GE(lost(wall(place(1, 0), kHalfWall + 2 * kTolerance)), shown());
}

// Rows of a ball that leave crests 3.75 um high, of which 1.75 um stand above a plane of the grid.
std::vector<Cut> crests(double pitch) {
  const Lattice lattice{kStock, kVoxel, 4};
  const double plane = lattice.coordinate(2, 10 * lattice.per_voxel()), below = 0.002;
  std::vector<Cut> cuts;
  for (double off = -3; off <= 3; off += pitch) {
    const Vec2 from{9 + off, 7 - off}, to{15 + off, 13 - off};
    cuts.push_back(ball_line(from, to, kRadius, plane - below + kRadius));
  }
  return cuts;
}
const double kPitch = 0.3 / std::sqrt(2.0);

class LostCrest : public Lost {
 protected:
  LostCrest() : Lost(crests(kPitch)) {}
};

// A mesh may cut off what is lower than the tolerance.
TEST_F(LostCrest, IsNoWall) {
  EXPECT_GT(shown(), 20u);
  EXPECT_EQ(lost(crests(kPitch / 2)), 0u);
}

// Between this plane of the grid and the next, so that all edges that show the wall are held.
TEST_F(Lost, AWallIsLostWhereItEndsBesideAnEdge) {
  const Place at = place(1, 0);
  const std::int32_t voxel = lattice_.per_voxel();
  const auto plane = static_cast<std::int32_t>((at.middle.x - lattice_.coordinate(0, 0)) / kVoxel);
  std::vector<Cut> cuts = wall(at);
  const Place end{{lattice_.coordinate(0, plane * voxel) + 0.4 * kVoxel, at.middle.y}, at.along};
  cuts.push_back(slot_beside(end, {0, -1}, 1e-9));
  for (const int before : {0, 2}) {
    std::vector<MinimalEdge> edges;
    for (const MinimalEdge& e : edges_)
      if (e.axis == 1 && e.start.x == (plane - before) * voxel) edges.push_back(e);
    ASSERT_FALSE(detail::thin_features(part_, tree_, edges).empty());
    EXPECT_EQ(lost(cuts, edges).empty(), before > 0);
  }
}

std::vector<Cut> gap() {
  return {flat_line({5, 10}, {25, 10}, 0.04, kFloor),
          flat_line({5, 10.03}, {25, 10.03}, 0.04, kFloor)};
}

class LostGap : public Lost {
 protected:
  LostGap() : Lost(gap()) {}
};

TEST_F(LostGap, IsReported) {
  EXPECT_GT(shown(), 20u);
  EXPECT_EQ(lost(gap()), 0u);
  EXPECT_EQ(lost({flat_line({5, 10.6}, {25, 10.6}, 0.04, kFloor)}), shown());
}

}  // namespace
}  // namespace mrsim
