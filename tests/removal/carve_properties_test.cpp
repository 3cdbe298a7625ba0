// The carver against the obvious one for every kind of tool and of motion, coincident moves
// included; and what holds of any two programs.
#include "carve_support.h"
#include "core/numbers/units.h"
#include "support/shapes.h"
#include "sweep_support.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

struct Kind {
  const char* name;
  Tool tool;
};

// All but form tools, whose search takes too long here off horizontal moves (docs/sweeps.md).
std::vector<Kind> kinds() {
  std::vector<Kind> all{{"flat", endmill(3)},
                        {"closed", endmill(3, 0.5, 4)},
                        {"ball", ballmill(3)},
                        {"bull", endmill(4, 1)},
                        {"chamfer", mill(ToolType::chamfer, 4)},
                        {"taper", mill(ToolType::taper, 4)},
                        {"drill", mill(ToolType::drill, 3)},
                        {"tslot", mill(ToolType::tslot, 5)},
                        {"lollipop", mill(ToolType::lollipop, 4)},
                        {"barrel", mill(ToolType::barrel, 4)},
                        {"insert", mill(ToolType::turning, 0)},
                        {"round insert", mill(ToolType::turning, 3)},
                        {"blade", mill(ToolType::grooving, 0)},
                        {"boring bar", mill(ToolType::boring, 0)}};
  const auto tool = [&](const char* name) -> Tool& {
    return std::find_if(all.begin(), all.end(),
                        [&](const Kind& k) { return name == std::string(k.name); })
        ->tool;
  };
  tool("chamfer").tip_diameter = 1;
  tool("taper").tip_diameter = 1, tool("taper").taper_angle = 0.3;
  tool("tslot").flute_length = 2, tool("tslot").neck_diameter = 2;
  tool("lollipop").neck_diameter = 1.5;
  tool("barrel").profile_radius = 12, tool("barrel").corner_radius = 0.5;
  tool("insert").insert = "D", tool("insert").nose_radius = 0.4, tool("insert").edge_length = 5;
  tool("round insert").insert = "R";
  tool("blade").width = 2, tool("blade").nose_radius = 0.2;
  tool("boring bar").insert = "C", tool("boring bar").edge_length = 4;
  return all;
}

// On a lattice of half millimetres, so that moves touch and coincide; some are there twice.
std::vector<Motion> random_scene(Random& r, bool turning, int count) {
  const auto number = [&](double lo, double hi) { return std::round(2 * r(lo, hi)) / 2; };
  const auto place = [&] {
    return turning ? Vec3{number(1, 5), 0, number(0, 6)}
                   : Vec3{number(0, 7), number(0, 7), number(1, 5)};
  };
  std::vector<Motion> list;
  Vec3 from = place();
  for (int k = 0; k < count; ++k) {
    Vec3 to = place();
    const int kind = r.pick(turning ? 3 : 6);
    if (kind == 0) to.z = from.z;
    if (kind == 1 && !turning) to = {from.x, from.y, to.z};
    Motion m = line(from, to);
    const Vec3 axis = turning || kind == 5 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    const Vec3 radius = number(1, 3) * Vec3{1, 0, 0};
    const double sweep = (r.pick(2) ? 1 : -1) * (1 + r.pick(4)) * kPi / 2;
    if (kind == 2 || kind > 3) m = arc(from, from + radius, axis, sweep, kind == 4 ? -1 : 0);
    if (m.kind == MotionKind::line && m.end == m.start) continue;
    m.line = k + 1;
    list.push_back(m);
    if (r.pick(4) == 0) list.push_back(m);
    from = r.pick(3) ? m.end : place();
    if (turning) from.y = 0;
  }
  return list;
}

StockShape stock_of(bool turning) {
  return turning ? round_stock(4.5, 0, 0, 6) : box_stock({0, 0, 0}, {7, 7, 5});
}

void expect_reference(const Kind& kind, std::uint64_t first, std::uint64_t count) {
  const bool turning = is_turning(kind.tool.type);
  const std::vector<Tool> tools{kind.tool};
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    Random r(seed);
    const std::vector<Motion> motions = random_scene(r, turning, 8);
    const StockShape shape = stock_of(turning);
    ASSERT_EQ(voxels(carve(shape, motions, tools, {.voxel = 0.8, .threads = 1})),
              reference(shape, motions, tools, 0.8))
        << kind.name << ", seed " << seed;
  }
}

class EveryKindCarved : public ::testing::TestWithParam<Kind> {};
TEST_P(EveryKindCarved, IsCarvedAsTheReferenceDoes) { expect_reference(GetParam(), 1, 4); }
const auto name_of = [](const auto& at) {
  std::string name = at.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
};
INSTANTIATE_TEST_SUITE_P(Kinds, EveryKindCarved, ::testing::ValuesIn(kinds()), name_of);

class EveryKindCarvedOften : public ::testing::TestWithParam<Kind> {};
TEST_P(EveryKindCarvedOften, IsCarvedAsTheReferenceDoes) { expect_reference(GetParam(), 100, 30); }
INSTANTIATE_TEST_SUITE_P(SlowKinds, EveryKindCarvedOften, ::testing::ValuesIn(kinds()), name_of);

// Both one after the other leave what is left of both: to the last bit, whatever the order.
TEST(CarveProperties, TwoProgramsAreTheirUnion) {
  for (const Kind& kind : kinds()) {
    const bool turning = is_turning(kind.tool.type);
    const std::vector<Tool> tools{kind.tool};
    Random r(5);
    const std::vector<Motion> a = random_scene(r, turning, 6), b = random_scene(r, turning, 6);
    std::vector<Motion> ab = a, ba = b;
    ab.insert(ab.end(), b.begin(), b.end());
    ba.insert(ba.end(), a.begin(), a.end());
    const CarvePlan options{.voxel = 1};
    const StockShape shape = stock_of(turning);
    const Stock first = carve(shape, a, tools, options), second = carve(shape, b, tools, options);
    const Stock both = carve(shape, ab, tools, options), other = carve(shape, ba, tools, options);
    for (int k = 0; k < 200; ++k) {
      const Vec3 p{r(-5, 8), r(-5, 8), r(-1, 7)};
      const double d = std::max(first.distance(p), second.distance(p));
      if (std::fabs(d) > 2) continue;  // far from the surface only the sign is kept
      ASSERT_EQ(d, both.distance(p)) << kind.name;
      ASSERT_EQ(d, other.distance(p)) << kind.name;
    }
  }
}

}  // namespace
}  // namespace mrsim
