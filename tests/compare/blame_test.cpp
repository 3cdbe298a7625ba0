// Planted faults: plates with slots whose faces have owners, one of them wrong.
#include "compare/distance/align.h"
#include "core/numbers/vec.h"
#include "support/mesh_asserts.h"
#include "support/slot_parts.h"
#include <mrsim/compare.h>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mrsim {
namespace {

using testing::build;
using testing::Cells;
using testing::kRight;
using testing::kTop;
using testing::slots;
using testing::texts;

Comparison judged(const Cells& part, Alignment align = Alignment::none) {
  CompareOptions options;
  options.accept = Acceptance{-0.02, 0.02};
  options.align = align;
  options.samples = 60000;
  return compare(build(part), build(slots(kRight)), options, texts());
}

TEST(Blame, TestShapeIsASolid) { testing::expect_closed_manifold(build(slots(kRight))); }

TEST(Blame, RightPartIsAccepted) {
  const Comparison c = judged(slots(kRight));
  EXPECT_TRUE(*c.accepted);
  EXPECT_EQ(c.region_count, 0u);
  EXPECT_TRUE(c.hints.empty());
  EXPECT_EQ(c.lines.size(), 7u);  // the stock and six lines
}

TEST(Blame, NamesTheLineOfAGouge) {
  std::array<float, 6> depth = kRight;
  depth[3] = 4.1f;
  const Comparison c = judged(slots(depth));
  EXPECT_FALSE(*c.accepted);
  ASSERT_EQ(c.region_count, 1u);
  const DeviationRegion& r = c.regions[0];
  EXPECT_TRUE(r.gouge);
  EXPECT_NEAR(r.worst, -0.1, 1e-5);
  ASSERT_FALSE(r.lines.empty());
  EXPECT_EQ(r.lines[0].line, 40);
  EXPECT_EQ(r.lines[0].text, "N40 G1 X1");
  EXPECT_EQ(r.lines[0].tool, "4");
  EXPECT_GT(r.lines[0].share, 0.99);
  EXPECT_NEAR(c.gouge_volume, 100 * 6 * 0.1, 0.6);
  const auto json = nlohmann::json::parse(comparison_json(c));
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["verdict"], "rejected");
  EXPECT_EQ(json["regions"][0]["lines"][0]["text"], "N40 G1 X1");
}

TEST(Blame, FloorLeftTooHighNamesItsLine) {
  std::array<float, 6> depth = kRight;
  depth[1] = 3.9f;
  const Comparison c = judged(slots(depth));
  ASSERT_EQ(c.region_count, 1u);
  EXPECT_FALSE(c.regions[0].gouge);
  EXPECT_NEAR(c.regions[0].worst, 0.1, 1e-5);
  EXPECT_EQ(c.regions[0].lines.at(0).line, 20);
  EXPECT_FALSE(c.regions[0].lines[0].beside);
}

TEST(Blame, NamesAWrongDiameterOfTheTool) {
  const Comparison c = judged(slots(kRight, 0.1f));
  EXPECT_NEAR(c.part.min, -0.1, 1e-5);
  ASSERT_GE(c.regions.size(), 6u);
  for (const DeviationRegion& r : c.regions) EXPECT_TRUE(r.gouge);
  ASSERT_FALSE(c.hints.empty());
  EXPECT_EQ(c.hints[0].code, "tool-size");
  EXPECT_NE(c.hints[0].text.find("tool 4"), std::string::npos) << c.hints[0].text;
  EXPECT_NE(c.hints[0].text.find("diameter"), std::string::npos);
}

TEST(Blame, MissingPassNamesItsNeighbours) {
  std::array<float, 6> depth = kRight;
  depth[2] = 0;
  const Comparison c = judged(slots(depth));
  ASSERT_GE(c.region_count, 1u);
  const DeviationRegion& r = c.regions[0];
  EXPECT_FALSE(r.gouge);
  EXPECT_NEAR(r.worst, 4, 1e-3);  // the nominal's floor under 4 mm of material
  EXPECT_GT(r.stock_share, 0.99);
  ASSERT_GE(r.lines.size(), 2u);
  EXPECT_TRUE(r.lines[0].beside);
  EXPECT_TRUE((r.lines[0].line == 20 && r.lines[1].line == 40) ||
              (r.lines[0].line == 40 && r.lines[1].line == 20));
  EXPECT_NEAR(c.excess_volume, 100 * 6 * 4, 10);
  EXPECT_LE(r.extent.lo.y, 35.1);
  EXPECT_GE(r.extent.hi.y, 40.9);
}

