// What a run chooses where neither --voxel nor --tolerance is given.
#include "run_program.h"

#include <nlohmann/json.hpp>

namespace mrsim {
namespace {

using Json = nlohmann::json;

class Defaults : public CliTest {
 protected:
  /// The JSON of a run whose only cut is a groove of 0.2 mm by `tool`.
  Json groove(const std::string& tool, const std::string& rest = "") {
    write("groove.nc",
          "G21 G90\nT1 M6\nS9000 M3\nG0 X10 Y10 Z2\nG1 Z-.2 F100\nX30 Y17 F400\nG0 Z2\n");
    const Outcome o = run("groove.nc --stock box:0,0,-10,40,30,0 --tool 1=" + tool +
                          " -q -o part.stl --json r.json " + rest);
    EXPECT_EQ(o.code, 0) << o.err;
    return Json::parse(read("r.json"));
  }
};

TEST_F(Defaults, VoxelSuitsTheRadiusWithWhichAToolCuts) {
  EXPECT_EQ(groove("endmill:d=6")["voxel"]["value"], 0.1);
  EXPECT_EQ(groove("chamfer:d=6,a=90")["voxel"]["value"], 0.025);  // an eighth of 0.2 mm
  EXPECT_EQ(groove("ballmill:d=6")["voxel"]["value"], 0.1);
}

TEST_F(Defaults, GrooveOfAVBitHasItsVolume) {
  // A prism of 0.2 mm by 0.4, its ends halves of a cone.
  const Json j = groove("chamfer:d=6,a=90");
  const double length = 21.1896201, pi = 3.14159265;
  EXPECT_NEAR(j["volume"]["removed"], 0.04 * length + pi * 0.008 / 3, 5e-4);
}

TEST_F(Defaults, ToleranceThatIsGivenIsKept) {
  const Json j = groove("chamfer:d=6,a=90", "--tolerance 0.004");
  EXPECT_EQ(j["tolerance"]["value"], 0.004);
}

}  // namespace
}  // namespace mrsim
