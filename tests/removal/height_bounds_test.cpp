// Bounds of heights: the same on every instruction set, and bounds of dense samples of the sweeps.
#include "removal/prune/height_bounds.h"

#include "core/numbers/units.h"
#include "removal/columns/height_segments.h"
#include "removal/columns/sweep_columns.h"
#include "removal/forms/path_sweep.h"
#include "removal/prune/list_candidates.h"
#include "removal/simd/sweep_kernels.h"
#include "support/rounds.h"
#include "sweep_support.h"

#include <cstring>
#include <limits>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

constexpr float kNone = std::numeric_limits<float>::infinity();

std::vector<Tool> tools_with_heights() {
  std::vector<Tool> t = {endmill(6),
                         endmill(6, 1),
                         endmill(6, 1, 4),
                         ballmill(5),
                         mill(ToolType::drill, 5),
                         mill(ToolType::chamfer, 6, 0, 2.5),
                         mill(ToolType::taper, 1, 0.5, 12),
                         mill(ToolType::tslot, 8, 0, 3)};
  t[5].tip_diameter = 1;
  t[6].taper_angle = radians(10);
  t[7].neck_diameter = 4;
  return t;
}

/// Height of the underside above the tip at `rho`: where the profile first comes as far.
double underside(const Profile& tool, double rho) {
  for (const ProfileEdge& e : tool.edges()) {
    if (rho > e.b.x || (rho < e.a.x && e.a.x > 0)) continue;
    if (e.radius > 0)
      return e.center.y -
             std::sqrt(std::max(0.0, e.radius * e.radius - std::pow(rho - e.center.x, 2)));
    return e.b.x > e.a.x ? e.a.y + (e.b.y - e.a.y) * (rho - e.a.x) / (e.b.x - e.a.x) : e.a.y;
  }
  return std::numeric_limits<double>::infinity();
}

/// Segments in columns, padded for whole registers.
struct SegmentColumns {
  static constexpr std::size_t kStride = 320;
  alignas(64) float values[kCandidateColumns * kStride] = {};
  std::size_t count = 0;

  void add(const std::vector<LineRecord>& segments) {
    for (const LineRecord& segment : segments) {
      for (std::size_t i = 0; i < 8; ++i)
        values[i * kStride + count] = static_cast<float>(segment.c[i]);
      values[kIdColumn * kStride + count] = static_cast<float>(count + 1);
      ++count;
    }
  }
  CandidateColumns columns() const { return {values, kStride}; }
};

ToolPath random_path(Random& r, bool arc) {
  ToolPath path;
  path.start = {r(-6, 6), r(-6, 6), r(-3, 3)};
  const double flat = r.pick(6) == 0 ? 1e-3 : 1, steep = r.pick(4) == 0 ? 0.01 : 1;
  path.travel = {flat * r(-5, 5), flat * r(-5, 5), steep * r(-4, 4)};
  path.arc = arc;
  path.radius = r(0.5, 5), path.sweep = r(0.5, 6), path.center = path.start;
  const double turn = r(0, kTwoPi), lean = r.pick(2) == 0 ? 0 : r(-1, 1);
  path.u = path.radius * Vec3{std::cos(turn), std::sin(turn), 0};
  path.v = path.radius *
           Vec3{-std::sin(turn) * std::cos(lean), std::cos(turn) * std::cos(lean), std::sin(lean)};
  path.rise = {0, 0, r(-0.5, 0.5)};
  path.speed =
      arc ? std::sqrt(path.radius * path.radius + dot(path.rise, path.rise)) : length(path.travel);
  return path;
}

HeightArgs square(const Vec3& center, double half_diagonal, const SweepClass& type) {
  RegionArgs at;
  at.x = static_cast<float>(center.x), at.y = static_cast<float>(center.y);
  at.z = -20;                     // bounds hold for all that lies above
  at.delta = 64 * 20 * 0x1p-24F;  // docs/removal.md, Single precision
  HeightBounds bounds(0);
  bounds.begin(at, static_cast<float>(half_diagonal));
  return bounds.args(type);
}
HeightArgs square(const Vec3& center, double half_diagonal, const HeightTool& tool) {
  SweepClass type;
  type.heights = tool;
  return square(center, half_diagonal, type);
}

