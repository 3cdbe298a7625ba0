// The limits of docs/limits.md, as a user meets them.
#include "run_program.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

class Limits : public CliTest {
 protected:
  // A raster of many short lines, so that files of its mesh are large.
  void write_raster(int moves) {
    std::string text = "G54 G17 G90\nT1 M6\nG0 X0 Y0 Z9\n";
    for (int i = 0; i < moves; ++i)
      text += "G1 X" + std::to_string(i % 100) + " Y" + std::to_string(i / 100 % 100) + " Z-" +
              std::to_string(1 + i % 7 * 0.1) + " F500\n";
    write("raster.MPF", text + "G0 Z9\nM30\n");
  }
};

TEST_F(Limits, FilesThatNeverEndAreRefused) {
  std::filesystem::create_symlink("/dev/zero", folder_ / "zero.stl");
  std::filesystem::create_symlink("/dev/zero", folder_ / "zero.MPF");
  expect_failure("PRIMER_2F.MPF --stock zero.stl -o part.stl", 1, "[file-too-large]");
  expect_failure("zero.MPF --stock block.stl -o part.stl", 1, "[file-too-large]");
  expect_failure("compare zero.stl block.stl", 1, "[file-too-large]");
}

// Each part of a key is a table in the next one, freed by recursion.
TEST_F(Limits, KeysOfManyPartsAreRefusedAtTheirLine) {
  std::string key = "a";
  for (int i = 0; i < 100000; ++i) key += ".a";
  for (const std::string& text : {key + " = 1\n", "[" + key + "]\n", "b = { " + key + " = 1 }\n"}) {
    write("deep.toml", "# many\n" + text);
    for (const char* arguments : {"PRIMER_2F.MPF --stock block.stl --tools deep.toml", "deep.toml",
                                  "PRIMER_2F.MPF --stock block.stl --machine-file deep.toml"})
      expect_failure(arguments, 1, "deep.toml:2:");
  }
  write("fine.toml",
        "[[tool]]\nid = \"4\"\ntype = \"form\"\nprofile = [[0.0, 0.0], [1.5, 0.0], "
        "[1.6, 0.1], [1.7, 0.2], [1.8, 0.3], [1.9, 0.4], [2.0, 0.5], [2.1, 0.6], "
        "[2.2, 0.7], [2.5, 8.0]]  # 1.2.3.4.5.6.7.8.9.0.1.2.3.4.5.6.7.8.9\n"
        "name = \"a.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p.q.r\"\n");
  EXPECT_FALSE(contains(run("tools fine.toml").err, "16 parts"));
}

TEST_F(Limits, ADamagedProgramGetsFewMessages) {
  write("flood.MPF", std::string(200000, '!') + "\n");
  const Outcome outcome = run("flood.MPF --machine mill --stock block.stl -o part.stl");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_LT(outcome.err.size(), 100000U);
  EXPECT_TRUE(contains(outcome.err, "more of these")) << outcome.err.substr(0, 2000);
}

TEST_F(Limits, DensitiesBeyondTheSamplesAreWrongUsage) {
  const Outcome dense = run("compare block.stl block.stl --density 1e300");
  EXPECT_EQ(dense.code, 2) << dense.err;
  EXPECT_TRUE(contains(dense.err, "[density-too-large]")) << dense.err;
  EXPECT_TRUE(contains(dense.err, "at most 5000000")) << dense.err;
}

TEST_F(Limits, MeshesTooFarAwayAreRefused) {
  std::string far = read("block.stl");
  const float coordinate = 1e38F;
  far.replace(96, 4, std::string(reinterpret_cast<const char*>(&coordinate), 4));
  write("far.stl", far);
  for (const char* arguments : {"compare far.stl block.stl", "compare block.stl far.stl",
                                "PRIMER_2F.MPF --stock far.stl -o part.stl"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 1) << arguments << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "[stl-too-far]")) << arguments << outcome.err;
  }
}

TEST_F(Limits, AComparisonBeyondTheMemoryIsRefused) {
  const Outcome small = run("compare block.stl block.stl --max-memory 20M");
  EXPECT_EQ(small.code, 1) << small.err;
  EXPECT_TRUE(contains(small.err, "[memory]")) << small.err;
}

// What is read before and beside motions: tables of tools, long lines, comments, many tools.
TEST_F(Limits, ToolsAndTextBeyondTheMemoryAreRefused) {
  if (!kIsPlain) GTEST_SKIP();
  std::filesystem::create_symlink("/dev/zero", folder_ / "zero.toml");
  const std::string cut = "G1 X9 Y9 Z-1 F500\n",
                    stock = " --stock block.stl -o part.stl --max-memory ";
  expect_failure("PRIMER_2F.MPF --tools zero.toml" + stock + "60M", 1, "[memory]");
  write("long.MPF", "G1 X" + std::string(20'000'000, '1') + "\n");
  expect_failure("long.MPF --machine mill" + stock + "60M", 1, "[memory]");
  std::string comments = "G17 G90\n", program = "G17 G90\n", tools;
  for (int i = 1; i < 40000; ++i) comments += "(TOOL " + std::to_string(i) + " D=5 ENDMILL)\n";
  write("comments.nc", comments + "T1 M6\nG0 X0 Y0 Z9\n" + cut + "M30\n");
  expect_failure("comments.nc --dialect fanuc" + stock + "30M", 1, "comments about tools");
  for (int i = 1; i < 5000; ++i) {
    program += "T" + std::to_string(i) + " M6\nG0 Z9\n" + cut;
    tools += "[[tool]]\nid = " + std::to_string(i) + "\ntype = \"endmill\"\ndiameter = 5\n";
  }
  write("many.nc", program + "M30\n");
  write("many.toml", tools);
  expect_failure("many.nc --dialect fanuc --tools many.toml" + stock + "50M", 1, "4999 tools");
}

// Commands that read a file without running its program.
TEST_F(Limits, EachCommandIsRefusedBeyondTheMemory) {
  if (!kIsPlain) GTEST_SKIP();
  const Outcome large = run("render block.stl -o a.png --size 1600x1200 --max-memory 100M");
  EXPECT_EQ(large.code, 1) << large.err;
  EXPECT_TRUE(contains(large.err, "a smaller --size")) << large.err;
  EXPECT_FALSE(exists("a.png"));
  EXPECT_EQ(run("render block.stl -o a.png --size 320x240 --max-memory 100M").code, 0);
  const Outcome page = run("view block.stl --no-open --max-memory 20M", "mkdir t; TMPDIR=$PWD/t");
  EXPECT_EQ(page.code, 1) << page.err;
  EXPECT_TRUE(contains(page.err, "[memory]")) << page.err;
  write_raster(60000);
  write("long.MPF", "G1 X" + std::string(20'000'000, '1') + "\n");
  write("tools.toml", "# " + std::string(30'000'000, 'x') + "\n");
  for (const char* command : {"trace raster.MPF --tool ballmill:d=6 -q -o a.svg",
                              "check long.MPF --machine mill", "tools tools.toml"}) {
    const Outcome outcome = run(std::string(command) + " --max-memory 20M");
    EXPECT_EQ(outcome.code, 1) << command << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "[memory]")) << command << outcome.err;
  }
}

TEST_F(Limits, ReadingPastTheMemoryIsRefused) {
  write_raster(60000);
  expect_failure(
      "raster.MPF --stock box:0,0,-8,100,100,0 --tool ballmill:d=6 -o part.stl "
      "--max-memory 20M",
      1, "[memory]");
}

}  // namespace
}  // namespace mrsim
