// Horizontal moves of flat mills against exact plane geometry: at height z the removed region is
// the union of the stadiums and swept arcs of all moves at or below z (ExactRegion), so the volume
// is a sum of areas times depths, and membership of a point is that of a point in a polygon.
#include "core/numbers/units.h"
#include "interp/interpreter.h"
#include "mesh/mesh_part.h"
#include "mesh/solid/check.h"
#include "oracle/exact_region.h"
#include "removal/part/part_field.h"
#include "support/collecting_sink.h"
#include "support/random.h"
#include "support/rounds.h"
#include "support/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

Vec2 plan(const Vec3& p) { return {p.x, p.y}; }

struct Milled {
  Box3 stock;
  std::vector<Tool> tools;
  std::vector<Motion> motions;
};

// The region removed at each level and above it, up to the next.
std::map<double, ExactRegion> levels_of(const Milled& part) {
  const auto level = [](const Motion& m) { return std::min(m.start.z, m.end.z); };
  const auto add = [&](ExactRegion& region, const Motion& m) {
    const double r = part.tools[static_cast<std::size_t>(m.tool)].diameter / 2;
    if (m.kind != MotionKind::arc) return region.add_bar(plan(m.start), plan(m.end), r);
    const Vec2 from = plan(m.start) - plan(m.center);
    const double sweep = m.axis.z > 0 ? m.sweep : -m.sweep;
    region.add_arc(plan(m.center), length(from), std::atan2(from.y, from.x), sweep, r);
  };
  std::map<double, ExactRegion> levels;
  for (const Motion& m : part.motions)
    if (m.kind != MotionKind::rapid && level(m) < part.stock.hi.z) levels[level(m)];
  for (auto& [z, region] : levels) {
    std::set<std::array<double, 8>> seen;  // passes over one contour look the same in plan
    for (const Motion& m : part.motions)
      if (m.kind != MotionKind::rapid && level(m) <= z &&
          seen.insert({m.start.x, m.start.y, m.end.x, m.end.y, m.center.x, m.center.y, m.sweep,
                       part.tools[static_cast<std::size_t>(m.tool)].diameter})
              .second)
        add(region, m);
  }
  return levels;
}

struct Removed {
  double volume = 0;  // mm^3
  double edges = 0;   // mm: outlines of all steps; each is an edge at its top and one at its floor
};

Removed removed_by(const Milled& part, const std::map<double, ExactRegion>& levels) {
  Removed sum;
  double last = 0;
  for (auto it = levels.begin(); it != levels.end(); ++it) {
    const double from = std::max(it->first, part.stock.lo.z);
    const double to = std::next(it) == levels.end() ? part.stock.hi.z : std::next(it)->first;
    if (to <= from) continue;
    const ExactRegion::Measure found = it->second.within(plan(part.stock.lo), plan(part.stock.hi));
    sum.volume += found.area * (to - from);
    if (found.area > last + 1e-9) sum.edges += 2 * found.outline;
    last = found.area;
  }
  return sum;
}

PartField field_of(const Milled& part) {
  return {StockSolid(testing::box_stock(part.stock.lo, part.stock.hi)),
          SweepTable(part.motions, part.tools)};
}

// The volume that a run prints, of the mesh less what the mesh holds too much, against the
// oracle's. It is right to second order in the tolerance T: along an edge of the part the mesh's
// edge is a chord at most T from it, and a wall of radius r loses T / 2r of what lies between: T^2
// for each millimetre of edge, for walls no deeper than twice the radius of the tool, covers both.
void expect_volume(const Milled& part, const PartField& field,
                   const std::map<double, ExactRegion>& levels, double voxel, double tolerance,
                   const std::string& name, MeshReport& found) {
  MeshPlan options;
  options.tolerance = tolerance;
  const TriMesh mesh = mesh_part(field, voxel, options, &found);
  if (!found.thin.empty()) return;  // a wall below the voxel may be missing, and is reported
  const double got = signed_volume(mesh) - found.volume_excess;
  const Vec3 size = part.stock.hi - part.stock.lo;
  const Removed removed = removed_by(part, levels);
  const double exact = size.x * size.y * size.z - removed.volume;
  EXPECT_NEAR(got, exact, tolerance * tolerance * removed.edges) << name;
}

void expect_membership(const Milled& part, const std::map<double, ExactRegion>& levels,
                       const PartField& field, int points, std::uint64_t seed) {
  Random r(seed);
  const Candidates all = field.all();
  const Box3& b = part.stock;
  int removed = 0;
  for (int k = 0; k < points; ++k) {
    const Vec3 p{r(b.lo.x, b.hi.x), r(b.lo.y, b.hi.y), r(b.lo.z, b.hi.z)};
    const double d = field.sample(p, all).distance;
    if (std::fabs(d) < 1e-9) continue;
    auto level = levels.upper_bound(p.z);
    const bool out = level != levels.begin() && std::prev(level)->second.contains(plan(p));
    removed += out;
    ASSERT_EQ(d > 0, out) << "seed " << seed << ": (" << p.x << ", " << p.y << ", " << p.z
                          << "), d = " << d;
  }
  EXPECT_GT(removed, 0) << seed;
}

