// Bad input: a clear error, the right exit code, and no output file.
#include "run_program.h"

#include <cstdint>
#include <cstring>

#include <sys/stat.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

class BadInput : public CliTest {
 protected:
  void expect_bad_stock(const std::string& text) {
    expect_failure("PRIMER_2F.MPF --stock bad.stl -o part.stl", 1, text);
  }
};

TEST_F(BadInput, ProgramThatCannotBeReadOrCutsNothing) {
  expect_failure("missing.MPF --stock block.stl -o part.stl", 1, "no such file");
  expect_failure(". --stock block.stl -o part.stl", 1, "is a directory");
  write("empty.MPF", "");
  expect_failure("empty.MPF --stock block.stl -o part.stl", 1, "empty");
  write("nocuts.MPF",
        "G54\nTRANS X0 Y0\nT4 D1 M6; Steblasto frezalo \xC3\x98"
        "5\nG0 X0 Y0 Z5\nM30\n");
  expect_failure("nocuts.MPF --machine mill --stock block.stl -o part.stl", 1, "cuts nothing");
  write("error.MPF", "G54\nTRANS X0\nT4 M6\nG0 X0 Y0 Z5\nG1 Z-1 F100\nG1 X12.3.4\nM30\n");
  expect_failure("error.MPF --tool 4=endmill:d=5 --stock block.stl -o part.stl", 1, "error.MPF:6:");
}

// A pipe gives its text once. What would read it again says so and does not wait.
TEST_F(BadInput, PipesThatAreReadTwice) {
  for (const char* name : {"pipe.stl", "pipe.step"})
    ASSERT_EQ(::mkfifo((folder_ / name).c_str(), 0600), 0);
  const std::string filled = "{ cat block.stl > pipe.stl & } && timeout 30";
  const Outcome once = run("PRIMER_2F.MPF --stock pipe.stl --voxel 2 -o part.stl", filled);
  EXPECT_EQ(once.code, 0) << once.err;
  std::filesystem::remove(folder_ / "part.stl");
  for (const char* arguments : {"PRIMER_2F.MPF --stock pipe.stl --voxel 2 -o part.stl --frames 2",
                                "compare pipe.stl pipe.stl"}) {
    const Outcome outcome = run(arguments, filled);
    EXPECT_EQ(outcome.code, 1) << arguments;
    EXPECT_TRUE(contains(outcome.err, "[file-read-once]")) << outcome.err;
  }
  const Outcome step = run("compare pipe.step block.stl", "timeout 30");
  EXPECT_EQ(step.code, 1);
  EXPECT_TRUE(contains(step.err, "store the model in a file")) << step.err;
}

TEST_F(BadInput, SimdLevelThatDoesNotExist) {
  const auto run_with = [this](const char* level) {
    ::setenv("MRSIM_SIMD", level, 1);
    const Outcome outcome = run("PRIMER_2F.MPF --stock block.stl --voxel 1 -o part.stl");
    ::unsetenv("MRSIM_SIMD");
    return outcome;
  };
  for (const char* level : {"avx", "AVX2", "none"}) {
    const Outcome outcome = run_with(level);
    EXPECT_EQ(outcome.code, 2) << level << outcome.err;
    EXPECT_NE(outcome.err.find("none of scalar, avx2 and avx512"), std::string::npos)
        << outcome.err;
    EXPECT_NE(outcome.err.find("[simd-unknown]"), std::string::npos) << outcome.err;
    EXPECT_FALSE(exists("part.stl"));
  }
  for (const char* level : {"", "scalar", "avx2", "avx512"})
    EXPECT_EQ(run_with(level).code, 0) << level;
}

TEST_F(BadInput, ToolsThatAreNotKnownAreRefused) {
  write("tool.MPF",
        "G54\nTRANS X50 Y-30 Z10\nT9 M6\nS3200 F200 M3\nG0 X0 Y0 Z5\nG1 Z-2\nG1 X10\nM30\n");
  expect_failure("tool.MPF --stock block.stl -o part.stl", 1, "tool 9");
  expect_failure("PRIMER_2F.MPF --tool 4=endmil:d=5 -o part.stl", 2, "did you mean \"endmill\"");
  write("tools.toml", "[[tool]]\nid = 4\ntype = \"endmill\"\ndiametr = 5\n");
  expect_failure("PRIMER_2F.MPF --tools tools.toml -o part.stl", 1, "tools.toml:4:1: error:");
  expect_failure("PRIMER_2F.MPF --tools missing.toml -o part.stl", 1, "no such file");
}

TEST_F(BadInput, BadStlFilesAreRefused) {
  const std::string block = read("block.stl");
  write("bad.stl", block.substr(0, block.size() - 25));
  expect_bad_stock("bad.stl");
  write("bad.stl", block.substr(0, 50));
  expect_bad_stock("bad.stl");
  write("bad.stl", "");
  expect_bad_stock("empty");
}

