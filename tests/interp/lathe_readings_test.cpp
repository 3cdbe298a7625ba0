// What mrsim makes of comments about tools of lathes.
#include "interp/tool_readings.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

TEST(LatheToolReadings, InsertsAreReadFromComments) {
  expect_readings({
      {lathe_mm, "80* ROUGH TURNING TOOL", "turning, insert 80"},
      {lathe_mm, "T0101 DREHMEISSEL 80* R0.8", "turning, insert 80, nose 0.8"},
      {lathe_mm, "80 DEG ROUGH TURNING TOOL .031 R", "turning, insert 80, nose 0.7874"},
      {lathe_mm, "tool 1: 80 deg .031TNR", "turning, insert 80, nose 0.7874"},
      {lathe_inch, "35 DEG TNR .4", "turning, insert 35, nose 0.4"},
      {lathe_inch, "80 DEG DIAMOND .031R", "turning, insert 80, nose 0.7874"},
      {lathe_inch, "OD TURN TOOL 55 DEG .0156 RAD", "turning, insert 55, nose 0.39624"},
      {lathe_inch, ".125 GROOVE TOOL .008R", "grooving, width 3.175"},
      {lathe_mm, "GROOVING TOOL 3", "grooving, width 3"},
      {lathe_mm, "TURNING TOOL PCLNR 2525 M12", "turning, insert 80"},
      {lathe_mm, "SDJCL-1212 R0.4", "turning, insert 55, nose 0.4"},
      {lathe_mm, "PCLNR2525M12 CNMG120408", "turning, insert 80, nose 0.8"},
      {lathe_mm, "STEEL 1018", "-"},
      {lathe_inch, "PARTING TOOL .118", "grooving, width 2.9972"},
      {lathe_mm, "STECHSTAHL B3", "grooving, width 3"},
      {lathe_mm, "STECHDREHER B3", "grooving, width 3"},
      {lathe_mm, "T0303 GROOVE 3MM", "grooving, width 3"},
      {lathe_inch, "T0606 .125 CUTOFF", "grooving, width 3.175"},
      {lathe_inch, "1.0 U-DRILL", "drill 25.4"},
      {lathe_mm, "T0707 M10 TAP", "endmill 10"},
      {lathe_mm, "ABSTECHER 3MM", "grooving, width 3"},
      {lathe_mm, "STECHMEISSEL 2.5", "grooving, width 2.5"},
      {lathe_mm, "GEWINDEPLATTE", "threading, insert 60"},
      {lathe_mm, "OD ROUGH R0.8 80DEG", "turning, insert 80, nose 0.8"},
      {lathe_mm, "80 DEG TURN R.8", "turning, insert 80, nose 0.8"},
      {lathe_mm, "CUTTING OFF TOOL W3", "grooving, width 3"},
      {lathe_mm, "OD FINISH 35 DEG R0.4", "turning, insert 35, nose 0.4"},
      {lathe_mm, "80 DEG ROUGH", "turning, insert 80"},
      {lathe_mm, "35 DEG PROFILE", "turning, insert 35"},
      {lathe_mm, "35 DEG PROFILE R0.4", "turning, insert 35, nose 0.4"},
      {lathe_mm, "ROUGHER CNMG 120408", "turning, insert 80, nose 0.8"},
      {lathe_mm, "REAM 10H7", "endmill 10"},
      {lathe_mm, "RCMT 10", "turning, nose 5"},
      {lathe_mm, "RNMG 43", "turning, nose 6.35"},
      {lathe_mm, "CDR 3.15", "drill 3.15, point 60"},
      {lathe_mm, "THREAD TURNING", "threading, insert 60"},
      {lathe_mm, "MGMN 300", "grooving, width 3"},
      {lathe_mm, "GROOVE MGMN250-G", "grooving, width 2.5"},
      {lathe_mm, "N123G2-0300-0004-TF", "grooving, width 3"},
      {lathe_mm, "16ER AG60", "threading, insert 60"},
      {lathe_mm, "ER16 AG60", "threading, insert 60"},
      {lathe_mm, "IR11 1.5 ISO", "threading, orientation 6, insert 60"},
      {lathe_mm, "ER16 COLLET", "-"},
      {lathe_inch, "TOP NOTCH NG-3125R", "grooving, width 3.175"},
      {lathe_inch, ".125W GROOVE TOOL", "grooving, width 3.175"},
      {lathe_inch, "CNMG 1/32", "turning, insert 80, nose 0.79375"},
      {lathe_mm, "OD THREAD 16ERAG55", "threading, insert 55"},
      {lathe_mm, "11IR 1.5 ISO", "threading, orientation 6, insert 60"},
      {lathe_mm, "16 NR 14 W", "-"},
      {lathe_mm, "16 ER 1.5 ISO", "threading, insert 60"},
      {lathe_mm, "GTN-3", "? gives no width of the blade"},
      {lathe_mm, "TDC3 W3.1", "grooving, width 3.1"},
      {mm, "THREAD MILL 16ER AG60 D20", "endmill 20"},
      {lathe_mm, "GROOVE TURNING", "? gives no width of the blade"},
      {lathe_mm, "ID ROUGH MIN. 16. DIA. - 75 DEG.  INSERT - CCMT-09-T3-08",
       "boring, insert 80, nose 0.8"},
      {lathe_mm, "DCMT-11-T304", "turning, insert 55, nose 0.4"},
      {lathe_inch, "TNMP 332", "turning, insert 60, nose 0.79375"},
      {lathe_mm, "BUTTON TOOL R4", "turning, nose 4"},
      {lathe_inch, "ROUND INSERT DIA .5", "turning, nose 6.35"},
  });
}

