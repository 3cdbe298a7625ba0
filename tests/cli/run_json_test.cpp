// What a run tells programs: --json and --junit, the same keys whatever happens.
#include "run_program.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

class RunJson : public CliTest {
 protected:
  static constexpr const char* kCut = "PRIMER_2F.MPF --stock block.stl --voxel 5 -q ";
  Json parsed(const std::string& name) { return Json::parse(read(name), nullptr, false); }
  /// The run ends with `code`, and its JSON fits the schema and says so.
  Json told(const std::string& arguments, int code) {
    const Outcome o = run(arguments + " --json r.json --junit r.xml");
    EXPECT_EQ(o.code, code) << o.err;
    expect_valid("run", "r.json");
    const Json j = parsed("r.json");
    EXPECT_EQ(j["exit_code"], code);
    EXPECT_TRUE(contains(read("r.xml"), "<testsuites tests=\"4\"")) << read("r.xml");
    return j;
  }
};

TEST_F(RunJson, SaysWhatTheSummarySays) {
  const Json j = told(std::string(kCut) + "-o part.stl -o part.ply", 0);
  EXPECT_EQ(j["status"], "done");
  EXPECT_EQ(j["program"]["dialect"], "SINUMERIK");
  EXPECT_EQ(j["program"]["motions"]["arc"], 3);
  EXPECT_EQ(j["tools"][0]["diameter"], 5);
  EXPECT_EQ(j["voxel"]["value"], 5);
  ASSERT_EQ(j["outputs"].size(), 3u);  // the JUnit file, too; not the JSON itself
  EXPECT_EQ(j["outputs"][0]["path"], "part.stl");
  EXPECT_EQ(j["outputs"][0]["bytes"], read("part.stl").size());
  const std::string sum = j["outputs"][0]["sha256"];
  const std::string check =
      "cd '" + folder_.string() + "' && echo '" + sum + "  part.stl' | sha256sum -c --status";
  EXPECT_EQ(std::system(check.c_str()), 0) << sum;
}

// Not that of the script that started it.
TEST_F(RunJson, ThePeakOfMemoryIsOfTheRunAlone) {
  if (!kIsPlain) GTEST_SKIP();
  const std::string large = "cd '" + folder_.string() +
                            "' && python3 -c 'import subprocess, sys; held = b\"x\" * (400 << 20); "
                            "sys.exit(subprocess.call(sys.argv[1:]))' '" +
                            kProgram + "' " + kCut + "-o part.stl --json r.json";
  ASSERT_EQ(std::system(large.c_str()), 0);
  EXPECT_LT(parsed("r.json")["memory"]["peak"], 200e6);
}

// A case that was not tried has not passed.
TEST_F(RunJson, JUnitSkipsWhatWasNotTried) {
  const std::string none =
      "<testcase classname=\"mrsim.run\" name=\"comparison\"><skipped message=\"";
  told(std::string(kCut) + "-o part.stl", 0);
  EXPECT_TRUE(contains(read("r.xml"), "failures=\"0\" skipped=\"1\"")) << read("r.xml");
  EXPECT_TRUE(contains(read("r.xml"), none + "no nominal\"/>")) << read("r.xml");
  EXPECT_TRUE(contains(read("r.xml"), "name=\"collisions\"></testcase>")) << read("r.xml");
  write("bad.MPF", "T1 M6\nG1 X1.2.3\n");
  told("bad.MPF --machine mill --stock block.stl --nominal block.stl -q", 1);
  EXPECT_TRUE(contains(read("r.xml"), "failures=\"2\" skipped=\"2\"")) << read("r.xml");
  EXPECT_TRUE(contains(read("r.xml"), none + "the run ended before")) << read("r.xml");
  EXPECT_TRUE(contains(read("r.xml"), "name=\"collisions\"><skipped message=\"the run ended"))
      << read("r.xml");
}

