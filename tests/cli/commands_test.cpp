// What each command prints and where.
#include "run_program.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace mrsim {
namespace {

using namespace mrsim::testing;

using Cli = CliTest;

TEST_F(Cli, HelpAndVersionArePrinted) {
  const Outcome help = run("--help");
  EXPECT_EQ(help.code, 0);
  for (const char* word : {"Usage:", "--stock", "--voxel", "--tool", "--color", "trace", "check",
                           "render", "Exit:", "Examples:"})
    EXPECT_TRUE(contains(help.out, word)) << word;
  EXPECT_EQ(run("").out, help.out);
  EXPECT_EQ(run("help").out, help.out);
  EXPECT_TRUE(contains(run("trace --help").out, "--json"));
  EXPECT_TRUE(contains(run("render -h").out, "--azimuth"));
  EXPECT_TRUE(run("--version").out.starts_with("mrsim "));
  for (const std::string& line : {help.out, run("trace --help").out})
    EXPECT_FALSE(contains(line, "TEXT"));
}

TEST_F(Cli, ReportSaysWhatWasDecidedAndWhy) {
  const Outcome outcome = run("PRIMER_2F.MPF --stock block.stl --voxel 0.5 -o part.stl");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* word : {"dialect",     "SINUMERIK", "machine",
                           "mill",        "tools",     "T4",
                           "end mill Ø5", "stock",     "box 100 x 60 x 10 mm",
                           "voxel",       "0.5 mm",    "motions",
                           "volume",      "removed",   "triangles",
                           "written",     "part.stl",  "time",
                           "read",        "carve",     "mesh",
                           "memory"})
    EXPECT_TRUE(contains(outcome.out, word)) << word << "\n" << outcome.out;
  EXPECT_FALSE(contains(outcome.out + outcome.err, "\x1b")) << "no colours in a pipe";
  EXPECT_FALSE(contains(outcome.err, "%")) << "no progress bar in a pipe";
}

TEST_F(Cli, ReportNamesEachFile) {
  const std::string base = "PRIMER_2F.MPF --stock block.stl --voxel 5 ";
  const Outcome all = run(base + "-o part.stl --report r.html --history h.csv --json r.json");
  for (const char* file : {"part.stl  (", "r.html  (", "h.csv  (", "r.json  ("})
    EXPECT_TRUE(contains(all.out, std::string("  written    ") + file)) << file << "\n" << all.out;
  EXPECT_FALSE(contains(all.out, "nothing was written"));
  const Outcome page = run(base + "--report r.html");
  EXPECT_TRUE(contains(page.out, "  written    r.html  (")) << page.out;
  EXPECT_FALSE(contains(page.out, "nothing was written")) << page.out;
  EXPECT_TRUE(contains(run(base).out, "nothing was written: no output given (-o part.stl)"));
  const Outcome few = run(base + "-o f.stl --frames 3");
  for (const char* file : {"f-1.stl", "f-2.stl", "f-3.stl"})
    EXPECT_TRUE(contains(few.out, std::string("  written    ") + file)) << few.out;
  const Outcome many = run(base + "-o f.stl --frames 20");
  EXPECT_TRUE(contains(many.out, "  written    f-06.stl")) << many.out;
  EXPECT_TRUE(contains(many.out, "... and 8 more")) << many.out;
  EXPECT_FALSE(contains(many.out, "f-07.stl")) << many.out;
  EXPECT_TRUE(contains(many.out, "  written    f-20.stl")) << many.out;
}

