#include "setup/job_file.h"

#include "support/error_code.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

// "line:column code text" of the fault in a job.
std::string fault(std::string_view text) {
  return testing::placed_fault("jobs/j.toml", [&] { parse_job(text, "jobs/j.toml"); });
}

// All options as they would be typed.
std::string typed(std::string_view text, const std::string& name = "jobs/j.toml") {
  const JobFile job = parse_job(text, name);
  std::string out = job.program;
  for (const JobOption& option : job.options) {
    if (option.values.empty()) out += " " + option.option;
    for (const std::string& value : option.values) out += " " + option.option + "=" + value;
  }
  return out;
}

TEST(JobFile, KeysBecomeOptions) {
  EXPECT_EQ(typed(R"(
program = "p.mpf"
stock = "box:0,0,0,1,2,3"
stock_exact = false
outputs = ["a.stl", "sub/../b.ply"]
color = "line"
keep = "largest"
tools = "tools.toml"
tool = ["1=endmill:d=5", "2=drill:d=3"]
start = [0, -1.5, 20]
block_skip = [0, 2]
voxel = 0.25
tolerance = 1
threads = 2
strict = true
nominal = "n.step"
accept = [-0.02, 0.05]
json = "-"
)"),
            "jobs/p.mpf --stock=box:0,0,0,1,2,3 --stock-exact=off --voxel=0.25 --tolerance=1 "
            "--keep=largest --threads=2 --nominal=jobs/n.step --accept=-0.02,0.05 --json=- "
            "--tools=jobs/tools.toml --tool=1=endmill:d=5 --tool=2=drill:d=3 --start=0,-1.5,20 "
            "--block-skip=0,2 --output=jobs/a.stl --output=jobs/b.ply --color=line --strict");
}

TEST(JobFile, PathsAreRelativeToTheFile) {
  EXPECT_EQ(typed("program = \"p.mpf\"\nstock = \"s.stl\"", "j.toml"), "p.mpf --stock=s.stl");
  EXPECT_EQ(typed("program = \"/x/p.mpf\"\nstock = \"s.stl\"", "/a/j.toml"),
            "/x/p.mpf --stock=/a/s.stl");
}

TEST(JobFile, FlagsThatAreFalseAreNotTyped) {
  EXPECT_EQ(typed("program = \"p.mpf\"\nstrict = false", "j.toml"), "p.mpf");
}

TEST(JobFile, UnknownKeysAreErrorsWithASuggestion) {
  EXPECT_EQ(fault("program = \"p\"\nvoxle = 1\n"),
            "2:1 job-key unknown key \"voxle\"; did you mean \"voxel\"?");
  EXPECT_TRUE(fault("quux = 1").starts_with("1:1 job-key unknown key \"quux\"; known here: "));
}

TEST(JobFile, ValuesAreChecked) {
  EXPECT_EQ(fault("voxel = \"x\"\n"), "1:9 job-value voxel must be a number");
  EXPECT_EQ(fault("voxel = 0\n"), "1:9 job-value voxel must be above 0");
  EXPECT_EQ(fault("voxel = nan\n"), "1:9 job-value voxel must be a number");
  EXPECT_EQ(fault("threads = 1.5\n"),
            "1:11 job-value threads must be a whole number from 1 to 256");
  EXPECT_EQ(fault("strict = 1\n"), "1:10 job-value strict must be true or false");
  EXPECT_EQ(fault("align = \"ipc\"\n"),
            "1:9 job-value align \"ipc\" is unknown; did you mean \"icp\"? (known: none bbox icp)");
  EXPECT_EQ(fault("outputs = [\"a.stl\", 1]\n"), "1:21 job-value outputs must be a text");
  EXPECT_EQ(fault("start = []\n"), "1:9 job-value start is an empty list");
  EXPECT_EQ(fault("program = \"other.toml\"\n"),
            "1:11 job-value program must be an NC program, not another job");
  EXPECT_EQ(fault("voxel = 1\n"), "1:1 job-value the job names no program");
  EXPECT_TRUE(fault("voxel = = 1\n").starts_with("1:"));
  EXPECT_EQ(fault("voxel = 2e6\n"), "1:9 job-value voxel is too large: at most 1e+06");
  EXPECT_EQ(fault("max_blocks = 2e15\n"), "1:14 job-value max_blocks is too large: at most 1e+15");
}

// Names of files end at it: the report would lie in the file "a".
TEST(JobFile, TheTableOfAMachineHasItsKind) {
  const std::string job = "program = \"p\"\n", table = "[machine]\ntool_change = 3\n";
  const std::string both = fault(job + "machine = \"mill\"\n" + table);
  EXPECT_TRUE(both.starts_with("3:1 job-syntax")) << both;
  EXPECT_NE(both.find("write kind = \"mill\""), both.npos) << both;
  EXPECT_EQ(fault(job + table + "kind = \"mill\"\n"), "");
}

TEST(JobFile, TextsHaveNoNulCharacter) {
  EXPECT_EQ(fault("report = \"a\\u0000b\"\n"),
            "1:10 job-value report must be a text without \\u0000");
}

TEST(JobFile, CountsMayBeLarge) {
  EXPECT_EQ(typed("program = \"p.mpf\"\nmax_triangles = 2000000", "j.toml"),
            "p.mpf --max-triangles=2000000");
}

// `program = "--help"` printed the help and was done.
TEST(JobFile, ANameOfAProgramIsNoOption) {
  EXPECT_EQ(typed("program = \"--help\"", "j.toml"), "./--help");
  EXPECT_EQ(typed("program = \"-\"", "j.toml"), "-");
}

}  // namespace
}  // namespace mrsim
