// Sizes of comments that stand beside another one: the shank's, the tip's, a head's in inches.
#include "interp/tool_readings.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

TEST(ToolMixedSizes, TheSizeThatCutsIsNotTheShanks) {
  const char* both = "? can be read as diameter 6 or 3";
  expect_readings({
      {mm, "T1 D6 SHANK D3 CUT ENDMILL", "endmill 3"},
      {mm, "T1 D3 CUT D6 SHANK ENDMILL", "endmill 3"},
      {mm, "T1 SHANK D6 CUT D3 ENDMILL", "endmill 3"},
      {mm, "T1 SHANK D6 D3 CUT ENDMILL", "endmill 3"},
      {mm, "SHANK 6 CUT 3 ENDMILL", "endmill 3"},
      {mm, "T1 D6 SHANK D3 CUT D10 LONG ENDMILL", "endmill 3"},
      {mm, "T1 D6 SHANK ENDMILL D3", "endmill 3"},
      {mm, "T1 D6 SCHAFT SCHAFTFRAESER D3", "endmill 3"},
      {mm, "T1 D6MM SHANK D3MM CUT ENDMILL", "endmill 3"},
      {mm, "T1 DIA 6 SHANK DIA 3 CUT ENDMILL", "endmill 3"},
      {mm, "T1 6MM SHANK 3MM CUT ENDMILL", "endmill 3"},
      {mm, "T1 6 SHANK 3 CUT ENDMILL", "endmill 3"},
      {mm, "T1 ENDMILL D6 SHANK 3 CUT", "endmill 3"},
      {mm, "T1 D6 SHANK D3 ENDMILL", both},
      {mm, "T1 D6 SHANK ENDMILL", "? gives no diameter"},
      {mm, "T1 ENDMILL D10 SHANK D12", "endmill 10"},
      {mm, "T1 ENDMILL D12 SHANK D10", "endmill 12"},
      {mm, "T1 D10 SHANK D12 ENDMILL", "endmill 10"},
      {mm, "T1 ENDMILL D6 SHANK 6 CUT LENGTH 13", "endmill 6"},
      {mm, "T1 ENDMILL D6 SHANK 8", "endmill 6"},
  });
}

TEST(ToolMixedSizes, AWidthInInchesMakesTheDiameterInches) {
  expect_readings({
      {mm, "T1 KEYSEAT CUTTER 1 X 1/8", "tslot 25.4, width 3.175"},
      {mm, "T1 KEYSEAT CUTTER DIA 1 WIDTH 1/8", "tslot 25.4, width 3.175"},
      {mm, "T1 T-SLOT 1.0 X 1/4", "tslot 25.4, width 6.35"},
      {mm, "T1 SAW 3 X 1/16", "tslot 76.2, width 1.5875"},
      {mm, "T1 WOODRUFF 1 1/4 X 1/8", "tslot 31.75, width 3.175"},
      {mm, "T1 DOVETAIL 1 X 1/4 60DEG", "form 25.4"},
      {inch, "T1 KEYSEAT CUTTER 1 X 1/8", "tslot 25.4, width 3.175"},
      {mm, "T1 SAW 63 X 1/16", "? gives the diameter 63 without a unit, beside a size in inches"},
      {mm, "T1 KEYSEAT CUTTER 1.0 X .125",
       "? gives the width 0.125 without a unit, in a program in mm"},
      {mm, "T1 T-SLOT 25MM X 1/4", "tslot 25, width 6.35"},
      {mm, "T1 T-SLOT 25 X 6", "tslot 25, width 6"},
  });
}

TEST(ToolMixedSizes, MillsForSlotsWithAWidthAreDiscs) {
  expect_readings({
      {mm, "T1 NUTENFRAESER D20 B4", "tslot 20, width 4"},
      {mm, "T1 NUTENFR~SER D20 BREITE 4", "tslot 20, width 4"},
      {mm, "T1 SCHLITZFRAESER D20 B4", "tslot 20, width 4"},
      {mm, "T1 FRAISE A RAINURER D20 B4", "tslot 20, width 4"},
      {mm, "T1 FRESA PARA RANURAR D20 W4", "tslot 20, width 4"},
      {mm, "T1 FRESA PER CAVE D20 B4", "tslot 20, width 4"},
      {mm, "T1 FREZ DO ROWKOW D20 B4", "tslot 20, width 4"},
      {mm, "T1 NUTENFRAESER D20", "endmill 20"},
      {mm, "T1 NUTENFRAESER D12 B14", "endmill 12"},
      {mm, "T1 SCHEIBENFRAESER D80 B6", "tslot 80, width 6"},
      {mm, "T1 FRAISE D12 RAINURE LARGEUR 8", "endmill 12"},
  });
}

TEST(ToolMixedSizes, D1OfAChamferMillIsItsTip) {
  const char* half = "? can be read as a tip of 8 or as another size of 8";
  expect_readings({
      {mm, "T1 CHAMFER MILL D16 D1=2 45DEG", "chamfer 16, side 45, tip 2"},
      {mm, "T1 D16 D1=2 90 DEG CHAMFER MILL", "chamfer 16, point 90, tip 2"},
      {mm, "T1 FASENFRAESER D1=2 D16 90 GRAD", "chamfer 16, point 90, tip 2"},
      {mm, "T1 16MM CHAMFER MILL D1=2 45DEG", "chamfer 16, side 45, tip 2"},
      {mm, "T1 CHAMFER MILL DIA 16 D1=2 45DEG", "chamfer 16, side 45, tip 2"},
      {mm, "T1 CHAMFER MILL D16 D1=8 45DEG", half},
      {mm, "T1 CHAMFER MILL D16 D2=8 45DEG", half},
      {mm, "T1 CHAMFER MILL D16 D2=16 45DEG", "chamfer 16, side 45"},
      {mm, "T1 ENDMILL D10 D1=5", "endmill 10"},
  });
}

}  // namespace
}  // namespace mrsim
