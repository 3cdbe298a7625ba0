// --until: the part at a moment is the part of a program that ends there, to the byte.
#include "run_program.h"

#include <filesystem>

namespace mrsim {
namespace {

using namespace mrsim::testing;

class Until : public CliTest {
 protected:
  // PRIMER_2F up to `line`, then M30.
  void write_shortened(int line) {
    std::istringstream text(read("PRIMER_2F.MPF"));
    std::string out, row;
    for (int i = 0; i < line && std::getline(text, row); ++i) out += row + "\n";
    write("SHORT.MPF", out + "M30\n");
  }
  void expect_same(const std::string& until, int line) {
    write_shortened(line);
    ASSERT_EQ(run("SHORT.MPF --stock block.stl -q -o short.stl").code, 0);
    const Outcome outcome = run("PRIMER_2F.MPF --stock block.stl -o part.stl --until " + until);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "the program ends after")) << outcome.err;
    EXPECT_EQ(read("part.stl"), read("short.stl")) << until;
  }
};

TEST_F(Until, LineEndsTheProgramThere) {
  expect_same("7", 7);
  expect_same("PRIMER_2F:8", 8);
  expect_same("11", 11);
}

TEST_F(Until, MotionsAreCountedFromOne) { expect_same("'#3'", 7); }

TEST_F(Until, LineOfACallHoldsAllThatItCalls) {
  write("SUB.SPF", "G91 G1 X5 F200\nY5\nX-5\nY-5 G90\nM17\n");
  const std::string head = "G54 G17 G90 G71\nT1 M6\nG0 X20 Y-30 Z5\nG1 Z-2 F200\n";
  write("main.MPF", head + "SUB\nG1 X40\nM30\n");
  write("short.MPF", head + "SUB\nM30\n");
  const std::string rest =
      " --machine mill --stock box:0,-60,-10,100,0,0 --tool 1=endmill:d=4 -q -o ";
  ASSERT_EQ(run("short.MPF" + rest + "short.stl").code, 0);
  const Outcome outcome = run("main.MPF" + rest + "part.stl --until 5");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(read("part.stl"), read("short.stl"));
  EXPECT_EQ(run("main.MPF" + rest + "sub.stl --until SUB:2").code, 0);
  EXPECT_NE(read("sub.stl"), read("short.stl"));
}

// The holes of a cycle stand at its line, called from those of their places; a subprogram may stand
// in the file of its call.
TEST_F(Until, LinesOfOneFileHoldAllThatTheyCall) {
  const std::string head = "G21 G90 G17 G54\nT1 M6\nS1000 M3\nG0 X10 Y-30 Z5\n";
  const std::string holes = "G81 X10 Z-4 R2 F100\nX30\nX50\nG80\n", call = "M98 P200\n";
  const std::string end = "M30\nO200\nG0 X70 Z2\nG1 Z-3\nX80\nG0 Z5\nM99\n";
  const std::string rest =
      " --dialect fanuc --machine mill --stock box:0,-60,-10,100,0,0 --tool 1=endmill:d=6 --json ";
  const auto removed = [&](const std::string& program, const std::string& until) {
    write("main.nc", program);
    const Outcome outcome = run("main.nc" + rest + "out.json" + until);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return number_after(read("out.json"), "\"removed\":");
  };
  const std::string whole = "O100\n" + head + holes + call + end;
  const double hole = 3.14159265 * 9 * 4, slot = 3.14159265 * 9 * 3 + 10 * 6 * 3;
  EXPECT_NEAR(removed(whole, " --until 6"), hole, 0.01);
  EXPECT_NEAR(removed(whole, " --until 7"), 2 * hole, 0.01);
  EXPECT_NEAR(removed(whole, " --until 9"), 3 * hole, 0.01);
  EXPECT_NEAR(removed(whole, " --until 10"), 3 * hole + slot, 0.01);
  EXPECT_NEAR(removed(whole, " --until 14"), 3 * hole + slot - 180, 0.01);  // within the call
}

