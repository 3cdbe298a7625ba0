// How long the tool stays: G4 and drilling cycles, in the units of each control.
#include "interp/show/motion_text.h"
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

// "after:seconds" of each dwell, then the codes of notes about dwells.
std::string dwells(const std::string& text, Dialect dialect,
                   MachineKind machine = MachineKind::mill) {
  const Program p = read_text(text, at_origin(dialect, machine));
  std::string out;
  for (const Event& d : dwells_of(p))
    out += fmt::format("{}{}:{:g}", out.empty() ? "" : " ", d.before, d.seconds);
  for (const Diagnostic& d : p.diagnostics)
    if (d.code.starts_with("dwell") || d.severity == Severity::error) out += " " + d.code;
  return out;
}

TEST(Dwell, FanucCountsMillisecondsInPAndSecondsInXAndU) {
  const auto fanuc = [](const char* g4) {
    return dwells(fmt::format("G21 G90 S100 M3\nG1 X1. F9\n{}\nX2.\nM30\n", g4), Dialect::fanuc);
  };
  EXPECT_EQ(fanuc("G4 P1500"), "1:1.5");
  EXPECT_EQ(fanuc("G04 P2"), "1:0.002");
  EXPECT_EQ(fanuc("G4 X2.5"), "1:2.5");
  EXPECT_EQ(fanuc("G4 U3"), "1:3");
  EXPECT_EQ(fanuc("G4 X1000"), "1:1 dwell-unit") << "least increments";
  EXPECT_EQ(fanuc("G4 P1.5"), "1:1.5") << "Haas";
  EXPECT_EQ(fanuc("#1=2000\nG4 P#1"), "1:2 dwell-unit");
  EXPECT_EQ(fanuc("#1=2.\nG4 X#1"), "1:2");
  EXPECT_EQ(fanuc("G4"), "");
  EXPECT_EQ(fanuc("G4 P0"), "");
}

TEST(Dwell, LeastIncrementsCountThousandthsOfASecond) {
  InterpOptions options = at_origin(Dialect::fanuc);
  options.least_increments = true;
  const Program p = read_text("G21 G90 S100 M3\nG1 X1. F9\nG4 X20\nX2.\nM30\n", options);
  ASSERT_EQ(dwells_of(p).size(), 1u);
  EXPECT_DOUBLE_EQ(dwells_of(p)[0].seconds, 0.02);
}

TEST(Dwell, SinumerikCountsSecondsInFAndTurnsInS) {
  EXPECT_EQ(dwells("G1 X1 F100\nG4 F2.5\nX2\n", Dialect::sinumerik), "1:2.5");
  EXPECT_EQ(dwells("S300 M3\nG1 X1 F100\nG4 S30\nX2\n", Dialect::sinumerik), "1:6");
  EXPECT_EQ(dwells("G1 X1 F100\nG4 S30\nX2\n", Dialect::sinumerik), " dwell-not-counted");
  EXPECT_EQ(dwells("G96 S200 M3\nG1 X1 F0.1\nG4 S3\nX2\n", Dialect::sinumerik, MachineKind::lathe),
            " dwell-not-counted");
}

TEST(Dwell, LinuxCncCountsSecondsBeforeTheMoveOfTheBlock) {
  EXPECT_EQ(dwells("G1 X1 F100\nG4 P0.5\nG4 P2 X2\nM2\n", Dialect::ngc), "1:0.5 1:2");
  EXPECT_EQ(dwells("G1 X1 F100\nG4 P1500\nM2\n", Dialect::ngc), "1:1500 dwell-unit")
      << "Mach may be set to milliseconds";
}

TEST(Dwell, CodesysCountsSecondsInT) {
  EXPECT_EQ(dwells("N10 G1 X1 F100\nN20 G4 T3\nN30 G1 X2\n", Dialect::codesys), "1:3");
}

TEST(Dwell, IsoTellsHowItReadsANumberWithoutAPoint) {
  const auto iso = [](const char* g4) {
    return dwells(fmt::format("G1 X1 F100\n{}\nX2\nM30\n", g4), Dialect::iso);
  };
  EXPECT_EQ(iso("G4 F2.5"), "1:2.5");
  EXPECT_EQ(iso("G4 X2"), "1:2");
  EXPECT_EQ(iso("G4 P0.5"), "1:0.5");
  EXPECT_EQ(iso("G4 P2"), "1:2 dwell-unit");
  EXPECT_EQ(iso("G4 P500"), "1:0.5 dwell-unit");
  EXPECT_EQ(iso("G4 K1.5"), "1:1.5");
  EXPECT_EQ(iso("G4 K2"), "1:2 dwell-unit");
}