// A mesh with a tolerance is that of the exact part: voxels are sampled where they are asked for.
// The machine of a file decides where --machine is not typed.
TEST_F(Cli, MachineFileSaysWhetherItIsALathe) {
  write("plain.nc", "G90 G21\nT1\nS500 M3\nG0 X20 Z5\nG1 Z-10 F100\nX30\nM30\n");
  write("lathe.toml", "[machine]\nkind = \"lathe\"\n");
  write("mill.toml", "[machine]\nkind = \"mill\"\n");
  const std::string words = "check plain.nc --dialect iso --json ";
  EXPECT_TRUE(contains(run(words + "--machine-file lathe.toml").out, "\"machine\":\"lathe\""));
  EXPECT_TRUE(contains(run(words + "--machine-file mill.toml").out, "\"machine\":\"mill\""));
  EXPECT_TRUE(contains(run(words + "--machine-file mill.toml --machine lathe").out,
                       "\"machine\":\"lathe\""));
}

TEST_F(Cli, VoxelsAreReportedWhereThereAreAny) {
  for (const auto& [options, sampled] : {std::pair<const char*, bool>{"--tolerance 0.1", false},
                                         {"--voxel 1 --tolerance 0.1", false},
                                         {"--voxel 1", false},
                                         {"--tolerance 0.1 -o part.vdb", true}}) {
    const Outcome outcome =
        run("PRIMER_2F.MPF --stock block.stl --verbose -o part.stl " + std::string(options));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(contains(outcome.out, " active\n"), sampled) << options << outcome.out;
  }
}

TEST_F(Cli, QuietPrintsNothing) {
  const Outcome outcome = run("PRIMER_2F.MPF --stock block.stl --voxel 1 -q -o part.stl");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out + outcome.err, "");
  EXPECT_TRUE(exists("part.stl"));
}

TEST_F(Cli, DiagnosticShowsTheLineAndACaret) {
  write("bad.MPF", "G54\nTRANS X0 Y0\nT1 M6\nG0 X0 Y0 Z5 ; \xC3\x98\nG1\tZ-1 FF100\nM30\n");
  const Outcome outcome = run("check bad.MPF --tool 1=endmill:d=5");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(contains(outcome.err, "bad.MPF:5:")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "    G1\tZ-1 FF100\n")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "\n      \t")) << "the caret's line keeps the tab";
  EXPECT_TRUE(contains(outcome.err, "^"));
}

TEST_F(Cli, NothingFromAFileReachesTheTerminalAsControl) {
  write("esc.MPF", "G54\nTRANS X0\nG1 \x1b[31mX1\nM30\n");
  write("\x1b[31m.MPF", "G54\nG1 X1 YY\nM30\n");
  for (const char* command : {"check esc.MPF --machine mill", "check '\x1b[31m.MPF' --machine mill",
                              "'\x1b[31m.MPF' --machine mill --stock block.stl -o part.stl",
                              "trace '\x1b[31m.MPF' --machine mill"}) {
    const Outcome outcome = run(command);
    EXPECT_FALSE(contains(outcome.out + outcome.err, "\x1b")) << command;
  }
  // Line and column would be read backwards behind such a name.
  write("a\u202Ecn.MPF", "G54\nG1 X1 YY ; \u2067\nM30\n");
  const Outcome turned = run("check 'a\u202Ecn.MPF' --machine mill");
  EXPECT_TRUE(contains(turned.err, "a?cn.MPF:2:7: error:")) << turned.err;
  EXPECT_TRUE(contains(turned.err, "G1 X1 YY ; ?\n")) << turned.err;
}

