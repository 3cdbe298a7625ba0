// Every way of programming an arc, in every plane, both directions, all dialects: the expectation
// is built from centre, radius and angles, never from the code under test.
#include "interp/support.h"
#include "support/random.h"

#include <cmath>
#include <functional>
#include <random>

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

struct Arc {
  int plane = 0;  // 0 = G17, 1 = G18, 2 = G19
  double cu = 0, cv = 0, radius = 1;
  double from = 0, sweep = 0;  // degrees, signed
  double height = 0, rise = 0;
};

// Axis indices of the plane: first, second, normal.
constexpr int kAxes[3][3] = {{0, 1, 2}, {2, 0, 1}, {1, 2, 0}};

Vec3 place(const Arc& a, double u, double v, double w) {
  double p[3];
  p[kAxes[a.plane][0]] = u;
  p[kAxes[a.plane][1]] = v;
  p[kAxes[a.plane][2]] = w;
  return {p[0], p[1], p[2]};
}

Vec3 at(const Arc& a, double share) {
  const double angle = (a.from + share * a.sweep) * kPi / 180;
  return place(a, a.cu + a.radius * std::cos(angle), a.cv + a.radius * std::sin(angle),
               a.height + share * a.rise);
}

std::string words(const char* letters, const Vec3& p, const char* format = "{}{:.12f} ") {
  return fmt::format(fmt::runtime(format), letters[0], p.x) +
         fmt::format(fmt::runtime(format), letters[1], p.y) +
         fmt::format(fmt::runtime(format), letters[2], p.z);
}

// Centre words of the plane only.
std::string centre(const Arc& a, const Vec3& c, const char* format = "{}{:.12f} ") {
  std::string out;
  for (const int k : {kAxes[a.plane][0], kAxes[a.plane][1]})
    out += fmt::format(fmt::runtime(format), "IJK"[k], k == 0 ? c.x : k == 1 ? c.y : c.z);
  return out;
}

std::string head(const Arc& a) {
  const Vec3 s = at(a, 0);
  return fmt::format("G90 G{} G0 {}F100\n", 17 + a.plane, words("XYZ", s));
}

std::string g(const Arc& a) { return a.sweep > 0 ? "G3 " : "G2 "; }

Vec3 centre_offset(const Arc& a) {
  const Vec3 s = at(a, 0), c = place(a, a.cu, a.cv, a.height);
  return {c.x - s.x, c.y - s.y, c.z - s.z};
}

