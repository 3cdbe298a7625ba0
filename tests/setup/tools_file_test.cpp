#include "setup/tools_file.h"

#include "core/numbers/units.h"
#include "core/process/memory_limit.h"
#include "support/error_code.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

// "line:column code text" of the fault in a table.
std::string fault(std::string_view text) {
  return testing::placed_fault("t.toml", [&] { parse_tools(text, "t.toml"); });
}

TEST(ToolsFile, ReadsTheWholeSchema) {
  const ToolTable table = parse_tools(R"(
units = "mm"
[[tool]]
id = "4"
type = "endmill"
diameter = 5.0
flute_length = 12
shank = [[5, 10], [6, 20.5]]
holder = [[20, 25, 30]]
[[tool]]
id = 7
type = "form"
profile = [[0, 0], [3, 3, 0.41421356], [3, 10]]
[[tool]]
id = "VNMG"
type = "turning"
insert = "VNMG"
nose_radius = 0.4
lead_angle = 93
hand = "left"
tip = 3
[offsets.D3]
radius = 5.0
wear = -0.02
[offsets."T4.D1"]
length = 100
[work.G54]
z = 50
)",
                                      "t.toml");
  ASSERT_EQ(table.tools.size(), 3u);
  EXPECT_EQ(table.tools[0].diameter, 5);
  EXPECT_EQ(table.tools[0].shank[1].length, 20.5);
  EXPECT_EQ(table.tools[0].holder[0].diameter_high, 25);
  EXPECT_EQ(table.tools[0].origin, "t.toml:3");
  EXPECT_EQ(table.tools[1].id, "7");
  EXPECT_EQ(table.tools[1].profile[1].bulge, 0.41421356);
  EXPECT_TRUE(table.tools[2].left_hand);
  EXPECT_NEAR(table.tools[2].lead_angle, radians(93), 1e-15);
  ASSERT_EQ(table.offsets.size(), 2u);
  EXPECT_EQ(table.offsets[0].name, "D3");
  EXPECT_EQ(table.offsets[0].wear, -0.02);
  EXPECT_EQ(table.offsets[1].name, "T4.D1");
  ASSERT_EQ(table.work.size(), 1u);
  EXPECT_EQ(table.work[0].shift, (Vec3{0, 0, 50}));
}

TEST(ToolsFile, InchesBecomeMillimetres) {
  const ToolTable table = parse_tools(
      "units = \"inch\"\n[[tool]]\nid = 1\ntype = \"drill\"\ndiameter = 0.5\ntip_angle = 118\n"
      "[work.G54]\nx = 1\n",
      "t.toml");
  EXPECT_EQ(table.tools[0].diameter, 12.7);
  EXPECT_NEAR(table.tools[0].tip_angle, radians(118), 1e-15);
  EXPECT_EQ(table.work[0].shift.x, 25.4);
}

TEST(ToolsFile, NamesLineAndColumn) {
  EXPECT_EQ(fault("unit = \"mm\"\n"),
            "1:1 tools-key unknown key \"unit\" in the tool table; did you mean \"units\"?");
  EXPECT_EQ(fault("[[tool]]\nid = 1\ntype = \"endmill\"\n  diametr = 5\n"),
            "4:3 tools-key unknown key \"diametr\" in a tool of type endmill; did you mean "
            "\"diameter\"?");
  EXPECT_EQ(fault("units = \"cm\"\n"), "1:9 tools-value units must be \"mm\" or \"inch\"");
  EXPECT_EQ(fault("[work.G54]\nx = \"1\"\n"), "2:5 tools-value x must be a number");
}

