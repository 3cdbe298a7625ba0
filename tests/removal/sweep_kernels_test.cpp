// Lists and nearest points: equal to the single queries to the last bit, on every instruction set.
#include "removal/sweep_kernels.h"

#include "sweep_support.h"

#include <cstring>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace test;

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

struct Scene {
  std::vector<Tool> tools;
  std::vector<Motion> motions;
};

Scene mixed_scene(Random& r, int n) {
  Scene s;
  s.tools = {ballmill(6), endmill(10), endmill(8, 1.5), endmill(4, 1, 7)};
  s.tools.push_back(endmill(5));
  s.tools.back().type = ToolType::drill;
  for (int i = 0; i < n; ++i) {
    const Vec3 a = {r(-20, 20), r(-20, 20), r(-5, 5)};
    Vec3 b = {r(-20, 20), r(-20, 20), r(-5, 5)};
    const int kind = r.pick(4);
    if (kind == 1) b.z = a.z;
    if (kind == 2) b = {a.x, a.y, b.z};
    Motion m = kind == 3 ? arc(a, {b.x, b.y, a.z}, {0, 0, 1}, r(-7, 7)) : line(a, b);
    m.tool = r.pick(5);
    s.motions.push_back(m);
  }
  return s;
}

class Lists : public testing::TestWithParam<int> {};  // tool of all moves, -1 = mixed

TEST_P(Lists, EqualSingleQueriesToTheLastBit) {
  Random r(11);
  Scene scene = mixed_scene(r, 300);
  if (GetParam() >= 0) {
    std::erase_if(scene.motions, [](const Motion& m) { return m.kind == MotionKind::arc; });
    for (Motion& m : scene.motions) m.tool = GetParam(), m.end.z = m.start.z;
  }
  const SweepTable s(scene.motions, scene.tools, 50);
  for (int round = 0; round < 30; ++round) {
    std::vector<std::uint32_t> ids;
    for (std::uint32_t i = 0; i < s.size(); ++i)
      if (r(0, 1) < 0.6) ids.push_back(i);
    ids.resize(std::min<std::size_t>(ids.size(), round < 10 ? round : 1000));
    const Vec3 p = {r(-25, 25), r(-25, 25), r(-10, 15)};
    const std::size_t n = ids.size();
    std::vector<double> d(n + 1, 7), e(n), q(n), x(n), y(n), z(n);
    s.distances(ids, p, d.data());
    s.nearest(ids, p, {e.data(), q.data(), x.data(), y.data(), z.data()});
    EXPECT_EQ(d[n], 7) << "written past the end";
    for (std::size_t k = 0; k < n; ++k) {
      ASSERT_TRUE(same_bits(d[k], s.distance(ids[k], p)));
      ASSERT_TRUE(same_bits(e[k], d[k]));
    }
  }
  std::vector<Vec3> points;
  for (int k = 0; k < 37; ++k) points.push_back({r(-25, 25), r(-25, 25), r(-10, 15)});
  std::vector<double> d(points.size());
  for (std::size_t i = 0; i < s.size(); ++i) {
    s.distances(i, points, d.data());
    for (std::size_t k = 0; k < points.size(); ++k)
      ASSERT_TRUE(same_bits(d[k], s.distance(i, points[k])));
  }
}

INSTANTIATE_TEST_SUITE_P(MixedBallFlatBullClosed, Lists, testing::Values(-1, 0, 1, 2, 3));

template <class Record>
void expect_equal_levels(FormKernels<Record> SweepKernels::*form, std::vector<Record> records) {
  Random r(5);
  std::vector<std::uint32_t> rows;
  for (std::size_t i = 0; i < records.size(); i += 1 + r.pick(3))
    rows.push_back(static_cast<std::uint32_t>(i));
  const FormKernels<Record>& plain = sweep_kernels(SimdLevel::scalar)->*form;
  for (SimdLevel level : {SimdLevel::avx2, SimdLevel::avx512}) {
    const SweepKernels* set = sweep_kernels(level);
    if (set == nullptr) continue;
    for (int round = 0; round < 200; ++round) {
      const Vec3 p = {r(-5, 15), r(-5, 15), r(-5, 5)};
      const std::size_t n = rows.size() - round % 11;
      std::vector<double> a(5 * n), b(5 * n);
      const auto columns = [n](std::vector<double>& v) {
        return NearestColumns{&v[0], &v[n], &v[2 * n], &v[3 * n], &v[4 * n]};
      };
      plain.nearest(records.data(), rows.data(), n, p, columns(a));
      (set->*form).nearest(records.data(), rows.data(), n, p, columns(b));
      ASSERT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)), 0) << set->name;
      (set->*form).list(records.data(), rows.data(), n, p, b.data());
      ASSERT_EQ(std::memcmp(a.data(), b.data(), n * sizeof(double)), 0) << set->name;
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
  expect_equal_levels(&SweepKernels::ball_line, balls);
  expect_equal_levels(&SweepKernels::plane_line, lines);
  expect_equal_levels(&SweepKernels::plane_arc, arcs);
}

TEST(SweepTable, NearestPointsLieOnTheSkeleton) {
  Random r(23);
  const Scene scene = mixed_scene(r, 200);
  const SweepTable s(scene.motions, scene.tools, 50);
  for (std::uint32_t i = 0; i < s.size(); ++i) {
    const SweepSkeleton k = s.skeleton(i);
    for (int round = 0; round < 10; ++round) {
      const Vec3 p = {r(-25, 25), r(-25, 25), r(-10, 15)};
      double d, q, x, y, z;
      s.nearest({&i, 1}, p, {&d, &q, &x, &y, &z});
      if (k.kind == SweepSkeleton::Kind::none) continue;
      const bool strip = k.kind == SweepSkeleton::Kind::strip;
      const double dz = strip ? p.z - z : 0;
      const double plan = (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y);
      EXPECT_NEAR(plan + dz * dz, q, 1e-10);
      EXPECT_TRUE(!strip || std::fabs(std::sqrt(q) - k.radius - d) < 1e-12);
      EXPECT_GE(z, k.low - 1e-12);
      EXPECT_TRUE(strip || std::fabs(z - k.low) < 1e-12);
    }
  }
}

}  // namespace
}  // namespace mrsim
