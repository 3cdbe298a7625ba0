// Tool libraries of other programs, each in the form that its program writes.
#include "setup/tool_library.h"

#include "core/numbers/units.h"
#include "core/process/error.h"
#include "core/text/zip.h"
#include "support/temp_folder.h"

#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

const Tool& tool(const ToolLibrary& library, const std::string& id) {
  static const Tool kNone;
  for (const LibraryTool& entry : library.tools)
    if (entry.tool.id == id) return entry.tool;
  ADD_FAILURE() << "no tool " << id;
  return kNone;
}

TEST(ToolLibrary, TablesOfLinuxCncAreRead) {
  const ToolLibrary l = parse_library(
      "; my tools\nT1 P1 D6.000 Z-51.2 ;6mm flat end mill\r\nT2 P2 D+3.0 Q0\nT12 P3 D0.8 I85 J5 "
      "Q2 "
      ";CCMT\nT7 P4\n",
      "tool.tbl");
  EXPECT_EQ(l.format, LibraryFormat::linuxcnc);
  ASSERT_EQ(l.tools.size(), 3U);
  EXPECT_EQ(tool(l, "1").diameter, 6);
  EXPECT_EQ(l.tools[0].remark, "6mm flat end mill");
  EXPECT_EQ(tool(l, "12").type, ToolType::turning);
  EXPECT_EQ(tool(l, "12").tip, 3) << "towards -X and -Z";
  EXPECT_EQ(tool(l, "12").nose_radius, 0.4);
  ASSERT_EQ(l.skipped.size(), 1U);
  EXPECT_THROW(parse_library("T1 P1 D6\nG1 X5 end mill\n", "t.tbl"), Error);
}

// The table of LinuxCNC's simulated lathe: the nose's centre lies by (dx, dz) radii from the point,
// (1,-1) (1,1) (-1,1) (-1,-1) (0,-1) (1,0) (0,1) (-1,0), and the edges at I and J degrees from +Z.
TEST(ToolLibrary, OrientationsOfLinuxCncAreTips) {
  const ToolLibrary l = parse_library(
      "T1 P1 D0.1 I95 J155 Q1\nT2 P2 D0.1 I85 J25 Q2\nT3 P3 D0.1 I275 J335 Q3\n"
      "T4 P4 D0.1 I265 J205 Q4\nT5 P5 D0.1 I210 J150 Q5\nT6 P6 D0.1 I120 J60 Q6\n"
      "T7 P7 D0.1 I-30 J30 Q7\nT8 P8 D0.1 I240 J300 Q8\nT9 P9 D0.1 Q9\n",
      "lathe.tbl");
  const int tips[] = {4, 3, 2, 1, 5, 8, 7, 6, 9};
  for (int q = 1; q <= 9; ++q) {
    const Tool& t = tool(l, std::to_string(q));
    EXPECT_EQ(t.tip, tips[q - 1]) << q;
    EXPECT_EQ(t.tip_is_nose_centre, q == 9);
    const bool sided = q <= 4, neutral = q == 6 || q == 8;
    EXPECT_NEAR(degrees(t.insert_angle), sided || neutral ? 60 : 0, 1e-9) << q;
    EXPECT_NEAR(degrees(t.lead_angle), sided ? 95 : neutral ? 60 : 0, 1e-9) << q;
  }
}

TEST(ToolLibrary, UnitsAndShapesOfCamoticsAreRead) {
  const ToolLibrary l = parse_library(
      R"({"units":"metric","tools":{"1":{"units":"metric","shape":"cylindrical","length":20,"diameter":3},
      "2":{"units":"imperial","shape":"ballnose","length":1,"diameter":0.25},
      "3":{"units":"metric","shape":"conical","length":5,"diameter":10},
      "4":{"units":"metric","shape":"snubnose","length":5,"diameter":10,"snub_diameter":2},
      "5":{"units":"metric","shape":"spheroid","length":5,"diameter":10}},
      "workpiece":{"automatic":true},"files":["a.nc"]})",
      "p.camotics");
  EXPECT_EQ(l.format, LibraryFormat::camotics);
  EXPECT_EQ(tool(l, "1").type, ToolType::endmill);
  EXPECT_EQ(tool(l, "1").flute_length, 20);
  EXPECT_EQ(tool(l, "2").type, ToolType::ballmill);
  EXPECT_NEAR(tool(l, "2").diameter, 6.35, 1e-12);
  EXPECT_NEAR(degrees(tool(l, "3").taper_angle), 45, 1e-9);
  EXPECT_EQ(tool(l, "4").tip_diameter, 2);
  EXPECT_EQ(l.skipped.size(), 1U);
  EXPECT_EQ(parse_library(R"({"7":{"shape":"cylindrical","diameter":2}})", "t.json").tools.size(),
            1U);
}

