// The tree of turning sweeps against every sweep on its own.
#include "removal/columns/turn_tree.h"

#include "removal/prune/candidate_list.h"
#include "removal/prune/list_candidates.h"
#include "removal/prune/prune.h"
#include "removal/prune/prune_turned.h"
#include "removal/simd/sweep_kernels.h"
#include "turn_scenes.h"

#include <bit>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

SweepTable::Nearest of_all(const SweepTable& sweeps, const Vec3& p) {
  SweepTable::Nearest best;
  for (std::uint32_t i = 0; i < sweeps.size(); ++i)
    if (const double d = sweeps.distance(i, p); d < best.distance) best = {d, i};
  return best;
}

Vec3 somewhere(Random& r) {
  const double reach = r.pick(8) == 0 ? 0.05 : 12;
  return {r(-reach, reach), r.pick(8) == 0 ? 0 : r(-reach, reach), r(-2, 22)};
}

TEST(TurnTree, NearestEqualsTheLeastOfAllSweeps) {
  Random r(11);
  const std::vector<Tool> tools = inserts();
  for (int round = 0; round < 400; ++round) {
    const SweepTable sweeps(turning_moves(r, 20 + r.pick(300), 10, 20), tools);
    const std::vector<std::uint32_t> all = sweeps.all();
    for (int k = 0; k < 30; ++k) {
      const Vec3 p = somewhere(r);
      const SweepTable::Nearest expected = of_all(sweeps, p), found = sweeps.nearest(all, p);
      ASSERT_EQ(expected.distance, found.distance) << "round " << round;
      ASSERT_EQ(expected.sweep, found.sweep) << "round " << round;
    }
  }
}

// A region and one within it: what is left decides all their points.
TEST(TurnTree, PruningNeverChangesABit) {
  Random r(5);
  const std::vector<Tool> tools = inserts();
  for (int round = 0; round < 1500; ++round) {
    const SweepTable sweeps(turning_moves(r, 20 + r.pick(200), 10, 20), tools);
    const Vec3 center = somewhere(r);
    const double half = r.pick(2) ? r(0.001, 0.05) : r(0.05, 2), band = 3 * half;
    CandidateList all, large, small;
    list_candidates(sweeps, sweeps.all(), center, all);
    const PruneRegion outer = PruneRegion::cube(center, 2 * half);
    if (!prune(sweeps, outer, outer.radius + band + 1e-9, band, all, large)) continue;
    const Vec3 inside = center + half * Vec3{r(-1, 1), r(-1, 1), r(-1, 1)};
    const PruneRegion inner = round % 3 == 0   ? PruneRegion::cube(inside, half)
                              : round % 3 == 1 ? PruneRegion::ball(inside, half)
                                               : PruneRegion::column(inside, 0.4 * half, half);
    if (!prune(sweeps, inner, inner.radius + band + 1e-9, band, large, small)) continue;
    PointColumns points{};
    points.count = 16;
    for (std::size_t k = 0; k < points.count; ++k) {
      Vec3 o{r(-1, 1), r(-1, 1), r(-1, 1)};
      if (k < 8) o = {k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0};
      if (!inner.box && dot(o, o) > 1) o = normalized(o);
      const Vec3 p = inner.center + Vec3{inner.half * o.x, inner.half * o.y, inner.tall * o.z};
      points.x[k] = p.x, points.y[k] = p.y, points.z[k] = p.z, points.least[k] = INFINITY;
    }
    least_distances(sweeps, small, points);
    for (std::size_t k = 0; k < points.count; ++k) {
      const SweepTable::Nearest expected = of_all(sweeps, {points.x[k], points.y[k], points.z[k]});
      if (std::fabs(expected.distance) >= band) {
        ASSERT_GE(std::fabs(points.least[k]), band);
        continue;
      }
      ASSERT_EQ(expected.distance, points.least[k]) << "round " << round;
      ASSERT_EQ(expected.sweep, points.nearest[k]) << "round " << round;
    }
  }
}

