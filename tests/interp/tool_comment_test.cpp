// Tool comments as posts write them: the data of the tool, or a reason why there is none.
#include "interp/comments/tool_comment.h"

#include "core/numbers/units.h"
#include "interp/comments/tool_hint.h"

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

struct Made {
  Tool tool;
  std::string id, why;
  bool ok = false;
};

Made made(const std::string& comment, double unit = 1, bool lathe = false) {
  Made out;
  const ToolHint hint = read_tool_comment(comment);
  out.id = hint.id;
  out.ok = fill_tool(hint, unit, lathe, out.tool, out.why);
  return out;
}

struct Row {
  const char* comment;
  ToolType type;
  double diameter;
  double corner = 0;
  const char* id = "";
};

void expect_rows(const std::vector<Row>& rows, double unit) {
  for (const Row& row : rows) {
    SCOPED_TRACE(row.comment);
    const Made m = made(row.comment, unit);
    EXPECT_TRUE(m.ok) << m.why;
    EXPECT_EQ(m.tool.type, row.type);
    EXPECT_NEAR(m.tool.diameter, row.diameter, 1e-9);
    EXPECT_NEAR(m.tool.corner_radius, row.corner, 1e-9);
    EXPECT_EQ(m.id, row.id);
  }
}

using enum ToolType;

TEST(ToolComment, CommentsOfPostsInMillimetresAreRead) {
  expect_rows(
      {{"T01 10. FLAT ENDMILL", endmill, 10, 0, "1"},
       {"TOOL : END MILL D 10", endmill, 10, 0, ""},
       {" T239 | 10 FLAT ENDMILL | H239 | D239 | TOOL DIA. - 10. ", endmill, 10, 0, "239"},
       {"T1 | 12. BULL ENDMILL 2. RAD | H1 | D1 | TOOL DIA. - 12.", bullmill, 12, 2, "1"},
       {"T7|6. BALL ENDMILL|H7|D7", ballmill, 6, 0, "7"},
       {"T3 | 8.5 DRILL | H3", drill, 8.5, 0, "3"},
       {"TOOL - 1 DIA. OFF. - 41 LEN. - 1 DIA. - 12.", endmill, 12, 0, "1"},
       {"12. FLAT ENDMILL TOOL - 4 DIA. OFF. - 44 LEN. - 4 DIA. - 12.", endmill, 12, 0, "4"},
       {"T1 D=6. CR=0. - ZMIN=-2. - FLAT END MILL", endmill, 6, 0, "1"},
       {"T5 D=10. CR=0. TAPER=118deg - ZMIN=-12. - drill", drill, 10, 0, "5"},
       {"T12 D=10. CR=2. - ZMIN=-2. - bullnose end mill", bullmill, 10, 2, "12"},
       {"T2 D=8. CR=4. - ZMIN=-2. - ball end mill", ballmill, 8, 0, "2"},
       {"T4 D=50. CR=0. - ZMIN=-1. - face mill", endmill, 50, 0, "4"},
       {"T6 D=6. CR=0. - ZMIN=-9. - right hand tap", endmill, 6, 0, "6"},
       {"Tool 1: End Mill 6 mm", endmill, 6, 0, "1"},
       {"Tool: End Mill {6 mm}", endmill, 6, 0, ""},
       {"[T1: End Mill {0.25 inch}]", endmill, 6.35, 0, "1"},
       {"T2 : Ball Nose {3 mm}", ballmill, 3, 0, "2"},
       {"TOOL/MILL,3.17", endmill, 3.17, 0, ""},
       {"TOOL/MILL,6.35, 0.50, 0.000, 0.00", bullmill, 6.35, 0.5, ""},
       {"TOOL/DRILL,5,118,40", drill, 5, 0, ""},
       {"TC: 5mm Endmill", endmill, 5, 0, ""},
       {"begin operation: TC: 3 mm Drill", drill, 3, 0, ""},
       {"TC: 1/8\" Endmill", endmill, 3.175, 0, ""},
       {"No. 1: 3mm Schaftfr\xC3\xA4ser", endmill, 3, 0, "1"},
       {"Schaftfr\xC3\xA4ser 6mm", endmill, 6, 0, ""},
       {"Kugelfr\xC3\xA4ser 6mm", ballmill, 6, 0, ""},
       {"TOOL -5- MILL DIA 10.0 R0. MM", endmill, 10, 0, "5"},
       {"TOOL -6- MILL DIA 10.0 R1. MM", bullmill, 10, 1, "6"},
       {"TOOL -7- DRILL DIA 8.5 R0. MM", drill, 8.5, 0, "7"},
       {"@MKR|TOOL|number=1|type=Flat End|diameter=3.175", endmill, 3.175, 0, "1"},
       {"T1 : 10MM SLOT DRILL", endmill, 10, 0, "1"},
       {"10 MM 4 FLUTE CARBIDE ENDMILL", endmill, 10, 0, ""},
       {"T4 3 FLUTE 10MM ENDMILL", endmill, 10, 0, "4"},
       {"ENDMILL 6MM X 50MM", endmill, 6, 0, ""},
       {"END MILL D10R1", bullmill, 10, 1, ""},
       {"T2 BALLMILL D10", ballmill, 10, 0, "2"},
       {"M6X1 TAP", endmill, 6, 0, ""},
       {"TOOL DIAMETER = 10.0", endmill, 10, 0, ""},
       {"FRESA 12 MM", endmill, 12, 0, ""},
       {"FRAISE D8", endmill, 8, 0, ""},
       {"BROCA 6,5 MM", drill, 6.5, 0, ""},
       {"FRAISE DIAMETRE 10", endmill, 10, 0, ""},
       {"T4 FRAISE DIAM\xC3\x88TRE 8", endmill, 8, 0, "4"},
       {"FRESA DI\xC1METRO 6", endmill, 6, 0, ""},
       {"T1 : 3.0", endmill, 3, 0, "1"},  // CamBam
       {"Endmill Diameter: 3.175", endmill, 3.175, 0, ""},
       {"T2 D=20. CR=0. - ZMIN=-30. - BORING BAR", endmill, 20, 0, "2"},
       {"T3 BORING HEAD DIA 32.", endmill, 32, 0, "3"}},
      1);
}

