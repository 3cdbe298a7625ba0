// Frames, units, diameters, increments: where a point lands, worked out by hand.
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

struct Row {
  Dialect dialect;
  const char* text;
  Vec3 end;  // of the last motion
};

void expect_end(const Row& row, const InterpOptions& options) {
  SCOPED_TRACE(row.text);
  const Program p = read_text(std::string(row.text) + "\n", options);
  ASSERT_EQ(codes(p, Severity::error), "") << listing(p);
  ASSERT_FALSE(p.motions.empty());
  expect_near(p.motions.back().end, row.end);
}

TEST(Frames, FramesMovePoints) {
  constexpr auto s = Dialect::sinumerik, f = Dialect::fanuc, i = Dialect::iso, c = Dialect::codesys;
  const Row rows[] = {
      {s, "TRANS X10 Y20\nG1 X1 Y2 Z3 F1", {11, 22, 3}},
      {s, "TRANS X10\nTRANS Y5\nG1 X1 Y1 F1", {1, 6, 0}},
      {s, "TRANS X10\nATRANS Y5\nG1 X1 Y1 F1", {11, 6, 0}},
      {s, "TRANS X10\nTRANS\nG1 X1 Y1 F1", {1, 1, 0}},
      {s, "TRANS X10\nAROT Z90\nG1 X5 Y1 F1", {9, 5, 0}},
      {s, "ROT Z90\nATRANS X10\nG1 X5 Y1 F1", {-1, 15, 0}},
      {s, "ROT RPL=90\nG1 X5 Y1 F1", {-1, 5, 0}},
      {s, "G18\nROT RPL=90\nG1 X5 Z1 F1", {1, 0, -5}},  // +Y: Z towards X, X towards -Z
      {s, "ROT X90\nG1 X1 Y2 Z3 F1", {1, -3, 2}},
      {s, "SCALE X2 Y3\nG1 X5 Y1 F1", {10, 3, 0}},
      {s, "TRANS X1\nASCALE X2\nG1 X5 F1", {11, 0, 0}},
      {s, "MIRROR X0\nG1 X5 Y1 F1", {-5, 1, 0}},
      {s, "MIRROR X0\nAMIRROR X0\nG1 X5 Y1 F1", {5, 1, 0}},
      {s, "TRANS X10\nMIRROR Y0\nG1 X5 Y1 F1", {5, -1, 0}},
      {s, "G54\nG1 X1 F1", {101, 0, 0}},
      {s, "G505\nG1 X1 Y0 F1", {1, 50, 0}},
      {s, "G54\nG500\nG1 X1 F1", {1, 0, 0}},
      {s, "G54\nG1 SUPA X1 F1\nX1", {101, 0, 0}},
      {s, "G58 X10\nG59 X1\nG1 X1 F1", {12, 0, 0}},
      // The example of SINUMERIK's manual: X25 Y15 Z10 behind G58, X30 Y20 Z10 behind G59.
      {s, "TRANS X10 Y10 Z10\nATRANS X5 Y5\nG58 X20\nG1 X0 Y0 Z0 F1", {25, 15, 10}},
      {s, "TRANS X10 Y10 Z10\nATRANS X5 Y5\nG58 X20\nG59 X10 Y10\nG1 X0 Y0 Z0 F1", {30, 20, 10}},
      {s, "G59 X5\nTRANS X10\nG58 X20\nG1 X0 F1", {20, 0, 0}},
      {s, "G59 X5\n$P_PFRAME=CTRANS(X,10)\nG58 X20\nG1 X0 F1", {20, 0, 0}},
      {s, "AROT Z90\nATRANS X5\nG59 Y1\nG1 X0 Y0 F1", {0, 1, 0}},
      {s, "G1 X10 F1\nTRANS X100\nG91 X5", {115, 0, 0}},
      {s, "G1 X10 F1\nTRANS X100\nG1 Y5", {10, 5, 0}},
      {s, "G91 G1 X10 F1\nX=AC(3)\nG90 X=IC(4)", {7, 0, 0}},
      {s, "G70 G1 X1 F1", {25.4, 0, 0}},
      {s, "G700 G1 X1 F1", {25.4, 0, 0}},
      {s, "G1 X1EX2 Y='H1F' F1", {100, 31, 0}},
      {s, "G111 X10 Y10\nG1 AP=90 RP=5 F1", {10, 15, 0}},
      {s, "G1 X3 Y4 F1\nG110 X1\nG1 AP=0 RP=5", {9, 4, 0}},
      {s, "G111 X10\nG112 Y5\nG1 AP=180 RP=2 F1\nAP=IC(90)", {10, 3, 0}},
      {s, "G111 X10\nG1 AP=0 RP=5 F1\nRP=IC(3)", {18, 0, 0}},
      {s, "G111 X10\nG1 AP=0 RP=5 F1\nRP=IC(-3)\nG91 RP=IC(1) AP=IC(90)", {10, 3, 0}},
      {s, "G1 X9 F1\nG111 X2\nG91 G1 AP=AC(90) RP=IC(1)\nRP=6", {2, 6, 0}},
      {s, "G1 X10 Y10 F1\nANG=60 X20", {20, 27.320508075688775, 0}},
      {f, "G20 G1 X1 F1", {25.4, 0, 0}},
      {f, "G54.1 P3 G1 X1 F1", {301, 0, 0}},
      {f, "G52 X5\nG1 X1 F1", {6, 0, 0}},
      {f, "G52 X5\nG52 X0\nG1 X1 F1", {1, 0, 0}},
      {f, "G1 X10 F1\nG92 X0\nG1 X1", {11, 0, 0}},
      {f, "G68 X10 Y0 R90\nG1 X15 Y0 F1", {10, 5, 0}},
      {f, "G68 X10 Y0 R90\nG69\nG1 X15 Y0 F1", {15, 0, 0}},
      {f, "G68.2 X0 Y0 Z0 I0 J0 K0\nG53.1\nG1 X5 Y1 F1", {5, 1, 0}},
      {f, "G68.2 X10. Y20. Z-3. I30. J0 K60.\nG53.1\nG1 X5 Y1 Z1 F1", {9, 25, -2}},
      {f, "G1 X7 Y7 F1\nG68.2 Z2. J0\nG1 X5 Y1 Z0 F1", {5, 1, 2}},
      {i, "G68.2 X10. Y20. J0 K90.\nG53.1\nG1 X5 Y1 F1", {9, 25, 0}},
      {f, "G54.4 P0\nG1 X5 Y1 F1", {5, 1, 0}},
      {f, "G68.2 X10. I90. J0 K0\nG69\nG1 X15 Y0 Z0 F1", {15, 0, 0}},
      {f, "G68.2 P1 X10. I0 J0 K90.\nG53.1\nG1 X5 Y1 F1", {9, 5, 0}},
      {f, "G51 X0 Y0 Z0 P2000\nG1 X5 Y1 F1", {10, 2, 0}},
      {f, "G51 X0 Y0 Z0 I2. J3. K1.\nG1 X5 Y1 F1", {10, 3, 0}},
      {f, "G51.1 X10\nG1 X5 Y1 F1", {15, 1, 0}},
      {f, "G51.1 X10\nG50.1 X0\nG1 X5 Y1 F1", {5, 1, 0}},
      {f, "G51 X0 Y0 P2.\nG68 X10 Y0 R90\nG1 X15 Y0 F1", {20, 10, 0}},
      {f, "G51 X0 Y0 I2. J3.\nG68 X10 Y1 R90\nG1 X15 Y0 F1", {23, 13, 0}},
      {f, "G68 X10 Y0 R90\nG51 X20 Y0 P2.\nG1 X25 Y0 F1", {10, 20, 0}},
      {f, "G51.1 X0\nG68 X0 Y0 R90\nG1 X10 Y0 F1", {0, 10, 0}},
      {f, "G51.1 X20\nG68 X10 Y0 R90\nG1 X15 Y0 F1", {30, 5, 0}},
      {f, "G51.1 X0 Y0\nG68 X10 Y0 R90\nG1 X15 Y0 F1", {-10, -5, 0}},
      {f, "G51.1 X0\nG51 X10 Y0 P2.\nG1 X15 Y0 F1", {-20, 0, 0}},
      {f, "G51 X0 Y0 I-1. J1.\nG68 X0 Y0 R90\nG1 X10 Y0 F1", {0, 10, 0}},
      {f, "G43 H1 G1 Z5 F1", {0, 0, 17}},
      {f, "G44 H1 G1 Z5 F1", {0, 0, -7}},
      {f, "G1 X10 F1\nG55\nG91 X5", {15, 0, 0}},
      {i, "G70 G1 X1 F1", {25.4, 0, 0}},
      {i, "g91 g1 x1 f1\nx2", {3, 0, 0}},
      {c, "G54 X10 Y5\nG1 X1 Y1 F1", {11, 6, 0}},
      {c, "G54 X10\nG55 X5\nG1 X1 F1", {16, 0, 0}},
      {c, "G54 X10\nG53\nG1 X1 F1", {1, 0, 0}},
      {c, "G92 X10\nG1 Y5 F1", {10, 5, 0}},
      {c, "G71 L4\nG1 X1 F1", {1, 0, 0}},
  };
  for (const Row& row : rows) {
    InterpOptions options = at_origin(row.dialect);
    options.table.work = {{"G54", {100, 0, 0}}, {"G505", {0, 50, 0}}, {"G54.1 P3", {300, 0, 0}}};
    if (row.dialect != Dialect::sinumerik) options.table.work[0].shift = {};
    options.table.offsets.push_back({"H1", 0, 0, 12});
    expect_end(row, options);
  }
}

