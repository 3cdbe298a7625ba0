// Comments about tools other than plain mills and drills: router bits, discs, tapers, and shapes
// that a comment can not give.
#include "interp/comments/form_outline.h"
#include "interp/comments/tool_hint.h"
#include "interp/tool_readings.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

TEST(ToolShapes, RouterBitsAreMills) {
  expect_readings({
      {mm, "T1 6MM O-FLUTE", "endmill 6"},
      {mm, "1/8\" SINGLE FLUTE ENDMILL", "endmill 3.175"},
      {mm, "COMPRESSION BIT 1/4\"", "endmill 6.35"},
      {mm, "T2 6MM COMPRESSION", "endmill 6"},
      {inch, ".25 DOWN CUT", "endmill 6.35"},
      {mm, "CORE BOX 12MM", "ballmill 12"},
      {mm, "T1: Spherical mill D6", "ballmill 6"},
      {mm, "END MILL 10MM 35 DEG HELIX", "endmill 10"},
      {mm, "1/2\" CORE BOX BIT", "ballmill 12.7"},
      {mm, "T3 ROUND NOSE BIT R6", "ballmill 12"},
      {mm, "BULL CUTTER 12 R2", "bullmill 12, corner 2"},
      {mm, "T4 CORN CUTTER 3.175", "endmill 3.175"},
      {mm, "ENDMILL 1/4", "endmill 6.35"},
      {mm, "T1 1/4 FLAT ENDMILL", "endmill 6.35"},
      {mm, "change tool to 'end 1/4'", "endmill 6.35"},
      {mm, "TOOL 1 SIDE 1/2", "? gives the diameter 0.5 without a unit, in a program in mm"},
      {mm, "END OF PART 1/2", "-"},
      {mm, "35MM HINGE DRILL", "endmill 35"},
      {mm, "CUTTER DIAM. 8.000 RAD 4.000", "ballmill 8"},
      {mm, "CUTTER DIA 12 R 1.5", "bullmill 12, corner 1.5"},
      {mm, "5MM BRAD POINT DRILL", "endmill 5"},
      {inch, "2 = Ball Nose {0.25\"}", "ballmill 6.35"},
  });
}

// A word before MILL that makes another shape of it; all were end mills.
TEST(ToolShapes, AWordBeforeMillNamesItsShape) {
  const char* const more = "? names a kind of tool that needs more data";
  expect_readings({
      {mm, "SPHERE MILL 8", "ballmill 8"},
      {mm, "DOVE TAIL MILL D20", "? gives no angle of its flanks"},
      {mm, "DOVE-TAIL D12 60DEG LOC 5", told("DOVETAIL D12 60DEG LOC 5", 1, false).c_str()},
      {mm, "V MILL 6", "? gives no angle"},
      {mm, "V-MILL D6 90 DEG", "chamfer 6, point 90"},
      {mm, "POINTED MILL 6", "? gives no angle"},
      {mm, "TEE SLOT 20X5", "tslot 20, width 5"},
      {mm, "CONE MILL 8", more},
      {mm, "HALF ROUND MILL 6", more},
      {mm, "GEAR MILL 40", more},
  });
}

TEST(ToolShapes, AShankMayStandBeforeTheSize) {
  expect_readings({
      {mm, "1/8 SHANK 0.8MM DRILL", "drill 0.8"},
      {mm, "T1 3.175MM SHANK 0.5MM ENDMILL", "endmill 0.5"},
      {mm, "0.5MM ENDMILL 1/8 SHANK", "endmill 0.5"},
      {mm, "ENDMILL 6 SHANK 8", "endmill 6"},
      {inch, "SHANK .25 .125 2FL ENDMILL", "endmill 3.175"},
      {mm, "TOOL=1 NAME=EM10 DIA=10.0 CRAD=0.5", "bullmill 10, corner 0.5"},
      {mm, "T1 | D10 ENDMILL | LENGTH 75 | FLUTES 4 | CORNER 0.5", "bullmill 10, corner 0.5"},
      {mm, "T1 D10 CORNER 0.5 ENDMILL", "bullmill 10, corner 0.5"},
      {mm, "10MM ENDMILL CORNER 1", "endmill 10"},
      {mm, "270 DEG BALL 8MM", "lollipop 8"},
      {mm, "T1 EM D10.0 RC0.5 FL22", "bullmill 10, corner 0.5"},
  });
}