// Rapid to the point, rapid to R, the stroke: the third motion ends at the bottom.
TEST(Dwell, HolesWaitAtTheirBottom) {
  const auto cycle = [](const char* words, Dialect dialect) {
    return dwells(
        fmt::format("G21 G90 S600 M3 F60\nG0 Z10.\n{} X5. Y5. Z-3. R2.\nG80\nM30\n", words),
        dialect);
  };
  EXPECT_EQ(cycle("G82 P500", Dialect::fanuc), "4:0.5");
  EXPECT_EQ(cycle("G82 P0.5", Dialect::fanuc), "4:0.5") << "Haas";
  EXPECT_EQ(cycle("G89 P200", Dialect::fanuc), "4:0.2");
  EXPECT_EQ(cycle("G81 P200", Dialect::fanuc), "") << "G81 knows no dwell";
  EXPECT_EQ(cycle("G83 Q1. P200", Dialect::fanuc).find(":0.2"),
            cycle("G83 Q1. P200", Dialect::fanuc).rfind(":0.2"))
      << "the last stroke alone";
  EXPECT_EQ(cycle("G84 P200", Dialect::fanuc), "4:0.2 5:0.2") << "at R, too";
  EXPECT_EQ(cycle("G82 P0.5", Dialect::ngc), "4:0.5");
  EXPECT_EQ(cycle("G82", Dialect::ngc), " dwell-missing") << "others than LinuxCNC drill";
  EXPECT_EQ(cycle("G82 P500", Dialect::iso), "4:0.5 dwell-unit");
}

TEST(Dwell, EachHoleOfACycleWaits) {
  EXPECT_EQ(dwells("G21 G90 S600 M3 F60\nG0 Z10.\nG99 G82 X5. Z-3. R2. P500\nX9.\nX12.\nG81 X15.\n"
                   "G80\nM30\n",
                   Dialect::fanuc),
            "4:0.5 7:0.5 10:0.5");
}

TEST(Dwell, SinumerikCyclesWaitSecondsOrTurns) {
  const auto cycle = [](const char* call) {
    return dwells(fmt::format("S600 M3 F60\nG0 X5 Y5 Z10\n{}\nM30\n", call), Dialect::sinumerik);
  };
  EXPECT_EQ(cycle("CYCLE82(10,0,2,-3,,0.5)"), "3:0.5");
  EXPECT_EQ(cycle("CYCLE82(10,0,2,-3,,-2)"), "3:0.2") << "below 0: turns";
  EXPECT_EQ(cycle("CYCLE82(10,0,2,-3,,2,0,1,22)"), "3:0.2") << "the mode says turns";
  EXPECT_EQ(cycle("CYCLE85(10,0,2,-3,,0.5,60,90)"), "3:0.5");
  EXPECT_EQ(cycle("CYCLE89(10,0,2,-3,,0.5)"), "3:0.5");
  EXPECT_EQ(cycle("CYCLE81(10,0,2,-3)"), "");
  // Down, wait, out, wait, back, down, wait.
  EXPECT_EQ(cycle("CYCLE83(10,0,2,-3,,,2,0,0.5,0.25,1,1)"), "3:0.5 4:0.25 6:0.5");
  EXPECT_EQ(cycle("CYCLE83(10,0,2,-3,,,2,0,0.5,0.25,1,0)"), "3:0.5 5:0.5") << "chips broken";
  EXPECT_EQ(cycle("CYCLE83(10,0,2,-3,,,2,0,0.5,0.25,1,1,,,,1.5)"), "3:0.5 4:0.25 6:1.5") << "DTD";
}

// Motions are held back until the next ones are known: the dwell keeps its place.
TEST(Dwell, StaysBetweenItsBlocksUnderCompensation) {
  const Program p =
      read_text("S100 M3 F60\nG41 D1 G1 X10 Y10\nX20\nG4 F2\nX30\nY20\nG40 X40 Y40\nM30\n",
                at_origin(Dialect::sinumerik));
  ASSERT_EQ(dwells_of(p).size(), 1u) << listing(p);
  ASSERT_LT(dwells_of(p)[0].before, p.motions.size());
  EXPECT_EQ(p.motions[dwells_of(p)[0].before].line, 5);
  EXPECT_EQ(p.motions[dwells_of(p)[0].before - 1].line, 3);
}

TEST(Dwell, ThoseInARowAreOneUnderCompensationToo) {
  const Program p =
      read_text("S100 M3 F60\nG41 D1 G1 X10 Y10\nX20\nG4 F2\nG4 F3\nX30\nG4 F1\nG40 X40 Y40\nM30\n",
                at_origin(Dialect::sinumerik));
  ASSERT_EQ(dwells_of(p).size(), 2u) << listing(p);
  EXPECT_EQ(dwells_of(p)[0].seconds, 5);
  EXPECT_EQ(p.motions[dwells_of(p)[0].before].line, 6);
  EXPECT_EQ(dwells_of(p)[1].seconds, 1);
}

TEST(Dwell, HasALineOfTheTrace) {
  const Program p = read_text("S100 M3 F60\nG1 X10\nG4 F2.5\nX20 RND=1\nG4 F1\nX30\nM30\n",
                              at_origin(Dialect::sinumerik));
  ASSERT_EQ(dwells_of(p).size(), 2u);
  EXPECT_EQ(event_text(p, dwells_of(p)[0]), "    3     dwell  2.5 s");
  EXPECT_EQ(event_json(p, dwells_of(p)[1]), R"({"line":5,"kind":"dwell","seconds":1,"tool":""})");
}

TEST(Dwell, AtTheEndOfAHeldBackContourIsNotLost) {
  EXPECT_EQ(dwells("S100 M3 F60\nG1 X10 Y10 RND=1\nG4 F2\nM30\n", Dialect::sinumerik), "1:2");
}

}  // namespace
}  // namespace mrsim
