// Numbers in comments that are of the work, of registers and rotary axes, or have lost their point.
#include "interp/tool_readings.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

TEST(ToolCommentDoubts, RegistersBesideADiameterAreNoSizes) {
  expect_readings({
      {mm, "T01 FRAISE 2T D10 H1 D1", "endmill 10"},
      {mm, "T01 H1 D1 FRAISE D10", "endmill 10"},
      {mm, "T10 FRAISE D10 H10", "? gives no diameter"},
      {mm, "T10 FRAISE D12 D10 H7", "? gives no diameter"},
      {mm, "T3 ALESATORE D10 H7", "endmill 10"},
      {mm, "T3 REIBAHLE D10 H7", "endmill 10"},
      {mm, "T3 REAMER H7 D7", "? gives no diameter"},
  });
}

// Numbers of the work beside a kind that names a tool, too.
TEST(ToolCommentDoubts, SizesOfTheWorkAreNoDiameters) {
  for (const char* none :
       {"FACE MILL 0.5MM OFF TOP", "FACE MILL TOP 0.5MM", "BALL MILL 0.2MM STEPOVER",
        "END MILL 45MM BOSS", "ENDMILL POCKET 20MM", "ENDMILL 30MM POCKET",
        "ENDMILL IN 16MM COLLET", "ENDMILL HOLDER 20MM", "ENDMILL FINISH WALL 0.2MM",
        "ENDMILL 40MM LONG", "CHAMFER MILL EDGES 0.5MM", "CHAMFER MILL 0.5MM EDGE BREAK"})
    EXPECT_EQ(told(none, 1, false), "? gives no diameter") << none;
  for (const char* none :
       {"D2 TOOL STEEL", "MATERIAL: TOOL STEEL D2", "TOOL OFFSET D10", "TOOL STICK OUT 30MM",
        "TOOL MUST BE 50MM LONG", "MATERIAL 6061-T6", "DRILL THRU 20MM", "DRILL ON 50MM PCD",
        "DRILL PCD 50MM", "DRILL 20MM APART", "DRILL 50MM BOLT CIRCLE", "DRILL EVERY 15MM",
        "PECK DRILL 3MM STEP", "DRILL CHUCK 13MM", "ROUGH MILL 0.3MM STOCK",
        "REST MILL AFTER 10MM ENDMILL"})
    EXPECT_EQ(told(none, 1, false), "-") << none;
  expect_readings({
      {mm, "FINISH WALLS 10MM ENDMILL", "endmill 10"},
      {mm, "POCKET 20MM ENDMILL", "endmill 20"},
      {mm, "ROUGH TOP 50MM FACEMILL", "endmill 50"},
      {mm, "10MM ENDMILL STOCK .5", "endmill 10"},
      {mm, ".5 STOCK 10MM ENDMILL", "endmill 10"},
      {mm, "20MM CHUCK 6MM DRILL", "drill 6"},
      {mm, "DRILL 8.5MM GUHRING", "drill 8.5"},
      {mm, "FACE MILL 1MM", "? can be read as diameter 1 mm or as what the work loses"},
      {mm, "CHAMFER HOLES 0.5MM", "? can be read as diameter 0.5 mm or as what the work loses"},
      {mm, "CHAMFER MILL DIA 1", "chamfer 1, point 90"},
      {mm, "DRILL 4X 8.5MM", "? can be read as diameter 4 or as 4 places"},
      {mm, "COUNTERBORE 4X 11MM", "? can be read as diameter 4 or as 4 places"},
      {mm, "8.5 X 117 DRILL", "drill 8.5"},
      {mm, "4 X 75 DRILL", "drill 4"},
      {mm, "CENTER DRILL 2.5X6.3", "form 6.3"},
      {mm, "CENTER DRILL 3 X 50", "drill 3, point 60"},
      {mm, "DEBURR MILL 6MM 90 DEG", "chamfer 6, point 90"},
      {mm, "DEBURR MILL 6MM", "? gives no angle"},
      {inch, "1/2 OR 12MM ENDMILL", "? names two sizes"},
  });
}