TEST(Blame, NamesAShiftedWorkOffset) {
  const Cells moved = slots(kRight, 0, 0.3f);
  const Comparison c = judged(moved);
  EXPECT_FALSE(*c.accepted);
  const auto shifted = std::find_if(c.hints.begin(), c.hints.end(),
                                    [](const auto& h) { return h.code == "part-shifted"; });
  ASSERT_NE(shifted, c.hints.end());
  EXPECT_NE(shifted->text.find("-0.300"), std::string::npos) << shifted->text;
}

TEST(Blame, ShiftOfTheWholePartVanishesWithIcp) {
  RigidTransform shift;
  shift.shift = {0.2, 0.3, -0.15};
  const TriMesh nominal = build(slots(kRight)), part = transformed(nominal, shift);
  CompareOptions options;
  options.accept = Acceptance{-0.02, 0.02};
  options.samples = 60000;
  EXPECT_FALSE(*compare(part, nominal, options, texts()).accepted);
  options.align = Alignment::icp;
  const Comparison c = compare(part, nominal, options, texts());
  EXPECT_TRUE(*c.accepted);
  EXPECT_NEAR(distance(c.transform.shift, {-0.2, -0.3, 0.15}), 0, 1e-4);
}

TEST(Blame, NamesAnArcOfTheWrongSign) {
  // A quarter of a ring on the wrong side: cells of the wanted arc stay, others are cut by line 40.
  const auto arc = [](float turn) {
    Cells g;
    for (int i = 0; i <= 60; ++i) {
      g.x.push_back(float(i));
      g.y.push_back(float(i));
    }
    const auto on = [turn](float x, float y) {
      const double r = std::hypot(x - 30, turn * (y - 30)), a = turn * (y - 30);
      return r > 10 && r < 14 && a > 0;
    };
    g.height = [on](float x, float y) { return on(x, y) ? 5.0f : kTop; };
    g.owner = [on](float x, float y) { return on(x, y) ? 3 : -1; };
    return g;
  };
  CompareOptions options;
  options.accept = Acceptance{-0.02, 0.02};
  const Comparison c = compare(build(arc(-1)), build(arc(1)), options, texts());
  EXPECT_FALSE(*c.accepted);
  ASSERT_EQ(c.region_count, 2u);
  for (const DeviationRegion& r : c.regions) {
    EXPECT_EQ(r.lines.at(0).line, 40);
    EXPECT_EQ(r.lines[0].beside, !r.gouge);
    EXPECT_NEAR(std::abs(r.worst), r.gouge ? 5 : 5, 3.1);
  }
}

TEST(Blame, BareMeshNamesNoLines) {
  TriMesh part = build(slots({4, 4, 4, 4.1f, 4, 4}));
  part.owners.clear();
  part.origin = {};
  CompareOptions options;
  options.accept = Acceptance{-0.02, 0.02};
  const Comparison c = compare(part, build(slots(kRight)), options);
  ASSERT_EQ(c.region_count, 1u);
  EXPECT_TRUE(c.regions[0].lines.empty());
}

TEST(Blame, TextIsEscapedInJunit) {
  std::array<float, 6> depth = kRight;
  depth[0] = 4.1f;
  auto lines = texts();
  lines[0][9] = "N10 (</testcase><x a=\"&\">)";
  CompareOptions options;
  options.accept = Acceptance{-0.02, 0.02};
  Comparison c = compare(build(slots(depth)), build(slots(kRight)), options, lines);
  c.part_name = "a<b>.ply";
  const std::string xml = comparison_junit(c);
  EXPECT_EQ(xml.find("</testcase><x"), std::string::npos);
  EXPECT_NE(xml.find("&lt;/testcase&gt;&lt;x a=&quot;&amp;&quot;&gt;"), std::string::npos);
  EXPECT_NE(xml.find("failures=\"2\""), std::string::npos);
  // One line as the message, all of them as its text.
  EXPECT_NE(xml.find("<failure message=\"  1. gouge"), std::string::npos);
  EXPECT_NE(xml.find("mm3\">  1. gouge"), std::string::npos);
  EXPECT_NE(comparison_text(c).find("REJECTED"), std::string::npos);
}

}  // namespace
}  // namespace mrsim
