// Turning against exact plane geometry: in the half plane (X, Z) an insert is a polygon thickened
// by its nose radius, and what it sweeps a union of polygons, bars and swept arcs (ExactRegion).
// The part's volume follows by Pappus; membership of a point is that of (radius, Z) in the region.
#include "core/numbers/units.h"
#include "interp/interpreter.h"
#include "mesh/mesh_part.h"
#include "mesh/solid/check.h"
#include "oracle/exact_region.h"
#include "removal/part/part_field.h"
#include "removal/tool/tool.h"
#include "support/collecting_sink.h"
#include "support/random.h"
#include "support/rounds.h"
#include "support/shapes.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

struct Turned {
  double radius = 0, z0 = 0, z1 = 0;  // the bar
  std::vector<Tool> tools;
  std::vector<Motion> motions;
};

Vec2 half_plane(const Vec3& p) { return {p.x, p.z}; }

// A convex polygon moved along a segment is itself at the start, and its sides moved along it.
void add_line(ExactRegion& region, const InsertOutline& o, Vec2 from, Vec2 to) {
  const Vec2 way = to - from;
  std::vector<Vec2> at;
  for (const Vec2 v : o.core) at.push_back(from + v);
  region.add_polygon(at);
  for (std::size_t k = 0; k < at.size(); ++k) {
    const Vec2 a = at[k], b = at[(k + 1) % at.size()];
    const Vec2 corners[] = {a, b, b + way, a + way};
    if (std::fabs(cross(b - a, way)) > 1e-9) region.add_polygon(corners);
    region.add_bar(a, b, o.round);
    region.add_bar(a + way, b + way, o.round);
    region.add_bar(a, a + way, o.round);
  }
}

// The same along an arc; a thick side is a rectangle with round ends, of which two sides count.
void add_arc(ExactRegion& region, const InsertOutline& o, Vec2 center, Vec2 from, double sweep) {
  const Vec2 arm = from - center;
  const double radius = length(arm), begin = std::atan2(arm.y, arm.x);
  const auto place = [&](double angle) {
    return center + radius * Vec2{std::cos(angle), std::sin(angle)};
  };
  const std::size_t n = o.core.size();
  for (const Vec2 start : {place(begin), place(begin + sweep)}) {
    std::vector<Vec2> at;
    for (const Vec2 v : o.core) at.push_back(start + v);
    region.add_polygon(at);
    for (std::size_t k = 0; k < n; ++k) region.add_bar(at[k], at[(k + 1) % n], o.round);
  }
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 a = center + o.core[k], b = center + o.core[(k + 1) % n];
    region.add_arc(a, radius, begin, sweep, o.round);
    if (n < 2) continue;
    const Vec2 side = b - a;
    const Vec2 out = o.round / length(side) * Vec2{side.y, -side.x};
    region.add_drawn_segment(a, b, radius, begin, sweep);
    if (o.round > 0) region.add_drawn_segment(a + out, b + out, radius, begin, sweep);
    if (o.round > 0) region.add_drawn_segment(a - out, b - out, radius, begin, sweep);
  }
}

ExactRegion region_of(const Turned& part) {
  ExactRegion all;
  for (const Motion& m : part.motions) {
    if (m.kind == MotionKind::rapid || m.assumed_start) continue;
    const InsertOutline o = make_insert(part.tools[static_cast<std::size_t>(m.tool)]);
    // About +Y, counter-clockwise leads from Z to X.
    if (m.kind == MotionKind::arc)
      add_arc(all, o, half_plane(m.center), half_plane(m.start), m.axis.y > 0 ? -m.sweep : m.sweep);
    else
      add_line(all, o, half_plane(m.start), half_plane(m.end));
  }
  if (all.crosses_axis()) all.add_mirrored();  // what reaches beyond the axis cuts there, too
  return all;
}

PartField field_of(const Turned& part) {
  return {StockSolid(testing::round_stock(part.radius, 0, part.z0, part.z1)),
          SweepTable(part.motions, part.tools)};
}