const char* const kFusion = R"({"data":[
  {"type":"flat end mill","unit":"millimeters","description":"6mm","geometry":{"DC":6,"LB":25,"LCF":15,"SFDM":6,"RE":0},
   "post-process":{"number":1},"holder":{"unit":"millimeters","segments":[{"height":20,"lower-diameter":20,"upper-diameter":30}]}},
  {"type":"bull nose end mill","unit":"inches","geometry":{"DC":0.5,"RE":0.0625,"LCF":1},"post-process":{"number":2}},
  {"type":"drill","unit":"millimeters","geometry":{"DC":5,"SIG":140},"post-process":{"number":3}},
  {"type":"chamfer mill","unit":"millimeters","geometry":{"DC":8,"TA":45,"tip-diameter":1},"post-process":{"number":4}},
  {"type":"dovetail mill","unit":"millimeters","geometry":{"DC":8},"post-process":{"number":5}},
  {"type":"holder"}],"version":2})";

TEST(ToolLibrary, MeasuresOfFusionAreReadPlainAndZipped) {
  for (const std::string& bytes : {std::string(kFusion), detail::zip({{"tools.json", kFusion}})}) {
    const ToolLibrary l = parse_library(bytes, "lib.tools");
    EXPECT_EQ(l.format, LibraryFormat::fusion);
    ASSERT_EQ(l.tools.size(), 4U);
    EXPECT_EQ(tool(l, "1").diameter, 6);
    EXPECT_EQ(tool(l, "1").flute_length, 15);
    ASSERT_EQ(tool(l, "1").shank.size(), 1U);
    EXPECT_EQ(tool(l, "1").shank[0].length, 10);
    ASSERT_EQ(tool(l, "1").holder.size(), 1U);
    EXPECT_NEAR(tool(l, "2").corner_radius, 1.5875, 1e-12);
    EXPECT_NEAR(degrees(tool(l, "3").tip_angle), 140, 1e-9);
    EXPECT_EQ(tool(l, "4").tip_diameter, 1);
    EXPECT_EQ(l.skipped.size(), 1U);
  }
}

// The neck of a reduced shank; the taper of a face mill, whose DC is at its tip; a boring bar.
TEST(ToolLibrary, ShapesOfFusionAreRead) {
  const ToolLibrary l = parse_library(R"({"data":[
  {"type":"flat end mill","unit":"millimeters","geometry":{"DC":6,"LB":40,"LCF":10,"SFDM":6,"shoulder-diameter":5.6,"shoulder-length":30},"post-process":{"number":1}},
  {"type":"face mill","unit":"millimeters","geometry":{"DC":50,"LCF":5,"TA":45},"post-process":{"number":2}},
  {"type":"boring bar","unit":"millimeters","geometry":{"DC":20,"LCF":5},"post-process":{"number":3}},
  {"type":"tapered mill","unit":"millimeters","geometry":{"DC":1.872,"RE":1,"TA":3.8,"LCF":15},"post-process":{"number":4}}]})",
                                      "lib.json");
  ASSERT_EQ(l.tools.size(), 4U);
  const std::vector<ToolSegment>& shank = tool(l, "1").shank;
  ASSERT_EQ(shank.size(), 2U);
  EXPECT_EQ(shank[0].diameter_low, 5.6);
  EXPECT_EQ(shank[0].length, 20);
  EXPECT_EQ(shank[1].diameter_low, 6);
  EXPECT_EQ(shank[1].length, 10);
  EXPECT_EQ(tool(l, "2").type, ToolType::taper);
  EXPECT_NEAR(degrees(tool(l, "2").taper_angle), 45, 1e-9);
  EXPECT_EQ(tool(l, "3").type, ToolType::endmill);
  EXPECT_EQ(tool(l, "4").corner_radius, 1);
}

