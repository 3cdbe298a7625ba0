// What is in force at the start, and what a block leaves behind.
#include "interp/support.h"

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

constexpr Dialect kAll[] = {Dialect::sinumerik, Dialect::iso, Dialect::codesys, Dialect::fanuc};

std::string xyz(const Vec3& p) {
  return fmt::format("{},{},{}", number_text(p.x), number_text(p.y), number_text(p.z));
}

// The ends of all motions, "a" before arcs.
std::string ends(const Program& p) {
  std::string out;
  for (const Motion& m : p.motions)
    out +=
        (out.empty() ? "" : " ") + std::string(m.kind == MotionKind::arc ? "a" : "") + xyz(m.end);
  return out;
}

TEST(Start, IncrementsAndArcsCountFromIt) {
  for (const Dialect d : kAll) {
    InterpOptions options = at_origin(d);
    options.start = Vec3{10, 20, 30};
    EXPECT_EQ(ends(read_text("G91 G1 X1 F5\n", options)), "11,20,30");
    const Program arc = read_text("G2 X20 Y20 I5 F5\n", options);
    ASSERT_EQ(codes(arc), "") << listing(arc);
    expect_near(arc.motions[0].center, {15, 20, 30});
  }
}

// A mill that never sees M6 takes its first tool late; D and radius are those of the program.
TEST(Tools, WithoutM6ToolsActAsWithIt) {
  InterpOptions options = at_origin(Dialect::sinumerik);
  options.table.offsets = {{"T1.D2", 3, 0, 0}};
  const char* rows[] = {"G0 X-20 Y0 Z0 F100\nG41 D2 G1 X0 Y0\nY20\nG40 X-20\n",
                        "G0 X-20 Y0 Z0 F100\nG41 D0 G1 X0 Y0\nY20\nG40 X-20\n",
                        "G0 X-20 Y0 Z0 F100\nG41 G0 X0 Y0\nG1 Y20\nX20\nG40 X-20\n"};
  for (const char* row : rows) {
    SCOPED_TRACE(row);
    EXPECT_EQ(ends(read_text(std::string("T1 D1\n") + row, options)),
              ends(read_text(std::string("T1 D1 M6\n") + row, options)));
  }
  const Program same = read_text("T1 D2 M6\nG0 X-20\nG41 G1 X0 F1\nX20\nG40 Y20\n", options);
  EXPECT_EQ(ends(same), "-20,0,0 0,3,0 20,3,0 20,20,0");
}

// Schools leave the first tool in the spindle, and make the next one ready beside a motion; a mill
// without a changer names its tools so, too.
TEST(Tools, ATBesideAMotionIsInDoubtWhereTheCommentNamesAnother) {
  const std::string tail =
      "G1 Z-1. F100\nG0 Z9.\n(T02 - 3MM END MILL)\nT2\nM6\nG0 X5. T1\nG1 Z-2.\nG0 Z9.\nM30\n";
  const auto told = [&](const std::string& head) {
    return listing(read_text(head + tail, at_origin(Dialect::fanuc)));
  };
  const std::string first = "(T01 - 6MM END MILL)\nG21\n", second = "(T02 - 6MM END MILL)\nG21\n";
  for (const char* call : {"G90 G0 X1. Y1. S900 M3 T2\n", "G90 G0 X1. Y1. T0202\n"})
    EXPECT_NE(told(first + call).find("the comment names T1 alone"), std::string::npos) << call;
  EXPECT_EQ(told(first + "G90 G0 G43 H2 X1. Y1. T2\n").find("alone"), std::string::npos);
  for (const char* call : {"G90 G0 X1. Y1. S900 M3 T2\n", "T2\nG90 G0 X1. Y1. S900 M3\n"})
    EXPECT_NE(told(second + call).find("T2 comes with an M6 only behind"), std::string::npos);
}

