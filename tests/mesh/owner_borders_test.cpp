// Borders between owners on plane faces: where the floors of two passes meet.
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "mesh/mesh_part.h"
#include "mesh/solid/check.h"
#include "removal/part/part_field.h"
#include "support/moves.h"
#include "support/shapes.h"
#include "support/tools.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

constexpr double kVoxel = 0.5, kTolerance = 0.02;
constexpr double kRoom = kVoxel / 8;  // what docs/mesh.md promises of borders on planes

PartField milled(const std::vector<Motion>& motions) {
  const StockShape stock = box_stock({0, 0, -10}, {60, 50, 0});
  const Tool tool = endmill(10);
  return {StockSolid(stock), SweepTable(motions, std::span(&tool, 1))};
}

std::vector<Motion> path(const std::vector<Vec3>& places) {
  std::vector<Motion> out;
  for (std::size_t k = 0; k + 1 < places.size(); ++k)
    out.push_back(line(places[k], places[k + 1], static_cast<int>(k)));
  return out;
}

// A pocket 5 mm deep in rows 6 mm apart; then its outline once more.
std::vector<Motion> rows_and_outline() {
  return path({{10, 10, 5},
               {10, 10, -5},
               {50, 10, -5},
               {50, 16, -5},
               {10, 16, -5},
               {10, 22, -5},
               {50, 22, -5},
               {50, 28, -5},
               {10, 28, -5},
               {10, 40, -5},
               {50, 40, -5},
               {50, 10, -5},
               {10, 10, -5}});
}

// Half a turn at -3 between two lines.
std::vector<Motion> lines_and_arc() {
  std::vector<Motion> out = path({{10, 20, 5}, {10, 20, -3}, {25, 20, -3}});
  Motion arc = line({25, 20, -3}, {25, 40, -3}, 3);
  arc.kind = MotionKind::arc;
  arc.center = {25, 30, -3};
  arc.sweep = kPi;
  out.push_back(arc);
  out.push_back(line({25, 40, -3}, {10, 40, -3}, 4));
  return out;
}

// A slot 5 mm deep, in full circles one after the other.
std::vector<Motion> circles(int count) {
  std::vector<Motion> out;
  for (int k = 0; k < count; ++k) {
    const Vec3 from{15 + 0.4 * k, 25, -5};
    Motion circle = line(from, from, 2 * k);
    circle.kind = MotionKind::arc;
    circle.center = from + Vec3{0, 5, 0};
    circle.sweep = -kTwoPi;
    out.push_back(circle);
    out.push_back(line(from, from + Vec3{0.4, 0, 0}, 2 * k + 1));
  }
  return out;
}

TriMesh mesh_of(const PartField& part, int threads = 2, double tolerance = kTolerance) {
  MeshPlan options;
  options.tolerance = tolerance;
  options.threads = threads;
  return mesh_part(part, kVoxel, options);
}

Vec3 place(const TriMesh& mesh, std::uint32_t v) {
  const auto& p = mesh.vertices[v];
  return {p[0], p[1], p[2]};
}

// Points of the mesh's triangles at one height, a fifth of the sides apart, inside.
void for_floor(const TriMesh& mesh, double z,
               const std::function<void(std::size_t, const Vec3&)>& body) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& x = mesh.triangles[t];
    const Vec3 a = place(mesh, x[0]), b = place(mesh, x[1]), c = place(mesh, x[2]);
    if (std::max({std::abs(a.z - z), std::abs(b.z - z), std::abs(c.z - z)}) > 1e-6) continue;
    for (int i = 1; i < 5; ++i)
      for (int j = 1; i + j < 5; ++j) body(t, a + 0.2 * i * (b - a) + 0.2 * j * (c - a));
  }
}

// `test` holds of a place `room` mm beside p, in one of sixteen directions.
bool any_beside(const Vec3& p, double room, const std::function<bool(const Vec3&)>& test) {
  for (int k = 0; k < 16; ++k) {
    const double angle = k * kPi / 8;
    if (test(p + room * Vec3{std::cos(angle), std::sin(angle), 0})) return true;
  }
  return false;
}

