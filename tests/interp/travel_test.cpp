// Travel limits of the machine, in its own coordinates.
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

// G54 lies at X-300 Y-200 Z-400 of a machine of 600 x 400 x 500 mm.
InterpOptions on_machine(Dialect dialect = Dialect::fanuc) {
  InterpOptions options = at_origin(dialect);
  options.places.zero = {{"G54", {-300, -200, -400}}};
  options.places.limits = Box3{{-600, -400, -500}, {0, 0, 0}};
  return options;
}

std::string found(const Program& program) {
  std::string out;
  for (const Diagnostic& d : program.diagnostics)
    if (d.code.find("travel") != d.code.npos ||
        (d.severity == Severity::error && d.code != "program-without-cuts"))
      out += fmt::format("{}:{} {}\n", d.place.line, d.code, d.text);
  return out;
}

TEST(Travel, InsideNothingIsSaid) {
  EXPECT_EQ(found(read_text("G54\nG0 X300. Y200. Z400.\nG1 X-300. Y-200. F100\nZ-100.\nM30\n",
                            on_machine())),
            "")
      << "to the very ends of all axes";
}

TEST(Travel, BeyondIsToldOnceForEachEndOfAnAxis) {
  EXPECT_EQ(
      found(
          read_text("G54\nG0 Z10.\nX301.\nX0.\nX305.\nG1 Z-102.5 F100\nZ10.\nM30\n", on_machine())),
      "3:beyond-travel X leaves the machine's travel: 5 mm above its limit of 0, in 2 motions, "
      "farthest in line 5\n"
      "6:beyond-travel Z leaves the machine's travel: 2.5 mm below its limit of -500\n");
}

TEST(Travel, ArcsReachFartherThanTheirEnds) {
  EXPECT_EQ(
      found(read_text("G54\nG0 Z10.\nG0 X290.\nG3 X290. Y40. J20. F100\nM30\n", on_machine())),
      "4:beyond-travel X leaves the machine's travel: 10 mm above its limit of 0\n")
      << "half a circle of radius 20 about X290 Y20";
  EXPECT_EQ(
      found(read_text("G54\nG0 Z10.\nG0 X290.\nG2 X290. Y40. J20. F100\nM30\n", on_machine())), "");
  EXPECT_EQ(found(read_text("G54\nG0 Z10.\nG0 X290.\nG2 J20. F100\nM30\n", on_machine())),
            "4:beyond-travel X leaves the machine's travel: 10 mm above its limit of 0\n");
}

TEST(Travel, TheToolsCentreCounts) {
  EXPECT_EQ(found(read_text("G54\nG0 Z10.\nX250. Y-20.\nG42 D1 G1 X297. Y-10. F100\nY50.\n"
                            "G40 X200. Y60.\nM30\n",
                            on_machine())),
            "4:beyond-travel X leaves the machine's travel: 2 mm above its limit of 0, in 2 "
            "motions, farthest in line 4\n")
      << "a tool of 10 mm right of X297";
}

TEST(Travel, MovesInMachineCoordinatesAreChecked) {
  EXPECT_EQ(found(read_text("G54\nG0 X0. Y0. Z0.\nG53 Z1.\nM30\n", on_machine())),
            "3:beyond-travel Z leaves the machine's travel: 1 mm above its limit of 0\n");
  EXPECT_EQ(found(read_text("G54\nG0 X0. Y0. Z0.\nG91 G28 Z0.\nM30\n", on_machine())), "");
}

TEST(Travel, AnAxisWithoutLimitsEndsNowhere) {
  InterpOptions options = on_machine();
  options.places.limits->hi.x = std::numeric_limits<double>::infinity();
  EXPECT_EQ(found(read_text("G54\nG0 Z10.\nX5000.\nM30\n", options)), "");
}

TEST(Travel, WhatCanNotBeCheckedIsSaid) {
  InterpOptions options = on_machine();
  options.places.zero.clear();
  EXPECT_EQ(found(read_text("G54\nG0 X5000.\nM30\n", options)),
            "0:travel-unchecked the limits of [machine] are not checked: where its zero lies is "
            "unknown; give the place of the work zero in machine coordinates, zero.G54 = [x, y, "
            "z]\n");
  EXPECT_EQ(found(read_text("G55\nG0 X5000.\nY1.\nM30\n", on_machine())),
            "0:travel-unchecked the limits of [machine] are not checked for 2 motions: where the "
            "work zero in force lies on the machine is unknown\n");
}

TEST(Travel, AStartThatIsUnknownIsNotChecked) {
  InterpOptions options = on_machine();
  options.start.reset();
  EXPECT_EQ(found(read_text("G54\nG0 X400.\nY0.\nZ0.\nM30\n", options)),
            "2:beyond-travel X leaves the machine's travel: 100 mm above its limit of 0\n")
      << "X is known from its first word on";
}

}  // namespace
}  // namespace mrsim