// The least height over dense positions of a path, at a place in plan.
double bottom(const Profile& tool, const ToolPath& path, double x, double y) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 400; ++i) {
    const Vec3 c = path_point(path, i / 400.0 * (path.arc ? path.sweep : 1)).position;
    least = std::min(least, c.z + underside(tool, std::hypot(x - c.x, y - c.y)));
  }
  return least;
}

// No position of the path that the segments stand for lies deeper.
double lowest_tip(const std::vector<LineRecord>& segments) {
  double least = std::numeric_limits<double>::infinity();
  for (const LineRecord& segment : segments)
    least = std::min(least, segment.c[BallSlot::z] - segment.c[BallSlot::error]);
  return least;
}

// At the upper bound every place of the square is in the sweep, as far as each position reaches up.
TEST(Heights, OfPathsAreBoundsOverASquare) {
  Random r(91);
  int below = 0, above = 0;
  for (unsigned round = 0; round < rounds(1500); ++round) {
    const Profile tool = make_cutter(tools_with_heights()[round % 8]);
    ASSERT_TRUE(has_heights(tool));
    const ToolPath path = random_path(r, round % 3 == 0);
    std::vector<LineRecord> segments;
    ASSERT_TRUE(append_segments(path, segments));
    SegmentColumns columns;
    columns.add(segments);
    const double wide = r.pick(3) == 0 ? 0 : r(0, 1.5);
    const Vec3 on_path = path_point(path, r(0, 1)).position;
    const Vec3 center = on_path + Vec3{r(-4, 4), r(-4, 4), 0};
    std::vector<float> lower(SegmentColumns::kStride);
    const float upper = candidate_kernels().segment_heights(
        columns.columns(), columns.count, square(center, wide, height_tool(tool)), lower.data());
    const float least =
        *std::min_element(lower.begin(), lower.begin() + static_cast<long>(columns.count));
    const double top = lowest_tip(segments) + height_tool(tool).top;
    for (int k = 0; k < 12; ++k) {
      const double turn = r(0, kTwoPi), away = k < 6 ? wide : r(0, wide);
      const double x = center.x + away * std::cos(turn), y = center.y + away * std::sin(turn);
      ASSERT_LE(least, bottom(tool, path, x, y)) << "round " << round;
      if (upper < top) {
        ASSERT_LE(path_distance(tool, path, {x, y, upper}).distance, kPathError)
            << "round " << round;
        ++above;
      }
      if (least < kNone) ++below;
    }
  }
  EXPECT_GT(below, 3000) << "bounds that tell something";
  EXPECT_GT(above, 2000);
}

// Short moves that bend in plan and up and down.
std::vector<Motion> bent_row(Random& r, int moves) {
  std::vector<Motion> program;
  double heading = r(0, kTwoPi);
  const double bend = r(-0.15, 0.15), slope = r(-0.4, 0.4), wave = r(0, 0.4);
  Vec3 at{r(-2, 2), r(-2, 2), 0};
  for (int k = 0; k < moves; ++k) {
    heading += bend * r(0, 0.2);
    const Vec3 way{std::cos(heading), std::sin(heading), slope + wave * std::sin(0.3 * k)};
    program.push_back(line(at, at + 0.1 * way));
    at = program.back().end;
  }
  return program;
}