// Shops name inserts by what they do; a size before ROUGHER makes it a mill.
TEST(LatheToolReadings, ARougherBesideDataOfAnInsertTurns) {
  expect_readings({
      {lathe_inch, "80 DEG ROUGHER .031 R", "turning, insert 80, nose 0.7874"},
      {lathe_inch, "T0101 80 DEG OD RGHR", "turning, insert 80"},
      {lathe_inch, "T0101 CNMG 432 ROUGHER", "turning, insert 80, nose 0.79375"},
      {lathe_mm, "55 DEG FINISHER", "turning, insert 55"},
      {lathe_mm, "PROFILER 35 DEG R0.4", "turning, insert 35, nose 0.4"},
      {lathe_inch, "1/2 ROUGHER", "endmill 12.7"},
      {lathe_inch, "3/4 OD ROUGHER", "endmill 19.05"},
      {inch, "1/2 4FL ROUGHER", "endmill 12.7"},
  });
}

// A number that nothing names, of the value of a nose radius in mm or inches.
TEST(LatheToolReadings, AnUnnamedNumberOfTheSizeOfANoseIsItsRadius) {
  expect_readings({
      {lathe_mm, "80 DEG ROUGH .031", "turning, insert 80, nose 0.7874"},
      {lathe_mm, "CNMG .8", "turning, insert 80, nose 0.8"},
      {lathe_inch, "CNMG 432 .05 DOC", "turning, insert 80, nose 0.79375"},
      {lathe_mm, "CNMG 1.5", "turning, insert 80"},
      {lathe_mm, "FINISH BORE .8", "-"},
  });
}

TEST(LatheToolReadings, BladesInAnotherUnitAreDoubted) {
  expect_readings({
      {lathe_mm, "CUTOFF TOOL .118 WIDE",
       "? gives the width 0.118 of the blade without a unit, in a program in mm"},
      {lathe_inch, "CUTOFF TOOL 3 WIDE",
       "? gives the width 3 of the blade without a unit, in a program in inches"},
      {lathe_inch, "CUTOFF TOOL 3MM WIDE", "grooving, width 3"},
  });
}