// G92 of FANUC and Haas ends G52 for its axes, G92.1 both, for the axes beside it.
TEST(Frames, G92EndsG52AndG921ResetsItsAxes) {
  const auto run = [](const std::string& text) {
    return path_text(read_text("G90 G0 X10 Y10 Z0\n" + text, at_origin(Dialect::fanuc)));
  };
  EXPECT_EQ(run("G52 X4 Y2\nG92 X0\nG52 X0 Y0\nG1 X1 Y1 F9\n"), "r10,10,0 l11,1,0");
  EXPECT_EQ(run("G52 X4 Y2\nG92 X0\nG1 X1 Y1 F9\n"), "r10,10,0 l11,3,0");
  EXPECT_EQ(run("G92 X0 Y0\nG92.1 X0\nG1 X1 Y1 F9\n"), "r10,10,0 l1,11,0");
  EXPECT_EQ(run("G92 X0 Y0\nG52 Y3\nG92.1 Y0\nG1 X1 Y1 F9\n"), "r10,10,0 l11,1,0");
  EXPECT_EQ(run("G92 X0 Y0\nG52 Y3\nG92.1\nG1 X1 Y1 F9\n"), "r10,10,0 l1,1,0");
}

// G52 in force before G68 is one thing, between G68 and G69 the manuals forbid it.
TEST(Frames, AShiftWithinARotationIsSaid) {
  const auto run = [](const char* text) {
    return path_text(read_text(text, at_origin(Dialect::fanuc)));
  };
  EXPECT_EQ(run("G52 X20 Y0\nG68 X0 Y0 R90\nG1 X5 Y0 F1\nG52 X20\nG69\nG52 X0\n"), "l20,5,0");
  EXPECT_EQ(run("G68 X0 Y0 R90\nG52 X20 Y0\nG1 X5 Y0 F1\n"), "l20,5,0 | rotation-shift");
}