TEST_F(Cli, NamesOfMeshesAreShownWithoutControls) {
  const std::string name = "'\x1b[31m\u202Ecn.MPF'", part = "'\x1b[31m\u202Elts.stl'";
  write("\x1b[31m\u202Ecn.MPF", "G54\nTRANS X0\nT1 M6\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX9\nM30\n");
  ASSERT_EQ(run("PRIMER_2F.MPF --stock block.stl --voxel 1 -q -o whole.stl").code, 0);
  write("\x1b[31m\u202Elts.stl", read("whole.stl"));
  for (const std::string& command :
       {name +
            " --machine mill --tool 1=endmill:d=5 --stock block.stl -o x.stl --nominal whole.stl",
        "compare " + part + " whole.stl", "render " + part + " -o x.png --color line",
        "rest " + part + " whole.stl"}) {
    const Outcome outcome = run(command);
    EXPECT_FALSE(contains(outcome.out + outcome.err, "\x1b")) << outcome.out << outcome.err;
    EXPECT_FALSE(contains(outcome.out + outcome.err, "\u202E")) << command;
  }
  // Behind its line end such a name would be a message of its own.
  write("a\nb.MPF", "G54\nG1 X1 YY\nM30\n");
  const Outcome torn = run("check 'a\nb.MPF' --machine mill");
  EXPECT_TRUE(contains(torn.err, "a?b.MPF:2:7: error:")) << torn.err;
}

TEST_F(Cli, CheckListsEverythingAndWritesNothing) {
  const Outcome good = run("check PRIMER_2S.MPF --verbose");
  EXPECT_EQ(good.code, 0) << good.err;
  EXPECT_TRUE(contains(good.out, "lathe")) << good.out;
  EXPECT_TRUE(contains(good.out, "0 errors")) << good.out;
}

TEST_F(Cli, TraceJsonIsOneObjectALine) {
  const Outcome outcome = run("trace PRIMER_2F.MPF --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::size_t arcs = 0;
  for (std::size_t begin = 0; begin < outcome.out.size();) {
    const std::size_t end = outcome.out.find('\n', begin);
    ASSERT_NE(end, std::string::npos);
    const std::string line = outcome.out.substr(begin, end - begin);
    EXPECT_TRUE(line.starts_with("{") && line.ends_with("}")) << line;
    arcs += contains(line, "\"kind\":\"arc\"");
    begin = end + 1;
  }
  EXPECT_EQ(arcs, 3u);
  EXPECT_TRUE(contains(outcome.out, "\"center\":[27.5,-30,8]")) << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "\"tool\":\"4\""));
}

TEST_F(Cli, TraceDrawsThePath) {
  EXPECT_EQ(run("trace PRIMER_2S.MPF -o path.svg").code, 0);
  EXPECT_TRUE(contains(read("path.svg"), "<svg"));
}

TEST_F(Cli, RenderMakesAPicture) {
  ASSERT_EQ(run("render block.stl -o block.png --size 320x240").code, 0);
  EXPECT_TRUE(read("block.png").starts_with("\x89PNG"));
}

// They held a PNG.
TEST_F(Cli, PicturesAreNamedAsWhatTheyHold) {
  expect_failure("render block.stl -o picture.jpg", 2, "picture.jpg: a picture is written as .png");
  expect_failure("render PRIMER_2F.MPF --stock block.stl --frames 2 -o f%d.jpg", 2,
                 "f%d.jpg: a picture is written as .png");
  EXPECT_EQ(run("render block.stl --size 160x120 -o P.PNG").code, 0);
  EXPECT_EQ(run("trace PRIMER_2F.MPF -q -o P.HTML").code, 0);
  expect_failure("trace PRIMER_2F.MPF -q -o p.png", 2,
                 "p.png: a tool path is written as .svg, .ply or .html");
}

// The list has all that the place takes.
TEST_F(Cli, UnknownFormatsNameThoseThatAreKnown) {
  expect_failure("PRIMER_2F.MPF --stock block.stl -o part.xyz", 2, ".3mf .glb .vdb [mesh-format]");
  expect_failure("PRIMER_2F.MPF --stock sphere:10 -o part.stl", 2,
                 ".3mf .glb .step .stp .vdb; a plain stock is box:x0,y0,z0,x1,y1,z1, ");
  expect_failure("compare PRIMER_2F.MPF block.stl", 2, ".3mf .glb .step .stp .vdb [mesh-format]");
}

