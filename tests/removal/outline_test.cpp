// Tools of any outline on horizontal paths: the kernels give the bits of the profile's distance, on
// every instruction set, in lists and for many points.
#include "removal/forms/outline.h"

#include "removal/simd/scalar_forms.h"
#include "removal/simd/sweep_kernels.h"
#include "removal/tool/tool.h"
#include "support/rounds.h"
#include "sweep_support.h"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

std::vector<Profile> profiles() {
  std::vector<Tool> t = {mill(ToolType::chamfer, 8),
                         mill(ToolType::chamfer, 8, 0, 3),
                         mill(ToolType::drill, 5),
                         mill(ToolType::drill, 5, 0, 12),
                         mill(ToolType::taper, 4, 0.5, 14),
                         mill(ToolType::tslot, 10, 0.5, 3),
                         mill(ToolType::lollipop, 6),
                         mill(ToolType::barrel, 8, 2, 16),
                         mill(ToolType::form, 0),
                         mill(ToolType::form, 0),
                         mill(ToolType::form, 0)};
  t[0].tip_diameter = 1, t[4].taper_angle = radians(10), t[5].neck_diameter = 4;
  t[6].neck_diameter = 3, t[7].profile_radius = 30;
  t[8].profile = {{0, 0, 0}, {2, 0, 0}, {2, 1, -std::tan(kPi / 8)}, {5, 4, 0}, {5, 6, 0}};
  t[9].profile = {{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 3, 0}, {2, 5, 0}, {3.5, 6, 0}, {0, 6, 0}};
  t[10] = thread_mill(2, 2.9);
  for (ProfilePoint& p : t[10].profile)
    if (std::fmod(p.z, 1.5) > 1.3 && p.z < 11) p.bulge = -0.3;
  std::vector<Profile> made;
  for (const Tool& tool : t) made.push_back(make_cutter(tool));
  return made;
}

struct Outline {
  explicit Outline(const Profile& tool) { append_outline(tool, edges); }
  OutlineTool of(const Profile& tool) const { return {edges, tool.max_radius(), tool.bottom()}; }
  std::vector<OutlineEdge> edges;
};

// Some places are corners of the outline, or on its axis, or level with a corner.
Vec2 place(Random& r, const Profile& tool) {
  const auto& edges = tool.edges();
  const Vec2 corner = edges[static_cast<std::size_t>(r.pick(static_cast<int>(edges.size())))].a;
  switch (r.pick(6)) {
    case 0:
      return corner;
    case 1:
      return {r(0, 8), corner.y};
    case 2:
      return {corner.x, r(-3, 15)};
    case 3:
      return {0, r(-3, 15)};
    default:
      return {r(0, 8), r(-3, 15)};
  }
}

TEST(OutlineDistance, HasTheBitsOfTheProfile) {
  Random r(3);
  for (const Profile& tool : profiles()) {
    const Outline outline(tool);
    for (unsigned round = 0; round < testing::rounds(4000); ++round) {
      const Vec2 q = place(r, tool);
      const double expected = tool.distance(q);
      ASSERT_EQ(lane::outline_distance(outline.edges, q.x, q.y), expected) << q.x << ' ' << q.y;
    }
  }
}

ProfileRow random_row(Random& r, bool is_arc) {
  ProfileRow row;
  row.arc = is_arc, row.z = r(-3, 3);
  row.c[LineSlot::x] = r(0, 5), row.c[LineSlot::y] = r(0, 5);
  const double turn = r(0, kTwoPi), half = r(0, kPi);
  if (!is_arc) {
    const double length = r.pick(5) == 0 ? 0 : r(0, 6);
    row.c[LineSlot::dx] = length * std::cos(turn), row.c[LineSlot::dy] = length * std::sin(turn);
  } else {
    row.c[ArcSlot::radius] = r(0.1, 5);
    row.c[ArcSlot::mx] = std::cos(turn), row.c[ArcSlot::my] = std::sin(turn);
    row.c[ArcSlot::cosine] = std::cos(half), row.c[ArcSlot::sine] = std::sin(half);
  }
  return row;
}

double distance_from(const Profile& tool, const ProfileRow& row, const Vec3& p) {
  const double rho = row.arc ? lane::arc_rho(row.c, p.x, p.y) : lane::line_rho(row.c, p.x, p.y);
  return tool.distance({rho, p.z - row.z});
}

constexpr InstructionSet kSets[] = {InstructionSet::scalar, InstructionSet::avx2,
                                    InstructionSet::avx512};

// Beyond the limit any number above it will do.
TEST(OutlineKernels, ListsAreTheSingleDistances) {
  Random r(4);
  for (const Profile& tool : profiles()) {
    const Outline outline(tool);
    for (unsigned round = 0; round < testing::rounds(60); ++round) {
      std::vector<ProfileRow> paths;
      for (int i = 0; i < 20; ++i) paths.push_back(random_row(r, round % 2 == 1));
      std::vector<std::uint32_t> rows(1 + r.pick(30));
      for (std::uint32_t& row : rows) row = static_cast<std::uint32_t>(r.pick(20));
      const Vec3 p{r(0, 5), r(0, 5), r(-5, 12)};
      const double limit = round % 3 == 0 ? r(0, 2) : std::numeric_limits<double>::infinity();
      for (const InstructionSet isa : kSets) {
        const SweepKernels* set = sweep_kernels(isa);
        if (set == nullptr) continue;
        std::array<double, 32 + PointColumns::kPad> out{};
        set->outline_list(outline.of(tool), paths.data(), rows.data(), rows.size(), p, limit,
                          out.data());
        for (std::size_t k = 0; k < rows.size(); ++k) {
          const double expected = distance_from(tool, paths[rows[k]], p);
          if (expected > limit)
            ASSERT_GT(out[k], limit) << set->name;
          else
            ASSERT_EQ(out[k], expected) << set->name;
        }
      }
    }
  }
}

TEST(OutlineKernels, TakeTheCloserOfManyPoints) {
  Random r(5);
  for (const Profile& tool : profiles()) {
    const Outline outline(tool);
    for (unsigned round = 0; round < testing::rounds(60); ++round) {
      const ProfileRow row = random_row(r, round % 2 == 1);
      PointColumns before{};
      before.count = std::size_t(8) << round % 4;
      for (std::size_t k = 0; k < before.count; ++k) {
        before.x[k] = r(0, 5), before.y[k] = r(0, 5), before.z[k] = r(-5, 12);
        before.least[k] = k % 3 == 0 ? INFINITY : r(-1, 3), before.nearest[k] = 7;
        const Vec3 p{before.x[k], before.y[k], before.z[k]};
        if (k % 5 == 1) before.least[k] = distance_from(tool, row, p);  // the lower id has it
      }
      const std::uint32_t id = round % 3 == 0 ? 9 : 5;
      for (const InstructionSet isa : kSets) {
        const SweepKernels* set = sweep_kernels(isa);
        if (set == nullptr) continue;
        PointColumns points = before;
        set->outline(outline.of(tool), row, id, points);
        for (std::size_t k = 0; k < points.count; ++k) {
          const double d = distance_from(tool, row, {points.x[k], points.y[k], points.z[k]});
          const double least = before.least[k];
          ASSERT_EQ(points.least[k], std::min(d, least)) << set->name;
          const bool closer = d < least || (d == least && id < 7);
          ASSERT_EQ(points.nearest[k], closer ? id : 7) << set->name;
        }
      }
    }
  }
}

}  // namespace
}  // namespace mrsim