// No end mill is as wide as that: the number is of a name.
TEST(ToolCommentDoubts, NumbersOfNamesAreNoDiameters) {
  expect_readings({
      {mm, "365_endmill001", "? gives the diameter 365 without a unit, in a program in mm"},
      {mm, "200 FACE MILL", "endmill 200"},
      {mm, "200 SAW 3 WIDE", "tslot 200, width 3"},
      {mm, "ENDMILL D160", "endmill 160"},
      {mm, "ENDMILL 160MM", "endmill 160"},
  });
}

TEST(ToolCommentDoubts, SizesWithAnotherSignForThePointAreDoubted) {
  expect_readings({
      {mm, "DRILL 8-5", "? can be read as size 8 or 8.5"},
      {mm, "DRILL_8-5", "? can be read as size 8 or 8.5"},
      {mm, "BOHRER 8P5", "? can be read as size 8 or 8.5"},
      {mm, "ENDMILL 10-40", "endmill 10"},
      {mm, "ENDMILL 10-4FL", "endmill 10"},
      {mm, "DRILL 8,5", "drill 8.5"},
      {inch, "TAP 10-8", told("10-8 TAP", kMmPerInch, false).c_str()},
  });
}

// The angle was left out: a drill had 118 degrees, a face mill upright walls.
TEST(ToolCommentDoubts, AnglesWithoutAWordAreDoubted) {
  constexpr const char* k90 = "? can be read as having 90 degrees: say 90 DEG";
  expect_readings({
      {mm, "DRILL D10 90", k90},
      {mm, "DRILL D10 A90", k90},
      {mm, "BOHRER D10 90", k90},
      {mm, "FACE MILL D50 45", "? can be read as having 45 degrees: say 45 DEG"},
      {mm, "DRILL D10 ANG 90", "drill 10, point 90"},
      {mm, "DRILL D10 118", "drill 10, point 118"},
      {mm, "DRILL D8 X 90", "drill 8"},
      {mm, "DRILL D8 L90", "drill 8"},
      {mm, "DRILL D90", "drill 90"},
  });
}

// A size with a unit went before the number beside the kind: these were tools of 40 and 117 mm.
TEST(ToolCommentDoubts, ALengthBesideADiameterWithoutAUnitIsDoubted) {
  expect_readings({
      {mm, "ENDMILL 10 40MM LONG", "? can be read as diameter 40 mm or 10"},
      {mm, "DRILL 8.5 117MM", "? can be read as diameter 117 mm or 8.5"},
      {mm, "DRILL 8 60MM OUT", "drill 8"},
      {mm, "10MM ENDMILL 30MM OUT OF HOLDER, 22MM FLUTE", "endmill 10"},
      {mm, "ENDMILL 3 - 10MM", "? can be read as diameter 3 or 10 mm"},
      {mm, "3 ENDMILL 10", "? can be read as diameter 3 or 10"},
      {mm, "SLOT 12 ENDMILL 8", "? can be read as diameter 12 or 8"},
      {mm, "10 ENDMILL 4 FLUTE", "endmill 10"},
      {mm, "ENDMILL 10MM 40MM LONG", "endmill 10"},
      {mm, "ENDMILL 10 40MM DEEP", "endmill 10"},
  });
}

// Numbers of screws were those of number drills.
TEST(ToolCommentDoubts, NumbersOfScrewsAreNoGauge) {
  expect_readings({
      {inch, "CENT DRL .125", "drill 3.175, point 60"},
      {inch, "SPT DRL .5", "drill 12.7, point 90"},
      {inch, "SPOT DRL 1/2", "drill 12.7, point 90"},
      {mm, "NC-BOHRER D12", "drill 12, point 90"},
      {inch, "#6 SCREW DRILL", "-"},
      {inch, "DRILL #10 HOLE", "-"},
      {inch, "#7 TAP DRILL", "drill 5.1054"},
      {inch, "CLEARANCE DRILL #7", "drill 5.1054"},
  });
}

// 1/8 inch in mm, in a program in inches.
TEST(ToolCommentDoubts, MetricSizesInAProgramInInchesAreRefused) {
  expect_readings({
      {inch, "3.175 BALL MILL",
       "? gives the diameter 3.175 without a unit, in a program in inches"},
      {inch, "T1 D=1.588 CR=0. FLAT END MILL",
       "? gives the diameter 1.588 without a unit, in a program in inches"},
      {inch, "3.175MM BALL MILL", "ballmill 3.175"},
      {inch, "1.5 END MILL", "endmill 38.1"},
      {mm, "3.175 BALL MILL", "ballmill 3.175"},
  });
}