void expect_membership(const Turned& part, const ExactRegion& region, const PartField& field,
                       int points, std::uint64_t seed) {
  Random r(seed);
  const Candidates all = field.all();
  for (int k = 0; k < points; ++k) {
    const double radius = r(0, part.radius), angle = r(0, kTwoPi), z = r(part.z0, part.z1);
    const double d =
        field.sample({radius * std::cos(angle), radius * std::sin(angle), z}, all).distance;
    if (std::fabs(d) < 1e-9) continue;
    const bool out = region.contains({radius, z});
    ASSERT_EQ(d > 0, out) << "seed " << seed << ": radius " << radius << ", Z " << z
                          << ", d = " << d;
  }
}

// Right to second order in the tolerance T. Around the axis, T^2 for each millimetre of an edge,
// and T^2 / 2 times the sum of the curvatures for the faces: 1/radius about the axis, and that of
// the outline's arcs.
void expect_volume(const Turned& part, const ExactRegion& region, const PartField& field,
                   double voxel, double tolerance, const std::string& name, MeshReport& found) {
  MeshPlan options;
  options.tolerance = tolerance;
  const TriMesh mesh = mesh_part(field, voxel, options, &found);
  if (!found.thin.empty()) return;
  const double got = signed_volume(mesh) - found.volume_excess;
  const ExactRegion::Measure removed = region.within({0, part.z0}, {part.radius, part.z1});
  const double exact =
      kPi * part.radius * part.radius * (part.z1 - part.z0) - kTwoPi * removed.moment;
  const double outline = removed.outline + part.radius + part.z1 - part.z0;
  const double bound = tolerance * tolerance * kPi *
                       (outline + part.radius * (removed.turns + 2 * (removed.pieces + 2)));
  EXPECT_NEAR(got, exact, bound) << name;
}

Tool random_tool(Random& r, int kind) {
  Tool tool;
  tool.type = ToolType::turning;
  tool.edge_length = r(3, 6);
  tool.nose_radius = kind == 1 ? 0 : 0.2 * (1 + r.pick(4));
  tool.insert = std::string(1, "VDCSTR"[r.pick(6)]);
  if (tool.insert == "R") tool.diameter = 2 * tool.nose_radius + (kind == 1 ? 3 : 0);
  tool.left_hand = r.pick(4) == 0;
  if (kind == 2) {
    tool.type = ToolType::grooving;
    tool.width = r(2, 4);
  }
  return tool;
}

Turned random_part(std::uint64_t seed) {
  Random r(seed);
  Turned part{20, 0, 30, {random_tool(r, static_cast<int>(seed % 4))}, {}};
  const bool whole = seed % 2 == 0;
  const auto number = [&](double lo, double hi) {
    return whole ? std::round(2 * r(lo, hi)) / 2 : r(lo, hi);
  };
  Vec3 at{number(8, 22), 0, number(5, 30)};
  const int count = 2 + r.pick(6);
  for (int k = 0; k < count; ++k) {
    Motion m;
    m.kind = MotionKind::line;
    m.tool = 0;
    m.start = at;
    m.end = {r.pick(3) == 0 ? at.x : number(6, 22), 0, r.pick(3) == 0 ? at.z : number(2, 31)};
    if (r.pick(2) == 0) {
      m.kind = MotionKind::arc;
      m.axis = {0, 1, 0};
      m.radius = number(1, 6);
      const double begin = whole ? r.pick(4) * kPi / 2 : r(-kPi, kPi);
      m.sweep = (r.pick(2) ? 1 : -1) * (whole ? (1 + r.pick(3)) * kPi / 2 : r(0.1, 4));
      m.center = at - m.radius * Vec3{std::cos(begin), 0, std::sin(begin)};
      const double end = begin - m.sweep;
      m.end = m.center + m.radius * Vec3{std::cos(end), 0, std::sin(end)};
    }
    if (m.end == m.start) continue;
    part.motions.push_back(m);
    at = m.end;
    if (r.pick(3) == 0) at = {number(8, 22), 0, number(5, 30)};
  }
  return part;
}

