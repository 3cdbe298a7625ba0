// SINUMERIK programs as controls and CAM systems write them: words that change nothing are read
// over, words that move the machine count, and nothing is dropped in silence.
#include "interp/support.h"

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

/// End points of the motions, and the codes of errors and warnings.
std::string run(const std::string& text) {
  InterpOptions options = at_origin(Dialect::sinumerik);
  options.variables = {{"R1", "3"}};
  const Program program = read_text(text, options);
  std::string out;
  for (const Motion& m : program.motions)
    out += fmt::format("{:.6g},{:.6g},{:.6g} ", m.end.x + 0.0, m.end.y + 0.0, m.end.z + 0.0);
  return out + codes(program);
}

TEST(Sinumerik, RadiusOfTheToolIsKnownBeforeItCuts) {
  EXPECT_EQ(run("T1 D1 M6\nF100 G1 X=20-$P_TOOLR Y0\n"), "15,0,0 ");
  EXPECT_EQ(run("T1 D0 M6\nF100 G1 X=20-$P_TOOLR Y0\n"), "20,0,0 ") << "D0: no edge";
  EXPECT_EQ(run("T1 D1 M6\nF100 G1 X=20-$P_AD[6] Y0\n"), "15,0,0 ");
  EXPECT_EQ(run("$TC_DP6[1,1]=4\nT1 D1 M6\nF100 G1 X=20-$P_AD[6] Y0\n"), "16,0,0 ");
}

TEST(Sinumerik, NamesMayStandBehindASign) {
  const std::string def = "DEF REAL _A=4, _B=2\nF100 G1 ";
  EXPECT_EQ(run(def + "X=-_A\nX=-_A*_B\nX=5-_A\nX=+_A\nX=-(_A+_B)\n"),
            "-4,0,0 -8,0,0 1,0,0 4,0,0 -6,0,0 ");
}

TEST(Sinumerik, AxesBesideADwellAreNotDropped) {
  EXPECT_EQ(run("F100 G1 X1\nG4 F2 X30\nX2\n"), "1,0,0 2,0,0 call-not-alone");
  EXPECT_EQ(run("F100 G1 X1\nG4 F2\nG4 S3\nX2\n"), "1,0,0 2,0,0 ");
}

TEST(Sinumerik, CallsOfIsoModeAreRefused) {
  const Program iso = read_text("G291\nG90 G54\n", at_origin(Dialect::sinumerik));
  ASSERT_EQ(codes(iso), "not-supported");
  EXPECT_NE(iso.diagnostics[0].text.find("--dialect fanuc"), std::string::npos);
  EXPECT_EQ(run("F100 G1 X1\nG291\nG68 X0 Y0 R45\n#101=5\nG43 H1 Z5\nG290\nG1 X2 Y3 Z4\n"),
            "1,0,0 2,3,4 not-supported")
      << "one cause, one error";
  EXPECT_EQ(run("F100 G1 X1\nM98 P1\nX2\n"), "1,0,0 2,0,0 not-supported");
  EXPECT_EQ(run("F100 G1 X1\nM99\nX2\n"), "1,0,0 2,0,0 not-supported");
}

// Speeds, smoothing, couplings, the handling of wear: the path stays what it is.
TEST(Sinumerik, WordsThatMoveNothingAreReadOver) {
  const std::string path = "F100 G1 X1\n";
  for (const char* word :
       {"G54 G17 GWPSOF", "GWPSON(1)", "PAROTOF",   "TOROTOF", "FENDNORM",      "G62",
        "G621",           "G972",      "G973",      "TOWSTD",  "TOWMCS",        "ORISON",
        "ORISOF",         "CUTMOD=0",  "STOLF=0.1", "SVC=120", "DITS=1 DITE=1", "WAITS",
        "STOPREOF",       "NEWCONF",   "CANCEL(1)", "FPRAOF",  "FPR(S1)",       "CORROF",
        "FTOCOF"})
    EXPECT_EQ(run(word + std::string("\n") + path), "1,0,0 ") << word;
  EXPECT_EQ(run("CUTMOD=1\n" + path), "1,0,0 not-supported");
}