std::string by_offset(const Arc& a) {
  return head(a) + g(a) + words("XYZ", at(a, 1)) + centre(a, centre_offset(a));
}
std::string by_offset_incremental(const Arc& a) {
  const Vec3 s = at(a, 0), e = at(a, 1);
  return head(a) + "G91 " + g(a) + words("XYZ", {e.x - s.x, e.y - s.y, e.z - s.z}) +
         centre(a, centre_offset(a));
}
std::string by_absolute(const Arc& a) {
  return head(a) + g(a) + words("XYZ", at(a, 1)) +
         centre(a, place(a, a.cu, a.cv, a.height), "{}=AC({:.12f})");
}
std::string by_words_of_both_kinds(const Arc& a) {
  const Vec3 c = place(a, a.cu, a.cv, a.height), o = centre_offset(a);
  const int first = kAxes[a.plane][0], second = kAxes[a.plane][1];
  const auto get = [](const Vec3& p, int k) { return k == 0 ? p.x : k == 1 ? p.y : p.z; };
  return head(a) + g(a) + words("XYZ", at(a, 1)) +
         fmt::format("{}=AC({:.12f}) {}=IC({:.12f})", "IJK"[first], get(c, first), "IJK"[second],
                     get(o, second));
}
std::string by_radius(const Arc& a, const char* word) {
  const double sign = std::abs(a.sweep) > 180 ? -1 : 1;
  return head(a) + g(a) + words("XYZ", at(a, 1)) + fmt::format("{}{:.12f}", word, sign * a.radius);
}
std::string by_angle_and_end(const Arc& a) {
  return head(a) + g(a) + words("XYZ", at(a, 1)) + fmt::format("AR={:.12f}", std::abs(a.sweep));
}
std::string normal_word(const Arc& a) {
  const Vec3 e = at(a, 1);
  const int k = kAxes[a.plane][2];
  return a.rise == 0 ? std::string()
                     : fmt::format("{}{:.12f} ", "XYZ"[k],
                                   k == 0   ? e.x
                                   : k == 1 ? e.y
                                            : e.z);
}
std::string by_angle_and_centre(const Arc& a) {
  return head(a) + g(a) + normal_word(a) + centre(a, centre_offset(a)) +
         fmt::format("AR={:.12f}", std::abs(a.sweep));
}
std::string by_polar(const Arc& a) {
  return head(a) + "G111 " + words("XYZ", place(a, a.cu, a.cv, 0)) + "\n" + g(a) + normal_word(a) +
         fmt::format("AP={:.12f} RP={:.12f}", std::remainder(a.from + a.sweep, 360.0), a.radius);
}
std::string by_point(const Arc& a) {
  const Vec3 m = at(a, 0.4);
  return head(a) + "CIP " + words("XYZ", at(a, 1)) +
         fmt::format("I1={:.12f}J1={:.12f} K1={:.12f}", m.x, m.y, m.z);
}
std::string by_t(const Arc& a) {
  return head(a) + g(a) + normal_word(a) + centre(a, centre_offset(a)) +
         fmt::format("T{:.12f}", std::abs(a.sweep));
}
std::string by_g98(const Arc& a) {
  return head(a) + "G98\n" + g(a) + words("XYZ", at(a, 1)) +
         centre(a, place(a, a.cu, a.cv, a.height));
}

void expect_arc(const std::string& text, const Arc& a, Dialect dialect) {
  SCOPED_TRACE(text);
  const Program p = read_text(text + "\n", at_origin(dialect));
  ASSERT_EQ(codes(p), "");
  ASSERT_FALSE(p.motions.empty());
  const Motion& m = p.motions.back();
  ASSERT_EQ(m.kind, MotionKind::arc);
  expect_near(m.start, at(a, 0), 1e-8);
  expect_near(m.end, at(a, 1), 1e-8);
  expect_near(m.center, place(a, a.cu, a.cv, a.height), 1e-6 * a.radius);
  expect_near(m.axis, place(a, 0, 0, 1), 1e-9);
  EXPECT_NEAR(m.radius, a.radius, 1e-6 * a.radius);
  EXPECT_NEAR(degrees(m.sweep), a.sweep, 1e-5);
  EXPECT_NEAR(m.rise, a.rise, 1e-9);
  // The middle of the arc as any reader of Motion works it out.
  const Vec3 r{m.start.x - m.center.x, m.start.y - m.center.y, m.start.z - m.center.z};
  const double c = std::cos(m.sweep / 2), s = std::sin(m.sweep / 2);
  const Vec3 n = m.axis;
  const Vec3 x{n.y * r.z - n.z * r.y, n.z * r.x - n.x * r.z, n.x * r.y - n.y * r.x};
  expect_near({m.center.x + c * r.x + s * x.x + n.x * m.rise / 2,
               m.center.y + c * r.y + s * x.y + n.y * m.rise / 2,
               m.center.z + c * r.z + s * x.z + n.z * m.rise / 2},
              at(a, 0.5), 1e-6 * (1 + a.radius));
}

