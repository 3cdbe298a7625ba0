#include "setup/machine_file.h"

#include "support/error_code.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

std::string code_of(std::string_view text) {
  return testing::error_code([&] { parse_machine(text, "job.toml"); });
}

TEST(MachineFile, ReadsWhatItNamesAndKeepsTheRest) {
  const MachineData machine = parse_machine(
      "program = \"a.nc\"\n[machine]\nkind = \"mill\"\nrapid = 30000\n"
      "acceleration = [5000, 4000, 3000]\ntool_change = 0\nmax_spindle = 12000\n",
      "job.toml");
  EXPECT_EQ(machine.rapid, (Vec3{30000, 30000, 30000}));
  EXPECT_EQ(machine.acceleration, (Vec3{5000, 4000, 3000}));
  EXPECT_EQ(machine.kind, MachineKind::mill);
  EXPECT_EQ(machine.tool_change, 0);
  EXPECT_EQ(machine.max_spindle, 12000);
  EXPECT_EQ(machine.corner_tolerance, MachineData{}.corner_tolerance);
  EXPECT_EQ(machine.origin, "job.toml");
}

TEST(MachineFile, ReadsThePlacesOfTheMachine) {
  const MachineData machine = parse_machine(
      "[machine]\nzero.G54 = [-210.5, -120, -180]\nzero.\"G54.1P3\" = [1, 2, 3]\n"
      "reference = [0, 0, -5]\nsecond = [-400, 0, 0]\n",
      "job.toml");
  ASSERT_EQ(machine.places.zero.size(), 2U);
  EXPECT_EQ(machine.places.zero[0].name, "G54");
  EXPECT_EQ(machine.places.zero[0].shift, (Vec3{-210.5, -120, -180}));
  EXPECT_EQ(machine.places.zero[1].name, "G54.1P3");
  EXPECT_EQ(machine.places.reference, (Vec3{0, 0, -5}));
  EXPECT_EQ(*machine.places.second, (Vec3{-400, 0, 0}));
  EXPECT_EQ(code_of("[machine]\nzero = 1"), "machine-value");
  EXPECT_EQ(code_of("[machine]\nzero.G54 = [1, 2]"), "machine-value");
  EXPECT_EQ(code_of("[machine]\nzero.G99 = [1, 2, 3]"), "machine-key");
  EXPECT_EQ(code_of("\xFF\xFE[\0m\0"), "machine-syntax");
  EXPECT_EQ(code_of("[machine]\nsecond = 3"), "machine-value");
}

TEST(MachineFile, ErrorsShowTheLineThatTheyMean) {
  try {
    parse_machine("[machine]\nkind = \"mill\"\nrapid = 0\n", "job.toml");
    FAIL() << "a rapid of 0 was taken";
  } catch (const PlacedError& error) {
    EXPECT_EQ(error.diagnostic().place.line, 3);
    EXPECT_EQ(error.diagnostic().source_line, "rapid = 0");
  }
}

TEST(MachineFile, RefusesWhatItDoesNotUnderstand) {
  EXPECT_EQ(code_of("[machine]\nrapids = 1"), "machine-key");
  EXPECT_EQ(code_of("[machine]\nzero.g54 = [1, 2, 3]"), "machine-key");
  EXPECT_EQ(code_of("[machine]\nlimits = [1, 2]"), "machine-value");
  EXPECT_EQ(code_of("[machine]\nlimits = { x = 5 }"), "machine-value");
  EXPECT_EQ(code_of("[machine]\nlimits = { x = [1, 2, 3] }"), "machine-value");
  EXPECT_EQ(code_of("[machine]\nlimits = { z = [0, -500] }"), "machine-value");
  EXPECT_EQ(code_of("[machine]\nlimits = { z = [0, 0] }"), "machine-value");
  EXPECT_EQ(code_of("[machine]\nlimits = { a = [0, 90] }"), "machine-key");
  EXPECT_EQ(code_of("[machine]\nkind = \"grinder\""), "machine-value");
  EXPECT_EQ(code_of("[machine]\nkind = 1"), "machine-value");
  EXPECT_EQ(code_of("[machine]\nrapid = 0"), "machine-value");
  EXPECT_EQ(code_of("[machine]\nrapid = [1, 2]"), "machine-value");
  EXPECT_EQ(code_of("[machine]\nrapid = [1, 2, nan]"), "machine-value");
  EXPECT_EQ(code_of("[machine]\ntool_change = \"6\""), "machine-value");
  EXPECT_EQ(code_of("machine = \"mill\""), "machine-missing");
  EXPECT_EQ(code_of("[machine"), "machine-syntax");
}

}  // namespace
}  // namespace mrsim