// Points of the floor, no wall within `margin` mm, that are more than `room` mm away from what the
// owner of their triangle owns.
std::size_t far_from_their_owner(const PartField& part, const TriMesh& mesh, double z, double room,
                                 double margin = 0) {
  const Candidates all = part.all();
  std::size_t wrong = 0;
  for_floor(mesh, z, [&](std::size_t t, const Vec3& p) {
    const auto is_own = [&](const Vec3& q) { return part.sample(q, all).owner == mesh.owners[t]; };
    const auto is_wall = [&](const Vec3& q) {
      return is_inside(part.sample(q + Vec3{0, 0, 0.01}, all).distance);
    };
    if (is_own(p) || any_beside(p, room, is_own)) return;
    wrong += margin == 0 || !any_beside(p, margin, is_wall);
  });
  return wrong;
}

TEST(OwnerBorders, FloorsBelongToTheMoveThatCutThemFirst) {
  for (const auto& [motions, z] :
       {std::pair(rows_and_outline(), -5.0), std::pair(lines_and_arc(), -3.0)}) {
    const PartField part = milled(motions);
    const TriMesh mesh = mesh_of(part);
    const MeshSummary s = check_mesh(mesh);
    EXPECT_TRUE(s.closed && s.oriented && s.manifold) << s.first_fault;
    EXPECT_EQ(far_from_their_owner(part, mesh, z, 1.5 * kRoom), 0u);
  }
}

// The floor of the first row ends where its tool did: on lines 5 mm beside it, and half circles.
TEST(OwnerBorders, AreLinesAndArcs) {
  const PartField part = milled(rows_and_outline());
  const TriMesh mesh = mesh_of(part);
  std::size_t corners = 0;
  double area = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.owners[t] != 0 && mesh.owners[t] != 1) continue;
    const auto& x = mesh.triangles[t];
    const Vec3 a = place(mesh, x[0]), b = place(mesh, x[1]), c = place(mesh, x[2]);
    if (std::max({a.z, b.z, c.z}) > -5 + 1e-6) continue;
    area += 0.5 * length(cross(b - a, c - a));
    for (const Vec3& p : {a, b, c}) {
      const double along = std::clamp(p.x, 10.0, 50.0);
      const double off = std::hypot(p.x - along, p.y - 10);
      EXPECT_LE(off, 5 + kRoom);
      corners += std::abs(off - 5) < 1e-4;
    }
  }
  EXPECT_GT(corners, 20u);
  EXPECT_NEAR(area, 40 * 10 + kPi * 25, kRoom * (2 * 40 + 10 * kPi));
}

// Each triangle of the floor lies under many crescents. Cut at each border it crosses, without
// edges that are flipped, sixty circles gave 130 000 triangles, in 17 s. At the foot of the wall
// crescents end in points.
TEST(OwnerBorders, OfManyCirclesTakeFewTriangles) {
  const PartField part = milled(circles(60));
  const TriMesh mesh = mesh_of(part);
  const MeshSummary s = check_mesh(mesh);
  EXPECT_TRUE(s.closed && s.oriented && s.manifold) << s.first_fault;
  EXPECT_LT(mesh.triangles.size(), 60u * 100);
  EXPECT_EQ(far_from_their_owner(part, mesh, -5, 2 * kRoom, 2 * kRoom), 0u);
}

// Vertices of the uniform grid lie on the border, which bends by 0.01 mm along a chord; but for the
// last cells, whose vertices lie at the foot of a wall.
TEST(OwnerBorders, PassTheVerticesOfTheGrid) {
  const PartField part = milled(lines_and_arc());
  const TriMesh mesh = mesh_of(part, 2, 0);
  EXPECT_EQ(far_from_their_owner(part, mesh, -3, 0.02, kVoxel), 0u);
}

TEST(OwnerBorders, AreTheSameForAnyNumberOfThreads) {
  const PartField part = milled(rows_and_outline());
  const TriMesh one = mesh_of(part, 1);
  for (const int threads : {2, 7}) {
    const TriMesh many = mesh_of(part, threads);
    EXPECT_EQ(one.triangles, many.triangles);
    EXPECT_EQ(one.owners, many.owners);
    EXPECT_EQ(one.vertices, many.vertices);
  }
}

