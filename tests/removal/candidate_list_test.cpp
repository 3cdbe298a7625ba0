// Pruning drops only what never decides: checked by all sweeps at many points of the region.
#include "removal/prune/candidate_list.h"

#include "core/numbers/vec.h"
#include "removal/prune/list_candidates.h"
#include "removal/prune/prune.h"
#include "removal/prune/prune_strips.h"
#include "removal/simd/sweep_kernels.h"
#include "support/rounds.h"
#include "sweep_support.h"

#include <numeric>
#include <string>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

struct Scene {
  const char* name;
  std::vector<Tool> tools;
  bool horizontal, arcs;
  double step;           // length of a move, mm
  bool helices = false;  // and arcs in upright planes
};

std::vector<Scene> scenes() {
  Tool taper = endmill(6);
  taper.type = ToolType::taper;
  taper.taper_angle = 0.2;
  taper.tip_diameter = 2;
  Tool vee = endmill(6);
  vee.type = ToolType::chamfer;
  vee.tip_angle = 1;
  Tool blunt = vee;
  blunt.tip_diameter = 1, blunt.flute_length = 4;
  Tool slot = endmill(8);
  slot.type = ToolType::tslot;
  slot.neck_diameter = 4, slot.flute_length = 3;
  Tool lollipop = endmill(6);
  lollipop.type = ToolType::lollipop;
  lollipop.neck_diameter = 3, lollipop.flute_length = 0;
  return {
      {"slanted flat", {endmill(6)}, false, false, 0.4},
      {"slanted flat, long", {endmill(3)}, false, false, 8},
      {"slanted bull", {endmill(6, 1)}, false, false, 0.4},
      {"slanted bull, short flutes", {endmill(6, 1, 4)}, false, false, 1},
      {"slanted vee", {vee}, false, false, 0.4},
      {"slanted vee, blunt", {blunt}, false, false, 2},
      {"slanted taper", {taper}, false, false, 0.4},
      {"slanted slot", {slot}, false, false, 1},
      {"slanted lollipop", {lollipop}, false, false, 0.4},
      {"slot, arcs", {slot}, true, true, 2},
      {"lollipop, arcs", {lollipop}, true, true, 0.5},
      {"undercutting, all", {slot, lollipop, endmill(4)}, false, true, 1, true},
      {"helices, flat", {endmill(3)}, false, true, 4, true},
      {"helices, bull", {endmill(6, 1)}, false, true, 4, true},
      {"helices, vee", {vee}, false, true, 2, true},
      {"helices, all", {vee, endmill(4), taper, ballmill(5), slot, blunt}, false, true, 2, true},
      {"ball", {ballmill(6)}, false, false, 0.4},
      {"ball, long moves", {ballmill(6)}, false, false, 30},
      {"flat", {endmill(6)}, true, false, 0.4},
      {"flat, arcs", {endmill(6)}, true, true, 2},
      {"bull, arcs", {endmill(6, 1)}, true, true, 6},
      {"closed", {endmill(6, 1, 8)}, true, true, 1},
      {"taper", {taper}, true, true, 1},
      {"three tools", {ballmill(6), endmill(6), ballmill(4)}, false, true, 1}};
}

std::vector<Motion> moves(Random& r, const Scene& s, const Vec3& origin) {
  std::vector<Motion> list;
  Vec3 at = origin;
  for (int i = 0; i < 60; ++i) {
    const bool horizontal = s.horizontal || r.pick(4) == 0;
    const Vec3 to =
        at + Vec3{r(-s.step, s.step), r(-s.step, s.step), horizontal ? 0 : r(-0.5, 0.5) * s.step};
    Motion m = line(at, to);
    if (s.arcs && i % 2)
      m = arc(at, {to.x, to.y, at.z}, {0, 0, 1}, r.pick(2) ? r(-3.1, 3.1) : r(-6, 6));
    if (s.helices && i % 4 == 1) {
      const double turn = (r.pick(2) ? 1 : -1) * r(0.1, 6.2);
      m = arc(at, {to.x, to.y, at.z}, {0, 0, 1}, turn, r(-1, 1) * s.step);
    } else if (s.helices && i % 4 == 3) {
      const Vec3 axis = r.pick(2) ? Vec3{0, 1, 0} : normalized(Vec3{r(-1, 1), r(-1, 1), 0});
      const Vec3 across = cross(axis, {0, 0, 1});
      m = arc(at, at + r(-2, 2) * across + Vec3{0, 0, r(-2, 2)}, axis, r(-3.1, 3.1));
    }
    m.tool = r.pick(static_cast<int>(s.tools.size()));
    list.push_back(m);
    if (i % 9 == 0) list.push_back(m);  // coincident
    at = m.end;
    if (i % 20 == 19) at = origin + Vec3{r(-2, 2), r(-2, 2), r(-1, 1)};
    if (s.horizontal) at.z = origin.z + 0.5 * r.pick(3);
  }
  return list;
}