// A boring bar is a turning tool on a lathe only, where its diameter says nothing.
TEST(ToolComment, ABoringBarTurnsOnALatheOnly) {
  const Made m = made("T2 D=20. - BORING BAR", 1, true);
  EXPECT_TRUE(m.ok) << m.why;
  EXPECT_EQ(m.tool.type, boring);
  EXPECT_EQ(m.tool.diameter, 0);
  EXPECT_EQ(made("T2 BORING BAR").why, "gives no diameter");
}

TEST(ToolComment, CommentsOfPostsInInchesAreRead) {
  expect_rows(
      {{"TOOL 1: .500 ROUGH EM, TUFF-KUT COOLANT", endmill, 12.7, 0, "1"},
       {"T1 | 1/4 FLAT ENDMILL | H1 ", endmill, 6.35, 0, "1"},
       {"1/2 FLAT ENDMILL TOOL - 1 DIA. OFF. - 41 LEN. - 1 DIA. - .5", endmill, 12.7, 0, "1"},
       {"TOOL 1 1/4 ENDMILL", endmill, 6.35, 0, "1"},
       {"1-1/2 FACE MILL", endmill, 38.1, 0, ""},
       {"1 1/2 FACE MILL", endmill, 38.1, 0, ""},
       {".25 INCH ENDMILL", endmill, 6.35, 0, ""},
       {"ENDMILL 0.25\"", endmill, 6.35, 0, ""},
       {"T2 D=0.375 CR=0.03 - BULLNOSE END MILL", bullmill, 9.525, 0.762, "2"},
       {"T3 1/4 IN. END MILL", endmill, 6.35, 0, "3"},
       {"6MM BALL ENDMILL", ballmill, 6, 0, ""},
       {"T1 | 1/2 FLAT ENDMILL | TOOL DIA. - .5", endmill, 12.7, 0, "1"},
       {"TOOL/MILL,.25,0,0,0", endmill, 6.35, 0, ""},
       {".201 DRILL", drill, 5.1054, 0, ""}},
      25.4);
}

TEST(ToolComment, PointedToolsHaveTheirAngles) {
  EXPECT_NEAR(degrees(made("T5 D=10. CR=0. TAPER=118deg - ZMIN=-12. - drill").tool.tip_angle), 118,
              1e-9);
  EXPECT_NEAR(degrees(made("T3 D=10. TAPER=90deg - spot drill").tool.tip_angle), 90, 1e-9);
  EXPECT_NEAR(degrees(made("T2 D=6. CR=0. TAPER=45deg - chamfer mill").tool.taper_angle), 45, 1e-9);
  const Made v = made("60 deg V-Bit 0.5\" dia");
  EXPECT_TRUE(v.ok) << v.why;
  EXPECT_EQ(v.tool.type, chamfer);
  EXPECT_NEAR(v.tool.diameter, 12.7, 1e-9);
  EXPECT_NEAR(degrees(v.tool.tip_angle), 60, 1e-9);
  EXPECT_FALSE(made("V-BIT 6 MM").ok);  // which angle?
}

TEST(ToolComment, DoubtIsSaid) {
  for (const char* text :
       {"T1 D=10 - FLAT END MILL DIA 8", "T1 10MM ENDMILL 8MM DIA", "T1 6MM ENDMILL T2 3MM DRILL",
        "T1 12. BULL ENDMILL", "T1 D=6 - DOVETAIL MILL", "T1 D=6 CR=4 - BULLNOSE END MILL",
        "T1 END MILL", "T5 D5 ENDMILL", "#7 DRILL", "NO. 7 DRILL", "T3 D=8. - FORM MILL"}) {
    const Made m = made(text);
    EXPECT_FALSE(m.ok) << text << ": " << m.tool.diameter;
    EXPECT_FALSE(m.why.empty()) << text;
  }
  EXPECT_FALSE(made("T1 | 10 FLAT ENDMILL | H1", 25.4).ok);  // 254 mm?
}

