// Lists and nearest points: equal to the single queries to the last bit, on every instruction set.
#include "removal/simd/sweep_kernels.h"

#include "removal/forms/chain_sweep.h"
#include "removal/forms/slant_sweep.h"
#include "removal/prune/candidate_list.h"
#include "removal/prune/list_candidates.h"
#include "support/rounds.h"
#include "sweep_support.h"

#include <cstring>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

struct KernelScene {
  std::vector<Tool> tools;
  std::vector<Motion> motions;
};

KernelScene mixed_scene(Random& r, int n) {
  KernelScene s;
  s.tools = {ballmill(6), endmill(10), endmill(8, 1.5), endmill(4, 1, 7)};
  s.tools.push_back(endmill(5));
  s.tools.back().type = ToolType::drill;
  s.tools.push_back(mill(ToolType::taper, 1, 0.5, 12));
  s.tools.back().taper_angle = 0.2;
  for (int i = 0; i < n; ++i) {
    const Vec3 a = {r(-20, 20), r(-20, 20), r(-5, 5)};
    Vec3 b = {r(-20, 20), r(-20, 20), r(-5, 5)};
    const int kind = r.pick(6);
    if (kind == 1) b.z = a.z;
    if (kind == 2) b = {a.x, a.y, b.z};
    Motion m = kind == 3 ? arc(a, {b.x, b.y, a.z}, {0, 0, 1}, r(-7, 7)) : line(a, b);
    if (kind == 4) m = arc(a, {a.x + r(1, 3), a.y, a.z}, {0, 0, 1}, r(5, 20), -r(0, 5));
    if (kind == 5) m = upright_arc(r);
    m.tool = r.pick(6);
    s.motions.push_back(m);
  }
  return s;
}

PointColumns random_points(Random& r, std::size_t count) {
  PointColumns points{};
  points.count = count;
  for (std::size_t k = 0; k < count; ++k) {
    points.x[k] = r(-5, 15), points.y[k] = r(-5, 15), points.z[k] = r(-5, 5);
    points.least[k] = INFINITY;
  }
  return points;
}

// The least of all distances and the first sweep that has it.
void expect_least(const SweepTable& s, const std::vector<std::uint32_t>& ids, PointColumns points) {
  CandidateList list;
  list_candidates(s, ids, {0, 0, 0}, list);
  least_distances(s, list, points);
  for (std::size_t k = 0; k < points.count; ++k) {
    double least = INFINITY, nearest = 0;
    for (const std::uint32_t id : ids)
      if (const double d = s.distance(id, {points.x[k], points.y[k], points.z[k]}); d < least)
        least = d, nearest = id;
    ASSERT_TRUE(same_bits(least, points.least[k]));
    ASSERT_EQ(nearest, points.nearest[k]);
  }
}

class Lists : public ::testing::TestWithParam<int> {};  // tool of all moves, -1 = mixed

TEST_P(Lists, EqualSingleQueriesToTheLastBit) {
  Random r(11);
  KernelScene scene = mixed_scene(r, 300);
  if (GetParam() >= 0) {
    std::erase_if(scene.motions, [](const Motion& m) { return m.kind == MotionKind::arc; });
    for (Motion& m : scene.motions) m.tool = GetParam(), m.end.z = m.start.z;
  }
  const SweepTable s(scene.motions, scene.tools);
  for (int round = 0; round < 30; ++round) {
    std::vector<std::uint32_t> ids;
    for (std::uint32_t i = 0; i < s.size(); ++i)
      if (r(0, 1) < 0.6) ids.push_back(i);
    ids.resize(std::min<std::size_t>(ids.size(), round < 10 ? round : 1000));
    const Vec3 p = {r(-25, 25), r(-25, 25), r(-10, 15)};
    const std::size_t n = ids.size();
    std::vector<double> d(n + 1, 7);
    s.distances(ids, p, d.data());
    EXPECT_EQ(d[n], 7) << "written past the end";
    for (std::size_t k = 0; k < n; ++k) ASSERT_TRUE(same_bits(d[k], s.distance(ids[k], p)));
    std::vector<double> near(n);
    s.near_distances(ids, p, 2.0, near.data());
    const double limit = n > 0 ? *std::min_element(d.begin(), d.begin() + n) + 2 : 0;
    for (std::size_t k = 0; k < n; ++k)
      ASSERT_TRUE(d[k] > limit ? near[k] > limit : same_bits(near[k], d[k])) << k;
    expect_least(s, ids, random_points(r, 64));
  }
}

