// What mrsim makes of tool comments as shops and posts write them: sizes, threads, angles, radii.
#include "interp/tool_readings.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

TEST(ToolCommentReadings, TapsAreAsWideAsTheirThreads) {
  expect_readings({
      {mm, "M8 X 1.25 TAP", "endmill 8"},
      {mm, "M6X1 TAP", "endmill 6"},
      {mm, "T10 | M8-1.25 TAP RH | H10", "endmill 8"},
      {mm, "T10 | 8.-1.25 TAP | H10", "endmill 8"},
      {mm, "T10 | 10.0 X 1.50 TAP RH | H10", "endmill 10"},
      {mm, "TAP M5X.8", "endmill 5"},
      {mm, "M3X0,5 GEWINDEBOHRER", "endmill 3"},
      {mm, "M6 TAP 1.0 PITCH", "endmill 6"},
      {mm, "M12 GEWINDEBOHRER TIEFE 20", "endmill 12"},
      {mm, "T6 D=6. CR=0. - ZMIN=-9. - right hand tap", "endmill 6"},
      {inch, "T4 | 1/4-20 TAPRH | H4", "endmill 6.35"},
      {inch, "1/4 - 20 TAP", "endmill 6.35"},
      {inch, ".250-20 TAP", "endmill 6.35"},
      {inch, "TAP 1/4-20 UNC", "endmill 6.35"},
      {inch, "T6 - 1/2-13 UNC-2B TAP", "endmill 12.7"},
      {inch, "10-32 TAP", "endmill 4.826"},
      {inch, "#10-24 TAP", "endmill 4.826"},
      {inch, "8-32 TAP", "endmill 4.1656"},
      {inch, "4-40 SPIRAL POINT TAP", "endmill 2.8448"},
      {inch, "1-8 TAP", "endmill 25.4"},
      {inch, "T6 1/4-20 TAP .75 DEEP", "endmill 6.35"},
      {inch, "1/8 NPT TAP", "? names a pipe thread, whose size is not its diameter"},
      {inch, "1/4-20 STI TAP", "? names a thread for wire inserts, whose tap is larger"},
      {inch, "1/4-20 THREAD MILL", "? gives no diameter"},
      {inch, "THREADMILL .370 DIA 1/2-13", "endmill 9.398"},
      {mm, "GEWINDEFRAESER M8", "? gives no diameter"},
      {inch, "1/4-20 TAP DRILL", "-"},
      {mm, "TAP DRILL M8 6.8MM", "drill 6.8"},
      {mm, "BOHRER 6.8 FUER M8", "drill 6.8"},
      {mm, "M6 CLEARANCE DRILL 6.6", "drill 6.6"},
  });
}

TEST(ToolCommentReadings, NumbersAndLettersAreDiametersOfDrills) {
  expect_readings({
      {inch, "#7 DRILL", "drill 5.1054"},
      {inch, "NO. 7 DRILL", "drill 5.1054"},
      {inch, "NO.21 DRILL", "drill 4.0386"},
      {inch, "T5 | NO. 7 DRILL | H5 | TOOL DIA. - .201", "drill 5.1054"},
      {inch, "DRILL #29", "drill 3.4544"},
      {inch, ".136 (#29) DRILL", "drill 3.4544"},
      {inch, "1/4-20 TAP DRILL #7", "drill 5.1054"},
      {inch, "#7 DRILL FOR 1/4-20 TAP", "drill 5.1054"},
      {inch, "F DRILL", "drill 6.5278"},
      {inch, "T3 F DRILL", "drill 6.5278"},
      {inch, "\"F\" DRILL", "drill 6.5278"},
      {inch, "F DRILL (.257)", "drill 6.5278"},
      {inch, "LETTER Q DRILL", "drill 8.4328"},
      {inch, "DRILL LETTER F", "drill 6.5278"},
      {inch, "#7 8.5MM DRILL", "? can be read as diameter 0.201 inch or 8.5 mm"},
      {inch, "#2 CENTER DRILL", "form 4.7625"},
      {inch, "C-DRILL #3", "form 6.35"},
      {inch, "#8 SCREW CLEARANCE DRILL", "-"},
      {inch, "HOLE #1 - DRILL", "-"},
      {inch, "A DRILL", "-"},
      {inch, "2F DRILL .25", "drill 6.35"},
      {inch, "3/8 U-DRILL", "drill 9.525"},
      {mm, "#7 DRILL", "? can be read as the drill 7 of 0.201 inch, in a program in mm"},
      {mm, "F DRILL", "? can be read as the drill F of 0.257 inch, in a program in mm"},
  });
}

