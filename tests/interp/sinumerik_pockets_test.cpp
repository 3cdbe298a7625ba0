// CYCLE63: pockets and spigots of any contour, as worked out by hand.
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

std::string pocketed(const std::string& text) {
  return path_text(read_text("T1 D1 M6\nG0 X50 Y50 Z50\n" + text, at_origin(Dialect::sinumerik)));
}

const std::string kSquare = "M30\n%_N_SQUARE_SPF\nG0 X0 Y0\nG1 X20\nY20\nX0\nY0\nM17\n";
const std::string kBlank = "%_N_BLANK_SPF\nG0 X-8 Y-8\nG1 X28\nY28\nX-8\nY-8\nM17\n";
const std::string kStart = "r50,50,50 ";
const std::string kRound = "l5,15,Z l5,5,Z l15,5,Z l15,15,Z ";

std::string at_level(std::string path, const std::string& z) {
  for (std::size_t at; (at = path.find('Z')) != path.npos;) path.replace(at, 1, z);
  return path;
}

TEST(SinumerikPockets, ASquareIsClearedInTwoInfeeds) {
  // From the corner that is nearest; counter-clockwise, climbing; the floor's allowance is 1.
  const std::string path = kStart + "r15,15,50 r15,15,2 l15,15,-2 " + at_level(kRound, "-2") +
                           "r15,15,2 r15,15,0 l15,15,-4 " + at_level(kRound, "-4") + "r15,15,50";
  EXPECT_EQ(pocketed("CYCLE62(\"SQUARE\",0,,)\nCYCLE63(\"\",11,50,0,2,-5,500,200,5,2,0,1,0,0,0,0,0,"
                     "0,0,0,\"\",1,0,0,101,0)\n" +
                     kSquare),
            path);
  // The depth as an increment, the way between loops in per cent of the diameter.
  EXPECT_EQ(pocketed("CYCLE62(\"SQUARE\",0,,)\nCYCLE63(\"\",11,50,0,2,5,500,200,50,2,0,1,0,0,0,0,0,"
                     "0,0,0,\"\",1,0,0,101,11)\n" +
                     kSquare),
            path);
}

TEST(SinumerikPockets, FloorAndWallAreFinishedApart) {
  // The floor in one cut, 1 mm from the wall; conventional: clockwise.
  EXPECT_EQ(pocketed("CYCLE62(\"SQUARE\",0,,)\nCYCLE63(\"\",3,50,0,2,-5,500,200,5,2,1,1,1,0,0,0,0,"
                     "0,0,0,\"\",1,0,0,101,0)\n" +
                     kSquare),
            kStart + "r14,14,50 r14,14,2 l14,14,-5 l14,6,-5 l6,6,-5 l6,14,-5 l14,14,-5 r14,14,50");
  EXPECT_EQ(pocketed("CYCLE62(\"SQUARE\",0,,)\nCYCLE63(\"\",4,50,0,2,-5,500,200,5,5,1,0,0,0,0,0,0,"
                     "0,0,0,\"\",1,0,0,101,0)\n" +
                     kSquare),
            kStart + "r15,15,50 r15,15,2 l15,15,-5 " + at_level(kRound, "-5") + "r15,15,50");
}

TEST(SinumerikPockets, ASpigotIsMilledAlongItsWall) {
  // Its wall alone: clockwise about the square, arcs about its corners.
  EXPECT_EQ(
      pocketed("CYCLE62(\"BLANK\",0,,)\nCYCLE62(\"SQUARE\",0,,)\nCYCLE63(\"\",4,50,0,2,-5,500,"
               "200,5,5,0,0,0,0,0,0,0,0,0,0,\"\",1,0,0,201,0)\n" +
               kSquare + kBlank),
      kStart +
          "r23.54,23.54,50 r23.54,23.54,2 l23.54,23.54,-5 a25,20,-5 l25,0,-5 a20,-5,-5 "
          "l0,-5,-5 a-5,0,-5 l-5,20,-5 a0,25,-5 l20,25,-5 a23.54,23.54,-5 r23.54,23.54,50");
  // Roughing reaches over the blank's edge: it lies 8 mm outside, the cutter's centre 5 more.
  const Program p = read_text(
      "T1 D1 M6\nG0 X50 Y50 "
      "Z50\nCYCLE62(\"BLANK\",0,,)\nCYCLE62(\"SQUARE\",0,,)\nCYCLE63(\"\",1,50,"
      "0,2,-5,500,200,5,5,0,0,0,0,0,0,0,0,0,0,\"\",1,0,0,201,0)\n" +
          kSquare + kBlank,
      at_origin(Dialect::sinumerik));
  double left = 0, right = 0;
  for (const Motion& m : p.motions)
    if (m.kind != MotionKind::rapid) {
      left = std::min(left, m.end.x);
      right = std::max(right, m.end.x);
    }
  EXPECT_NEAR(left, -13, 1e-9);
  EXPECT_NEAR(right, 33, 1e-9);
}