// The least distance and its owner of all sweeps at random points of the region and its corners.
PointColumns least_in(Random& r, const SweepTable& table, const CandidateList& all,
                      const PruneRegion& region) {
  PointColumns full{};
  full.count = 64;
  for (std::size_t k = 0; k < full.count; ++k) {
    Vec3 o{r(-1, 1), r(-1, 1), r(-1, 1)};
    if (k < 8) o = {k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0};
    if (!region.box && dot(o, o) > 1) o = normalized(o);
    const Vec3 p = region.center + Vec3{region.half * o.x, region.half * o.y, region.tall * o.z};
    full.x[k] = p.x, full.y[k] = p.y, full.z[k] = p.z, full.least[k] = INFINITY;
  }
  least_distances(table, all, full);
  // Some on the surface, between a point of the material and one of the air.
  for (std::size_t k = 56; k < full.count; ++k) {
    const std::size_t j = k - 1 - static_cast<std::size_t>(r.pick(20));
    if ((full.least[j] < 0) == (full.least[k] < 0)) continue;
    const Vec3 from{full.x[j], full.y[j], full.z[j]}, to{full.x[k], full.y[k], full.z[k]};
    const bool negative = full.least[j] < 0;
    double low = 0, high = 1;
    PointColumns one{};
    for (int step = 0; step < 24; ++step) {
      const double t = 0.5 * (low + high);
      const Vec3 p = from + t * (to - from);
      one.count = 1, one.x[0] = p.x, one.y[0] = p.y, one.z[0] = p.z, one.least[0] = INFINITY;
      least_distances(table, all, one);
      ((one.least[0] < 0) == negative ? low : high) = t;
    }
    full.x[k] = one.x[0], full.y[k] = one.y[0], full.z[k] = one.z[0];
    full.least[k] = one.least[0], full.nearest[k] = one.nearest[0];
  }
  return full;
}

// The same of a pruned list.
void expect_same(Random& r, const SweepTable& table, const CandidateList& all,
                 const CandidateList& pruned, const PruneRegion& region, double band) {
  const PointColumns full = least_in(r, table, all, region);
  PointColumns some = full;
  std::fill_n(some.least, some.count, INFINITY);
  least_distances(table, pruned, some);
  for (std::size_t k = 0; k < full.count; ++k) {
    if (std::fabs(full.least[k]) >= band) {
      ASSERT_GE(full.least[k] > 0 ? some.least[k] : -some.least[k], band);
      continue;
    }
    ASSERT_EQ(full.least[k], some.least[k]);
    ASSERT_EQ(full.nearest[k], some.nearest[k]);
  }
}

// A region of which pruning says that it is deep in a sweep.
void expect_swept(Random& r, const SweepTable& table, const CandidateList& all,
                  const PruneRegion& region, double band) {
  const PointColumns full = least_in(r, table, all, region);
  for (std::size_t k = 0; k < full.count; ++k) ASSERT_LT(full.least[k], -band);
}