TEST(Frames, XOfALatheIsADiameterOrARadius) {
  constexpr auto s = Dialect::sinumerik, f = Dialect::fanuc;
  const Row rows[] = {
      {s, "G1 X20 Z-5 F.1", {10, 0, -5}},
      {s, "G1 X20 F.1\nG91 X4", {12, 0, 0}},
      {s, "DIAM90\nG1 X20 F.1\nG91 X4", {14, 0, 0}},
      {s, "DIAMOF\nG1 X20 F.1", {20, 0, 0}},
      {s, "G1 X=RAC(20) F.1\nX=DIC(4)\nX=RIC(3)", {25, 0, 0}},
      {s, "DIAMOF\nG1 X=DAC(20) F.1", {10, 0, 0}},
      {s, "TRANS Z50\nG1 X20 Z-5 F.1", {10, 0, 45}},
      {f, "G1 X20 Z-5 F.1\nU4 W-2", {12, 0, -7}},
      {f, "T0101 G1 X20 F.1", {10, 0, 0}},
  };
  for (const Row& row : rows) expect_end(row, at_origin(row.dialect, MachineKind::lathe));
}

TEST(Frames, CentresOfALatheAreRadiiUnlessAbsolute) {
  // Quarter circle about X40 (radius 20), Z0: I is a radius, absolute I a diameter.
  for (const char* text :
       {"G1 X20 Z0 F.1\nG3 X40 Z-10 I10 K0", "G1 X20 Z0 F.1\nG3 X40 Z-10 I=AC(40) K=AC(0)",
        "G1 X20 Z0 F.1\nG3 X40 Z-10 CR=10"}) {
    SCOPED_TRACE(text);
    const Program p =
        read_text(std::string(text) + "\n", at_origin(Dialect::sinumerik, MachineKind::lathe));
    ASSERT_EQ(codes(p), "") << listing(p);
    const bool radius = std::string(text).find("CR") != std::string::npos;
    expect_near(p.motions.back().center, radius ? Vec3{10, 0, -10} : Vec3{20, 0, 0});
  }
  // The turning manual prints one arc both ways: X absolute as a diameter, increments as radii.
  for (const char* text : {"G0 X40 Z-25\nCIP X70 Z-75 I1=93.33 K1=-54.25 F.1",
                           "G0 X40 Z-25\nCIP X70 Z-75 I1=IC(26.665) K1=IC(-29.25) F.1"}) {
    const Program p =
        read_text(std::string(text) + "\n", at_origin(Dialect::sinumerik, MachineKind::lathe));
    ASSERT_EQ(codes(p), "") << listing(p);
    expect_near(p.motions.back().center, {19.230288569, 0, -52.480913429}, 1e-8);
  }
}