TEST_F(BadInput, StlThatClaimsMoreThanItHas) {
  std::string block = read("block.stl");
  const std::uint32_t count = 4000000000u;
  std::memcpy(block.data() + 80, &count, 4);
  write("bad.stl", block);
  expect_bad_stock("4000000000");
}

TEST_F(BadInput, AnStlIsReadByItsContentNotItsFirstWord) {
  std::string block = read("block.stl");
  std::memcpy(block.data(), "solid block", 11);  // binary all the same, and read as such
  write("solid.stl", block);
  EXPECT_EQ(run("PRIMER_2F.MPF --stock solid.stl --voxel 1 -o good.stl").code, 0);
  write("bad.stl", "solid block\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n");
  expect_bad_stock("bad.stl");
  write("bad.stl", "solid block\nendsolid block\n");
  expect_bad_stock("bad.stl");
}

TEST_F(BadInput, StlThatIsNoSolid) {
  std::string block = read("block.stl");
  std::string open = block.substr(0, block.size() - 50);
  const std::uint32_t count = 11;
  std::memcpy(open.data() + 80, &count, 4);
  write("bad.stl", open);
  expect_bad_stock("open edge");
}

// What welds away, and sizes beyond any machine.
TEST_F(BadInput, AStockOfSliversIsRefused) {
  const std::string faces = "f 1 2 3\nf 1 3 2\n";
  for (const std::string points :
       {"v 0 0 0\nv 10 0 0\nv 1e-6 1e-6 0\n", "v 1000 0 0\nv 1000.0003 0 0\nv 1000 0.0003 0\n",
        "v 0 0 0\nv 1e9 0 0\nv 0 10 0\n"}) {
    write("bad.obj", points + faces);
    expect_failure("PRIMER_2F.MPF --stock bad.obj -o part.stl", 1, "bad.obj");
    write("bad.obj", points + "f 1 2 3\n");
    expect_failure("PRIMER_2F.MPF --stock bad.obj -o part.stl", 1, "bad.obj");
  }
}

TEST_F(BadInput, RunsThatFitNeedNoTemporaryFolder) {
  EXPECT_EQ(
      run("PRIMER_2F.MPF --stock block.stl -q --voxel 1 -o part.stl", "TMPDIR=/nonexistent").code,
      0);
  EXPECT_EQ(
      run("PRIMER_2F.MPF --stock block.stl -q --voxel 1 --report /dev/null", "TMPDIR=/nonexistent")
          .code,
      0);
}

