// Flat and bull-nose mills on arcs in upright planes: lists, and arcs much larger than the tool.
#include "removal/forms/upright_sweep.h"
#include "removal/simd/sweep_kernels.h"
#include "sweep_support.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

// Every other one with a nearest sweep, 7.
PointColumns some_points(Random& r, std::size_t count) {
  PointColumns points{};
  points.count = count;
  for (std::size_t k = 0; k < count; ++k) {
    points.x[k] = r(-5, 15), points.y[k] = r(-5, 15), points.z[k] = r(-5, 5);
    points.least[k] = k % 2 == 0 ? r(-1, 3) : INFINITY, points.nearest[k] = k % 2 == 0 ? 7 : 0;
  }
  return points;
}

std::vector<UprightRecord> random_quarters(Random& r) {
  ToolPath path = path_of(upright_arc(r));
  path.upright = true;
  set_upright_plane(path);
  const double radius = r(0.3, 6);
  std::vector<UprightRecord> quarters;
  append_quarters(make_cutter(endmill(2 * radius, r.pick(2) ? 0 : r(0, 0.9) * radius)), path,
                  quarters);
  return quarters;
}

TEST(UprightArcs, AreTheSameOnEveryInstructionSet) {
  Random r(14);
  for (int round = 0; round < 2000; ++round) {
    std::vector<UprightRecord> arc = random_quarters(r);
    const std::size_t quarters = arc.size();
    PointColumns one = some_points(r, 8 << round % 4);
    if (round % 8 == 0) one.x[0] = arc[0].x, one.y[0] = arc[0].y;  // under the centre
    const PointColumns before = one;
    sweep_kernels(InstructionSet::scalar)->upright(arc.data(), arc.size(), 5, one);
    for (int k = 0; k < 4; ++k)
      for (const UprightRecord& quarter : random_quarters(r)) arc.push_back(quarter);
    std::vector<std::uint32_t> rows(arc.size());
    for (std::uint32_t& row : rows) row = static_cast<std::uint32_t>(r.pick(int(arc.size())));
    const Vec3 p{one.x[1], one.y[1], one.z[1]};
    const auto listed = [&](const SweepKernels& set, double limit, bool nearest) {
      std::vector<double> out(rows.size() + PointColumns::kPad);
      set.upright_list(arc.data(), rows.data(), rows.size(), p, limit, nearest, out.data());
      out.resize(rows.size());
      return out;
    };
    const std::vector<double> list =
        listed(*sweep_kernels(InstructionSet::scalar), INFINITY, false);
    const double least = *std::min_element(list.begin(), list.end()), limit = least + r(0, 3);
    for (InstructionSet isa :
         {InstructionSet::scalar, InstructionSet::avx2, InstructionSet::avx512}) {
      const SweepKernels* set = sweep_kernels(isa);
      if (set == nullptr) continue;
      PointColumns other = before;
      set->upright(arc.data(), quarters, 5, other);
      ASSERT_EQ(std::memcmp(one.least, other.least, sizeof one.least), 0) << set->name;
      ASSERT_EQ(std::memcmp(one.nearest, other.nearest, sizeof one.nearest), 0) << set->name;
      ASSERT_EQ(listed(*set, INFINITY, false), list) << set->name;
      const std::vector<double> some = listed(*set, limit, false);
      const std::vector<double> first = listed(*set, INFINITY, true);
      for (std::size_t k = 0; k < list.size(); ++k)
        ASSERT_TRUE(list[k] > limit ? some[k] > limit : same_bits(some[k], list[k])) << set->name;
      ASSERT_TRUE(same_bits(*std::min_element(first.begin(), first.end()), least)) << set->name;
    }
  }
}

// Passes side by side, as ribs are finished: most are about as near as the nearest.
TEST(UprightArcs, NearestIsTheLeastOfAll) {
  Random r(15);
  for (const Tool& tool : {endmill(6), endmill(6, 1)}) {
    std::vector<Motion> motions;
    for (int pass = 0; pass < 40; ++pass)
      for (int k = 0; k < 3; ++k) {
        const double x = 20.0 * k, y = 0.5 * pass,
                     side = k == 1 ? -1 : 1;  // a crest between troughs
        const double lean = std::asin(10.0 / 14), rise = 14 * std::cos(lean);
        motions.push_back(arc({x, y, 0}, {x + 10, y, side * rise}, {0, 1, 0}, -side * 2 * lean));
      }
    const SweepTable s(motions, {&tool, 1});
    for (int round = 0; round < 400; ++round) {
      std::vector<std::uint32_t> ids;
      for (std::uint32_t i = 0; i < s.size(); ++i)
        if (r(0, 1) < 0.3) ids.push_back(i);
      const bool is_horizontal = round % 4 == 0;  // with the floors of all
      const Vec3 p{r(-2, 62), r(0, 20),
                   is_horizontal ? 14 * std::cos(std::asin(10.0 / 14)) - 14 : r(-5, 6)};
      double least = INFINITY;
      std::uint32_t nearest = 0;
      for (const std::uint32_t id : ids)
        if (const double d = s.distance(id, p); d < least) least = d, nearest = id;
      const SweepTable::Nearest found = s.nearest(ids, p);
      ASSERT_TRUE(same_bits(found.distance, least));
      ASSERT_EQ(found.sweep, nearest);
    }
  }
}

// Arcs that are hundreds of times as large as the tool, near to them.
TEST(LargeArcs, UprightOnesEqualTheLeastDistanceOverAllPositions) {
  Random r(23);
  for (int round = 0; round < 200; ++round) {
    const double turned = r(0, kTwoPi), size = r(20, 500), from = r(0, kTwoPi);
    const Vec3 along = {std::cos(turned), std::sin(turned), 0};
    const Vec3 start = size * (std::cos(from) * along + Vec3{0, 0, std::sin(from)});
    const Motion m = arc(start, {0, 0, 0}, {along.y, -along.x, 0}, r(-1, 1));
    const double radius = r(0.5, 6), corner = r.pick(2) ? 0 : 0.3 * radius;
    const Tool tool = endmill(2 * radius, corner);
    const SweepTable s({&m, 1}, {&tool, 1});
    for (int k = 0; k < 8; ++k) {
      const Vec3 p = point_near(r, m, 1.2 * radius);
      const double want =
          least([&](double t) { return mill_at_rest(radius, corner, p - at(m, t)); }, 2000);
      EXPECT_NEAR(s.distance(0, p), want, 1e-9) << "round " << round << " point " << k;
    }
  }
}

}  // namespace
}  // namespace mrsim