TEST(ToolLibrary, OtherTablesAreNamed) {
  const auto why = [](const char* bytes) {
    try {
      parse_library(bytes, "f");
    } catch (const Error& error) {
      return error.code() + " " + error.what();
    }
    return std::string();
  };
  for (const char* csv : {"Tool,Description,Diameter\n1,End Mill,6\n",
                          "Tool Index (tool_index);Number;Diameter\n1;1;6 mm\n"})
    EXPECT_NE(why(csv).find("tools-format f is a table of values"), std::string::npos) << why(csv);
  for (const char* program :
       {"%\nO0001\nG21\n", "(T1 D=6.)\nG21\n", "# a\nG90 G21\n", "N10 T1 M6\n"})
    EXPECT_NE(why(program).find("tools-format f is no table of tools"), std::string::npos)
        << program;
  EXPECT_NE(why("[{\"type\":\"drill\"}]").find("tools-format f is a JSON list"), std::string::npos);
  EXPECT_EQ(why("[[tool]]\nid = \"1\"\ntype = \"endmill\"\ndiameter = 5\n"), "");
  EXPECT_EQ(why("[offsets.D3]\nradius = 5\n"), "");
}

using ToolLibraryFiles = testing::TempFolderTest;

TEST_F(ToolLibraryFiles, BitsOfFreeCadAreRead) {
  const auto write = [&](const std::string& name, const std::string& text) {
    std::ofstream(path(name)) << text;
    return path(name);
  };
  write("5mm.fctb", R"({"version":2,"name":"5mm Endmill","shape":"endmill.fcstd","attribute":{},
    "parameter":{"CuttingEdgeHeight":"30.0000 mm","Diameter":"5.0000 mm","Length":"50.0000 mm","ShankDiameter":"3.0000 mm"}})");
  write(
      "v.fctb",
      R"({"shape-type":"VBit","name":"60","parameter":{"CuttingEdgeAngle":"60.0000 °","Diameter":"1/4 in","TipDiameter":"1.0 mm"}})");
  const ToolLibrary l = load_library(write(
      "lib.fctl",
      R"({"tools":[{"nr":1,"path":"5mm.fctb"},{"nr":2,"path":"v.fctb"},{"nr":3,"path":"../../../etc/passwd"}],"version":1})"));
  EXPECT_EQ(l.format, LibraryFormat::freecad);
  ASSERT_EQ(l.tools.size(), 2U);
  EXPECT_EQ(tool(l, "1").diameter, 5);
  EXPECT_EQ(tool(l, "1").shank.size(), 1U);
  EXPECT_NEAR(tool(l, "2").diameter, 6.35, 1e-12);
  EXPECT_NEAR(degrees(tool(l, "2").tip_angle), 60, 1e-9);
  EXPECT_EQ(l.skipped.size(), 1U);
  const ToolLibrary bit = load_library(path("5mm.fctb"));
  EXPECT_EQ(bit.format, LibraryFormat::freecad_bit);
  EXPECT_EQ(tool(bit, "").diameter, 5);
}

TEST(ToolLibrary, OtherFilesAreNamed) {
  for (const std::string& text :
       {std::string("{}"), std::string("{\"a\":1}"), std::string("<tools/>"), std::string(""),
        std::string("[1]"), std::string("{\"tools\":"), std::string(200, '{'),
        std::string("PK\x03\x04"),
        "{\"data\":" + std::string(100, '[') + std::string(100, ']') + "}", std::string("a\0b", 3)})
    EXPECT_THROW(parse_library(text, "x"), Error) << text;
  EXPECT_EQ(parse_library("[[tool]]\nid = 1\ntype = \"endmill\"\ndiameter = 5\n", "t.toml")
                .table.tools.size(),
            1U);
}

}  // namespace
}  // namespace mrsim