// All three were cut by a sharp tooth of 60 degrees.
TEST(LatheToolReadings, ThreadsOfBluntTeethAreDoubted) {
  constexpr const char* kFlat = "? names a thread whose teeth end in no point";
  expect_readings({
      {lathe_mm, "THREADING TOOL TR20X4", kFlat},
      {lathe_mm, "16ER 5 TR", kFlat},
      {lathe_inch, "22ER 5 ACME", kFlat},
      {lathe_mm, "WHITWORTH THREADING TOOL", "threading, insert 55"},
      {lathe_mm, "BSP THREADING TOOL 55 DEG", "threading, insert 55"},
      {lathe_mm, "THREADING TOOL M20X2", "threading, insert 60"},
  });
}

// A tip that is not the usual one was left out, and radius compensation ran beside the contour.
TEST(LatheToolReadings, OrientationsThatAreNotTheUsual) {
  expect_readings({
      {lathe_mm, "CNMG 120408 TIP 3", "turning, insert 80, nose 0.8"},
      {lathe_mm, "BORING BAR CCMT 09T304 TIP DIRECTION: 2", "boring, insert 80, nose 0.4"},
      {lathe_mm, "VNMG 160404 TIP 4",
       "? says tip 4, and 3 is usual here: tip=4 or tip=3 tells which counts"},
      {lathe_mm, "GROOVING TOOL 3MM TIP #8",
       "? says tip 8, and 3 is usual here: tip=8 or tip=3 tells which counts"},
      {lathe_mm, "GROOVING TOOL 3MM RIGHT CORNER TIP 4", "grooving, width 3, orientation 4"},
      {lathe_mm, "CNMG 120408 TIP R0.8", "turning, insert 80, nose 0.8"},
      {lathe_mm, "THREADING TOOL TIP 3", "threading, insert 60"},
      {mm, "V BIT 60 DEG D6 TIP 1", told("V-BIT 60 DEG DIA 6 TIP 1", 1, false).c_str()},
  });
}

TEST(LatheToolReadings, BackTurningAsksForTheHand) {
  constexpr const char* kHand =
      "? names a tool that turns backwards, and does not say its hand, hand=left or right";
  expect_readings({
      {lathe_mm, "BACK TURN VNMG 160404", kHand},
      {lathe_mm, "BACK BORING BAR VBMT 110304", kHand},
      {lathe_mm, "BACK-BORING BAR VBMT 110304 LH", "boring, insert 35, nose 0.4"},
      {lathe_mm, "BACK-TURNING TOOL", kHand},
      {lathe_mm, "BACK TURN VNMG 160404 LH", "turning, insert 35, nose 0.4"},
  });
}

// Three letters: ANSI B212.4 leaves out the fourth of inserts without a hole.
TEST(LatheToolReadings, InsertsWithoutAHoleHaveThreeLetters) {
  expect_readings({
      {lathe_inch, "TPG 322", "turning, insert 60, nose 0.79375"},
      {lathe_inch, "OD ROUGH CNG-432", "turning, insert 80, nose 0.79375"},
      {lathe_inch, "RADIUS TOOL R.125", "? names a kind of tool that needs more data"},
  });
}

// The point of a blade that a comment names; "LEFT CORNER" was read as a left-hand tool, whose
// right corner is programmed.
TEST(LatheReadings, ACommentNamesTheCornerOfABlade) {
  constexpr const char* kUnclear =
      "? names a right side or corner, of the blade or of the groove: tip=4 says that the right "
      "corner of the blade is programmed, tip=3 the left one";
  expect_readings({
      {lathe_mm, "PARTING TOOL 3MM LEFT CORNER", "grooving, width 3, orientation 3"},
      {lathe_mm, "GROOVING TOOL 3MM RIGHT CORNER", "grooving, width 3, orientation 4"},
      {lathe_mm, "GROOVING TOOL 3MM TIP RIGHT", "grooving, width 3, orientation 4"},
      {lathe_mm, "STECHER 3MM RECHTE ECKE", "grooving, width 3, orientation 4"},
      {lathe_mm, "GROOVING TOOL 3MM CENTER OF BLADE", "grooving, width 3, orientation 8"},
      {lathe_mm, "ID GROOVING TOOL 3MM RIGHT EDGE", "grooving, width 3, orientation 1"},
      {lathe_mm, "ID GROOVING TOOL 3MM LEFT EDGE", "grooving, width 3, orientation 2"},
      {lathe_mm, "GROOVING TOOL 3MM RIGHT SIDE", kUnclear},
      {lathe_mm, "GROOVING TOOL 3MM CHAMFER RIGHT CORNER", kUnclear},
      {lathe_mm, "GROOVING TOOL 3MM CHAMFER LEFT CORNER", "grooving, width 3"},
      {lathe_mm, "GROOVING TOOL 3MM RIGHT HAND", "grooving, width 3"},
  });
}