TEST(ToolCommentReadings, OfSizesJoinedByXTheFirstIsTheDiameter) {
  expect_readings({
      {inch, "MAFORD .25 X .75 X 2.5 ENDMILL", "endmill 6.35"},
      {mm, "12X26 EM", "endmill 12"},
      {mm, "4 X 11 X 50 Z2 FREZ", "endmill 4"},
      {inch, "1/2 X 1-1/4 X 3 4FL EM", "endmill 12.7"},
      {inch, "3/8 X 3/8 X 1 X 2-1/2 EM", "endmill 9.525"},
      {inch, "TOOL #4 .375 DIA X 1.0 LOC BALL EM", "ballmill 9.525"},
      {mm, "ENDMILL 6MM X 50MM", "endmill 6"},
      {mm, "DRILL 8.5 X 117", "drill 8.5"},
      {mm, "BALL R3 X 50", "ballmill 6"},
      {mm, "12 X R1 ENDMILL", "bullmill 12, corner 1"},
      {mm, "BULL NOSE 20 X 2", "bullmill 20, corner 2"},
      {mm, "FACE MILL 63 X 5", "endmill 63"},
      {mm, "END MILL 20 X 2", "? can be read as diameter 20 or 2"},
      {inch, "1/2 EM X .06", "? can be read as diameter 0.5 or 0.06"},
      {mm, "10MM X 3MM X 72MM EM", "? can be read as diameter 10 mm or 3 mm"},
      {inch, ".500 1.25 EM", "? can be read as diameter 1.25 or 0.5"},
      {mm, "ENDMILL 12 × 26", "endmill 12"},
  });
}

TEST(ToolCommentReadings, NumbersBelongToTheNamesBesideThem) {
  expect_readings({
      {inch, "EM 0.375 LOC 1.0", "endmill 9.525"},
      {inch, "3/8 BEM 1.0 LOC 2.5 OAL", "ballmill 9.525"},
      {inch, "1/2 DIA 4 FLUTE ENDMILL", "endmill 12.7"},
      {inch, "TOOL 1 = .5 DIA. 4 FLUTE END MILL", "endmill 12.7"},
      {inch, ".500 4 FLT E.M.", "endmill 12.7"},
      {inch, "1/4 LONG REACH EM", "endmill 6.35"},
      {inch, ".3125 5XD DRILL", "drill 7.9375"},
      {inch, "T2 | 3/8 FLAT ENDMILL | H2 | XY STOCK TO LEAVE - .02", "endmill 9.525"},
      {mm, "ENDMILL DOC 2MM D6", "endmill 6"},
      {mm, "6MM ENDMILL S3000 F500", "endmill 6"},
      {mm, "ALESOIR D10H7", "endmill 10"},
      {mm, "6H7 REAMER", "endmill 6"},
      {inch, "1/4 DRILL (4 HOLES)", "drill 6.35"},
      {inch, "DRILL (4) 1/4 HOLES", "? can be read as diameter 4 or 0.25"},
      {inch, "DRILL 1/2 DEEP", "-"},
      {mm, "T3 ENDMILL LEAVE 0.5MM", "? gives no diameter"},
      {inch, "ROUGH 1.5 POCKET WITH ENDMILL", "? gives no diameter"},
      {mm, "20MM POCKET, ENDMILL", "? gives no diameter"},
      {mm, "POCKET 20MM DEEP WITH 6MM ENDMILL", "endmill 6"},
      {mm, "FRESA D.50", "? can be read as diameter 0.5 or as D. and a number without a point"},
  });
}