// A slot at 30 degrees, cut from its middle to one end and back through the other: its walls belong
// to both passes, and rounding takes now the one and now the other. There is no border to cut.
TEST(OwnerBorders, OfPassesOverOneWallAreNone) {
  const double u = 0.5 * std::sqrt(3.0), v = 0.5;
  const auto at = [&](double along, double z) { return Vec3{30 + along * u, 25 + along * v, z}; };
  const PartField field =
      milled(path({at(0, 5), at(0, -6), at(11, -6), at(-11, -6), at(11, -6), at(11, 5)}));
  const TriMesh mesh = mesh_of(field);
  const MeshSummary s = check_mesh(mesh);
  EXPECT_TRUE(s.closed && s.oriented && s.manifold) << s.first_fault;
  EXPECT_LT(mesh.triangles.size(), 2'000u);  // cut to pieces of the tolerance they were a million
}

// An outline through a sheet in seven laps: on its walls, which no edge of the grid follows, the
// floors of the laps leave bands narrower than a cell. Triangles that were cut at any of their
// edges first became slivers that each cross many borders.
TEST(OwnerBorders, OfBandsNarrowerThanCellsTakeFewCuts) {
  constexpr int kSides = 100, kLaps = 7;
  const auto rounded = [](double x) { return std::round(1000 * x) / 1000; };
  std::vector<Vec3> places;
  for (int k = 0; k <= kLaps * kSides; ++k) {
    const double turn = kTwoPi * k / kSides, r = 55 * (1 + 0.25 * sincos(5 * turn).sin);
    const auto [sin, cos] = sincos(turn);
    const double lap = k / kSides + std::min(1.0, (k % kSides + 1) / 6.0);
    places.push_back({rounded(r * cos), rounded(1.1 * r * sin), rounded(-3.0 / kLaps * lap)});
  }
  const StockShape sheet = box_stock({-90, -90, -3}, {90, 90, 0});
  const Tool tool = endmill(3.175);
  const PartField field{StockSolid(sheet), SweepTable(path(places), std::span(&tool, 1))};
  MeshPlan plan;
  plan.tolerance = 0.1;
  MeshReport report;
  mesh_part(field, 1, plan, &report);
  // There were 189 000 in one mesh; 44 000 of these come from the smaller cells about the floor
  // that the ramp of the last lap leaves.
  EXPECT_LT(report.triangles_before, 130'000u);
}

// A contour of short moves in five passes: a triangle over two of its faces has a neighbour that is
// cut where two passes meet, and its piece lies over the other one of the faces.
TEST(OwnerBorders, KeepPiecesOfChordsWithinTheTolerance) {
  constexpr int kSides = 60, kPasses = 5;
  const auto rounded = [](double x) { return std::round(1000 * x) / 1000; };
  std::vector<Vec3> places;
  for (int k = 0; k < kPasses * (kSides + 1); ++k) {
    const double turn = kTwoPi * (k % (kSides + 1)) / kSides;
    const double r = 28.26835 * (1 + 0.2 * sincos(3 * turn + 31).sin + 0.1 * sincos(7 * turn).cos);
    const auto [sin, cos] = sincos(turn);
    places.push_back({rounded(699.23445 + r * cos), rounded(752.73065 + r * sin),
                      -5.06 * (1 + k / (kSides + 1))});
  }
  const StockShape sheet = box_stock({0, 0, -25}, {800, 1200, 0});
  const Tool tool = endmill(8);
  const PartField field{StockSolid(sheet), SweepTable(path(places), std::span(&tool, 1))};
  MeshPlan plan;
  plan.tolerance = 0.204;
  MeshReport report;
  mesh_part(field, 2.5, plan, &report);
  EXPECT_EQ(report.unresolved, 0u);
  EXPECT_LE(report.bound, plan.tolerance);  // it was 0.443
}

}  // namespace
}  // namespace mrsim
