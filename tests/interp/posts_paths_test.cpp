// Programs in the manner of CAM posts, by the whole path of each: worked out from the program and
// its control's manual. path_text() gives ends and kinds; tools are "id:diameter".
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

struct PathOfPost {
  const char* file;
  Dialect dialect;
  MachineKind machine;
  const char* tools;
  const char* path;
};

constexpr auto kMill = MachineKind::mill, kLathe = MachineKind::lathe;

const PathOfPost kPaths[] = {
    // Inches; two turns down, half a turn on.
    {"pathpilot_mill.nc", Dialect::ngc, kMill, "1:12.7",
     "r25.4,25.4,0 r25.4,25.4,15.24 r25.4,25.4,5.08 l25.4,25.4,2.54 "
     "a25.4,25.4,-1.27 a25.4,25.4,-6.35 a30.48,25.4,-6.35 l50.8,25.4,-6.35 "
     "r50.8,25.4,15.24"},
    // The lead-in: a quarter circle in G18, G2 from X- to Z-, one in G17.
    {"fusion_uccnc.nc", Dialect::ngc, kMill, "1:6",
     "r-4.2,10,0 r-4.2,10,15 r-4.2,10,5 l-4.2,10,1 a-3.6,10,0.4 l-3,10,0.4 "
     "a-2.4,10.6,0.4 l-2.4,40,0.4 r-2.4,40,15"},
    // "T1 : 3.0" is the tool.
    {"cambam.nc", Dialect::ngc, kMill, "1:3",
     "r0,0,3 r-1.5,20,3 r-1.5,20,1 l-1.5,20,-1 l-1.5,40,-1 a0,41.5,-1 l40,41.5,-1 "
     "a41.5,40,-1 l41.5,20,-1 r41.5,20,3"},
    // G70 are inches, G5.3 P is nothing.
    {"hurco_isnc.hnc", Dialect::fanuc, kMill, "1:12.7",
     "r0,0,15.24 l0,0,-5.08 l50.8,0,-5.08 r50.8,0,15.24"},
    // No T word; $H at the end.
    {"openbuilds.gcode", Dialect::ngc, kMill, ":3.175",
     "r0,0,10 r1.587,1.587,10 l1.587,1.587,-1 l20,1.587,-1 l20,20,-1 r20,20,10"},
    // The tool of radius 5 in the arc of radius 5: a point. MCALL drills at one place.
    {"fusion_828d.mpf", Dialect::sinumerik, kMill, "1:10",
     "r-20,10,0 r-20,10,15 r-20,10,5 l-20,10,-5 l-5,5,-5 l-5,40,-5 a5,50,-5 "
     "l50,50,-5 l60,60,-5 r60,60,15 r10,10,15 r10,10,5 l10,10,-10 r10,10,15 | "
     "register-missing"},
    // A cylinder of the thread's diameter, with a warning.
    {"thread_mill.nc", Dialect::fanuc, kMill, "10:8",
     "r0,0,15 r0,0,2 l0,0,-12 a1,0,-12 a1,0,-10.75 a0,0,-10.75 r0,0,15 | "
     "tool-inferred"},
    // A circle of radius 10 cut from within by a radius of 6.
    {"featurecam.nc", Dialect::fanuc, kMill, "2:12",
     "r0,0,25 l0,0,-2 l4,0,-2 a4,0,-2 l0,0,-2 r0,0,25 | register-missing"},
    // Three runs; G92 at the end of each makes the place its zero.
    {"sub_that_shifts.nc", Dialect::fanuc, kMill, "7:12",
     "r0,0,50 r0,0,2 l0,0,-1 l40,0,-1 l40,20,-1 a30,30,-1 r30,30,2 r80,30,2 "
     "l80,30,-1 l120,30,-1 l120,50,-1 a110,60,-1 r110,60,2 r160,60,2 l160,60,-1 "
     "l200,60,-1 l200,80,-1 a190,90,-1 r190,90,2 r240,90,2 r240,90,50"},
    // Three slots by a loop, O100 twice, OABC by its name, O200 behind two moves.
    {"okuma_task.min", Dialect::fanuc, kMill, "1:10",
     "r0,0,50 r0,10,50 r0,10,5 l0,10,-2 l10,10,-2 r10,10,50 r30,10,50 r30,10,5 l30,10,-2 "
     "l40,10,-2 r40,10,50 r60,10,50 r60,10,5 l60,10,-2 l70,10,-2 r70,10,50 r0,0,50 r0,0,5 l0,0,-1 "
     "l15,0,-1 r15,0,50 r0,0,50 r0,0,5 l0,0,-1 l15,0,-1 r15,0,50 r77,0,50 r0,0,50 r0,0,2 l0,0,-1 "
     "r0,0,50 r50,0,50 r50,0,2 l50,0,-1 r50,0,50 r50,0,400"},
    // LAP: D8 are passes of 4; W0.1 to the right of the walls, U0.4 about the diameters.
    {"okuma_lap.min", Dialect::fanuc, kLathe, "1:0 2:0",
     "r150,0,300 r27,0,5 r23,0,5 l23,0,-39.9 r23.5,0,-39.4 r23.5,0,5 r19,0,5 l19,0,-19.9 "
     "r19.5,0,-19.4 r19.5,0,5 r15,0,5 l15,0,-19.9 r15.5,0,-19.4 r15.5,0,5 r11,0,5 l11,0,-19.9 "
     "r11.5,0,-19.4 r11.5,0,5 r10.2,0,5.1 l10.2,0,-19.9 l20.2,0,-19.9 l20.2,0,-39.9 "
     "l26.2,0,-39.9 r27,0,5 r150,0,300 r27,0,5 r10,0,5 l10,0,-20 l20,0,-20 l20,0,-40 l26,0,-40 "
     "r27,0,5 r150,0,300"},
    // T001001 is tool 1; five strokes of 5 mm, back by 1.
    {"mazak_six_digits.eia", Dialect::fanuc, kLathe, "1:0 3:12",
     "r26,0,0 l-0.8,0,0 r23,0,2 l23,0,-30 l26,0,-30 r0,0,5 l0,0,0 r0,0,1 l0,0,-5 "
     "r0,0,-4 l0,0,-10 r0,0,-9 l0,0,-15 r0,0,-14 l0,0,-20 r0,0,-19 l0,0,-25 r0,0,5"},
    // K-1.5 from Z-20; R-3 from Z5, strokes of 2.
    {"mastercam_lathe_oils.nc", Dialect::fanuc, kLathe, "1:0 61:6",
     "r27.5,0,2.5 l27.5,0,0.5 l-0.8,0,0.5 r-0.8,0,2.5 r23.7,0,2.5 l23.7,0,-48 "
     "l25,0,-48 l26.41,0,-46.59 r26.41,0,2.5 r22.5,0,2.5 l22.5,0,-20 a24,0,-21.5 "
     "l26,0,-21.5 r0,0,5 r0,0,2 l0,0,0 r0,0,2 r0,0,0.254 l0,0,-2 r0,0,2 "
     "r0,0,-1.746 l0,0,-4 r0,0,2 r0,0,-3.746 l0,0,-6 r0,0,2 r0,0,-5.746 l0,0,-8 "
     "r0,0,2 r0,0,-7.746 l0,0,-10 r0,0,5"},
    // ":0030 T01 M06" is a block; the second tool comes behind another.
    {"nx_alignment.ptp", Dialect::fanuc, kMill, "1:10 2:6",
     "r-20,-5,0 r-20,-5,30 r-20,-5,3 l-20,-5,-5 l-5,-5,-5 l-5,30,-5 a0,35,-5 l50,35,-5 "
     "r50,35,30 r10,10,30 r10,10,2 l10,10,-12 r10,10,30"},
    // Two holes, two taps with the lead in I; L is no count.
    {"brother_taps.nc", Dialect::fanuc, kMill, "2:5 9:6",
     "r20,15,15 r20,15,5 r20,15,3 l20,15,-12 r20,15,5 r40,15,5 r40,15,3 l40,15,-12 r40,15,5 "
     "r40,15,15 r20,15,15 r20,15,5 r20,15,3 l20,15,-10 l20,15,3 r20,15,5 r40,15,5 r40,15,3 "
     "l40,15,-10 l40,15,3 r40,15,5 r40,15,15"},
    // The second program is not run.
    {"face_and_edge.nc", Dialect::fanuc, kMill, "1:50 2:16",
     "r-30,20,0 r-30,20,10 r-30,20,0 l130,20,0 r130,20,10 r-30,55,10 r-30,55,0 l130,55,0 "
     "r130,55,100 r-12,-2,100 r-12,-2,10 r-12,-2,-4 l112,-2,-4 l112,-2,-8 l-12,-2,-8 "
     "r-12,-2,100"},
    // D1 behind the tool's name is an edge.
    {"hypermill_840d.mpf", Dialect::sinumerik, kMill, "BALL_8_R4:8",
     "r0,0,20 r0,0,2 l0,0,-1 l40,0,-2 l40,1,-2 l0,1,-1 r0,1,20"},
    // Down into the troughs: G2 towards X+ in G18, G3 towards Y+ in G19.
    {"troughs_in_g18_g19.nc", Dialect::fanuc, kMill, "7:10",
     "r-25,0,0 r-25,0,20 r-25,0,0 l-20,0,0 a20,0,0 l20,2,0 a-20,2,0 r-20,2,40 r30,-15,40 "
     "r30,-15,5 l30,-15,0 a30,15,0 a30,-15,0 r30,-15,40"},
    // L0 drills nowhere; R-2 holds for one hole; K2 in G91; Q7. and Q11000 are depths.
    {"drill_patterns_in_g91.nc", Dialect::fanuc, kMill, "5:6",
     "r0,0,30 r10,10,30 r10,10,3 l10,10,-10 r10,10,30 r20,10,30 r20,10,3 l20,10,-10 r20,10,30 "
     "r20,20,30 r20,20,3 l20,20,-10 r20,20,3 r10,20,3 l10,20,-5 r10,20,3 r0,20,3 r0,20,-2 "
     "l0,20,-12 r0,20,30 r0,30,30 r0,30,3 l0,30,-4 r0,30,3 r0,30,-3.746 l0,30,-10 r0,30,3 "
     "r0,40,3 l0,40,-4 r0,40,3 r0,40,-3.746 l0,40,-10 r0,40,3 r0,40,30 r50,0,30 r50,0,2 "
     "l50,0,-9 r50,0,-8.746 l50,0,-20 r50,0,2 r60,0,2 l60,0,-9 r60,0,-8.746 l60,0,-20 r60,0,2 "
     "r60,0,30 r0,0,30 r0,5,30"},
    // Rings of 7, 14, 21 mm and the last of (60 - 12) / 2.
    {"spiral_pocket_macro.nc", Dialect::fanuc, kMill, "4:12",
     "r0,0,25 r0,0,2 l0,0,-6 l7,0,-6 a7,0,-6 l14,0,-6 a14,0,-6 l21,0,-6 a21,0,-6 l24,0,-6 "
     "a24,0,-6 l23,0,-6 r23,0,25"},
    // PROC, FOR, IF, REPEAT by condition and of a part, CASE; frames and a pole. The tool by its
    // name.
    {"sin_flow.mpf", Dialect::sinumerik, kMill, "CUTTER 6:6",
     "r0,0,2 l0,0,-1 l10,5,-1 l20,10,-1 l20,10,-2 l30,5,-2 l40,10,-2 l40,10,-3 "
     "l50,5,-3 l60,10,-3 r60,10,5 r0,10,5 l3,1,5 l10.2,-2,-3 r10.2,-2,5 "
     "l30.2,-2,5 l50.2,-2,5 l70.2,-2,5 r50,10,5 r10,30,5 r70,50,5 a50,70,5"},
    // G50 of the second tool is where it stands, no other zero.
    {"fanuc_0t_touch_off.nc", Dialect::fanuc, kLathe, "1:0 3:0",
     "r26,0,0 l-0.8,0,0 r23,0,1.5 l23,0,-25 l27,0,-25 r120,0,120 r22,0,1 l19,0,1 l19,0,-12 "
     "l21,0,-14 l21,0,-24 l25,0,-24 r118,0,132"},
    // A block with a name; L is the arc's radius.
    {"okuma_osp_lathe.min", Dialect::fanuc, kLathe, "1:0",
     "r160,0,240 r32,0,0 l-0.8,0,0 r30,0,2 l30,0,-46 l32,0,-46 r32,0,2 r24,0,2 l24,0,-22 "
     "a27,0,-25 l29,0,-25 a30,0,-26 r160,0,240"},
    // The bar stop and the puller only touch, G53 is no pass of G90.
    {"haas_bar_work.nc", Dialect::fanuc, kLathe, "1:0 7:0",
     "r0,0,2 r0,0,0.5 r0,0,60 r17,0,0 l-0.4,0,0 r16,0,1 r13.5,0,1 l13.5,0,-24 l16,0,-24 "
     "r16,0,1 r12,0,1 l12,0,-24 l16,0,-24 r16,0,1 r18,0,-23 l11,0,-23 r13.5,0,-23 "
     "r13.5,0,-21.5 l12,0,-21.5 l10.5,0,-23 l-0.1,0,-23 r30,0,-23 r30,0,60 r0,0,6 r0,0,-12 "
     "r0,0,14 r0,0,60"},
    // X below 0: passes at 27.2 less 2, 4 and 6, back by 0.5 at 45 degrees; the contour at 0.2,
    // 0.1.
    {"back_turret.nc", Dialect::fanuc, kLathe, "2:0 4:0",
     "r27,0,2 r27.2,0,2.1 r25.2,0,2.1 l25.2,0,-14.9 r25.7,0,-14.4 r25.7,0,2.1 r23.2,0,2.1 "
     "l23.2,0,-14.9 r23.7,0,-14.4 r23.7,0,2.1 r21.2,0,2.1 l21.2,0,-12.66 r21.7,0,-12.16 "
     "r21.7,0,2.1 r19.2,0,2.1 l19.2,0,-11.9 a22.2,0,-14.9 l27.2,0,-14.9 r27,0,2 r19,0,2 "
     "l19,0,-12 a22,0,-15 l27,0,-15 r27,0,2 "
     "r40,0,40 r23,0,-12 l15,0,-12 r23,0,-12 r40,0,40"},
    // Tools of the list's names: outside, drill, inside, blade; the counter spindle takes the part.
    {"shop_names_shaft.mpf", Dialect::sinumerik, kLathe,
     "ROUGHING_T80_A:0 DRILL_12:12 FINISHING_T35_I:0 PLUNGE_CUTTER_3_A:0",
     "r23,0,0 l-0.8,0,0 r21,0,2 l21,0,-30 l23,0,-30 r60,0,60 r0,0,3 l0,0,-24 r0,0,60 r10,0,2 "
     "l10,0,-8 a8,0,-10 l5.5,0,-10 r5.5,0,60 r24,0,60 r24,0,-20 l18,0,-20 r60,0,-20"},
    // A byte order mark, CR LF, tabs, blank lines, a text end (0x1A).
    {"bom_crlf.nc", Dialect::fanuc, kMill, "1:6", "r0,0,5 l0,0,-1 l10,0,-1 r10,0,5"},
};

TEST(PostsPaths, PathsOfPostsAreAsWorkedOut) {
  for (const PathOfPost& post : kPaths) {
    SCOPED_TRACE(post.file);
    const Program p =
        read_program(std::string(MRSIM_DATA_DIR) + "/../tests/posts/" + post.file, {});
    EXPECT_EQ(p.dialect, post.dialect) << p.dialect_reason;
    EXPECT_EQ(p.machine, post.machine) << p.machine_reason;
    std::string tools;
    for (const Tool& tool : p.tools)
      tools += fmt::format("{}{}:{:g}", tools.empty() ? "" : " ", tool.id, tool.diameter);
    EXPECT_EQ(tools, post.tools);
    EXPECT_EQ(path_text(p), post.path);
  }
}

}  // namespace
}  // namespace mrsim
