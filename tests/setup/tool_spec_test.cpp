#include "setup/tool_spec.h"

#include "core/numbers/units.h"
#include "support/error_code.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

std::string fault(const std::string& spec) {
  return testing::usage_fault("tool-spec", [&] { parse_tool_spec(spec); });
}

TEST(ToolSpec, ReadsNumberTypeAndKeys) {
  const Tool tool = parse_tool_spec("4=endmill:d=5");
  EXPECT_EQ(tool.id, "4");
  EXPECT_EQ(tool.type, ToolType::endmill);
  EXPECT_EQ(tool.diameter, 5);
  EXPECT_EQ(tool.origin, "--tool");
  EXPECT_EQ(parse_tool_spec("T12=ballmill:d=6").id, "12");
  EXPECT_EQ(parse_tool_spec("ENDMILL_5=endmill:d=5").id, "ENDMILL_5");
}

TEST(ToolSpec, LengthsMayHaveTheirUnit) {
  EXPECT_EQ(parse_tool_spec("endmill:d=6.35mm").diameter, 6.35);
  EXPECT_EQ(parse_tool_spec("endmill:d=0.25in").diameter, 6.35);
  EXPECT_EQ(parse_tool_spec("endmill:d=.25 inch").diameter, 6.35);
  EXPECT_EQ(parse_tool_spec("endmill:d=1/4\"").diameter, 6.35);
  EXPECT_EQ(parse_tool_spec("bullmill:d=1/2in,r=1/16in,l=30").corner_radius, 25.4 / 16);
  for (const char* wrong :
       {"endmill:d=1/4", "endmill:d=1/0in", "endmill:d=in", "endmill:d=5cm", "drill:d=5,a=118in"})
    EXPECT_NE(fault(wrong).find("is not a number"), std::string::npos) << wrong;
}

TEST(ToolSpec, WithoutNumberIsTheToolOfAProgramThatNamesNone) {
  const Tool tool = parse_tool_spec("bullmill: d = 10, r = 1.5 , l=20");
  EXPECT_EQ(tool.id, "");
  EXPECT_EQ(tool.corner_radius, 1.5);
  EXPECT_EQ(tool.flute_length, 20);
}

TEST(ToolSpec, MillsHaveShortNames) {
  EXPECT_EQ(parse_tool_spec("1=flat:d=6").type, ToolType::endmill);
  EXPECT_EQ(parse_tool_spec("1=ball:d=6").type, ToolType::ballmill);
  EXPECT_EQ(parse_tool_spec("1=bull:d=6,r=1").type, ToolType::bullmill);
}

TEST(ToolSpec, SharpTaperIsNoFlatOne) {
  EXPECT_NE(fault("taper:d=8,a=30,t=0").find("is of type chamfer, with diameter and taper_angle"),
            std::string::npos);
}

TEST(ToolSpec, AngleIsTheOneTheToolHas) {
  EXPECT_NEAR(parse_tool_spec("drill:d=8,a=118").tip_angle, radians(118), 1e-15);
  EXPECT_NEAR(parse_tool_spec("taper:d=8,a=3").taper_angle, radians(3), 1e-15);
  EXPECT_NEAR(parse_tool_spec("chamfer:d=8,a=90").tip_angle, radians(90), 1e-15);
  EXPECT_NEAR(parse_tool_spec("turning:a=95,r=0.4").lead_angle, radians(95), 1e-15);
}

TEST(ToolSpec, ReadsInserts) {
  const Tool tool = parse_tool_spec("2=turning:insert=VNMG,hand=left,tip=3,r=0.4");
  EXPECT_EQ(tool.insert, "VNMG");
  EXPECT_TRUE(tool.left_hand);
  EXPECT_EQ(tool.tip, 3);
  EXPECT_EQ(tool.nose_radius, 0.4);
}

TEST(ToolSpec, RoundInsertsHaveADiameter) {
  EXPECT_EQ(parse_tool_spec("1=turning:insert=RCMT,d=8").diameter, 8);
  EXPECT_NE(fault("1=turning:insert=VNMG,d=8").find("round insert"), std::string::npos);
  EXPECT_NE(fault("1=turning:d=8").find("round insert"), std::string::npos);
}

TEST(ToolSpec, BarrelsHaveATipDiameter) {
  EXPECT_EQ(parse_tool_spec("1=barrel:d=8,p=20,t=2").tip_diameter, 2);
}

TEST(ToolSpec, SaysWhatIsWrong) {
  EXPECT_NE(fault("4=endmil:d=5").find("did you mean \"endmill\""), std::string::npos);
  EXPECT_NE(fault("4=endmill").find("needs a diameter"), std::string::npos);
  EXPECT_NE(fault("4=endmill:diametre=5").find("did you mean \"diameter\""), std::string::npos);
  EXPECT_NE(fault("4=chamfer:d=3,tip=0.1")
                .find("(a tool of type chamfer has: d or diameter, r or corner_radius, "
                      "l or flute_length, taper_angle, a or tip_angle, t or tip_diameter)"),
            std::string::npos);
  EXPECT_NE(fault("4=endmill:d=five").find("not a number"), std::string::npos);
  EXPECT_NE(fault("4=endmill:d=nan").find("not a number"), std::string::npos);
  EXPECT_NE(fault("4=endmill:d=-5").find("must be between"), std::string::npos);
  EXPECT_NE(fault("4=endmill:d").find("key=value"), std::string::npos);
  EXPECT_NE(fault("4=endmill:d=5,r=3").find("larger than"), std::string::npos);
  EXPECT_NE(fault("4=endmill:d=5,lead_angle=3").find("has none"), std::string::npos);
  EXPECT_NE(fault("=endmill:d=5").find("missing"), std::string::npos);
  EXPECT_NE(fault("").find("unknown type"), std::string::npos);
  EXPECT_NE(fault("turning:tip=10").find("1 to 9"), std::string::npos);
}

}  // namespace
}  // namespace mrsim
