// Engraved texts, G47 of Haas mills and CYCLE60 of SINUMERIK: where the letters stand, how high and
// deep they are, how they are spaced, and which digits count.
#include "interp/path/stroke_font.h"
#include "interp/support.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

struct Cuts {
  Vec3 low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
  std::size_t plunges = 0;
  double plunge_feed = 0, feed = 0;
};

// Of the cuts at the depth.
Cuts cuts_of(const Program& p) {
  Cuts out;
  for (const Motion& m : p.motions) {
    if (m.kind != MotionKind::line) continue;
    if (m.start.z > m.end.z) {
      ++out.plunges;
      out.plunge_feed = m.feed;
      continue;
    }
    out.feed = m.feed;
    for (const Vec3& v : {m.start, m.end}) {
      out.low = {std::min(out.low.x, v.x), std::min(out.low.y, v.y), std::min(out.low.z, v.z)};
      out.high = {std::max(out.high.x, v.x), std::max(out.high.y, v.y), std::max(out.high.z, v.z)};
    }
  }
  return out;
}

Program engraved(const std::string& text) {
  return read_text("G90 G0 Z20.\n" + text, at_origin(Dialect::fanuc));
}

std::string found(const std::string& text) {
  std::string out;
  for (const Diagnostic& d : engraved(text).diagnostics) out += d.code + " ";
  return out;
}

TEST(Engraving, CapitalsStandOnTheirLine) {
  const TextStrokes a = text_strokes("H");
  ASSERT_EQ(a.strokes.size(), 3U);
  EXPECT_EQ(a.strokes[0].front().y, 1);
  EXPECT_EQ(a.strokes[0].back().y, 0);
  EXPECT_DOUBLE_EQ(text_strokes("H H").width, 2 * a.width + text_strokes(" ").width);
  EXPECT_EQ(text_strokes("\xE4").strokes.size(), 0U);
}

// Two strokes of E and four letters' worth of rapids: place, height, depth, feeds as written.
TEST(Engraving, PlaceHeightAndDepthAreTheProgrammed) {
  const Program p = engraved("G47 P0 X30. Y40. J10. R2. Z-0.3 F150. E50. (HIT)\n");
  const Cuts c = cuts_of(p);
  EXPECT_EQ(c.plunges, 6U);  // H 3, I 1, T 2
  EXPECT_EQ(c.plunge_feed, 50);
  EXPECT_EQ(c.feed, 150);
  EXPECT_GT(c.low.x, 30);
  EXPECT_DOUBLE_EQ(c.low.y, 40);
  EXPECT_DOUBLE_EQ(c.high.y, 50);
  EXPECT_EQ(c.low.z, -0.3);
  EXPECT_EQ(c.high.z, -0.3);
  EXPECT_EQ(p.motions.back().end.z, 2) << "the level R";
  EXPECT_EQ(found("G47 P0 X30. Y40. J10. R2. Z-0.3 F150. (HIT)\n"
                  "G47 P0 X30. Y60. J10. R2. Z-0.3 (HIT)\n"),
            "engraving-font ");
}

TEST(Engraving, ITurnsTheTextAboutItsStart) {
  const Cuts c = cuts_of(engraved("G47 P0 X30. Y40. I90. J10. R2. Z-0.3 F150. (HIT)\n"));
  EXPECT_NEAR(c.low.x, 20, 1e-9);
  EXPECT_NEAR(c.high.x, 30, 1e-9);
  EXPECT_GT(c.low.y, 40);
}

// The widths that the manual prints.
TEST(Engraving, SpaceAndExclamationMarkHaveTheControlsWidth) {
  const Program p = engraved("G47 P32 X0 Y0 J10. R2. Z-1. F150.\nG47 P33 J10. Z-1.\n");
  EXPECT_NEAR(p.motions.back().end.x, 8.64 + 5.384, 0.02);
}

TEST(Engraving, InchesHaveLettersOfAnInch) {
  const Cuts c = cuts_of(engraved("G20 G47 P72 X1. Y0 R.1 Z-.01 F10.\n"));
  EXPECT_NEAR(c.high.y, 25.4, 1e-9);
  EXPECT_NEAR(c.low.z, -0.254, 1e-9);
}