TEST(ToolCommentReadings, SizesMayStandOnEitherSideOfTheKind) {
  expect_readings({
      {inch, "3 IN FACE MILL", "endmill 76.2"},
      {inch, "4 IN DIA FACE MILL", "endmill 101.6"},
      {inch, "1.5 IN. SHELL MILL", "endmill 38.1"},
      {inch, "FACE MILL 1 1/2", "endmill 38.1"},
      {inch, "TOOL #1 1/2 ENDMILL ROUGH", "endmill 12.7"},  // BobCAD
      {inch, ".375 GARR EM", "endmill 9.525"},
      {inch, "1. 1/2 ENDMILL", "endmill 12.7"},
      {mm, "TOOL=10MM_ENDMILL_4FL", "endmill 10"},
      {mm, "EM10 Z4 L75", "endmill 10"},
      {mm, "TC: 5mm Endmill001", "endmill 5"},
      {mm, "TC: Endmill001", "? gives no diameter"},
      {mm, "TOOL 1 : endmill1000:reg",
       "? gives the diameter 1000 without a unit, in a program in mm"},
      {inch, "T11 | 3.0 FACE MILL | H11", "endmill 76.2"},
  });
}

// "EM-10.0-4FL": the parts of a name; numbered names have no size.
TEST(ToolCommentReadings, HyphensMayStandBetweenThePartsOfAName) {
  expect_readings({
      {mm, "FlatMill-6", "endmill 6"},
      {mm, "EM-10.0-4FL", "endmill 10"},
      {mm, "BN-6.0", "-"},  // ball nose or bull nose
      {mm, "EM-10-R0.5", "bullmill 10, corner 0.5"},
      {mm, "BullMill-10-R1", "bullmill 10, corner 1"},
      {mm, "FLAT-6MM", "endmill 6"},
      {mm, "DRILL-8.5", "drill 8.5"},
      {inch, "DRILL-1/4", "drill 6.35"},
      {mm, "SPOTDRILL-10-90", "drill 10, point 90"},
      {mm, "SPOT-10-90", "drill 10, point 90"},
      {mm, "DRILL-8-118", "drill 8, point 118"},
      {mm, "DRILL-8-90", "-"},
      {mm, "ENDMILL-2", "? gives no diameter"},
      {mm, "ENDMILL-05", "? gives no diameter"},
      {inch, "TOOL NAME: UGT0201_001 MILL DIA=.750 LR=.0625", "bullmill 19.05, corner 1.5875"},
      {mm, "DM=9 VHM-BOHRER", "drill 9"},
      {mm, "T2 D=20. CR=0. - ZMIN=-8 - slot mill", "? gives no width of the head"},
      {mm, "T2 10MM SLOT MILL", "endmill 10"},
      {mm, "T2 SLOT MILL D20 W3", "tslot 20, width 3"},
      {mm, "T2 KEYWAY CUTTER D20 WIDTH 3", "tslot 20, width 3"},
      {mm, "T2 KEYWAY CUTTER D8", "endmill 8"},
      {mm, "T2 50MM FACE MILL TAPER 40", "? names a tapered mill, whose shape it does not tell"},
      {mm, "T2 MASCHINENREIBAHLE 10H7", "endmill 10"},
      {mm, "T2 D=50. CR=0. TAPER=45deg - ZMIN=-1. - face mill", "taper 50, side 45"},
      {inch, "TAP-1/4-20", "endmill 6.35"},
      {mm, "ENDMILL - 10", "endmill 10"},
  });
}

