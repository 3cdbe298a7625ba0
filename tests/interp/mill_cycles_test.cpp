// SINUMERIK's milling cycles against the shapes of their manual: at the depth of the cycle the
// cutter reaches every point of the shape and no point beyond its wall.
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "interp/support.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace mrsim {
namespace {

using namespace mrsim::testing;

constexpr double kRadius = 5;  // of the cutter of at_origin

/// Signed distance of (x, y) from the shape, mm; below 0 inside.
using Shape = std::function<double(double, double)>;

double from_box(double x, double y, double half_length, double half_width, double corner) {
  const double dx = std::abs(x) - half_length + corner, dy = std::abs(y) - half_width + corner;
  return std::hypot(std::max(dx, 0.0), std::max(dy, 0.0)) + std::min(std::max(dx, dy), 0.0) -
         corner;
}

double from_motion(const Motion& m, double x, double y) {
  if (m.kind != MotionKind::arc) {
    const Vec2 d{m.end.x - m.start.x, m.end.y - m.start.y}, p{x - m.start.x, y - m.start.y};
    const double l = dot(d, d), t = l > 0 ? std::clamp(dot(p, d) / l, 0.0, 1.0) : 0;
    return length(p - t * d);
  }
  const double turn = m.sweep < 0 ? -m.sweep : m.sweep, sign = m.sweep < 0 ? -1 : 1;
  const double begin = std::atan2(m.start.y - m.center.y, m.start.x - m.center.x);
  double angle = sign * (std::atan2(y - m.center.y, x - m.center.x) - begin);
  while (angle < 0) angle += 2 * kPi;
  while (angle >= 2 * kPi) angle -= 2 * kPi;
  if (angle <= turn) return std::abs(std::hypot(x - m.center.x, y - m.center.y) - m.radius);
  return std::min(std::hypot(x - m.start.x, y - m.start.y), std::hypot(x - m.end.x, y - m.end.y));
}

/// Whether the motions at the depth clear the shape and nothing else, on a grid.
void expect_cleared(const std::string& text, double depth, const Shape& shape, double low,
                    double high) {
  SCOPED_TRACE(text);
  const Program p = read_text("T1 D1 M6\nS1000 M3\nG0 X0 Y0 Z50\n" + text + "\nM30\n",
                              at_origin(Dialect::sinumerik));
  EXPECT_EQ(codes(p), "");
  std::vector<Motion> cuts;
  for (const Motion& m : p.motions) {
    EXPECT_GE(m.end.z, depth - 1e-9);
    if (std::abs(m.end.z - depth) < 1e-9 && m.kind != MotionKind::rapid) cuts.push_back(m);
  }
  ASSERT_FALSE(cuts.empty());
  int missed = 0, gouged = 0;
  for (double x = low + 0.137; x < high; x += 0.71)
    for (double y = low + 0.211; y < high; y += 0.73) {
      double least = 1e9;
      for (const Motion& m : cuts) least = std::min(least, from_motion(m, x, y));
      const double d = shape(x, y);
      missed += d < -0.01 && least > kRadius + 0.005 ? 1 : 0;
      gouged += d > 0.01 && least < kRadius - 0.005 ? 1 : 0;
    }
  EXPECT_EQ(missed, 0);
  EXPECT_EQ(gouged, 0);
}

TEST(MillCycles, RectangularPocketsAreCleared) {
  const auto pocket = [](double x, double y) { return from_box(x, y, 30, 20, 8); };
  expect_cleared("POCKET3(50,0,2,-6,60,40,8,0,0,0,3,0,0,800,200,0,11)", -6, pocket, -40, 40);
  expect_cleared(
      "POCKET3(50,0,2,-6,60,40,8,0,0,0,2.5,0.3,0.2,800,200,0,21,4,,,,2,1)\n"
      "POCKET3(50,0,2,-6,60,40,8,0,0,0,3,0.3,0.2,800,200,1,12)",
      -6, pocket, -40, 40);
  expect_cleared("POCKET1(50,0,2,-6,,60,40,8,0,0,0,200,800,3,2,0.2,0,6)", -6, pocket, -40, 40);
  // Current list: depth and infeed incremental, width in per cent, from a corner.
  expect_cleared("POCKET3(50,0,2,6,60,40,8,-30,-20,0,3,0,0,800,200,0,31,70,,,,3,,,,,12100,11,111)",
                 -6, pocket, -40, 40);
  // Upright, and corners sharper than the cutter are as round as it is.
  expect_cleared(
      "POCKET3(50,0,2,-6,30,50,1,0,0,0,3,0,0,800,200,0,11)", -6,
      [](double x, double y) { return from_box(x, y, 15, 25, kRadius); }, -40, 40);
  expect_cleared(
      "POCKET3(50,0,2,-6,60,40,8,5,3,90,3,0,0,800,200,0,11)", -6,
      [](double x, double y) { return from_box(y - 3, x - 5, 30, 20, 8); }, -40, 40);
}

TEST(MillCycles, CircularPocketsAreCleared) {
  const auto pocket = [](double x, double y) { return std::hypot(x - 3, y - 4) - 22; };
  expect_cleared("POCKET4(50,0,2,-6,22,3,4,3,0,0,800,200,0,21,8,,,2,1)", -6, pocket, -30, 30);
  expect_cleared("POCKET2(50,0,2,,6,22,3,4,200,800,3,3,0.1,0)", -6, pocket, -30, 30);
  expect_cleared(
      "MCALL POCKET4(50,0,2,-6,22,,,3,0,0,800,200,0,11)\nX3 Y4\nMCALL", -6,
      [&](double x, double y) { return pocket(x, y); }, -30, 30);
}

TEST(MillCycles, SlotsAndLongHolesAreCleared) {
  const auto radial = [](double half_length, double half_width) {
    return [=](double x, double y) {  // four of them, inner ends on a circle of 10
      double least = 1e9;
      for (const double angle : {0.0, 90.0, 180.0, 270.0}) {
        const double c = std::cos(radians(angle)), s = std::sin(radians(angle));
        const double u = x * c + y * s - 10 - half_length, v = y * c - x * s;
        least = std::min(least, from_box(u, v, half_length, half_width, half_width));
      }
      return least;
    };
  };
  expect_cleared("SLOT1(50,0,2,-4,,4,20,14,0,0,10,0,90,200,800,2,3,0.2,0,4)", -4, radial(10, 7),
                 -32, 32);
  expect_cleared("LONGHOLE(50,0,2,,4,4,20,0,0,10,0,0,200,800,2)", -4, radial(10, 5), -32, 32);
  // Swinging down by at most 15 degrees, STA2.
  expect_cleared("SLOT1(50,0,2,-4,,4,20,14,0,0,10,0,90,200,800,2,3,0.2,30,4,,,0,15)", -4,
                 radial(10, 7), -32, 32);
  // One slot about its centre, as GMODE says.
  expect_cleared(
      "SLOT1(50,0,2,4,,1,40,14,0,0,0,90,0,200,800,2,0,0,1,,,,,,,,,,1100,,1)", -4,
      [](double x, double y) { return from_box(y, x, 20, 7, 7); }, -32, 32);
  // Along a circle of 20: two slots over 70 degrees.
  const auto arcs = [](double x, double y) {
    double least = 1e9;
    for (const double first : {0.0, 180.0}) {
      double angle = degrees(std::atan2(y, x)) - first;
      while (angle < -145) angle += 360;
      const double at = radians(std::clamp(angle, 0.0, 70.0) + first);
      least = std::min(least, std::hypot(x - 20 * std::cos(at), y - 20 * std::sin(at)) - 7);
    }
    return least;
  };
  expect_cleared("SLOT2(50,0,2,-4,,2,70,14,0,0,20,0,180,200,800,2,2,0.1,0,4)", -4, arcs, -32, 32);
}

TEST(MillCycles, SpigotsLeaveTheirShape) {
  // Inside of the blank and outside of the spigot all is cleared.
  const auto ring = [](double x, double y) {
    const double spigot = from_box(x, y, 20, 15, 4), blank = from_box(x, y, 30, 28, 0);
    return blank > 0.01 ? 0 : -spigot;  // beyond the blank nothing is asked
  };
  expect_cleared("CYCLE76(50,0,2,-6,,40,30,4,0,0,0,3,0,0,800,200,0,1,60,56)", -6, ring, -35, 35);
  // AMODE 1 with the depth in DPR.
  expect_cleared("CYCLE76(50,0,2,,6,40,30,4,0,0,0,3,0,0,800,200,0,1,60,56,1,2,1100,1,101)", -6,
                 ring, -35, 35);
  const auto round = [](double x, double y) {
    const double d = std::hypot(x - 2, y - 1);
    return d > 25 ? 0 : 15 - d;
  };
  expect_cleared(
      "CYCLE77(50,0,2,-6,,30,2,1,3,0.2,0.1,800,200,0,1,50)\n"
      "CYCLE77(50,0,2,-6,,30,2,1,3,0.2,0.1,800,200,0,2,31)",
      -6, round, -35, 35);
}

TEST(MillCycles, FacesAreCleared) {
  const auto face = [](double x, double y) {  // what is asked for lies inside of the face
    return x > 0.01 && x < 50 && y > 0.01 && y < 30 ? -1.0 : 0.0;
  };
  for (const char* way : {"11", "21", "31", "41"})
    expect_cleared(std::string("CYCLE71(50,3,2,0,0,0,50,30,0,2,8,5,0,800,") + way + ",1)", 0, face,
                   -10, 60);
  expect_cleared("CYCLE61(50,3,2,0,0,0,50,30,1.5,80,0,800,31,0,1,10)", 0, face, -10, 60);
  // Two edges that the cutter keeps inside of, given by both corners.
  const auto kept = [](double x, double y) {
    const bool inside = x > 5.01 && x < 50 && y < 25 && y > 0.01;
    return inside ? -1.0 : x < 0 || y > 30 ? 1.0 : 0.0;
  };
  expect_cleared("CYCLE61(50,3,2,0,0,0,50,30,1.5,80,0,800,31,1001,1,2210)", 0, kept, -10, 60);
}

TEST(MillCycles, OpenSlotsAndThreadsAreMilled) {
  const auto slot = [](double x, double y) {
    return std::abs(x) > 30 ? std::max(0.0, std::abs(y) - 12) : std::abs(y) - 12;
  };
  expect_cleared("CYCLE899(50,0,2,-6,60,24,0,0,0,3,6,0,0,800,0,1)", -6, slot, -33, 33);
  const Program p = read_text("T1 D1 M6\nG0 X0 Y0 Z50\nCYCLE90(50,0,2,-10,,30,26,2,500,3,0,4,3)\n",
                              at_origin(Dialect::sinumerik));
  const auto helix = std::find_if(p.motions.begin(), p.motions.end(),
                                  [](const Motion& m) { return m.kind == MotionKind::arc; });
  ASSERT_NE(helix, p.motions.end());
  EXPECT_DOUBLE_EQ(helix->radius, 10);
  EXPECT_NEAR(helix->sweep, 6 * 2 * kPi, 1e-9);
  EXPECT_NEAR(helix->rise, -12, 1e-9);
  EXPECT_NEAR(helix->end.z, -10, 1e-9);
}

std::string found_in(const std::string& text) {
  std::string out;
  const Program program =
      read_text("T1 D1 M6\nF100 G1 X0 Y0 Z50\n" + text + "\n", at_origin(Dialect::sinumerik));
  for (const Diagnostic& d : program.diagnostics)
    if (const std::size_t at = d.text.find("(alarm "); at != std::string::npos)
      out += d.code + d.text.substr(at + 6, 6);
    else if (d.severity >= Severity::warning)
      out += d.code;
  return out;
}

// Half of the smaller side is the largest corner that a rectangle can have.
TEST(MillCycles, ACornerLargerThanTheRectangleIsAFault) {
  const auto pocket = [](const std::string& corner) {
    return "POCKET3(20,0,2,-5,40,30," + corner + ",50,40,0,5,0,0,300,100,0,11,5)";
  };
  EXPECT_EQ(found_in(pocket("15")), "");
  EXPECT_EQ(found_in(pocket("15.0005")), "") << "rounded by a post";
  EXPECT_EQ(found_in(pocket("16")), "value-range 61113");
  EXPECT_EQ(found_in(pocket("30")), "value-range 61113");
  EXPECT_EQ(found_in("POCKET1(50,0,2,-6,,30,60,16,0,0,0,200,800,3,2,0.2,0,6)"),
            "value-range 61113");
  const auto spigot = [](const std::string& corner) {
    return "CYCLE76(20,0,2,-5,,40,30," + corner + ",50,40,0,5,0,0,300,100,0,1,50,40)";
  };
  EXPECT_EQ(found_in(spigot("15")), "");
  EXPECT_EQ(found_in(spigot("20")), "value-range 61113");
}

// Twelve slots of 30 x 10 meet where their inner ends lie on a circle of 5, and not on one of 20.
TEST(MillCycles, SlotsThatMeetAreWarnedOf) {
  const auto radial = [](const std::string& radius) {
    return "SLOT1(20,0,2,-5,,12,30,10,50,40," + radius + ",0,30,100,300,5,2,0,0)";
  };
  EXPECT_EQ(found_in(radial("5")), "slots-overlap");
  EXPECT_EQ(found_in(radial("14")), "slots-overlap") << "2 * 19 * sin 15 is 9.8";
  EXPECT_EQ(found_in(radial("15")), "") << "2 * 20 * sin 15 is 10.4";
  EXPECT_EQ(found_in("SLOT1(20,0,2,-5,,2,30,10,50,40,5,0,360,100,300,5,2,0,0)"), "slots-overlap");
  EXPECT_EQ(found_in("SLOT1(20,0,2,-5,,1,30,10,50,40,0,0,0,100,300,5,2,0,0)"), "");
  EXPECT_EQ(found_in("LONGHOLE(20,0,2,-5,,12,30,50,40,2,0,30,100,300,5)"), "slots-overlap");
  EXPECT_EQ(found_in("LONGHOLE(20,0,2,-5,,2,30,50,40,2,0,180,100,300,5)"), "");
  const auto curved = [](const std::string& angle) {
    return "SLOT2(20,0,2,-4,,3," + angle + ",14,0,0,42,0,120,200,800,2,2,0,0)";
  };
  EXPECT_EQ(found_in(curved("100")), "") << "2 * 42 * sin 10 is 14.6";
  EXPECT_EQ(found_in(curved("102")), "slots-overlap");
  EXPECT_EQ(found_in("MCALL " + radial("5") + "\nX1\nX2\nMCALL"), "not-supportednot-supported");
}

TEST(MillCycles, FaultsAreNamed) {
  const auto code = [](const std::string& text) {
    return codes(
        read_text("T1 D1 M6\nF100 G1 X0 Y0 Z50\n" + text + "\n", at_origin(Dialect::sinumerik)));
  };
  EXPECT_EQ(code("POCKET3(50,0,2,-6,60,8,8,0,0,0,3,0,0,800,200,0,11)"), "value-range");
  EXPECT_EQ(code("POCKET3(50,0,2,6,60,40,8,0,0,0,3,0,0,800,200,0,11)"), "value-range");
  EXPECT_EQ(code("POCKET3(50,0,2,,60,40,8,0,0,0,3,0,0,800,200,0,11)"), "value-missing");
  EXPECT_EQ(code("POCKET3(50,0,2,-6,60,40,8,0,0,0,3,0,0,800,200,0,5)"), "tool-unknown");
  EXPECT_EQ(code("POCKET4(50,0,2,6,22,3,4,3,0,0,800,200,0,11,50,9,15,2,1,0,1,2,10100,111,111)"),
            "not-supported");
  EXPECT_EQ(code("POCKET4(50,0,2,-6,-22,3,4,3)"), "value-range");
  EXPECT_EQ(code("T0 D0\nPOCKET4(50,0,2,-6,22,3,4,3)"), "tool-unknown");
  EXPECT_EQ(code("CYCLE77(50,0,2,-6,,30,0,0,3,0,0,800,200,0,1,900000000)"), "value-range");
  EXPECT_EQ(code("POCKET4(50,0,2,-6,22,1EX100,4,3)"), "number-too-large");
  EXPECT_EQ(code("CYCLE79(50,0,2,-6,,6,10)"), "not-supported");
  const std::string pocket = "POCKET3(50,0,2,-6,60,40,8,0,0,0,3,0,0,800,200,0,11)";
  EXPECT_EQ(code("SCALE X2 Y2\n" + pocket), "not-supported") << "what of the cutter's radius?";
  EXPECT_EQ(code("SCALE Z2\n" + pocket), "");
  EXPECT_EQ(code("MIRROR X0\n" + pocket), "");
}

TEST(MillCycles, AMissingRadiusIsToldOnceForATool) {
  InterpOptions options = at_origin(Dialect::sinumerik);
  options.table.tools.clear();
  const std::string pocket = "POCKET3(5,0,2,-4,40,20,4,0,0,0,2,0,0,500,100,0,11,8)\n";
  const Program p = read_text(
      "T3 M6\nS900 M3 F100\n" + pocket + "G0 X50\n" + pocket + "T4 M6\n" + pocket + "M30\n",
      options);
  EXPECT_EQ(codes(p, Severity::error), "tool-unknown tool-unknown") << listing(p);
}

// Without M6 the tool came into the spindle with the first move, behind the cycle's own question.
TEST(MillCycles, ATWithoutM6IsInTheSpindle) {
  const std::string pocket = "G0 X0 Y0 Z50\nPOCKET3(5,0,1,-5,40,30,8,0,0,0,5,0,0,500,200,0,11,5)\n";
  EXPECT_EQ(path_text(read_text("T1 D1\n" + pocket, at_origin(Dialect::sinumerik))),
            path_text(read_text("T1 D1 M6\n" + pocket, at_origin(Dialect::sinumerik))));
}

// The unit of DMODE is the plane of the cycle, whatever plane is in force.
TEST(MillCycles, DmodeChoosesThePlane) {
  const auto run_in = [](const std::string& plane, const std::string& dmode) {
    return path_text(read_text(plane +
                                   " T1 D1 M6\nG0 X0 Y0 Z50\nPOCKET3(50,0,1,-5,40,30,8,0,0,0,5,0,"
                                   "0,500,200,0,11,5,,,,,,,,,," +
                                   dmode + ")\nG1 X0 F9\n",
                               at_origin(Dialect::sinumerik)));
  };
  EXPECT_EQ(run_in("G18", "1"), run_in("G17", "0"));
  EXPECT_NE(run_in("G18", "0"), run_in("G17", "0"));
}

TEST(MillCycles, ValuesBehindTheListAreToldOf) {
  const auto run_drill = [](const std::string& more) {
    return codes(read_text("T1 D1 M6\nG0 X0 Y0 Z50 F9\nCYCLE81(10,0,2,-5,,0,1,1,1" + more + ")\n",
                           at_origin(Dialect::sinumerik)));
  };
  EXPECT_EQ(run_drill(""), "");
  EXPECT_EQ(run_drill(",0,0"), "");
  EXPECT_EQ(run_drill(",,7"), "word-without-effect");
}

TEST(MillCycles, ASpigotFromACornerIsRefused) {
  EXPECT_EQ(
      codes(read_text("T1 D1 M6\nG0 X0 Y0 Z50\nCYCLE76(10,0,2,-17.5,,-60,-40,15,80,60,10,11,,,"
                      "900,800,0,1,80,50)\n",
                      at_origin(Dialect::sinumerik)),
            Severity::error),
      "not-supported");
}

// The list of the old manual, with the depth as a level, and that of the current masks, with the
// depth below the reference, the width in per cent and the plane: the same motions.
TEST(MillCycles, OldAndCurrentListsMoveAlike) {
  const auto path = [](const std::string& cycle) {
    const Program p =
        read_text("T1 D1 M6\nG0 X0 Y0 Z50\n" + cycle + "\nM30\nBEG:\nG1 X0 Y0\nY20\nX20\nFIN:\n",
                  at_origin(Dialect::sinumerik));
    const bool engraves = cycle.starts_with("CYCLE60");
    EXPECT_EQ(codes(p), engraves ? "engraving-font" : "") << cycle;
    EXPECT_GT(p.motions.size(), 5U) << cycle;
    return path_text(p);
  };
  const std::pair<const char*, const char*> lists[] = {
      {"CYCLE60(\"HI\",50,1,2,0.2,,3,4,30,,,6,1,80,200,11000)",
       "CYCLE60(\"HI\",50,1,2,0.8,,3,4,30,,,6,1,80,200,11000,1252,0,0,1,1)"},
      {"CYCLE60(\"HI\",50,1,2,,0.8,3,4,30,,,6,1,80,200,0)",
       "CYCLE60(\"HI\",50,1,2,0.2,,3,4,30,,,6,1,80,200,0,1252,0,0,1,2)"},
      {"POCKET1(50,0,2,-6,,60,40,8,3,4,30,200,800,3,2,0.2,0,6)",
       "POCKET1(50,0,2,,6,60,40,8,3,4,30,200,800,3,2,0.2,0,6)"},
      {"POCKET2(50,0,2,-6,,22,3,4,200,800,3,3,0.1,0)",
       "POCKET2(50,0,2,,6,22,3,4,200,800,3,3,0.1,0)"},
      {"POCKET3(50,0,2,-6,60,40,8,3,4,30,2.5,0.3,0.2,800,200,0,21,4,,,,2,1)",
       "POCKET3(50,0,2,6,60,40,8,3,4,30,2.5,0.3,0.2,800,200,0,21,40,,,,2,1,0,1,2,11100,11,111)"},
      {"POCKET3(50,0,2,-6,60,40,8,0,0,0,2.5,0.3,0.2,800,200,1,12)",
       "POCKET3(50,0,2,6,60,40,8,-30,20,0,2.5,0.3,0.2,800,200,1,12,,,,,,,0,1,2,14100,11,111)"},
      {"POCKET4(50,0,2,-6,22,3,4,3,0.3,0.2,800,200,0,21,6,,,2,1)",
       "POCKET4(50,0,2,6,22,3,4,3,0.3,0.2,800,200,0,21,60,,,2,1,0,1,2,10100,11,11)"},
      {"SLOT1(50,0,2,-4,,4,20,14,1,2,10,0,90,200,800,2,3,0.2,0,4)",
       "SLOT1(50,0,2,4,,4,20,14,1,2,10,0,90,200,800,2,3,0.2,0,4,,,,,,0,1,2,0,11,1)"},
      {"SLOT2(50,0,2,-4,,2,70,14,1,2,20,0,180,200,800,2,2,0.1,0,4)",
       "SLOT2(50,0,2,4,,2,70,14,1,2,20,0,180,200,800,2,2,0.1,0,4,,,200,0,1,2,0,11,1)"},
      {"LONGHOLE(50,0,2,-4,,4,20,1,2,10,0,0,200,800,2)",
       "LONGHOLE(50,0,2,4,,4,20,1,2,10,0,0,200,800,2,1,0,0,11,1)"},
      {"CYCLE61(50,3,2,0,0,0,50,30,1.5,8,0,800,31)",
       "CYCLE61(50,3,2,3,0,0,50,30,1.5,80,0,800,31,0,1,11)"},
      {"CYCLE72(\"BEG:FIN\",50,0,2,-4,2,0.3,0.2,500,200,11,41,1,7,200,1,7)",
       "CYCLE72(\"BEG:FIN\",50,0,2,4,2,0.3,0.2,500,200,11,41,1,7,200,1,7,0,1,2,101,11,1)"},
      {"CYCLE72(\"BEG:FIN\",50,0,2,-4,2,0,0,500,200,11,40,1,7,200,1,7)",
       "CYCLE62(\"\",2,\"BEG\",\"FIN\")\n"
       "CYCLE72(\"\",50,0,2,4,2,0,0,500,200,11,40,1,7,200,1,7,0,1,2,101,11,1)"},
      {"CYCLE76(50,0,2,-6,,40,30,4,3,4,30,3,0.3,0.2,800,200,0,1,60,56)",
       "CYCLE76(50,0,2,,6,40,30,4,3,4,30,3,0.3,0.2,800,200,0,1,60,56,1,2,1100,1,101)"},
      {"CYCLE77(50,0,2,-6,,30,2,1,3,0.2,0.1,800,200,0,1,50)",
       "CYCLE77(50,0,2,,6,30,2,1,3,0.2,0.1,800,200,0,1,50,1,2,1100,1,101)"},
      {"CYCLE90(50,0,2,-10,,30,26,2,500,3,0,4,3)", "CYCLE90(50,0,2,,10,30,26,2,500,3,0,4,3)"},
      {"CYCLE899(50,0,2,-6,60,24,1,2,30,3,6,0,0,800,0,1)",
       "CYCLE899(50,0,2,6,60,24,1,2,30,3,60,0,0,800,0,1,1100,11,11)"},
  };
  for (const auto& [old, current] : lists) EXPECT_EQ(path(current), path(old)) << current;
}

// The face of the old cycle, along X to and fro, and that of the current one.
TEST(MillCycles, TheTwoFacingCyclesClearTheSameFace) {
  const auto levels = [](const std::string& cycle) {
    const Program p =
        read_text("T1 D1 M6\nG0 X0 Y0 Z50\n" + cycle + "\nM30\n", at_origin(Dialect::sinumerik));
    EXPECT_EQ(codes(p), "");
    std::vector<double> out;
    for (const Motion& m : p.motions)
      if (m.kind != MotionKind::rapid && (out.empty() || out.back() != m.end.z))
        out.push_back(m.end.z);
    return out;
  };
  EXPECT_EQ(levels("CYCLE71(50,3,2,0,0,0,50,30,0,1.5,6,5,0,800,31,1)"), (std::vector{1.5, 0.0}));
  EXPECT_EQ(levels("CYCLE61(50,3,2,0,0,0,50,30,1.5,6,0,800,31)"), (std::vector{1.5, 0.0}));
}

}  // namespace
}  // namespace mrsim