TEST(Subprograms, M30ReturnsOnSinumerik) {
  for (const char* end : {"M30", "M2", "M17", "G1 X88 M30"}) {
    SCOPED_TRACE(end);
    const TempFolder scratch;
    scratch.write("SUB.SPF", std::string("G1 X88\n") + end + "\n");
    const Program p =
        read_program(scratch.write("main.MPF", "G0 X0 F100\nSUB P2\nG1 X1\nM30\nX2\n"),
                     at_origin(Dialect::sinumerik));
    EXPECT_EQ(codes(p), "");
    EXPECT_EQ(ends(p), "88,0,0 1,0,0");
  }
}

TEST(RejectedBlocks, MoveNothingAndChangeNothing) {
  struct Rejected {
    Dialect dialect;
    const char* text;
    const char* codes;
    const char* ends;
  };
  constexpr auto s = Dialect::sinumerik;
  const Rejected rows[] = {
      {s, "G41 G2 X10 Y10 CR=10\nG40 G1 X20", "comp-start-arc", "20,0,0"},
      {s, "G41 G1 X0 Y20\nY30\nG40 G2 X10 CR=50\nG1 Y40\nG40 X9", "comp-end-arc",
       "-5,20,0 -5,30,0 -5,40,0 9,40,0"},
      {s, "G41 CIP X10 Y10 I1=0 J1=10\nG40 G1 X20", "comp-start-arc", "20,0,0"},
      {s, "G1 X10\nG1 AP=0 RP=10\nG2 AP=90 RP=50\nG1 AP=90", "arc-radii-differ", "10,0,0 0,10,0"},
      {Dialect::fanuc, "G41 D1 G2 X10 Y10 R10\nG40 G1 X20", "comp-start-arc", "20,0,0"},
  };
  for (const Rejected& row : rows) {
    SCOPED_TRACE(row.text);
    const Program p = read_text(std::string("F100\n") + row.text + "\n", at_origin(row.dialect));
    EXPECT_EQ(codes(p), row.codes);
    EXPECT_EQ(ends(p), row.ends);
  }
  InterpOptions options = at_origin(s);
  options.table.tools.push_back(options.table.tools[0]);
  options.table.tools[0].id = "1";
  options.table.tools[1].id = "2";
  const Program p = read_text("T1 M6\nG1 X1 F1\nT2 M6 G2 X5 CR=1\nG1 X2\n", options);
  ASSERT_EQ(p.motions.size(), 2U) << listing(p);
  EXPECT_EQ(p.motions[0].tool, p.motions[1].tool);
}

TEST(Start, G54IsInForceOnFanucAndIso) {
  for (const Dialect d : kAll) {
    InterpOptions options = at_origin(d);
    options.table.work = {{"G54", {10, 20, 30}}};
    options.start.reset();
    const bool in_force = d == Dialect::fanuc || d == Dialect::iso;
    EXPECT_EQ(ends(read_text("G0 X0 Y0 Z0 F100\nG1 X1\n", options)),
              in_force ? "10,20,30 11,20,30" : "1,0,0");
  }
}

TEST(Codesys, TheVectorOfG16IsNoCentre) {
  const Program p =
      read_text("G0 X0 Y0 Z0 F100\nG2 X10 I5\nG16 I1 J0 K1\nG1 X5\n", at_origin(Dialect::codesys));
  EXPECT_EQ(codes(p), "") << listing(p);
  EXPECT_EQ(ends(p), "a10,0,0 5,0,0");
}

TEST(Codesys, DAloneIsNoToolRadius) {
  const Program p = read_text("G0 X-20 Y0 Z0 F100\nG41 D5 G1 X0 Y0\nY20\nD2 X20\nY0\nG40 X40\n",
                              at_origin(Dialect::codesys));
  EXPECT_EQ(ends(p), "-20,0,0 -5,0,0 -5,20,0 a0,25,0 20,25,0 a25,20,0 25,0,0 40,0,0") << listing(p);
}