void expect_all_forms(const Arc& a) {
  const bool half = std::abs(std::abs(a.sweep) - 180) < 1.5;
  const bool short_arc = std::abs(a.sweep) < 180;
  for (const Dialect d : {Dialect::sinumerik, Dialect::iso, Dialect::fanuc, Dialect::codesys}) {
    expect_arc(by_offset(a), a, d);
    expect_arc(by_offset_incremental(a), a, d);
    if (half) continue;
    if (d == Dialect::sinumerik) expect_arc(by_radius(a, "CR="), a, d);
    if (d == Dialect::iso || d == Dialect::fanuc || (d == Dialect::codesys && short_arc))
      expect_arc(by_radius(a, "R"), a, d);
  }
  expect_arc(by_absolute(a), a, Dialect::sinumerik);
  expect_arc(by_words_of_both_kinds(a), a, Dialect::sinumerik);
  expect_arc(by_angle_and_end(a), a, Dialect::sinumerik);
  expect_arc(by_angle_and_centre(a), a, Dialect::sinumerik);
  expect_arc(by_polar(a), a, Dialect::sinumerik);
  if (a.rise == 0) expect_arc(by_point(a), a, Dialect::sinumerik);
  expect_arc(by_t(a), a, Dialect::codesys);
  expect_arc(by_g98(a), a, Dialect::codesys);
}

// L is the number of turns on some controls: one turn would be another part.
TEST(ArcForms, LBesideAnArcIsNamed) {
  for (const Dialect dialect : {Dialect::fanuc, Dialect::iso})
    EXPECT_EQ(path_text(read_text("G1 X20 F100\nG3 I-20 Z-2 L5\n", at_origin(dialect))),
              "l20,0,0 | not-supported");
}

TEST(ArcForms, AllFormsGiveOneArcInEveryPlaneAndDirection) {
  for (int plane = 0; plane < 3; ++plane)
    for (const double sweep :
         {60.0, -60.0, 90.0, -90.0, 135.0, -135.0, 242.0, -242.0, 300.0, -300.0})
      for (const double rise : {0.0, -3.0})
        expect_all_forms({plane, 12, -7, 20, 25, sweep, 4, rise});
}

TEST(ArcForms, RandomArcsAgreeInAllForms) {
  std::mt19937_64 random(testing::salted(7));
  const auto uniform = [&](double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random);
  };
  for (int i = 0; i < 20; ++i) {
    Arc a{static_cast<int>(random() % 3),
          uniform(-50, 50),
          uniform(-50, 50),
          uniform(2, 80),
          uniform(-180, 180),
          uniform(15, 345),
          uniform(-5, 5),
          0};
    if (random() % 2) a.sweep = -a.sweep;
    if (random() % 2) a.rise = uniform(-5, 5);
    expect_all_forms(a);
  }
}

TEST(ArcForms, ReversedArcIsTheSameCircle) {
  std::mt19937_64 random(testing::salted(8));
  std::uniform_real_distribution<double> angle(20, 340);
  for (int i = 0; i < 15; ++i) {
    const Arc there{i % 3, 3, 4, 15, angle(random), angle(random), 0, 0};
    Arc back = there;
    back.from = there.from + there.sweep;
    back.sweep = -there.sweep;
    expect_arc(by_offset(there), there, Dialect::iso);
    expect_arc(by_offset(back), back, Dialect::iso);
  }
}

TEST(ArcForms, AnArcWithoutAnEndPointIsAFullCircle) {
  for (const Dialect d : {Dialect::sinumerik, Dialect::iso, Dialect::fanuc, Dialect::codesys})
    for (const char* word : {"G2 I10", "G3 I10 J0", "g2 i10 j0", "G3 X0 Y0 I10"}) {
      SCOPED_TRACE(word);
      const Program p = read_text(std::string("F100 G17\n") + word + "\n", at_origin(d));
      ASSERT_EQ(p.motions.size(), 1U) << listing(p);
      EXPECT_NEAR(degrees(p.motions[0].sweep), word[1] == '2' ? -360 : 360, 1e-12);
      expect_near(p.motions[0].center, {10, 0, 0}, 0);
      expect_near(p.motions[0].end, {0, 0, 0}, 0);
    }
}