// Lines that move nothing end the program where the control has done them: behind a loop, that is
// behind all of its passes. A line that is no block is one of those before the next block.
TEST_F(Until, LinesWithoutMovesEndTheProgramWhereTheyAreDone) {
  const std::string head = "G21 G90 G17\nT1 M6\nS1000 M3\n#1=0\nG0 X-10 Y5 Z-2\n";
  const std::string loop =
      "WHILE [#1 LT 3] DO1\nG1 Y[5+#1*10] F1000\nX60\n#1=#1+1\nG0 X-10\nEND1\n";
  const std::string rest =
      " --dialect fanuc --machine mill --stock box:0,0,-20,50,40,0 --tool 1=endmill:d=6 --voxel 2 "
      "-q "
      "--json ";
  write("main.nc", head + loop + "(NEXT)\nM5\nG4 P2000\nG4 P3000\n\nG1 X0 F500\nM30\n");
  const auto expect = [&](int line, double removed, double dwell) {
    const Outcome outcome = run("main.nc" + rest + "out.json --until " + std::to_string(line));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string json = read("out.json");
    EXPECT_NEAR(number_after(json, "\"removed\":"), removed, 0.01) << line;
    EXPECT_NEAR(number_after(json, "\"dwell_seconds\":"), dwell, 1e-9) << line;
  };
  for (const int line : {8, 9, 10, 11}) expect(line, 600, 0);  // done for the first time
  for (const int line : {12, 13}) expect(line, 1800, 0);
  expect(14, 1800, 2);
  expect(16, 1800, 5);
  expect(18, 1800, 5);
  // What a line calls belongs to it.
  write("main.nc", head + "G1 X60 F500\nM98 P100 L3\nG4 P100\nM5\nM30\n" +
                       "O100\nG4 P500\nM8\nG4 P250\nM99\n");
  expect(7, 600, 2.25);
  expect(8, 600, 2.35);
  expect(12, 600, 0.5);
  // An empty line behind a call comes after the subprogram, which stands further down.
  write("main.nc",
        head + "G1 X60 F500\nM98 P100\n\nM5\nG1 Y20\nM30\n" + "O100\nG0 X-10 Y15\n\nG1 X60\nM99\n");
  expect(8, 1200, 0);
  expect(14, 600, 0);
  // With cutter compensation moves come later than their blocks.
  write("main.nc", head + "G41 D1 G1 X0 F500\nX60\n#1=1\nY60\nG40 X70\nM30\n");
  EXPECT_EQ(run("main.nc" + rest + "out.json --until 8").code, 0);
  const double before = number_after(read("out.json"), "\"removed\":");
  EXPECT_EQ(run("main.nc" + rest + "out.json --until 7").code, 0);
  EXPECT_EQ(before, number_after(read("out.json"), "\"removed\":"));
}

TEST_F(Until, MomentsThatAreNoneAreWrongUsage) {
  for (const char* moment : {"0", "'#'", "-3", "7a", ":7", "OTHER:7", "'#8'", "13", "''"})
    expect_failure(std::string("PRIMER_2F.MPF --stock block.stl -o part.stl --until ") + moment, 2,
                   "until");
}

TEST_F(Until, FramesAreThePartsAtTheirMoments) {
  const std::string rest = "PRIMER_2F.MPF --stock block.stl -q -o part.stl ";
  ASSERT_EQ(run(rest + "--frames 4").code, 0);
  EXPECT_FALSE(exists("part.stl"));
  ASSERT_EQ(run(rest).code, 0);
  EXPECT_EQ(read("part-4.stl"), read("part.stl"));
  // A plunge of 2.1 s, half circles of 14.1, 7.1 and 14.1 s, and rapids.
  ASSERT_EQ(run(rest + "--until '#3'").code, 0);
  EXPECT_EQ(read("part-1.stl"), read("part.stl"));
  ASSERT_EQ(run(rest + "--until '#4'").code, 0);
  EXPECT_EQ(read("part-2.stl"), read("part.stl"));
  EXPECT_NE(read("part-1.stl"), read("part-2.stl"));
  EXPECT_NE(read("part-2.stl"), read("part-3.stl"));
}

