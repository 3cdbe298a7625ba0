// What a control does beside its motions, and between which of them.
#include "interp/show/motion_text.h"
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

// "before:what" of each event, those of the tool left out.
std::string events(const std::string& text, Dialect dialect,
                   MachineKind machine = MachineKind::mill) {
  const Program p = read_text(text, at_origin(dialect, machine));
  std::string out;
  for (const Event& e : p.events) {
    const std::string line = event_text(p, e);
    if (e.kind != EventKind::tool_change)
      out += fmt::format("{}{}:{}", out.empty() ? "" : ", ", e.before, line.substr(10));
  }
  return out + (codes(p).empty() ? "" : " " + codes(p));
}

// Starts come before the motion of their block, ends behind it, as DIN 66025 says.
TEST(Events, StartsComeBeforeTheMotionAndEndsBehindIt) {
  const char* text = "G1 X1 F100 S500 M3\nX2 M8\nX3 M5\nX4 M9\nX5 M0\nX6 M1\nX7 M30\n";
  const char* din =
      "0:spindle  cw  S 500 rev/min, 1:coolant  flood, 3:spindle  off, 4:coolant  off, "
      "5:stop  program, 6:stop  optional, 7:stop  end";
  EXPECT_EQ(events(text, Dialect::sinumerik), din);
  EXPECT_EQ(events(text, Dialect::fanuc), din);
  EXPECT_EQ(events(text, Dialect::iso), din);
  EXPECT_EQ(events("G1 X1 F100 M3\nX2 M8\nX3 M5\nM30\n", Dialect::codesys),
            "0:spindle  cw, 1:coolant  flood, 3:spindle  off, 3:stop  end");
}

// LinuxCNC's order of execution: spindle and coolant before the motion, stops behind it.
TEST(Events, LinuxCncEndsSpindleAndCoolantBeforeTheMotion) {
  EXPECT_EQ(events("G1 X1 F100 S500 M4\nX2 M5 M9\nX3 M60\nX4 M2\n", Dialect::ngc),
            "0:spindle  ccw  S 500 rev/min, 1:spindle  off, 1:coolant  off, 3:stop  program, "
            "4:stop  end");
}

TEST(Events, ASpeedWhileTheSpindleTurnsIsAnEvent) {
  EXPECT_EQ(events("S500\nM3\nG1 X1 F100\nS800 X2\nX3 M5\nS900\nM30\n", Dialect::fanuc),
            "0:spindle  cw  S 500 rev/min, 1:spindle  cw  S 800 rev/min, 3:spindle  off, "
            "3:stop  end");
  EXPECT_EQ(events("G97 S500 M3\nG96 S200\nG1 X10 F0.1\nM30\n", Dialect::fanuc, MachineKind::lathe),
            "0:spindle  cw  S 500 rev/min, 0:spindle  cw  S 200 m/min, 1:stop  end");
}

TEST(Events, CoolantsOfAllKindsAreEvents) {
  EXPECT_EQ(events("M7\nM88\nM89\nM13 S500\nG1 X1 F100\nM30\n", Dialect::fanuc),
            "0:coolant  mist, 0:coolant  through, 0:coolant  off, 0:spindle  cw  S 500 rev/min, "
            "0:coolant  flood, 1:stop  end");
  EXPECT_EQ(events("M14 S500\nG1 X1 F100\nM30\n", Dialect::sinumerik),
            "0:spindle  ccw  S 500 rev/min, 0:coolant  flood, 1:stop  end");
  EXPECT_EQ(events("M13 S500\nG1 X1 F0.1\nM30\n", Dialect::fanuc, MachineKind::lathe),
            "1:stop  end")
      << "M13 of lathes is the live tool's or the chuck's";
}

