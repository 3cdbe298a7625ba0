// What only an independent library should judge: self-intersections, and the distance of the exact
// part from the mesh.
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "mesh/mesh_part.h"
#include "mesh/solid/self_intersection.h"
#include "support/analytic_field.h"
#include "support/cgal_mesh.h"
#include "support/cgal_surface.h"
#include "support/rounds.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<SurfaceMesh>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

class MeshDistance {
 public:
  explicit MeshDistance(const TriMesh& mesh) : mesh_(to_cgal(mesh)) {
    tree_.insert(faces(mesh_).first, faces(mesh_).second, mesh_);
    tree_.accelerate_distance_queries();
  }
  double of(const Vec3& p) const {
    return std::sqrt(CGAL::to_double(tree_.squared_distance({p.x, p.y, p.z})));
  }

 private:
  SurfaceMesh mesh_;
  Tree tree_;
};

MeshPlan with_tolerance(double tolerance) {
  MeshPlan o;
  o.tolerance = tolerance;
  o.threads = 1;
  return o;
}

// Distance of (x, y) from PRIMER_2F's path.
double path_distance(Vec2 p) {
  double d = 1e9;
  for (const Cut& c :
       {flat_arc({27.5, -30}, 15, true, 2.5, 8), flat_arc({50, -30}, 7.5, false, 2.5, 8),
        flat_arc({72.5, -30}, 15, true, 2.5, 8)})
    d = std::min(d, c.path.distance(p).first);
  return d;
}

// Points of the slot's outline: circles about the arcs' centres and ends that lie 2.5 mm from the
// path.
std::vector<Vec2> slot_outline() {
  std::vector<Vec2> out;
  const struct {
    double x, y, r;
  } circles[] = {{27.5, -30, 17.5}, {27.5, -30, 12.5}, {50, -30, 10},    {50, -30, 5},
                 {72.5, -30, 17.5}, {72.5, -30, 12.5}, {12.5, -30, 2.5}, {87.5, -30, 2.5}};
  for (const auto& c : circles)
    for (int k = 0; k < 3600; ++k) {
      const SinCos a = sincos_deg(k / 10.0 + 0.03);
      const Vec2 p{c.x + c.r * a.cos, c.y + c.r * a.sin};
      if (std::abs(path_distance(p) - 2.5) < 1e-9) out.push_back(p);
    }
  return out;
}

double largest_edge_distance(const TriMesh& mesh) {
  const MeshDistance distance(mesh);
  double most = 0;
  for (const Vec2& p : slot_outline())
    for (const double z : {8.0, 10.0}) most = std::max(most, distance.of({p.x, p.y, z}));
  for (int k = 0; k <= 1000; ++k)
    for (const double y : {0.0, -60.0})
      for (const double z : {0.0, 10.0}) most = std::max(most, distance.of({k / 10.0, y, z}));
  for (int k = 0; k <= 600; ++k)
    for (const double x : {0.0, 100.0})
      for (const double z : {0.0, 10.0}) most = std::max(most, distance.of({x, -k / 10.0, z}));
  return most;
}

TEST(AdaptiveCgal, SharpEdgesAreKeptAtHalfAMillimetre) {
  EXPECT_LE(largest_edge_distance(mesh_part(primer_2f(), 0.5)), 0.036);
}

// A mesh and a copy of it, moved: the triangles that meet are those that CGAL finds, of all and of
// some.
TEST(AdaptiveCgal, TrianglesThatMeetAreFound) {
  TriMesh mesh = mesh_part(primer_2s(), 0.2, with_tolerance(0.05));
  constexpr float kSteps = 1 << 12;  // in a millimetre: coordinates on the lattice of vertices
  for (auto& v : mesh.vertices)
    for (float& x : v) x = std::round(x * kSteps) / kSteps;
  const auto vertices = static_cast<std::uint32_t>(mesh.vertices.size());
  const std::size_t triangles = mesh.triangles.size();
  for (std::uint32_t k = 0; k < vertices; ++k) {
    const auto& v = mesh.vertices[k];
    mesh.vertices.push_back({v[0] + 3.25F, v[1] + 1.5F, v[2] + 2.75F});
  }
  for (std::size_t k = 0; k < triangles; ++k) {
    const auto& t = mesh.triangles[k];
    mesh.triangles.push_back({t[0] + vertices, t[1] + vertices, t[2] + vertices});
  }
  using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;
  Pairs all, some;
  std::vector<char> chosen(mesh.triangles.size());
  for (std::size_t k = 0; k < chosen.size(); k += 7) chosen[k] = 1;
  for (const auto& [f, g] : meeting_faces(mesh)) {
    const std::pair<std::uint32_t, std::uint32_t> pair(std::min(f, g), std::max(f, g));
    all.insert(pair);
    if (chosen[pair.first] || chosen[pair.second]) some.insert(pair);
  }
  ASSERT_GT(some.size(), 20u);
  ASSERT_GT(all.size(), some.size());

  std::vector<Vec3> points;
  for (const auto& v : mesh.vertices) points.push_back({v[0], v[1], v[2]});
  const auto found = [&](std::span<const char> of) {
    Pairs out;
    for (const auto& [i, j] : detail::self_intersections(points, mesh.triangles, 2, of))
      EXPECT_TRUE(out.emplace(std::min(i, j), std::max(i, j)).second);
    return out;
  };
  EXPECT_EQ(found({}), all);
  EXPECT_EQ(found(chosen), some);
}

