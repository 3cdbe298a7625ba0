// Files beside a SINUMERIK program that have the name of one of the control's own cycles.
#include "interp/support.h"

#include <map>

namespace mrsim {
namespace {

using namespace mrsim::testing;

const char* const kDrills = "G71 G90 F100\nG0 X5\nCYCLE81(10,0,2,-5)\nM30\n";

Program beside(const std::string& main, const std::map<std::string, std::string>& files,
               const std::string& name = "MAIN.MPF") {
  const TempFolder scratch;
  for (const auto& [file, text] : files) scratch.write(file, text);
  return read_program(scratch.write(name, main), at_origin(Dialect::sinumerik));
}

std::string noted(const Program& program) {
  std::string out;
  for (const Diagnostic& d : program.diagnostics)
    if (d.code == "cycle-file") out += d.text + "\n";
  return out;
}

// The machine builder's cycle begins with PROC and the cycle's name.
TEST(CycleFiles, OnlyAFileWithProcOfThatNameReplacesACycle) {
  const std::string own = path_text(beside(kDrills, {}));
  const Program replaced = beside(
      kDrills,
      {{"CYCLE81.SPF",
        "; maker's own\nN1 ; 81\nN2;\nN3\nN10 PROC CYCLE81(REAL RTP,REAL RFP,REAL SDIS,REAL DP)\n"
        "G1 Z=DP\nRET\n"}});
  EXPECT_EQ(path_text(replaced), "r5,0,0 l5,0,-5");
  EXPECT_NE(noted(replaced).find("CYCLE81.SPF, which begins with PROC CYCLE81"), std::string::npos)
      << noted(replaced);
  for (const char* text : {"G1 Z-7\nM17\n", "PROC OTHER(REAL A)\nG1 Z-7\nRET\n", ""}) {
    const Program kept = beside(kDrills, {{"CYCLE81.MPF", text}});
    EXPECT_EQ(path_text(kept), own) << text;
    EXPECT_NE(noted(kept).find("CYCLE81.MPF: only a file that begins with PROC CYCLE81"),
              std::string::npos)
        << noted(kept);
  }
}

TEST(CycleFiles, AProgramWithoutProcRunsInPlaceOfNoCall) {
  const std::map<std::string, std::string> files = {{"cycle800.mpf", "G1 Z-7 F100\nM17\n"},
                                                    {"msg.spf", "G1 Z-7 F100\nM17\n"}};
  EXPECT_EQ(path_text(beside("G71 G90\nCYCLE800()\nMSG()\nG1 X5 F9\nM30\n", files)), "l5,0,0");
  const std::string modal = "G71 G90 F100\nMCALL CYCLE81(10,0,2,-5)\nG0 X5\nMCALL\nM30\n";
  EXPECT_EQ(path_text(beside(modal, {{"CYCLE81.MPF", "Z-7\nM17\n"}})),
            path_text(beside(modal, {})));
}

TEST(CycleFiles, TheMainProgramIsNeverItsOwnCycle) {
  const std::string own = path_text(beside(kDrills, {}));
  EXPECT_EQ(path_text(beside(kDrills, {}, "CYCLE81.MPF")), own);
  EXPECT_EQ(noted(beside(kDrills, {}, "CYCLE81.MPF")), "");
  EXPECT_EQ(path_text(beside(std::string("PROC CYCLE81\n") + kDrills, {}, "cycle81.mpf")), own);
  EXPECT_EQ(path_text(beside(std::string("%_N_CYCLE81_MPF\n") + kDrills, {})), own);
  EXPECT_EQ(path_text(beside(kDrills,
                             {{"CYCLE81.SPF",
                               "PROC CYCLE81(REAL A,REAL B,REAL C,REAL D)\n"
                               "G1 Z=D\nRET\n"}},
                             "CYCLE81.MPF")),
            "r5,0,0 l5,0,-5");
  EXPECT_EQ(codes(beside("G71 G90\nCYCLE64(1)\nM30\n", {}, "CYCLE64.MPF"), Severity::error),
            "not-supported");
}

// A cycle that is not read can be a file, with or without PROC.
TEST(CycleFiles, CyclesThatAreNotReadMayBeFiles) {
  EXPECT_EQ(path_text(beside("G71 G90\nCYCLE64()\nM30\n", {{"CYCLE64.SPF", "G1 X5 F9\nM17\n"}})),
            "l5,0,0");
}

TEST(CycleFiles, AWrongNumberOfValuesNamesTheFile) {
  const auto fault = [](const std::string& sub) {
    for (const Diagnostic& d : beside("SUB(1,2)\nM30\n", {{"SUB.SPF", sub}}).diagnostics)
      if (d.code == "call-arguments")
        return d.text.substr(0, 14) + d.text.substr(d.text.find("SUB"));
    return std::string();
  };
  EXPECT_EQ(fault("M17\n"),
            "2 arguments foSUB.SPF, which has no PROC that takes them (alarm 12340)");
  EXPECT_EQ(fault("PROC SUB(REAL A)\nM17\n"),
            "2 arguments foSUB.SPF, which has PROC with 1 parameter (alarm 12340)");
}

}  // namespace
}  // namespace mrsim