TEST(Frames, MirrorTurnsArcsByGeometry) {
  const Program m = read_text("MIRROR X0\nG3 X10 Y10 I0 J10 F1\n", at_origin(Dialect::sinumerik));
  ASSERT_EQ(m.motions.size(), 1U) << listing(m);
  EXPECT_NEAR(degrees(m.motions[0].sweep), -90, 1e-9);
  expect_near(m.motions[0].end, {-10, 10, 0});
  expect_near(m.motions[0].axis, {0, 0, 1});
  const Program twice =
      read_text("MIRROR X0 Y0\nG3 X10 Y10 I0 J10 F1\n", at_origin(Dialect::sinumerik));
  EXPECT_NEAR(degrees(twice.motions[0].sweep), 90, 1e-9);
  // Compensation changes sides with it: left of the mirrored path is right of the drawn one.
  const Program comp =
      read_text("MIRROR X0\nG41 G1 X20 F1\nX40\nX60\n", at_origin(Dialect::sinumerik));
  expect_near(comp.motions[1].end, {-60, 5, 0}, 60);
  EXPECT_GT(comp.motions[1].end.y, 0);
}

TEST(Frames, UnequalScaleOfAnArcIsAnError) {
  EXPECT_EQ(codes(read_text("SCALE X2\nF1\nG2 X10 CR=5\nG1 X1\n", at_origin(Dialect::sinumerik))),
            "arc-scaled-unequally");
  EXPECT_EQ(codes(read_text("SCALE Z2\nG2 X10 Z1 CR=5 F1\nG1 X1\n", at_origin(Dialect::sinumerik))),
            "");
}

TEST(Frames, MotionsFromAnUnknownPlaceAreMarked) {
  InterpOptions options = at_origin(Dialect::iso);
  options.start.reset();
  const Program p = read_text("G1 X10 Y0 F1\nZ5\nX20\n", options);
  ASSERT_EQ(p.motions.size(), 3U);
  EXPECT_TRUE(p.motions[0].assumed_start);
  EXPECT_TRUE(p.motions[1].assumed_start);
  EXPECT_FALSE(p.motions[2].assumed_start);
  EXPECT_NE(motion_json(p, p.motions[0]).find("\"start\":[0,0,0]"), std::string::npos);
  const Program home = read_text("G1 X1 Y1 Z1 F1\nG28 Z2\nX5\nZ3\nX6\n", options);
  ASSERT_EQ(home.motions.size(), 5U) << listing(home);
  EXPECT_TRUE(home.motions[2].assumed_start);
  EXPECT_FALSE(home.motions[4].assumed_start);
}

