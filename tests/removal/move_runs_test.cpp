// Long lists of short straight moves of convex tools: by runs or one by one, the nearest is the
// same.
#include "core/numbers/units.h"
#include "removal/sweep/sweep_table.h"
#include "sweep_support.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

std::vector<Tool> tapers() {
  std::vector<Tool> tools = {mill(ToolType::taper, 1, 0.5, 12), mill(ToolType::chamfer, 6)};
  tools[0].taper_angle = radians(3);
  tools[1].tip_angle = radians(60);
  return tools;
}

// Rows of moves of 0.05 mm or so over a wavy surface, by two tools; among them a plunge, turns of
// the way, and moves of no length in plan.
std::vector<Motion> rows(Random& r, int moves) {
  std::vector<Motion> program;
  Vec3 at{0, 0, 0};
  for (int k = 0; k < moves; ++k) {
    const int row = k / 60;
    const double x = 0.05 * (row % 2 == 0 ? k % 60 : 59 - k % 60) + r(-0.0005, 0.0005);
    Vec3 to{x, 0.3 * row, 0.2 * std::sin(2 * x) + 0.1 * row};
    if (k % 97 == 0) to = at + Vec3{0, 0, -0.1};
    if (k % 41 == 0) to = at + Vec3{r(-0.3, 0.3), r(-0.3, 0.3), 0};
    Motion m = line(at, to);
    m.tool = row == 3 ? 1 : 0;
    program.push_back(m);
    at = to;
  }
  return program;
}

void expect_nearest(const SweepTable& table, std::span<const std::uint32_t> list, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  std::uint32_t sweep = 0;
  for (const std::uint32_t id : list)
    if (const double d = table.distance(id, p); d < least) least = d, sweep = id;
  const SweepTable::Nearest found = table.nearest(list, p);
  EXPECT_EQ(found.distance, least) << p.x << ' ' << p.y << ' ' << p.z;
  EXPECT_EQ(found.sweep, sweep) << p.x << ' ' << p.y << ' ' << p.z;
  EXPECT_LT(table.nearest(list, p, least + 0.1).distance, least + 0.1);
}

// Two tables and several lists of each, by turns: what is kept of one list is not taken for
// another.
TEST(MoveRuns, LeaveTheNearestOfAll) {
  const std::vector<Tool> tools = tapers();
  Random r(3);
  const SweepTable tables[] = {SweepTable(rows(r, 420), tools), SweepTable(rows(r, 420), tools)};
  for (int round = 0; round < 60; ++round) {
    const SweepTable& table = tables[round % 2];
    std::vector<std::uint32_t> list;
    for (std::uint32_t id = 0; id < table.size(); ++id)
      if (round < 4 || r(0, 1) < 0.7) list.push_back(id);
    for (int k = 0; k < 20; ++k) {
      const Vec3 p{r(-1, 4), r(-1, 3), r(-1, 3)};
      expect_nearest(table, list, p);
      for (int near = 0; near < 5; ++near)
        expect_nearest(table, list, p + Vec3{r(-0.1, 0.1), r(-0.1, 0.1), r(-0.1, 0.1)});
    }
  }
}

}  // namespace
}  // namespace mrsim