TEST(LatheReadings, LeftIsNoHandBesideAPlace) {
  const auto hand = [](const char* comment) {
    Tool tool;
    std::string why;
    EXPECT_TRUE(fill_tool(read_tool_comment(comment), 1, true, tool, why)) << comment << why;
    return tool.left_hand;
  };
  EXPECT_TRUE(hand("VNMG 160404 LEFT HAND"));
  EXPECT_TRUE(hand("GROOVING TOOL 3MM LH"));
  EXPECT_FALSE(hand("VNMG 160404 LEFT END OF PART"));
  EXPECT_FALSE(hand("GROOVING TOOL 3MM LEFT CORNER"));
}

// Words for the inside of the work turn the point outwards.
TEST(LatheToolReadings, WordsForTheInsideMakeABoringBar) {
  expect_readings({
      {lathe_mm, "ID ROUGH CNMG 120408", "boring, insert 80, nose 0.8"},
      {lathe_mm, "BORE BAR", "boring, insert 35"},
      {lathe_mm, "BORING TURNING", "boring, insert 35"},
      {lathe_mm, "ID FINISH 16. DIA. - 80 DEG.  INSERT - CCMT 09 T3 04",
       "boring, insert 80, nose 0.4"},
      {lathe_mm, "BORING CCMT 09T304", "boring, insert 80, nose 0.4"},
      {lathe_mm, "FINISH BORE CCMT 060204", "boring, insert 80, nose 0.4"},
      {lathe_mm, "FACE AND BORE OD CNMG 120408", "turning, insert 80, nose 0.8"},
      {lathe_mm, "TURN AND BORE CNMG 120408", "turning, insert 80, nose 0.8"},
      {lathe_mm, "ID TURN CCMT 060204", "boring, insert 80, nose 0.4"},
      {lathe_mm, "T8 ID GROOVE 3MM", "grooving, width 3, orientation 2"},
      {lathe_mm, "T9 INTERNAL THREADING TOOL", "threading, orientation 6, insert 60"},
      {lathe_mm, "T9 INNENGEWINDE", "threading, orientation 6, insert 60"},
      {lathe_mm, "T9 OD THREAD", "threading, insert 60"},
      {lathe_mm, "FACE GROOVING TOOL 4MM",
       "? names a face groove, and does not say which corner of the blade is programmed"},
      {lathe_mm, "VNITRNI CCMT 09T304", "boring, insert 80, nose 0.4"},
      {lathe_mm, "NOTRANJE STRUZENJE CCMT 09T304", "boring, insert 80, nose 0.4"},
      {lathe_mm, "VYVRTAVANI CCMT 09T304", "boring, insert 80, nose 0.4"},
      {lathe_mm, "IC CAP CCMT 09T304", "boring, insert 80, nose 0.4"},
      {lathe_mm, "DIS CAP CCMT 09T304", "turning, insert 80, nose 0.4"},
      {lathe_mm, "T8 CANAL INTERNO 3MM", "grooving, width 3, orientation 2"},
      {lathe_mm, "T8 ROWEK WEWNETRZNY 3MM", "grooving, width 3, orientation 2"},
      {lathe_mm, "T9 GWINT WEWNETRZNY 1.5", "threading, orientation 6, insert 60"},
      {lathe_mm, "T8 \u5185\u5f84\u6e9d 3MM", "grooving, width 3, orientation 2"},
      {lathe_mm, "T8 \u7a81\u5207\u308a 3MM", "grooving, width 3"},
      {lathe_mm, "\u5185\u5b54 CCMT 09T304", "boring, insert 80, nose 0.4"},
      {lathe_mm, "T9 \u0432\u043d\u0443\u0442\u0440. \u0440\u0435\u0437\u044c\u0431\u0430",
       "threading, orientation 6, insert 60"},
      {lathe_mm, "NOZ DO ODCINANIA 3MM", "grooving, width 3"},
      {lathe_mm, "NOZ ZA ODREZIVANJE 3MM", "grooving, width 3"},
      {lathe_mm, "CUCHILLA TRONZADO 3MM", "grooving, width 3"},
      {lathe_mm, "ABSTECHDREHMEISSEL 3MM", "grooving, width 3"},
      {lathe_mm, "DREHMEISSEL ABSTECHEN 3MM", "grooving, width 3"},
      {lathe_mm, "CUTIT DE RETEZAT 3MM", "grooving, width 3"},
      {lathe_mm, "T9 NOZ ZA NAVOJ", "threading, insert 60"},
      {lathe_mm, "T9 VIDA KALEMI", "threading, insert 60"},
      {lathe_mm, "NOZ ZA UNUTARNJE TOKARENJE R0.4", "boring, insert 35, nose 0.4"},
      {lathe_mm, "NOZ CZOLOWY DO ROWKOW 3MM",
       "? names a face groove, and does not say which corner of the blade is programmed"},
      {lathe_mm, "STIRNSTECHEN 4MM",
       "? names a face groove, and does not say which corner of the blade is programmed"},
      {lathe_mm, "AXIALSTECHER 4MM",
       "? names a face groove, and does not say which corner of the blade is programmed"},
  });
}