// A point left out, or a leading zero.
TEST(ToolCommentDoubts, RadiiWithoutAPointAreDoubted) {
  expect_readings({
      {mm, "EM 12 R05", "? can be read as radius 5 or 0.5"},
      {mm, "EM 12 R0.5", "bullmill 12, corner 0.5"},
      {inch, ".03R 1/2 EM", "bullmill 12.7, corner 0.762"},
      {mm, "ENDMILL D06 R00", "endmill 6"},
      {lathe_mm, "CNMG R08", "turning, insert 80, nose 0.8"},
      {lathe_mm, "OD_35_R0.4", "turning, insert 35, nose 0.4"},
      {lathe_mm, "BUTTON TOOL 8", "? gives no radius of its round insert"},
      {lathe_mm, "PRESS GREEN BUTTON 2", "-"},
  });
}

// A behind a size is the angle of the point; alone it may be a rotary axis or a steel.
TEST(ToolCommentDoubts, ABehindASizeIsTheAngle) {
  expect_readings({
      {mm, "T3 - SPOT DRILL - D10. A120.", "drill 10, point 120"},
      {mm, "SPOTDRILL D=6 A=142", "drill 6, point 142"},
      {mm, "DRILL D8.5 A140", "drill 8.5, point 140"},
      {mm, "CHAMFER MILL D10 A45", "chamfer 10, side 45"},
      {mm, "DRILL D8.5 A30", "drill 8.5"},
      {mm, "6MM ENDMILL A90", "endmill 6"},
      {mm, "MATERIAL A36 STEEL", "-"},
      {mm, "FRAISE A SURFACER D80", "endmill 80"},
  });
}

TEST(ToolCommentDoubts, AnglesThatNoSideHasAreThePoints) {
  expect_readings({
      {mm, "T5 D=10. CR=0. TAPER=45DEG - CHAMFER MILL", "chamfer 10, side 45"},
      {mm, "T5 D=10. CR=0. TAPER=90DEG - CHAMFER MILL", "chamfer 10, point 90"},
      {mm, "T5 D=10. CR=0. TAPER=120DEG - CHAMFER MILL", "chamfer 10, point 120"},
  });
}

TEST(ToolCommentDoubts, MillsHaveManyNames) {
  expect_readings({
      {mm, "WENDEPLATTENFRAESER D32 R0.8", "bullmill 32, corner 0.8"},
      {inch, "3/4 HOGGER", "endmill 19.05"},
      {inch, "1/2 RGHR", "endmill 12.7"},
      {mm, "Bit diameter: 22mm", "endmill 22"},
  });
}

// A size and a word for a shape that is no end mill.
TEST(ToolCommentDoubts, ShapesWithoutAKindAreRefused) {
  for (const char* shape :
       {"T1 6MM TAPER 2", "T1 6MM TAPER 5 DEG", "T1 3MM CONE", "T1 20MM UNDERCUT", "T1 20MM COVE",
        "T1 20MM FORM", "T1 6MM VEE", "T1 6MM DEBURR", "T1 12MM ROUND NOSE"})
    EXPECT_TRUE(told(shape, 1, false).starts_with("? names a")) << shape << told(shape, 1, false);
  expect_readings({
      {mm, "T1 6MM BALL DEBURR", "ballmill 6"},
      {mm, "T1 6MM ENDMILL TAPER SHANK", "? names a tapered mill, whose shape it does not tell"},
      {mm, "CONE 20MM", "-"},
      {mm, "UNDERCUT D20", "-"},
  });
}