TEST(ToolCommentReadings, TheSmallerDiameterOfAPointedMillIsItsTip) {
  expect_readings({
      {mm, "CHAMFER MILL D10/D2", "chamfer 10, point 90, tip 2"},
      {mm, "CHAMFER D2-D10 90 DEG", "chamfer 10, point 90, tip 2"},
      {mm, "CHAMFER MILL D10 D2", "? can be read as a tip of 2 or as register D2"},
      {mm, "T3 CHAMFER MILL D10 D3", "chamfer 10, point 90"},
      {mm, "CHAMFER MILL D10 H2 D2", "chamfer 10, point 90"},
  });
}

// FRESA, FRAISE and FREZ alone are end mills; the word behind them may name another shape.
TEST(ToolCommentReadings, WordsBehindTheMillNameItsShape) {
  expect_readings({
      {mm, "FRAISE CHANFREIN 90 D10", "chamfer 10, point 90"},
      {mm, "FRESA A SMUSSARE 90 D10", "chamfer 10, point 90"},
      {mm, "FRESA BISEL D10", "chamfer 10, point 90"},
      {mm, "FRESA DE CHANFRO D10", "chamfer 10, point 90"},
      {mm, "FRESA ANGOLARE 45 D16", "? names a kind of tool that needs more data"},
      {mm, "FREZ KATOWY 45 D16", "? names a kind of tool that needs more data"},
      {mm, "FRAISE CONCAVE D10 R2", "? names a kind of tool that needs more data"},
      {mm, "VIERTELRUNDFRAESER D10 R2", "? names a kind of tool that needs more data"},
      {mm, "FRAISE 3 TAILLES D80 EP4", "tslot 80, width 4"},
      {mm, "FRAISE 2 TAILLES D10", "endmill 10"},
      {mm, "KEGELFRAESER D6 3 GRAD", "taper 6, side 3"},
      {mm, "FRESA DE GRABAR 60 D6", "chamfer 6, point 60"},
      {mm, "PLAT 2", "endmill 2"},
      {mm, "VINGERFREES 10", "endmill 10"},
      {mm, "BOLFREES R3", "ballmill 6"},
      {mm, "FR\xC3\x89ZA D10", "endmill 10"},
      {mm, "BOOR 8.5", "drill 8.5"},
      {mm, "VRT\xC3\x81K 8.5", "drill 8.5"},
  });
}

TEST(ToolCommentReadings, ReadingsThatWouldLoseAWordAreDoubted) {
  expect_readings({
      {inch, ".1875 +.0005 REAMER", "? gives no diameter"},
      {inch, "1/8 BALL 5 DEG TAPER", "? names a tapered mill, whose shape it does not tell"},
      {mm, "T12 D=3. CR=0. TAPER=2deg - flat end mill",
       "? names a tapered mill, whose shape it does not tell"},
      {inch, "1/4 SHCS COUNTERBORE", "-"},
      {inch, "3/8 SHCS CBORE .594", "endmill 15.088"},
      {inch, "1/2 CHAMFER 45", "chamfer 12.7, side 45"},
      {mm, "FRAISE DIA 12 R 1", "bullmill 12, corner 1"},
      {mm, "FRESA TONDA R3", "ballmill 6"},
      {mm, "DRILL 8.5 X 120", "drill 8.5"},
      {inch, "REAMER .251/.250", "? can be read as diameter 0.251 or 0.25"},
  });
}

TEST(ToolCommentReadings, QuotesAreNamesOrInches) {
  expect_readings({
      {mm, "T=\"CUTTER_10\" D=10 endmill", "endmill 10"},
      {mm, "TOOL : T=\"BALL_8_R4\" D1 BALL D=8", "ballmill 8"},
      {inch, "END MILL 1/2\" D.5", "endmill 12.7"},
      {inch, "1/2\" EM 3\" OAL", "endmill 12.7"},
  });
}

