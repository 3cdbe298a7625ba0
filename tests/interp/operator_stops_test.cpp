// Programs that stop for the part to be turned over, or for a tool to be changed by hand.
#include "interp/comments/operator_comments.h"
#include "interp/support.h"

#include <string>

namespace mrsim {
namespace {

using namespace mrsim::testing;

TEST(OperatorStops, CommentsTellThatThePartIsTurnedOver) {
  const auto said = [](const char* comment, bool lathe = false) {
    return says_part_is_turned(comment, lathe);
  };
  for (const char* yes :
       {"FLIP PART", "STOP - FLIP OVER AND CLAMP", "Turn part over", "ROTATE STOCK 180 DEG",
        "REVERSE PART IN VISE", "BAUTEIL WENDEN", "UMSPANNEN", "RETOURNER LA PIECE",
        "VOLTEAR LA PIEZA", "GIRARE IL PEZZO", "OBRNI KOS", "PREPNI KOS", "OKRENI KOMAD",
        "PART UPSIDE DOWN", "TEIL DREHEN", "WERKSTUECK UM 180 GRAD DREHEN", "BAUTEIL GEDREHT",
        "DREHE DAS TEIL"})
    EXPECT_EQ(said(yes), PartTurned::yes) << yes;
  for (const char* perhaps :
       {"OTHER SIDE", "2ND SIDE", "SIDE 2", "BACK SIDE", "RÜCKSEITE", "ZWEITE SEITE", "2. SEITE",
        "MOVE THE PART", "SHIFT PART LEFT", "MOVE CLAMPS THEN SLIDE STOCK", "MOVE THIS PART",
        "MOVE THE FIRST PART", "REPOSITION FINISHED WORKPIECE", "SHIFT 2ND PART"})
    EXPECT_EQ(said(perhaps), PartTurned::perhaps) << perhaps;
  for (const char* no : {"FLIP UP STOP",        "FLIP JAWS",
                         "TURN OFF COOLANT",    "SIDE 1",
                         "CHECK SIZE",          "ROTATE TOOL",
                         "CLEAR CHIPS",         "DO NOT FLIP",
                         "SIDE MILL D63",       "DO NOT MOVE PART",
                         "DONT MOVE THE PART",  "MOVE PART STOP",
                         "MOVE CLAMP OFF PART", "SLIDE STOP AWAY FROM PART",
                         "TEIL NICHT DREHEN",   "MOVE WORK LIGHT",
                         "DO NOT TURN PART",    "NEVER ROTATE STOCK",
                         "SPINDEL DREHEN",      "DREHEN FERTIG",
                         "SHIFT WORK OFFSET",   "MOVE OVER PART",
                         "MOVE HOSE FROM PART"})
    EXPECT_EQ(said(no), PartTurned::no) << no;
  EXPECT_EQ(said("TEIL DREHEN", true), PartTurned::no);
  EXPECT_EQ(said("DO NOT MOVE CLAMPS, FLIP PART"), PartTurned::yes);
  EXPECT_EQ(said("TURN PART TO 40.", true), PartTurned::no);
  EXPECT_EQ(said("TURN PART AROUND", true), PartTurned::yes);
}

// Cuts above and below the stop.
std::string warned(const std::string& stop, Dialect dialect = Dialect::fanuc) {
  const std::string first = "G0 X0 Y0 Z5\nG1 Z-2 F100\nG0 Z5\n";
  return codes(read_text(first + stop + "G0 X20\nG1 Z-3\nG0 Z5\nM30\n", at_origin(dialect)),
               Severity::warning);
}

TEST(OperatorStops, IsAWarningAtTheFirstCutOfTheOtherSide) {
  EXPECT_EQ(warned("M00 (FLIP PART)\n"), "part-turned");
  EXPECT_EQ(warned("(FLIP PART)\nG0 Z50\nM0\n"), "part-turned");
  EXPECT_EQ(warned("M01\n(TURN PART OVER)\n"), "part-turned");
  EXPECT_EQ(warned("M0 (SECOND SIDE)\n"), "part-turned");
  EXPECT_EQ(warned("M0 (SHIFT PART IN VISE)\n"), "part-turned");
  EXPECT_EQ(warned("M0 (STAND UP PART ON END)\n"), "part-turned");
  EXPECT_EQ(warned("M0 (ROTATE VISE 90 DEG)\n"), "part-turned");
  EXPECT_EQ(warned("MSG(\"BAUTEIL WENDEN\")\nM0\n", Dialect::sinumerik), "part-turned");
  EXPECT_EQ(warned("(MSG, flip the part)\nM0\n", Dialect::ngc), "part-turned");
}

TEST(OperatorStops, IsNoneWithoutAStopOrWithoutCutsOnBothSides) {
  EXPECT_EQ(warned("M01\n(SIDE 2 CONTOUR)\n"), "");
  EXPECT_EQ(warned("(FLIP PART)\n"), "");
  EXPECT_EQ(warned("M00 (MOVE CLAMPS)\n"), "");
  EXPECT_EQ(warned("M00 (FLIP PART, THEN RUN O0002)\nM30\n"), "");
  const std::string none = "M00 (FLIP PART)\nG0 X0 Y0 Z5\nG1 Z-2 F100\nG0 Z5\nM30\n";
  EXPECT_EQ(codes(read_text(none, at_origin(Dialect::fanuc)), Severity::warning), "");
}

TEST(OperatorStops, CommentsTellThatAToolIsChangedByHand) {
  for (const char* yes : {"CHANGE TO 1/8 BALL ENDMILL", "Insert 60 degree V bit", "TOOL CHANGE",
                          "CHANGE TOOL", "Change bit to 3mm ball", "WERKZEUG WECHSELN",
                          "LOAD 6MM DRILL", "WHEN STOPPED CHANGE TO 6MM BALL ENDMILL"})
    EXPECT_TRUE(says_tool_is_changed(yes)) << yes;
  for (const char* no :
       {"CHANGE DRILL IF WORN", "CHANGE DRILL WHEN NEEDED", "CHECK TOOL", "CHANGE INSERT",
        "LOAD PART", "CHANGE TOOL OFFSET", "MOVE CLAMPS", "1/8 BALL ENDMILL"})
    EXPECT_FALSE(says_tool_is_changed(no)) << no;
}

TEST(OperatorStops, AToolChangedByHandWithoutATWordIsAnError) {
  const auto told = [](const std::string& stop, Dialect dialect = Dialect::fanuc) {
    const std::string first = "G0 X0 Y0 Z5\nG1 Z-2 F100\nG0 Z5\n";
    return codes(read_text(first + stop + "G0 X20\nG1 Z-3\nM30\n", at_origin(dialect)),
                 Severity::error);
  };
  EXPECT_EQ(told("M0 (CHANGE TO 1/8 BALL ENDMILL)\n"), "tool-by-hand");
  EXPECT_EQ(told("(TOOL CHANGE)\nM5\nM00\nM3\n"), "tool-by-hand");
  EXPECT_EQ(told("(MSG, Change bit to 3mm ball)\nM0\n", Dialect::ngc), "tool-by-hand");
  EXPECT_EQ(told("MSG(\"WERKZEUG WECHSELN\")\nM0\n", Dialect::sinumerik), "tool-by-hand");
  EXPECT_EQ(told("M0\n(1/8 BALL ENDMILL)\n"), "tool-by-hand");
  EXPECT_EQ(told("M1 (REPLACE 10MM ENDMILL EVERY 20 PARTS)\n"), "");
  EXPECT_EQ(told("M1 (CHANGE 10MM ENDMILL EVERY 20 PARTS)\n"), "");
  EXPECT_EQ(told("M0\n(FINISH WALL WITH 10MM ENDMILL)\n"), "") << "the one in the spindle";
  EXPECT_EQ(told("M0\n(DRILL 5MM HOLES)\n"), "") << "the work";
  EXPECT_EQ(told("M1 (TOOL CHANGE)\nT2 M6 (D4 ENDMILL)\n"), "");
  EXPECT_EQ(told("(TOOL CHANGE)\n"), "");
  EXPECT_EQ(told("M0 (CHANGE TOOL)\nM30\n"), "");
  const std::string head = "M0 (INSERT 1/4 ENDMILL)\nG0 X0 Y0 Z5\nG1 Z-2 F100\nG0 Z5\nM30\n";
  EXPECT_EQ(codes(read_text(head, at_origin(Dialect::fanuc)), Severity::error), "");
}

// FreeCAD's posts for Grbl and Marlin leave tool changes as comments.
TEST(OperatorStops, AToolChangeInACommentIsTold) {
  const auto told = [](const std::string& comment, const std::string& head = "(M6 T2)\n") {
    const std::string first = "G0 X0 Y0 Z5\nG1 Z-2 F100\nG0 Z5\n";
    return codes(
        read_text(head + first + comment + "G0 X20\nG1 Z-3\nM30\n", at_origin(Dialect::ngc)),
        Severity::warning);
  };
  EXPECT_EQ(told("( M6 T3 )\n"), "tool-in-comment");
  EXPECT_EQ(told("(M6 T3.0)\n"), "tool-in-comment");
  EXPECT_EQ(told(";T3 M06\n", ""), "tool-in-comment");
  EXPECT_EQ(told("(M6 T2)\n"), "") << "the same tool";
  EXPECT_EQ(told("(M6 T1)\n", "T1 M6\n"), "") << "the one in the spindle";
  EXPECT_EQ(told("(M6 T3)\nT3 M6\n"), "");
  for (const char* text : {"M6", "T3", "M6 T3 DRILL", "M6 T3 S100", "M5 T3", "M6 T3.5", "T3=dr6"})
    EXPECT_EQ(tool_change_in_comment(text), std::nullopt) << text;
  EXPECT_EQ(tool_change_in_comment(" t12m6 "), 12);
}

}  // namespace
}  // namespace mrsim