TEST(ToolShapes, ChamferMillsHaveTheirAngle) {
  expect_readings({
      {mm, "T5 CHAMF. 10MM", "chamfer 10, point 90"},
      {mm, "CHAMF. MILL 10MM 90 DEG", "chamfer 10, point 90"},
      {mm, "D10 CHAMF 45 DEG", "chamfer 10, side 45"},
      {mm, "T1 FASE 90 D10", "chamfer 10, point 90"},
      {mm, "GRATFRAESER D8 90", "chamfer 8, point 90"},
      {mm, "POSNEMALNIK 45 D10", "chamfer 10, side 45"},
      {mm, "NCA D10 90", "drill 10, point 90"},
      {mm, "T1 ABC D10 90", "? names an angle, and no kind of tool"},
      {mm, "T1 D10 90 DEG", "? names an angle, and no kind of tool"},
      {mm, "T1 V90 D12", "chamfer 12, point 90"},
      {mm, "T1 V90", "chamfer, point 90"},
      {mm, "T1 V90 ENGRAVER D6", "chamfer 6, point 90"},
      {mm, "T1 ENGRAVER V60 D6", "chamfer 6, point 60"},
      {mm, "T1 V-BIT V60 D6", "chamfer 6, point 60"},
      {mm, "POST V20", "-"},
      {mm, "60V 1/2\"", "chamfer 12.7, point 60"},
      {mm, "T1 V-60", "? gives no diameter"},
      {inch, "T6 1/2 CHMFR X 45", "chamfer 12.7, side 45"},
  });
}

TEST(ToolShapes, TipsOfChamferMillsAreRead) {
  const char* const read = "chamfer 10, point 90, tip 2";
  expect_readings({
      {mm, "CHAMFER MILL D10 90 DEG TIP D2", read},
      {mm, "CHAMFER MILL D10 90 DEG TIP D=2", read},
      {mm,
       "CHAMFER MILL D10 90 DEG TIP \xC3\x98"
       "2",
       read},
      {mm, "CHAMFER MILL D10 90 DEG TIPD 2", read},
      {mm, "CHAMFER MILL D10 90 DEG TIP-D 2", read},
      {mm, "FASENFRAESER D10 90GRAD SPITZE D2", read},
      {mm, "FASENFRAESER D10 90GRAD SPITZE \xC3\x98 2", read},
      {mm, "10MM CHAMFER 90 DEG FLAT TIP 2MM", read},
      {mm, "10MM CHAMFER 90 DEG 2MM FLAT", read},
      {mm, "CHAMFER MILL D10 90 DEG MIN DIA 2", read},
      {mm, "CHAMFER MILL 90 DEG D1=2 D2=10", "? gives no diameter"},
      {mm, "CHAMFER MILL D10 90 DEG TIP R0.2", "chamfer 10, corner 0.2, point 90"},
  });
}

TEST(ToolShapes, DovetailsHaveAngleAndHeight) {
  expect_readings({
      {mm, "DOVETAIL CUTTER D12 60 DEG LOC 5", "form 12"},
      {mm, "DOVETAIL 60DEG D12", "? gives no height of its head"},
      {mm, "DOVETAIL D12 LOC 5", "? gives no angle of its flanks"},
      {mm, "DOVETAIL D12 60 DEG LOC 12", "? gives flanks that meet below the height of its head"},
      {mm, "DOVETAIL D12 60 DEG LOC 5 R0.2",
       "? gives a corner radius, which its outline must have"},
      {mm, "SCHWALBENSCHWANZFRAESER 16X4 60 GRAD", "form 16"},
      {inch, "DOVETAIL CUTTER 1/2 DIA 45 DEG LOC .125", "form 12.7"},
  });
  Tool tool;
  std::string why;
  ASSERT_TRUE(fill_tool(read_tool_comment("DOVETAIL D12 45DEG LOC 2"), 1, false, tool, why)) << why;
  ASSERT_EQ(tool.profile.size(), 3u);
  EXPECT_NEAR(tool.profile[1].r, 6, 1e-12);
  EXPECT_NEAR(tool.profile[2].r, 4, 1e-12);
  EXPECT_NEAR(tool.profile[2].z, 2, 1e-12);
}