TEST(ToolsFile, RefusesWhatMakesNoTool) {
  EXPECT_NE(fault("[[tool]]\nid = 1\n").find("has no type"), std::string::npos);
  EXPECT_NE(fault("[[tool]]\ntype = \"endmill\"\n").find("needs a diameter"), std::string::npos);
  EXPECT_NE(fault("[[tool]]\ntype = \"endmill\"\ndiameter = -1\n").find("must be between"),
            std::string::npos);
  EXPECT_NE(fault("[[tool]]\ntype = \"endmill\"\ndiameter = nan\n").find("must be a number"),
            std::string::npos);
  EXPECT_NE(fault("[[tool]]\ntype = \"mill\"\n").find("is unknown"), std::string::npos);
  EXPECT_NE(fault("tool = 3\n").find("must be a list"), std::string::npos);
  EXPECT_NE(fault("[tool.1]\ntype = \"drill\"\n").find("[[tool]]"), std::string::npos);
  EXPECT_NE(fault("[[tool]]\ntype = \"drill\"\ndiameter = 1\nshank = [[1]]\n").find("2 numbers"),
            std::string::npos);
  EXPECT_NE(fault("[[tool]]\nid=1\ntype=\"drill\"\ndiameter=1\n[[tool]]\nid=1\ntype=\"drill\"\n"
                  "diameter=1\n")
                .find("given twice"),
            std::string::npos);
}

// A program writes T1 or T01 and means one tool.
TEST(ToolsFile, NumbersWithZerosInFrontAreTheSame) {
  const auto two = [](const std::string& a, const std::string& b) {
    const std::string rest = "type=\"drill\"\ndiameter=1\n";
    return fault("[[tool]]\nid=" + a + "\n" + rest + "[[tool]]\nid=" + b + "\n" + rest);
  };
  EXPECT_NE(two("\"01\"", "1").find("have one number"), std::string::npos);
  EXPECT_NE(two("\"1\"", "\"001\"").find("have one number"), std::string::npos);
  EXPECT_EQ(two("\"01\"", "10"), "");
  EXPECT_EQ(two("\"01A\"", "\"1A\""), "");  // names
  EXPECT_EQ(two("0", "\"00\"").substr(0, 3), "5:1");
}

// An offset that no program can select counts for nothing.
TEST(ToolsFile, OffsetsOfNoControlAreErrors) {
  for (const std::string name : {"G99", "G53", "G60", "G0", "G54.1", "G54.2", "G54.1P0",
                                 "G54.1P301", "G504", "G600", "X", "G054", "E0", "G59.4"})
    EXPECT_EQ(fault("[work.\"" + name + "\"]\nx = 5\n").substr(0, 13), "1:7 tools-key") << name;
  for (const std::string name :
       {"G54", "G59", "G59.3", "G54.1P300", "G54.1 P2", "G154P20", "G154 P1", "G110", "G505",
        "G599", "G15H2", "G15 H200", "E48", "EXT"})
    EXPECT_EQ(fault("[work.\"" + name + "\"]\nx = 5\n"), "") << name;
}

// They count for nothing, since programs are compared in capitals.
TEST(ToolsFile, NamesInSmallLettersAreErrors) {
  for (const char* text :
       {"[work.g54]\nx = 5\n", "[work.\"\"]\nx = 5\n", "[offsets.d1]\nradius = 5\n"})
    EXPECT_NE(fault(text).find("tools-key"), std::string::npos) << text << fault(text);
  EXPECT_EQ(fault("[work.\"G54.1 P2\"]\nx = 5\n[offsets.\"Tball.D1\"]\nradius = 5\n"), "");
}

TEST(ToolsFile, AsksForTheMemoryOfALongOne) {
  std::string text;
  for (int id = 0; text.size() < 200'000; ++id)
    text += "[[tool]]\nid = " + std::to_string(id) + "\ntype = \"drill\"\ndiameter = 1\n";
  EXPECT_EQ(fault(text), "");
  const MemoryLimit limit(1);
  EXPECT_EQ(testing::error_code([&] { parse_tools(text, "t.toml"); }), "memory");
}

TEST(ToolsFile, BrokenSyntaxIsPlaced) {
  EXPECT_EQ(fault("a = = 1\n").substr(0, 2), "1:");
  EXPECT_NE(fault("[[tool]\n").find("tools-syntax"), std::string::npos);
  EXPECT_NE(fault(std::string(100000, '[')).find("tools-syntax"), std::string::npos);
}

}  // namespace
}  // namespace mrsim
