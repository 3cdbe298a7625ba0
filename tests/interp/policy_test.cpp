// What each control does with bad input, one row of the table per row here (docs/interp.md).
#include "interp/support.h"

#include <tuple>

namespace mrsim {
namespace {

using namespace mrsim::testing;

struct Row {
  const char* what;
  const char* text;  // after a start at the origin
  const char* sinumerik;
  const char* iso;
  const char* codesys;
  const char* fanuc;
};

// "arc", "line" or "none": what the last block gives; then the codes of warnings and errors.
std::string outcome(const char* text, Dialect dialect) {
  std::string program = text;
  if (dialect == Dialect::sinumerik)
    for (std::size_t i = 0; (i = program.find(" R", i)) != std::string::npos; i += 4)
      program.replace(i, 2, " CR=");
  const Program p = read_text("G17 F100\n" + program + "\n", at_origin(dialect));
  std::string out = p.motions.empty()                           ? "none"
                    : p.motions.back().kind == MotionKind::arc  ? "arc"
                    : p.motions.back().kind == MotionKind::line ? "line"
                                                                : "rapid";
  const std::string found = codes(p);
  return found.empty() ? out : out + " " + found;
}

std::string worst(const Program& p) {
  for (const Diagnostic& d : p.diagnostics)
    if (d.severity == Severity::error) return "error";
  return "";
}

TEST(Policy, EachControlTreatsBadArcsByTheTable) {
  const Row rows[] = {
      {"radii agree to the tolerance", "G3 X20.008 Y0 I10 J0", "arc", "arc", "arc", "arc"},
      // 60 degrees, where the metrics agree: 5 % off
      {"within ten per cent", "G3 X-4.75 Y9.093266740 I-10 J0", "none arc-radii-differ",
       "arc arc-center-moved", "arc arc-center-moved", "none arc-radii-differ"},
      {"beyond ten per cent", "G3 X20 Y0 I14 J0", "none arc-radii-differ", "none arc-radii-differ",
       "line arc-radii-differ", "none arc-radii-differ"},
      {"chord over the diameter", "G2 X20 R9", "none arc-radius-too-small",
       "none arc-radius-too-small", "line arc-radius-too-small", "none arc-radius-too-small"},
      {"radius 0", "G2 X20 R0", "none arc-radius-zero", "none arc-radius-zero",
       "line arc-radius-zero", "none arc-radius-zero"},
      {"centre is the start", "G2 X20 I0 J0", "none arc-center-is-start",
       "none arc-center-is-start", "line arc-center-is-start", "none arc-center-is-start"},
      {"no centre data", "G2 X20", "none arc-no-center", "none arc-no-center", "line arc-no-center",
       "line arc-no-center"},
      {"end = start by radius", "G2 X0 Y0 R5", "none arc-radius-full-circle",
       "none arc-radius-full-circle", "arc", "none program-without-cuts"},
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(row.what);
    EXPECT_EQ(outcome(row.text, Dialect::sinumerik), row.sinumerik);
    EXPECT_EQ(outcome(row.text, Dialect::iso), row.iso);
    EXPECT_EQ(outcome(row.text, Dialect::codesys), row.codesys);
    EXPECT_EQ(outcome(row.text, Dialect::fanuc), row.fanuc);
  }
}

TEST(Policy, BadWordsAreErrorsEverywhere) {
  const char* rows[] = {"G1 X--5",  "G1 X1.2.3", "G1 XNAN",         "G1 XINF", "G1 X Y5",
                        "G1 X",     "G1 95 Y17", "G1 X1 X2",        "G1 X1 ?", "G1 X\xC3\x98",
                        "G9999 X1", "G1 X1 J",   "G1 X99999999999", "X1e400"};
  for (const Dialect d : {Dialect::sinumerik, Dialect::iso, Dialect::codesys, Dialect::fanuc})
    for (const char* row : rows) {
      SCOPED_TRACE(row);
      if (d == Dialect::codesys && std::string(row) == "X1e400") continue;  // E is an acceleration
      const Program p = read_text("G1 X1 F100\n" + std::string(row) + "\nG1 X2\n", at_origin(d));
      EXPECT_EQ(worst(p), "error");
      // The rejected block moves nothing; the others run.
      ASSERT_EQ(p.motions.size(), 2U) << listing(p);
      expect_near(p.motions[1].start, {1, 0, 0});
    }
}

TEST(Policy, ARejectedBlockLeavesTheModes) {
  const Program p = read_text("G1 X1 F100\nG91 G19 G2 X5 F50 R1\nX3\n", at_origin(Dialect::iso));
  ASSERT_EQ(p.motions.size(), 2U) << listing(p);
  EXPECT_EQ(p.motions[1].kind, MotionKind::line);
  EXPECT_EQ(p.motions[1].end.x, 3);
  EXPECT_EQ(p.motions[1].feed, 100);
}

TEST(Policy, PlacesPointAtTheWord) {
  const Program p = read_text("G1 X1 F100\n  G1 95 Y17\n", at_origin(Dialect::iso));
  ASSERT_EQ(p.diagnostics.size(), 1U);
  const Diagnostic& d = p.diagnostics[0];
  EXPECT_EQ(d.place.line, 2);
  EXPECT_EQ(d.place.column, 6);
  EXPECT_EQ(d.length, 2);
  EXPECT_EQ(d.source_line, "  G1 95 Y17");
  EXPECT_NE(d.text.find("missing axis letter before 95?"), std::string::npos);
}

TEST(Policy, BothRadiiAndASignAreNamed) {
  const Program p = read_text("G1 X44 Y73 F100\nG3 X95 Y43 I17 J30\n", at_origin(Dialect::iso));
  const Diagnostic& d = p.diagnostics.back();
  EXPECT_NE(d.text.find("34.4819"), std::string::npos) << d.text;
  EXPECT_NE(d.text.find("68.9638"), std::string::npos) << d.text;
  EXPECT_NE(d.text.find("J-30"), std::string::npos) << d.text;
}

TEST(Policy, NoWordOfAnArcIsDroppedInSilence) {
  EXPECT_EQ(outcome("G91 G3 AR=90 R5 X3", Dialect::sinumerik), "none arc-overdetermined");
  EXPECT_EQ(outcome("G3 AR=90 R5 I3", Dialect::sinumerik), "none arc-overdetermined");
  EXPECT_EQ(outcome("G3 T90 I3 J0 R5", Dialect::codesys), "arc arc-overdetermined");
  EXPECT_EQ(outcome("G2 X5 T90", Dialect::codesys), "line arc-no-center");
}

TEST(Policy, TwoWordsOfAGroupAreAnErrorOrTheLastCounts) {
  for (const char* text : {"G60 G64 X1", "G601 G602 X1", "G17 G18 X1"})
    EXPECT_EQ(outcome(text, Dialect::sinumerik), "none group-twice") << text;
  for (const char* text : {"BRISK SOFT", "FFWON FFWOF", "CFC CFIN", "CDON CDOF", "CUT2D CUT2DF",
                           "COMPON COMPOF", "KONT NORM", "DIAMON DIAM90", "CUTCONON CUTCONOF",
                           "G140 G141", "G340 G341", "G460 G461", "G4 F1 G74", "TRANS MIRROR"})
    EXPECT_EQ(outcome((std::string(text) + " X1").c_str(), Dialect::sinumerik), "none group-twice")
        << text;
  EXPECT_EQ(outcome("G9 G60 G601 X1", Dialect::sinumerik), "line");
  EXPECT_EQ(outcome("G1 G17 G40 G54 G60 G64 G90 G94 G450 X1", Dialect::sinumerik),
            "none group-twice");
  EXPECT_EQ(
      outcome("G1 G17 G40 G54 G601 G64 G71 G90 G94 G450 CFC BRISK FFWON X1", Dialect::sinumerik),
      "line");
}

// Lines of a megabyte: no character and no word may look at the whole line again, which took
// minutes.
TEST(Policy, LongLinesCostTheirLength) {
  for (const char* part : {"/", ")", "<", "(", "G1", "G5", "G8", "T1"}) {
    std::string text = "G1 X1 F1 ";
    while (text.size() < 300'000) text += part;
    for (const Dialect d :
         {Dialect::iso, Dialect::fanuc, Dialect::codesys, Dialect::ngc, Dialect::sinumerik})
      EXPECT_FALSE(read_text(text + "\n", at_origin(d)).diagnostics.empty()) << part;
  }
}

// SINUMERIK: 512 characters, 5 M words, texts that close on their line.
TEST(Policy, BlocksOfSinumerikHave512CharactersAtMost) {
  const InterpOptions s = at_origin(Dialect::sinumerik);
  const auto line = [](std::size_t n) { return "G1 X1 F1" + std::string(n - 8, ' '); };
  EXPECT_EQ(codes(read_text(line(512) + "\r\n", s)), "");
  const Program p = read_text("G1 X2 F1\n" + line(513) + "\n", s);
  EXPECT_EQ(codes(p), "block-too-long");
  ASSERT_EQ(p.diagnostics.size(), 1U);
  EXPECT_EQ(p.diagnostics[0].place.line, 2);
  EXPECT_EQ(p.diagnostics[0].place.column, 513);
  EXPECT_EQ(p.motions.size(), 1U);
  EXPECT_EQ(codes(read_text(line(513) + "\n", at_origin(Dialect::iso))), "");
}

TEST(Policy, BlocksHave4096WordsAtMost) {
  const auto words = [](std::size_t n) {
    std::string text = "G1 X1 F1";
    for (std::size_t i = 3; i < n; ++i) text += " M0";
    return text + "\n";
  };
  const InterpOptions iso = at_origin(Dialect::iso);
  EXPECT_EQ(codes(read_text(words(4096), iso)).find("block-too-long"), std::string::npos);
  EXPECT_NE(codes(read_text(words(4097), iso)).find("block-too-long"), std::string::npos);
}

TEST(Policy, BlocksOfSinumerikHaveFiveMWordsAtMost) {
  const InterpOptions s = at_origin(Dialect::sinumerik);
  EXPECT_EQ(codes(read_text("M3 M8 M7 M41 M10 G1 X1 F1\n", s)), "");
  const Program m = read_text("M3 M8 M7 M41 M10 M11 G1 X1 F1\nG1 X1 F1\n", s);
  EXPECT_EQ(codes(m), "m-words");
  EXPECT_EQ(m.diagnostics[0].place.column, 18);
  EXPECT_EQ(m.motions.size(), 1U);
}

TEST(Policy, StringsWithoutAnEndNameTheirAlarm) {
  for (const char* text : {"MSG(\"open)", "T=\"MILL", "CALL \"A", "G1 X1 F1 MSG(\"a"}) {
    const Program open =
        read_text(std::string(text) + "\nG1 X1 F1\n", at_origin(Dialect::sinumerik));
    EXPECT_EQ(codes(open), "string-unterminated") << text;
    EXPECT_NE(open.diagnostics[0].text.find("(alarm 12080)"), std::string::npos);
  }
}

TEST(Policy, CipThroughPointsOnOneLineIsALineOrAnError) {
  const auto run = [](const char* text) {
    return codes(
        read_text(std::string("G1 X1 F100\n") + text + "\n", at_origin(Dialect::sinumerik)));
  };
  EXPECT_EQ(run("CIP X10 I1=5"), "");
  EXPECT_EQ(run("CIP X10 I1=15"), "arc-points-collinear");
  EXPECT_EQ(run("CIP X10 I1=5 TURN=1"), "arc-points-collinear");
  EXPECT_EQ(run("CIP X10 I1=10"), "arc-points-coincide");
}

TEST(Policy, NotSupportedIsNeverSkipped) {
  const std::pair<Dialect, const char*> rows[] = {

      {Dialect::sinumerik, "ASPLINE X5"},
      {Dialect::sinumerik, "BSPLINE"},
      {Dialect::sinumerik, "POLY PO[X]=(1,2)"},
      {Dialect::sinumerik, "TOFFR=2"},
      {Dialect::sinumerik, "TRANSMIT"},

      {Dialect::fanuc, "G5 X1 Y2 I1 J1"},
      {Dialect::fanuc, "G5.1 X1 Y2"},
      {Dialect::fanuc, "G7.1 C10"},
      {Dialect::fanuc, "G68.2 X0 Y0 Z0 I0 J30 K0"},
      {Dialect::fanuc, "G68.2 X0 Y0 Z0 I0 K0"},
      {Dialect::fanuc, "G68.2 P2 Q0 X0 Y0 Z0 I0 J0 K0"},
      {Dialect::fanuc, "G53.1"},
      {Dialect::fanuc, "G43.5 H1"},
      {Dialect::iso, "G37 R5 X20"},
      {Dialect::iso, "G68.2 I0"},

      {Dialect::fanuc, "G10 L70"},
      {Dialect::codesys, "G5 X1"},
      {Dialect::codesys, "G38 D1"},
      {Dialect::iso, "(EXEC P5)"}};
  for (const auto& [dialect, text] : rows) {
    SCOPED_TRACE(text);
    const Program p = read_text(std::string("G1 X1 F100\n") + text + "\n", at_origin(dialect));
    EXPECT_EQ(codes(p), "not-supported") << listing(p);
    EXPECT_EQ(p.motions.size(), 1U);
  }
}

TEST(Policy, ACallOfNothingIsNamed) {
  const Program p = read_text("G1 X1 F100\nPART(3,4)\n", at_origin(Dialect::sinumerik));
  EXPECT_EQ(codes(p), "subprogram-missing");
  EXPECT_NE(p.diagnostics.back().text.find("PART"), std::string::npos);
}

TEST(Policy, LabelsHaveTwoTo32Characters) {
  const auto run = [](const std::string& label) {
    return codes(read_text("G1 X1 F1\n" + label + ": X2\n", at_origin(Dialect::sinumerik)));
  };
  EXPECT_EQ(run("AB"), "");
  EXPECT_EQ(run("N10 _B1"), "");
  EXPECT_EQ(run(std::string(32, 'A')), "");
  EXPECT_EQ(run(std::string(33, 'A')), "label-length");
  EXPECT_EQ(run("A"), "label-length");
  for (const char* label : {"L1", "A3", "N10"}) EXPECT_EQ(run(label), "label-length") << label;
}

// Statements in brackets are told from comments, which stand in brackets too.
TEST(Policy, StatementsInBracketsOfIsoControlsAreNoComments) {
  const auto of = [](const std::string& comment) {
    return codes(read_text("G1 X1 F100\n" + comment + "\n", at_origin(Dialect::iso)));
  };
  for (const char* statement :
       {"(P1 = P2 + 1)", "N5 (RPT N10,N20) N3", "(if P1 EQ 2 GOTO N10)", "(GOTO N10)", "(CALL 5)",
        "(PCALL 7, P1=3)", "(SUB 5)", "(RET)", "(EXEC P5)", "G1 X2 (P1=5)"})
    EXPECT_NE(of(statement), "") << statement;
  for (const char* comment : {"(ROUGHING)", "(IF YOU CAN, CHECK)", "(P1 POCKET)", "(CALL THE BOSS)",
                              "(MSG \"TURN\")", "(RETURN)", "(GOTO HOME)", "()"})
    EXPECT_EQ(of(comment), "") << comment;
}

TEST(Policy, ACommentInBracketsIsOneFault) {
  EXPECT_EQ(codes(read_text("G1 X1 F1\nX2 (c 5)\nX3 (open\n", at_origin(Dialect::sinumerik))),
            "character character");
  EXPECT_EQ(codes(read_text("G1 X1 F1\nX=AC()\nX=AC(\n", at_origin(Dialect::sinumerik))),
            "address-without-number address-without-number");
}

TEST(Policy, FilesThatAreNoProgramsAreRefused) {
  const TempFolder scratch;
  const InterpOptions options = at_origin(Dialect::iso);
  EXPECT_THROW(read_program(scratch.write("empty.nc", ""), options), Error);
  EXPECT_THROW(read_program(scratch.write("blank.nc", " \n\r\n"), options), Error);
  EXPECT_THROW(read_program("/nowhere/x.nc", options), Error);
  EXPECT_THROW(read_program("/tmp", options), Error);
  for (const std::string& text :
       {std::string("\xFF\xFEG\0001\0\n\0", 8), std::string("\xFE\xFF\0G\0001", 6),
        std::string("G\0001\0 \0X\0005\0", 10), std::string("\0G\0001\0 \0X\0005", 10)})
    try {
      read_program(scratch.write("wide.nc", text), options);
      FAIL();
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), "file-encoding");
    }
  EXPECT_EQ(codes(read_text("G0 X5\nM30\n", options)), "program-without-cuts");
}

TEST(Policy, LinesOfAnyLengthAreRead) {
  const std::string blanks(3 << 20, ' ');
  const Program p =
      read_text("G1" + blanks + "X1 F100\nG1 X" + std::string(1 << 20, '9') + "\nG1 X2\n",
                at_origin(Dialect::iso));
  EXPECT_EQ(p.motions.size(), 2U);
  EXPECT_EQ(codes(p), "number-too-large");
}

// Lines end with LF, CR LF or CR; a byte order mark is no word.
TEST(Policy, LinesEndWithLfCrOrBoth) {
  const InterpOptions options = at_origin(Dialect::iso);
  for (const char* text :
       {"G1 X1 F1\nX2\nX3\n", "G1 X1 F1\r\nX2\r\nX3\r\n", "G1 X1 F1\rX2\rX3\r", "G1 X1 F1\rX2\rX3",
        "G1 X1 F1\r\r\nX2\r\r\nX3\r\r\n", "\xEF\xBB\xBFG1 X1 F1\nX2\nX3"}) {
    const Program p = read_text(text, options);
    ASSERT_EQ(p.motions.size(), 3U) << listing(p);
    EXPECT_EQ(p.motions[2].line, 3);
    EXPECT_EQ(p.motions[1].column, 1);
    EXPECT_EQ(codes(p), "");
  }
  const Program gap = read_text("G1 X1 F1\r\rX2\r", options);
  ASSERT_EQ(gap.motions.size(), 2U);
  EXPECT_EQ(gap.motions[1].line, 3);
}

// Rows of CR took time by the square of their length.
TEST(Policy, AMillionEmptyLinesOfCrAreReadAtOnce) {
  const std::string row(1'000'000, '\r');
  const Program p = read_text("G1 X1 F1" + row + "X2\r\r\nX3" + row, at_origin(Dialect::iso));
  ASSERT_EQ(p.motions.size(), 3U);
  EXPECT_EQ(p.motions[1].line, 1'000'001);
  EXPECT_EQ(p.motions[2].line, 1'000'002);
}

// Which loop it is, where the limit of steps has ended it: here each counter steps past its bound.
TEST(Policy, TheLimitOfStepsNamesTheLoop) {
  const struct {
    Dialect dialect;
    const char* text;
    const char* told;
  } cases[] = {
      {Dialect::fanuc, "G1 X1 F1\n#1=0\nWHILE[#1NE10]DO1\nX#1\n#1=#1+3\nEND1\nM30\n", "line 3 "},
      {Dialect::fanuc, "#1=0\nN1 #1=#1+3\nG1 X#1 F1\nIF[#1NE10]GOTO1\nM30\n", "line 2 "},
      {Dialect::ngc, "G1 X1 F1\n#1=0\no1 while [#1 NE 10]\n#1=[#1+3]\no1 endwhile\nM2\n",
       "line 3 "},
      {Dialect::sinumerik, "G1 X1 F1\nR1=0\nWHILE R1<>10\nR1=R1+3\nENDWHILE\nM30\n", "line 3 "},
      {Dialect::sinumerik, "G1 X1 F1\nR1=0\nREPEAT\nR1=R1+3\nUNTIL R1==10\nM30\n", "line 3 "},
  };
  for (const auto& one : cases) {
    SCOPED_TRACE(one.text);
    InterpOptions options = at_origin(one.dialect);
    options.max_steps = 20'000;
    const Program p = read_text(one.text, options);
    EXPECT_EQ(codes(p, Severity::error), "program-endless");
    ASSERT_FALSE(p.diagnostics.empty());
    const std::string& text = p.diagnostics.back().text;
    EXPECT_NE(text.find("the loop that begins in " + std::string(one.told)), std::string::npos)
        << text;
  }
}

TEST(Policy, LexicalFaultsNameTheirAlarm) {
  const std::tuple<Dialect, const char*, const char*> rows[] = {
      {Dialect::fanuc, "G1 X5 95", "blank"},
      {Dialect::fanuc, "95 X1", "(alarm 004)"},
      {Dialect::fanuc, "G1 X", "(alarm 005)"},
      {Dialect::fanuc, "G1 X--5", "(alarm 006)"},
      {Dialect::fanuc, "G1 X1.2.3", "(alarm 007)"},
      {Dialect::fanuc, "G1 E5", "(alarm 009)"},
      {Dialect::sinumerik, "G1 X1.2.3", "(alarm 12080)"},
      {Dialect::sinumerik, "G1 X=AC(5", "(alarm 12080)"}};
  for (const auto& [dialect, text, part] : rows) {
    SCOPED_TRACE(text);
    const Program p = read_text(std::string(text) + "\nG1 X1 F1\n", at_origin(dialect));
    ASSERT_FALSE(p.diagnostics.empty());
    EXPECT_NE(p.diagnostics[0].text.find(part), std::string::npos) << p.diagnostics[0].text;
  }
}

// A lost end of line would make one slanted move of two: an alarm of SINUMERIK and LinuxCNC.
TEST(Policy, ASecondBlockNumberTellsOfALostEndOfLine) {
  const auto run = [](Dialect dialect, const std::string& line) {
    return path_text(read_text("N10 F9 G90\n" + line + "\n", at_origin(dialect)));
  };
  const std::string two = "N20 G1 X10 N30 Y5";
  EXPECT_EQ(run(Dialect::sinumerik, two), " | address-twice");
  EXPECT_EQ(run(Dialect::ngc, two), " | address-twice");
  EXPECT_EQ(run(Dialect::fanuc, two), "l10,5,0 | address-twice");
  EXPECT_EQ(run(Dialect::iso, two), "l10,5,0 | address-twice");
  EXPECT_EQ(run(Dialect::iso, "N20 G1 X10 N2"), "l10,0,0");
  EXPECT_EQ(run(Dialect::codesys, two), "l10,0,0 l10,5,0 | blocks-on-one-line");
  EXPECT_EQ(run(Dialect::fanuc, "N20 N25 G1 X10"), "l10,0,0");
  EXPECT_EQ(run(Dialect::fanuc, "G1 N20 X10"), "l10,0,0");
  EXPECT_EQ(run(Dialect::sinumerik, "N20 GOTOF N30\nN30 G1 X10"), "l10,0,0");
}

}  // namespace
}  // namespace mrsim
