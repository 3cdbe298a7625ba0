#include "mesh/mesh_part.h"
#include "mesh/solid/check.h"
#include "mesh/solid/half_edges.h"
#include "support/analytic_field.h"
#include "support/mesh_asserts.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

// Largest |d| over samples of every triangle, n to a side.
double largest_mesh_error(const ExactField& field, const TriMesh& mesh, int n) {
  const Candidates all = field.all();
  double most = 0;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) {
        const double x = double(i) / n, y = double(j) / n;
        const Vec3 p = (1 - x - y) * to_vec(mesh.vertices[t[0]]) + x * to_vec(mesh.vertices[t[1]]) +
                       y * to_vec(mesh.vertices[t[2]]);
        most = std::max(most, std::abs(field.sample(p, all).distance));
      }
  return most;
}

void expect_solid(const TriMesh& mesh) {
  const MeshSummary s = check_mesh(mesh);
  EXPECT_TRUE(s.closed && s.oriented && s.manifold) << s.first_fault;
  EXPECT_EQ(s.degenerate, 0u);
  EXPECT_EQ(mesh.owners.size(), mesh.triangles.size());
}

MeshPlan with_tolerance(double tolerance, int threads = 1) {
  MeshPlan o;
  o.tolerance = tolerance;
  o.threads = threads;
  return o;
}

bool same_bytes(const TriMesh& a, const TriMesh& b) {
  return a.triangles == b.triangles && a.owners == b.owners &&
         a.vertices.size() == b.vertices.size() &&
         std::memcmp(a.vertices.data(), b.vertices.data(),
                     a.vertices.size() * sizeof(a.vertices[0])) == 0;
}

TEST(MeshPart, BoxIsExactWithTwelveTriangles) {
  const AnalyticField box({{0, 0, 0}, {20, 15, 10}}, false, {});
  const TriMesh uniform = mesh_part(box, 1);
  expect_solid(uniform);
  EXPECT_NEAR(check_mesh(uniform).volume, 3000, 1e-6);
  const TriMesh small = mesh_part(box, 1, with_tolerance(0.01));
  expect_solid(small);
  EXPECT_NEAR(check_mesh(small).volume, 3000, 1e-6);
  EXPECT_EQ(small.triangles.size(), 12u);
}

TEST(MeshPart, VerticesAreExactAtAnyVoxel) {
  const AnalyticField part = primer_2f();
  for (const double voxel : {1.0, 0.5, 0.25}) {
    const TriMesh mesh = mesh_part(part, voxel);
    expect_solid(mesh);
    EXPECT_LE(largest_vertex_error(part, mesh), 2e-5) << voxel;
  }
}

TEST(MeshPart, ErrorFallsWithTheSquareOfTheVoxel) {
  const AnalyticField part = primer_2f();
  double last = 0, last_volume = 0;
  for (const double voxel : {1.0, 0.5, 0.25}) {
    const TriMesh mesh = mesh_part(part, voxel);
    const double error = largest_mesh_error(part, mesh, 4);
    const double volume = std::abs(check_mesh(mesh).volume - kPrimer2fVolume);
    if (last > 0) {
      EXPECT_LE(error, last / 3) << voxel;
      EXPECT_LE(volume, last_volume / 3) << voxel;
    }
    last = error;
    last_volume = volume;
  }
}

TEST(MeshPart, ToleranceHoldsOnEverySampleOfTheMesh) {
  const AnalyticField part = primer_2f();
  for (const double tolerance : {0.05, 0.005, 0.0005}) {
    MeshReport report;
    const TriMesh mesh = mesh_part(part, 0.25, with_tolerance(tolerance), &report);
    expect_solid(mesh);
    EXPECT_LE(largest_mesh_error(part, mesh, 12), tolerance);
    EXPECT_LE(report.bound, tolerance);
    EXPECT_GE(report.bound, largest_mesh_error(part, mesh, 12));
    EXPECT_EQ(report.unresolved, 0u);
    EXPECT_LE(largest_vertex_error(part, mesh), 2e-5);
  }
}