TEST(Sinumerik, WordsThatPostsWriteAroundProgramsAreRead) {
  EXPECT_EQ(run("G17 G90\nORIWKS\nORIAXES\nCOMPCAD\nDYNFINISH\nGROUP_BEGIN(0,\"FACE\",0,0)\n"
                "SPOS[2]=90\nPOLF[Z]=100\nLFPOS\nWALIMON\nFA[X]=200\nSPOS=DC(90)\n"
                "CP\nPTPG0\nDRFOF\nGEOAX()\nWAITMC(1)\nNPROT(1,0)\nMMC(\"A\",\"N\")\n"
                "WAITE(2)\nDISABLE(1)\nENABLE(1)\nATOL=0.1\nLEAD=0 TILT=0\n"
                "BRISKA(X)\nSOFTA(X,Y)\nDRIVEA(X)\nTCARR=0\nTCOABS\nTOFFL=0\nTOFFR=0.0\n"
                "F100 G1 X1\nGROUP_END(0,0)\nM30\n"),
            "1,0,0 ");
  EXPECT_EQ(run("TRANSMIT\nF100 G1 G41 X1\nG40 X5\nTRAFOOF\nG1 X2\n"), "2,0,0 not-supported")
      << "no more is told of radius compensation";
  EXPECT_EQ(run("TRANSMIT\nF100 G1 X1 C20\nTRAFOOF\nG1 X2\n"), "2,0,0 not-supported")
      << "one cause, one error";
  EXPECT_EQ(run("TRACYL(50)\nF100 G1 X1 C20\nTRAFOOF\nG1 X2\n"), "2,0,0 not-supported");
  EXPECT_EQ(run("TRAORI(1)\nF100 G1 X1 A20\nTRAFOOF\nG1 X2\n"), "2,0,0 not-supported");
  EXPECT_EQ(run("TRAORI\nG1 F100 X1\nPOS[B]=30\nX2\n"), "1,0,0 not-supported");
  EXPECT_EQ(run("G1 F100 X1\nPOS[A]=0 POSA[C]=0\nX2\n"), "1,0,0 2,0,0 ");
  EXPECT_EQ(run("G1 F100 X1\nPOSA[ c ]=DC(90)\nX2\n"), "1,0,0 2,0,0 not-supported");
  EXPECT_EQ(run("SETMS(2)\nF100 G1 X1\nSETMS\nX2\n"), "1,0,0 2,0,0 ");
}

TEST(Sinumerik, ASwivelWithoutATiltShiftsAndTurns) {
  EXPECT_EQ(
      run("CYCLE800(1,\"TC1\",100000,57,10,20,0,0,0,90,0,0,0,1)\nF9 G1 X5 Y0\nCYCLE800()\nX5 Y0\n"),
      "10,25,0 5,0,0 ");
  EXPECT_EQ(run("CYCLE800(0,\"\",0,27,10,0,0,90,0,0,1,2,0,1)\nF9 G1 X5 Y0\n"), "8,6,0 ");
  EXPECT_EQ(
      run("CYCLE800(0,\"\",0,57,10,0,0)\nTRANS X5\nCYCLE800(0,\"\",1,57,1,0,0)\nF9 G1 X5 Y0\n"),
      "21,0,0 ")
      << "additive, with TRANS";
  EXPECT_EQ(run("TRANS X5\nCYCLE800()\nF9 G1 X5 Y0\n"), "5,0,0 frame-deleted");
  EXPECT_EQ(run("TRANS X5\nCYCLE800(0,\"\",0,57,1,0,0)\nF9 G1 X5 Y0\n"), "6,0,0 frame-deleted");
  EXPECT_EQ(
      run("F9 G1 X1\nCYCLE800(0,\"\",0,57,0,0,0,0,30)\nX5\nMCALL CYCLE81(9,0,2,-5)\nX7\nMCALL\n"
          "CYCLE800(0,\"\",0,192,0,0,0,0,0,30)\nX8\nCYCLE800()\nX9\n"),
      "1,0,0 9,0,0 not-supported not-supported")
      << "no move is run in a tilted plane";
}

TEST(Sinumerik, OffsetsOfTheToolByTheProgramAreErrors) {
  EXPECT_EQ(run("F100 G1 X1\nTOFFL=2\nX2\n"), "1,0,0 2,0,0 not-supported");
  EXPECT_EQ(run("F100 G1 X1\nTOFFL=0+2\nX2\n"), "1,0,0 2,0,0 not-supported");
  EXPECT_EQ(run("F100 G1 X1\nTCARR=1\nX2\n"), "1,0,0 2,0,0 not-supported");
}