// Of the polygons' sides those that decide on a stretch of rho: any points of it.
TEST(TurnTree, FacingSidesGiveTheSameBits) {
  Random r(11);
  const std::vector<Tool> tools = inserts();
  std::size_t left = 0, polygons = 0;
  for (int round = 0; round < 1500; ++round) {
    const SweepTable sweeps(turning_moves(r, 20, 10, 20), tools);
    const TurnTree& tree = sweeps.turn_tree();
    std::vector<TurnMember> members;
    for (std::uint32_t i = 0; i < sweeps.size(); ++i) append_sides(tree.turns(), i, i, members);
    const Vec3 at = somewhere(r);
    const double from = std::fabs(at.x), to = from + (round % 3 ? r(0, 0.3) : r(0, 10));
    TurnSides sides;
    std::vector<FacingMember> facing;
    for (const TurnMember& m : members) {
      facing.push_back(mrsim::facing(tree.turns(), m, from, to, at.z, sides));
      left += facing.back().count, polygons += facing.back().count > 0;
    }
    for (const TurnMember& m : members) {
      PointColumns one{};
      one.count = 8;
      for (std::size_t k = 0; k < one.count; ++k) {
        one.x[k] = k == 0 ? from : k == 1 ? to : from + r(0, 1) * (to - from);
        one.z[k] = at.z, one.least[k] = INFINITY;
      }
      PointColumns other = one;
      const auto& near = facing[static_cast<std::size_t>(&m - members.data())];
      least_of(tree.turns(), std::span(&m, 1), one);
      least_of(tree.turns(), std::span(&near, 1), sides, other);
      for (std::size_t k = 0; k < one.count; ++k)
        ASSERT_EQ(std::bit_cast<std::uint64_t>(one.least[k]),
                  std::bit_cast<std::uint64_t>(other.least[k]))
            << "round " << round;
    }
  }
  EXPECT_LT(left, 3 * polygons) << "four to six sides each: the others are left out";
}

// Packs of a small region, opened: as many sweeps as decide its points, in any list.
TEST(TurnTree, OpenedPacksGiveTheSameBits) {
  Random r(7);
  const std::vector<Tool> tools = inserts();
  int opened = 0;
  for (int round = 0; round < 1500; ++round) {
    const SweepTable sweeps(turning_moves(r, 20 + r.pick(200), 10, 20), tools);
    const Vec3 center = somewhere(r);
    const double half = r(0.01, 0.3), band = 3 * half;
    const PruneRegion region = PruneRegion::cube(center, half);
    const double reach = region.radius + band + 1e-9;
    CandidateList all, left;
    list_candidates(sweeps, sweeps.all(), center, all);
    if (!prune(sweeps, region, reach, band, all, left)) continue;
    std::vector<std::uint32_t> ids;
    for (const CandidateList::Slice& slice : left.slices())
      for (std::size_t k = 0; k < slice.count; ++k) ids.push_back(left.number(slice, k));
    const std::vector<std::uint32_t> packs = ids;
    if (!expand_turned(sweeps, region, reach, 20, ids)) {
      EXPECT_EQ(ids, packs);
      continue;
    }
    opened += ids.size() > 1;
    for (const std::uint32_t id : ids) ASSERT_LT(id, sweeps.size());
    // The list is a list like others: it can be pruned on.
    CandidateList named, again;
    list_candidates(sweeps, ids, center, named);
    ASSERT_TRUE(prune(sweeps, region, reach, band, named, again));
    PointColumns points{}, pruned{};
    points.count = 8;
    for (std::size_t k = 0; k < points.count; ++k) {
      const Vec3 p = center + half * Vec3{r(-1, 1), r(-1, 1), r(-1, 1)};
      points.x[k] = p.x, points.y[k] = p.y, points.z[k] = p.z, points.least[k] = INFINITY;
    }
    pruned = points;
    sweeps.least(ids, points);
    least_distances(sweeps, again, pruned);
    for (std::size_t k = 0; k < points.count; ++k) {
      const Vec3 p{points.x[k], points.y[k], points.z[k]};
      const SweepTable::Nearest expected = of_all(sweeps, p), alone = sweeps.nearest(ids, p);
      if (std::fabs(expected.distance) >= band) continue;
      ASSERT_EQ(expected.distance, points.least[k]) << "round " << round;
      ASSERT_EQ(expected.sweep, points.nearest[k]) << "round " << round;
      ASSERT_EQ(expected.distance, alone.distance);
      ASSERT_EQ(expected.sweep, alone.sweep);
      ASSERT_EQ(expected.distance, pruned.least[k]);
      ASSERT_EQ(expected.sweep, pruned.nearest[k]);
    }
  }
  EXPECT_GT(opened, 100);
}

