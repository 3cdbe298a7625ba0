// A part cut with loops, calls and expressions is the part cut with the program written out, byte
// for byte; cycles leave the volumes of their closed forms.
#include "run_program.h"

#include <cmath>

namespace mrsim {
namespace {

using namespace mrsim::testing;

class Loops : public CliTest {
 protected:
  const std::string rest_ =
      " --dialect sinumerik --machine mill --stock box:0,0,-10,60,40,0 --tool 1=endmill:d=6 ";
};

TEST_F(Loops, PartEqualsThatOfTheProgramWrittenOut) {
  const std::string head = "G54 G17 G90 G71\nT1 D1 M6\nS3000 M3 F400\nG0 X0 Y0 Z5\n";
  write("loops.mpf", head +
                         "DEF INT COL, ROW\nDEF REAL DEEP[2]=SET(-2,-3.5)\nFOR ROW=0 TO 1\nCOL=1\n"
                         "WHILE COL<=3\nHOLE(COL*15,10+ROW*15,DEEP[ROW])\nCOL=COL+1\nENDWHILE\n"
                         "ENDFOR\nR1=0\nNEXT: R1=R1+1\nG1 Z=-R1\nG2 I=10/2\nIF R1<3 GOTOB NEXT\n"
                         "G0 Z5\nM30\n%_N_HOLE_SPF\nPROC HOLE(REAL XX, REAL YY, REAL ZZ)\n"
                         "G0 X=XX Y=YY\nG1 Z=ZZ\nG1 X=IC(2)\nG0 Z5\nRET\n");
  std::string plain = head;
  for (const int row : {10, 25})
    for (const int column : {15, 30, 45}) {
      plain += "G0 X" + std::to_string(column) + " Y" + std::to_string(row) + "\nG1 Z-" +
               (row == 10 ? "2" : "3.5") + "\nG1 X" + std::to_string(column + 2) + "\nG0 Z5\n";
    }
  for (const char* level : {"-1", "-2", "-3"}) plain += std::string("G1 Z") + level + "\nG2 I5\n";
  write("plain.mpf", plain + "G0 Z5\nM30\n");
  ASSERT_EQ(run("loops.mpf" + rest_ + "-q -o loops.stl").code, 0);
  ASSERT_EQ(run("plain.mpf" + rest_ + "-q -o plain.stl").code, 0);
  EXPECT_FALSE(read("loops.stl").empty());
  EXPECT_EQ(read("loops.stl"), read("plain.stl"));
}

// Three circles in ten depths under G42: by a subprogram in increments, by WHILE, by a macro with
// arguments, and written out.
TEST_F(Loops, FanucsPocketIsOnePart) {
  const std::string head = "O0001\nG90G80G40G49\nT1M6\nM3S2500\nG0G90G54X0Y0\nG43H1Z5\nG1Z0F500\n";
  const std::string tail = "G0Z100\nM30\n";
  const std::string circles =
      "G90G42D3X12.5\nG2I-12.5J0\nG1X17.5\nG2I-17.5\nG1X20.\nG2I-20.\nG0G90G40X0Y0\n";
  write("m98.nc", head + "M98P2L10\n" + tail + "O0002\nG91G1Z-0.5F200\n" + circles + "M99\n");
  write("while.nc", head +
                        "#1=1\nWHILE[#1LE10]DO1\nG1Z-[#1*0.5]F200\n#2=12.5\n#1=#1+1\n"
                        "G42D3X#2\nG2I-#2J0\n#2=#2+5\nG1X#2\nG2I-#2\n#2=#2+2.5\nG1X#2\n"
                        "G2I-#2\nG0G40X0Y0\nEND1\n" +
                        tail);
  write("g65.nc", head + "G65P9010Z-5.K0.5A12.5B17.5C20.\n" + tail +
                      "O9010\n#30=0\nN10#30=#30+#6\nG1Z-#30F200\nG42D3X#1\nG2I-#1\nG1X#2\n"
                      "G2I-#2\nG1X#3\nG2I-#3\nG0G40X0Y0\nIF[#30LT-#26]GOTO10\nM99\n");
  std::string plain = head;
  for (int i = 1; i <= 10; ++i) plain += "G1Z-" + std::to_string(i * 0.5) + "F200\n" + circles;
  write("plain.nc", plain + tail);
  for (const std::string name : {"m98", "while", "g65", "plain"}) {
    const Outcome outcome = run(name +
                                ".nc --dialect fanuc --machine mill --stock box:-30,-30,-10,30,30,0"
                                " --tool 1=endmill:d=10 -q -o " +
                                name + ".stl");
    ASSERT_EQ(outcome.code, 0) << name << outcome.err;
    ASSERT_FALSE(read(name + ".stl").empty());
    EXPECT_EQ(read(name + ".stl"), read("m98.stl")) << name;
  }
}

TEST_F(Loops, CyclesLeaveTheVolumesOfTheirClosedForms) {
  const double pi = 3.14159265358979323846, stock = 60 * 40 * 10;
  // Volumes are good to the square of the tolerance for each millimetre of edge (docs/accuracy.md).
  const double slack = 0.0102 * 0.0102 * (4 * (60 + 40 + 10) + 2 * 70);
  const auto volume = [&](const std::string& cycle) {
    write("cycle.mpf",
          "G54 G17 G90\nT1 D1 M6\nS3000 M3 F400\nG0 X30 Y20 Z20\n" + cycle + "\nM30\n");
    const Outcome outcome = run("cycle.mpf" + rest_ + "-o cycle.stl");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return number_after(outcome.out + outcome.err, "volume");
  };
  EXPECT_NEAR(volume("POCKET3(20,0,2,-5,40,24,6,30,20,0,2,0.2,0.1,800,200,0,21,4,,,,2,1)\n"
                     "POCKET3(20,0,2,-5,40,24,6,30,20,0,2,0.2,0.1,800,200,0,12)"),
              stock - 5 * (40 * 24 - (4 - pi) * 36), slack);
  EXPECT_NEAR(volume("POCKET4(20,0,2,-5,12,30,20,2,0,0,800,200,0,21,4,,,2,1)"),
              stock - 5 * pi * 144, slack);
  EXPECT_NEAR(volume("SLOT1(20,0,2,-4,,1,30,10,30,20,0,90,0,200,800,2,2,0,0,,,,,,,,,,1100)"),
              stock - 4 * (20 * 10 + pi * 25), slack);
}

}  // namespace
}  // namespace mrsim
