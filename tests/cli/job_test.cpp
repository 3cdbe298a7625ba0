// A run from job.toml, alone and with options beside it.
#include "run_program.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

class JobRun : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    std::filesystem::create_directory(folder_ / "jobs");
    for (const char* name : {"PRIMER_2F.MPF", "block.stl"})
      std::filesystem::copy(folder_ / name, folder_ / "jobs" / name);
    write("jobs/job.toml",
          "program = \"PRIMER_2F.MPF\"\nstock = \"block.stl\"\noutputs = [\"part.ply\"]\n"
          "voxel = 1\ncolor = \"line\"\n");
  }
};

TEST_F(JobRun, IsTheSameAsTypingItsOptions) {
  const Outcome job = run("jobs/job.toml");
  ASSERT_EQ(job.code, 0) << job.err;
  ASSERT_EQ(run("jobs/PRIMER_2F.MPF --stock block.stl --voxel 1 --color line -o typed.ply").code,
            0);
  EXPECT_TRUE(read("jobs/part.ply") == read("typed.ply"));
}

TEST_F(JobRun, TypedOptionsReplaceTheFiles) {
  const Outcome outcome = run("--voxel=2 jobs/job.toml --color none -o other.ply");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "2 mm")) << outcome.out;
  EXPECT_FALSE(exists("jobs/part.ply"));
  EXPECT_FALSE(contains(read("other.ply"), "property uchar red"));
}

TEST_F(JobRun, HoldsTheComparison) {
  write("same.toml",
        "program = \"PRIMER_2F.MPF\"\nstock = \"block.stl\"\nvoxel = 1\nnominal = \"block.stl\"\n"
        "accept = [-0.02, 0.05]\njson = \"r.json\"\n");
  EXPECT_EQ(run("same.toml").code, 4) << "the block is not the part";
  EXPECT_TRUE(contains(read("r.json"), "verdict"));
}

// A folder that is not there may have held the subprogram that is meant.
TEST_F(JobRun, FoldersOfProgramsExist) {
  write("same.toml",
        "program = \"PRIMER_2F.MPF\"\nstock = \"block.stl\"\nvoxel = 2\npath = \"jobz\"\n");
  expect_failure("same.toml", 1, "jobz: no such folder");
  EXPECT_EQ(run("same.toml --path jobs").code, 0);
}

TEST_F(JobRun, LeadsOutOfItsFolderOnlyWhereThatIsAllowed) {
  write("jobs/out.toml",
        "program = \"PRIMER_2F.MPF\"\nstock = \"block.stl\"\nvoxel = 2\n"
        "outputs = [\"../part.ply\"]\n");
  expect_failure("jobs/out.toml", 1, "jobs/out.toml:4:12");
  expect_failure("jobs/out.toml", 1, "--allow-outside");
  EXPECT_FALSE(exists("part.ply"));
  EXPECT_EQ(run("jobs/out.toml --allow-outside").code, 0);
  EXPECT_TRUE(exists("part.ply"));
  std::filesystem::create_directory_symlink("..", folder_ / "jobs/link");
  std::filesystem::create_symlink("../linked.ply", folder_ / "jobs/file.ply");
  for (const char* output : {"link/linked.ply", "file.ply"}) {
    write("jobs/link.toml",
          "program = \"PRIMER_2F.MPF\"\nstock = \"block.stl\"\nvoxel = 2\noutputs = \"" +
              std::string(output) + "\"\n");
    expect_failure("jobs/link.toml", 1, "jobs/link.toml:4:11");
    EXPECT_FALSE(exists("linked.ply")) << output;
  }
  EXPECT_EQ(run("jobs/link.toml --allow-outside").code, 0);
  EXPECT_TRUE(exists("linked.ply"));
  // The file that was checked is the one that is written, from the job's own folder as well.
  const std::filesystem::path above = folder_ / "jobs/link/../above.ply";
  write("here.toml",
        "program = \"PRIMER_2F.MPF\"\nstock = \"block.stl\"\nvoxel = 2\n"
        "outputs = \"jobs/link/../above.ply\"\n");
  EXPECT_EQ(run("here.toml").code, 0);
  EXPECT_TRUE(exists("jobs/above.ply"));
  EXPECT_FALSE(std::filesystem::remove(above));
  const std::string place = (folder_ / "far.ply").string();
  write("jobs/far.toml",
        "program = \"PRIMER_2F.MPF\"\nstock = \"block.stl\"\nvoxel = 2\noutputs = \"" + place +
            "\"\n");
  EXPECT_EQ(run("jobs/far.toml").code, 0);
  EXPECT_TRUE(exists("far.ply"));
}