TEST(ToolComment, PartsOfWordsNameNoTool) {
  for (const char* text : {"SPINDLE TURNING CW",
                           "RETURNING TO HOME",
                           "GLOBALLY VALID",
                           "finish the pocket",
                           "POCKET 40MM DIA",
                           "DRILL",
                           "CHAMFER EDGES",
                           "ROUGH TURNING",
                           "DRILLING CYCLE",
                           "MILLING",
                           "TOOL CHANGE",
                           "THE BALLAST",
                           "GROOVE 1",
                           "DIA. OFF. - 41",
                           "H5 D5",
                           "STOCK 100 X 50 X 20 MM",
                           "DRILL 4 HOLES",
                           "THREADING PASS 2",
                           "TAP HERE",
                           "T1",
                           "TOOL 5"})
    EXPECT_FALSE(read_tool_comment(text)) << text;
}

TEST(ToolComment, CodesOfInsertsAreRead) {
  struct Insert {
    const char* comment;
    double angle, nose, edge;
  };
  const Insert rows[] = {{"CNMG 120408, 80 DEG", 80, 0.8, 12},
                         {"T0101 OD ROUGH CNMG120412-PM", 80, 1.2, 12},
                         {"OD ROUGH RIGHT - 80 DEG.  INSERT - CNMG-432", 80, 2 * 25.4 / 64, 12.895},
                         {"OD FINISH RIGHT - 35 DEG.  INSERT - VNMG-331", 35, 25.4 / 64, 16.605},
                         {"DNMG 150604", 55, 0.4, 15},
                         {"WNMG 080408", 80, 0.8, 8},
                         {"TNMG 160404", 60, 0.4, 16},
                         {"SNMG 120408", 90, 0.8, 12},
                         {"CCMT 32.51", 80, 25.4 / 64, 9.671},
                         {"TURNING TOOL 55 DEG R0.4", 55, 0.4, 16}};
  for (const Insert& row : rows) {
    SCOPED_TRACE(row.comment);
    const Made m = made(row.comment, 1, true);
    EXPECT_TRUE(m.ok) << m.why;
    EXPECT_EQ(m.tool.type, turning);
    EXPECT_NEAR(degrees(m.tool.insert_angle), row.angle, 1e-9);
    EXPECT_NEAR(m.tool.nose_radius, row.nose, 1e-9);
    EXPECT_NEAR(m.tool.edge_length, row.edge, 1e-3);
  }
  EXPECT_NEAR(made("RCMT 0803", 1, true).tool.nose_radius, 4, 1e-9);
  EXPECT_FALSE(made("CNMG 120408, 55 DEG", 1, true).ok);
  EXPECT_FALSE(made("CNMG 120408 R0.4", 1, true).ok);
  EXPECT_NE(made("CNMG 120408 / DNMG 150608", 1, true).why.find("CNMG and DNMG"),
            std::string::npos);
  EXPECT_FALSE(made("OD TURN CNMG120408 OR CNMG120404", 1, true).ok);
  EXPECT_TRUE(made("OD TURN CNMG120408 (WNMG080408)", 1, true).ok) << "the same corner";
  EXPECT_NEAR(made("GROOVING TOOL 3MM", 1, true).tool.width, 3, 1e-9);
  EXPECT_NEAR(made("T0505 3MM GROOVE", 1, true).tool.width, 3, 1e-9);
  EXPECT_NEAR(made("T0404 4MM PART OFF", 1, true).tool.width, 4, 1e-9);
  EXPECT_NE(made("T0404 4MM PARTING", 1, true).tool.origin.find("blade 4 mm wide"),
            std::string::npos);
}

TEST(ToolComment, CommentsAboutOneToolAreMerged) {
  ToolHint hint = read_tool_comment("TOOL NUMBER: 3");
  merge_hint(hint, read_tool_comment("TOOL TYPE: BALLNOSE"));
  merge_hint(hint, read_tool_comment("TOOL DIAMETER: 10"));
  Tool tool;
  std::string why;
  EXPECT_TRUE(fill_tool(hint, 1, false, tool, why)) << why;
  EXPECT_EQ(hint.id, "3");
  EXPECT_EQ(tool.type, ballmill);
  EXPECT_EQ(tool.diameter, 10);
  merge_hint(hint, read_tool_comment("TOOL DIAMETER: 12"));
  EXPECT_FALSE(fill_tool(hint, 1, false, tool, why));
}

}  // namespace
}  // namespace mrsim
