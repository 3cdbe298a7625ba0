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

}  // namespace
}  // namespace mrsim