// A slot of 100 mm by F1000 through air for 300 mm: by volume, half of it is gone at its middle.
// What is left to cut is told of the finished part.
TEST_F(Until, FramesLeaveTheFilesOfTheWholeRun) {
  std::filesystem::copy(std::filesystem::path(MRSIM_DATA_DIR) / "PRIMER_2F.nominal.stl",
                        folder_ / "n.stl");
  const Outcome outcome =
      run("PRIMER_2F.MPF --stock block.stl -q -o part.stl --frames 2 --nominal n.stl --accept 0.02 "
          "--rest rest.json --json run.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  expect_valid("rest", "rest.json");
  expect_valid("run", "run.json");
  EXPECT_TRUE(contains(read("run.json"), "\"verdict\": \"accepted\"")) << read("run.json");
}

// All of them or none: half of the time passes before the cut, and under --strict that a frame cuts
// nothing is an error.
TEST_F(Until, FramesAppearTogether) {
  write("main.MPF", "G17 G90 G71\nT1 M6\nG0 X-1000 Y20 Z5\nG1 Z-2 F1000\nX-10\nX110\nG0 Z5\nM30\n");
  for (const char* name : {"part-1.stl", "part-2.stl", "page.html"}) write(name, "old");
  const std::string rest =
      "main.MPF --machine mill --stock box:0,0,-10,100,40,0 --tool 1=endmill:d=4 --voxel 0.5 -q "
      "-o part.stl --json run.json --report page.html --frames 2";
  const Outcome failed = run(rest + " --strict");
  EXPECT_EQ(failed.code, 1) << failed.err;
  for (const char* name : {"part-1.stl", "part-2.stl", "page.html"}) EXPECT_EQ(read(name), "old");
  EXPECT_TRUE(contains(read("run.json"), "\"nothing-cut\"")) << read("run.json");
  EXPECT_TRUE(contains(read("run.json"), "\"outputs\": []"));
  expect_valid("run", "run.json");
  ASSERT_EQ(run(rest).code, 0);
  for (const char* name : {"part-1.stl", "part-2.stl", "page.html"}) {
    EXPECT_GT(read(name).size(), 1000u);
    EXPECT_TRUE(contains(read("run.json"), std::string("\"path\": \"") + name)) << name;
  }
}

TEST_F(Until, FramesByVolumeAreEqualSharesOfWhatIsRemoved) {
  write("main.MPF",
        "G17 G90 G71\nT1 M6\nG0 X-10 Y20 Z5\nG1 Z-2 F1000\nX0\nX25\nX50\nX75\nX110\nX400\nG0 "
        "Z5\nM30\n");
  const std::string rest =
      "main.MPF --machine mill --stock box:0,0,-10,100,40,0 --tool 1=endmill:d=4 --voxel 0.5 -q "
      "-o part.stl ";
  ASSERT_EQ(run(rest + "--frames 2 --frames-by volume").code, 0);
  ASSERT_EQ(run(rest + "--until 7").code, 0);
  const std::string half = read("part.stl");
  ASSERT_EQ(run(rest + "--until 8").code, 0);
  EXPECT_TRUE(read("part-1.stl") == half || read("part-1.stl") == read("part.stl"));
  ASSERT_EQ(run(rest + "--frames 2 --frames-by time").code, 0);
  EXPECT_NE(read("part-1.stl"), half);
  std::filesystem::remove(folder_ / "part.stl");
  expect_failure(rest + "--frames-by volume --until 7 ", 2, "needs --frames");
  expect_failure(rest + "--frames 2 --frames-by mass", 2, "time or volume");
  expect_failure(rest + "--frames 2 --frames-by volume --history off", 2, "history");
}

TEST_F(Until, FramesArePictures) {
  const std::string rest = "render PRIMER_2F.MPF --stock block.stl -q --size 160x120 --frames 3 ";
  const Outcome outcome = run(rest + "-o f%02d.png");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* name : {"f01.png", "f02.png", "f03.png"}) EXPECT_TRUE(exists(name)) << name;
  EXPECT_NE(read("f01.png"), read("f03.png"));
  EXPECT_FALSE(exists("f04.png"));
  expect_failure(rest + "-o f%s.png", 2, "%04d");
}

TEST_F(Until, AJobMayBeRenderedInFrames) {
  write("job.toml",
        "program = \"PRIMER_2F.MPF\"\nstock = \"block.stl\"\noutputs = [\"part.stl\"]\n"
        "report = \"page.html\"\naccept = [-0.1, 0.1]\nframes = 7\n");
  const std::string rest = "-q --size 160x120 --frames 2 ";
  const Outcome outcome = run("render job.toml " + rest + "-o j%d.png");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  ASSERT_EQ(run("render PRIMER_2F.MPF --stock block.stl " + rest + "-o f%d.png").code, 0);
  for (const char* number : {"1.png", "2.png"})
    EXPECT_EQ(read(std::string("j") + number), read(std::string("f") + number)) << number;
  EXPECT_FALSE(exists("j3.png") || exists("part.stl") || exists("page.html"));
}

// Stands for ffmpeg: the film names its pictures.
TEST_F(Until, FramesAreAFilm) {
  const std::string rest =
      "render PRIMER_2F.MPF --stock block.stl --voxel 5 -q --size 160x120 --frames 3 -o film.webm";
  const Outcome without = run(rest, "PATH=" + folder_.string());
  EXPECT_EQ(without.code, 1);
  EXPECT_NE(without.err.find("ffmpeg, which is not installed"), std::string::npos) << without.err;
  EXPECT_FALSE(exists("film.webm"));
  write("ffmpeg",
        "#!/bin/sh\nfor a; do case $a in */%04d.png) d=${a%/*};; esac; last=$a; done\n"
        "cd \"$d\" && ls *.png > film.webm && [ \"$last\" -ef film.webm ]\n");
  std::filesystem::permissions(folder_ / "ffmpeg", std::filesystem::perms::owner_all);
  const Outcome with = run(rest, "PATH=" + folder_.string() + ":/usr/bin:/bin");
  ASSERT_EQ(with.code, 0) << with.err;
  EXPECT_EQ(read("film.webm"), "0001.png\n0002.png\n0003.png\n");
  write("ffmpeg", "#!/bin/sh\nexit 3\n");
  EXPECT_EQ(run(rest, "PATH=" + folder_.string() + ":/usr/bin:/bin").code, 1);
  EXPECT_EQ(read("film.webm"), "0001.png\n0002.png\n0003.png\n");  // the earlier one
}