// Words that a later reading took for others: OUT, a count of flutes, the letters of a shape.
TEST(ToolShapes, WordsBesideASizeLeaveItAsItIs) {
  expect_readings({
      {mm, "EM 12 OUT 40", "endmill 12"},
      {inch, "DRILL .5 OUT 2.5", "drill 12.7"},
      {mm, "T1 DRILL 10 OUT OF 20", "? gives no diameter"},
      {mm, "10MM ENDMILL 30MM OUT", "endmill 10"},
      {mm, "T1 30 OUT 10MM EM", "endmill 10"},
      {mm, "CLEAN OUT 10 EM", "endmill 10"},
      {mm, "PREDRILL HOLE D10 EM", "endmill 10"},
      {inch, "1/2 EM AT PREDRILL", "endmill 12.7"},
      {inch, "1/2 4FL 1.0", "endmill 12.7"},
      {mm, "10MM 4F 22.5", "endmill 10"},
      {mm, "T1 TF D12 R2", "bullmill 12, corner 2"},
      {mm, "T1 KF D6 R3", "ballmill 6"},
      {mm, "T1 KF D6", "? names a shape, and no kind of tool"},
  });
}

// Pilot and body of ANSI B94.11M; BS 328 has others for 2, 3, 6 and 7.
TEST(ToolShapes, CentreDrillsHaveAPilotAndABody) {
  expect_readings({
      {inch, "CTR DRL #3", "form 6.35"},
      {inch, "CNTR DRILL #2", "form 4.7625"},
      {inch, "T4 NO. 4 CENTER DRILL", "form 7.9375"},
      {mm, "CENTRE DRILL #4", "form 7.9375"},
      {mm, "CENTRE DRILL #3", "? can be read as size 3 of ANSI or of BS 328, which differ"},
      {mm, "BS3 CENTRE DRILL", "form 6.35"},
      {lathe_mm, "CENTRE DRILL BS6", "form 15.875"},
      {inch, "CENTER DRILL #9", "? gives no diameter"},
      {inch, "HOLE #4 CENTER DRILL", "? gives no diameter"},
      {mm, "CENTER DRILL 3.15 X 8", "form 8"},
      {inch, "T4, CENTER DRILL, #4", "form 7.9375"},
      {inch, "#4 CENTER DRILL 1/8 DIA", "form 7.9375"},
      {inch, "#3 CENTER DRILL DIA. .1094", "form 6.35"},
      {inch, "#2 CENTER DRILL .25", "? can be read as diameter 0.25 or 0.1875 inch"},
      {mm, "T2 NO. 2 CENTER DRILL D4", "drill 4, point 60"},
      {mm, "T3 NO. 2 CENTER DRILL D4", "? can be read as diameter 4 or 0.1875 inch"},
      {inch, "CENTER DRILL FOR #4-40", "? gives no diameter"},
      {inch, "CENTER DRILL #4-40 HOLES", "? gives no diameter"},
      {inch, "CENTER DRILL FOR #8-32 TAP", "? gives no diameter"},
      {inch, "CENTER DRILL FOR #7 DRILL", "? gives no diameter"},
      {inch, "CENTER DRILL #7 HOLES", "? gives no diameter"},
      {inch, "CENTER DRILL HOLES #1 - #6", "? gives no diameter"},
      {inch, "CENTER DRILL #3 OR #4", "? gives no diameter"},
      {mm, "CENTER DRILL 6.3 X 20", "? can be read as diameter 6.3 or 20"},
      {mm, "CENTER DRILL 3.15", "drill 3.15, point 60"},
      {mm, "CENTER DRILL 3.15 X 4", "? can be read as diameter 3.15 or 4"},
      {mm, "T1 CENTER D3", "? names a shape, and no kind of tool"},
      {mm, "T1 D3 CENTRE", "? names a shape, and no kind of tool"},
      {mm, "T1 D10 CENTER CUTTING", "endmill 10"},
  });
  EXPECT_FALSE(sized_in_inches(read_tool_comment("#4 CENTER DRILL"))) << "no sign of inches";
  EXPECT_TRUE(sized_in_inches(read_tool_comment("#7 DRILL")));
  Tool tool;
  std::string why;
  ASSERT_TRUE(fill_tool(read_tool_comment("#4 CENTER DRILL"), kMmPerInch, false, tool, why));
  ASSERT_EQ(tool.profile.size(), 4U);
  EXPECT_NEAR(tool.profile[1].r, 25.4 / 16, 1e-12);
  EXPECT_NEAR(tool.profile[1].z, 25.4 / 16 / 1.6642794823505183, 1e-9) << "half of 118 degrees";
  EXPECT_NEAR(tool.profile[2].z, 25.4 / 8, 1e-12) << "the pilot is as long as it is wide";
  EXPECT_NEAR(tool.profile[3].r, 25.4 * 5 / 32, 1e-12);
  EXPECT_NEAR(tool.profile[3].z, 25.4 / 8 + 25.4 * 3 / 32 * 1.7320508075688772, 1e-9);
  const double by_number = tool.profile[2].z;
  const ToolHint by_sizes = read_tool_comment("1/8 X 5/16 CENTER DRILL");
  ASSERT_TRUE(fill_tool(by_sizes, kMmPerInch, false, tool, why));
  EXPECT_NEAR(tool.profile[2].z, by_number, 1e-12);
}