TEST(Engraving, SerialNumbersCountOn) {
  const std::string words = " J5. Z-0.2 R1. F100.\n";
  // As many strokes as the digits written out.
  const auto same = [&](const std::string& serial, const std::string& digits) {
    const Program a = engraved(serial), b = engraved("G47 P0 (" + digits + ")" + words);
    return path_text(a) == path_text(b);
  };
  EXPECT_TRUE(same("#599=47\nG47 P1 (####)" + words, "0047"));
  EXPECT_TRUE(same("#599=12345\nG47 P1 (####)" + words, "2345"));
  EXPECT_TRUE(same("G47 P1 (0123)" + words, "0123"));
  const Cuts one = cuts_of(engraved("G47 P0 (0123)" + words));
  const Cuts next = cuts_of(engraved("G47 P0 (0124)" + words));
  EXPECT_EQ(cuts_of(engraved("G47 P1 (0123)" + words + "G47 P1 (####)" + words)).plunges,
            one.plunges + next.plunges);
  EXPECT_EQ(found("G47 P1 (###)" + words), "serial-number engraving-font ");
  EXPECT_EQ(found("G47 P1 (SN ###)" + words), "value-range ");
}

TEST(Engraving, TheTextIsNoToolComment) {
  EXPECT_EQ(found("G47 P0 X0 Y0 J5. R1. Z-0.2 F100. (T5 6MM ENDMILL)\n"), "engraving-font ");
}

TEST(Engraving, WhatIsMissingIsTold) {
  EXPECT_EQ(found("G47 P0 X0 Y0 J5. R1. F100. (A)\n"), "value-missing ");
  EXPECT_EQ(found("G47 P0 X0 Y0 J5. R1. Z-1. F100.\n"), "value-missing ");
  EXPECT_EQ(found("G47 P0 X0 Y0 R1. Z-1. F100. (A)\n"), "value-missing ");
  EXPECT_EQ(found("G47 P0 X0 Y0 J5. R-2. Z-1. F100. (A)\n"), "value-range ");
  EXPECT_EQ(found("G47 P2 X0 Y0 J5. R2. Z-1. F100. (A)\n"), "value-range ");
  EXPECT_EQ(found("G91 G47 P0 J5. R2. Z-1. F100. (A)\n"), "not-supported ");
  EXPECT_EQ(found("G68 X0 Y0 R30.\nG47 P0 J5. R2. Z-1. F100. (A)\n"), "not-supported ");
  EXPECT_EQ(found("G47 X10. D1\n"), "not-supported ");
}

Program cycle60(const std::string& values) {
  return read_text("T1 D1 M6\nG0 X0 Y0 Z60\nS900 M3 F300\nCYCLE60(" + values + ")\nM30\n",
                   at_origin(Dialect::sinumerik));
}

std::string faults(const std::string& values) { return codes(cycle60(values)); }

// H is 14 of 21 units wide.
constexpr double kWide = 14.0 / 21;

TEST(Cycle60, ALineOfTextIsAsHighAndAsDeepAsTheProgramSays) {
  const Program p = cycle60("\"HH\",50,1,2,,0.5,30,40,0,,,6,1.5,80,200,0,1252");
  const Cuts c = cuts_of(p);
  EXPECT_EQ(codes(p), "engraving-font");
  EXPECT_EQ(c.plunges, 6U);
  EXPECT_EQ(c.plunge_feed, 80);
  EXPECT_EQ(c.feed, 200);
  EXPECT_DOUBLE_EQ(c.low.x, 30);
  EXPECT_DOUBLE_EQ(c.high.x, 30 + 2 * kWide * 6 + 1.5) << "two letters and the gap";
  EXPECT_DOUBLE_EQ(c.low.y, 40);
  EXPECT_DOUBLE_EQ(c.high.y, 46);
  EXPECT_DOUBLE_EQ(c.low.z, 0.5) << "DPR below RFP";
  EXPECT_DOUBLE_EQ(c.high.z, 0.5);
  EXPECT_DOUBLE_EQ(p.motions.back().end.z, 50);
}

TEST(Cycle60, DepthsAreLevelsOrIncrements) {
  EXPECT_DOUBLE_EQ(cuts_of(cycle60("\"H\",50,1,2,-0.2,,0,0,0,,,6,1,80,200,0")).low.z, -0.2);
  const std::string tail = ",0,0,0,,,6,1,80,200,0,1252,0,0,1,";
  EXPECT_DOUBLE_EQ(cuts_of(cycle60("\"H\",50,1,2,0.2," + tail + "1")).low.z, 0.8);
  EXPECT_DOUBLE_EQ(cuts_of(cycle60("\"H\",50,1,2,0.2," + tail + "2")).low.z, 0.2);
}