TEST(MeshPart, Primer2fTakesFewTriangles) {
  const AnalyticField part = primer_2f();
  const TriMesh coarse = mesh_part(part, 0.25, with_tolerance(0.005));
  EXPECT_LE(coarse.triangles.size(), 4000u);
  EXPECT_NEAR(check_mesh(coarse).volume, kPrimer2fVolume, 0.5);
  EXPECT_LE(mesh_part(part, 0.25, with_tolerance(0.001)).triangles.size(), 10000u);
}

TEST(MeshPart, Primer2sTakesFewTriangles) {
  const AnalyticField part = primer_2s();
  const TriMesh mesh = mesh_part(part, 0.1, with_tolerance(0.005));
  expect_solid(mesh);
  EXPECT_LE(mesh.triangles.size(), 45000u);
  EXPECT_NEAR(check_mesh(mesh).volume, kPrimer2sVolume, 25);
  EXPECT_LE(largest_mesh_error(part, mesh, 6), 0.005);
}

// A ball of 3 mm along rows of moves that are shorter than the cells the tolerance asks for, on a
// wave of small steps; rows are `apart` mm apart. With cells of a voxel they would be 2600.
AnalyticField raster_of_short_moves(double apart) {
  std::vector<Cut> cuts;
  for (double y = 0; y <= 8; y += apart)
    for (double x = 0; x < 8; x += 0.3)
      cuts.push_back(ball_line({x, y}, {x + 0.3, y}, 3, 8 + std::sin(x / 4) * std::cos(y / 5)));
  return AnalyticField({{0, 0, 0}, {8, 8, 10}}, false, std::move(cuts));
}

TEST(MeshPart, ShortMovesTakeFewCells) {
  for (const double apart : {1.0, 0.3}) {
    const AnalyticField part = raster_of_short_moves(apart);
    MeshReport report;
    const TriMesh mesh = mesh_part(part, 0.25, with_tolerance(0.02, 2), &report);
    expect_solid(mesh);
    const double error = largest_mesh_error(part, mesh, 6);
    EXPECT_LE(error, 0.02) << apart;
    EXPECT_LE(error, report.bound) << apart;
    EXPECT_LE(report.bound, 0.02) << apart;
    EXPECT_LE(report.cells, 1300u) << apart;  // half of the voxels on the surface
    EXPECT_LE(largest_vertex_error(part, mesh), 2e-5) << apart;
    EXPECT_TRUE(same_bytes(mesh, mesh_part(part, 0.25, with_tolerance(0.02, 1)))) << apart;
  }
}

TEST(MeshPart, BytesAreTheSameForAnyNumberOfThreads) {
  const AnalyticField part = primer_2f();
  for (const double tolerance : {0.0, 0.01}) {
    const TriMesh one = mesh_part(part, 0.5, with_tolerance(tolerance, 1));
    for (const int threads : {2, 7})
      EXPECT_TRUE(same_bytes(one, mesh_part(part, 0.5, with_tolerance(tolerance, threads))))
          << tolerance << " " << threads;
  }
}

TEST(MeshPart, OwnersAreThoseOfTheExactPart) {
  const AnalyticField part = primer_2f();
  const TriMesh mesh = mesh_part(part, 0.5);
  const Candidates all = part.all();
  std::size_t wrong = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& x = mesh.triangles[t];
    const Vec3 p = (1.0 / 3) * (to_vec(mesh.vertices[x[0]]) + to_vec(mesh.vertices[x[1]]) +
                                to_vec(mesh.vertices[x[2]]));
    wrong += part.sample(p, all).owner != mesh.owners[t];
  }
  EXPECT_LE(wrong, mesh.triangles.size() / 500);  // where owners change on one smooth surface
}

