// Programs in the manner of CAM posts: their envelope (safe starts, tool changes, ways home) gives
// no warning, and they move as worked out by hand.
#include "core/numbers/vec.h"
#include "interp/support.h"

#include <cmath>

namespace mrsim {
namespace {

using namespace mrsim::testing;

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
      {"powermill_fanuc.nc", Dialect::fanuc, mill, 2, 3, 0, {0, 0, -1.5}, {20, 0, -1}},
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
      // "G91X1.G90" is read otherwise by Mitsubishi.
      {"calls_in_all_forms.nc",
       Dialect::fanuc,
       mill,
       1,
       17,
       0,
       {0, 0, -5},
       {10, 10, 0},
       "group-twice"},
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
       "live-tool not-supported"},
      // WEAR COMP: D is 0, so that the programmed path is the cutter's.
      {"mastercam_wear.nc", Dialect::fanuc, mill, 33, 24, 3, {-20, -20, -20}, {58, 48, 5}},
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
      // The nose of 0.8 finishes: an arc round the chamfer's edge, and on the chamfer its point
      // lies
      // 0.8 (1 - cos 45) nearer to the axis.
      {"sinumerik_shaft.mpf",
       Dialect::sinumerik,
       lathe,
       66,
       33,
       3,
       {10 - 0.8 * (1 - std::sqrt(0.5)), 0, -40},
       {31.5, 0, 0.3}},
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
      // HA and DA, home positions, a place without a hole, a hole in turned coordinates.
      {"okuma_fusion_mill.min",
       Dialect::fanuc,
       mill,
       10,
       7,
       1,
       {-10, 0, -5},
       {60, 35, -1},
       "register-missing"},
      // Work offsets in E, the level of the cycle in R0, lengths without G43.
      {"fadal.nc", Dialect::fanuc, mill, 4, 4, 0, {-25.4, 0, -12.7}, {50.8, 12.7, -6.35}},
      {"okuma_osp_mill.min", Dialect::fanuc, mill, 8, 5, 1, {-20, 0, -20}, {60, 40, -3}},
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
      // Nine passes of G71 below radius 31.2 with a corner of 1 and one of 3; G70; G75 in three
      // strokes;
      // G76 in ten depths and twice more at the last; parted off.
      {"fanuc_shaft_cycles.nc", Dialect::fanuc, lathe, 81, 43, 4, {-0.8, 0, -74}, {31.2, 0, 0.1}},
      // One-line G72 in nine levels of D2000, G70, seven strokes of 8 back by 1, a bore of nine
      // passes
      // outwards, four passes of G92 in it.
      {"fanuc_0t_flange.nc", Dialect::fanuc, lathe, 74, 49, 2, {0, 0, -45}, {59.25, 0, 2.2}},
      // Code system B: G77, G79 and G78, G90 and G91.
      {"fanuc_code_b.nc", Dialect::fanuc, lathe, 27, 20, 0, {0, 0, -30}, {26, 0, 2}},
      // Chamfers, fillets and a line at 150 degrees without its Z.
      {"fanuc_direct_drawing.nc", Dialect::fanuc, lathe, 5, 8, 3, {0, 0, -62}, {32, 0, 0}},
      // CYCLE95 along blocks between labels, CYCLE93 with a blade of 4, CYCLE99, parted off. The
      // chamfer in the last block of the contour has no move behind it.
      {"lathe_808d.mpf",
       Dialect::sinumerik,
       lathe,
       84,
       45,
       3,
       {-0.5, 0, -50},
       {25.2, 0, 2.1},
       "corner-void"},
      // A groove from Z-15 to Z-21 in three plunges of three strokes; holes in G17, by DMODE and by
      // AXN; an inner thread in one pass.
      {"sin_lathe_drilling.mpf",
       Dialect::sinumerik,
       lathe,
       36,
       18,
       0,
       {-0.5, 0, -30},
       {18.333333333, 0, 2}},
      {"tool_change_sub.nc", Dialect::fanuc, mill, 6, 4, 0, {0, 0, -10}, {30, 10, -2}},
      // The same cuts left and right of X0.
      {"haas_mirror.nc", Dialect::fanuc, mill, 6, 6, 2, {-63.5, 0, -2.54}, {63.5, 38.1, -2.54}},
      // G10 L3 to G11 changes no tool; four taps of F1.25 under ,R1.
      {"mitsubishi_taps.nc", Dialect::fanuc, mill, 11, 8, 0, {10, 10, -12}, {50, 40, 3}},
      // A V tool as a taper of 45 degrees a side.
      {"carbide_create_vee.nc", Dialect::ngc, mill, 2, 8, 0, {-60, -20, -3}, {60, 20, 0}},
      // Inches; tools by their numbers in the list.
      {"vectric_avid.tap", Dialect::ngc, mill, 4, 4, 2, {12.7, 12.7, -3.175}, {139.7, 50.8, -2.54}},
      // In and out by quarter circles in G18, down by half turns.
      {"fusion_mach3_adaptive.tap", Dialect::ngc, mill, 2, 3, 8, {30, 18.8, -3}, {42, 21.2, 1}},
      {"kiri_moto.nc", Dialect::ngc, mill, 1, 10, 0, {5, 5, 6}, {45, 25, 8}},
      // The tool is named three blocks below its M06; R-12 runs 247 degrees.
      {"dolphin.nc", Dialect::fanuc, mill, 3, 3, 2, {-10, 30, -3}, {80, 50, -3}},
      // Its head counts the drills: T1 is 0.8, T2 1 mm. Three holes and two, all 2 deep.
      {"pcb2gcode_drill.ngc", Dialect::ngc, mill, 11, 7, 0, {0, 0, -2}, {25, 20, 2}},
      // G68.2 of zeros and G53.1 leave all as it is.
      {"tilt_of_zero.nc", Dialect::fanuc, mill, 2, 5, 0, {10, 10, -4}, {50, 30, -4}},
      // #13001 is 5.5 in the first pass round 40 x 30, 5 in the second.
      {"wear_in_loop.nc", Dialect::fanuc, mill, 1, 13, 0, {-20, -20, -5}, {45.5, 35.5, -5}},
      // DIAM90: X of G91 is a radius. Four passes 1 mm deep.
      {"diam90_setms.mpf", Dialect::sinumerik, lathe, 15, 7, 0, {20, 0, -30}, {26, 0, 2}},
      {"worknc.nc", Dialect::fanuc, mill, 2, 4, 0, {5, 5, -2.2}, {45, 5.4, -2}},
      // Slots at 0, 90, 180 and 270 degrees about (20, 20): A B of G68 are the centre, I adds.
      {"mach3_rotated.tap", Dialect::fanuc, mill, 13, 8, 0, {0, 0, -2}, {40, 40, -2}},
      // Six holes round the zero by N5, then half a circle about (60, 50) and a line.
      {"fagor_polar.pim", Dialect::iso, mill, 16, 8, 1, {-40, -34.641016151, -12}, {80, 50, -3}},
      {"two_vises_calls.nc", Dialect::fanuc, mill, 4, 4, 0, {0, 0, -2}, {130, 20, -2}},
      {"din_dwell.nc", Dialect::sinumerik, mill, 1, 3, 2, {-15, 0, -5}, {60, 60, -5}},
      // Turns of 1 mm down to 4.5 and to 3, and a flat one each.
      {"ngc_bores.ngc", Dialect::ngc, mill, 5, 4, 10, {20, 20, -4.5}, {65, 20, 0}},
      // An edge, then G47: HIT in six strokes and six further cuts, 11 in two and four.
      {"haas_engraved_plate.nc",
       Dialect::fanuc,
       mill,
       23,
       25,
       0,
       {-12.7, -12.7, -3.175},
       {114.3, 63.5, -0.2032},
       "engraving-font"},
      // G54, then G55 on the part turned over: the tap goes into the holes of the other side.
      {"two_set_ups.nc",
       Dialect::fanuc,
       mill,
       12,
       8,
       0,
       {-10, 10, -28},
       {50, 30, 5},
       "origins-coincide part-turned"},
      // G92 Z0 of the second bit is the surface, not the 20 mm above it where the first one was.
      {"router_two_bits.nc", Dialect::iso, mill, 6, 4, 0, {10, 10, -3}, {60, 30, -1}},
      {"listing_with_stars.nc", Dialect::fanuc, mill, 1, 2, 1, {0, 0, -1}, {30, 10, -1}},
      // Size 2 of 3: three holes on a circle of 60, 15 + 4 deep, in two strokes.
      {"flange_family.nc",
       Dialect::fanuc,
       mill,
       16,
       6,
       0,
       {-15, -25.980762114, -19},
       {30, 25.980762114, -9}},
      // Z=-_I*_ZUST twice, three holes in a loop by GOTOB.
      {"sin_housing.mpf", Dialect::sinumerik, mill, 14, 7, 0, {-12, 10, -6}, {132, 40, -3}},
      // CYCLE63 with an island of 60 x 40: the axis of a cutter of 10 comes to 5 mm of the walls.
      {"programguide_pocket.mpf",
       Dialect::sinumerik,
       mill,
       27,
       67,
       38,
       {-25, -15, -6},
       {25, 15, -2.9}},
      // CYCLE952: a nose of 0.8 before X52, 0.4 aside while roughing; Z from 1 - 0.8 + 0.1 on.
      {"programguide_shaft.mpf",
       Dialect::sinumerik,
       lathe,
       46,
       30,
       10,
       {0, 0, -60},
       {26 - 0.8 + 0.4, 0, 0.3}},
      // A pocket of 40 x 30 turned by 30 degrees, its chamfer cut 1 mm from the walls: 19 cos 30 +
      // 14 sin 30 about (5, 3).
      {"programguide_chamfer.mpf",
       Dialect::sinumerik,
       mill,
       9,
       60,
       0,
       {-18.454482671904, -18.624355652982, -5},
       {28.454482671904, 24.624355652982, -2}},
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
      {"num_1060.nc", "NUM"},           {"heidenhain.h", "Heidenhain"},
      {"heidenhain_iso.i", "DIN/ISO"},  {"mazatrol.pbg", "Mazatrol"},
      {"printer.gcode", "3-D printer"}, {"laser.nc", "laser"}};
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

}  // namespace
}  // namespace mrsim