TEST_F(Until, PathsAreAPage) {
  const Outcome outcome = run("trace PRIMER_2F.MPF -q -o path.html");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string page = read("path.html");
  EXPECT_NE(page.find("<!doctype html>"), std::string::npos);
  EXPECT_NE(page.find("\"stock\":null"), std::string::npos);
}

TEST_F(Until, PagesAndPicturesNeedNoTmpdir) {
  const std::string gone = "TMPDIR=/nonexistent";
  const Outcome page = run("view block.stl --no-open", gone);
  ASSERT_EQ(page.code, 0) << page.err;
  std::filesystem::remove(page.out.substr(0, page.out.find('\n')));
  const Outcome pictures =
      run("render PRIMER_2F.MPF --stock block.stl -q --size 80x60 --frames 2 -o f%d.png", gone);
  EXPECT_EQ(pictures.code, 0) << pictures.err;
  EXPECT_TRUE(exists("f2.png"));
}

TEST_F(Until, ColorsOfAFileWithoutLinesAreSaidToBeMissing) {
  const Outcome outcome = run("render block.stl --color line --size 80x60 -o a.png");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("does not say which line cut which face"), std::string::npos)
      << outcome.err;
}

TEST_F(Until, ViewWritesAPageAndTellsItsName) {
  for (const char* input : {"PRIMER_2F.MPF --stock block.stl -q", "block.stl"}) {
    const Outcome outcome = run(std::string("view ") + input + " --no-open");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string page = outcome.out.substr(0, outcome.out.find('\n'));
    ASSERT_TRUE(page.ends_with(".html")) << outcome.out;
    EXPECT_GT(std::filesystem::file_size(page), 100000u);
    std::filesystem::remove(page);
  }
  write("BAD.MPF", "N1 G0 X0 Y0 Z5\nN2 G1 X=(\n");
  for (const char* input : {"BAD.MPF --stock block.stl", "missing.stl"}) {  // nothing is left
    EXPECT_NE(run(std::string("view ") + input + " --no-open", "mkdir -p t; TMPDIR=$PWD/t").code,
              0);
    EXPECT_TRUE(std::filesystem::is_empty(folder_ / "t")) << input;
  }
  expect_failure("view", 2, "view takes");
  expect_failure("view PRIMER_2F.MPF --stock block.stl --frames 3 -o a.stl", 2, "--frames");
}

TEST_F(Until, FramesNeedOutputsAndNoOtherMoment) {
  expect_failure("PRIMER_2F.MPF --stock block.stl --frames 3", 2, "--frames");
  expect_failure("PRIMER_2F.MPF --stock block.stl -o part.stl --frames 3 --until 7", 2, "--frames");
  expect_failure("PRIMER_2F.MPF --stock block.stl -o part.stl --frames 0", 2, "--frames");
}

TEST_F(Until, CycleTimeIsToldAndFollowsTheMachine) {
  const Outcome usual = run("PRIMER_2F.MPF --stock block.stl -o part.stl");
  EXPECT_TRUE(contains(usual.out, "a usual machine")) << usual.out;
  write("job.toml",
        "program = \"PRIMER_2F.MPF\"\nstock = \"block.stl\"\noutputs = \"part.stl\"\n"
        "[machine]\nkind = \"mill\"\nacceleration = 100000\nspindle_acceleration = 1e6\n");
  const Outcome fast = run("job.toml");
  ASSERT_EQ(fast.code, 0) << fast.err;
  // 7 mm down and three half circles at 200 mm/min.
  EXPECT_NEAR(number_after(fast.out, "cutting"), (7 + 37.5 * 3.14159265) * 60 / 200, 0.06)
      << fast.out;
}

TEST_F(Until, DwellsAreToldInTheTimeOfTheProgram) {
  write("dwell.nc",
        "G21 G90 G17 G54 T1 M6\nS1000 M3\nG0 X0 Y0 Z5.\nG1 Z-1. F200\nG4 P7500\nG1 X5.\nG0 Z5.\n"
        "M30\n");
  const Outcome told = run(
      "dwell.nc --dialect fanuc --machine mill --tool 1=endmill:d=4 --stock block.stl -o part.stl "
      "--json out.json");
  ASSERT_EQ(told.code, 0) << told.err;
  EXPECT_TRUE(contains(told.out, ", dwells 7.5 s")) << told.out;
  EXPECT_TRUE(contains(read("out.json"), "\"dwell_seconds\": 7.5")) << read("out.json");
}

}  // namespace
}  // namespace mrsim