TEST(Sinumerik, DirectionsOfTheToolAreOneError) {
  const std::string moves = "G1 X1 A3=0 B3=0 C3=1 F100\nG1 X2 A3=0 B3=0.1 C3=1\nG1 X3 A3=0 C3=1\n";
  EXPECT_EQ(run("TRAORI\n" + moves + "TRAFOOF\nG1 X5\n"), "1,0,0 5,0,0 not-supported");
  EXPECT_EQ(run("TRAORI(1)\nG1 X1 A0 C0 F9\nX2 A2=0 B2=0 C2=0\nX3 A3=0 C3=1\nTRAFOOF\n"),
            "1,0,0 2,0,0 3,0,0 ");
  EXPECT_EQ(run("TRAORI\nG1 X1 A3=0 B3=0 C3=-1 F9\n"), "not-supported");
  EXPECT_EQ(run("TRAORI\nG1 X1 A5=0 B5=0 C5=1 F9\n"), "not-supported");
  EXPECT_EQ(
      codes(read_text("TRAORI\nG1 X1 Z1 F9\n", at_origin(Dialect::sinumerik, MachineKind::lathe))),
      "not-supported")
      << "a tool of a lathe that turns about Y";
  const Program p = read_text(moves, at_origin(Dialect::sinumerik));
  EXPECT_EQ(codes(p), "not-supported");
  EXPECT_EQ(codes(p, Severity::note), "not-supported told-once");
  EXPECT_EQ(p.motions.size(), 0U);
  EXPECT_EQ(p.diagnostics.back().text.substr(0, 6), "2 more");
}

TEST(Sinumerik, AxesAndCodesMayBeChosenByIndex) {
  EXPECT_EQ(run("DEF AXIS WAY=X\nF100 G1 AX[WAY]=5 AX[Y]=R1*2\nG[14]=2\nAX[Z]=-1\nAX[Z]=-1\n"
                "G[14]=1 AX[X]=IC(1)\n"),
            "5,6,0 5,6,-1 5,6,-2 6,6,-2 ");
  EXPECT_EQ(run("F100 G1 AX[A]=5\n"), "variable-unset");
  EXPECT_EQ(run("F100 G[1]=99 X1\n"), "not-supported");
}

TEST(Sinumerik, OffnAddsToTheRadius) {
  // The tool of 5 mm keeps 5.5 mm from the contour.
  EXPECT_EQ(run("F100 G1 X-20 Y-20\nOFFN=0.5\nG41 X0 Y0 D1\nY50\nG40 X-20\nOFFN=0\n"),
            "-20,-20,0 -5.5,0,0 -5.5,50,0 -20,50,0 ");
}

// Blanks may stand on both sides of the sign of an assignment.
TEST(Sinumerik, BlanksMayStandAboutTheSignOfAssignments) {
  EXPECT_EQ(run("R1 = 5\nR2 =R1 * 2\nF100 G1 X = R1 Y=R2\nR1\t= R1 + 1\nX=R1\n"), "5,10,0 6,10,0 ");
  EXPECT_EQ(run("F100 G1 CIP X10 Y0 I1 = 5 J1 = 5\n"), run("F100 G1 CIP X10 Y0 I1=5 J1=5\n"));
  EXPECT_EQ(run("F100 G1\nsub\nM30\n%_n_sub_spf\nx7\nm17\n"), "7,0,0 ");
}

TEST(Sinumerik, CyclesTakeExpressions) {
  EXPECT_EQ(run("F100 G0 Z50\nCYCLE82(50,0,2,-R1*2,,0.5)\n"),
            run("F100 G0 Z50\nCYCLE82(50,0,2,-6,,0.5)\n"));
  EXPECT_EQ(run("F100 G0 Z50\nCYCLE82(50,0,2,-R9,,0.5)\n"), "0,0,50 variable-unset");
}

TEST(Sinumerik, DefinitionsAreReadFromFiles) {
  const TempFolder scratch;
  const std::string defs = scratch.write(
      "UGUD.DEF",
      "; user data\nDEF NCK REAL WIDTH=7\nDEF CHAN SYNRW INT PHU 1 LLI 0 ULI 9 _COUNT[2]=SET(3,4)\n"
      "DEF NCK STRING[16] APRP 7 APWP 7 _NAME=\"A\"\nM17\n");
  InterpOptions options = at_origin(Dialect::sinumerik);
  options.search_path = {defs};
  const Program p =
      read_text("F100 G1 X=WIDTH Y=_COUNT[1]\nSUB\nM30\n%_N_SUB_SPF\nX=WIDTH*2\nM17\n", options);
  EXPECT_EQ(codes(p), "");
  ASSERT_EQ(p.motions.size(), 2U);
  expect_near(p.motions[0].end, {7, 4, 0});
  expect_near(p.motions[1].end, {14, 4, 0});
  options.search_path = {scratch.write("MGUD.DEF", "DEF NCK NUMBER WIDTH\n")};
  EXPECT_EQ(codes(read_text("F100 G1 X1\n", options)), "statement");
}

