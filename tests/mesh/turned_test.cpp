// Parts that are the same at every angle: the outline and its mesh, on closed forms and on random
// programs.
#include "core/numbers/triangle_tree.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "mesh/mesh_part.h"
#include "mesh/solid/check.h"
#include "mesh/solid/half_edges.h"
#include "mesh/turned/turned_chords.h"
#include "mesh/turned/turned_mesh.h"
#include "removal/part/part_field.h"
#include "support/cgal_mesh.h"
#include "support/field_distance.h"
#include "support/moves.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/tools.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using testing::insert;
using testing::line;

StockShape bar(double radius, double z0, double z1, double bore = 0) {
  return testing::round_stock(radius, bore, z0, z1);
}

PartField cut(const StockShape& stock, const std::vector<Motion>& motions, const Tool& tool) {
  return {StockSolid(stock), SweepTable(motions, std::span(&tool, 1))};
}

MeshPlan within(double tolerance, int threads = 1) {
  MeshPlan options;
  options.tolerance = tolerance;
  options.threads = threads;
  return options;
}

Motion arc_about_y(Vec3 start, Vec3 center, double sweep) {
  return testing::arc(start, center, {0, 1, 0}, sweep);
}

std::vector<Motion> random_moves(std::mt19937& random) {
  const auto number = [&](double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random);
  };
  std::vector<Motion> moves;
  Vec3 at{number(6, 16), 0, number(4, 22)};
  for (int k = 0; k < 5; ++k) {
    if (k % 3 == 2) {
      const double radius = number(1, 5), angle = number(-3, 3);
      const SinCos t = sincos(angle);
      moves.push_back(
          arc_about_y(at, at - radius * Vec3{t.cos, 0, t.sin}, number(0.3, 3) * (k % 2 ? 1 : -1)));
    } else {
      moves.push_back(line(at, {number(5, 16), 0, number(2, 23)}));
    }
    at = moves.back().end;
  }
  return moves;
}

// How far the exact part lies from the mesh, by points of its outline at many angles.
double farthest_of_part(const PartField& field, const TriMesh& mesh, double voxel) {
  const TriangleTree tree(mesh);
  double most = 0;
  for (const detail::Outline& line : detail::turned_section(field, voxel, 1e-5, 1e-3, 1).outlines)
    for (std::size_t k = 0; k < line.points.size(); k += 3)
      for (const double angle : {0.01, 0.5, 1.234, 3.0, 4.4, 6.2}) {
        const SinCos t = sincos(angle);
        const Vec3& p = line.points[k].at;
        most = std::max(most, std::sqrt(tree.nearest({p.x * t.cos, p.x * t.sin, p.z}).distance2));
      }
  return most;
}

// No cells in space were needed.
bool is_turned_outline(const MeshReport& report) {
  return std::none_of(report.seconds.begin(), report.seconds.end(),
                      [](const auto& step) { return step.first == "tree"; });
}

TEST(Turned, BoundHoldsBothWaysOnRandomParts) {
  std::mt19937 random(testing::salted(5));
  const char* shapes[] = {"V", "C", "R", "D"};
  for (int round = 0; round < 24; ++round) {
    const double tolerance = round % 3 == 0 ? 0.05 : round % 3 == 1 ? 0.01 : 0.002;
    const PartField field =
        cut(bar(15, 0, 24, round % 5 == 0 ? 4 : 0), random_moves(random),
            insert(shapes[round % 4], round % 4 == 2 ? 2 : 0.4 * (round % 2), 0, 12));
    MeshReport report;
    const TriMesh mesh = mesh_part(field, 0.25, within(tolerance), &report);
    const std::string what = "round " + std::to_string(round);
    EXPECT_TRUE(is_turned_outline(report)) << what;
    EXPECT_LE(report.bound, tolerance) << what;
    EXPECT_EQ(report.sampled, 0u) << what;
    EXPECT_LE(testing::largest_distance(field, mesh), report.bound) << what;
    if (report.thin.empty()) {
      EXPECT_LE(farthest_of_part(field, mesh, 0.25), report.bound) << what;
    }
    EXPECT_NO_THROW(require_solid(mesh, what));
    EXPECT_EQ(testing::self_intersections(mesh), 0u) << what;
  }
}

TEST(Turned, BytesAreTheSameForAnyNumberOfThreads) {
  std::mt19937 random(testing::salted(9));
  const PartField field = cut(bar(15, 0, 24), random_moves(random), insert("D", 0.8, 0, 12));
  const TriMesh one = mesh_part(field, 0.25, within(0.01, 1)),
                seven = mesh_part(field, 0.25, within(0.01, 7));
  EXPECT_EQ(one.vertices, seven.vertices);
  EXPECT_EQ(one.triangles, seven.triangles);
  EXPECT_EQ(one.owners, seven.owners);
}