TEST(ArcForms, HalfACircleMayBeGivenByRadius) {
  const Program s = read_text("G17 G2 X20 CR=10 F100\n", at_origin(Dialect::sinumerik));
  ASSERT_EQ(s.motions.size(), 1U);
  EXPECT_EQ(codes(s), "");
  EXPECT_NEAR(degrees(s.motions[0].sweep), -180, 1e-9);
  const Program minus = read_text("G17 G2 X20 CR=-10 F100\n", at_origin(Dialect::sinumerik));
  ASSERT_EQ(minus.motions.size(), 1U);
  const Program c = read_text("G2 X20 R10 F100\n", at_origin(Dialect::codesys));
  EXPECT_EQ(codes(c), "");
  const Program f = read_text("G2 X20 R10 F100\n", at_origin(Dialect::fanuc));
  EXPECT_EQ(codes(f), "arc-near-180");
  EXPECT_EQ(codes(read_text("G2 X20 R10 F100\nX0 R10\n", at_origin(Dialect::fanuc))),
            "arc-near-180")
      << "once";
}

TEST(ArcForms, TurnAddsFullCircles) {
  const Program p =
      read_text("G17 G0 X10 F100\nG3 X0 Y10 Z-6 I-10 TURN=2\n", at_origin(Dialect::sinumerik));
  ASSERT_EQ(p.motions.size(), 2U) << listing(p);
  EXPECT_NEAR(degrees(p.motions[1].sweep), 90 + 720, 1e-9);
  EXPECT_NEAR(p.motions[1].rise, -6, 1e-12);
}

TEST(ArcForms, PolarArcsAreThoseOfTheManual) {
  const Program p = read_text("G17 G0 X30 Y40 F100\nG111 X40 Y33\nG2 RP=12.207 AP=21\n",
                              at_origin(Dialect::sinumerik));
  ASSERT_EQ(codes(p), "") << listing(p);
  const Motion& m = p.motions.back();
  EXPECT_NEAR(m.end.x, 40 + 12.207 * std::cos(21 * kPi / 180), 1e-9);
  EXPECT_NEAR(m.end.y, 33 + 12.207 * std::sin(21 * kPi / 180), 1e-9);
  EXPECT_NEAR(m.center.x, 40, 1e-3);
  EXPECT_LT(m.sweep, 0);
}

TEST(ArcForms, AnArcThroughAPointLiesInAnyPlane) {
  // A circle about (1,2,3) in a plane that is square to (1,1,1).
  const double k = 1 / std::sqrt(2.0), l = 1 / std::sqrt(6.0);
  const auto point = [&](double a) {
    const double c = 9 * std::cos(a), s = 9 * std::sin(a);
    return Vec3{1 + c * k + s * l, 2 - c * k + s * l, 3 - 2 * s * l};
  };
  const Vec3 s = point(0.3), v = point(1.1), e = point(2.9);
  const Program p =
      read_text(fmt::format("G0 X{:.12f} Y{:.12f} Z{:.12f} F100\nCIP X{:.12f} Y{:.12f} "
                            "Z{:.12f} I1={:.12f} J1={:.12f} K1={:.12f}\n",
                            s.x, s.y, s.z, e.x, e.y, e.z, v.x, v.y, v.z),
                at_origin(Dialect::sinumerik));
  ASSERT_EQ(codes(p), "");
  const Motion& m = p.motions.back();
  expect_near(m.center, {1, 2, 3}, 1e-8);
  EXPECT_NEAR(m.radius, 9, 1e-8);
  EXPECT_NEAR(m.sweep, 2.6, 1e-8);
  expect_near(m.axis, {1 / std::sqrt(3.0), 1 / std::sqrt(3.0), 1 / std::sqrt(3.0)}, 1e-9);
}

TEST(ArcForms, CtIsTangentToTheElementBefore) {
  const Program p =
      read_text("G1 X10 F100\nCT X20 Y10\nCT X10 Y20\n", at_origin(Dialect::sinumerik));
  ASSERT_EQ(codes(p), "") << listing(p);
  ASSERT_EQ(p.motions.size(), 3U);
  expect_near(p.motions[1].center, {10, 10, 0});
  EXPECT_NEAR(degrees(p.motions[1].sweep), 90, 1e-9);
  expect_near(p.motions[2].center, {10, 10, 0});
  const Program line = read_text("G1 X10 F100\nCT X20\n", at_origin(Dialect::sinumerik));
  EXPECT_EQ(line.motions.back().kind, MotionKind::line);
}