TEST(TurningOracle, PointsOfRandomProgramsAreWhereTheUnionSays) {
  for (std::uint64_t seed = 1; seed <= rounds(60); ++seed) {
    const Turned part = random_part(seed);
    expect_membership(part, region_of(part), field_of(part), 1000, seed);
    if (HasFatalFailure()) return;
  }
}

// Knives, needles and notches included: what the mesh does not hold is reported.
TEST(TurningOracle, VolumeOfRandomPartsIsThatOfPappus) {
  int compared = 0;
  for (std::uint64_t seed = 61; seed <= 100; ++seed) {
    const Turned part = random_part(seed);
    MeshReport found;
    expect_volume(part, region_of(part), field_of(part), 0.4, 0.01, std::to_string(seed), found);
    compared += found.thin.empty();
  }
  EXPECT_GE(compared, 36);
}

// A contour as it is finished: towards the chuck and outwards, in cylinders, cones and quarter
// circles of both kinds. Rings as sharp as knives, as the programs above leave them, are left to
// those.
Turned contour_part(std::uint64_t seed) {
  Random r(seed);
  Turned part{12, 0, 20, {random_tool(r, static_cast<int>(seed % 2))}, {}};
  part.tools[0].left_hand = false;
  part.tools[0].edge_length = 16;
  const auto half = [&](double lo, double hi) { return std::round(2 * r(lo, hi)) / 2; };
  Vec3 at{half(3, 6), 0, 21};
  while (at.z > 4 && at.x < 10) {
    Motion m;
    m.tool = 0;
    m.start = at;
    const int kind = r.pick(4);
    if (kind < 2) {
      m.kind = MotionKind::line;
      m.end = at + Vec3{kind == 0 ? 0 : r(0.3, 2), 0, -half(1, 4)};
    } else {
      m.kind = MotionKind::arc;
      m.axis = {0, 1, 0};
      m.radius = half(1, 2.5);
      m.center = at + (kind == 2 ? Vec3{0, 0, -m.radius} : Vec3{m.radius, 0, 0});
      m.sweep = kind == 2 ? kPi / 2 : -kPi / 2;
      m.end = at + Vec3{m.radius, 0, -m.radius};
    }
    part.motions.push_back(m);
    at = m.end;
  }
  return part;
}

TEST(TurningOracle, VolumeOfContoursIsThatOfPappus) {
  unsigned compared = 0;
  for (std::uint64_t seed = 1; seed <= rounds(8); ++seed) {
    const Turned part = contour_part(seed);
    MeshReport found;
    expect_volume(part, region_of(part), field_of(part), 0.4, 0.01, std::to_string(seed), found);
    compared += found.thin.empty();
  }
  EXPECT_GE(compared, rounds(6));
}

TEST(TurningOracle, PrimerIsWhatItsInsertSweeps) {
  testing::CollectingSink collector;
  const Program program = interpret(MRSIM_DATA_DIR "/PRIMER_2S.MPF", {}, collector);
  const Turned part{25, 0, 51, program.tools, collector.motions};
  const ExactRegion region = region_of(part);
  const PartField field = field_of(part);
  expect_membership(part, region, field, 5000, 1);
  MeshReport found;
  expect_volume(part, region, field, 0.25, 0.01, "PRIMER_2S", found);
  EXPECT_TRUE(found.thin.empty());
  // The closed form of data/SOURCES.md: the oracle, too, is right.
  const double left = kPi * 625 * 51 - kTwoPi * region.within({0, 0}, {25, 51}).moment;
  EXPECT_NEAR(
      left, kPi * (625 * 25 + (2790 - 378 * kPi) + 225 * 14 + (500 + 125 * kPi + 250.0 / 3)), 1e-6);
}

}  // namespace
}  // namespace mrsim