INSTANTIATE_TEST_SUITE_P(MixedBallFlatBullClosed, Lists, ::testing::Values(-1, 0, 1, 2, 3));

// Voxels of a block: columns of equal x and y, `depth` points each.
PointColumns lattice_points(Random& r, std::size_t side, std::size_t depth, double voxel) {
  PointColumns points{};
  const Vec3 first = {r(-2, 2), r(-2, 2), r(-voxel * double(depth), 0)};
  for (std::size_t x = 0; x < side; ++x)
    for (std::size_t y = 0; y < side; ++y)
      for (std::size_t z = 0; z < depth; ++z) {
        const std::size_t k = points.count++;
        points.x[k] = first.x + double(x) * voxel, points.y[k] = first.y + double(y) * voxel;
        points.z[k] = first.z + double(z) * voxel;
        points.least[k] = INFINITY;
      }
  return points;
}

// Clearing at two levels: most moves reach over the points, and their floors are equally near. Ends
// lie on a coarse grid, so that walls and ends coincide as well.
TEST(LevelMoves, OwnTheFloorByTheFirstOfThemThatCoversIt) {
  Random r(31);
  for (const Tool& tool : {endmill(6), endmill(6, 1), ballmill(6), endmill(6, 1, 3)}) {
    std::vector<Motion> motions;
    const auto place = [&](double z) { return Vec3{r.pick(9) - 4.0, r.pick(9) - 4.0, z}; };
    for (int i = 0; i < 400; ++i) {
      const double z = i % 100 < 70 ? 0 : -0.125;
      const Vec3 a = place(z), b = place(z);
      motions.push_back(i % 3 == 0 ? line(a, b) : arc(a, {b.x + 0.5, b.y, z}, {0, 0, 1}, r(-3, 3)));
    }
    const SweepTable s(motions, {&tool, 1});
    std::vector<std::uint32_t> ids;
    for (unsigned round = 0; round < testing::rounds(120); ++round) {
      ids.clear();
      for (std::uint32_t i = 0; i < s.size(); ++i)
        if (r(0, 1) < 0.2) ids.push_back(i);
      expect_least(s, ids, lattice_points(r, 4, 4, 0.25));
      expect_least(s, ids, lattice_points(r, 3, 3, 1e-6));
      expect_least(s, ids, lattice_points(r, 2, 8, 0.125));
      expect_least(s, ids, lattice_points(r, 1, 5, 0.5));
    }
  }
}

template <class Record>
void expect_equal_sets(FormKernels<Record> SweepKernels::*form, std::vector<Record> records) {
  Random r(5);
  std::vector<std::uint32_t> rows;
  for (std::size_t i = 0; i < records.size(); i += 1 + r.pick(3))
    rows.push_back(static_cast<std::uint32_t>(i));
  const FormKernels<Record>& plain = sweep_kernels(InstructionSet::scalar)->*form;
  for (InstructionSet isa : {InstructionSet::avx2, InstructionSet::avx512}) {
    const SweepKernels* set = sweep_kernels(isa);
    if (set == nullptr) continue;
    for (int round = 0; round < 200; ++round) {
      const Vec3 p = {r(-5, 15), r(-5, 15), r(-5, 5)};
      const std::size_t n = rows.size() - round % 11;
      std::vector<double> a(n), b(n);
      plain.list(records.data(), rows.data(), n, p, a.data());
      (set->*form).list(records.data(), rows.data(), n, p, b.data());
      ASSERT_EQ(std::memcmp(a.data(), b.data(), n * sizeof(double)), 0) << set->name;
      PointColumns one = random_points(r, 8 << round % 4), other = one;
      plain.least(records.data(), rows.data(), rows.data(), n, one);
      (set->*form).least(records.data(), rows.data(), rows.data(), n, other);
      ASSERT_EQ(std::memcmp(one.least, other.least, sizeof one.least), 0) << set->name;
      ASSERT_EQ(std::memcmp(one.nearest, other.nearest, sizeof one.nearest), 0) << set->name;
    }
  }
}