TEST(Heights, OfPacksAreBoundsOfTheirMoves) {
  Random r(94);
  int below = 0, above = 0;
  for (unsigned round = 0; round < rounds(200); ++round) {
    const std::vector<Tool> tools{tools_with_heights()[std::vector{0, 1, 5, 6}[round % 4]]};
    const SweepTable table(bent_row(r, 64), tools);
    const SweepColumns& c = table.columns();
    for (std::uint32_t pack = kFirstPack; pack < kFirstPack + c.packs.size(); ++pack) {
      std::vector<std::uint32_t> numbers{pack}, sweeps;
      c.append_sweeps(pack, sweeps);
      const Vec3 near = c.paths.line(c.refs[sweeps[sweeps.size() / 2]].row).start;
      const Vec3 center = near + Vec3{r(-3, 3), r(-3, 3), 0};
      CandidateList list;
      list_candidates(table, numbers, {0, 0, 0}, list);
      const CandidateList::Slice& slice = list.slices().front();
      const double wide = r(0, 0.3);
      float lower[CandidateList::kPad];
      const float upper = candidate_kernels().segment_heights(
          list.columns(slice.first), 1, square(center, wide, c.classes[slice.class_index]), lower);
      for (int k = 0; k < 8; ++k) {
        const double turn = r(0, kTwoPi);
        const double x = center.x + wide * std::cos(turn), y = center.y + wide * std::sin(turn);
        double least = std::numeric_limits<double>::infinity(), distance = least, lowest = least;
        for (const std::uint32_t id : sweeps) {
          const auto& [a, way] = c.paths.line(c.refs[id].row);
          for (const double s : {0.0, 0.5, 1.0}) {
            const Vec3 tip = a + s * way;
            lowest = std::min(lowest, tip.z);
            least = std::min(
                least, tip.z + underside(c.cutter(c.refs[id]), std::hypot(x - tip.x, y - tip.y)));
          }
          if (upper < kNone) distance = std::min(distance, table.distance(id, {x, y, upper}));
        }
        ASSERT_LE(lower[0], least) << "round " << round;
        below += least < 1e9 ? 1 : 0;
        if (!(upper < lowest + c.classes[slice.class_index].heights.top))
          continue;  // or above the flutes
        ASSERT_LE(distance, kPathError) << "round " << round;
        ++above;
      }
    }
  }
  EXPECT_GT(below, 1000);
  EXPECT_GT(above, 1000);
}

// Of a flat end on a line both bounds are the height itself where the square is a point.
TEST(Heights, OfFlatEndsAreExactAtAPoint) {
  Random r(92);
  const Profile tool = make_cutter(endmill(6));
  int told = 0;
  for (int round = 0; round < 500; ++round) {
    ToolPath path = random_path(r, false);
    path.travel = {r(1, 5), r(-5, 5), r(-4, 4)};
    std::vector<LineRecord> segments;
    ASSERT_TRUE(append_segments(path, segments));
    SegmentColumns columns;
    columns.add(segments);
    const Vec3 center = path_point(path, r(0, 1)).position + Vec3{r(-3, 3), r(-3, 3), 0};
    const Vec3 way = path.travel, low = way.z < 0 ? path.start + way : path.start;
    const double plan = std::hypot(way.x, way.y), m = std::fabs(way.z) / plan;
    const double sign = way.z < 0 ? -1 : 1, ux = sign * way.x / plan, uy = sign * way.y / plan;
    const double u = (center.x - low.x) * ux + (center.y - low.y) * uy;
    const double v = (center.x - low.x) * uy - (center.y - low.y) * ux;
    const double reach = std::sqrt(std::max(0.0, 9 - v * v)), s = std::max(u - reach, 0.0);
    if (std::fabs(v) > 2.99 || s > plan - 0.01 || u + reach < 0.01) continue;
    float lower[SegmentColumns::kStride];
    const float upper = candidate_kernels().segment_heights(
        columns.columns(), columns.count, square(center, 0, height_tool(tool)), lower);
    // Errors in plan count with the slope, and grow where the rim passes at a flat angle.
    const double error = 2e-3 * (1 + m) * (1 + m);
    EXPECT_NEAR(lower[0], low.z + m * s, error);
    EXPECT_NEAR(upper, low.z + m * s, error);
    ++told;
  }
  EXPECT_GT(told, 100);
}

