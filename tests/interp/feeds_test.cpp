// Feeds, speeds and leads of threads: their units, their limits and where they come from.
#include "interp/support.h"

#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

TEST(Feeds, FeedsAndSpeedsHaveTheirUnits) {
  const InterpOptions mill = at_origin(Dialect::sinumerik);
  const Program p = read_text(
      "G95 F0.2 S100 G1 X1\nG94 F50 X2\nG93 F2 X3\nG96 S200 F.1 X4\nG97 S500 X5\n"
      "G33 Z-5 K1.5\nG0 X9\nG331 Z-9 K-2\n",
      mill);
  ASSERT_EQ(p.motions.size(), 8U) << listing(p);
  EXPECT_EQ(p.motions[0].feed_unit, FeedUnit::mm_per_rev);
  EXPECT_EQ(p.motions[1].feed_unit, FeedUnit::mm_per_min);
  EXPECT_EQ(p.motions[2].feed_unit, FeedUnit::inverse_time);
  EXPECT_TRUE(p.motions[3].constant_surface_speed);
  EXPECT_EQ(p.motions[3].feed_unit, FeedUnit::mm_per_rev);
  EXPECT_EQ(p.motions[3].speed, 200);
  EXPECT_EQ(p.motions[4].speed, 500);
  EXPECT_EQ(p.motions[5].lead, 1.5);
  EXPECT_EQ(p.motions[6].lead, 0);
  EXPECT_EQ(p.motions[7].lead, -2);
}

// FANUC and LinuxCNC limit the speed under G96 alone, SINUMERIK every speed.
TEST(Feeds, ProgramsLimitTheSpindle) {
  struct Case {
    const char* text;
    Dialect dialect;
    MachineKind machine;
    double under_g96, under_g97;
  };
  const Case cases[] = {
      {"G50 S1500\n", Dialect::fanuc, MachineKind::lathe, 1500, 0},
      {"G92 S1500\n", Dialect::fanuc, MachineKind::lathe, 1500, 0},
      {"G92 S1500\n", Dialect::fanuc, MachineKind::mill, 1500, 0},
      {"G92 S1500\n", Dialect::iso, MachineKind::lathe, 1500, 0},
      {"LIMS=1500\n", Dialect::sinumerik, MachineKind::lathe, 1500, 1500},
      {"G26 S1500\n", Dialect::sinumerik, MachineKind::lathe, 1500, 1500},
      {"G26 S1500\nG25 S100\n", Dialect::sinumerik, MachineKind::lathe, 1500, 1500},
      {"G96 D1500 S80\n", Dialect::ngc, MachineKind::lathe, 1500, 0},
      {"", Dialect::sinumerik, MachineKind::lathe, 0, 0}};
  for (const Case& c : cases) {
    InterpOptions options = at_origin(c.dialect);
    options.machine = c.machine;
    const Program p = read_text(
        "S100 M3\n" + std::string(c.text) + "G95\nG96 S200\nG1 X4 F0.1\nG97 S500\nX5\n", options);
    ASSERT_EQ(p.motions.size(), 2U) << c.text << listing(p);
    EXPECT_EQ(p.motions[0].speed_limit, c.under_g96) << c.text << listing(p);
    EXPECT_EQ(p.motions[0].speed, 200) << c.text;
    EXPECT_EQ(p.motions[1].speed_limit, c.under_g97) << c.text << listing(p);
    EXPECT_EQ(p.motions[1].speed, 500) << c.text;
  }
}

// The sign of a tap's lead is its hand, into the hole and out of it.
TEST(Feeds, TheSignOfATapsLeadIsItsHand) {
  const InterpOptions s = at_origin(Dialect::sinumerik);
  const Program p = read_text("S100 SPOS=0\nG331 Z-9 K-1.25\nG332 Z5 K-1.25\nG331 Z-9 K1.25\n", s);
  ASSERT_EQ(p.motions.size(), 3U) << listing(p);
  EXPECT_EQ(p.motions[0].lead, -1.25);
  EXPECT_EQ(p.motions[1].lead, -1.25);
  EXPECT_EQ(p.motions[2].lead, 1.25);
  EXPECT_NE(motion_json(p, p.motions[0]).find("\"lead\":-1.25"), std::string::npos);
  EXPECT_EQ(codes(read_text("S100\nG33 Z-9 K-2\n", s)), "thread-lead");
  EXPECT_EQ(codes(read_text("S100\nG33 Z-9. F-2.\n", at_origin(Dialect::fanuc))), "thread-lead");
  EXPECT_EQ(codes(read_text("S100 M4 F100\nG63 Z-9\n", s)), "");
}