TEST_F(BadInput, OutputThatCannotBeWritten) {
  expect_failure("PRIMER_2F.MPF --stock block.stl -o missing/part.stl", 1, "does not exist");
  std::filesystem::create_symlink("gone/part.stl", folder_ / "link.stl");
  expect_failure("PRIMER_2F.MPF --stock block.stl -o link.stl", 1, "gone does not exist");
  expect_failure("PRIMER_2F.MPF --stock block.stl -o /proc/part.stl", 1, "cannot write");
  expect_failure("PRIMER_2F.MPF --stock block.stl -o part.stp", 2, "part.stp");
  expect_failure("PRIMER_2F.MPF --stock block.stl -o part", 2, ".stl");
  expect_failure("PRIMER_2F.MPF --stock block.stl -o part.stl -o ./part.stl", 2, "twice");
  const std::string both = "PRIMER_2F.MPF --stock block.stl --voxel 2 --json - --junit ";
  for (const char* place : {"-", "/dev/stdout", "/proc/self/fd/1"})  // one behind the other
    expect_failure(both + place, 2, "twice");
  EXPECT_EQ(
      run("PRIMER_2F.MPF --stock block.stl --voxel 2 --json /dev/null --junit /dev/null").code, 0);
  std::filesystem::create_directory(folder_ / "closed");
  std::filesystem::permissions(
      folder_ / "closed", std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  if (::geteuid() != 0)
    expect_failure("PRIMER_2F.MPF --stock block.stl -o closed/part.stl", 1, "cannot write");
}

TEST_F(BadInput, OutputThatIsTooLarge) {
  for (const char* name : {"p.stl", "p.ply", "p.obj", "p.off", "p.3mf", "p.glb", "p.vdb"}) {
    const Outcome outcome =
        run("PRIMER_2F.MPF --stock block.stl --voxel 0.5 -q -o " + std::string(name),
            "ulimit -f 20 &&");
    EXPECT_EQ(outcome.code, 1) << name;
    EXPECT_TRUE(contains(outcome.err, "cannot write " + std::string(name) + ": File too large"))
        << outcome.err;
    EXPECT_FALSE(exists(name));
  }
}

// What cannot be printed is an error; closed streams leave their numbers to no file of the run, and
// nobody who hears no note stops it.
TEST_F(BadInput, WhatCannotBePrintedIsAnError) {
  const auto with = [](const char* streams) {
    return std::string("sh -c '\"$0\" \"$@\" ") + streams + "'";
  };
  std::filesystem::copy(MRSIM_DATA_DIR "/../tests/fuzz/corpus/step/box", folder_ / "box.step");
  const char* const compared = "compare box.step box.step --json -";
  for (const char* asked :
       {"--help", "--version", "rest --help", "PRIMER_2F.MPF -o p.stl --json -", compared})
    for (const char* streams : {">&-", ">&- <&-", ">/dev/full", ">&- <&- 2>&-"})
      EXPECT_EQ(run(asked, with(streams)).code, 1) << asked << streams;
  EXPECT_FALSE(exists("p.stl"));
  for (const char* streams : {"<&-", "2>&-", "2>/dev/full", "<&- 2>&-"})
    EXPECT_EQ(run(compared, with(streams)).code, 0) << streams;
}

TEST_F(BadInput, OldOutputStaysWhenARunFails) {
  write("old.stl", "old");
  EXPECT_EQ(run("missing.MPF -o old.stl").code, 1);
  EXPECT_EQ(run("PRIMER_2F.MPF --stock block.stl -o old.stl -o missing/part.stl").code, 1);
  EXPECT_EQ(read("old.stl"), "old");
}

TEST_F(BadInput, VoxelsTooFineForNumbersOrMemoryAreRefused) {
  expect_failure("PRIMER_2F.MPF --stock block.stl --voxel 0 -o part.stl", 2, "--voxel");
  expect_failure("PRIMER_2F.MPF --stock block.stl --voxel -1 -o part.stl", 2, "--voxel");
  expect_failure("PRIMER_2F.MPF --stock block.stl --voxel nan -o part.stl", 2, "--voxel");
  expect_failure("PRIMER_2F.MPF --stock block.stl --voxel 0.0001 -o part.stl", 1,
                 "voxel-too-small");
  expect_failure("PRIMER_2F.MPF --stock block.stl --voxel 0.001 -o part.stl", 1,
                 "--voxel 0.00394 or more");
  expect_failure("PRIMER_2F.MPF --stock block.stl --voxel 0.001 -o part.vdb", 1, "voxel-too-small");
  // Coordinates of up to x mm are floats, at most x / 2^22 apart; 1.1 of it is proposed.
  expect_failure("PRIMER_2F.MPF --stock block.stl --tolerance 1e-5 -o part.stl", 2,
                 "--tolerance 2.6e-05 or more");
  expect_failure("PRIMER_2S.MPF --stock bar.stl --tolerance 1e-5 -o part.stl", 2,
                 "--tolerance 1.3e-05 or more");
  expect_failure("PRIMER_2F.MPF --stock block.stl --max-memory 1M -o part.stl", 1, "memory");
}

TEST_F(BadInput, FaultsOfTheCommandLineAreNamed) {
  expect_failure("PRIMER_2F.MPF --stok block.stl -o part.stl", 2, "did you mean \"--stock\"");
  expect_failure("PRIMER_2F.MPF PRIMER_2S.MPF -o part.stl", 2, "not expected");
  expect_failure("--stock block.stl -o part.stl", 2, "the program is missing");
  expect_failure("PRIMER_2F.MPF --stock box:0,0,0,1 -o part.stl", 2, "6 numbers");
  expect_failure("PRIMER_2F.MPF --stock missing.stl -o part.stl", 1, "missing.stl");
  expect_failure("PRIMER_2F.MPF --dialect sinumeric -o part.stl", 2, "did you mean \"sinumerik\"");
  expect_failure("PRIMER_2F.MPF --machine robot -o part.stl", 2, "mill, lathe");
  expect_failure("PRIMER_2F.MPF --threads 0 -o part.stl", 2, "--threads");
  expect_failure("compare block.stl block.stl --align box", 2, "did you mean \"bbox\"");
  expect_failure("compare block.stl block.stl --colors save", 2, "did you mean \"safe\"");
  expect_failure("PRIMER_2F.MPF --start 1,2 -o part.stl", 2, "X,Y,Z");
  expect_failure("PRIMER_2F.MPF --max-memory much -o part.stl", 2, "--max-memory");
  expect_failure("render block.stl", 2, "-o picture.png");
  expect_failure("render missing.stl -o part.png", 1, "missing.stl");
  expect_failure("trace", 2, "the program is missing");
  expect_failure("PRIMER_2F.MPF --path /dev/null -o part.stl", 1, "neither a folder nor a file");
  // "--stock=$BLOCK -q" of a variable that is not set: no file "-q".
  expect_failure("PRIMER_2F.MPF --stock= -o part.stl", 2, "--stock has an empty value");
  expect_failure("PRIMER_2F.MPF --report= -q -o part.stl", 2, "--report has an empty value");
  EXPECT_FALSE(exists("-q"));
}

}  // namespace
}  // namespace mrsim