// Diameters along X and Y are those of the part; steps stay sharp; a face or a cylinder is one
// strip.
TEST(Turned, ShoulderIsAsSharpAndAsLargeAsThePart) {
  const PartField field =
      cut(bar(20, 0, 50), {line({12, 0, 60}, {12, 0, 30}), line({12, 0, 30}, {30, 0, 30})},
          insert("", 0, 0, 12));
  MeshReport report;
  const TriMesh mesh = mesh_part(field, 0.5, within(0.01), &report);
  std::array<float, 3> lo = mesh.vertices[0], hi = lo;
  std::size_t at_step = 0;
  for (const auto& v : mesh.vertices) {
    for (std::size_t a = 0; a < 3; ++a)
      lo[a] = std::min(lo[a], v[a]), hi[a] = std::max(hi[a], v[a]);
    const double radius = std::hypot(v[0], v[1]);
    EXPECT_TRUE(radius < 1e-6 || std::abs(radius - 12) < 4e-6 || std::abs(radius - 20) < 4e-6);
    at_step += std::abs(radius - 12) < 4e-6 && v[2] == 30;
  }
  EXPECT_EQ(lo, (std::array<float, 3>{-20, -20, 0}));
  EXPECT_EQ(hi, (std::array<float, 3>{20, 20, 50}));
  EXPECT_GT(at_step, 20u);
  EXPECT_EQ(mesh.vertices.size(), 2 + 4 * at_step);  // two poles, four rings
  EXPECT_NEAR(signed_volume(mesh) - report.volume_excess, kPi * (400 * 30 + 144 * 20), 1e-6);
}

// What the surface is told of: the move that made each face.
TEST(Turned, OwnersAreThoseOfTheCuts) {
  const PartField field =
      cut(bar(20, 0, 50), {line({12, 0, 60}, {12, 0, 30}), line({12, 0, 30}, {30, 0, 30})},
          insert("", 0, 0, 12));
  const TriMesh mesh = mesh_part(field, 0.5, within(0.01));
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto& t = mesh.triangles[k];
    const Vec3 middle = (1.0 / 3) * (to_vec(mesh.vertices[t[0]]) + to_vec(mesh.vertices[t[1]]) +
                                     to_vec(mesh.vertices[t[2]]));
    const double radius = std::hypot(middle.x, middle.y);
    const bool is_stock = (radius > 12.5 && middle.z < 29) || middle.z < 1 || middle.z > 49;
    EXPECT_EQ(mesh.owners[k] == kStockOwner, is_stock) << radius << ' ' << middle.z;
  }
}

// A wall of a twelfth of the voxel, between two grooves.
TEST(Turned, ThinWallsAreDrawnNotReported) {
  Tool tool = insert("", 0, 0, 12);
  tool.type = ToolType::grooving;
  tool.width = 2;
  const PartField field = cut(
      bar(20, 0, 50), {line({25, 0, 30}, {15, 0, 30}), line({25, 0, 32.04}, {15, 0, 32.04})}, tool);
  MeshReport report;
  const TriMesh mesh = mesh_part(field, 0.5, within(0.01), &report);
  EXPECT_TRUE(is_turned_outline(report));
  EXPECT_TRUE(report.thin.empty());
  EXPECT_NEAR(signed_volume(mesh) - report.volume_excess, kPi * (400 * 50 - 2 * 2 * (400 - 225)),
              1e-6);
  EXPECT_LE(farthest_of_part(field, mesh, 0.5), report.bound);
}

// Chords of an arc are alike, and no fewer would do.
TEST(Turned, ChordsOfAnArcAreEven) {
  const PartField field =
      cut(bar(20, 0, 50), {arc_about_y({10, 0, 50}, {10, 0, 40}, kPi / 2)}, insert("", 0, 0, 12));
  const detail::TurnedSection section = detail::turned_section(field, 0.5, 1e-4, 1e-3, 1);
  ASSERT_EQ(section.outlines.size(), 1u);
  const detail::Outline line =
      detail::even_chords(detail::straightened(section.outlines[0]), {0.01, 1e-3, 0.25});
  std::vector<double> sizes;
  for (std::size_t k = 0; k + 1 < line.points.size(); ++k)
    if (line.points[k].face.owner == 0)
      sizes.push_back(distance(line.points[k].at, line.points[k + 1].at));
  std::sort(sizes.begin(), sizes.end());
  // The sagitta of 0.01 mm on a radius of 10 mm.
  const double longest = 2 * std::sqrt(2 * 10 * 0.01);
  EXPECT_EQ(sizes.size(), static_cast<std::size_t>(std::ceil(kPi / 2 * 10 / longest)));
  EXPECT_LT(sizes.back(), 1.1 * sizes[1]);
}

}  // namespace
}  // namespace mrsim