TEST(SweepKernels, BoresAreTheSameOnEveryInstructionSet) {
  Random r(6);
  for (int round = 0; round < 200; ++round) {
    const double low = r(-3, 3), corner = r.pick(2) ? r(0, 1) : 0;
    const double whole = r.pick(2);
    const LineRecord bore = {
        {r(0, 5), r(0, 5), r(0.5, 4), r(0, 4), corner, low, low - r(0, 1), whole}};
    PointColumns one = random_points(r, 8 << round % 4);
    for (std::size_t k = 0; k < one.count; k += 2) one.least[k] = r(-1, 3), one.nearest[k] = 7;
    const PointColumns before = one;
    const auto open = sweep_kernels(InstructionSet::scalar)->bore(bore, 5, one);
    for (InstructionSet isa : {InstructionSet::avx2, InstructionSet::avx512}) {
      const SweepKernels* set = sweep_kernels(isa);
      if (set == nullptr) continue;
      PointColumns other = before;
      ASSERT_EQ(set->bore(bore, 5, other), open) << set->name;
      ASSERT_EQ(std::memcmp(one.least, other.least, sizeof one.least), 0) << set->name;
      ASSERT_EQ(std::memcmp(one.nearest, other.nearest, sizeof one.nearest), 0) << set->name;
    }
  }
}

TEST(SweepKernels, BoundsOfBoresAreTheSameOnEveryInstructionSet) {
  Random r(16);
  std::vector<LineRecord> bores;
  std::vector<std::uint32_t> rows;
  for (std::uint32_t k = 0; k < 40; ++k, rows.push_back(k / 2 * 2)) {
    const double low = r(-3, 3);
    bores.push_back({{r(0, 5), r(0, 5), r(0.5, 4), r(0, 4), r(0, 1), low, low - r(0, 1), 1}});
    bores.back().c[BoreSlot::whole] = r.pick(2);
  }
  struct Bounds {
    double bounds[48] = {};
    std::uint8_t decided[48] = {};
  };
  for (std::size_t n = 1; n <= rows.size(); ++n) {
    const Vec3 p = {r(-5, 10), r(-5, 10), r(-5, 5)};
    const auto found = [&](InstructionSet isa) {
      Bounds out;
      sweep_kernels(isa)->bore_bounds(bores.data(), rows.data(), n, p, out.bounds, out.decided);
      return out;
    };
    const Bounds one = found(InstructionSet::scalar);
    for (InstructionSet isa : {InstructionSet::avx2, InstructionSet::avx512}) {
      if (sweep_kernels(isa) == nullptr) continue;
      const Bounds other = found(isa);
      ASSERT_EQ(std::memcmp(one.bounds, other.bounds, n * sizeof(double)), 0);
      ASSERT_EQ(std::memcmp(one.decided, other.decided, n), 0);
    }
  }
}

HelixRecord random_helix(Random& r) {
  HelixRecord h{r(0, 5), r(0, 5), r(-3, 3), 1, 0, 0, 1, r(0.2, 5), r(0.01, 1), r(0, 4)};
  if (r.pick(2)) h.round = r(0, 1);
  if (r.pick(4) == 0) h.core = 0;
  const double a = r(0, 6.28), b = r.pick(2) ? r(a, 6.28) : 6.28;
  if (r.pick(2)) h.begin = {a, std::sin(a), std::cos(a)};
  h.end = {b, std::sin(b), std::cos(b)};
  return h;
}

TEST(SweepKernels, HelicesAreTheSameOnEveryInstructionSet) {
  Random r(9);
  for (int round = 0; round < 2000; ++round) {
    const HelixRecord helix = random_helix(r);
    PointColumns one = random_points(r, 8 << round % 4);
    for (std::size_t k = 0; k < one.count; k += 2) one.least[k] = r(-1, 3), one.nearest[k] = 7;
    if (round % 8 == 0) one.x[0] = helix.x, one.y[0] = helix.y;  // on the axis
    const PointColumns before = one;
    std::uint64_t open = ~std::uint64_t(0) >> (PointColumns::kMost - one.count);
    for (int k = round % 5; k > 0; --k) open &= ~(std::uint64_t(1) << r.pick(64));
    sweep_kernels(InstructionSet::scalar)->helix(helix, 5, open, one);
    for (std::size_t k = 0; k < one.count; ++k)
      if ((open >> k & 1u) == 0) {
        ASSERT_TRUE(same_bits(one.least[k], before.least[k]));
      }
    for (InstructionSet isa : {InstructionSet::avx2, InstructionSet::avx512}) {
      const SweepKernels* set = sweep_kernels(isa);
      if (set == nullptr) continue;
      PointColumns other = before;
      set->helix(helix, 5, open, other);
      ASSERT_EQ(std::memcmp(one.least, other.least, sizeof one.least), 0) << set->name;
      ASSERT_EQ(std::memcmp(one.nearest, other.nearest, sizeof one.nearest), 0) << set->name;
    }
  }
}