Milled random_part(std::uint64_t seed) {
  Random r(seed);
  Milled part;
  part.stock = {{0, 0, 0}, {30, 20, 8}};
  for (const double diameter : {6.0, r(1.5, 5)}) {
    part.tools.emplace_back();
    part.tools.back().diameter = diameter;
  }
  const bool whole = seed % 2 == 0;  // on a lattice of half millimetres, where moves touch
  const auto number = [&](double lo, double hi) {
    return whole ? std::round(2 * r(lo, hi)) / 2 : r(lo, hi);
  };
  Vec3 at{number(2, 28), number(2, 18), 5};
  const int count = 4 + r.pick(12);
  for (int k = 0; k < count; ++k) {
    Motion m;
    m.kind = MotionKind::line;
    m.tool = r.pick(2);
    m.start = m.end = at;
    const int kind = r.pick(8);
    if (kind == 0) {
      m.end.z = number(2, 7);  // plunge or retreat
    } else if (kind < 4) {
      m.kind = MotionKind::arc;
      m.radius = number(1, 7);
      const double begin = whole ? r.pick(4) * kPi / 2 : r(-kPi, kPi);
      m.sweep = (r.pick(2) ? 1 : -1) * (whole ? (1 + r.pick(4)) * kPi / 2 : r(0.1, 6.2));
      m.center = at - m.radius * Vec3{std::cos(begin), std::sin(begin), 0};
      const double end = begin + m.sweep;
      m.end = m.center + m.radius * Vec3{std::cos(end), std::sin(end), 0};
    } else {
      m.end = {number(0, 30), number(0, 20), at.z};
    }
    if (m.end == m.start && m.kind == MotionKind::line) continue;
    part.motions.push_back(m);
    if (r.pick(6) == 0) part.motions.push_back(m);  // twice the same
    at = m.end;
    if (r.pick(4) == 0) at.z = number(-1, 7);
  }
  return part;
}

TEST(MillingOracle, PointsOfRandomProgramsAreWhereTheUnionSays) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Milled part = random_part(seed);
    expect_membership(part, levels_of(part), field_of(part), 1000, seed);
    if (HasFatalFailure()) return;
  }
}

TEST(MillingOracle, VolumeOfRandomProgramsIsThatOfTheUnion) {
  unsigned compared = 0;
  for (std::uint64_t seed = 101; seed <= 100 + rounds(30); ++seed) {
    Milled part = random_part(seed);
    part.motions.resize(std::min<std::size_t>(part.motions.size(), 6));
    MeshReport found;
    expect_volume(part, field_of(part), levels_of(part), 0.25, 0.01, std::to_string(seed), found);
    compared += found.thin.empty();
  }
  EXPECT_GE(compared, rounds(20));
}

struct RealProgram {
  const char* name;
  double diameter;  // of the tool where the program does not describe it; 0: it does
  Box3 stock;
};

class RealPrograms : public ::testing::TestWithParam<RealProgram> {};

TEST_P(RealPrograms, VolumeAndPointsAreThoseOfTheUnion) {
  const auto& [name, diameter, stock] = GetParam();
  InterpOptions options;
  options.machine = MachineKind::mill;
  if (diameter > 0) {
    Tool tool;
    tool.diameter = diameter;
    options.table.tools.push_back(tool);
    tool.id = "1";
    options.table.tools.push_back(tool);
  }
  testing::CollectingSink collector;
  const Program program = interpret(std::string(MRSIM_DATA_DIR "/") + name, options, collector);
  Milled part{stock, program.tools, {}};
  for (const Motion& m : collector.motions)
    if (m.kind != MotionKind::rapid && !m.assumed_start) part.motions.push_back(m);
  for (const Motion& m : part.motions) {  // what this oracle can judge
    ASSERT_EQ(part.tools[static_cast<std::size_t>(m.tool)].type, ToolType::endmill);
    const Vec3 way = m.end - m.start;
    ASSERT_TRUE(way.z == 0 || (way.x == 0 && way.y == 0)) << m.line;
    ASSERT_TRUE(m.kind != MotionKind::arc || (m.rise == 0 && m.axis.z != 0)) << m.line;
  }
  const PartField field = field_of(part);
  const std::map<double, ExactRegion> levels = levels_of(part);
  expect_membership(part, levels, field, 5000, 1);
  MeshReport found;
  expect_volume(part, field, levels, 0.25, 0.01, name, found);
  EXPECT_TRUE(found.thin.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Data, RealPrograms,
    ::testing::Values(RealProgram{"PRIMER_2F.MPF", 0, {{0, -60, 0}, {100, 0, 10}}},
                      RealProgram{"FANUC_POCKET.NC", 10, {{-30, -30, -30}, {30, 30, 0}}},
                      RealProgram{"FANUC_POCKET_G40.NC", 10, {{-30, -30, -30}, {30, 30, 0}}},
                      RealProgram{"ISO_CENTER.NC", 10, {{-20, -20, -10}, {160, 160, 0}}},
                      RealProgram{"ISO_RADIUS.NC", 10, {{-20, -20, -10}, {160, 160, 0}}},
                      RealProgram{"CODESYS_RADIUS.CNC", 10, {{80, 80, -10}, {220, 170, 0}}},
                      RealProgram{"CODESYS_ANGLE.CNC", 8, {{80, 80, -10}, {220, 170, 0}}}),
    [](const auto& at) {
      std::string name = at.param.name;
      std::replace(name.begin(), name.end(), '.', '_');
      return name;
    });

}  // namespace
}  // namespace mrsim