TEST(Heights, OfLevelMovesAreBoundsOverARing) {
  Random r(93);
  constexpr std::size_t kMost = 48;
  for (unsigned round = 0; round < rounds(400); ++round) {
    const Profile tool = make_cutter(tools_with_heights()[round % 8]);
    alignas(64) float squared[kMost] = {}, z[kMost] = {}, lower[kMost] = {};
    const std::size_t n = 1 + static_cast<std::size_t>(r.pick(30));
    const double wide = r(0, 1);
    for (std::size_t k = 0; k < n; ++k)
      squared[k] = static_cast<float>(std::pow(r(0, 5), 2)), z[k] = static_cast<float>(r(-3, 3));
    squared[0] = round % 4 == 0 ? kNone : squared[0];
    CandidateRows rows{};
    rows.squared = squared, rows.z = z;
    const float upper = candidate_kernels().horizontal_heights(
        rows, n, square({0, 0, 0}, wide, height_tool(tool)), lower);
    double most = kNone;  // the least of what each is at most
    for (std::size_t k = 0; k < n; ++k) {
      const double rho = std::sqrt(squared[k]);
      if (squared[k] == kNone) {
        EXPECT_EQ(lower[k], -kNone) << "nothing is known of it";
        continue;
      }
      for (int i = 0; i <= 20; ++i)
        EXPECT_LE(lower[k],
                  z[k] + underside(tool, std::max(0.0, rho - wide) + i / 20.0 * 2 * wide));
      most = std::min(most, z[k] + underside(tool, rho + wide));
    }
    if (upper < kNone) {
      EXPECT_GE(upper, most);
    }
  }
}

TEST(Heights, AreTheSameOnEveryInstructionSet) {
  Random r(94);
  for (unsigned round = 0; round < rounds(600); ++round) {
    const HeightTool tool = height_tool(make_cutter(tools_with_heights()[round % 8]));
    SegmentColumns columns;
    std::vector<LineRecord> segments;
    const int wanted = 1 + r.pick(20);
    for (int i = 0; i < wanted; ++i) ASSERT_TRUE(append_segments(random_path(r, false), segments));
    columns.add(segments);
    const std::size_t n = columns.count;
    const HeightArgs args = square({r(-6, 6), r(-6, 6), 0}, r(0, 2), tool);
    alignas(64) float squared[SegmentColumns::kStride] = {};
    for (std::size_t k = 0; k < n; ++k)
      squared[k] = r.pick(8) == 0 ? kNone : static_cast<float>(r(0, 25));
    CandidateRows rows{};
    rows.squared = squared, rows.z = columns.values + 2 * SegmentColumns::kStride;
    struct Result {
      std::vector<float> lower = std::vector<float>(SegmentColumns::kStride), level = lower,
                         kept = std::vector<float>(kCandidateColumns * SegmentColumns::kStride);
      float least, least_level;
      std::size_t count;
    };
    const auto run = [&](const CandidateKernels& kernels) {
      Result x;
      x.least = kernels.segment_heights(columns.columns(), n, args, x.lower.data());
      x.least_level = kernels.horizontal_heights(rows, n, args, x.level.data());
      x.count = kernels.keep_low(x.lower.data(), n, 1, columns.columns(), 8, x.kept.data(),
                                 SegmentColumns::kStride);
      return x;
    };
    const auto same = [](const float* a, const float* b, std::size_t count) {
      return std::memcmp(a, b, count * sizeof(float)) == 0;
    };
    const Result plain = run(*candidate_kernels(InstructionSet::scalar));
    for (const InstructionSet isa : {InstructionSet::avx2, InstructionSet::avx512}) {
      const CandidateKernels* set = candidate_kernels(isa);
      if (set == nullptr) continue;
      const Result other = run(*set);
      ASSERT_TRUE(same(plain.lower.data(), other.lower.data(), n))
          << "instruction set " << static_cast<int>(isa);
      ASSERT_TRUE(same(plain.level.data(), other.level.data(), n))
          << "instruction set " << static_cast<int>(isa);
      ASSERT_TRUE(same(&plain.least, &other.least, 1) &&
                  same(&plain.least_level, &other.least_level, 1));
      ASSERT_EQ(plain.count, other.count);
      for (std::size_t i = 0; i < kCandidateColumns; ++i) {
        if (i == kPackColumn) continue;
        const std::size_t column = i * SegmentColumns::kStride;
        ASSERT_TRUE(same(&plain.kept[column], &other.kept[column], plain.count)) << i;
      }
    }
  }
}

}  // namespace
}  // namespace mrsim
