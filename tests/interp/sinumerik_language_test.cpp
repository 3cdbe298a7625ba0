// SINUMERIK's language as its manuals tell it: frames by their parts, arrays and elements as
// parameters, SAVE, RET with values, parts of a program.
#include "interp/support.h"

#include <map>

namespace mrsim {
namespace {

using namespace mrsim::testing;

std::string moves(const std::string& text, const std::map<std::string, std::string>& subs = {}) {
  const TempFolder scratch;
  for (const auto& [name, sub] : subs) scratch.write(name, sub);
  const std::string main = scratch.write("MAIN.MPF", "G71 G90 G1 F100\n" + text + "M30\n");
  return path_text(read_program(main, at_origin(Dialect::sinumerik)));
}

// FR[axis, part]: TR shift, RT turn (Z, new Y, new X), SC scale, MI mirror image.
TEST(SinumerikFrames, PartsAreReadAndSet) {
  const std::string frame = "DEF FRAME FR\n";
  EXPECT_EQ(moves(frame + "FR[X,TR]=5\n$P_PFRAME=FR\nX1\n"), "l6,0,0");
  EXPECT_EQ(moves(frame + "FR=CTRANS(X,5,Y,6)\nX=FR[X,TR] Y=FR[Y,TR]\n"), "l5,6,0");
  EXPECT_EQ(moves(frame + "FR[Z,RT]=90\n$P_PFRAME=FR\nX1\nX=FR[Z,RT]/90+1\n"), "l0,1,0 l0,2,0");
  EXPECT_EQ(moves(frame + "FR[X,SC]=2\nFR[Y,MI]=1\n$P_PFRAME=FR\nX1 Y1\nX=FR[X,SC] Y=FR[Y,MI]+1\n"),
            "l2,-1,0 l4,-2,0");
  EXPECT_EQ(moves("DEF FRAME FR[2]\nFR[1,X,TR]=5\n$P_PFRAME=FR[1]\nX1\n"), "l6,0,0");
  EXPECT_EQ(moves("$P_PFRAME[X,SC]=2\nX1\n$P_PFRAME[X,MI]=1\nX2\nX=$P_PFRAME[X,SC]+1\n"),
            "l2,0,0 l-4,0,0 l-6,0,0");
  EXPECT_EQ(moves("$P_PFRAME=CROT(X,20,Z,30)\nR1=$P_PFRAME[X,RT] R2=$P_PFRAME[Z,RT]\n"
                  "$P_PFRAME=CTRANS()\nX=R1 Y=R2\n"),
            "l20,30,0");
  EXPECT_EQ(moves(frame + "FR[X,FI]=5\n"), " | variable-unset");
}

// The order of CROT's axes is that of ROT, whichever is written first.
TEST(SinumerikFrames, CrotTurnsAsRotDoes) {
  const std::string there = "X10 Y20 Z30\n";
  EXPECT_EQ(moves("$P_PFRAME=CROT(X,30,Z,40)\n" + there), moves("ROT X30 Z40\n" + there));
  EXPECT_EQ(moves("$P_PFRAME=CROT(Z,40,X,30)\n" + there), moves("ROT X30 Z40\n" + there));
}

TEST(SinumerikFrames, InvframeUndoesAFrame) {
  const std::string frame = "DEF FRAME FR\nFR=CTRANS(X,5,Y,6):CROT(Z,30):CSCALE(X,2)\n";
  EXPECT_EQ(moves(frame + "$P_PFRAME=FR:INVFRAME(FR)\nX10 Y20 Z30\n"), "l10,20,30");
  EXPECT_EQ(moves("$P_PFRAME=INVFRAME(CTRANS(X,5):CROT(Z,90))\nX7 Y1\n"), "l1,-2,0");
  EXPECT_EQ(moves(frame + "$P_PFRAME=INVFRAME(5)\n"), " | expression");
}

// $P_UIFR holds what the next G54 to G599 puts in force.
TEST(SinumerikFrames, SettableFramesWaitForTheirWord) {
  EXPECT_EQ(moves("G54\n$P_UIFR[1]=CTRANS(X,5)\nX1\nG54 X2\n"), "l1,0,0 l7,0,0");
}

// Behind each block that moves, whichever program it stands in, but not in the one that is called.
TEST(SinumerikProc, ModalCallsHoldInSubprograms) {
  const std::map<std::string, std::string> subs = {{"HOLE.SPF", "PROC HOLE\nZ-3\nZ5\nRET\n"},
                                                   {"PLACES.SPF", "X1\nX2 M17\n"}};
  const std::string holes = "l1,0,0 l1,0,-3 l1,0,5 l2,0,5 l2,0,-3 l2,0,5";
  EXPECT_EQ(moves("MCALL HOLE\nPLACES\nMCALL\nX9\n", subs), holes + " l9,0,5");
  EXPECT_EQ(moves("MCALL HOLE\nLAB1: X=IC(1)\nREPEATB LAB1 P=1\nMCALL\nX9\n", subs),
            holes + " l9,0,5");
  const std::string row = "r1,0,0 l1,0,-3 l1,0,5 r2,0,5 l2,0,-3 l2,0,5 l9,0,5";
  EXPECT_EQ(moves("MCALL HOLE\nHOLES1(0,0,0,1,1,2)\nMCALL\nX9\n", subs), row);
  EXPECT_EQ(moves("MCALL DEEP(-3)\nHOLES1(0,0,0,1,1,2)\nMCALL\nX9\n",
                  {{"DEEP.SPF", "PROC DEEP(REAL Z1) SAVE\nTRANS Z5\nG91 Z=Z1-5\nZ8\nM17\n"}}),
            row);
  EXPECT_EQ(moves("MCALL ROW\nX1\nMCALL\n", {{"ROW.SPF", "HOLES1(0,0,0,1,1,2)\nRET\n"}}),
            "l1,0,0 | not-supported");
}

TEST(SinumerikProc, SaveRestoresFramesAndGCodesAlone) {
  EXPECT_EQ(moves("L70(5)\nN5 L70 (6) P2\n",
                  {{"L70.SPF", "PROC L70(REAL VA)\nX=VA\nG91 X1\nG90\nRET\n"}}),
            "l5,0,0 l6,0,0 l7,0,0 l6,0,0 l7,0,0");
  EXPECT_EQ(moves("SUB\nX1\n", {{"SUB.SPF", "PROC SUB SAVE\nTRANS X10\nX1\nRET\n"}}),
            "l11,0,0 l1,0,0");
  EXPECT_EQ(moves("TRANS X2\nSUB\nX1\n", {{"SUB.SPF", "PROC SUB SAVE\nTRANS X10\nX1\nRET\n"}}),
            "l11,0,0 l3,0,0");
  EXPECT_EQ(moves("SUB\nX1\n", {{"SUB.SPF", "PROC SUB\nTRANS X10\nX1\nRET\n"}}), "l11,0,0")
      << "without SAVE the frame stays";
  EXPECT_EQ(
      moves("$P_UIFR[2]=CTRANS(X,5)\nSUB\nX1\n", {{"SUB.SPF", "PROC SUB SAVE\nG55 X1\nRET\n"}}),
      "l6,0,0 l1,0,0");
  EXPECT_EQ(moves("G54\nSUB\nX1\n",
                  {{"SUB.SPF", "PROC SUB SAVE\n$P_UIFR[1]=CTRANS(X,5)\nG54\nX2\nRET\n"}}),
            "l7,0,0 l6,0,0")
      << "no other settable frame was chosen";
}

TEST(SinumerikProc, ArraysAndElementsAreParameters) {
  EXPECT_EQ(moves("DEF REAL VQ[3]\nVQ[2]=4\nSUB(VQ)\nX=VQ[1]\n",
                  {{"SUB.SPF", "PROC SUB(VAR REAL VA[3])\nVA[1]=VA[2]+5\nRET\n"}}),
            "l9,0,0");
  EXPECT_EQ(moves("DEF REAL VQ[3]\nVQ[2]=4\nSUB(VQ)\nX=VQ[1]+1\n",
                  {{"SUB.SPF", "PROC SUB(REAL VA[])\nVA[1]=9\nX=VA[2]\nRET\n"}}),
            "l4,0,0 l1,0,0");
  const std::map<std::string, std::string> twice = {
      {"SUB.SPF", "PROC SUB(VAR REAL VA)\nVA=VA*2\nRET\n"}};
  EXPECT_EQ(moves("DEF REAL VQ[3]\nVQ[1]=3\nSUB(VQ[1])\nX=VQ[1]\n", twice), "l6,0,0");
  EXPECT_EQ(moves("R1=4\nSUB(R1)\nSUB(R[1])\nX=R1\n", twice), "l16,0,0");
  EXPECT_EQ(moves("X1\nSUB(4)\n", twice), "l1,0,0 | call-arguments");
  EXPECT_EQ(moves("DEF REAL VQ[3]\nX1\nSUB(VQ)\n", twice), "l1,0,0 | call-arguments");
  // R9 would be a variable beside R9.
  EXPECT_EQ(moves("X1\nSUB(4)\n", {{"SUB.SPF", "PROC SUB(REAL R9)\nX=R9\nRET\n"}}),
            "l1,0,0 | call-arguments");
}

// A text for a number left the parameter at 0.
TEST(SinumerikProc, ArgumentsHaveTheTypeOfTheirParameter) {
  const std::map<std::string, std::string> sub = {
      {"SUB.SPF", "PROC SUB(REAL VA, STRING[9] VB)\nX=VA+STRLEN(VB)\nRET\n"}};
  EXPECT_EQ(moves("SUB(4,\"AB\")\n", sub), "l6,0,0");
  EXPECT_EQ(moves("X1\nSUB(\"ABC\",\"AB\")\n", sub), "l1,0,0 | call-arguments");
  EXPECT_EQ(moves("X1\nSUB(4,5)\n", sub), "l1,0,0 | call-arguments");
}

// Back by levels, and there to the block of a label or behind it.
TEST(SinumerikProc, RetReturnsByLevelsAndToLabels) {
  const std::string main = "SUB\nX1\nLEND: X5\nN50 X6\n";
  EXPECT_EQ(moves(main, {{"SUB.SPF", "PROC SUB\nX3\nRET()\n"}}), "l3,0,0 l1,0,0 l5,0,0 l6,0,0");
  EXPECT_EQ(moves(main, {{"SUB.SPF", "PROC SUB\nX3\nRET(\"LEND\")\n"}}), "l3,0,0 l5,0,0 l6,0,0");
  EXPECT_EQ(moves(main, {{"SUB.SPF", "PROC SUB\nX3\nRET(\"LEND\",1)\n"}}), "l3,0,0 l6,0,0");
  EXPECT_EQ(moves(main, {{"SUB.SPF", "PROC SUB\nX3\nRET(\"N50\")\n"}}), "l3,0,0 l6,0,0");
  EXPECT_EQ(moves(main, {{"SUB.SPF", "PROC SUB\nX3\nRET(\"NONE\")\n"}}), "l3,0,0 | jump-target");
  const std::string outer = "PROC OUTER\nINNER\nX99\nRET\n";
  EXPECT_EQ(moves("OUTER\nX1\nLEND: X7\n",
                  {{"OUTER.SPF", outer}, {"INNER.SPF", "PROC INNER\nX3\nRET(,,2)\n"}}),
            "l3,0,0 l1,0,0 l7,0,0");
  EXPECT_EQ(moves("OUTER\nX1\nLEND: X7\n",
                  {{"OUTER.SPF", outer}, {"INNER.SPF", "PROC INNER\nX3\nRET(\"LEND\",,2)\n"}}),
            "l3,0,0 l7,0,0");
  EXPECT_EQ(moves(main, {{"SUB.SPF", "PROC SUB\nX3\nRET(,,2)\n"}}), "l3,0,0 | value-range");
}

// What else stands in the block of ENDLABEL belongs to the part.
TEST(SinumerikParts, EndlabelEndsBehindItsBlock) {
  EXPECT_EQ(moves("G91\nLAB1: X1\nENDLABEL: X4\nX10\nREPEAT LAB1 P=1\n"),
            "l1,0,0 l5,0,0 l15,0,0 l16,0,0 l20,0,0");
  EXPECT_EQ(moves("G91\nLAB1: X1\nREPEAT LAB1 P=1\nLAB2: X10\nENDLABEL:\nREPEAT LAB2 P=1\n"),
            "l1,0,0 l2,0,0 l12,0,0 l22,0,0")
      << "an ENDLABEL behind REPEAT is that of another part";
}

// A name stands for its text in the program that defines it, and from a file of definitions in all.
TEST(SinumerikProc, NamesOfTheFileSystemAreTheSamePrograms) {
  EXPECT_EQ(moves("_N_SUB_SPF\nCALL \"_N_SUB_SPF\"\nX9\n", {{"SUB.SPF", "X1\nX2 M17\n"}}),
            "l1,0,0 l2,0,0 l1,0,0 l2,0,0 l9,0,0");
  EXPECT_EQ(moves("_N_SUB_SPF\nX9\nM30\n%_N_SUB_SPF\nX1\nM17\n"), "l1,0,0 l9,0,0");
  EXPECT_EQ(moves("_N_OTHER_SPF\n"), " | subprogram-missing");
}

TEST(SinumerikValues, ATextIsNoLongerThanItsVariable) {
  EXPECT_EQ(moves("DEF STRING[3] SA,SB=\"ABC\"\nSA=\"DEF\"\nX=STRLEN(SA)\n"), "l3,0,0");
  EXPECT_EQ(moves("DEF STRING[3] SA\nSA=\"DEFG\"\n"), " | variable-unset");
  EXPECT_EQ(moves("DEF STRING[3] SA=\"DEFG\"\n"), " | variable-unset");
  EXPECT_EQ(moves("DEF STRING[0] SA\n"), " | value-range");
}

// Several jumps in a block: the first whose condition holds.
// A text or the name of an axis in the place of a number was read as 0, by cycles as left out.
TEST(SinumerikValues, TextsAndAxesAreNoNumbers) {
  EXPECT_EQ(moves("X10\nX=Y\n"), "l10,0,0 | expression");
  EXPECT_EQ(moves("X10\nX=\"5\"\n"), "l10,0,0 | expression");
  EXPECT_EQ(moves("X10\nX=IC(X)\n"), "l10,0,0 | expression");
  EXPECT_EQ(moves("DEF STRING[9] ST=\"5\"\nX10 RND=ST\nY10\n"), "l0,10,0 | expression");
  EXPECT_EQ(moves("AX[Z]=X\nG4 F=\"1\"\n"), " | expression expression");
  EXPECT_EQ(moves("CYCLE81(10,0,2,X)\n"), " | expression");
  EXPECT_EQ(moves("CYCLE83(10,0,2,-6,\"\",-6,,0)\n"), "r0,0,2 l0,0,-6 r0,0,10");
  EXPECT_EQ(moves("R[\"A\"]=1\n"), " | variable-number");
}

TEST(SinumerikJumps, SeveralStandInABlock) {
  const std::string block = "IF R1==1 GOTOF AA IF R1==2 GOTOF \"N\"<<20 IF (R1==3) GOTOF CC\n";
  const std::string marks = "X9\nAA: X1\nN20 X2\nCC: X3\n";
  EXPECT_EQ(moves("R1=1\n" + block + marks), "l1,0,0 l2,0,0 l3,0,0");
  EXPECT_EQ(moves("R1=2\n" + block + marks), "l2,0,0 l3,0,0");
  EXPECT_EQ(moves("R1=3\n" + block + marks), "l3,0,0");
  EXPECT_EQ(moves("R1=4\n" + block + marks), "l9,0,0 l1,0,0 l2,0,0 l3,0,0");
  EXPECT_EQ(moves("R1=4\nIF R1==1 GOTOF AA X5\nAA: X1\n"), " | statement")
      << "what stands behind a jump is not left out in silence";
}

TEST(SinumerikMacros, TextsAreRunAsBlocks) {
  EXPECT_EQ(moves("DEF STRING[40] TX\nR2=7\nTX=\"X\"<<R2\nEXECSTRING(TX)\n"
                  "EXECSTRING(\"R1=3\")\nX=R1\n"),
            "l7,0,0 l3,0,0");
  EXPECT_EQ(moves("R1=0\nAA: R1=R1+1\nX=R1\nEXECSTRING(\"IF R1<3 GOTOB AA\")\nX9\n"),
            "l1,0,0 l2,0,0 l3,0,0 l9,0,0");
  EXPECT_EQ(moves("EXECSTRING(\"IF TRUE\")\nX1\n"), " | not-supported");
  EXPECT_EQ(moves("EXECSTRING(\"GOTOF BB\")\nX1\nBB: X2\n"), "l2,0,0");
  EXPECT_EQ(moves("EXECSTRING(\"SUB(4)\")\nX9\n", {{"SUB.SPF", "PROC SUB(REAL AA)\nX=AA\nRET\n"}}),
            "l4,0,0 l9,0,0");
  EXPECT_EQ(moves("EXECSTRING(\"X1 Q=\")\n"), " | address-without-number");
  EXPECT_EQ(moves("EXECSTRING(5)\n"), " | statement");
  EXPECT_EQ(moves("EXECSTRING(\"DEF INT II\")\n"), " | not-supported");
  InterpOptions options = at_origin(Dialect::sinumerik);
  options.max_steps = 1000;
  EXPECT_EQ(codes(read_text("DEF STRING[40] TX=\"EXECSTRING(TX)\"\nEXECSTRING(TX)\n", options),
                  Severity::error),
            "program-endless");
}

TEST(SinumerikMacros, NamesStandForText) {
  EXPECT_EQ(moves("DEFINE GOHOME AS G0 X5 Y5 ; a comment\nGOHOME Z1\nG1 X1 ; GOHOME\n"),
            "r5,5,1 l1,5,1");
  EXPECT_EQ(moves("DEFINE WIDTH AS 12\nR1=WIDTH/4\nX=R1+WIDTH\nMSG(\"WIDTH\")\n"), "l15,0,0");
  EXPECT_EQ(moves("DEFINE TWICE AS P=1\nG91\nLAB1: X1\nREPEAT LAB1 TWICE\n"), "l1,0,0 l2,0,0");
  EXPECT_EQ(moves("DEFINE THERE AS X5\nTHERE\nSUB\n", {{"SUB.SPF", "X1\nTHERE\nM17\n"}}),
            "l5,0,0 l1,0,0 | subprogram-missing")
      << "not in a subprogram";
  EXPECT_EQ(moves("DEFINE ASK AS IF R1==1\nX1\n"), " | not-supported");
  const TempFolder scratch;
  InterpOptions options = at_origin(Dialect::sinumerik);
  options.search_path = {scratch.write("UMAC.DEF", "DEFINE THERE AS X5\nDEF REAL _WIDE=7\nM30\n")};
  const std::string main = scratch.write("MAIN.MPF", "G90 G1 F100\nTHERE\nX=_WIDE\nSUB\nM30\n");
  scratch.write("SUB.SPF", "THERE\nM17\n");
  EXPECT_EQ(path_text(read_program(main, options)), "l5,0,0 l7,0,0 l5,0,0");
}

// T1= and M1=6 are the tool of the first spindle, and its change; a spindle's own M is none.
TEST(SinumerikWordsOfSpindles, ChangeTheToolOfTheFirst) {
  const InterpOptions options = at_origin(Dialect::sinumerik);
  const Program p = read_text(
      "T1=5\nM1=6\nS1=1000 M1=3\nG1 X1 F100\nT1=\"FR\"\nX2\nM1=6\nX3\nM2=6\nT7\nM2=6\nX4\n",
      options);
  std::string tools;
  for (const Motion& m : p.motions) tools += p.tools[static_cast<std::size_t>(m.tool)].id + " ";
  EXPECT_EQ(tools, "5 5 FR FR ");
  EXPECT_EQ(codes(read_text("T2=5\nG1 X1 F100\n", options)), "address-unknown");
}

TEST(SinumerikValues, SetAndRepFillLists) {
  EXPECT_EQ(moves("DEF REAL VQ[4]\nVQ=REP(1)\nVQ[1]=REP(4,2)\nX=VQ[0] Y=VQ[2] Z=VQ[3]\n"),
            "l1,4,1");
  EXPECT_EQ(moves("DEF REAL VQ[3]\nVQ=REP(7)\nVQ[0]=SET(1,,3)\nX=VQ[0] Y=VQ[1] Z=VQ[2]\n"),
            "l1,7,3");
  EXPECT_EQ(moves("X=12 B_AND 10 Y=12 B_OR 10 Z=12 B_XOR 10\n"), "l8,14,6");
  EXPECT_EQ(moves("AX[AXNAME(\"Y\")]=3\n"), "l0,3,0");
  const std::string letter = "DEF CHAR VC=\"B\"\nDEF STRING[8] VS=\"ABC\"\n";
  EXPECT_EQ(moves(letter + "IF VC==\"B\"\nX1\nENDIF\nIF VC==VS[1]\nX2\nENDIF\nX=VC Y=VC+1\n"),
            "l1,0,0 l2,0,0 l66,67,0");
  EXPECT_EQ(moves(letter + "X1\nVC=256\n"), "l1,0,0 | variable-unset");
  EXPECT_EQ(moves(letter + "VS=\"A\"<<-VC\nIF VS==\"A-66\"\nX1\nENDIF\n"), "l1,0,0");
  EXPECT_EQ(moves(letter + "VS[2]=VC\nVS[0]=\"X\"\nIF VS==\"XBB\"\nX1\nENDIF\n"
                           "IF (\"L\"<<VC)==\"LB\"\nX2\nENDIF\nVS[3]=VC\n"),
            "l1,0,0 l2,0,0 | variable-unset");
  EXPECT_EQ(moves("DEF STRING[8] VS=\"AB\"\nIF VS[1]==\"B\"\nX1\nENDIF\n"), "l1,0,0");
}

// Data of the machine that the cycles read are no words that mrsim could ever know.
TEST(SinumerikLanguage, ArraysThatNothingDefinesAreErrors) {
  EXPECT_EQ(moves("X1\n_ZSD[2]=1\n"), "l1,0,0 | variable-unset");
  EXPECT_EQ(moves("DEF INT _ZSD[9]\n_ZSD[2]=1\nX=_ZSD[2]\n"), "l1,0,0");
}

TEST(SinumerikLanguage, IsvarAsksForAVariable) {
  EXPECT_EQ(moves("DEF REAL AA=3\nIF ISVAR(\"AA\")\nX=AA\nENDIF\nIF NOT ISVAR(\"BB\")\nX4\nENDIF\n"
                  "IF ISVAR(\"R5\")\nX5\nENDIF\n"),
            "l3,0,0 l4,0,0 l5,0,0");
  EXPECT_EQ(moves("IF ISVAR(\"$MN_X\")\nX4\nENDIF\n"), " | expression");
}

// As of FANUC's lengths: the machine cuts deeper, and here all passes are at one depth.
TEST(SinumerikLanguage, ALengthMustNotChangeBetweenCuts) {
  const auto told = [](const std::string& set, const std::string& second = "T1 M6\n") {
    const std::string cut = "D1 G0 Z9\nG1 Z0 F9\nG0 Z9\n";
    return codes(read_text("T1 M6\n$TC_DP3[2,1]=90 $TC_DP12[1,1]=0\n" + cut + set + second + cut,
                           at_origin(Dialect::sinumerik)));
  };
  EXPECT_EQ(told("$TC_DP12[1,1]=$TC_DP12[1,1]-0.5\n"), "not-supported");
  EXPECT_EQ(told("$TC_DP3[1,1]=80\n"), "not-supported");
  EXPECT_EQ(told("$TC_DP3[2,1]=91\n"), "");
  EXPECT_EQ(told("$TC_DP12[1,1]=0\n"), "");
  const auto edges = [](const std::string& set) {
    const std::string cut = " G0 Z9\nG1 Z0 F9\nG0 Z9\n";
    return codes(read_text(set + "\nT1 M6\nD1" + cut + "D2" + cut, at_origin(Dialect::sinumerik)));
  };
  EXPECT_EQ(edges("$TC_DP3[1,1]=100 $TC_DP3[1,2]=98"), "not-supported");
  EXPECT_EQ(edges("$TC_DP3[1,1]=100 $TC_DP3[1,2]=100"), "");
}

// Of a path the last part counts: no other folder is opened.
TEST(SinumerikLanguage, OfAPathTheLastPartIsCalled) {
  const std::string sub = "\nM30\n%_N_HOLES_SPF\nG1 X1 F9\nM17\n";
  for (const std::string call :
       {"CALL \"/_N_WKS_DIR/_N_PART_WPD/_N_HOLES_SPF\"", "CALL \"/_N_SPF_DIR/\"<<\"_N_HOLES_SPF\"",
        "EXTCALL(\"USB:\\PARTS\\HOLES.SPF\")", "EXTCALL \"/user/sinumerik/HOLES.MPF\"",
        "PCALL /_N_WKS_DIR/_N_PART_WPD/_N_HOLES_SPF"})
    EXPECT_EQ(path_text(read_text(call + sub, at_origin(Dialect::sinumerik))), "l1,0,0") << call;
}

TEST(SinumerikLanguage, ANameInPlaceOfATextIsToldOf) {
  const auto told = [](const char* text) {
    const Program p = read_text(text, at_origin(Dialect::sinumerik));
    return p.diagnostics.empty() ? std::string() : p.diagnostics.front().text;
  };
  EXPECT_EQ(told("CALL HOLES\nM30\n"),
            "CALL needs the name of a program as text: CALL \"HOLES\", or HOLES alone");
  EXPECT_EQ(told("GOTOF 'LB1'\nLB1: M30\n"), "GOTOF needs a label: GOTOF LAB1");
}

// R1 was a variable beside R1, and F1 could not be assigned.
TEST(SinumerikLanguage, NamesOfVariablesBeginWithTwoLetters) {
  const auto run = [](const char* text) {
    return codes(read_text(text, at_origin(Dialect::sinumerik)));
  };
  for (const char* const text : {"DEF REAL R1\nG1 X1 F9\n", "DEF FRAME F1\nG1 X1 F9\n"})
    EXPECT_EQ(run(text), "statement") << text;
  EXPECT_EQ(run("DEF REAL _1,RA1\nRA1=2\nG1 X=RA1 F9\n"), "statement") << "_1";
  EXPECT_EQ(run("DEF REAL __1,RA1\nRA1=2\nG1 X=RA1 F9\n"), "");
}

// The branch passed over the ELSE, which no control sees there.
TEST(SinumerikLanguage, PartsOfBranchesAndLoopsBehindWordsAreErrors) {
  const auto told = [](const std::string& text) {
    return codes(read_text("R1=2\nF9\n" + text + "\nM30\n", at_origin(Dialect::sinumerik)));
  };
  EXPECT_EQ(told("IF R1==1\nG1 X1 ELSE\nX2\nENDIF"), "structure");
  EXPECT_EQ(told("IF R1==1\nG1 X1\nR2=1 ENDIF\nX2\nENDIF"), "structure");
  EXPECT_EQ(told("WHILE R1==1\nG1 X1 ENDWHILE\nENDWHILE"), "structure");
  EXPECT_EQ(told("IF R1==1\nMSG(\"OR ELSE\")\nENDIF\nG1 X1 ;ELSE"), "");
}

TEST(SinumerikLanguage, SubprogramsMayBeNamedAsInArchives) {
  for (const char* const file : {"_N_HOLES_SPF", "_N_HOLES_MPF", "_N_HOLES_SPF.SPF"}) {
    const TempFolder scratch;
    scratch.write(file, "X1\nM17\n");
    const std::string main = scratch.write("MAIN.MPF", "G1 F9\nHOLES\nCALL \"HOLES\"\nX5\nM30\n");
    EXPECT_EQ(path_text(read_program(main, at_origin(Dialect::sinumerik))), "l1,0,0 l5,0,0")
        << file;
  }
}

// $P_GG[n] is the code of group n that is in force, counted as G[n]=m counts.
TEST(SinumerikLanguage, ModalCodesInForceAreRead) {
  const auto path = [](const std::string& text) {
    return path_text(read_text(text, at_origin(Dialect::sinumerik)));
  };
  EXPECT_EQ(path("G91 G18\nR1=$P_GG[14] R2=$P_GG[6] R3=$P_GG[1]\n"
                 "G90 G17 G1 X=R1 Y=R2 Z=R3 F9\n"),
            "l2,2,2");
  EXPECT_EQ(path("G91\nR1=$P_GG[14]\nG90 G1 X5 F9\nG[14]=R1\nX1\n"), "l5,0,0 l6,0,0");
  EXPECT_EQ(path("G451 DIAMON\nR1=$P_GG[18] R2=$P_GG[29]\nDIAMOF G1 X=R1 Y=R2 F9\n"), "l2,2,0");
  EXPECT_EQ(path("$P_UIFR[5]=CTRANS(X,10)\nG505\nR1=$P_UIFRNUM R2=$P_GG[8]\n"
                 "G500 G1 X=R1 Y=R2 F9\n"),
            "l5,6,0");
  EXPECT_EQ(path("R1=$P_GG[13]\nG1 X5 F9\n"), "l5,0,0 | variable-unset");
}

// $P_SUBPAR[n]: whether the call gives parameter n, or its default counts.
TEST(SinumerikLanguage, ASubprogramKnowsWhichParametersItWasGiven) {
  const TempFolder scratch;
  scratch.write("SUB.SPF",
                "PROC SUB(REAL PA, REAL PB=7)\nIF $P_SUBPAR[1]\nX=PA\nENDIF\n"
                "IF $P_SUBPAR[2]==TRUE\nY=PB\nELSE\nZ=PB\nENDIF\nM17\n");
  const std::string main =
      scratch.write("MAIN.MPF", "G1 F9\nSUB(1)\nSUB(2,3)\nSUB(,4)\nSUB\nX9\nM30\n");
  EXPECT_EQ(path_text(read_program(main, at_origin(Dialect::sinumerik))),
            "l1,0,0 l1,0,7 l2,0,7 l2,3,7 l2,4,7 l9,4,7");
}

// What stands behind a condition is an error whether the condition holds or not: "IF R1=5" would
// ask whether R1 is 0, and words there would be lost.
TEST(SinumerikStructures, NothingStandsBehindACondition) {
  const std::string body = "X1\nENDIF\nX2\n";
  for (const char* value : {"R1=0\n", "R1=5\n"}) {
    EXPECT_EQ(moves(value + ("IF R1=5\n" + body)), " | statement") << value;
    EXPECT_EQ(moves(value + ("IF R1==5 THEN\n" + body)), " | statement") << value;
    EXPECT_EQ(moves(value + ("IF R1==5 X9\n" + body)), " | statement") << value;
    EXPECT_EQ(moves(value + std::string("WHILE R1=5\nR1=0\nENDWHILE\nX2\n")), " | statement");
    EXPECT_EQ(moves(value + std::string("FOR R2=R1 TO 4 STEP 2\nX1\nENDFOR\n")), " | statement");
    EXPECT_EQ(moves(value + std::string("REPEAT\nR1=0\nUNTIL R1=5\n")), " | statement");
    EXPECT_EQ(moves(value + std::string("IF R1==5 GOTOF AA BB\nAA: X1\n")), " | statement");
  }
  EXPECT_EQ(moves("GOTOF AA BB\nAA: X1\n"), " | statement");
  for (const char* jump : {"IF R1==4 GOTOF", "IF R1==4 GOTOB ; AA", "IF R1==5 GOTO", "GOTOC"})
    EXPECT_EQ(moves("R1=5\nAA: X1\n" + std::string(jump) + "\nX2\n"), "l1,0,0 | jump-target")
        << jump;
  EXPECT_EQ(moves("GOTOF AA ; BB\nX9\nAA: X1\nGOTOF \"N\"<<20\nN20 X2\n"), "l1,0,0 l2,0,0");
}

// "=" stands before what is computed, with blanks behind a sign or not.
TEST(SinumerikStructures, AnEqualSignStandsBeforeWhatIsComputed) {
  EXPECT_EQ(moves("R1=5\nX=- R1 Y=-  3\n"), "l-5,-3,0");
  const auto told = [](const std::string& word) {
    const Program p = read_text("G1 F9 R1=5\nX2 " + word + "\n", at_origin(Dialect::sinumerik));
    return p.diagnostics.empty() ? std::string() : p.diagnostics.front().text;
  };
  for (const char* word : {"Y-R1", "Y R1", "Y(R1+2)", "Y-(R1)"})
    EXPECT_NE(told(word).find("= is missing"), std::string::npos) << word << told(word);
  EXPECT_NE(told("YR1").find("is Y=R1 meant?"), std::string::npos) << told("YR1");
}

}  // namespace
}  // namespace mrsim