TEST(AdaptiveCgal, ExactPartIsWithinToleranceOfTheMesh) {
  for (const double tolerance : {0.05, 0.005, 0.0005}) {
    const TriMesh mesh = mesh_part(primer_2f(), 0.25, with_tolerance(tolerance));
    EXPECT_EQ(self_intersections(mesh), 0u);
    EXPECT_LE(largest_edge_distance(mesh), tolerance);
    const MeshDistance distance(mesh);
    double wall = 0, flat = 0;
    for (const Vec2& p : slot_outline())
      for (const double z : {8.3, 9.1, 9.7}) wall = std::max(wall, distance.of({p.x, p.y, z}));
    for (int i = 0; i < 200; ++i)
      for (int j = 0; j < 120; ++j) {
        const Vec2 p{0.5 * i + 0.21, -0.5 * j - 0.17};
        flat = std::max(flat, distance.of({p.x, p.y, path_distance(p) < 2.5 ? 8.0 : 10.0}));
      }
    EXPECT_LE(wall, tolerance);
    EXPECT_LE(flat, tolerance);
  }
}

TEST(AdaptiveCgal, TurnedPartIsWithinToleranceOfTheMesh) {
  const AnalyticField part = primer_2s();
  const TriMesh mesh = mesh_part(part, 0.2, with_tolerance(0.01));
  EXPECT_EQ(self_intersections(mesh), 0u);
  const MeshDistance distance(mesh);
  std::vector<Vec2> profile;  // radius, z
  for (int k = 0; k <= 90; k += 3) {
    const SinCos a = sincos_deg(k);
    profile.push_back({10 + 5 * a.sin, 45 + 5 * a.cos});
    profile.push_back({21 - 6 * a.cos, 31 - 6 * a.sin});
  }
  for (int k = 0; k <= 20; ++k) {
    profile.push_back({0.5 * k, 50});
    profile.push_back({15, 31 + 0.7 * k});
    profile.push_back({21 + 0.2 * k, 25});
    profile.push_back({25, 1.25 * k});
    profile.push_back({1.25 * k, 0});
  }
  double most = 0;
  for (int k = 0; k < 720; ++k) {
    const SinCos a = sincos_deg(0.5 * k);
    for (const Vec2& p : profile)
      most = std::max(most, distance.of({p.x * a.cos, p.x * a.sin, p.y}));
  }
  EXPECT_LE(most, 0.01);
}

// Blocks with slots of all sorts, as a fixed generator gives them: thin walls, shallow meetings,
// floors below the bottom, cuts that touch.
AnalyticField random_part(std::uint64_t seed) {
  std::uint64_t state = seed * 0x9e3779b97f4a7c15u + 1;
  const auto uniform = [&](double a, double b) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return a + (b - a) * static_cast<double>(state >> 33) / 2147483648.0;
  };
  std::vector<Cut> cuts;
  const int count = 3 + static_cast<int>(uniform(0, 12));
  for (int k = 0; k < count; ++k) {
    const Vec2 a{uniform(-3, 33), uniform(-3, 23)}, b{uniform(-3, 33), uniform(-3, 23)};
    const double r = uniform(0.4, 4), kind = uniform(0, 3);
    if (kind < 1)
      cuts.push_back(flat_line(a, b, r, uniform(-1, 10)));
    else if (kind < 2)
      cuts.push_back(ball_line(a, b, r, uniform(0, 10)));
    else
      cuts.push_back(flat_arc(a, uniform(2, 10), uniform(0, 1) < 0.5, r, uniform(0, 10)));
  }
  return {{{0, 0, 0}, {30, 20, 10}}, false, std::move(cuts)};
}

void expect_sound(const AnalyticField& part, double voxel, double tolerance, std::uint64_t seed) {
  testing::expect_sound(part, mesh_part(part, voxel, with_tolerance(tolerance)), seed);
}

TEST(AdaptiveCgal, RandomPartsAreSoundAtTheVoxel) {
  for (std::uint64_t seed = 0; seed < rounds(100); ++seed)
    expect_sound(random_part(seed), 1, 0, seed);
}

// Several tiles of the uniform grid, with split cells at their borders.
TEST(AdaptiveCgal, RandomPartsAreSoundAcrossTiles) {
  for (std::uint64_t seed = 100; seed < 100 + rounds(30); ++seed)
    expect_sound(random_part(seed), 0.35, 0, seed);
}

TEST(AdaptiveCgal, RandomPartsAreSoundWithinTolerance) {
  for (std::uint64_t seed = 0; seed < rounds(12); ++seed)
    expect_sound(random_part(seed), 1, 0.1, seed);
}

}  // namespace
}  // namespace mrsim