TEST(ToolCommentReadings, RadiiAreHalvesOrCorners) {
  expect_readings({
      {inch, ".375 BEM", "ballmill 9.525"},
      {mm, "R3 BALL", "ballmill 6"},
      {mm, "BALL NOSE 3 R", "ballmill 6"},
      {inch, "BALL NOSE 1/8 R", "ballmill 6.35"},
      {inch, "R1/8 BALL", "ballmill 6.35"},
      {mm, "10MM BALL R5 2FL", "ballmill 10"},
      {mm, "BALL D10 R2",
       "? names a ball mill, but its radius of 2 mm is less than half the diameter"},
      {mm, "KUGELFRAESER R4", "ballmill 8"},
      {inch, "1/2 RUFFER .06 CR", "bullmill 12.7, corner 1.524"},
      {inch, ".5 DIA .03 RAD 4FL EM", "bullmill 12.7, corner 0.762"},
      {inch, "1/2 EM W/ .030 RAD", "bullmill 12.7, corner 0.762"},
      {mm, "END MILL 10MM CORNER R 0.5MM", "bullmill 10, corner 0.5"},
      {mm, "BULL NOSE END MILL 10 R 2", "bullmill 10, corner 2"},
      {inch, "T8 | 1/2 BULL ENDMILL .03 RAD | H8", "bullmill 12.7, corner 0.762"},
      {mm, "D12R2", "bullmill 12, corner 2"},
      {mm, "D6R3", "ballmill 6"},
      {mm, "D10R0", "endmill 10"},
      {mm, "T1 D12R2", "bullmill 12, corner 2"},
      {mm, "T3 D20R1 L100 Z2", "bullmill 20, corner 1"},
      {mm, "TOOL : MILL_D10_R0.5", "bullmill 10, corner 0.5"},
      {mm, "T7 D=63. CR=0.8 - face mill", "bullmill 63, corner 0.8"},
  });
}