TEST(ToolShapes, ErrorsOfFormMillsShowAnOutline) {
  const auto example = [](const std::string& comment) {
    return outline_example(read_tool_comment(comment), 1);
  };
  EXPECT_EQ(example("DOVETAIL 45DEG D12"),
            "profile = [[0, 0], [6, 0], [3, 3]] where its head is 3 mm high");
  EXPECT_EQ(example("DOVETAIL D12"),
            "profile = [[0, 0], [6, 0], [2.99778, 5.2]] where its head is "
            "5.2 mm high and its angle 60 degrees");
  EXPECT_EQ(example("CORNER ROUNDING R3 D10"),
            "profile = [[0, 0], [2, 0, -0.41421], [5, 3]] where its tip is 4 mm wide");
  EXPECT_EQ(example("OGEE 10MM"), "");
}

TEST(ToolShapes, ThousandthsAskForTheirUnitInMm) {
  expect_readings({
      {mm, ".1875 BEM", "? gives the diameter 0.1875 without a unit, in a program in mm"},
      {mm, ".250 END MILL", "? gives the diameter 0.25 without a unit, in a program in mm"},
      {mm, "DRILL DIA .323", "? gives the diameter 0.323 without a unit, in a program in mm"},
      {mm, ".250 MM END MILL", "endmill 0.25"},
      {mm, ".250 IN END MILL", "endmill 6.35"},
      {mm, "0.250 END MILL", "endmill 0.25"},
      {mm, ".5 END MILL", "endmill 0.5"},
      {inch, ".250 END MILL", "endmill 6.35"},
      {mm, "TOOL 1 : FlatMill 6", "endmill 6"},
      {mm, "TALADRO 8.5", "drill 8.5"},
      {mm, "HARTMETALLBOHRER 8.5", "drill 8.5"},
      {mm, "IGELFRAESER D32", "endmill 32"},
  });
}