// What only the option itself can tell, but not where the option is typed.
TEST_F(JobRun, ValuesThatAnOptionRefusesAreShownInTheFile) {
  const std::string program = "program = \"PRIMER_2F.MPF\"\n";
  for (const char* line : {"max_memory = \"4X\"", "start = [1]", "stock_repair = \"x\"",
                           "tool = \"x\"", "history = \"x\"", "max_triangles = 1.5"}) {
    write("odd.toml", program + line + "\n");
    const std::size_t column = std::string(line).find('=') + 3;
    expect_failure("odd.toml", 2, "odd.toml:2:" + std::to_string(column) + ": error");
  }
  write("odd.toml", program + "max_memory = \"4X\"\n");
  expect_failure("odd.toml --max-memory 4Y", 2, "mrsim: error: --max-memory \"4Y\"");
}

// What is known when the run has begun: lines, sizes, files that are missing or no outputs.
TEST_F(JobRun, ValuesThatTheRunRefusesAreShownInTheFile) {
  const std::string program = "program = \"PRIMER_2F.MPF\"\n";
  const std::string rest = "voxel = 2\noutputs = \"part.stl\"\n";
  for (const char* line :
       {"until = \"#99999\"", "until = \"99999\"", "until = \"x:7\"", "until = \"#0\"",
        "stock = \"none.stl\"", "stock = \"box:1,2\"", "tools = \"none.toml\"",
        "nominal = \"none.stl\"", "machine_file = \"none.toml\"", "tolerance = 1e-9",
        "report = \"PRIMER_2F.MPF\"", "json = \"none/r.json\""}) {
    const bool has_stock = std::string(line).starts_with("stock");
    write("odd.toml", program + line + "\n" + rest + (has_stock ? "" : "stock = \"block.stl\"\n"));
    const std::size_t column = std::string(line).find('=') + 3;
    const Outcome outcome = run("odd.toml");
    EXPECT_TRUE(outcome.code == 1 || outcome.code == 2) << line << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "odd.toml:2:" + std::to_string(column) + ": error"))
        << line << "\n"
        << outcome.err;
  }
  write("odd.toml", "stock = \"block.stl\"\nprogram = \"none.MPF\"\n");
  expect_failure("odd.toml", 1, "odd.toml:2:11: error: none.MPF: no such file");
  write("odd.toml", program + "until = \"#99999\"\nstock = \"block.stl\"\n" + rest);
  expect_failure("odd.toml --until 88888", 2, "mrsim: error: --until 88888");
}

TEST_F(JobRun, FaultsAreShownInTheFile) {
  write("bad.toml", "program = \"PRIMER_2F.MPF\"\nvoxle = 1\n");
  expect_failure("bad.toml", 1, "bad.toml:2:1");
  expect_failure("bad.toml", 1, "did you mean \"voxel\"");
  expect_failure("missing.toml", 1, "missing.toml");
  expect_failure("check jobs/job.toml", 2, "check takes a program");
  expect_failure("jobs/job.toml PRIMER_2S.MPF", 2, "not expected");
  expect_failure("jobs/job.toml --voxle 1", 2, "did you mean \"--voxel\"");
}

}  // namespace
}  // namespace mrsim