TEST_F(Cli, ColorPaintsFacesByWhatCutThem) {
  const std::string cut = "PRIMER_2F.MPF --stock block.stl --voxel 1 -q ";
  ASSERT_EQ(run(cut + "-o plain.ply").code, 0);
  ASSERT_EQ(run(cut + "--color none -o none.ply").code, 0);
  ASSERT_EQ(run(cut + "--color line -o line.ply").code, 0);
  ASSERT_EQ(run(cut + "--color tool -o tool.ply").code, 0);
  const std::string line = read("line.ply"), tool = read("tool.ply");
  EXPECT_EQ(read("none.ply"), read("plain.ply"));
  EXPECT_FALSE(contains(read("plain.ply"), "property uchar red"));
  EXPECT_TRUE(contains(line, "property uchar red"));
  EXPECT_TRUE(contains(tool, "property uchar red"));
  EXPECT_NE(line, tool);
}

TEST_F(Cli, RenderColorsByWhatCutThePart) {
  ASSERT_EQ(run("PRIMER_2F.MPF --stock block.stl --voxel 1 -q -o part.ply").code, 0);
  for (const char* color : {"none", "line", "tool"})
    ASSERT_EQ(run(std::string("render part.ply --size 320x240 --color ") + color + " -o " + color +
                  ".png")
                  .code,
              0);
  EXPECT_NE(read("none.png"), read("line.png"));
  EXPECT_NE(read("none.png"), read("tool.png"));
  EXPECT_NE(read("line.png"), read("tool.png"));
}

TEST_F(Cli, ToolsComeFromCommentFileOrCommandLine) {
  write("tools.toml", "[[tool]]\nid = 4\ntype = \"ballmill\"\ndiameter = 5\n");
  const Outcome file = run("PRIMER_2F.MPF --stock block.stl --tools tools.toml --voxel 1");
  EXPECT_TRUE(contains(file.out, "ball mill Ø5")) << file.out << file.err;
  EXPECT_TRUE(contains(file.out, "tools.toml:1")) << file.out;
  const Outcome both =
      run("PRIMER_2F.MPF --stock block.stl --tools tools.toml --tool 4=endmill:d=6 --voxel 1");
  EXPECT_TRUE(contains(both.out, "end mill Ø6")) << both.out << both.err;
}

// Two slots of a large cutter are planes and cylinders, however many voxels they pass.
TEST_F(Cli, FewLargeCutsKeepTheTolerance) {
  write("slots.nc", "%\nO1\nG90 G21\nG0 X10 Y10 Z2\nG1 Z-5 F200\nX50\nY40\nG0 Z2\nM30\n");
  const Outcome outcome =
      run("slots.nc --stock box:0,0,-20,80,60,0 --tool endmill:d=6 --dialect fanuc -q -o part.stl "
          "--json run.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json told = nlohmann::json::parse(read("run.json"));
  EXPECT_NEAR(told["tolerance"]["value"].get<double>(), 80 * 1.7e-4, 1e-9);
  EXPECT_LT(told["mesh"]["triangles"].get<int>(), 3000);
}

TEST_F(Cli, DefaultStockIsReported) {
  const Outcome outcome = run("PRIMER_2F.MPF --voxel 1 -o part.stl");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "no --stock given")) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "box:")) << outcome.out;
}

TEST_F(Cli, StrictMakesWarningsErrors) {
  // A block far away from the cuts: a warning, and with --strict no part.
  const std::string far = "PRIMER_2F.MPF --stock box:500,500,0,510,510,10 --voxel 1 -o part.stl";
  const Outcome warned = run(far);
  EXPECT_EQ(warned.code, 0) << warned.err;
  EXPECT_TRUE(contains(warned.err, "no cut meets the stock")) << warned.err;
  std::filesystem::remove(folder_ / "part.stl");
  EXPECT_EQ(run(far + " --strict").code, 1);
  EXPECT_FALSE(exists("part.stl"));
}

}  // namespace
}  // namespace mrsim