TEST(SweepKernels, SlantsAreTheSameOnEveryInstructionSet) {
  Random r(10);
  for (int round = 0; round < 2000; ++round) {
    const double a = r(-3, 3), lean = round % 5 == 0 ? 1.5707 : r(0, 1.57);
    SlantRecord slant{r(0, 5),    r(0, 5),        r(-3, 3),       std::cos(a), std::sin(a),
                      r(0.01, 6), std::cos(lean), std::sin(lean), r(0.1, 4)};
    if (round % 2 == 0) slant.round = r(0, 1);
    PointColumns one = random_points(r, 8 << round % 4);
    for (std::size_t k = 0; k < one.count; k += 2) one.least[k] = r(-1, 3), one.nearest[k] = 7;
    if (round % 8 == 0) one.x[0] = slant.x, one.y[0] = slant.y;
    const PointColumns before = one;
    sweep_kernels(InstructionSet::scalar)->slant(slant, 5, one);
    for (InstructionSet isa : {InstructionSet::avx2, InstructionSet::avx512}) {
      const SweepKernels* set = sweep_kernels(isa);
      if (set == nullptr) continue;
      PointColumns other = before;
      set->slant(slant, 5, other);
      ASSERT_EQ(std::memcmp(one.least, other.least, sizeof one.least), 0) << set->name;
      ASSERT_EQ(std::memcmp(one.nearest, other.nearest, sizeof one.nearest), 0) << set->name;
    }
  }
}

TEST(SweepKernels, ChainsAreTheSameOnEveryInstructionSet) {
  Random r(12);
  std::vector<Tool> tools = {mill(ToolType::drill, 5), mill(ToolType::chamfer, 6, 0, 4),
                             mill(ToolType::taper, 1, 0.5, 12), mill(ToolType::lollipop, 4)};
  tools[1].tip_diameter = 1, tools[2].taper_angle = 0.05, tools[3].neck_diameter = 1;
  for (int round = 0; round < 2000; ++round) {
    const Profile cutter = make_cutter(tools[static_cast<std::size_t>(round % 4)]);
    const ChainTool tool = chain_tool(cutter);
    ToolPath path;
    path.start = {r(0, 5), r(0, 5), r(-3, 3)};
    const double rise = round % 5 == 0 ? 1e-4 : 1;
    path.travel = {r(-4, 4), round % 7 == 0 ? 0 : r(-4, 4), rise * r(-3, 3)};
    const ChainLine line = chain_line(tool, path);
    PointColumns one = random_points(r, 8 << round % 4);
    for (std::size_t k = 0; k < one.count; k += 2) one.least[k] = r(-1, 3), one.nearest[k] = 7;
    if (round % 8 == 0) one.x[0] = line.x, one.y[0] = line.y;
    if (round % 8 == 1) one.x[1] = line.x, one.y[1] = line.y, one.z[1] = line.z + tool.tip;
    const PointColumns before = one;
    sweep_kernels(InstructionSet::scalar)->chain(tool, line, 5, one);
    for (InstructionSet isa : {InstructionSet::avx2, InstructionSet::avx512}) {
      const SweepKernels* set = sweep_kernels(isa);
      if (set == nullptr) continue;
      PointColumns other = before;
      set->chain(tool, line, 5, other);
      ASSERT_EQ(std::memcmp(one.least, other.least, sizeof one.least), 0) << set->name;
      ASSERT_EQ(std::memcmp(one.nearest, other.nearest, sizeof one.nearest), 0) << set->name;
    }
  }
}