// The style of a holder is its lead: SVVCN stands upright, where 93 degrees left no flank behind.
TEST(LatheToolReadings, TheStyleOfAHolderIsItsLead) {
  const auto lead = [](const char* comment) {
    Tool tool;
    std::string why;
    return fill_tool(read_tool_comment(comment), 1, true, tool, why) ? degrees(tool.lead_angle) : 0;
  };
  EXPECT_NEAR(lead("SVVCN 2525 VCMT160404"), 72.5, 1e-9);
  EXPECT_NEAR(lead("VCMT160404 SVVCN2525"), 72.5, 1e-9);
  EXPECT_NEAR(lead("SDNCN 2020 K11"), 62.5, 1e-9);
  EXPECT_NEAR(lead("PSSNR 2525 M12 SNMG120408"), 45, 1e-9);
  EXPECT_NEAR(lead("PCBNR 2525 CNMG120408"), 75, 1e-9);
  EXPECT_NEAR(lead("PCLNR 2525 CNMG120408"), 95, 1e-9);
  EXPECT_NEAR(lead("S16Q-SDQCR07"), 107.5, 1e-9);
  EXPECT_NEAR(lead("SVVCN 2525 CNMG120408"), 95, 1e-9) << "another insert's";
}

// Told of the tool by its number, without a word for what it is.
TEST(LatheToolReadings, ANumberedToolWithANoseTurns) {
  expect_readings({
      {lathe_mm, "T0101 FORMSTAHL", "? names a kind of tool that needs more data"},
      {lathe_mm, "T0101 R3", "? names no kind of tool"},
  });
  for (const char* numbered : {"T0101 R0.8", "T0101 TNR .8 TIP 3", "TOOL 1 R0.8"}) {
    const ToolHint hint = read_tool_comment(numbered);
    EXPECT_EQ(hint.operation, ToolType::turning) << numbered;
    EXPECT_DOUBLE_EQ(hint.nose_radius, 0.8) << numbered;
  }
}

}  // namespace
}  // namespace mrsim