TEST(MeshPart, ThinWallsAndGapsAreReported) {
  // Two slots with 0.12 mm between them, and a slot that leaves 0.1 mm beside the stock's side.
  const AnalyticField wall(
      {{0, 0, 0}, {30, 20, 10}}, false,
      {flat_line({5, 6}, {25, 6}, 2, 5), flat_line({5, 10.12}, {25, 10.12}, 2, 5)});
  MeshReport report;
  mesh_part(wall, 0.5, {}, &report);
  bool found = false;
  for (const ThinFeature& f : report.thin)
    found = found || (f.wall && f.owner[0] == 0 && f.owner[1] == 1 &&
                      std::abs(f.thickness - 0.12) < 1e-3 && std::abs(f.place.y - 8.06) < 0.1);
  EXPECT_TRUE(found);
  MeshReport none;
  mesh_part(primer_2f(), 0.5, {}, &none);
  EXPECT_TRUE(none.thin.empty());
}

// A wall of 0.15 voxels between two slots, everywhere in the voxels of a row that is longer than a
// A wall of 0.15 voxels between two slots, in every voxel of a row that is longer than a tile: in
// its first and last planes too, and wherever it lies in a node that shares a list.
TEST(MeshPart, ThinWallsAreKeptOrReportedWhereverTheyLieInATile) {
  constexpr double kVoxel = 0.5, kHalf = 0.075 * kVoxel, kRadius = 1.5;
  for (const int axis : {0, 1})
    for (int voxel = 8; voxel < 74; ++voxel)
      for (const double share : {0.05, 0.3, 0.55, 0.8}) {
        const double at = (voxel + share) * kVoxel;
        const auto on_axis = [&](double along, double across) {
          return axis == 0 ? Vec2{along, across} : Vec2{across, along};
        };
        const auto slot = [&](double side) {
          const double along = at + side * (kRadius + kHalf);
          return flat_line(on_axis(along, 1), on_axis(along, 5), kRadius, 1);
        };
        const Vec2 size = on_axis(40, 6);
        const AnalyticField part({{0, 0, 0}, {size.x, size.y, 3}}, false, {slot(-1), slot(1)});
        MeshReport report;
        const TriMesh mesh = mesh_part(part, kVoxel, {}, &report);
        const bool is_kept =  // a plane of the grid lies in it
            std::any_of(mesh.vertices.begin(), mesh.vertices.end(), [&](const auto& v) {
              return std::abs(component(to_vec(v), axis) - at) < 2 * kHalf && v[2] > 1.5 &&
                     v[2] < 2.5;
            });
        // The first edge of each pair of owners is told, where the slots' round ends may be.
        const auto is_wall = [&](const ThinFeature& f) {
          return f.wall && f.owner[0] == 0 && f.owner[1] == 1 && f.thickness < kVoxel &&
                 std::abs(component(f.place, axis) - at) < kVoxel / 2;
        };
        EXPECT_TRUE(is_kept || std::any_of(report.thin.begin(), report.thin.end(), is_wall))
            << "axis " << axis << ", voxel " << voxel + share;
      }
}

TEST(MeshPart, RefusesWhatItCanNotMesh) {
  const AnalyticField part = primer_2f();
  EXPECT_EQ(error_code([&] { mesh_part(part, 0); }), "voxel-invalid");
  EXPECT_EQ(error_code([&] { mesh_part(part, 1e-9); }), "voxel-invalid");
  EXPECT_EQ(error_code([&] { mesh_part(part, 1, with_tolerance(-1)); }), "tolerance-invalid");
  const AnalyticField nothing({{0, 0, 0}, {5, 5, 5}}, false, {{Cut::Kind::half, {}, 0, -1, 0}});
  EXPECT_EQ(error_code([&] { mesh_part(nothing, 1); }), "part-empty");
  // A floor of 0.1 mm between two planes of the lattice is not nothing.
  const AnalyticField floor({{0, 0, -10}, {50, 50, 0}}, false,
                            {flat_line({-20, 25}, {70, 25}, 75, -9.9)});
  for (const double tolerance : {0.0, 0.01})
    EXPECT_EQ(error_code([&] { mesh_part(floor, 0.25, with_tolerance(tolerance)); }), "part-thin");
  // Nor is a stock that is smaller than the voxels.
  for (const double voxel : {50.0, 100.0, 1000.0, 1e6})
    EXPECT_EQ(error_code([&] { mesh_part(part, voxel); }), "part-thin") << voxel;
}

}  // namespace
}  // namespace mrsim