TEST(Events, EachControlHasItsPathModes) {
  EXPECT_EQ(events("G60 G1 X1 F100\nX2 G9\nG64 X3\nG641 X4\nM30\n", Dialect::sinumerik),
            "0:path mode  exact stop, 2:path mode  exact once, 2:path mode  continuous, "
            "3:path mode  continuous, 4:stop  end");
  EXPECT_EQ(events("G61 G1 X1. F100\nG9 X2.\nG64 X3.\nM30\n", Dialect::fanuc),
            "0:path mode  exact stop, 2:path mode  exact once, 2:path mode  continuous, "
            "3:stop  end");
  EXPECT_EQ(events("G61 G1 X1 F100\nG61.1 X2\nG64 P0.1 X3\nM2\n", Dialect::ngc),
            "0:path mode  exact path, 1:path mode  exact stop, 2:path mode  continuous, "
            "3:stop  end");
  EXPECT_EQ(events("G61 G1 X1 F100\nM30\n", Dialect::codesys), "1:stop  end")
      << "G60 and G61 of CODESYS are about loops of the path";
}

TEST(Events, ToolChangesNameTheToolThatComes) {
  const auto changes = [](const char* text, Dialect dialect, MachineKind machine) {
    InterpOptions options = at_origin(dialect, machine);
    for (const char* id : {"1", "2"}) {
      options.table.tools.push_back(options.table.tools[0]);
      options.table.tools.back().id = id;
    }
    const Program p = read_text(text, options);
    std::string out = codes(p);
    for (const Event& e : p.events)
      if (e.kind == EventKind::tool_change)
        out += fmt::format(" {}@{}:{}", e.name, e.line, e.before);
    return out;
  };
  EXPECT_EQ(
      changes("T1\nM6\nG1 X1. F100\nT2 M6\nX2.\nM6 T2\nM30\n", Dialect::fanuc, MachineKind::mill),
      " 1@2:0 2@4:1");
  EXPECT_EQ(changes("T0101\nG1 X1. F0.1\nT0100\nX2.\nT0202\nX3.\nM30\n", Dialect::fanuc,
                    MachineKind::lathe),
            " 1@1:0 2@5:2");
}

// M2 in a subprogram of SINUMERIK is a return.
TEST(Events, AReturnIsNoEnd) {
  const TempFolder scratch;
  scratch.write("SUB.SPF", "G1 X1 F100\nM2\n");
  const Program p =
      read_program(scratch.write("MAIN.MPF", "SUB\nX2\nM30\n"), at_origin(Dialect::sinumerik));
  ASSERT_EQ(p.events.size(), 1u) << listing(p);
  EXPECT_EQ(p.events[0].line, 3);
  EXPECT_EQ(p.events[0].before, 2u);
}

TEST(Events, KeepTheirPlaceUnderCompensation) {
  EXPECT_EQ(events("S100 M3 F60\nG41 D1 G1 X10 Y10\nX20 M8\nX30\nG9 Y20 M9\nG40 X40 Y40\nM30\n",
                   Dialect::sinumerik),
            "0:spindle  cw  S 100 rev/min, 1:coolant  flood, 4:path mode  exact once, "
            "4:coolant  off, 5:stop  end");
}

TEST(Events, ALinuxCncDwellBesideAMoveComesBeforeItUnderCompensationToo) {
  const Program p = read_text("G1 X1 F100\nG41 D1 X10 Y10\nX20\nG4 P2 X30\nY20\nG40 X40 Y40\nM2\n",
                              at_origin(Dialect::ngc));
  ASSERT_EQ(dwells_of(p).size(), 1u) << listing(p);
  EXPECT_EQ(p.motions[dwells_of(p)[0].before].line, 4);
}

TEST(Events, ASpindleWithANumberIsNotTheTools) {
  EXPECT_EQ(events("M2=3 S2=900\nG1 X1 F100\nM30\n", Dialect::sinumerik), "1:stop  end");
}

TEST(Events, HaveALineOfTheTrace) {
  const Program p = read_text("S100 M3\nG1 X10 F60\nG9 X20\nM30\n", at_origin(Dialect::sinumerik));
  ASSERT_EQ(p.events.size(), 3u);
  EXPECT_EQ(event_json(p, p.events[0]), R"({"line":1,"kind":"spindle","state":"cw","speed":100})");
  EXPECT_EQ(event_text(p, p.events[1]), "    3     path mode  exact once");
}

}  // namespace
}  // namespace mrsim
