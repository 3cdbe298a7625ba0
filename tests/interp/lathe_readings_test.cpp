// Comments about the tools of lathes, as catalogues and shops of several countries write them.
#include "interp/tool_readings.h"

namespace mrsim {
namespace {

// The tool with its lead angle and its nose, which tables of readings leave out for some kinds.
std::string whole_tool(const std::string& comment, double unit = 1) {
  Tool tool;
  std::string why;
  if (!fill_tool(read_tool_comment(comment), unit, true, tool, why)) return "? " + why;
  return fmt::format("{} {:.4g}/{:.4g} r{:.4g} w{:.4g}{}", tool.insert, degrees(tool.insert_angle),
                     degrees(tool.lead_angle), tool.nose_radius, tool.width,
                     tool.left_hand ? " left" : "");
}

// No insert has such corners: they are the lead angles of holders.
TEST(LatheReadings, LeadAnglesBesideInserts) {
  EXPECT_EQ(whole_tool("T1 DNMG 150608 93 DEG"), "DNMG 55/93 r0.8 w0");
  EXPECT_EQ(whole_tool("T1 SNMG 120412 45 DEG"), "SNMG 90/45 r1.2 w0");
  EXPECT_EQ(whole_tool("T1 CNMG 120408 80 DEG 95 DEG"), "CNMG 80/95 r0.8 w0");
  EXPECT_EQ(whole_tool("T83 ID ROUGH MIN. .5 DIA. - 75 DEG.  INSERT - CCMT-21.51", 25.4),
            "CCMT 80/75 r0.3969 w0");
  EXPECT_EQ(whole_tool("T1 CNMG 120408 55 DEG").substr(0, 2), "? ");
  EXPECT_EQ(whole_tool("T1 DNMG 93 DEG 35 DEG").substr(0, 2), "? ");
}

TEST(LatheReadings, SizesOfInserts) {
  EXPECT_EQ(whole_tool("T1 CNMG12-04-08"), "CNMG 80/95 r0.8 w0");
  EXPECT_EQ(whole_tool("T1 CNMG1204.12"), "CNMG 80/95 r1.2 w0");
  EXPECT_EQ(whole_tool("T1 CCMT 3-2.5-1"), "CCMT 80/95 r0.3969 w0");
  EXPECT_EQ(whole_tool("T1 RCMT 10T3 MO"), "RCMT 0/0 r5 w0");
  EXPECT_EQ(whole_tool("T1 RCMT 0803"), "RCMT 0/0 r4 w0");
  EXPECT_EQ(whole_tool("T1 DCMT 11 T3 04"), "DCMT 55/93 r0.4 w0");
}

TEST(LatheReadings, CornersBesideTheWordDiamond) {
  EXPECT_EQ(whole_tool("TOOL 1: 80. DIAMOND .031 RAD", 25.4), " 80/93 r0.7874 w0");
  EXPECT_EQ(whole_tool("T1 35 DIAMOND"), " 35/93 r0 w0");
  EXPECT_EQ(whole_tool("T1 TRIGON 80 DEG R0.8"), " 80/93 r0.8 w0");
}

// How a holder stands in its turret says which way it cuts: PCLNL upright and PCLNR upside down
// both turn towards the chuck.
TEST(LatheReadings, TheHandOfAHolderIsNotRead) {
  EXPECT_EQ(whole_tool("T1 PCLNL 2525 M12"), "C 80/95 r0 w0");
  EXPECT_EQ(whole_tool("T1 LEFT HAND VNMG160404"), "VNMG 35/93 r0.4 w0 left");
  EXPECT_EQ(whole_tool("T1 SDQCR 1616 H11"), "D 55/93 r0 w0");
}

TEST(LatheReadings, HoldersOfBars) {
  expect_readings({
      {lathe_mm, "T1 A20S-SCLCR09", "boring, insert 80"},
      {lathe_mm, "T1 S16Q-SCLCR09 CCMT 09T304", "boring, insert 80, nose 0.4"},
      {lathe_mm, "T1 S16R SDUCR 11", "boring, insert 55"},
      {lathe_mm, "T1 PCLNR 2525 M12", "turning, insert 80"},
      {lathe_mm, "T1 ALESAGE CCMT 09T304", "boring, insert 80, nose 0.4"},
      {lathe_mm, "T1 MANDRINADO CCMT 09T304", "boring, insert 80, nose 0.4"},
      {lathe_mm, "T1 CHARIOTAGE ET ALESAGE EXT CNMG 120408", "turning, insert 80, nose 0.8"},
  });
}

TEST(LatheReadings, Blades) {
  EXPECT_EQ(whole_tool("T1 INSERT - N151.2-300-30-4G").substr(0, 99), " 35/93 r0 w3");
  EXPECT_EQ(whole_tool("T1 DGN 3102J"), " 35/93 r0.2 w3.1");
  EXPECT_EQ(whole_tool("T1 GIP 3.00-0.40"), " 35/93 r0.4 w3");
  EXPECT_EQ(whole_tool("T1 NG3125L"), " 35/93 r0 w3.175");
  EXPECT_EQ(whole_tool("T1 MRMN 300"), " 35/93 r1.5 w3");
  EXPECT_EQ(whole_tool("T1 SP300"), " 35/93 r0 w3");
  EXPECT_EQ(whole_tool("T1 RADIUS GROOVE 3MM FULL RADIUS"), " 35/93 r1.5 w3");
  expect_readings({
      {lathe_mm, "T1 INNENEINSTECHSTAHL 2 MM", "grooving, width 2, orientation 2"},
      {lathe_mm, "T1 INNENSTECHER 3MM", "grooving, width 3, orientation 2"},
      {lathe_mm, "T1 ID GROOVER 3MM", "grooving, width 3, orientation 2"},
      {lathe_inch, "T1 OD GROOVER .125 WIDE", "grooving, width 3.175"},
      {lathe_mm, "T1 P/OFF 3MM", "grooving, width 3"},
      {lathe_mm, "T1 TRONCONNAGE 3MM", "grooving, width 3"},
      {lathe_mm, "T1 RANURADO 4MM", "grooving, width 4"},
      {lathe_mm, "T1 TRONZADO 3MM", "grooving, width 3"},
      {lathe_mm, "T1 TRONCATURA 3MM", "grooving, width 3"},
      {lathe_mm, "T1 GOLA 3MM", "grooving, width 3"},
      {lathe_mm, "T1 BLADE 3MM", "grooving, width 3"},
      {lathe_mm, "T1 GORGE", "? gives no width of the blade"},
      {lathe_mm, "NOZ DO ROWKOW 3MM, POMIAR NA LEWYM NAROZU", "grooving, width 3"},
      {lathe_mm, "NÓŻ DO ROWKÓW 3 MM", "grooving, width 3"},
      {lathe_mm, "BESZURO B2.5", "grooving, width 2.5"},
      {lathe_mm, "LESZÚRÓ B3.0", "grooving, width 3"},
      {lathe_mm, "BEDAME 4MM", "grooving, width 4"},
      {lathe_mm, "UPICHOVACI NUZ 3MM", "grooving, width 3"},
      {lathe_mm, "NOZ DO GWINTOW WEWN. 60ST", "threading, orientation 6, insert 60"},
      {lathe_mm, "T1 NOZ WEWN. CCMT 09T304", "boring, insert 80, nose 0.4"},
      {lathe_mm, "T3 FURO D10.0 HM", "drill 10"},
      {lathe_mm, "T1 ROSCADO M20", "threading, insert 60"},
      {lathe_mm, "T1 FILETAGE EXT", "threading, insert 60"},
      {lathe_mm, "T1 FILETTATURA INTERNA", "threading, orientation 6, insert 60"},
  });
}

// A blade for the outside left nothing of what lies outside of the groove.
TEST(LatheReadings, SidesWithPointsAndSlashes) {
  expect_readings({
      {lathe_mm, "T1 I.D. GROOVE 3MM", "grooving, width 3, orientation 2"},
      {lathe_mm, "T1 I.D.GROOVE 3MM", "grooving, width 3, orientation 2"},
      {lathe_mm, "T1 I/D GROOVE 3MM", "grooving, width 3, orientation 2"},
      {lathe_mm, "T1 O.D GROOVE 3MM", "grooving, width 3"},
      {lathe_mm, "T1 I.D. THREAD", "threading, orientation 6, insert 60"},
      {lathe_mm, "T1 O.D. 80 DEG R.8", "turning, insert 80, nose 0.8"},
      {lathe_mm, "OD_80_L", "turning, insert 80"},
      {lathe_mm, "T2 ID_55_L R0.4", "boring, insert 55, nose 0.4"},
      {lathe_mm, "T1 OD_GROOVE_L", "? gives no width of the blade"},
      {inch, "T1 ENDMILL O.D.=.5", "endmill 12.7"},
      {inch, "T1 ENDMILL .500 O.D.", "endmill 12.7"},
  });
}

TEST(LatheReadings, WhatPressesOrHoldsCutsNothing) {
  expect_readings({{lathe_mm, "T1 KNURLING TOOL", "? names no cutter"},
                   {lathe_mm, "T1 RÄNDELN", "? names no cutter"},
                   {lathe_mm, "T1 MOLETAGE", "? names no cutter"},
                   {lathe_mm, "T1 LIVE CENTER", "? names no cutter"},
                   {lathe_mm, "T1 BAR PULLER", "? names no cutter"}});
}

}  // namespace
}  // namespace mrsim