TEST(ArcForms, CodesysRadiusWithoutEndIsACircle) {
  const Program p = read_text("G2 R5 F100\n", at_origin(Dialect::codesys));
  ASSERT_EQ(p.motions.size(), 1U) << listing(p);
  expect_near(p.motions[0].center, {5, 0, 0});
  EXPECT_NEAR(degrees(p.motions[0].sweep), -360, 1e-9);
  const Program t = read_text("G2 I50 J0 T720 Z-10 F100\n", at_origin(Dialect::codesys));
  ASSERT_EQ(t.motions.size(), 1U);
  EXPECT_NEAR(degrees(t.motions[0].sweep), -720, 1e-9);
  EXPECT_NEAR(t.motions[0].rise, -10, 1e-12);
}

TEST(ArcForms, CodesysGivesAPlaneByItsNormal) {
  const Program p =
      read_text("G1 X100 F100\nG16 I0 J-1 K0\nG2 X0 I-50 K0\n", at_origin(Dialect::codesys));
  ASSERT_EQ(codes(p), "") << listing(p);
  const Motion& m = p.motions.back();
  ASSERT_EQ(m.kind, MotionKind::arc);
  expect_near(m.axis, {0, 1, 0});
  expect_near(m.center, {50, 0, 0});
  EXPECT_NEAR(degrees(m.sweep), 180, 1e-9);  // clockwise about -Y
}

TEST(ArcForms, OfFanucsRadiusAndCentreTheRadiusCounts) {
  const Program none = read_text("G17 G2 R5 F100\nG1 X1\n", at_origin(Dialect::fanuc));
  EXPECT_EQ(none.motions.size(), 1U);
  EXPECT_EQ(codes(none), "");
  const Program both = read_text("G2 X10 Y10 R10 I99 J99 F100\n", at_origin(Dialect::fanuc));
  ASSERT_EQ(both.motions.size(), 1U);
  EXPECT_NEAR(both.motions[0].radius, 10, 1e-12);
  EXPECT_EQ(codes(both), "");
}

TEST(ArcForms, FanucReadsPolarCoordinates) {
  const Program p = read_text("G17 G90 G16 G1 X10 Y30 F100\nG3 Y120 R10\nG15\nG1 X0 Y0\n",
                              at_origin(Dialect::fanuc));
  ASSERT_EQ(codes(p), "") << listing(p);
  expect_near(p.motions[0].end, {10 * std::cos(kPi / 6), 5, 0});
  expect_near(p.motions[1].end, {-5, 10 * std::cos(kPi / 6), 0});
  expect_near(p.motions[1].center, {0, 0, 0}, 1e-6);
  // G91: an angle adds to the last angle about the zero point, a radius counts from the position.
  const Program inc = read_text("G16 G1 X10 Y0 F1\nG91 Y90\nY45 X5\n", at_origin(Dialect::fanuc));
  expect_near(inc.motions[1].end, {0, 10, 0});
  expect_near(inc.motions[2].end, {-5 / std::sqrt(2.0), 10 + 5 / std::sqrt(2.0), 0});
}