TEST(ToolShapes, TapersHaveTipAndSide) {
  expect_readings({
      {mm, "TAPERED BALL NOSE R0.5 D=6 5 DEG", "taper 6, corner 0.5, side 5, tip 1"},
      {mm, "TAPERED BALL R0.25 5.4 DEG", "taper 0.5, corner 0.25, side 5.4"},
      {mm, "TAPERED BALL 1/4\" 5 DEG", "? gives no radius of the tip"},
      {mm, "TAPERED BALL R0.25 5 DEG LOC 12", "taper 0.5, corner 0.25, side 5, flutes 12"},
      {mm, "TAPER MILL D6 5 DEG TIP 1", "taper 6, side 5, tip 1"},
      {mm, "TAPER MILL D6 10 DEG INCLUDED TIP 1", "taper 6, side 5, tip 1"},
      {mm, "TOOL/MILL,0.03, 0.00, 10.00, 45.00", "taper 0.03, side 45, flutes 10"},
      {mm, "TOOL/CHAMFER,12,90,20,6", "chamfer 12, point 90"},
      {mm, "TOOL/CHAMFER,12,45,20,6", "? gives 45 degrees, of its side or of the whole"},
      {mm, "TOOL/MILL,0.5, 0.25, 0.00, 5.00", "taper 0.5, corner 0.25, side 5"},
      {mm, "TOOL/MILL,3.17, 0.00, 9.52, 180.00", "? names a taper that is no angle of a mill"},
  });
}

TEST(ToolShapes, WhatACommentCanNotGive) {
  const char* const more = "? names a kind of tool that needs more data";
  expect_readings({
      {mm, "WINKELFRAESER D16 60GRAD", more},
      {mm, "PRISMENFRAESER D16", more},
      {mm, "T1 ANGLE CUTTER D16 60 DEG", more},
      {mm, "T2 DIAMOND DRAG 0.2MM", more},
      {mm, "DRAG KNIFE", more},
      {mm, "T3 BEADING BIT 1/4\"", more},
      {mm, "T3 ROMAN OGEE 1/2\"", more},
      {mm, "T4 UNDERCUT ENDMILL 6MM", more},
      {mm, "HOLE SAW 30MM", more},
      {mm, "T9 TREPAN 30MM", more},
      {mm, "FACEMILL 50MM KAPR45",
       "? names a face mill of 45 degrees: an endmill cuts upright walls, a taper has its angle to "
       "the axis"},
      {mm, "WP-FRAESER D50 45GRAD",
       "? names a mill of 45 degrees: an endmill cuts upright walls, a taper has its angle to the "
       "axis"},
      {mm, "T1 WIRE BRUSH 50MM", "? names no cutter"},
      {mm, "T1 STOP PIN 10MM", "? names no cutter"},
      {mm, "T1 PROBE 6MM", "? names no cutter"},
      {mm, "T5 DIAMOND 6MM", "? names a turning tool of a lathe"},
      {mm, "T6 GROOVING TOOL 3MM", "? names a grooving tool of a lathe"},
  });
}

TEST(ToolShapes, HeadsAndBladesHaveTheirWidth) {
  expect_readings({
      {mm, "T-SLOT CUTTER 20MM X 4MM", "tslot 20, width 4"},
      {mm, "T-SLOT 25 X 11 NECK 12", "tslot 25, width 11"},
      {inch, "KEYSEAT CUTTER 3/4 X 1/8 WIDE", "tslot 19.05, width 3.175"},
      {inch, "WOODRUFF 1/2 X 1/8", "tslot 12.7, width 3.175"},
      {inch, "SLITTING SAW 3.0 X .062", "tslot 76.2, width 1.5748"},
      {mm, "SCHEIBENFRAESER D50 B4", "tslot 50, width 4"},
      {mm, "T-NUTENFRAESER 20X6", "tslot 20, width 6"},
      {inch, "1/2 T-SLOT CUTTER", "? gives no width of the head"},
      {mm, "WOODRUFF 1/8 X 1/2", "tslot 12.7, width 3.175"},
      {inch, "WOODRUFF CUTTER #404", "tslot 12.7, width 3.175"},
      {mm, "KEYSEAT CUTTER NO. 606", "tslot 19.05, width 4.7625"},
      {mm, "T4 KEYSEAT 1008 CUTTER", "tslot 25.4, width 7.9375"},
      {mm, "SLOT CUTTER D50 W3", "tslot 50, width 3"},
      {mm, "SLOT CUTTER D50", "? gives no width of the head"},
      {mm, "T3 SAW 63 X 2", "tslot 63, width 2"},
      {mm, "SAW CUT 50MM LONG", "-"},
      {mm, "SAW D50 W2", "tslot 50, width 2"},
      {mm, "SLITTING SAW DIA 50 THK 2", "tslot 50, width 2"},
      {mm, "SLITTING SAW 2MM THICK 80MM DIA", "tslot 80, width 2"},
      {mm, "SLITTING SAW THICKNESS 1.6 D63", "tslot 63, width 1.6"},
      {mm, "SAEGEBLATT D63 B2", "tslot 63, width 2"},
      {mm, "T-SLOT 6 X 20", "? gives no width of the head"},
  });
}