TEST(CandidateList, PruningNeverChangesABit) {
  Random r(7);
  for (const Scene& scene : scenes()) {
    std::size_t before = 0, after = 0;
    for (int round = 0; round < 80; ++round) {
      const Vec3 origin =
          Vec3{r(-2, 2), r(-2, 2), r(-2, 2)} + (round % 4 == 0 ? Vec3{4000, -2500, 800} : Vec3{});
      const SweepTable table(moves(r, scene, origin), scene.tools);
      std::vector<std::uint32_t> ids(table.size());
      std::iota(ids.begin(), ids.end(), 0u);
      const Vec3 center = origin + Vec3{r(-5, 5), r(-5, 5), r(-4, 5)};
      const double half = r(0.02, 0.8), band = round % 3 == 1 ? 4e-6 : 3 * half;
      CandidateList all, large, small;
      list_candidates(table, ids, center, all);
      ASSERT_GE(all.size(), table.size());  // segments of paths
      const PruneRegion outer = PruneRegion::cube(center, 2 * half);
      if (!prune(table, outer, outer.radius + band + 1e-9, band, all, large)) {
        expect_swept(r, table, all, outer, band);
        if (HasFatalFailure()) FAIL() << scene.name << ", round " << round;
        continue;
      }
      const Vec3 inside = center + half * Vec3{r(-1, 1), r(-1, 1), r(-1, 1)};
      const PruneRegion inner = round % 3 == 0   ? PruneRegion::cube(inside, half)
                                : round % 3 == 1 ? PruneRegion::ball(inside, half)
                                                 : PruneRegion::column(inside, 0.4 * half, half);
      if (!prune(table, inner, inner.radius + band + 1e-9, band, large, small)) {
        expect_swept(r, table, all, inner, band);
        if (HasFatalFailure()) FAIL() << scene.name << ", round " << round;
        continue;
      }
      expect_same(r, table, all, small, inner, band);
      if (HasFatalFailure()) FAIL() << scene.name << ", round " << round;
      before += all.size(), after += small.size();
      if (!is_of_strips(table, large)) continue;
      for (const double beside : {half, 0.0}) {
        const std::size_t near = nearest_strips(inner, beside, large)[3];
        ASSERT_TRUE(prune_strips(table, inner, inner.radius + band + 1e-9, large, near, ids));
        CandidateList strips;
        list_candidates(table, ids, center, strips);
        expect_same(r, table, all, strips, inner, band);
      }
      EXPECT_EQ(ids.size(), small.size()) << scene.name << ", round " << round;
      if (HasFatalFailure()) FAIL() << scene.name << ", round " << round;
    }
    EXPECT_LT(after * 2, before) << scene.name << ": hardly anything was dropped";
  }
}

// Arcs that are too long to be cut into segments, beside moves that are, of mills that undercut.
TEST(CandidateList, LongArcsOfUndercuttingMillsAreMeasured) {
  Random r(17);
  Tool slot = endmill(8), lollipop = endmill(6);
  slot.type = ToolType::tslot;
  slot.neck_diameter = 4, slot.flute_length = 3;
  lollipop.type = ToolType::lollipop;
  lollipop.neck_diameter = 3, lollipop.flute_length = 0;
  for (unsigned round = 0; round < rounds(60); ++round) {
    std::vector<Motion> list;
    Vec3 at{r(-3, 3), r(-3, 3), 0};
    for (int i = 0; i < 40; ++i) {
      const Vec3 to = at + Vec3{r(-2, 2), r(-2, 2), 0};
      list.push_back(
          i % 4 == 1 ? arc(at, at + 600 * normalized(Vec3{r(-1, 1), r(-1, 1), 0}), {0, 0, 1}, 6.28)
                     : line(at, to));
      at = i % 4 == 1 ? at : to;
      if (i % 10 == 9) at = {r(-3, 3), r(-3, 3), r(-1, 1)};
    }
    const std::vector<Tool> tools{round % 2 ? slot : lollipop};
    const SweepTable table(list, tools);
    std::vector<std::uint32_t> ids(table.size());
    std::iota(ids.begin(), ids.end(), 0u);
    const Vec3 center{r(-5, 5), r(-5, 5), r(-2, 5)};
    CandidateList all, left;
    list_candidates(table, ids, center, all);
    const double half = r(0.02, 0.8), band = round % 3 == 1 ? 4e-6 : 3 * half;
    const PruneRegion region = PruneRegion::cube(center, half);
    if (prune(table, region, region.radius + band + 1e-9, band, all, left))
      expect_same(r, table, all, left, region, band);
    else
      expect_swept(r, table, all, region, band);
    if (HasFatalFailure()) FAIL() << "round " << round;
  }
}

