// G47 of Haas mills: where the letters stand, how high and deep they are, and which digits count.
#include "interp/path/stroke_font.h"
#include "interp/support.h"

#include <algorithm>

namespace mrsim {
namespace {

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

}  // namespace
}  // namespace mrsim