TEST(ArcForms, FanucPolarCoordinatesBeginAnewWithG16) {
  const auto run = [](const std::string& text) {
    return path_text(read_text("G17 G90 F100\n" + text, at_origin(Dialect::fanuc)));
  };
  EXPECT_EQ(run("G16 G1 X10 Y0\nG15\nX20 Y0\nG16 Y90\n"), "l10,0,0 l20,0,0 l0,20,0");
  EXPECT_EQ(run("G1 X3 Y4\nG16 Y90\nG1 X9\nG15\nX0 Y0\nG16 X2\n"),
            "l3,4,0 l0,5,0 l0,9,0 l0,0,0 l2,0,0 | polar-pole")
      << "another radius than X3";
  EXPECT_EQ(run("G1 X0 Y4\nG16 X5\nG1 Y0\n"), "l0,4,0 l0,5,0 l5,0,0 | polar-pole");
  EXPECT_EQ(run("G1 X10 Y10\nG16\nG91 X10 Y90\nX5 Y90\n"), "l10,10,0 l10,20,0 l5,20,0");
  EXPECT_EQ(run("G1 X10 Y10\nG91 G16\nG90 X20 Y90\n"), "l10,10,0 l0,20,0 | polar-pole");
  EXPECT_EQ(run("G1 X10 Y0\nG91 G16 Y90\n"), "l10,0,0 l0,10,0 | polar-pole");
  EXPECT_EQ(run("G1 X10 Y0\nG16 G91 Y90\n"), "l10,0,0 l0,10,0 | polar-pole");
  EXPECT_EQ(run("G1 X10 Y0\nG91\nG16 G90 Y90\n"), "l10,0,0 l0,10,0");
  EXPECT_EQ(run("G16 G1 X10 Y0\nG91 Y90\nG16 Y90\n"), "l10,0,0 l0,10,0 l-10,0,0");
}

// The chord is the diameter but for rounding: the centre lies on it.
TEST(ArcForms, HalfCirclesByRadiusAreExact) {
  const Program p = read_text("G70 G0 X3 Y0\nG3 X1 CR=1 F1\n", at_origin(Dialect::sinumerik));
  ASSERT_EQ(p.motions.size(), 2U) << listing(p);
  EXPECT_EQ(p.motions[1].center.y, 0);
  EXPECT_NEAR(degrees(p.motions[1].sweep), 180, 1e-12);
}

// Centres as places, without G90.1: the tool comes from the place that I and J name.
TEST(ArcForms, CirclesAboutThePlaceTheToolComesFromAreInDoubt) {
  const auto told = [](const std::string& text, Dialect dialect) {
    return codes(read_text("G1 F100 X20 Y10\n" + text, at_origin(dialect)));
  };
  const std::string place = "G1 Z-1\nG1 X22.5\nG2 I20 J10\n";
  for (const Dialect d : {Dialect::fanuc, Dialect::iso, Dialect::ngc})
    EXPECT_EQ(told(place, d), "arc-center-place") << static_cast<int>(d);
  const std::string level = "G0 X85.8381 Y47.6087\nG1 Z-1\nG3 X85.8381 Y47.6087 I49.2642 J";
  EXPECT_EQ(told(level + "47.6087\n", Dialect::iso), "arc-center-place") << "level with the tool";
  EXPECT_EQ(told(level + "0\n", Dialect::iso), "");
  EXPECT_EQ(told("G0 X5 Y10\nG2 I0 J10\n", Dialect::iso), "") << "a round number";
  EXPECT_EQ(told("G1 X22.5\nG2 I-2.5 J0\n", Dialect::fanuc), "");
  EXPECT_EQ(told("G1 X0 Y0\nG2 I20 J10\n", Dialect::fanuc), "") << "about where it came from";
  EXPECT_EQ(told("G1 X-20 Y-10\nG2 I20 J10\n", Dialect::fanuc), "") << "across the circle";
  EXPECT_EQ(told("G91.1\n" + place, Dialect::ngc), "") << "said";
  EXPECT_EQ(told("G0 Z5\nX22.5\nG1 Z-1\nG2 I20 J10\n", Dialect::ngc), "") << "over the part";
  EXPECT_EQ(told("G3 X0 Y-10 I-20 J0\nG1 X20 Y10\n" + place, Dialect::iso), "")
      << "an arc whose ends do not fit the place";
  EXPECT_EQ(told("G2 I20 J10\n" + place, Dialect::iso), "") << "once the place of the tool itself";
  EXPECT_EQ(told("G90.1\n" + place, Dialect::ngc), "");
}

}  // namespace
}  // namespace mrsim