// Those of the summary: a change of tools and the run-up of the spindle belong to no tool.
TEST_F(RunJson, TellsTheTimeOfEachTool) {
  write("two.nc",
        "G21 G90 G94\nT1 M6\nS2000 M3\nG0 X10 Y10 Z5\nG1 Z-2 F600\nG4 X2.\nX60\nG0 Z5\n"
        "T2 M6\nS3000 M3\nG0 X10 Y40\nG1 Z-2 F300\nX60\nG0 Z5\nM30\n");
  const Json j = told(
      "two.nc --dialect fanuc --machine mill --stock box:0,0,-9,70,50,0 "
      "--tool 1=endmill:d=8 --tool 2=endmill:d=6 --report r.html -q --voxel 1 --history off",
      0);
  const Json& cycle = j["program"]["cycle"];
  ASSERT_EQ(cycle["tools"].size(), 2u);
  EXPECT_EQ(cycle["tools"][1]["id"], "2");
  EXPECT_NEAR(cycle["tools"][0]["cutting"], 5.7, 0.1);   // 57 mm by 10 mm/s
  EXPECT_NEAR(cycle["tools"][1]["cutting"], 11.4, 0.1);  // by half of it
  EXPECT_EQ(cycle["tools"][0]["dwell"], 2.0);
  double sum = cycle["tool_change"].get<double>() + cycle["spindle"].get<double>();
  for (const Json& tool : cycle["tools"]) sum += tool["seconds"].get<double>();
  EXPECT_NEAR(cycle["seconds"], sum, 1e-9);
  EXPECT_EQ(cycle["seconds"], j["program"]["machine_seconds"]);
  EXPECT_TRUE(contains(read("r.html"), "\"Time of T2\""));
}

TEST_F(RunJson, TellsWhatAReductionCosts) {
  const Json j = told(std::string(kCut) + "--max-triangles 300 -o part.stl", 0);
  EXPECT_LE(j["mesh"]["triangles"], 300);
  EXPECT_GT(j["mesh"]["reduced"]["before"], 300);
  EXPECT_GE(j["mesh"]["reduced"]["distance"][1], j["mesh"]["reduced"]["distance"][0]);
}

TEST_F(RunJson, HoldsTheComparison) {
  const Json j = told(std::string(kCut) + "--nominal block.stl --accept 0.02", 4);
  EXPECT_EQ(j["status"], "rejected");
  EXPECT_EQ(j["comparison"]["verdict"], "rejected");
  EXPECT_TRUE(contains(read("r.xml"), "<failure"));
  write("c.json", j["comparison"].dump());
  expect_valid("compare", "c.json");
}

TEST_F(RunJson, HasTheSameKeysWhenTheRunFails) {
  const auto keys = [](const Json& j) {
    std::string out;
    for (const auto& [key, value] : j.items()) out += key + " ";
    return out;
  };
  const std::string all = keys(told(kCut, 0));
  const Json missing = told("missing.MPF --stock block.stl", 1);
  EXPECT_EQ(missing["error"]["code"], "file-missing");
  EXPECT_EQ(keys(missing), all);
  write("bad.MPF", "G54\nTRANS X0\nT1 M6\nG0 X0 Y0 Z5\nG1 X1.2.3\nM30\n");
  const Json bad = told("bad.MPF --machine mill --tool 1=endmill:d=5 -o part.stl", 1);
  EXPECT_EQ(keys(bad), all);
  EXPECT_FALSE(bad["diagnostics"].empty());
  EXPECT_TRUE(bad["outputs"].empty());
  EXPECT_GT(bad["memory"]["peak"], 1'000'000);
  EXPECT_FALSE(exists("part.stl"));
  // What is wrong before the run begins.
  write("tools.toml", "[[tool]]\nid = 4\ntype = \"endmill\"\ndiametr = 5\n");
  write("job.toml", "program = \"PRIMER_2F.MPF\"\nvoxl = 5\n");
  for (const auto& [arguments, code, error] :
       {std::tuple("PRIMER_2F.MPF --tools missing.toml", 1, "file-missing"),
        std::tuple("PRIMER_2F.MPF --tools tools.toml", 1, "tools-key"),
        std::tuple("job.toml", 1, "job-key"), std::tuple("gone.toml", 1, "file-missing"),
        std::tuple("PRIMER_2F.MPF --stok block.stl", 2, "usage"),
        std::tuple("PRIMER_2F.MPF --stock box:0,0", 2, "stock-spec"),
        std::tuple("PRIMER_2F.MPF --voxel 0", 2, "usage")}) {
    const Json j = told(arguments, code);
    EXPECT_EQ(keys(j), all) << arguments;
    EXPECT_EQ(j["error"]["code"], error) << arguments;
  }
  // An old part is no place for it, however the run ends.
  write("old.stl", "old");
  EXPECT_EQ(run("missing.MPF -o old.stl --json old.stl").code, 2);
  EXPECT_EQ(run("missing.MPF -o old.stl --voxel 0 --json old.stl").code, 2);
  EXPECT_EQ(run(std::string(kCut) + "--history old.json --json old.json").code, 2);
  EXPECT_EQ(read("old.stl"), "old");
  EXPECT_FALSE(exists("old.json"));
}