// A cone of 90 degrees 3 mm deep, a chamfer of 1: the axis runs 2 mm from the wall.
TEST(SinumerikPockets, AChamferRunsBesideTheWall) {
  InterpOptions options = at_origin(Dialect::sinumerik);
  options.table.tools[0].type = ToolType::chamfer;
  options.table.tools[0].tip_angle = radians(90);
  const auto cut = [&](const std::string& text) {
    return path_text(read_text("T1 D1 M6\nG0 X50 Y50 Z50\n" + text, options));
  };
  const std::string named = "CYCLE62(\"SQUARE\",0,,)\n";
  const std::string expected =
      kStart + "r18,18,50 r18,18,2 l18,18,-3 l2,18,-3 l2,2,-3 l18,2,-3 l18,18,-3 r18,18,50";
  EXPECT_EQ(
      cut(named + "CYCLE63(\"\",5,50,0,2,-5,500,200,5,2,0,0,0,0,0,0,0,0,1,3,\"\",1,0,0,101,100)\n" +
          kSquare),
      expected);
  EXPECT_EQ(
      cut(named + "CYCLE63(\"\",5,50,0,2,-5,500,200,5,2,0,0,0,0,0,0,0,0,1,-3,\"\",1,0,0,101,0)\n" +
          kSquare),
      expected);
  // A round pocket, and a round spigot; along a contour on its right, the outside.
  EXPECT_EQ(cut("POCKET4(50,0,2,-5,20,0,0,2,0,0,500,200,0,15,0,0,0,0,0,0,1,3,0,1,100)\n"),
            kStart + "r0,0,50 r0,0,2 l0,0,-3 l18,0,-3 a18,0,-3 r18,0,50 r0,0,50");
  EXPECT_EQ(cut("CYCLE77(50,0,2,-5,,20,0,0,2,0,0,500,200,0,5,20,1,3,0,1,100)\n"),
            kStart + "r16,0,50 r16,0,2 l16,0,-3 l12,0,-3 a12,0,-3 r12,0,50 r16,0,50");
  EXPECT_EQ(
      cut("CYCLE72(\"SQUARE\",50,0,2,-5,2,0,0,500,200,5,42,1,7,200,1,7,0,1,3,0,1,100)\n" + kSquare),
      kStart +
          "r-7,-2,50 r-7,-2,2 l-7,-2,-3 l0,-2,-3 l20,-2,-3 a22,0,-3 l22,20,-3 "
          "a20,22,-3 l0,22,-3 a-2,20,-3 l-2,0,-3 l-2,-7,-3 r-2,-7,50");
  // The tip is not deep enough for the width; the tool has no cone.
  EXPECT_EQ(
      cut(named + "CYCLE63(\"\",5,50,0,2,-5,500,200,5,2,0,0,0,0,0,0,0,0,4,3,\"\",1,0,0,101,100)\n" +
          kSquare),
      "r50,50,50 | value-range");
  EXPECT_EQ(
      pocketed(named + "CYCLE63(\"\",5,50,0,2,-5,500,200,5,2,0,0,0,0,0,0,0,0,1,3)\n" + kSquare),
      "r50,50,50 | tool-unknown");
}

TEST(SinumerikPockets, WhatIsNotRead) {
  const std::string named = "CYCLE62(\"SQUARE\",0,,)\n";
  const auto found = [&](const std::string& call) {
    const Program p = read_text("T1 D1 M6\nG0 X50 Y50 Z50\n" + named + call + "\n" + kSquare,
                                at_origin(Dialect::sinumerik));
    return fmt::format("{} {}", p.motions.size(), codes(p));
  };
  EXPECT_EQ(found("CYCLE63(\"\",2,50,0,2,-5,500,200,5,2)"), "1 not-supported");
  EXPECT_EQ(found("CYCLE63(\"\",1,50,0,2,5,500,200,5,2)"), "1 value-range");
  EXPECT_EQ(found("CYCLE63(\"\",1,50,0,2)"), "1 value-missing");
  // A spigot without its blank.
  EXPECT_EQ(found("CYCLE63(\"\",1,50,0,2,-5,500,200,5,2,0,0,0,,,,,,,,,,,,201)"), "1 not-supported");
  // A cutter of 10 with 6 left at each wall of 20.
  EXPECT_EQ(found("CYCLE63(\"\",1,50,0,2,-5,500,200,5,2,6)"), "1 value-range");
  // An open contour.
  const Program open = read_text(
      "T1 D1 M6\nG0 X50 Y50 "
      "Z50\nCYCLE62(\"\",2,\"AA\",\"BB\")\nCYCLE63(\"\",1,50,0,2,-5,500,200,5,2)\n"
      "M30\nAA:\nG0 X0 Y0\nG1 X20\nY20\nBB:\n",
      at_origin(Dialect::sinumerik));
  EXPECT_EQ(codes(open), "pocket-contour");
}

}  // namespace
}  // namespace mrsim