TEST(FanucLathe, G90IsACycleOnlyWithoutAMotionWord) {
  const InterpOptions lathe = at_origin(Dialect::fanuc, MachineKind::lathe);
  const std::pair<const char*, const char*> rows[] = {
      {"G18 G90 G0 X20 Z0\nG91 G1 X-4 Z-5\nX2\nG91 Z-1\n", "10,0,0 8,0,-5 9,0,-5 9,0,-6"},
      {"G90\nG0 X20 Z0\n", "10,0,0"}};
  for (const auto& [text, expected] : rows) {
    const Program p = read_text(std::string("F1\n") + text, lathe);
    EXPECT_EQ(ends(p), expected) << listing(p);
  }
  EXPECT_EQ(read_text("F1\nG1 X30 Z0\nG90 X20 Z-5\n", lathe).motions.size(), 5U);
}

TEST(Sinumerik, RetStandsAloneAndAmpersandsAreReadOver) {
  const InterpOptions s = at_origin(Dialect::sinumerik);
  EXPECT_EQ(codes(read_text("G1 X1 F1\nG1 X2 RET\n", s)), "call-not-alone");
  EXPECT_EQ(codes(read_text("G1 X1 F1\nRET\n", s)), "");
  EXPECT_EQ(ends(read_text("G1 X&5 F1 & Y2\n", s)), "5,2,0");
}

TEST(Sinumerik, ErrorsSayWhatIsPerhapsMeant) {
  const InterpOptions s = at_origin(Dialect::sinumerik);
  for (const char* text : {"G1 X=. F1\n", "G1 X=-\n"})
    EXPECT_EQ(codes(read_text(text, s), Severity::error).substr(0, 16), "number-malformed") << text;
  for (const char* text : {"CR5\n", "G2 X5 CR5\n"}) {
    const Program p = read_text(text, s);
    ASSERT_FALSE(p.diagnostics.empty());
    EXPECT_NE(p.diagnostics[0].text.find("is CR=5 meant?"), std::string::npos) << listing(p);
  }
}

TEST(Subprograms, AFanucSubprogramEndsWithM99) {
  const TempFolder scratch;
  const std::string path = scratch.write("f.nc", "O1\nG1 X1 F1\nM98 P7 L3\nG1 X3\nM30\n");
  for (const auto& [end, expected] : {std::pair("M99\n", ""), std::pair("", "program-end-missing"),
                                      std::pair("%\n", "program-end-missing")}) {
    scratch.write("O0007.nc", std::string("O7\nG1 X2\n") + end);
    const Program p = read_program(path, at_origin(Dialect::fanuc));
    EXPECT_EQ(codes(p), expected) << listing(p);
    EXPECT_EQ(ends(p), "1,0,0 2,0,0 3,0,0");
  }
}

// Straight lines that stand for arcs, or come from angles, select the compensation as others do.
TEST(Compensation, StartsWithEveryStraightLine) {
  const InterpOptions s = at_origin(Dialect::sinumerik);
  EXPECT_EQ(ends(read_text("F1\nG42 CIP X20 I1=10\nG1 X40\nG40 Y20\n", s)),
            "20,-5,0 40,-5,0 40,20,0");
  EXPECT_EQ(ends(read_text("F1\nG1 X5\nG42 CT X20\nG1 X40\nG40 Y20\n", s)),
            "5,0,0 20,-5,0 40,-5,0 40,20,0");
  EXPECT_EQ(codes(read_text("F1\nG41 ANG=0\nG1 X20 Y10 ANG=90\nG40 X40\n", s)), "");
}

// A table without lengths is told of once, a length that is missing among others each time.
TEST(Tools, MissingLengthsAreToldOnce) {
  const std::string text = "G43 H1 Z5\nG1 X1 F9\nG43 H2 Z5\nG1 X2\n";
  InterpOptions options = at_origin(Dialect::fanuc);
  EXPECT_EQ(codes(read_text(text, options), Severity::note), "register-missing");
  options.table.offsets = {{"H3", 0, 0, 5}};
  EXPECT_EQ(codes(read_text(text, options), Severity::note), "register-missing register-missing");
}

}  // namespace
}  // namespace mrsim