// Where machine coordinates lead is unknown: no motion, and the axis is unknown until given again.
TEST(Frames, BehindMachineCoordinatesTheAxisIsUnknown) {
  const std::pair<Dialect, const char*> rows[] = {{Dialect::sinumerik, "G0 SUPA Z100"},
                                                  {Dialect::sinumerik, "G53 G0 Z100 D0"},
                                                  {Dialect::sinumerik, "G75 Z1=0"},
                                                  {Dialect::fanuc, "G0 G53 Z0"},
                                                  {Dialect::fanuc, "G91 G28 Z0"},
                                                  {Dialect::fanuc, "G91 G30 Z0"},
                                                  {Dialect::iso, "G53 Z0"},
                                                  {Dialect::ngc, "G53 G0 Z0"}};
  for (const auto& [dialect, text] : rows) {
    SCOPED_TRACE(text);
    const Program p = read_text(std::string("G1 X1 Y1 Z1 F1\n") + text + "\nG90 G0 X5\nZ3\nG1 X6\n",
                                at_origin(dialect));
    EXPECT_EQ(codes(p), "");
    ASSERT_EQ(p.motions.size(), 4U) << listing(p);
    EXPECT_TRUE(p.motions[1].assumed_start);
    EXPECT_TRUE(p.motions[2].assumed_start);
    EXPECT_FALSE(p.motions[3].assumed_start);
  }
}

TEST(Frames, AWayToTheMachineOutOfACutIsAWarning) {
  const auto told = [](const std::string& leaving, Dialect dialect = Dialect::fanuc) {
    return codes(
        read_text("G0 X0 Y0 Z5\nG1 Z-1 F1\nX5\n" + leaving + "\nM30\n", at_origin(dialect)));
  };
  EXPECT_EQ(told("G28 G91 X0 Y0\nG28 Z0"), "leaves-in-cut");
  EXPECT_EQ(told("G53 G0 X0"), "leaves-in-cut");
  EXPECT_EQ(told("SUPA G0 X0", Dialect::sinumerik), "leaves-in-cut");
  EXPECT_EQ(told("G91 G28 Z0\nG28 X0 Y0"), "");
  EXPECT_EQ(told("G0 Z5\nG91 G28 X0 Y0 Z0"), "");
  EXPECT_EQ(told("G91 G28 X0 Y0 Z9."), "") << "over a place above";
  EXPECT_EQ(told("G91 G28 X0 Y0 Z0"), "") << "Z goes up at once";
}

// --least-increments: X1000 was 1 mm, and in G52 and G68 1000 mm; R90000 no angle at all.
TEST(Frames, WordsOfFramesCountLeastIncrements) {
  InterpOptions options = at_origin(Dialect::fanuc);
  options.least_increments = true;
  const auto path = [&](const std::string& text) {
    return path_text(read_text(text + "\nM30\n", options));
  };
  EXPECT_EQ(path("G52 X5000\nG1 X1000 F9"), "l6,0,0");
  EXPECT_EQ(path("G68 X1000 Y0 R90.\nG1 X2000 Y0 F9"), "l1,1,0");
  EXPECT_EQ(path("G68 X0 Y0 R90000\nG1 X2000 Y0 F9"), "l0,2,0");
  EXPECT_EQ(path("G68.2 X1000 Y0 Z0 I30000 J0 K60.\nG53.1\nG1 X2000 Y0 F9"), "l1,2,0");
  EXPECT_EQ(path("G51 X1000 Y0 Z0 P2.\nG1 X2000 F9"), "l3,0,0");
  EXPECT_EQ(path("G51.1 X1000\nG1 X3000 F9"), "l-1,0,0");
  EXPECT_EQ(path("G11 X1000 P90000\nG1 X2000 Y0 F9"), "l1,2,0") << "Okuma";
  EXPECT_EQ(path("G16 G1 X10000 Y90000 F9"), "l0,10,0");
  EXPECT_EQ(path("G1 X10000 ,A45000 F9"), "l10,10,0");
}

// What was meant by no P was taken for P0: the external offset, or nothing.
TEST(Frames, G10NeedsTheNumberOfWhatItSets) {
  for (const char* const text : {"G10 L2 X10.", "G10 L20 X10.", "G10 L12 R3.", "G10 L10 R3."})
    EXPECT_EQ(
        codes(read_text(fmt::format("{}\nG54 G1 X1. F9\nM30\n", text), at_origin(Dialect::fanuc))),
        "value-missing")
        << text;
  EXPECT_EQ(codes(read_text("G10 L2 X10\nG1 X1 F9\nM2\n", at_origin(Dialect::ngc))),
            "value-missing");
}

