#include "interp/recognise/recognise.h"

#include "support/random.h"
#include "support/temp_folder.h"

#include <fstream>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

auto recognised(const std::vector<std::string>& lines, const std::string& behind) {
  const testing::TempFolder folder;
  const std::string path = folder.path("program.nc");
  std::ofstream out(path);
  for (const std::string& line : lines)
    out << line << (line.find('%') == std::string::npos ? behind : "") << '\n';
  out.close();
  const Recognition r = recognise(path, {});
  return std::tuple(r.dialect, r.dialect_reason, r.machine, r.machine_reason, r.leader_lines,
                    r.empty);
}

std::string random_line(std::mt19937_64& random) {
  static const std::vector<std::string> kWords = {
      "X1.5", "Y-2.", "Z+.25", "I0", "J1", "K-3", "F100", "S8000", "G0", "G01", "G2",   "G03",
      "G1",   "G1.",  "G001",  "G4", "N7", "N8",  "XY",   "X 1",   "X1", "Y2",  "\tZ3", "-"};
  static const std::vector<std::string> kRare = {
      "T5",    "G96", "G18",    "U1",   "E1 E2", "FF100", "M98", "x1",  "G16", "%",
      "T0101", "; a", "G43 H1", "R1=4", "G28",   "$A$",   "O12", "G50", "=",   "CIP "};
  std::string line;
  for (std::size_t i = 1 + random() % 5; i > 0; --i) {
    const auto& words = random() % 60 ? kWords : kRare;
    line += words[random() % words.size()];
    if (random() % 8) line += ' ';
  }
  return line;
}

// An empty comment behind it says nothing, but a line that has one is not plain.
TEST(Recognise, PlainLinesSayWhatTheyWouldInFull) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    std::mt19937_64 random(testing::salted(seed));
    std::vector<std::string> lines(101, "X0");
    for (std::size_t i = 0; i < 5 + seed % 60; ++i) lines.push_back(random_line(random));
    EXPECT_EQ(recognised(lines, ""), recognised(lines, " ()")) << "seed " << seed;
  }
}

// Blanks at the end of a line are no sign: "% " is a tape mark, no header of CODESYS.
TEST(Recognise, BlanksAtTheEndsOfLinesSayNothing) {
  const std::vector<std::string> mill{"%  ", "N10 G90 G17 G40 ", "N20 G0 X0. Y0. \t", "N30 M2 "};
  EXPECT_EQ(std::get<0>(recognised(mill, "")), Dialect::fanuc);
  const std::vector<std::string> okuma{"$1001.MIN%  ", "G0 X0. Y0."};
  EXPECT_EQ(std::get<1>(recognised(okuma, "")), "a program name of Okuma in line 1");
}

}  // namespace
}  // namespace mrsim