TEST(Sinumerik, SearchPathsAreReadOver) {
  EXPECT_EQ(run("CALLPATH(\"/_N_WKS_DIR/_N_LIB_WPD\")\nF100 G1 X1\nCALLPATH()\n"), "1,0,0 ");
}

// Measuring cycles cut nothing; CYCLE978 is none of turning.
TEST(Sinumerik, MeasuringCyclesAreANote) {
  const std::string text =
      "G0 X0 Y0 Z5\nCYCLE978(0,1,,1,20,,30,,1)\nG0 X5 Y5\nZ2\nG1 Z-1 F100\nX9\n"
      "CYCLE996(1)\nG1 X20\nM30\n";
  const Program p = read_text(text, at_origin(Dialect::sinumerik));
  EXPECT_EQ(codes(p, Severity::note), "probe");
  std::string assumed;
  for (const Motion& m : p.motions) assumed += m.assumed_start ? '?' : '.';
  EXPECT_EQ(assumed, ".??..?");
  InterpOptions options = at_origin(Dialect::sinumerik);
  options.machine = MachineKind::automatic;
  EXPECT_EQ(read_text(text, options).machine, MachineKind::mill);
}

// MEAS and MEAW beside a move: it ends where the probe touches.
TEST(Sinumerik, MovesOfAProbeEndWhereItTouches) {
  for (const char* word : {"MEAS=1", "MEAS=-1", "MEAW=2"}) {
    const Program p =
        read_text(std::string("G0 X0 Y0 Z0\n") + word + " G1 X30 F300\nG0 X5\nG1 Y9\n",
                  at_origin(Dialect::sinumerik));
    EXPECT_EQ(codes(p), "") << listing(p);
    EXPECT_EQ(codes(p, Severity::note), "probe");
    ASSERT_EQ(p.motions.back().kind, MotionKind::line);
    EXPECT_EQ(p.motions.back().start.x, 5);
    EXPECT_EQ(p.motions.back().end.y, 9);
  }
}

// CALL BLOCK runs a part of the program, PCALL a program by its path, GOTOS the program again.
TEST(Sinumerik, PartsOfAProgramAndPathsMayBeCalled) {
  const std::string part = "\nGOTOF ENDE\nKA: X2\nY5\nKB: Y7\nX0\nENDE:\nX9\nM30\n";
  const std::string path = "1,0,0 2,0,0 2,5,0 2,7,0 9,7,0 ";
  EXPECT_EQ(run("G1 F9 X1\nCALL BLOCK KA TO KB" + part), path);
  EXPECT_EQ(run("G1 F9 X1\nCALL BLOCK \"KA\" TO \"KB\"" + part), path);
  EXPECT_EQ(run("DEF STRING[8] VON=\"KA\"\nG1 F9 X1\nCALL BLOCK VON TO KB" + part), path);
  EXPECT_EQ(run("G1 F9 X1\nCALL BLOCK KA KB" + part), "1,0,0 statement");
  EXPECT_EQ(run("G1 F9 X1\nCALL \"P\" BLOCK KA TO KB\nX2\n"), "1,0,0 2,0,0 not-supported");
  const std::string sub = "\nM30\n%_N_HOLES_SPF\nPROC HOLES(REAL A1,REAL B1=3)\nX=A1 Y=B1\nM17\n";
  for (const char* call : {"PCALL \"/_N_WKS_DIR/_N_PART_WPD/_N_HOLES_SPF\"(5)",
                           "PCALL/_N_SPF_DIR/HOLES.SPF(5)", "PCALL HOLES(5)"})
    EXPECT_EQ(run("G1 F9 X1\n" + std::string(call) + sub), "1,0,0 5,3,0 ") << call;
  EXPECT_EQ(run("G1 F9 X1\nPCALL\nX2\n"), "1,0,0 statement");
  const Program again = read_text("G1 F9 X1\nX2\nGOTOS\nX3\n", at_origin(Dialect::sinumerik));
  EXPECT_EQ(again.motions.size(), 2U);
  EXPECT_EQ(codes(again, Severity::note), "program-loops");
  EXPECT_EQ(run("R1=0 G1 F9\nR1=R1+1 X=R1\nIF R1<0 GOTOS\n"), "1,0,0 ");
}