TEST_F(RunJson, StandsAloneOnTheStandardOutput) {
  const Outcome o = run("PRIMER_2F.MPF --stock block.stl --voxel 5 -o part.stl --json -");
  EXPECT_EQ(Json::parse(o.out, nullptr, false)["status"], "done") << o.out;
  const Outcome page =
      run("view PRIMER_2F.MPF --stock block.stl --voxel 5 -q --no-open --report p.html --json -");
  EXPECT_EQ(Json::parse(page.out, nullptr, false)["status"], "done") << page.out;
  EXPECT_TRUE(contains(page.err, "p.html"));
}

// 0 would be read as a mesh that is exact.
TEST_F(RunJson, WhatIsNotKnownIsNull) {
  const Json by_voxels = told(kCut, 0);
  EXPECT_TRUE(by_voxels["bound"]["distance"].is_null());
  EXPECT_TRUE(by_voxels["tolerance"]["value"].is_null());
  EXPECT_GT(by_voxels["volume"]["part"], 0);
  const Json exact = told("PRIMER_2F.MPF --stock block.stl --tolerance 0.1", 0);
  EXPECT_GT(exact["bound"]["distance"], 0);
  EXPECT_EQ(exact["tolerance"]["value"], 0.1);
  const Json missing = told("missing.MPF --stock block.stl", 1);
  for (const char* const key : {"voxel", "tolerance"})
    EXPECT_TRUE(missing[key]["value"].is_null()) << key;
  EXPECT_TRUE(missing["volume"]["part"].is_null());
  EXPECT_TRUE(missing["volume"]["removed"].is_null());
}

TEST_F(RunJson, OtherCommandsFitTheirSchemas) {
  write("t.json", run("trace PRIMER_2F.MPF --json").out);
  expect_valid("trace", "t.json", true);
  write("c.json", run("check PRIMER_2S.MPF --json").out);
  expect_valid("check", "c.json", true);
  ASSERT_EQ(run("compare block.stl block.stl --accept 0.02 --json x.json").code, 0);
  expect_valid("compare", "x.json");
}

// The same keys as when they do not fail.
TEST_F(RunJson, OtherCommandsTellTheirFailures) {
  const auto keys = [](const Json& j) {
    std::string out;
    for (const auto& [key, value] : j.items()) out += key + " ";
    return out;
  };
  ASSERT_EQ(run("compare block.stl block.stl --density 1 --json compare.json").code, 0);
  ASSERT_EQ(run("rest block.stl block.stl --voxel 2 --json rest.json").code, 0);
  for (const std::string command : {"compare", "rest"})
    for (const auto& [rest, code, error] :
         {std::tuple(" block.stl missing.stl", 1, "file-missing"),
          std::tuple(" block.stl", 2, "usage"),
          std::tuple(" block.stl block.stl --unknown", 2, "usage"),
          std::tuple(" block.stl block.stl --deflection x", 2, "usage"),
          std::tuple(" block.stl block.stl --deflection", 2, "usage")}) {
      EXPECT_EQ(run(command + " --json x.json" + rest).code, code) << command << rest;
      expect_valid(command, "x.json");
      const Json told = parsed("x.json");
      EXPECT_EQ(told["error"]["code"], error) << command << rest;
      EXPECT_EQ(keys(told), keys(parsed(command + ".json"))) << command << rest;
      std::filesystem::remove(folder_ / "x.json");
    }
  write("tools.toml", "[[tool]]\nid = 4\ntype = \"endmill\"\ndiametr = 5\n");
  for (const std::string command : {"check", "trace"})
    for (const auto& [rest, error] :
         {std::pair("missing.MPF", "file-missing"), std::pair("PRIMER_2F.MPF --start x", "usage"),
          std::pair("PRIMER_2F.MPF --start", "usage"),
          std::pair("PRIMER_2F.MPF --tools tools.toml", "tools-key")}) {
      write("x.json", run(command + " --json " + rest).out);
      expect_valid(command, "x.json", true);
      EXPECT_TRUE(contains(read("x.json"), error)) << command << rest << read("x.json");
    }
  EXPECT_TRUE(contains(run("tools --json tools.toml").out, "tools-key"));
}