// Lists of moves at one point, of all lengths; far beyond a limit any bound will do.
TEST(SweepKernels, BoundsAreTheSameOnEveryInstructionSet) {
  Random r(21);
  Tool taper = mill(ToolType::taper, 6, 0.5, 12);
  taper.taper_angle = 0.1;
  const Profile cutter = make_cutter(taper), bull = make_cutter(endmill(4, 1));
  const ChainTool tool = chain_tool(cutter);
  std::vector<ChainLine> chains;
  std::vector<SlantRecord> slants;
  for (int i = 0; i < 40; ++i) {
    ToolPath path;
    path.start = {r(0, 5), r(0, 5), r(-3, 3)};
    path.travel = {r(-4, 4), i % 7 == 0 ? 0 : r(-4, 4), i % 5 == 0 ? 1e-4 : r(-9, 9)};
    chains.push_back(chain_line(tool, path)), slants.push_back(slant_record(bull, path));
  }
  for (int round = 0; round < 300; ++round) {
    std::vector<std::uint32_t> rows(1 + r.pick(30));
    for (std::uint32_t& row : rows) row = static_cast<std::uint32_t>(r.pick(40));
    const Vec3 p{r(0, 5), r(0, 5), r(-3, 8)};
    const double limit = round % 2 == 0 ? std::numeric_limits<double>::infinity() : r(0, 2);
    constexpr std::size_t kStride = 32 + PointColumns::kPad;
    std::vector<double> columns(ChainColumn::kCount * kStride);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const ChainLine& m = chains[rows[k]];
      const double numbers[] = {m.x,       m.y,       m.z,        m.ux,      m.uy,
                                m.plan,    m.rise,    m.per_plan, m.per_way, m.tilt[0],
                                m.tilt[1], m.tilt[2], m.tilt[3]};
      for (std::size_t i = 0; i < ChainColumn::kCount; ++i) columns[i * kStride + k] = numbers[i];
    }
    const auto found = [&](const SweepKernels& set) {
      std::vector<double> out(32 + PointColumns::kPad);
      set.chain_bounds(tool, chains.data(), rows.data(), rows.size(), p, limit, out.data());
      std::vector<double> beside(32 + PointColumns::kPad);
      set.chain_bounds_beside(tool, {columns.data(), kStride}, rows.size(), p, limit,
                              beside.data());
      for (double* d : {out.data(), beside.data()})
        for (std::size_t k = 0; k < rows.size(); ++k)
          if (d[k] > limit) d[k] = std::numeric_limits<double>::infinity();
      EXPECT_EQ(std::memcmp(out.data(), beside.data(), rows.size() * sizeof(double)), 0);
      std::vector<double> some(32 + PointColumns::kPad);
      set.slant_bounds(slants.data(), rows.data(), rows.size(), p, some.data());
      out.resize(rows.size());
      out.insert(out.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(rows.size()));
      return out;
    };
    const std::vector<double> one = found(*sweep_kernels(InstructionSet::scalar));
    for (std::size_t k = 0; k < rows.size(); ++k)
      ASSERT_LE(one[k + rows.size()], slant_minimum(slants[rows[k]], p).distance + 1e-8);
    for (InstructionSet isa : {InstructionSet::avx2, InstructionSet::avx512}) {
      const SweepKernels* set = sweep_kernels(isa);
      if (set == nullptr) continue;
      const std::vector<double> other = found(*set);
      ASSERT_EQ(std::memcmp(one.data(), other.data(), one.size() * sizeof(double)), 0) << set->name;
    }
  }
}

TEST(SweepKernels, EveryInstructionSetGivesTheSameBits) {
  Random r(17);
  std::vector<LineRecord> balls, lines;
  std::vector<ArcRecord> arcs;
  for (int i = 0; i < 100; ++i) {
    const double a = r(-4, 4), c = std::cos(a), s = std::sin(a), h = r(0, 3.14);
    const double length = i % 9 == 0 ? 0 : r(0, 8);
    balls.push_back({{r(0, 10), r(0, 10), r(-1, 1), c, s, length, r(-2, 2), r(0.1, 3)}});
    lines.push_back({{r(0, 10), r(0, 10), c * length, s * length, r(-1, 1), r(0, 3), r(0, 1),
                      i % 3 == 0 ? INFINITY : r(4, 6)}});
    arcs.push_back({{r(0, 10), r(0, 10), r(0, 5), c, s, std::cos(h), std::sin(h), r(-1, 1), r(0, 3),
                     r(0, 1), i % 3 == 0 ? INFINITY : r(4, 6)}});
  }
  expect_equal_sets(&SweepKernels::ball_line, balls);
  expect_equal_sets(&SweepKernels::plane_line, lines);
  expect_equal_sets(&SweepKernels::plane_arc, arcs);
}

}  // namespace
}  // namespace mrsim