// What a program has put into markers, parameters and outputs can be read; inputs can not.
TEST(Sinumerik, MarkersAndOutputsKeepTheirValues) {
  EXPECT_EQ(run("$AC_MARKER[1]=3 $A_OUT[2]=TRUE\n$AC_TIMER[1]=0\nG1 F9 X=$AC_MARKER[1]*2\n"),
            "6,0,0 ");
  EXPECT_EQ(run("G1 F9 X=$AC_PARAM[7]\n"), "variable-unset");
  EXPECT_EQ(run("R1=$A_IN[1]\nG1 F9 X1\n"), "1,0,0 variable-unset");
  EXPECT_EQ(run("T1 M6 ; SCHAFTFRAESER D6\nG1 F9 X=$TC_DP6[1,1]\n"), "3,0,0 ");
}

TEST(Sinumerik, SynchronisedActionsAreNamed) {
  for (const char* text : {"ID=1 WHEN $AA_IW[X]>5 DO M8\n", "WHENEVER $AA_IW[X]>5 DO M8\n"}) {
    const Program p = read_text(text, at_origin(Dialect::sinumerik));
    EXPECT_NE(listing(p).find("is a synchronised action"), std::string::npos) << listing(p);
  }
  const Program slot = read_text("SLOT1=5\n", at_origin(Dialect::sinumerik));
  EXPECT_NE(listing(slot).find("no variable of DEF"), std::string::npos) << listing(slot);
}

TEST(Sinumerik, CountersOfPartsBeginAtZero) {
  EXPECT_EQ(run("$AC_ACTUAL_PARTS=$AC_ACTUAL_PARTS+1\nG1 F9 X=$AC_ACTUAL_PARTS\n"
                "IF $AC_TOTAL_PARTS<5 GOTOF AA\nX9\nAA: X2\n"),
            "1,0,0 2,0,0 ");
  EXPECT_EQ(run("G1 F9 X=$AC_TOTAL_PARTS[1]\n"), "variable-unset") << "it has no index";
}

// The type of a tool and the orientation of its tip are read back as the program has set them, and
// so is the wear of its radius.
TEST(Sinumerik, ToolDataThatWereSetAreReadBack) {
  EXPECT_EQ(run("$TC_DP1[1,1]=120 $TC_DP2[1,1]=3\nG1 F9 X=$TC_DP1[1,1] Y=$TC_DP2[1,1]\n"),
            "120,3,0 ");
  EXPECT_EQ(run("$TC_DP1[1,1]=120\nG1 F9 X=$TC_DP1[2,1]\n"), "variable-unset");
  EXPECT_EQ(run("$TC_DP6[1,1]=5 $TC_DP15[1,1]=-0.2\nG1 F9 X=$TC_DP6[1,1] Y=$TC_DP15[1,1]\n"),
            "5,-0.2,0 ");
}