TEST(Feeds, TheLeadIsThatOfTheLongerPath) {
  const InterpOptions s = at_origin(Dialect::sinumerik);
  EXPECT_EQ(codes(read_text("S100\nG33 X60 Z-25 K2\n", s)), "thread-lead");
  EXPECT_EQ(codes(read_text("S100\nG33 X60 Z-25 I2\nG33 Z-90 K2\n", s)), "");
}

TEST(Feeds, SurfaceSpeedsChooseTheUnitOfTheFeed) {
  const std::pair<const char*, FeedUnit> rows[] = {
      {"G94 G96 S1", FeedUnit::mm_per_rev},      {"G95\nG961 S1", FeedUnit::mm_per_min},
      {"G94\nG962 S1", FeedUnit::mm_per_min},    {"G95\nG962 S1", FeedUnit::mm_per_rev},
      {"G96 S1\nG971 S1", FeedUnit::mm_per_min}, {"G96 S1\nG97 S1", FeedUnit::mm_per_rev}};
  for (const auto& [text, unit] : rows) {
    SCOPED_TRACE(text);
    const Program p = read_text(std::string(text) + "\nG1 X1 F1\n", at_origin(Dialect::sinumerik));
    if (std::string(text) == "G94 G96 S1") {  // both are of group 15
      EXPECT_EQ(codes(p), "group-twice");
      continue;
    }
    ASSERT_EQ(p.motions.size(), 1U) << listing(p);
    EXPECT_EQ(p.motions[0].feed_unit, unit);
    EXPECT_EQ(p.motions[0].constant_surface_speed,
              std::string(text).find("G97") == std::string::npos);
  }
}

// A thread's way is the spindle's: the F in force says nothing of it.
TEST(Feeds, ATraceShowsTheLeadOfAThread) {
  const Program p = read_text("G98\nG0 X20. Z5.\nG1 X18. F100.\nG32 Z-10. F1.5\n",
                              at_origin(Dialect::fanuc, MachineKind::lathe));
  const std::string line = motion_text(p, p.motions.back());
  EXPECT_NE(line.find("lead 1.5 mm"), std::string::npos) << line;
  EXPECT_EQ(line.find("F 100"), std::string::npos);
}

/// "lead or feed of each motion", rapids as "-".
std::string paces(const std::string& text, Dialect dialect) {
  const Program p = read_text(text, at_origin(dialect, MachineKind::lathe));
  std::string out;
  for (const Motion& m : p.motions)
    out += m.kind == MotionKind::rapid && m.lead == 0 ? "-"
           : m.lead != 0                              ? fmt::format(" t{:g}", m.lead)
                                                      : fmt::format(" f{:g}", m.feed);
  return out + codes(p);
}

// A thread's lead is no matter of the cycle behind it, whose F is its own.
TEST(Feeds, ACycleRightBehindAThreadHasItsOwnFeed) {
  EXPECT_EQ(paces("G97 S500 M3\nG0 X40 Z5\nG32 Z-5 F1.5\nG90 X30 Z-10 F0.2\nX28\n", Dialect::fanuc),
            "- t1.5- f0.2 f0.2-- f0.2 f0.2-");
  EXPECT_EQ(paces("G97 S500 M3\nG0 X40 Z5\nG32 Z-5 F1.5\nG92 X30 Z-10 F2\n", Dialect::fanuc),
            "- t1.5- t2--");
  EXPECT_EQ(paces("G97 S500 M3\nG0 X0 Z5\nG32 Z-5 F1.5\nG83 Z-9 Q20 F0.1\n", Dialect::fanuc),
            "- t1.5 f0.1-");
  EXPECT_EQ(paces("G18 G8 S500 M3\nG0 X20 Z5\nG33.1 Z-5 K1.5\n"
                  "G76 P2 Z-9 I-1 J1 K1.5 R1 Q0 H0 E0 L0\nG1 X30 F60\nM2\n",
                  Dialect::ngc),
            "- t1.5 t1.5-- t2--- t2- f60");
}

}  // namespace
}  // namespace mrsim
