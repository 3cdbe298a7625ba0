// Control and machine from the text of real posts, and what is refused by name.
#include "interp/recognise/recognise.h"
#include "interp/support.h"

#include <string>
#include <vector>

namespace mrsim {
namespace {

using namespace mrsim::testing;

Recognition recognised(const std::string& text, const std::string& name = "a.nc") {
  const TempFolder scratch;
  return recognise(scratch.write(name, text), {});
}

std::string refusal(const std::string& text, const std::string& name = "a.nc") {
  try {
    recognised(text, name);
  } catch (const PlacedError& error) {
    EXPECT_EQ(error.code(), "control-unsupported");
    return error.diagnostic().text;
  }
  return "";
}

// Listings of FANUC programs print the end of a block; an O number is no Heidenhain's.
TEST(RecogniseDialect, SignsAtTheEndsOfBlocksAreNoOtherControl) {
  for (const char* sign : {"*", "$"}) {
    const std::string text = fmt::format("%\nO1000{0}\nN10 G90{0}\nN20 G1 X5. F100{0}\n", sign);
    InterpOptions options = at_origin(Dialect::automatic);
    EXPECT_EQ(path_text(read_text(text, options)), "l5,0,0") << sign;
  }
}

TEST(RecogniseDialect, OutputOfPostsIsRecognised) {
  struct Row {
    const char* text;
    Dialect dialect;
  };
  const Row rows[] = {
      {"O100 SUB\nG1 X1 Y1 F1\nO100 ENDSUB\nO100 CALL\nM2\n", Dialect::ngc},
      {"o<pocket> sub\nG1 X1 Y1 F1\no<pocket> endsub\nM2\n", Dialect::ngc},
      {"G20\n#1=3\nO101 IF [#1 GT 2]\nG1 X1 Y1 F1\nO101 ENDIF\nM2\n", Dialect::ngc},
      {"#<depth> = 5\nG1 X1 Y#<depth> F1\nM2\n", Dialect::ngc},
      {"(Exported by FreeCAD)\n(Post Processor: linuxcnc_post)\nG17 G54 G40 G49 G80 G90\nG21\n"
       "T1 M6\nG43 H1\nG0 X0 Y0\nG1 Z-1 F100\nM2\n",
       Dialect::ngc},
      {"(Carbide Create)\nG21\nG90\nM05\nM6T102\nM03S8000\nG0X1Y1\nG1Z-1F100\nM02\n", Dialect::ngc},
      {"; generated for Grbl\nG21 ; mm\nG90\nG0 X1 Y1\nG1 Z-1 F100\nM2\n", Dialect::ngc},
      {"G90 G94 G17 G91.1\nG21\nG64 P0.02\nT1 M6\nG0 X1 Y1\nG1 Z-1 F10\nM30\n", Dialect::ngc},
      {"%\nO1001 (PART)\nG21\nG0 G17 G40 G49 G80 G90\nT1 M6\nG0 G90 G54 X1. Y1. S1000 M3\n"
       "G43 H1 Z5.\nG98 G81 Z-5. R1. F100.\nG80\nM30\n%\n",
       Dialect::fanuc},
      {"$PART1.MIN%\nG15 H1\nG0 X1 Y1\nG1 Z-1 F100\nM02\n", Dialect::fanuc},
      {"\xEF\xBB\xBF%\rO0001\rG90 G0 X1. Y1.\rG98\rG81 Z-5. R1. F100.\rM30\r%\r", Dialect::fanuc},
      {"N0; Post Processor: proLIGHT 1000\nN1; Units: Metric\nN2G05\nN3G0X1Y1\nN4G1Z-1F9; Plunge\n",
       Dialect::iso},
      {"G21\nG98\nG1 X1 Y1 F100\nG99\nX2\n", Dialect::iso},
      {"%\nG21\n(P1=5)\nN10 G1 X(P1+2) YP1 F100\n(P1=P1-1)\n(IF (P1 GT 0) GOTO N10)\nM30\n",
       Dialect::iso},
      {"%\nN10 G1 X1 Y1 F100\nN20 X2\n(RPT N10,N20) N3\nM30\n", Dialect::iso},
      {"#100=5\nIF [#100 EQ 5] GOTO 10\nG1 X1 Y1\nN10 M30\n", Dialect::fanuc},
      {"N5 G0 X100 Y100 Z-1\nN10 G1 X100 Y100 F100\nN15 G98\nN20 G2 X200 Y100 I150 J100\n",
       Dialect::codesys},
      {"%\nN1O1(FADAL)\nN2 G0 G17 G40 G90\nN3 G1 X1 Y1 F9\nN4 M30\n", Dialect::fanuc},
      {"N10 G0 X0 Y0\nN20 G52 D3\nN30 G1 X10 Y10 F100\n", Dialect::codesys},
      {"%\nN5 G17 G71 G90 G94\nN10 T1 M6 ; cutter 20mm\nN15 G1 X5 Y5 F9\nN20 G4 F1.5\nN25 M30\n",
       Dialect::sinumerik},
      {"N10 G0 X0 Y0\nN20 G51 D3\nN30 G1 X10 Y10 F100\n", Dialect::codesys},
      {"N10 G0 X0 Y0\nN20 G41 D3.5\nN30 G1 X10 Y10 F100\n", Dialect::codesys},
      {"N0 G36 D5\nN20 G1 X2 Y1 F100\nN30 G37 D-1\nN40 G20 L20\n", Dialect::codesys},
      {"G21 G90\nG52 X5 Y5\nG1 X1 Y1 F9\nG52 X0 Y0\n", Dialect::fanuc},
      {"; machine: Snapmaker 2.0 A350\nM3 P100\nG0 X1 Y1 F900\nG1 Z-1 F100\n", Dialect::ngc},
      {"N10 G291\nN20 G21 G40 G90 G95\n;GOTOF FINE\nN30 G54 G0 X1 Z1\nN40 G1 X2 F.1\n",
       Dialect::fanuc},
      {"G54 G0 X1 Y1\nG291\nM98 P10\nG290\nG1 X=R1 F9 ; back\n", Dialect::sinumerik},
      {"N10 G54 G90 G94\nN20 IF R1==2 GOTOF END\nN30 G1 X1 Y1\nN40 ENDIF\n", Dialect::sinumerik}};
  for (const Row& row : rows) {
    const Recognition r = recognised(row.text);
    EXPECT_EQ(static_cast<int>(r.dialect), static_cast<int>(row.dialect))
        << row.text << r.dialect_reason;
  }
}

TEST(RecogniseMachine, CommentsDecideNothing) {
  struct Row {
    const char* text;
    MachineKind machine;
  };
  const Row rows[] = {
      {"(SPINDLE TURNING CW)\nG90 G0 X0 Z5\nG1 Z-1 F100\nX20\nM30\n", MachineKind::automatic},
      {"(RETURNING)\nG90 G0 X0 Z5\nG1 Z-1 F100\nX20\nM30\n", MachineKind::automatic},
      {"(TURNING TOOL)\nG90 G0 X0 Z5\nG1 Z-1 F100\nX20\nM30\n", MachineKind::automatic},
      {"(END MILL D10)\nG90 G0 X0 Z5\nG1 Z-1 F100\nX20\nM30\n", MachineKind::automatic},
      {"T1 M6 (END MILL D10)\nG90 G0 X0 Z5\nG1 Z-1 F100\nX20\nM30\n", MachineKind::mill},
      {"T1 M6\nG43 H1 Z50\nG90 G0 X0 Z5\nG1 Z-1 F100\nX20\nM30\n", MachineKind::mill},
      {"T1 M6\nG90 G0 X0 Y#1\nG1 Z-1 F100\nM30\n", MachineKind::mill},
      {"G90 G0 X0 Y[#1+2]\nG1 Z-1 F100\nM30\n", MachineKind::mill},
      {"G90\nG71\nG0 X0 Y0 Z5\nG1 Z-1 F100\nM30\n", MachineKind::mill},
      {"O1\nG70\nG0 X0 Z5\nG1 Z-1 F100\nM30\n", MachineKind::automatic},
      {"O1\nG0 X50. Z2.\nG94 X20. Z-1. F.2\nM30\n", MachineKind::lathe},
      {"O1\nG0 X50. Z2.\nG71 U2. R.5\nG71 P10 Q20 U.4 W.1 F.2\nN10 G0 X20.\nN20 G1 Z-20.\nM30\n",
       MachineKind::lathe},
      {"O1\nG0 X60 Z5 T010101\nG1 Z-10 F.2\nM2\n", MachineKind::lathe},
      {"O1\nT123456 M6\nG0 X60 Y0 Z5\nG1 Z-10 F.2\nM2\n", MachineKind::mill},
      {"O1\nG28 U0 W0\nG0 X50. Z2.\nG1 Z-2.\nM30\n", MachineKind::lathe},
      {"O1\n(T0909 LIVE DRILL D=6)\nT0909\nG97 S900 M133\nG0 X30. Z5.\nC90.\nM30\n",
       MachineKind::lathe},
      // Drills and taps alone in a turret, G97 and no M6.
      {"O1\n(T0202 DRILL 8MM)\n(T0404 M10 TAP)\nT0202\nG97 S900 M3\nG0 X0 Z5.\nG83 Z-25. R2. "
       "F.1\nM30\n",
       MachineKind::lathe},
      {"O1\n(T0101 END MILL D10)\nG17\nT0101\nG0 X30. Z5.\nG1 Z-1. F100\nM30\n", MachineKind::mill},
      {"G18 G21 (CNMG 120408)\nG0 X50 Z2\nG1 Z-2 F.1\nM2\n", MachineKind::lathe},
      {"O100 sub\nG0 X1 Z5\nO100 endsub\nM2\n", MachineKind::mill},
      {"G17 G54 G90\nT=\"CUTTER\"\nM6\nPOCKET3(50,0,2,-5,30,20,5,25,20,0,2.5)\nM30\n",
       MachineKind::mill},
      {"N10 G90 G96 S200\nN20 G86 X30 Z0 Q30 R-20 I-1.3 B0.3 D1 L0.05 C2 J2 A30\n",
       MachineKind::lathe},
      {"G7\nG0 X50 Z2\nG76 P1 Z-10 I-1 J0.1 K0.5 R1 Q30 H2 E0 L0\nM2\n", MachineKind::lathe}};
  for (const Row& row : rows) {
    const Recognition r = recognised(row.text);
    EXPECT_EQ(static_cast<int>(r.machine), static_cast<int>(row.machine))
        << row.text << r.machine_reason;
  }
}

// SINUMERIK writes CR=; R10 is a variable there.
TEST(RecognisePosts, AnArcWithRIsNotSinumeriks) {
  const std::string head = "%100\nN20 T1 D1 M6\n; FRESA D10\nN30 G0 X0 Y0 Z5\n";
  EXPECT_NE(recognised(head + "N70 G3 X30 Y20 R10\nN80 M30\n").dialect, Dialect::sinumerik);
  EXPECT_EQ(recognised(head + "N65 R10=5\nN70 G3 X=R10 Y20 CR=R10\nN80 M30\n").dialect,
            Dialect::sinumerik);
}

TEST(RecogniseForeign, ForeignLanguagesAreNamedAndRefused) {
  EXPECT_NE(refusal("0 BEGIN PGM PART MM\n1 BLK FORM 0.1 Z X+0 Y+0 Z-20\n").find("Heidenhain"),
            std::string::npos);
  EXPECT_NE(
      refusal("BEGIN PGM PART MM\nTOOL CALL 1 Z S1000\nL X+10 R0 FMAX\n", "a.H").find("Heidenhain"),
      std::string::npos);
  EXPECT_NE(refusal("%PLATE G71 *\nN10 G30 G17 X+0 Y+0 Z-40*\n").find("DIN/ISO"),
            std::string::npos);
  EXPECT_NE(
      refusal("%PLATE G71\nN10 G30 G17 X+0 Y+0 Z-40\nN20 G31 G90 X+90 Y+90 Z+0\n").find("DIN/"),
      std::string::npos);
  EXPECT_EQ(refusal("%\nO1\nG91 G30 Z0\nG90 G17 G30 P2 X0 Y0\nG1 X5 Y0 F100\nM30\n"), "");
  EXPECT_EQ(refusal("N10 G54\nN70 TRANS X=R11*(R10-1)\nN80 G1 X1 Y1 F100\n"), "");
  EXPECT_EQ(refusal("G50 S2000\nG85 NAP1 D3 F.3 U.4 W.2\n"), "");
  EXPECT_EQ(recognised("N1 G15 H1\nN6 CALL O100 Q3\nG1 Y1\n").dialect, Dialect::fanuc);
  EXPECT_EQ(recognised("N10 VC12 = 3\nG1 Z=-VC12 Y1\n", "a.MIN").dialect, Dialect::fanuc);
  EXPECT_EQ(refusal("$A.MIN%\nN10 G15 H1\nG1 X1 Y1 F100\n", "a.MIN"), "");
  EXPECT_NE(refusal("PROGRAMMKOPF\n#MATERIAL Stahl\n").find("DIN PLUS"), std::string::npos);
  EXPECT_NE(refusal("module Part\nprogram\n", "a.simpl").find("SimPL"), std::string::npos);
  EXPECT_NE(refusal("UNo. MAT INITIAL-Z ATC MODE\n0 CBN STL 50. 0\n").find("Mazatrol"),
            std::string::npos);
  EXPECT_NE(refusal("N1 E_HEAD(1000,1,50)\nN2 E_END(0,1)\n").find("ShopMill"), std::string::npos);
  EXPECT_NE(refusal("G0 X1\n", "PART.PBG").find("Mazatrol"), std::string::npos);
  EXPECT_NE(refusal("IGF\n").find("Okuma IGF"), std::string::npos);
  EXPECT_NE(refusal("%10\nN10 G0 G52 Z0\nN20 T1 D1 M6\nN30 G1 X5 Y0 F100\nM2\n").find("NUM"),
            std::string::npos);
  EXPECT_NE(refusal("N50 G1 X5 Y0 F100\nN60 G77 N10 N50\nM2\n").find("NUM"), std::string::npos);
  for (const char* block : {"G80 X45 Z-30 F100", "G81 X20 Z-2 F100", "G82 X30 Z-20 F2",
                            "G71 U1.5 R1 P6 Q12 X0.4 Z0.1 F120"}) {
    const std::string text = std::string("T0101\nM3 S500\nG0 X50 Z5\n") + block + "\nM30\n";
    EXPECT_NE(refusal("%3327\n" + text).find("Huazhong"), std::string::npos) << block;
  }
  EXPECT_EQ(refusal("%3327\nT1 M6\nG90 G0 X10 Y0 Z5\nG81 X10 Y5 Z-3 R2 F100\nG80\nM30\n"), "");
  EXPECT_EQ(refusal("%\nO10\nN10 G0 G52 X0 Y0\nG1 X5 Y0 F100\nM30\n"), "");
  EXPECT_NE(refusal("#1 = 0\nwhile [#1 lt 3]\nG1 X#1 Y1 F9\nendwhile\n").find("Eding"),
            std::string::npos);
  EXPECT_NE(refusal("%PM9001\nN9001\nN1 G17 T1 M6\nN2 G81 Y2 Z-10\nN3 G79 X9 Y9 Z0\n").find("MAHO"),
            std::string::npos);
  EXPECT_NE(refusal("G0 X1 Y1\n$FOR P1=0,3,1\nG1 X[P1] F9\n$ENDFOR\n").find("8070"),
            std::string::npos);
  EXPECT_EQ(refusal("%PMX1,MX,\nG71\nG0 X1 Y1 Z5\nG1 Z-1 F100\n"), "");
  EXPECT_EQ(refusal("O1\n#1=0\nWHILE[#1LT3]DO1\nG1X#1Y1F9\n#1=#1+1\nEND1\nM30\n"), "");
  EXPECT_NE(refusal("O1 (STAR SB-20)\nT0100\nG0 X13. Z-1.\nG1 Z10. F.05\n").find("headstock"),
            std::string::npos);
  EXPECT_NE(
      refusal("G21\nG92 X0 Y0 Z0\nM300 S30\nG1 X9 Y9 F900\nM300 S50\nG1 X0\n").find("plotter"),
      std::string::npos);
  EXPECT_EQ(refusal("G21\nM300 S440 P200\nG1 X9 Y9 F900\nM300 S440 P200\n"), "");
  EXPECT_NE(refusal("'SHOPBOT FILE IN MM\nSA\nTR,18000\nJZ,5\nM3,50,10,-2\n").find("ShopBot"),
            std::string::npos);
  EXPECT_EQ(refusal("G21 G90\nM48\nG0 X1 Y1\nG1 Z-1 F100\n"), "");
  EXPECT_NE(refusal("M48\nMETRIC,TZ\nT1C0.8\n%\nG90\nT1\nX10.0Y10.0\nM30\n").find("Excellon"),
            std::string::npos);
  EXPECT_NE(refusal("%FSLAX24Y24*%\n%MOMM*%\nD10*\nX0Y0D02*\nM02*\n").find("Gerber"),
            std::string::npos);
  EXPECT_NE(refusal("IN;SP1;PU0,0;PD400,0;PU;\n").find("HPGL"), std::string::npos);
  EXPECT_NE(refusal("PA;VS10;!VZ10;!PZ-40,200;!MC1;\nZ0,0,200\n").find("Roland"),
            std::string::npos);
  EXPECT_NE(refusal("IMF_PBL_V1.0\nVEL 40000\nFASTABS X10000 Y10000\n").find("isel"),
            std::string::npos);
  EXPECT_NE(refusal("[H\nVERSION=\"4.0\"\n<100 \\WerkStck\\\nLA=\"800\"\n").find("woodWOP"),
            std::string::npos);
  EXPECT_EQ(refusal("M300 S440\nG21 G90\nM300 S880\nS12000 M3\nG0 X0 Y0\nG1 Z-1 F100\nX9\n"), "");
  EXPECT_NE(refusal("O1 (CITIZEN L20)\nT0100\nG0 X13. Z-1.\nG1 Z10. F.05\n").find("headstock"),
            std::string::npos);
  EXPECT_NE(refusal("O1\n$1\nT0100\nG0 X13. Z-1.\nG1 Z10. F.05\n").find("several paths"),
            std::string::npos);
  EXPECT_NE(refusal("N10 G95 G96 S200\nN20 G68 X20 Z0 C2 D1 L0.3 M0.1 F0.2 H0.1 S100 E120\n")
                .find("Fagor lathe"),
            std::string::npos);
  EXPECT_NE(refusal("N10 G0 X62 Z2\nN20 G81 X40 Z0 Q60 R-30 C2 D1\n").find("Fagor lathe"),
            std::string::npos);
  EXPECT_EQ(refusal("O1\nG68 X0 Y0 R30.\nG1 X5 Y5 F100\nG69\nG81 X1 Y1 Z-5. R2. C90.\n"), "");
  EXPECT_NE(refusal("%MPF 90\n( DRILLS )\nN10 G0 X1 Y1\n", "a.mpf").find("840C"),
            std::string::npos);
  EXPECT_NE(refusal("%MPF 90\nN1 @371 R52 K2 K0\nN10 G0 X1 Y1\n").find("840C"), std::string::npos);
  EXPECT_EQ(refusal("%MPF 90\nN10 G0 X1 Y1 ; place\nN20 G1 Z-1 F9\n"), "");
  EXPECT_NE(refusal("% @MACRO\n@1:=10;\n").find("Syntec"), std::string::npos);
  EXPECT_NE(refusal("M140 S60\nM104 S210\nG28\nG1 X10 Y10 E0.5 F1200\n").find("3-D printer"),
            std::string::npos);
  EXPECT_NE(
      refusal("G21\nG90\nM4 S0\nG0 X0 Y0\nG1 X10 S500 F1000\nG1 Y10 S300\nM5\nM2\n").find("laser"),
      std::string::npos);
  EXPECT_NE(refusal("G21\nG90\nG0 X0 Y0\nM3 S255\nG1 X10 F1000\nM5\nG0 X20 Y20\nM3 S255\n"
                    "G1 X30\nM5\nM2\n")
                .find("laser"),
            std::string::npos);
}

TEST(RecogniseForeign, MillsAndLathesAreNot) {
  for (const char* text :
       {"G21\nG90\nM3 S1000\nG0 X0 Y0 Z5\nG1 Z-1 F100\nG1 X10 Y10\nM5\nM2\n",
        "M3 S1000\nG1 X10 Y10 F100\nM5\n", "G96 S200 M4\nG0 X50\nG1 X-1 F.1\nM5\nM30\n",
        "M104\nG1 X10 Y10 Z1 F100\n", "G1 X1 Y1 M3 S100\nM98 P2\nM5\nM3 S200\nM5\n",
        "N10 G2 X1 Y1 I1 J1 E5 E-5\n"})
    EXPECT_EQ(refusal(text), "") << text;
  InterpOptions told;
  told.dialect = Dialect::fanuc;
  told.machine = MachineKind::mill;
  const TempFolder scratch;
  EXPECT_NO_THROW(recognise(scratch.write("a.nc", "M4 S0\nG1 X1 Y1 S5\nG1 X2 S6\nM5\n"), told));
}

// The ending is that of many controls: it stands back where the text speaks of tools.
TEST(RecogniseDialect, TheEndingCncAloneDecidesOnlyWithoutTools) {
  const auto dialect = [](const char* text) {
    return static_cast<int>(recognised(text, "a.cnc").dialect);
  };
  EXPECT_EQ(dialect("N5 G0 X1 Y1 Z-1\nN10 G1 X9 F100\n"), static_cast<int>(Dialect::codesys));
  EXPECT_EQ(dialect("T1 M6\nG0 X0 Y0\nG1 Z-1 F100\n"), static_cast<int>(Dialect::iso));
  EXPECT_EQ(dialect("G0 X0 Y0 S1000 M3\nG1 Z-1 F100\n"), static_cast<int>(Dialect::iso));
  EXPECT_EQ(dialect("N1 M6\nN2 G36 D5\nN3 G1 X1 F9\n"), static_cast<int>(Dialect::codesys));
}

// G74 with R alone sets the strokes of a lathe's deep hole; that of a mill taps.
TEST(RecogniseMachine, G74WithRAloneIsALathes) {
  const std::string head = "%\nO1\nG21\nT0505 (DRILL 20)\nG0 X0. Z3.\n";
  EXPECT_EQ(recognised(head + "G74 R1.\nG74 Z-40. Q8000 F.1\nM30\n").machine, MachineKind::lathe);
  EXPECT_EQ(recognised(head + "G74 Z-40. R2. F1.\nM30\n").machine, MachineKind::automatic);
}

// Lathes with an axis Y put it to 0 before they turn.
TEST(RecogniseMachine, YAtZeroDoesNotSpeakAgainstALathe) {
  const std::string turn = "G96 S150 M3\nG0 X54. Z6.\nG1 X40. F.1\nZ-20.\nX54.\nM30\n";
  for (const char* head : {"O1\nT0101\nG0 Y0.\n", "O1\nG28 U0. Y0. W0.\nT0101\n"}) {
    EXPECT_EQ(recognised(head + turn).machine, MachineKind::lathe) << head;
    EXPECT_EQ(codes(read_text(head + turn, {}), Severity::error), "") << head;
  }
  EXPECT_EQ(recognised("O1\nT0101\nG0 Y0.5\n" + turn).machine, MachineKind::automatic);
  EXPECT_EQ(recognised("O1\nT0101\nG0 Y#1\n" + turn).machine, MachineKind::automatic);
  // A word of station and offset alone does not decide against it, nor Y0 for a mill.
  EXPECT_EQ(recognised("O1\nT0101\nG97 S500 M3\nG0 Y0\nG0 X50. Z2.\nG1 Z-9. F.2\n").machine,
            MachineKind::automatic);
  EXPECT_EQ(recognised("O1\nT1 M6\nG0 X50. Y0 Z2.\nG1 Z-9. F.2\n").machine, MachineKind::mill);
}

// J and K of GSK's lathes: the run-out of a thread, and choices of its cycles.
TEST(RecogniseMachine, JOfALathesCyclesIsNoArc) {
  const std::string head = "O1\nT0101 (16ER AG60)\nG0 X35. Z5.\n";
  for (const char* work :
       {"G92 X29. Z-30. F2. J3. K1.5 L2\nX28.6\n", "G92 X29. Z-30. I11 J3. K1.5\n",
        "G71 U1.5 R1.\nG71 P1 Q2 U.4 W.1 J1 K1\nN1 G0 X20.\nN2 G1 Z-9.\n"})
    EXPECT_EQ(recognised(head + work).machine, MachineKind::lathe) << work;
  EXPECT_EQ(recognised(head + "G65 P9100 X5. J2.\nG1 Z-9. F.2\n").machine, MachineKind::lathe);
  EXPECT_EQ(recognised("O1\nT1 M6\nG43 H1 Z5.\nG71 I1. J30. K20. L3\n").machine, MachineKind::mill);
}

}  // namespace
}  // namespace mrsim
