// Programs in the manner of CAM posts: their envelope (safe starts, tool changes, ways home) gives
// no warning, and they move as worked out by hand.
#include "core/vec.h"
#include "interp/support.h"

namespace mrsim {
namespace {

struct Post {
  const char* file;
  Dialect dialect;
  MachineKind machine;
  std::size_t rapids, lines, arcs;  // the rapids with a known start
  Vec3 low, high;                   // of the ends of lines and arcs
  const char* found = "";           // codes of warnings and errors
};

TEST(Posts, RunAsWorkedOut) {
  constexpr auto mill = MachineKind::mill, lathe = MachineKind::lathe;
  const Post posts[] = {
      // A contour at Z-5 with a corner of 10, then two holes in three strokes of 5, 5 and 4 mm:
      // down to R, six strokes' worth of rapids, out; between them one rapid.
      {"fusion_fanuc.nc", Dialect::fanuc, mill, 17, 9, 1, {-10, -30, -12}, {60, 0, -3}},
      {"haas.nc", Dialect::fanuc, mill, 0, 2, 1, {-25.4, 0, -2.54}, {50.8, 0, -2.54}},
      {"mazak_iso.eia", Dialect::fanuc, mill, 1, 1, 1, {0, 0, -1}, {0, 0, -1}},
      // Three holes in strokes of 4, 3, 2 and 1 mm.
      {"sinumerik_cam.mpf", Dialect::sinumerik, mill, 28, 14, 1, {-10, 0, -10}, {40, 30, -3}},
      {"linuxcnc.ngc", Dialect::ngc, mill, 5, 3, 2, {0, -10, -4}, {20, 5, -2}},
      {"grbl_vectric.nc", Dialect::iso, mill, 1, 2, 1, {0, -5, -1.5}, {30, 0, -1.5}},
      {"fanuc_lathe.nc", Dialect::fanuc, lathe, 2, 2, 1, {20, 0, -25}, {25, 0, 2}},
      {"mastercam_mill.nc", Dialect::fanuc, mill, 2, 3, 1, {-20, 0, -2}, {50, 30, -2}},
      // G71 from radius 32 by 2 to 20: five passes of three rapids and a cut, the contour and back;
      // G70: in, three cuts, back; one rapid.
      {"mastercam_lathe.nc", Dialect::fanuc, lathe, 20, 11, 0, {20, 0, -35}, {30, 0, -30}},
      {"solidcam_haas.nc", Dialect::fanuc, mill, 2, 3, 1, {0, -30, -5}, {60, 40, -5}},
      // Two holes, and a tap that begins at R and comes back with its lead.
      {"hsmworks_haas.nc", Dialect::fanuc, mill, 8, 4, 0, {10, 10, -18}, {30, 10, 5}},
      {"vcarve_mach3.txt", Dialect::ngc, mill, 4, 3, 1, {20, 20, -3}, {60, 40, -3}},
      {"carbide_create.nc", Dialect::ngc, mill, 1, 2, 1, {10, 0, -1}, {60, 10, -1}},
      {"freecad_linuxcnc.ngc", Dialect::ngc, mill, 2, 3, 1, {-3, 0, -2}, {30, 23, -2}},
      {"freecad_grbl.gcode", Dialect::ngc, mill, 5, 2, 0, {5, 5, -4}, {15, 5, -4}},
      {"powermill_fanuc.nc", Dialect::fanuc, mill, 3, 3, 0, {0, 0, -1.5}, {20, 0, -1}},
      {"nx_sinumerik.mpf", Dialect::sinumerik, mill, 2, 4, 1, {-10, -20, -4}, {60, 5, 3}},
      // The first hole lies where the tool is: MCALL drills there, too.
      {"fusion_840d.mpf", Dialect::sinumerik, mill, 5, 2, 0, {10, 10, -10}, {30, 10, -10}},
      // Two runs of the subprogram, at Z-2 and Z-4.
      {"edgecam_fanuc.nc", Dialect::fanuc, mill, 1, 11, 2, {-20, -20, -4}, {30, 40, 0}},
      {"gibbscam.nc", Dialect::fanuc, mill, 2, 2, 2, {0, 0, -2}, {5, 0, 0}},
      // Three passes of G92: three rapids and a thread each; G75: two strokes of 2, one back.
      {"esprit_lathe.nc", Dialect::fanuc, lathe, 14, 5, 0, {9.3, 0, -25}, {14, 0, -18}},
      {"shopturn_iso.mpf", Dialect::sinumerik, lathe, 1, 2, 1, {25, 0, -25}, {30, 0, 2}},
      // A contour with a corner of 5 and a chamfer of 2, then two taps of four motions each.
      {"fusion_haas_corners.nc", Dialect::fanuc, mill, 7, 10, 1, {-10, -10, -15}, {30, 40, 5}},
      // A pocket in three depths, each down, in, round and out; four holes round (50, 50).
      {"haas_patterns.nc", Dialect::fanuc, mill, 11, 8, 9, {20, 20, -6}, {80, 80, 0}},
      // #101 is -5, #102 is 50; the loop runs twice, so that GOTO passes over X500.
      {"macro_header.nc", Dialect::fanuc, mill, 1, 5, 0, {-2, 0, -5}, {100, 25, -5}},
      // (20, 0) turned by 90 degrees, (10, 10) twice as far, (10, 5) mirrored, a local zero, two
      // holes at 0 and 60 degrees.
      {"rotation_scaling_polar.nc", Dialect::fanuc, mill, 7, 8, 0, {-10, 0, -3}, {100, 50, -1}},
      {"catia_v5.nc", Dialect::fanuc, mill, 1, 3, 1, {-5, -5, -5}, {60, 50, -5}},
      {"bobcad.nc", Dialect::fanuc, mill, 2, 3, 0, {0, 0, -6.35}, {101.6, 101.6, -6.35}},
      {"onecnc.nc", Dialect::fanuc, mill, 2, 3, 2, {0, 0, -6}, {100, 20, -3}},
      // G66: two holes; G65 twice with I J K in two groups; three steps in X, two in Y.
      {"macro_calls.nc", Dialect::fanuc, mill, 8, 11, 0, {1, 2, -3}, {20, 10, 6}},
      // A corner of 0.1 and a chamfer of 0.1 inch; a bore in strokes of half an inch.
      {"haas_lathe.nc", Dialect::fanuc, lathe, 9, 9, 1, {0, 0, -50.8}, {25.4, 0, 2.54}},
      {"edgecam_lathe.nc", Dialect::fanuc, lathe, 8, 10, 1, {-0.5, 0, -50}, {30, 0, 0}},
      // Five runs of O1002, each 1 mm deeper in radius.
      {"bar_puller.nc", Dialect::fanuc, lathe, 21, 5, 0, {11, 0, -18}, {15, 0, -18}},
      {"probing_haas.nc", Dialect::fanuc, mill, 1, 2, 0, {0, 0, -1}, {10, 0, -1}},
      // Holes at 30, 90, 150 degrees and, by K3 in G91, at 210, 270 and 330.
      {"polar_bolt_circle.nc",
       Dialect::fanuc,
       mill,
       14,
       6,
       0,
       {-34.641016151, -40, -12},
       {34.641016151, 40, -12}},
      // A contour inside its arc of 10 by G41 in four quadrants, by I-1000, and twice as large.
      {"mirror_comp.nc",
       Dialect::fanuc,
       mill,
       18,
       24,
       6,
       {-35, -30, -4},
       {75, 60, -2},
       "register-missing"},
      // P30071, P72 L2, and a call in a call; of G91 X1. G90 the last counts, so L3 moves once.
      {"calls_in_all_forms.nc", Dialect::fanuc, mill, 1, 17, 0, {0, 0, -5}, {10, 10, 0}},
      {"fagor_drilling.pim", Dialect::iso, mill, 6, 3, 0, {20, 0, -15}, {50, 20, 20}},
      // G76 in a bore: 12 passes to 0.65 - 0.02 and the last; G92, G32, G83, G74, G90, chamfers.
      {"lathe_bore_cycles.nc", Dialect::fanuc, lathe, 112, 59, 1, {0, 0, -30}, {25, 0, 7}},
      // The drill at X30 turns by itself.
      {"live_tool_lathe.nc",
       Dialect::fanuc,
       lathe,
       14,
       6,
       0,
       {15, 0, -20},
       {25, 0, -3},
       "live-tool not-supported not-supported not-supported"},
      // WEAR COMP: D is 0, so that the programmed path is the cutter's.
      {"mastercam_wear.nc", Dialect::fanuc, mill, 34, 24, 3, {-20, -20, -20}, {58, 48, 5}},
      // A slot at each 45 degrees by WHILE and G68, then a circle by G65.
      {"rotated_pattern_macro.nc", Dialect::fanuc, mill, 30, 19, 1, {-40, -40, -4}, {66, 40, -3}},
      {"haas_shrinking_strokes.nc",
       Dialect::fanuc,
       mill,
       7,
       9,
       10,
       {0, 0, -25.4},
       {67.31, 12.7, 0},
       "register-missing"},
      // The line at 170 degrees falls 5.08 / tan 10 in Z.
      {"mazak_lathe.eia",
       Dialect::fanuc,
       lathe,
       4,
       6,
       2,
       {-0.79375, 0, -66.910111644},
       {27.94, 0, 0.127}},
      {"sinumerik_shaft.mpf", Dialect::sinumerik, lathe, 66, 33, 2, {10, 0, -40}, {31.5, 0, 0.3}},
      {"sinumerik_defines.mpf", Dialect::sinumerik, mill, 14, 14, 4, {0, -20, -10}, {65, 30, 20}},
      {"sinumerik_frames.mpf",
       Dialect::sinumerik,
       mill,
       1,
       6,
       4,
       {-8.660254038, -5, -1},
       {70, 70, 19}},
      // No T word: the one tool of the comments cuts.
      {"estlcam.nc", Dialect::ngc, mill, 2, 3, 1, {10, 5, -1}, {45, 30, -1}},
      // No T word: "(tool 3.175mm)".
      {"bcnc_pocket.nc", Dialect::ngc, mill, 1, 3, 1, {10, 10, -1}, {55, 40, -1}},
      // A cut at each 90 degrees by RPT and G73, a quarter circle mirrored in X, a line at half its
      // size.
      {"fagor_mirror_rotation.pim", Dialect::iso, mill, 18, 11, 1, {-60, -50, -3}, {50, 60, -2}},
      // G15 H, G56 H and G53; two holes.
      {"okuma_osp_mill.min", Dialect::fanuc, mill, 10, 5, 1, {-20, 0, -20}, {60, 40, -3}},
      // Z is unknown behind the tool changes, until the place beside G100.
      {"brother_speedio.nc", Dialect::fanuc, mill, 7, 5, 0, {0, 0, -15}, {30, 20, -2}},
      {"powermill_bullnose.tap", Dialect::fanuc, mill, 2, 4, 0, {10, 10, -0.7}, {50, 10.5, -0.5}},
      // Strokes of 0.5, 0.3, 0.1, 0.1 and 0.1 inch from R in both holes.
      {"haas_ijk_stored.nc",
       Dialect::fanuc,
       mill,
       22,
       10,
       0,
       {25.4, 0, -25.4},
       {50.8, 25.4, -10.16}},
      {"both_sides.nc",
       Dialect::fanuc,
       mill,
       1,
       6,
       0,
       {-20, -20, -3},
       {80, 45, -3},
       "register-missing"},
      // The start lies at the end's radius, then 1 and 2 mm below.
      {"lathe_taper_cycles.nc", Dialect::fanuc, lathe, 7, 7, 0, {23, 0, -20}, {30, 0, 2}},
      {"sin_patterns_trans.mpf", Dialect::sinumerik, mill, 13, 12, 6, {0, 0, -1}, {35, 0, -1}},
      // Depths of 2, 4 and 5 mm at two places.
      {"ngc_steps.ngc", Dialect::ngc, mill, 4, 6, 6, {10, 10, -5}, {30, 10, -2}},
      // Turns of 1.5 mm down to 4.5, then to 5, then a flat one.
      {"helical_bore_macro.nc", Dialect::fanuc, mill, 1, 3, 5, {0, 0, -5}, {14, 0, 0}},
      {"tool_change_sub.nc", Dialect::fanuc, mill, 6, 4, 0, {0, 0, -10}, {30, 10, -2}},
  };
  for (const Post& post : posts) {
    SCOPED_TRACE(post.file);
    const Program p =
        read_program(std::string(MRSIM_DATA_DIR) + "/../tests/posts/" + post.file, {});
    EXPECT_EQ(codes(p), post.found) << listing(p);
    EXPECT_EQ(p.dialect, post.dialect) << p.dialect_reason;
    EXPECT_EQ(p.machine, post.machine) << p.machine_reason;
    std::size_t rapids = 0, lines = 0, arcs = 0;
    Vec3 low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
    for (const Motion& m : p.motions) {
      if (m.kind == MotionKind::rapid) {
        rapids += m.assumed_start ? 0 : 1;
        continue;
      }
      (m.kind == MotionKind::line ? lines : arcs) += 1;
      for (int i = 0; i < 3; ++i) {
        component(low, i) = std::min(component(low, i), component(m.end, i));
        component(high, i) = std::max(component(high, i), component(m.end, i));
      }
    }
    EXPECT_EQ(rapids, post.rapids) << listing(p);
    EXPECT_EQ(lines, post.lines);
    EXPECT_EQ(arcs, post.arcs);
    expect_near(low, post.low, 1e-8);
    expect_near(high, post.high, 1e-8);
  }
}

TEST(Posts, OtherControlsAreNamed) {
  const std::pair<const char*, const char*> programs[] = {
      {"num_1060.nc", "NUM"},     {"heidenhain.h", "Heidenhain"}, {"heidenhain_iso.i", "DIN/ISO"},
      {"okuma_lap.min", "Okuma"}, {"mazatrol.pbg", "Mazatrol"},   {"printer.gcode", "3-D printer"},
      {"laser.nc", "laser"}};
  for (const auto& [file, name] : programs) {
    SCOPED_TRACE(file);
    try {
      read_program(std::string(MRSIM_DATA_DIR) + "/../tests/posts/" + file, {});
      FAIL() << "it is read";
    } catch (const PlacedError& error) {
      EXPECT_EQ(error.diagnostic().code, "control-unsupported");
      EXPECT_NE(error.diagnostic().text.find(name), std::string::npos) << error.diagnostic().text;
    }
  }
}

TEST(Posts, ASafeStartNeverWarns) {
  const std::pair<Dialect, const char*> starts[] = {
      {Dialect::fanuc, "G90 G94 G17 G21 G40 G49 G80 G69 G50"},
      {Dialect::fanuc, "G00 G17 G21 G40 G49 G80 G90 G98"},
      {Dialect::fanuc, "G91 G28 Z0.\nG90 G28 X0. Y0.\nG90"},
      {Dialect::fanuc, "G28 G91 Z0.\nG30 G91 Z0.\nG90"},
      {Dialect::fanuc, "G5.1 Q1\nG5.1 Q0\nG5 P10000\nG5 P0\nG8 P1\nG64\nG61"},
      {Dialect::fanuc,
       "G10 L2 P1 X0. Y0. Z0.\nG54\nG92.1 X0 Y0 Z0\nG187 P2\nG22 X1. Y1. Z1. I0 J0 K0"},
      {Dialect::iso, "G90 G94 G17 G21 G40 G49 G80 G90.1 G91.1 G61.1 G64"},
      {Dialect::iso, "G90.1\nG91.1\nG54.1 P1\nG59.1"},
      {Dialect::ngc, "G17 G21 G40 G49 G54 G80 G90 G94\nG64 P0.01 Q0.01\nG90.1\nG91.1\nG61\nG61.1"},
      {Dialect::ngc,
       "G92.1\nG92.2\nG92.3\nG28.1\nG30.1\nG10 L2 P1 X0 Y0 Z0\nG10 L20 P0 X0\nG59.3\nG8"},
      {Dialect::sinumerik,
       "G40 G17 G90 G94 G71 G64 G500\nTRAFOOF\nCYCLE800()\nCYCLE832()\nMSG(\"A\")"},
      {Dialect::sinumerik, "G0 SUPA Z0 D0\nG0 G153 X0 Y0\nG74 Z1=0\nG75 X1=0 FP=1"},
  };
  for (const auto& [dialect, text] : starts) {
    SCOPED_TRACE(text);
    InterpOptions options = at_origin(dialect);
    options.start.reset();
    const Program p = read_text(std::string(text) + "\nG0 X1 Y1 Z1\nG1 X2 F100\n", options);
    EXPECT_EQ(codes(p), "") << listing(p);
    EXPECT_EQ(p.motions.size(), 2U) << listing(p);
  }
}

TEST(Posts, WhatMovesTheMachineIsNamed) {
  const std::pair<const char*, const char*> rows[] = {{"G68.2 X0 Y0 Z0 I0 J0 K0", "tilted"},
                                                      {"G43.4 H1", "tool centre point"},
                                                      {"G150 P1", "a pocket"},
                                                      {"G5 X1 Y1 I1 J1", "spline"},
                                                      {"G7.1 C20.", "cylindrical"}};
  for (const auto& [text, name] : rows) {
    SCOPED_TRACE(text);
    const Program p =
        read_text(std::string("G1 X1 F100\n") + text + "\n", at_origin(Dialect::fanuc));
    ASSERT_FALSE(p.diagnostics.empty());
    EXPECT_EQ(p.diagnostics[0].code, "not-supported");
    EXPECT_NE(p.diagnostics[0].text.find(name), std::string::npos) << p.diagnostics[0].text;
    EXPECT_EQ(p.diagnostics[0].place.line, 2);
  }
}

TEST(Posts, SemicolonsPointsAndTurns) {
  for (const Dialect d : {Dialect::fanuc, Dialect::iso, Dialect::ngc}) {
    const Program p = read_text("G1 Z-1 F100 ;Z-3\nG1 X1\n", at_origin(d));
    ASSERT_EQ(p.motions.size(), 2U);
    EXPECT_EQ(p.motions[0].end.z, -1);
    const Program turns = read_text("G1 X10 F100\nG3 I-10 Z-3 P3\n", at_origin(d));
    ASSERT_EQ(turns.motions.size(), 2U);
    EXPECT_NEAR(turns.motions[1].sweep, 6 * kPi, 1e-12);
  }
  EXPECT_EQ(codes(read_text("G1 X1000 F1\n", at_origin(Dialect::fanuc)), Severity::note),
            "number-without-point");
  EXPECT_EQ(codes(read_text("G1 X1 F1\nG55\nX2\n", at_origin(Dialect::iso)), Severity::note),
            "work-offset-unset");
  const Program half = read_text("G1 X0 F1\nG2 X10 R4.999\n", at_origin(Dialect::fanuc));
  EXPECT_EQ(codes(half, Severity::error), "");
  EXPECT_NEAR(half.motions.back().sweep, -kPi, 1e-9);
}

// G54's zero at X-200 Y-100 Z-300 of the machine: machine X0 lies at X200 of the stock.
TEST(Posts, MachineCoordinatesWithAKnownZero) {
  const auto moved = [](Dialect dialect, const std::string& text, bool table = false) {
    InterpOptions options = at_origin(dialect);
    options.places.zero = {{"G54", {-200, -100, -300}}, {"G55", {-150, -100, -300}}};
    options.places.reference = {0, 0, -10};
    options.places.second = Vec3{-300, 0, 0};
    if (table) options.table.work.push_back({"G54", {0, 0, 40}});
    const Program p = read_text(text, options);
    std::string out = codes(p, Severity::note);
    for (const Motion& m : p.motions)
      out += " " + std::to_string(static_cast<int>(m.end.x)) + "," +
             std::to_string(static_cast<int>(m.end.y)) + "," +
             std::to_string(static_cast<int>(m.end.z)) + (m.assumed_start ? "?" : "");
    return out;
  };
  const auto f = Dialect::fanuc, s = Dialect::sinumerik;
  EXPECT_EQ(moved(f, "G1 X5. F100.\nG53 G0 Z0.\nG53 X-50.\nG0 X0.\n"),
            " 5,0,0 5,0,300 150,0,300 0,0,300");
  EXPECT_EQ(moved(f, "G1 X5. F100.\nG91 G28 Z3.\nG28 X0. Y0.\nG90 G30 X10.\n"),
            " 5,0,0 5,0,3 5,0,290 200,100,290 10,100,290 -100,100,290");
  for (const Dialect dialect : {f, Dialect::ngc})  // without axes all of them
    EXPECT_EQ(moved(dialect, "G1 X5. F100.\nG28\nG30\n"), " 5,0,0 200,100,290 -100,100,300");
  EXPECT_EQ(moved(f, "G1 X5. F100.\nG28 A0.\n"), "rotary-axis 5,0,0");
  EXPECT_EQ(moved(f, "G1 X5. F100.\nG55\nX0. Y0.\n"), " 5,0,0 50,0,0");
  EXPECT_EQ(moved(f, "G10 L2 P1 X-190. Y-100. Z-300.\nG1 X5. F100.\n"), " 15,0,0");
  EXPECT_EQ(moved(f, "G1 X5. Z0. F100.\nG53 G0 Z0.\n", true), " 5,0,40 5,0,340");
  EXPECT_EQ(moved(s, "G1 X5 F100\nG0 SUPA Z0 D0\nG74 X1=0\nG75 X1=0 Z1=0\n"),
            " 5,0,0 5,0,300 200,0,300 -100,0,300");
}

TEST(Posts, RadiusWithoutARegister) {
  InterpOptions options = at_origin(Dialect::fanuc);
  const char* text = "G0 X0 Y0\nG1 G41 D1 X0 Y10 F100\nY20\nY30\nG40 X-20\n";
  const auto x = [&](CompRadius comp, const char* expected) {
    options.comp = comp;
    const Program p = read_text(text, options);
    EXPECT_EQ(codes(p), expected);
    return p.motions[1].end.x;
  };
  EXPECT_NEAR(x(CompRadius::automatic, "register-missing"), -5, 1e-9);
  EXPECT_NEAR(x(CompRadius::radius, ""), -5, 1e-9);
  EXPECT_NEAR(x(CompRadius::wear, ""), 0, 1e-9);
  EXPECT_NEAR(x(CompRadius::off, ""), 0, 1e-9);
}

TEST(Posts, G10SetsOffsetsAndRadii) {
  const Program p = read_text(
      "G10 L2 P2 X100 Y50\nG55\nG1 X1 Y1 F1\nG54\nG10 L12 P3 R2\nG41 D3 X1 Y10\nY20\nG40 X-9\n",
      at_origin(Dialect::fanuc));
  EXPECT_EQ(codes(p), "");
  expect_near(p.motions[0].end, {101, 51, 0});
  EXPECT_NEAR(p.motions[2].end.x, -1, 1e-9);
  const Program here = read_text("G1 X10 F1\nG10 L20 P1 X0\nG1 X5\n", at_origin(Dialect::ngc));
  EXPECT_EQ(here.motions.back().end.x, 15);
}

// LinuxCNC: the entry ends beside its own end, not beside the next element's start; round an
// outside corner an arc follows, an inside one ends the entry where the moved elements meet.
TEST(Posts, LinuxCncEntersCompensationBesideTheEntry) {
  const InterpOptions options = at_origin(Dialect::ngc);
  const Program outside = read_text("G42.1 D2 G1 X10 F100\nY10\nG40 X20\nM2\n", options);
  EXPECT_EQ(codes(outside), "");
  ASSERT_EQ(outside.motions.size(), 4U) << listing(outside);
  expect_near(outside.motions[0].end, {10, -1, 0});
  EXPECT_EQ(outside.motions[1].kind, MotionKind::arc);
  expect_near(outside.motions[1].center, {10, 0, 0});
  expect_near(outside.motions[1].end, {11, 0, 0});
  const Program inside = read_text("G41.1 D2 G1 X10 F100\nY10\nG40 X20\nM2\n", options);
  expect_near(inside.motions[0].end, {9, 1, 0});
  EXPECT_EQ(codes(read_text("G41.1 D4 G1 X2 F100\nY10\nG40 X20\nM2\n", options)), "comp-entry");
}

// LinuxCNC: R of G10 L2 turns the offset about its zero, L20 keeps the position.
TEST(Posts, G10TurnsAWorkOffset) {
  const InterpOptions options = at_origin(Dialect::ngc);
  const Program p = read_text("G10 L2 P1 X10 Y0 R90\nG1 X5 Y1 F1\nG10 L20 P1 X1 Y0\nX2\n", options);
  EXPECT_EQ(codes(p), "");
  ASSERT_EQ(p.motions.size(), 2U);
  expect_near(p.motions[0].end, {9, 5, 0});
  expect_near(p.motions[1].end, {9, 6, 0});
}

// Compensation ends with a straight move; a full circle is none.
TEST(Posts, AFullCircleDoesNotEndCompensation) {
  for (const Dialect d : {Dialect::fanuc, Dialect::ngc})
    EXPECT_EQ(codes(read_text("G41 D1 G1 X10 F100\nX30\nG40\nG2 I5\nG1 X50\nM2\n", at_origin(d))),
              "comp-end-arc");
}

TEST(Posts, LinuxCncArcsAndDiameters) {
  const InterpOptions options = at_origin(Dialect::ngc);
  EXPECT_EQ(codes(read_text("F1\nG2 X6000 I3100\n", options)), "arc-radii-differ");
  EXPECT_EQ(codes(read_text("F1\nG2 X1.01 I0.5\n", options), Severity::error), "");
  EXPECT_EQ(codes(read_text("F1\nG2 X10.1 I5\n", options)), "arc-radii-differ");
  const Program p = read_text("G1 G41.1 D6.5 X0 Y10 F100\nY20\nY30\nG40 X-20\n", options);
  EXPECT_EQ(codes(p), "");
  EXPECT_NEAR(p.motions[1].end.x, -3.25, 1e-9);
}

// A macro of a probe that is not at hand cuts nothing; where it ends is unknown.
TEST(Posts, ProbingMacrosAreNotRun) {
  const Program p = read_text(
      "G0 X1. Y1. Z1.\nG65 P9810 Z-5. F2000.\nG65 P9811 Z0. S1.\nG0 X5. Y5.\nZ5.\nG1 X9. F1.\n",
      at_origin(Dialect::fanuc));
  EXPECT_EQ(codes(p, Severity::note), "probe") << listing(p);
  ASSERT_EQ(p.motions.size(), 4U);
  EXPECT_TRUE(p.motions[2].assumed_start);
  EXPECT_FALSE(p.motions[3].assumed_start);
  EXPECT_EQ(codes(read_text("G65 P9100 Z-5.\n", at_origin(Dialect::fanuc)), Severity::error),
            "subprogram-missing");
}

TEST(Posts, LAloneIsACallThatIsNotMade) {
  for (const Dialect d : {Dialect::fanuc, Dialect::iso})
    EXPECT_EQ(codes(read_text("G1 X1. F1.\nL101\n", at_origin(d))), "call-without-program");
}

TEST(Posts, ProgramNamesOfOkumaAreHeaders) {
  const Program p = read_text("$PART1.MIN%\nO1\nG1 X1. F1.\n", at_origin(Dialect::fanuc));
  EXPECT_EQ(codes(p), "");
  EXPECT_EQ(p.motions.size(), 1U);
}

TEST(Posts, TwoToolsBesideM6) {
  InterpOptions options = at_origin(Dialect::fanuc);
  for (const char* id : {"1", "2"}) {
    Tool tool;
    tool.id = id;
    tool.diameter = 4;
    options.table.tools.push_back(tool);
  }
  const Program p = read_text("T01 T02 M06\nG1 X1 F1\nM6\nX2\n", options);
  EXPECT_EQ(codes(p), "");
  ASSERT_EQ(p.motions.size(), 2U);
  EXPECT_EQ(p.tools[static_cast<std::size_t>(p.motions[0].tool)].id, "1");
  EXPECT_EQ(p.tools[static_cast<std::size_t>(p.motions[1].tool)].id, "2");
}

}  // namespace
}  // namespace mrsim
