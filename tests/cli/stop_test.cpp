// Ctrl-C and SIGTERM during a long run: it ends within a second, with 130 or 143, and leaves
// nothing.
#include "run_program.h"

#include <algorithm>
#include <chrono>

namespace mrsim {
namespace {

using namespace mrsim::testing;

class Stop : public CliTest {
 protected:
  // A run of a minute or more gets the signal after a second.
  void expect_stopped(const std::string& arguments, const std::string& signal, int code) {
    const auto begin = std::chrono::steady_clock::now();
    const Outcome outcome =
        run(arguments, "timeout --foreground --preserve-status -s " + signal + " 1");
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    EXPECT_EQ(outcome.code, code) << arguments << "\n" << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "stopped")) << arguments << "\n" << outcome.err;
    EXPECT_LT(took.count(), 1 + 1 + busy_) << arguments;
    EXPECT_FALSE(exists("part.stl")) << arguments;
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
      EXPECT_FALSE(entry.path().filename().string().starts_with(".mrsim-")) << entry.path();
  }

  // s: other tests run beside this one, sanitizers take their time
  const double busy_ = kIsPlain ? 4 : 15;
  const int announced_ = kIsPlain ? 60 : 200;
};

TEST_F(Stop, EndsALongRunWithinASecond) {
  for (const char* rest : {" --voxel 0.005", " --tolerance 0.0002"}) {
    const std::string arguments = "PRIMER_2F.MPF --stock block.stl -o part.stl" + std::string(rest);
    expect_stopped(arguments, "INT", 130);
    expect_stopped(arguments, "TERM", 143);
  }
  expect_stopped("PRIMER_2F.MPF --stock block.stl -o part.stl --voxel 0.005 --json r.json", "HUP",
                 129);
  expect_valid("run", "r.json");
}

// What takes more than ten seconds says so after its first ones, and is stopped then.
TEST_F(Stop, ALongRunIsAnnounced) {
  const std::string note = "will take about ";
  const std::string until_announced = "sh -c '\"$0\" \"$@\" & run=$!; for k in $(seq " +
                                      std::to_string(announced_) + "); do sleep 1; grep -q \"" +
                                      note + "\" .err && break; done; kill -TERM $run; wait $run'";
  for (const char* rest : {" --voxel 0.004", " --tolerance 0.00003"}) {
    const Outcome outcome =
        run("PRIMER_2F.MPF --stock block.stl -o part.stl" + std::string(rest), until_announced);
    if (outcome.code == 0) continue;  // a machine that takes less
    EXPECT_EQ(outcome.code, 143) << rest;
    EXPECT_TRUE(contains(outcome.err, "note: meshing " + note)) << rest << outcome.err;
  }
  write("sheet.obj", "v 0 0 0\nv 200 0 0\nv 200 200 0\nv 0 200 0\nf 1 2 3\nf 1 3 4\n");
  const Outcome wrap =
      run("PRIMER_2F.MPF --stock sheet.obj --stock-repair wrap=0.1 -o part.stl", until_announced);
  EXPECT_EQ(wrap.code, 143) << wrap.err;
  EXPECT_TRUE(contains(wrap.err, "note: wrapping " + note)) << wrap.err;
}

// While a film is made: its pictures are temporary files, and ffmpeg is a program of its own.
TEST_F(Stop, LeavesNoTemporaryFileAndNoProgram) {
  std::filesystem::create_directory(folder_ / "tmp");
  write("ffmpeg", "#!/bin/sh\necho $$ > pid\nexec sleep 100\n");
  std::filesystem::permissions(folder_ / "ffmpeg", std::filesystem::perms::owner_all);
  const std::string when_filmed =
      "PATH=$PWD:$PATH TMPDIR=$PWD/tmp sh -c '\"$0\" \"$@\" & run=$!; for k in $(seq 600); do "
      "[ -s pid ] && break; sleep 0.1; done; kill -TERM $run; wait $run'";
  const Outcome outcome =
      run("render PRIMER_2F.MPF --stock block.stl -q --size 80x60 --frames 2 -o film.webm",
          when_filmed);
  EXPECT_EQ(outcome.code, 143) << outcome.err;
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "tmp"));
  EXPECT_FALSE(exists("film.webm"));
  const std::string gone = "for k in $(seq 50); do kill -0 " +
                           std::to_string(std::stoi(read("pid"))) +
                           " 2>/dev/null || exit 0; sleep 0.1; done; exit 1";
  EXPECT_EQ(std::system(gone.c_str()), 0);
}

// "| head -1": a page whose name nobody reads is gone. Messages that nobody reads are no end of a
// run.
TEST_F(Stop, LeavesNoPageWhoseReaderHasGone) {
  std::filesystem::create_directory(folder_ / "tmp");
  const std::string piped = "TMPDIR=$PWD/tmp bash -c '\"$0\" \"$@\" | true; exit ${PIPESTATUS[0]}'";
  for (const char* what : {"block.stl", "PRIMER_2F.MPF --stock block.stl --voxel 1 -q"}) {
    const Outcome outcome = run("view --no-open " + std::string(what), piped);
    EXPECT_EQ(outcome.code, 128 + 13) << what << outcome.err;
    EXPECT_TRUE(std::filesystem::is_empty(folder_ / "tmp")) << what;
  }
  const Outcome closed =
      run("view --no-open block.stl", "TMPDIR=$PWD/tmp sh -c '\"$0\" \"$@\" >&-'");
  EXPECT_EQ(closed.code, 1) << closed.err;
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "tmp"));
  const Outcome unheard = run("PRIMER_2F.MPF --stock block.stl --voxel 1 -o part.stl",
                              "bash -c 'exec 2> >(true); sleep 0.3; \"$0\" \"$@\"'");
  EXPECT_EQ(unheard.code, 0);
  EXPECT_TRUE(exists("part.stl"));
}

TEST_F(Stop, EndsAComparisonWithinASecond) {
  expect_stopped("compare block.stl bar.stl --density 300 --json c.json", "TERM", 143);
  expect_valid("compare", "c.json");
  EXPECT_TRUE(contains(read("c.json"), "\"cancelled\""));
}

// The lines of JSON end with a whole one, which says that there are not all.
TEST_F(Stop, EndsAListWithAWholeLine) {
  write("long.nc",
        "G17 G90 G21\nF500\nG0 X0 Y0\nM98 P1 L9999999\nM30\nO1\nG91 G1 X1\nG1 X-1\nM99\n");
  for (const char* command : {"trace", "check"}) {
    const std::string arguments =
        std::string(command) + " long.nc --dialect fanuc --machine mill --tool endmill:d=5 --json";
    const Outcome outcome = run(arguments, "timeout -s TERM 0.5");  // which sends it twice
    EXPECT_EQ(outcome.code, 124) << command << outcome.err;         // of timeout
    const std::size_t late = outcome.out.size() - std::min<std::size_t>(outcome.out.size(), 20000);
    write("lines", outcome.out.substr(late == 0 ? 0 : outcome.out.find('\n', late) + 1));
    expect_valid(command, "lines", true);
    EXPECT_TRUE(contains(outcome.out, "\"cancelled\"")) << command;
  }
}

}  // namespace
}  // namespace mrsim