// Work that has a diameter of its own, or that other tools do: an end mill was taken to stand
// there. Words that no table has leave it the end mill, with a warning.
TEST(ToolCommentDoubts, ADiameterBesideOtherWorkIsRefused) {
  constexpr const char* kUnknown = "? names no kind of tool that is known";
  for (const char* unknown :
       {"T1 KREISTASCHE D30", "T1 BOHRUNG D30 FRAESEN", "T1 FORO D30", "T1 CAJERA CIRCULAR D30",
        "T1 ALESAGE D30", "T1 OTWOR FI 30", "T1 HELICAL BORE D30", "T1 POCKET D30", "T1 ZAPFEN D30",
        "T1 REIBEN D10", "T1 ENTGRATEN D6", "T1 SENKUNG D20"})
    EXPECT_EQ(told(unknown, 1, false), kUnknown) << unknown;
  expect_readings({
      {mm, "T1 D10", "endmill 10"},
      {mm, "T1 D=10. CR=0. ZMIN=-5.", "endmill 10"},
      {mm, "T1 SCHRUPPEN D16", "endmill 16"},
      {mm, "T1 PLANEN D63 Z5", "endmill 63"},
      {mm, "T1 D12 FINISH WALLS", "endmill 12"},
      {mm, "TOOL NUMBER 1 D12 STOCK 0.2", "endmill 12"},
      {mm, "T1 D12 COLLET ER32", "endmill 12"},
      {mm, "T1 D12 - KONTUR AUSSEN", "endmill 12"},
      {mm, "T1 D6 ADAPTIVE", "endmill 6"},
      {mm, "T1 D6 ROUGHING PASS", "endmill 6"},
      {mm, "T01 D=10 GUEHRING", "endmill 10"},
      {mm, "T1 BOHREN D8.5", kUnknown},
      {mm, "T1 PERCAGE D8", kUnknown},
      {mm, "T1 BURGHIU D8", "drill 8"},
  });
}

// The size of a tool that was ground anew, or of another in its place.
TEST(ToolCommentDoubts, SizesThatHaveChangedAreRefused) {
  for (const char* changed :
       {"T1 WAS 10MM ENDMILL NOW 12MM", "T1 12MM ENDMILL WAS 10MM", "T1 ENDMILL 10MM REGROUND 9.8",
        "T1 ENDMILL 10MM REGROUND TO 9.8", "T1 10MM ENDMILL 0.2 UNDERSIZE"})
    EXPECT_EQ(told(changed, 1, false), "? names two sizes") << changed;
  EXPECT_EQ(told("T1 10MM ENDMILL NOW IN T5 HOLDER", 1, false), "? names several tools");
  for (const char* one : {"T1 REGROUND 10MM ENDMILL", "TOOL 1 NOW 10MM ENDMILL",
                          "TOOL 1 WAS SHARPENED - 10MM ENDMILL", "T1 10MM ENDMILL REGROUND 2X",
                          "10MM ENDMILL, REST FROM LAST TOOL", "10MM ENDMILL - NEXT TOOL DRILL"})
    EXPECT_EQ(told(one, 1, false), "endmill 10") << one;
  EXPECT_EQ(told("T1 10. DIA. HELICAL END MILL", 1, false), "endmill 10");
  EXPECT_EQ(told("T1 FASFRAESER 90 GRAD D8", 1, false), "chamfer 8, point 90");
}

// Estlcam numbers what is done.
TEST(ToolCommentDoubts, NumbersOfOperationsAreNoSizes) {
  expect_readings({
      {mm, "No. 1 Engraving 1", "-"},
      {mm, "ENGRAVING 2", "-"},
      {mm, "ENGRAVING 60", told("ENGRAVING 60 DEG", 1, false).c_str()},
      {inch, "1/4 SCREW MACH DRILL", "drill 6.35"},
  });
}

// What mills cut round has a diameter of its own.
TEST(ToolCommentDoubts, DiametersOfRoundWorkAreDoubted) {
  constexpr const char* kEither = "? can be read as the diameter of the tool or of what it mills";
  expect_readings({
      {inch, "CIRCLE MILL 2.5 DIA", kEither},
      {mm, "T1 HELICAL MILL 30 DIA", kEither},
      {mm, "T1 MILL 30 DIA HOLE", "? gives no diameter"},
      {mm, "T1 MILL HOLE DIA 30", "? gives no diameter"},
      {mm, "T1 ENDMILL 30 DIA BORE", "? gives no diameter"},
      {mm, "T1 10MM ENDMILL 30 DIA BORE", "endmill 10"},
      {mm, "T1 DRILL 8 DIA HOLE", "drill 8"},
      {mm, "T1 DRILL HOLE DIA 8", "drill 8"},
      {mm, "T1 MILL DIA 30", "endmill 30"},
      {inch, "T1 .5 DIA ENDMILL, BORE POCKET", "endmill 12.7"},
  });
}

}  // namespace
}  // namespace mrsim