// Where the last option has no value.
TEST_F(RunJson, TellsWordsThatDoNotParse) {
  EXPECT_EQ(run("PRIMER_2F.MPF --json r.json --junit=r.xml --voxel").code, 2);
  expect_valid("run", "r.json");
  EXPECT_EQ(parsed("r.json")["error"]["code"], "usage");
  EXPECT_TRUE(contains(read("r.xml"), "<failure"));
  EXPECT_EQ(run("PRIMER_2F.MPF --voxel= --json s.json").code, 2);
  expect_valid("run", "s.json");
}

TEST_F(RunJson, OptionsOfAComparisonNeedANominal) {
  for (const char* option : {"--deviation d.ply", "--align icp", "--density 3", "--colors safe"}) {
    const Outcome o = run(std::string(kCut) + option);
    EXPECT_EQ(o.code, 2) << option;
    EXPECT_TRUE(contains(o.err, "--nominal")) << o.err;
  }
}

TEST_F(RunJson, OptionsThatDoNothingSaySo) {
  const std::string cut = kCut, talking = cut.substr(0, cut.find(" -q")) + " ";
  const std::string idle =
      run(talking +
          "--color line -o part.stl --colors safe --deflection 0.1 --nominal block.stl "
          "--tool 9=endmill:d=3 --least-increments")
          .err;
  for (const char* said :
       {"--color does nothing", "--colors does nothing", "--deflection does nothing",
        "--tool 9: the program moves no tool", "[least-increments]"})
    EXPECT_TRUE(contains(idle, said)) << said << idle;
  EXPECT_TRUE(contains(run("PRIMER_2F.MPF --voxel 5 --stock-repair wrap=0.1").err,
                       "--stock-repair does nothing"));
  EXPECT_TRUE(contains(run("compare block.stl block.stl --density 1 --colors safe").err,
                       "--colors does nothing"));
  EXPECT_TRUE(contains(run("rest block.stl block.stl --voxel 2 --deflection 1").err,
                       "--deflection does nothing"));
  const Outcome used =
      run(talking +
          "--color line -o part.ply --colors safe --nominal block.stl --deviation d.ply "
          "--tool 04=endmill:d=5");
  EXPECT_EQ(used.code, 0) << used.err;
  EXPECT_FALSE(contains(used.err, "does nothing")) << used.err;
  EXPECT_FALSE(contains(used.err, "tool-unused")) << used.err;
}

TEST_F(RunJson, ACoarseToleranceIsAWarningLikeOthers) {
  const std::string coarse =
      "PRIMER_2F.MPF --stock block.stl --tolerance 0.1 --nominal block.stl --accept 0.02";
  EXPECT_TRUE(contains(run(coarse).err, "[tolerance-coarse]"));
  EXPECT_EQ(run(coarse + " -q").err, "");
  EXPECT_EQ(run(coarse + " --strict").code, 1);
}

// A mesh on voxels has no tolerance, and a reduced one leaves its own.
TEST_F(RunJson, ACoarseMeshIsOneToo) {
  const std::string cut = "PRIMER_2F.MPF --stock block.stl --nominal block.stl --accept 0.02 ";
  EXPECT_TRUE(contains(run(cut + "--voxel 1").err, "[tolerance-coarse]"));
  EXPECT_TRUE(contains(run(cut + "--max-triangles 300").err, "[tolerance-coarse]"));
  EXPECT_FALSE(contains(run(cut + "--voxel 0.2").err, "[tolerance-coarse]"));
  EXPECT_FALSE(contains(run(cut).err, "[tolerance-coarse]"));
}

TEST_F(RunJson, RefusalsSayWhatIsWrong) {
  EXPECT_TRUE(contains(run(std::string(kCut) + "--threads 4096").err, "too many threads"));
  EXPECT_TRUE(contains(run("PRIMER_2F.MPF --tolerance 1e9").err, "too large"));
}

}  // namespace
}  // namespace mrsim