// "10MM CRB 2FL" named no tool: a size and a count of flutes are those of an end mill.
TEST(ToolShapes, FlutesBesideASizeAreThoseOfAnEndMill) {
  expect_readings({
      {mm, "10MM CRB 2FL", "endmill 10"},
      {mm, "16MM HSS 2 FLUTE", "endmill 16"},
      {inch, "1/2 CRB 4FL", "endmill 12.7"},
      {inch, ".500 4FL CARB", "endmill 12.7"},
      {mm, "D10 4FL", "endmill 10"},
      {mm, "D10 R1 4 FLUTE", "bullmill 10, corner 1"},
      {mm, "D10 4F", "endmill 10"},
      {mm, "10MM BN 2FL", "? names a shape, and no kind of tool"},
      {lathe_mm, "10MM CRB 2FL", "? names no kind of tool"},
      {mm, "CLEARANCE 10MM Z5", "-"},
      {mm, "RAPID F5 10MM", "-"},
      {mm, "4 FLUTE", "-"},
      {mm, "6MM BALL 2FL", "ballmill 6"},
      {mm, "6MM DRILL 2FL", "drill 6"},
  });
}

// The corner behind its number was lost without a word.
TEST(ToolShapes, ACornerMayStandBehindItsRadius) {
  expect_readings({
      {inch, "3/8 EM .015 CRN RAD", "bullmill 9.525, corner 0.381"},
      {inch, "1/2 EM .03 CNR", "bullmill 12.7, corner 0.762"},
      {inch, "0.5000 DIA ENDMILL 0.030 CORNER", "bullmill 12.7, corner 0.762"},
      {mm, "10MM ENDMILL 0.5 CORNER BREAK", "endmill 10"},
      {mm, "10MM ENDMILL 4 CORNER", "endmill 10"},
  });
}

TEST(ToolShapes, NamesOfListsTellTheKind) {
  expect_readings({
      {mm, "FACINGTOOL 80", "endmill 80"},
      {mm, "STIRNFRAESER 50", "endmill 50"},
      {mm, "PREDRILL 30", "drill 30"},
      {mm, "KERNBOHRER 6.8", "drill 6.8"},
      {mm, "GEW.BOHRER M6", "endmill 6"},
      {mm, "T1 KF D6", "? names a shape, and no kind of tool"},
  });
  for (const char* list : {"STATION 12 - 10MM EM", "POT #12 10MM EM", "TL12 10MM EM"})
    EXPECT_EQ(read_tool_comment(list).id, "12") << list;
  EXPECT_EQ(read_tool_comment("T3 STATION 12 10MM EM").id, "3");
}

TEST(ToolShapes, AHyphenMayPartTheToolsNumberFromItsSize) {
  expect_readings({
      {inch, "T1-3/4 EM", "endmill 19.05"},
      {inch, "T01-1/2EM", "endmill 12.7"},
      {inch, "T1-.75 EM", "endmill 19.05"},
      {inch, "1-1/2 FACE MILL", "endmill 38.1"},
      {inch, "TOOL 1-1/2 EM", "endmill 38.1"},
  });
  EXPECT_EQ(read_tool_comment("T01-1/2EM").id, "1");
}

}  // namespace
}  // namespace mrsim