TEST(ToolCommentReadings, AnglesArePointsOrSides) {
  expect_readings({
      {inch, ".250 X 45 CHAMFER", "chamfer 6.35, side 45"},
      {inch, "CHAMFER MILL 1/2 X 45", "chamfer 12.7, side 45"},
      {inch, "1/2 X 90 SPOT", "drill 12.7, point 90"},
      {inch, "1/2-90 DEG SPOT DRILL", "drill 12.7, point 90"},
      {inch, "1/2 90 SPOT DRILL", "drill 12.7, point 90"},
      {inch, "1/2 120 DEG SPOT DRILL", "drill 12.7, point 120"},
      {inch, "1/4 135 DRILL", "drill 6.35, point 135"},
      {inch, ".25 STUB DRILL 135 SPLIT PT", "drill 6.35, point 135"},
      {mm, "T4 D6.8 DRILL 140 POINT", "drill 6.8, point 140"},
      {mm, "50MM 90 DEG FACE MILL", "endmill 50"},
      {mm, "50MM 45 DEG FACE MILL",
       "? names a face mill of 45 degrees: an endmill cuts upright walls, a taper has its angle to "
       "the axis"},
      {inch, "C-SINK 82 DEG 1/2", "chamfer 12.7, point 82"},
      {inch, "TOOL - 1  3/4 FLAT ENDMILL VIPER    DIA. OFF. - 1  LEN. - 1  DIA. - .75",
       "endmill 19.05"},
      {mm, "\u7acb\u94e3\u5200D10", "endmill 10"},
      {mm, "\u63622\u53f7\u5200: \u94bb\u5934\u03c65.5mm", "drill 5.5"},
      {mm, "\u5706\u9f3b\u5200 D16R1", "bullmill 16, corner 1"},
      {mm, "FRAISE HEMI D6", "ballmill 6"},
      {mm, "FRAISE 2 TAILLES HEMI D6", "ballmill 6"},
      {mm, "FRESA ESF. D6", "ballmill 6"},
      {mm, "FRESA BOLEADA D6", "ballmill 6"},
      {mm, "FRESA A PALLA D6", "ballmill 6"},
      {mm, "VOLLRADIUS FRAESER D6", "ballmill 6"},
      {mm, "KURESEL FREZE D6", "ballmill 6"},
      {mm, "GULOVA FREZA D6", "ballmill 6"},
      {mm, "FREZA CAP SFERIC D6", "ballmill 6"},
      {mm, "KUGELKOPFFRAESER D6", "ballmill 6"},
      {mm, "BOLKOPFREES D6", "ballmill 6"},
      {mm, "ECKRADIUSFRAESER D10 R1", "bullmill 10, corner 1"},
      {mm, "\u30a8\u30f3\u30c9\u30df\u30eb D10", "endmill 10"},
      {mm, "\uff8e\uff9e\uff70\uff99\uff74\uff9d\uff84\uff9e\uff90\uff99 R3", "ballmill 6"},
      {mm, "\u30e9\u30b8\u30a2\u30b9\u30a8\u30f3\u30c9\u30df\u30eb D10 R1",
       "bullmill 10, corner 1"},
      {mm, "\u30bb\u30f3\u30bf\u30fc\u30c9\u30ea\u30eb D3", "drill 3, point 60"},
      {mm, "\u30c9\u30ea\u30eb 6.8", "drill 6.8"},
      {mm, "\ubcfc \uc5d4\ub4dc\ubc00 D6", "ballmill 6"},
      {mm, "\ub4dc\ub9b4 6.8", "drill 6.8"},
      {mm, "\u63623\u53f7\u5200: \u6c89\u5934\u5200\u03c69mm\uff0c90\u5ea6", "chamfer 9, point 90"},
      {mm,
       "\u0424\u0420\u0415\u0417\u0410 \u043a\u043e\u043d\u0446\u0435\u0432\u0430\u044f "
       "10\u043c\u043c",
       "endmill 10"},
      {mm, "\u0421\u0432\u0435\u0440\u043b\u043e 8", "drill 8"},
      {inch, "3/4 82 DEG C'SINK", "chamfer 19.05, point 82"},
      {inch, "1/2\" X 82 C-SINK", "chamfer 12.7, point 82"},
      {inch, "3/4 COUNTERSINK",
       "? gives no angle, and countersinks of inch sizes have 82 or 90 degrees"},
      {inch, "1/4 CHAMFER TOOL 60 INCLUDED", "chamfer 6.35, point 60"},
      {inch, "1/4 60 DEG CHAMFER MILL", "? gives 60 degrees, of its side or of the whole"},
      {inch, "1/4 CHAMFER 30 DEG PER SIDE", "chamfer 6.35, side 30"},
      {mm, "90 CHAMFER MILL", "? can be read as diameter 90 or as 90 degrees"},
      {mm, "ANBOHRER D10/120", "drill 10, point 120"},
      {mm, "ENGRAVING CUTTER 30 DEG 0.2MM TIP", "chamfer, point 30, tip 0.2"},
      {mm, "V-BIT 60 DEG", "chamfer, point 60"},
      {mm, "CHAMFER MILL 90 DEG", "? gives no diameter"},
      {mm, "20 DEG V BIT DIA 6 TIP 0.2", "chamfer 6, point 20, tip 0.2"},
      {mm, "30 DEG 0.1MM ENGRAVING BIT", "? can be read as diameter 0.1 mm or as a tip of 0.1 mm"},
      {inch, "1/2 DRILL/MILL", "? gives no angle"},
      {inch, "1/2 DRILL MILL 90 DEG", "chamfer 12.7, point 90"},
      {inch, "T12 | 1/4 TAPER ENDMILL 3 DEG | H12", "taper 6.35, side 3"},
      {inch, "1/8 X 3 DEG TAPER EM LOC 1.0", "taper 3.175, side 3, flutes 25.4"},
  });
}