// A long smooth contour asks for few of its sweeps anywhere.
TEST(TurnTree, OpenedListsHoldWhatMeetsABox) {
  std::vector<Motion> contour;
  for (int i = 0; i < 2000; ++i) {
    const auto at = [](int k) { return Vec3{10 + std::sin(0.005 * k), 0, 0.01 * k}; };
    contour.push_back(line(at(i), at(i + 1)));
  }
  const SweepTable sweeps(contour, inserts());
  const std::vector<std::uint32_t> all = sweeps.all();
  EXPECT_LE(all.size(), 2u);
  const Box3 box{{-1, -1, 3}, {1, 1, 4}};
  std::vector<std::uint32_t> expected;
  for (std::uint32_t i = 0; i < sweeps.size(); ++i) {
    const Box3 b = sweeps.bounds(i);
    if (!is_empty({max(b.lo, box.lo), min(b.hi, box.hi)})) expected.push_back(i);
  }
  EXPECT_EQ(sweeps.expanded(all, box), expected);
  Box3 whole;
  for (std::uint32_t i = 0; i < sweeps.size(); ++i) extend(whole, sweeps.bounds(i));
  EXPECT_EQ(sweeps.bounds(all[0]).lo, whole.lo);
  EXPECT_EQ(sweeps.bounds(all[0]).hi, whole.hi);
}

// Passes one below the other: about a place there are a few of each, by their outlines; by their
// bounds, as large as the insert, half of a pass.
TEST(TurnTree, MeetingListsHoldWhatReachesABox) {
  Random r(17);
  std::vector<Motion> passes;
  for (int pass = 0; pass < 40; ++pass)
    for (int i = 0; i < 200; ++i) {
      const auto at = [&](int k) {
        return Vec3{20 - 0.2 * pass + std::sin(0.05 * k), 0, 20 - 0.1 * k};
      };
      passes.push_back(line(at(i), at(i + 1)));
    }
  const SweepTable sweeps(passes, inserts());
  const std::vector<std::uint32_t> all = sweeps.all();
  std::size_t met = 0, bounded = 0;
  for (int k = 0; k < 200; ++k) {
    const Vec3 p = somewhere(r);
    const double half = r(0.01, 0.5);
    const Box3 box = inflated(Box3{p, p}, half);
    const std::vector<std::uint32_t> meeting = sweeps.meeting(all, box);
    const std::vector<std::uint32_t> expanded = sweeps.expanded(all, box);
    EXPECT_TRUE(std::includes(expanded.begin(), expanded.end(), meeting.begin(), meeting.end()));
    for (const std::uint32_t i : expanded)
      if (!std::binary_search(meeting.begin(), meeting.end(), i)) {
        EXPECT_GT(sweeps.distance(i, p), half);
      }
    met += meeting.size(), bounded += expanded.size();
  }
  EXPECT_GT(met, 0u);
  EXPECT_LT(met, bounded / 2);
}

TEST(TurnTree, EveryInstructionSetGivesTheSameBits) {
  Random r(9);
  for (int round = 0; round < 300; ++round) {
    PolygonSides sides[4];
    alignas(64) double round_of[8], plain[8], wide[8];
    for (PolygonSides& s : sides)
      for (std::size_t k = 0; k < 8; ++k) {
        const double angle = r(-4, 4);
        s.ax[k] = r(-3, 3), s.ay[k] = r(-3, 3), s.length[k] = r(0, 2);
        s.dx[k] = std::cos(angle), s.dy[k] = std::sin(angle);
      }
    for (double& v : round_of) v = r(0, 1);
    const double x = r(-4, 4), y = r(-4, 4);
    sweep_kernels(InstructionSet::scalar)->polygons(sides, 4, round_of, x, y, plain);
    for (const InstructionSet isa : {InstructionSet::avx2, InstructionSet::avx512}) {
      const SweepKernels* set = sweep_kernels(isa);
      if (set == nullptr) continue;
      set->polygons(sides, 4, round_of, x, y, wide);
      for (int k = 0; k < 8; ++k)
        ASSERT_EQ(std::bit_cast<std::uint64_t>(plain[k]), std::bit_cast<std::uint64_t>(wide[k]));
    }
  }
}

}  // namespace
}  // namespace mrsim