// The manual's own example ends with G69 G90 X-5. Y-5.: G69 and G50 leave the axes to the move.
TEST(Frames, RotationAndScaleEndBesideOtherWords) {
  const auto path = [](const std::string& text) {
    return path_text(read_text(text, at_origin(Dialect::fanuc)));
  };
  const std::string turned = "G68 X0 Y0 R90.\nG1 X5. Y0 F9\n";
  EXPECT_EQ(path(turned + "G69 X1. Y2.\n"), "l0,5,0 l1,2,0");
  EXPECT_EQ(path(turned + "G69 G0 X1. Y2.\n"), "l0,5,0 r1,2,0");
  EXPECT_EQ(path(turned + "G91 G69 Z1.\n"), "l0,5,0 l0,5,1");
  EXPECT_EQ(path(turned + "G69 G92 X0 Y0\nX1. Y1.\n"), "l0,5,0 l1,6,0");
  EXPECT_EQ(path("G51 X0 Y0 P2.\n" + turned + "G69 G50\nX1. Y1.\n"), "l0,10,0 l1,1,0");
  EXPECT_EQ(path("G51 X0 Y0 P2.\n" + turned + "G50 G69 G90 X1. Y1.\n"), "l0,10,0 l1,1,0");
  EXPECT_EQ(path("G51.1 X0\n" + turned + "G69 G50.1 X0\nX1. Y1.\n"), "l0,5,0 l1,1,0");
  EXPECT_EQ(path("G52 X10.\n" + turned + "G69 G52 X0 Y0\nX1. Y1.\n"), "l10,5,0 l1,1,0");
  EXPECT_EQ(path("G52 X9. Z0 G68 Y0 R90.\nG1 X5. Y0 F9\n"), "l5,0,0 | frame-own-block");
}

// G72.1 P L X Y R turns each run of a subprogram further, G72.2 P L I J K shifts it further.
TEST(Frames, FiguresAreCopied) {
  const auto path = [](const std::string& text) {
    return path_text(read_text(text, at_origin(Dialect::fanuc)));
  };
  const std::string sub = "X30. Y0 F9\nX20.\n", at_p2 = "M30\nO2\nG90 G1 " + sub + "M99\n";
  const std::string begin = "G1 X20. Y0 F9\n", end = "G1 X20. Y0\n";
  const auto turned = [&](int angle) {
    return fmt::format("G68 X5. Y0 R{}.\nG1 {}G69\n", angle, sub);
  };
  EXPECT_EQ(path(begin + "G72.1 P2 L3 X5. Y0 R120.\n" + end + at_p2),
            path(begin + turned(0) + turned(120) + turned(240) + end));
  EXPECT_EQ(path(begin + "G72.1 P2 X5. Y0 R120.\n" + end + at_p2), path(begin + "G1 " + sub + end));
  EXPECT_EQ(path("G91\n" + begin + "G72.1 P2 L2 X5. Y0 R120.\n" + at_p2),
            path(begin + turned(0) + turned(120)))
      << "the centre is absolute";
  const auto shifted = [&](int times) {
    return fmt::format("G52 X{}. Y{}.\nG1 {}G52 X0 Y0\n", 7 * times, times, sub);
  };
  EXPECT_EQ(path(begin + "G72.2 P2 L3 I7. J1.\n" + end + at_p2),
            path(begin + shifted(0) + shifted(1) + shifted(2) + end));
  // A figure in increments goes on where the one before it ends.
  EXPECT_EQ(path(begin + "G72.1 P2 L4 X0 Y0 R90.\nG90 G1 X0\nM30\nO2\nG91 G1 X-20. Y20.\nM99\n"),
            "l20,0,0 l0,20,0 l-20,0,0 l0,-20,0 l20,0,0 l0,0,0");
  EXPECT_EQ(path("G68 X0 Y0 R90.\n" + begin + "G72.1 P2 L2 X5. Y0 R180.\nG69\n" + at_p2),
            path("G68 X0 Y0 R90.\n" + begin + "X30.\nX20.\nX-20.\nX-10.\nG69\n"));
  EXPECT_EQ(path("G72.2 P3 L2 J9.\nM30\nO3\nG72.1 P2 L2 X0 Y0 R180.\nM99\nO2\nG1 X1. Y0 F9\nM99\n"),
            "l1,0,0 l-1,0,0 l1,9,0 l-1,9,0");
  for (const char* wrong : {"G72.1 P2 L3 X5. Y0", "G72.1 P2 L3 X5. R90.", "G72.2 P2 L3"})
    EXPECT_EQ(path(std::string(wrong) + "\n" + at_p2), " | value-missing") << wrong;
  EXPECT_EQ(path("G1 X1. F9\nG72.1 P9 X0 Y0 R9.\nM30\n"), "l1,0,0 | subprogram-missing");
}

}  // namespace
}  // namespace mrsim