// 802S and 802C: G158, G258, G259 are TRANS, ROT, AROT; LCYC82 and its kin read R parameters.
TEST(Sinumerik, FramesAndCyclesOf802AreThoseOf840) {
  EXPECT_EQ(run("F9 G1\nG158 X5 Y2\nX1 Y0\nG259 RPL=90\nX1\nG258 RPL=90\nX2 Y0\nG158\nX3\n"),
            "6,2,0 6,3,0 0,2,0 3,2,0 ");
  const std::string levels = "F9 G0 Z5\nR101=5 R102=1 R103=0 R104=-9 R105=0\n";
  EXPECT_EQ(run(levels + "X1\nLCYC82\n"), "0,0,5 1,0,5 1,0,1 1,0,-9 1,0,5 ");
  const std::string deep = "R107=7 R108=9 R109=0 R110=-4 R111=1 R127=0\n";
  EXPECT_EQ(run(levels + deep + "LCYC83\n"),
            "0,0,5 0,0,1 0,0,-4 0,0,-3 0,0,-7 0,0,-6 0,0,-9 0,0,5 ");
  const Program drilled = read_text("G0 Z5\n" + levels.substr(levels.find('R')) + deep + "LCYC83\n",
                                    at_origin(Dialect::sinumerik));
  EXPECT_EQ(codes(drilled), "");
  EXPECT_EQ(drilled.motions[2].feed, 7);
  const std::string row = "R115=82 R116=1 R117=2 R118=3 R119=2 R120=90 R121=5\n";
  EXPECT_EQ(run(levels + row + "LCYC60\n"),
            "0,0,5 1,5,5 1,5,1 1,5,-9 1,5,5 1,10,5 1,10,1 1,10,-9 1,10,5 ");
  EXPECT_EQ(run(levels + "R115=82 R116=1 R117=0 R118=3 R119=2 R120=0 R121=0\nLCYC61\n"),
            "0,0,5 4,0,5 4,0,1 4,0,-9 4,0,5 -2,0,5 -2,0,1 -2,0,-9 -2,0,5 ");
  EXPECT_EQ(run(levels + "R115=75 R116=1 R117=2 R118=3 R119=2 R120=90 R121=5\nLCYC60\n"),
            "0,0,5 value-range");
  EXPECT_EQ(run("G0 Z5\nLCYC82\n"), "0,0,5 variable-unset");
  EXPECT_EQ(run("G0 Z5\nLCYC93\n"), "0,0,5 not-supported");
  const auto pocket = [](const std::string& text) {
    return path_text(read_text("T1 M6 ; SCHAFTFRAESER D10\nF9 G0 Z5\n" + text + "\n",
                               at_origin(Dialect::sinumerik)));
  };
  EXPECT_EQ(pocket("R101=5 R102=1 R103=0 R104=-3 R116=1 R117=2 R118=40 R119=30 R120=6 R121=2 "
                   "R122=50 R123=90 R124=0 R125=0 R126=3 R127=1\nLCYC75"),
            pocket("POCKET3(5,0,1,-3,40,30,6,1,2,0,2,0,0,90,50,3,11)"));
}

TEST(SinumerikCycles, ATextInThePlaceOfANumberIsNamed) {
  const Program p =
      read_text("T=\"A\"\nCYCLE81(10,0,\"X\",-5)\nM30\n", at_origin(Dialect::sinumerik));
  ASSERT_EQ(codes(p), "expression");
  EXPECT_NE(p.diagnostics.back().text.find("CYCLE81: value 3, SDIS, is a text"), std::string::npos)
      << p.diagnostics.back().text;
}

// With zeros of the machine, $P_IFRAME counts from the machine's zero, as $P_UIFR does.
TEST(Sinumerik, TheSettableFrameInForceCountsFromTheMachinesZero) {
  InterpOptions options = at_origin(Dialect::sinumerik);
  options.places.zero = {{"G54", {-200, -100, -300}}, {"G55", {-150, -100, -300}}};
  const auto path = [&](const std::string& text) { return path_text(read_text(text, options)); };
  EXPECT_EQ(path("G54 G1 F9\n$P_IFRAME=$P_UIFR[2]\nX1\n"), "l51,0,0");
  EXPECT_EQ(path("G54 G1 F9\n$P_IFRAME[X,TR]=$P_IFRAME[X,TR]+50\nX1\n"), "l51,0,0");
  EXPECT_EQ(path("G55 G1 F9\nR1=$P_IFRAME[X,TR]-$P_UIFR[2,X,TR]\nX=R1+1\n"), "l51,0,0");
}

// $P_IFRAME = ... holds until a settable frame is chosen again.
TEST(Sinumerik, TheSettableFrameInForceCanBeSet) {
  const auto path = [](const std::string& text) {
    return path_text(read_text(text, at_origin(Dialect::sinumerik)));
  };
  const std::string first = "$P_UIFR[2]=CTRANS(X,10,Y,20)\nG54 G1 F9\n";
  EXPECT_EQ(path(first + "$P_IFRAME=$P_UIFR[2]\nX1 Y1\nG54 X1 Y1\n"), "l11,21,0 l1,1,0");
  EXPECT_EQ(path(first + "$P_IFRAME[X,TR]=5\nX1\n$P_IFRAME[Z,RT]=90\nX1 Y0\nG500 X1\n"),
            "l6,0,0 l5,1,0 l1,1,0");
  EXPECT_EQ(path("G1 F9\n$P_IFRAME=CROT(X,30)\nX1\n"), "l1,0,0 | variable-unset");
}

// QU: the control puts M and H out before the block's motion has ended.
TEST(Sinumerik, QuickOutputsOfMAndHAreRead) {
  EXPECT_EQ(path_text(read_text("M=QU(8)\nH=QU(3)\nG1 X1 F9\n", at_origin(Dialect::sinumerik))),
            "l1,0,0");
}

}  // namespace
}  // namespace mrsim