// Thousands and ten thousands of VARI: where in the text the reference point is.
TEST(Cycle60, TheReferencePointIsACornerAnEdgeOrTheMiddle) {
  const double width = 2 * kWide * 6 + 1.5;
  for (int across = 0; across < 3; ++across)
    for (int up = 0; up < 3; ++up) {
      const Cuts c = cuts_of(cycle60(
          fmt::format("\"HH\",50,0,2,-1,,30,40,0,,,6,1.5,80,200,{}", across * 1000 + up * 10000)));
      EXPECT_NEAR(c.low.x, 30 - across * width / 2, 1e-12);
      EXPECT_NEAR(c.high.x, 30 + (2 - across) * width / 2, 1e-12);
      EXPECT_NEAR(c.low.y, 40 - up * 3.0, 1e-12);
      EXPECT_NEAR(c.high.y, 40 + (2 - up) * 3.0, 1e-12);
    }
}

TEST(Cycle60, TheTextTurnsAboutItsReferencePointWhichMayBePolar) {
  const Cuts c = cuts_of(cycle60("\"HH\",50,0,2,-1,,50,90,90,,,6,1.5,80,200,1"));
  EXPECT_NEAR(c.high.x, 0, 1e-12);
  EXPECT_NEAR(c.low.x, -6, 1e-12);
  EXPECT_NEAR(c.low.y, 50, 1e-12);
  EXPECT_NEAR(c.high.y, 50 + 2 * kWide * 6 + 1.5, 1e-12);
}

TEST(Cycle60, AWholeWidthSpreadsTheLetters) {
  const Cuts c = cuts_of(cycle60("\"HIH\",50,0,2,-1,,30,40,0,,,6,44,80,200,100000"));
  EXPECT_NEAR(c.low.x, 30, 1e-12);
  EXPECT_NEAR(c.high.x, 74, 1e-12);
}

/// Angle and distance of a point from the centre {10, 20}.
Vec2 polar_of(const Vec3& v) {
  return {std::atan2(v.y - 20, v.x - 10) * 180 / 3.14159265358979323846,
          std::hypot(v.x - 10, v.y - 20)};
}

// I is one stroke: on an arc it points to the centre wherever it stands.
TEST(Cycle60, LettersStandOnAnArc) {
  struct Case {
    int form;
    std::vector<double> angles;
    double inner;
  };
  for (const Case& e : {
           Case{200010, {90, 60, 30}, 40},    // over the centre, clockwise from the point
           Case{201010, {120, 90, 60}, 40},   // centred
           Case{202010, {150, 120, 90}, 40},  // ends there
           Case{220010, {90, 60, 30}, 34},    // its tops at the point
           Case{210010, {90, 60, 30}, 37},    // its middle
           Case{200020, {90, 120, 150}, 34},  // tops inwards, anticlockwise
           Case{221020, {60, 90, 120}, 40},
           Case{11201010, {60, 90, 120}, 40},  // mirrored; a polar centre is told below
       }) {
    SCOPED_TRACE(e.form);
    const bool polar = e.form >= 10000000;
    const Program p = cycle60(fmt::format(
        "\"III\",50,0,2,-1,,10,60,0,{},6,60,80,200,{}",
        polar ? fmt::format("{:.15f},{:.15f}", std::sqrt(500.0), 63.434948822922011) : "10,20",
        e.form));
    ASSERT_EQ(codes(p), "engraving-font");
    std::vector<double> angles;
    for (const Motion& m : p.motions) {
      if (m.kind != MotionKind::line || m.start.z > m.end.z) continue;
      const Vec2 a = polar_of(m.start), b = polar_of(m.end);
      EXPECT_NEAR(a.x, b.x, 1e-9) << "radial";
      EXPECT_NEAR(std::min(a.y, b.y), e.inner, 1e-9);
      EXPECT_NEAR(std::max(a.y, b.y), e.inner + 6, 1e-9);
      angles.push_back(a.x);
    }
    ASSERT_EQ(angles.size(), e.angles.size());
    for (std::size_t i = 0; i < angles.size(); ++i) EXPECT_NEAR(angles[i], e.angles[i], 1e-9);
  }
}