// Short moves along smooth paths, back and forth and again: what packs are made of.
std::vector<Motion> smooth_moves(Random& r, const Scene& s, const Vec3& origin) {
  std::vector<Motion> list;
  const double bend = r.pick(2) ? r(-0.2, 0.2) : 0, slope = s.horizontal ? 0 : r(-0.3, 0.3);
  for (int row = 0; row < 12; ++row) {
    double heading = r(-0.1, 0.1) + (row % 2 ? 3.14 : 0);
    Vec3 at = origin + Vec3{row % 2 ? 3.0 : -3.0, 0.4 * (row - 6), 0.1 * r.pick(3)};
    const int tool = r.pick(static_cast<int>(s.tools.size()));
    const std::size_t first = list.size();
    for (int i = 0; i < 70; ++i) {
      heading += s.step * bend;
      const double rise = s.horizontal ? 0 : slope + 0.3 * std::sin(0.4 * i);
      const double step = s.step * (i % 30 == 0 ? 5 : 1);
      const Vec3 to = at + step * Vec3{std::cos(heading), std::sin(heading), rise};
      list.push_back(line(at, to));
      list.back().tool = tool;
      at = to;
    }
    if (row % 4 == 0) {  // once more
      const std::vector<Motion> again(list.begin() + static_cast<std::ptrdiff_t>(first),
                                      list.end());
      list.insert(list.end(), again.begin(), again.end());
    }
  }
  return list;
}

std::vector<Scene> scenes_of_packs() {
  std::vector<Scene> out{{"ball", {ballmill(6)}, false, false, 0.1},
                         {"flat", {endmill(6)}, true, false, 0.08},
                         {"bull", {endmill(6, 1)}, true, false, 0.2},
                         {"two", {endmill(6), ballmill(4)}, true, false, 0.05}};
  for (Scene& scene : scenes()) {
    const std::string name = scene.name;
    if (name.rfind("slanted", 0) != 0 || name == "slanted slot" || name == "slanted lollipop")
      continue;
    scene.step = name == "slanted flat, long" ? 0.3 : 0.1;
    out.push_back(scene);
  }
  out.push_back(
      {"slanted, all", {out[4].tools[0], out[8].tools[0], out.back().tools[0]}, false, false, 0.1});
  return out;
}

TEST(CandidateList, PacksStandForTheirSweeps) {
  Random r(11);
  for (const Scene& scene : scenes_of_packs()) {
    std::size_t sweeps = 0, packed = 0;
    for (unsigned round = 0; round < rounds(60); ++round) {
      const Vec3 origin =
          Vec3{r(-2, 2), r(-2, 2), r(-2, 2)} + (round % 4 == 0 ? Vec3{4000, -2500, 800} : Vec3{});
      const SweepTable table(smooth_moves(r, scene, origin), scene.tools);
      std::vector<std::uint32_t> ids(table.size());
      std::iota(ids.begin(), ids.end(), 0u);
      Vec3 center = origin + Vec3{r(-6, 6), r(-6, 6), r(-4, 5)};
      double half = r(0.5, 6);
      CandidateList plain, lists[7];
      list_candidates(table, ids, center, plain);
      list_candidates(table, table.all(), center, lists[0]);
      sweeps += plain.size(), packed += lists[0].size();
      const double band = r(0.1, 1), asked = round % 5 == 4 ? 0 : band;
      for (int tier = 0; tier < 6; ++tier, half /= 2) {
        PruneRegion region = round % 3 == 0   ? PruneRegion::ball(center, half)
                             : round % 3 == 1 ? PruneRegion::cube(center, half)
                                              : PruneRegion::column(center, half, 2 * half);
        region.expand_packs = tier == 5;
        if (!prune(table, region, region.radius + band + 1e-9, asked, lists[tier],
                   lists[tier + 1])) {
          expect_swept(r, table, plain, region, band);
          if (HasFatalFailure()) FAIL() << scene.name << ", round " << round;
          break;
        }
        expect_same(r, table, plain, lists[tier + 1], region, band);
        if (HasFatalFailure()) FAIL() << scene.name << ", round " << round << ", tier " << tier;
        center = center + 0.5 * half * Vec3{r(-1, 1), r(-1, 1), r(-1, 1)};
        if (!region.box) center = region.center;
      }
      for (const CandidateList::Slice& slice : lists[6].slices())
        for (std::size_t k = 0; k < slice.count; ++k)
          ASSERT_LT(lists[6].number(slice, k), table.size());
    }
    // A bend in plan tells too little of a steep tool.
    const bool bends = std::string(scene.name).rfind("slanted", 0) == 0;
    EXPECT_LT(packed * (bends ? 2 : 6), sweeps) << scene.name;
  }
}

}  // namespace
}  // namespace mrsim