TEST(ToolCommentReadings, TwoKindsInOneCommentAreDoubted) {
  expect_readings({
      {mm, "6MM DRILL - CHAMFER EDGES", "? names more than one kind of tool"},
      {mm, "10MM ENDMILL CHAMFER EDGES", "endmill 10"},
      {mm, "10MM ENDMILL CHAMFER 45 DEG", "? names more than one kind of tool"},
      {inch, "T1 1/2 EM CHAMFER EDGES", "? names more than one kind of tool"},
      {inch, "DRILL AND TAP 1/4-20", "? names more than one kind of tool"},
      {inch, "3/8 FLAT BOTTOM DRILL", "endmill 9.525"},
      {mm, "TOOL -9- CHAMFER DRILL DIA 10.0 R0. MM", "chamfer 10, point 90"},
      {mm, "CHAMFER 0.5", "-"},
      {inch, "CHAMFER EDGES .03 X 45", "-"},
      {mm, "T5 CHAMFER 10", "chamfer 10, point 90"},
      {mm, "ENGRAVE LOGO", "-"},
      {mm, "FACE MILLING", "-"},
      {inch, "STOCK 2 X 3 X 1", "-"},
      {inch, "TAP 4 CORNERS", "-"},
      {mm, "STEP DRILL 6/10", "? names a kind of tool that needs more data"},
      {mm, "T10 D=10. CR=0. - dovetail mill", "? gives no angle of its flanks"},
  });
}

// How many tools, files or parts there are is no size.
TEST(ToolCommentReadings, NumbersThatCountThingsAreNoSizes) {
  expect_readings({
      {mm, "This file uses 2 drill bit sizes.", "-"},
      {mm, "USES 2 END MILL SIZES", "-"},
      {mm, "NEEDS 2 END MILLS", "-"},
      {mm, "3 DRILL OPERATIONS", "-"},
      {mm, "6 DRILL POSITIONS", "-"},
      {mm, "DRILL 1 OF 2", "-"},
      {mm, "FILE 2 DRILL", "-"},
      {mm, "PART 7 DRILL", "-"},
      {mm, "PART 7 6MM DRILL", "drill 6"},
      {mm, "12 DRILL OPERATION", "drill 12"},
      {mm, "6.8 DRILL OPS", "drill 6.8"},
      {mm, "6MM END MILLS", "endmill 6"},
  });
}

TEST(ToolReadings, BallsAndDrillsHaveShortNames) {
  expect_readings({
      {mm, "T1 6MM BALL NOSED SLOT DRILL", "ballmill 6"},
      {mm, "6.00 DIA BALLNOSE SLOTDRILL", "ballmill 6"},
      {mm, "T1 6MM SLOT DRILL", "endmill 6"},
      {mm, "T1 6MM BN", "? names a shape, and no kind of tool"},
      {mm, "T1 12MM BN R1", "bullmill 12, corner 1"},
      {mm, "T1 6MM JOBBER", "drill 6"},
      {mm, "T1 6MM CARB DR", "drill 6"},
      {inch, "T1 #29 SCREW MACHINE DRILL", "drill 3.4544"},
      {mm, "TOOL TYPE: TAPERSPHERICAL DIAMETER: 6. TIP RADIUS: 1.", "? gives no taper angle"},
      {mm, "TOOL TYPE: OFFTIPRAD DIAMETER: 30.", "? names a kind of tool that needs more data"},
      {mm, "T1 END MILL D: 12. R: 0.", "endmill 12"},
      {mm, "T1 D:12 R:2", "bullmill 12, corner 2"},
      {mm, "T5 DRILL H: 5 D: 5", "? gives no diameter"},
      {mm, "T1 HIGHFEED D25", "? gives no corner radius"},
      {mm, "T1 12MM HFM", "? gives no corner radius"},
      {mm, "T1 12MM ENDMILL CORNER=1", "bullmill 12, corner 1"},
      {mm, "T1 12MM CORNER=1", "bullmill 12, corner 1"},
      {mm, "TOOL DIA:10 CORNER:2", "bullmill 10, corner 2"},
      {mm, "T1 DC=12 RE=1", "bullmill 12, corner 1"},
      {mm, "T1 12MM ENDMILL RE 0.5", "bullmill 12, corner 0.5"},
  });
}

}  // namespace
}  // namespace mrsim