// L's foot points in the direction of reading, clockwise over the centre.
TEST(Cycle60, LettersOnAnArcAreNotMirrored) {
  const auto foot = [](const char* form) {
    const Program p = cycle60(std::string("\"L\",50,0,2,-1,,10,60,0,10,20,6,1,80,200,") + form);
    const Motion& last = *std::find_if(p.motions.rbegin(), p.motions.rend(),
                                       [](const Motion& m) { return m.kind == MotionKind::line; });
    return last.end.x - last.start.x;
  };
  EXPECT_GT(foot("1010"), 3.4);
  EXPECT_LT(foot("1020"), -3.4);
  EXPECT_LT(foot("10001010"), -3.4);
}

TEST(Cycle60, AMirroredTextIsReadFromBehind) {
  const Program plain = cycle60("\"LH\",50,0,2,-1,,30,40,0,,,6,1.5,80,200,1000");
  const Program mirrored = cycle60("\"LH\",50,0,2,-1,,30,40,0,,,6,1.5,80,200,10001000");
  ASSERT_EQ(plain.motions.size(), mirrored.motions.size());
  for (std::size_t i = 2; i < plain.motions.size(); ++i) {
    EXPECT_NEAR(plain.motions[i].end.x - 30, 30 - mirrored.motions[i].end.x, 1e-12);
    EXPECT_EQ(plain.motions[i].end.y, mirrored.motions[i].end.y);
  }
}

TEST(Cycle60, VariablesAndJoinedTextsAreLetters) {
  const auto path = [](const std::string& text) {
    return path_text(read_text("T1 D1 M6\nG0 X0 Y0 Z60\nS900 M3 F300\n" + text + "\nM30\n",
                               at_origin(Dialect::sinumerik)));
  };
  EXPECT_EQ(path("R1=47\nCYCLE60(\"NR \"<<R1,50,0,2,-1,,0,0,0,,,6,1,80,200,0)"),
            path("\nCYCLE60(\"NR 47\",50,0,2,-1,,0,0,0,,,6,1,80,200,0)"));
}

TEST(Cycle60, WhatIsNotKnownIsRefused) {
  const std::string head = "50,0,2,-1,,0,0,0,,,6,1,80,200,";
  EXPECT_EQ(faults("\"A<#,R1>\"," + head + "0"), "not-supported");
  EXPECT_EQ(faults("\"\xC4\"," + head + "0"), "not-supported");
  EXPECT_EQ(faults("," + head + "0"), "value-missing");
  EXPECT_EQ(faults("\"A\",50,0,2"), "value-missing");
  EXPECT_EQ(faults("\"A\",50,0,2,-1,,0,0,0,,,6,,80,200,0"), "value-missing");
  EXPECT_EQ(faults("\"A\",50,0,2,1,,0,0,0,,,6,1,80,200,0"), "value-range");
  EXPECT_EQ(faults("\"A\",50,0,2,-1,,0,0,0,,,0,1,80,200,0"), "value-range");
  EXPECT_EQ(faults("\"A\"," + head + "2"), "value-range");
  EXPECT_EQ(faults("\"A\"," + head + "100"), "value-range");
  EXPECT_EQ(faults("\"A\"," + head + "200000"), "value-range") << "an angle for a line";
  EXPECT_EQ(faults("\"AB\"," + head + "100000"), "value-range") << "1 mm for two letters";
  EXPECT_EQ(faults("\"A\"," + head + "10"), "value-range") << "no radius";
  EXPECT_EQ(faults("\"A\"," + head + "10000000"), "not-supported") << "mirrored about what?";
  EXPECT_EQ(faults("\"A\"," + head + "0,932"), "not-supported");
  EXPECT_EQ(faults("\"A\"," + head + "0,1252,0,0,2,1"), "cycle-plane");
  EXPECT_EQ(faults("\"A\"," + head + "0,1252,0,0,1,101"), "not-supported");
  EXPECT_EQ(faults("\"" + std::string(100, 'H') + "\",50,0,2,-1,,9,0,0,0,0,6,1,80,200,10"),
            "value-range")
      << "longer than its circle";
}

}  // namespace
}  // namespace mrsim
