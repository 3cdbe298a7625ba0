// The comparison from outside, on real programs with planted faults.
#include "run_program.h"

#include <sstream>

namespace mrsim {
namespace {

using namespace mrsim::testing;

class Compare : public NominalTest {
 protected:
  /// PRIMER_2F with `from` replaced by `to`, cut and compared; the JSON.
  Json spoiled(const std::string& from, const std::string& to, const std::string& options = "") {
    std::string program = read("PRIMER_2F.MPF");
    program.replace(program.find(from), from.size(), to);
    write("BAD.MPF", program);
    outcome_ =
        run("BAD.MPF --stock block.stl -o part.ply --nominal PRIMER_2F.nominal.stl --accept 0.02 "
            "--json r.json " +
            options);
    return Json::parse(exists("r.json") ? read("r.json") : "{}", nullptr, false)["comparison"];
  }
  /// A box from (x, 0, 0) of that size, as an OFF file.
  static std::string box_off(double x, double a, double b, double c) {
    std::string out = "OFF\n8 12 0\n";
    for (int k = 0; k < 8; ++k)
      out += std::to_string(x + (k & 1 ? a : 0)) + " " + std::to_string(k & 2 ? b : 0) + " " +
             std::to_string(k & 4 ? c : 0) + "\n";
    for (const char* t : {"0 2 1", "1 2 3", "4 5 6", "5 7 6", "0 1 4", "1 5 4", "2 6 3", "3 6 7",
                          "0 4 2", "2 4 6", "1 3 5", "3 7 5"})
      out += std::string("3 ") + t + "\n";
    return out;
  }
  static int first_line(const Json& region) { return region["lines"].at(0)["line"]; }
  Outcome outcome_;
};

TEST_F(Compare, MillingPartIsAccepted) {
  const Outcome o = run(
      "PRIMER_2F.MPF --stock block.stl -o part.ply --nominal PRIMER_2F.nominal.stl --accept 0.02 "
      "--json r.json");
  EXPECT_EQ(o.code, 0) << o.out << o.err;
  const Json j = Json::parse(read("r.json"))["comparison"];
  EXPECT_EQ(j["verdict"], "accepted");
  EXPECT_LE(j["part_to_nominal"]["rms"], 0.003);
  const Json& bound = j["hausdorff"]["symmetric"];
  EXPECT_LE(bound["upper"], 0.02);
  EXPECT_LE(bound["upper"].get<double>() - bound["lower"].get<double>(), 2e-4);
  // The part alone, later: the same verdict, lines known from the file.
  const Outcome later = run("compare part.ply PRIMER_2F.nominal.stl --accept 0.02 --report r.html");
  EXPECT_EQ(later.code, 0) << later.err;
  EXPECT_NE(read("r.html").find("N40 G2 X7.5 Y0 CR=7.5"), std::string::npos);
}

TEST_F(Compare, MeshIsFinerThanTheToleranceItIsJudgedBy) {
  const Outcome o =
      run("PRIMER_2F.MPF --stock block.stl --nominal PRIMER_2F.nominal.stl --accept -0.01,0.004 "
          "--json r.json");
  EXPECT_EQ(o.code, 0) << o.out << o.err;
  EXPECT_NE(o.out.find("0.001 mm  (a quarter of --accept, 0.004 mm)"), std::string::npos) << o.out;
}

TEST_F(Compare, TurningPartIsAccepted) {
  const Outcome o =
      run("PRIMER_2S.MPF --stock bar.stl -o part.ply --nominal PRIMER_2S.nominal.stl --accept 0.02 "
          "--json r.json");
  EXPECT_EQ(o.code, 0) << o.out << o.err;
  EXPECT_LE(Json::parse(read("r.json"))["comparison"]["part_to_nominal"]["rms"], 0.003);
}

TEST_F(Compare, ArcOfTheWrongSignIsNamed) {
  const Json j = spoiled("N40 G2", "N40 G3");
  EXPECT_EQ(outcome_.code, 4);
  EXPECT_EQ(j["verdict"], "rejected");
  bool named = false;
  for (const Json& region : j["regions"])
    named = named || (region["kind"] == "gouge" && first_line(region) == 8 &&
                      region["lines"][0]["text"] == "N40 G3 X7.5 Y0 CR=7.5");
  EXPECT_TRUE(named) << j["regions"].dump(1);
}

TEST_F(Compare, TheLineOfAGougeIsNamed) {
  const Json j = spoiled("N45 G3 X37.5 Y0 CR=15", "N45 G3 X37.5 Y0 Z-2.1 CR=15");
  EXPECT_EQ(outcome_.code, 4);
  EXPECT_EQ(j["regions"][0]["kind"], "gouge");
  EXPECT_EQ(first_line(j["regions"][0]), 9);
  EXPECT_NEAR(j["part_to_nominal"]["min"], -0.1, 0.005);
}

TEST_F(Compare, AWrongDiameterOfTheToolIsNamed) {
  const Json j = spoiled("N05", "N05", "--tool 4=endmill:d=5.2 --tolerance 0.01");
  EXPECT_EQ(outcome_.code, 4);
  EXPECT_NEAR(j["part_to_nominal"]["min"], -0.1, 0.0101);  // the mesh is within 0.01
  ASSERT_FALSE(j["hints"].empty());
  EXPECT_EQ(j["hints"][0]["code"], "tool-size");
}

TEST_F(Compare, MissingPassNamesItsNeighbours) {
  const Json j = spoiled("N45 G3", "N45 G0 Z5\nN46 G0");
  EXPECT_EQ(outcome_.code, 4);
  EXPECT_EQ(j["regions"][0]["kind"], "excess");
  EXPECT_EQ(j["regions"][0]["lines"][0]["role"], "beside");
  EXPECT_EQ(first_line(j["regions"][0]), 8);  // N40, which ends where the missing one began
}

TEST_F(Compare,
       AShiftedWorkOffsetIsNamed) {  // of the slot in its block: no move of the part mends it
  const Json j = spoiled("TRANS X50 Y-30", "TRANS X50.3 Y-30");
  EXPECT_EQ(outcome_.code, 4);
  bool shifted = false;
  for (const Json& hint : j["hints"])
    shifted = shifted || (hint["code"] == "part-shifted" &&
                          hint["text"].get<std::string>().find("-0.300") != std::string::npos);
  EXPECT_TRUE(shifted) << j["hints"].dump(1);
  EXPECT_EQ(j["hints"].dump().find("--align"), std::string::npos) << j["hints"].dump(1);
}

TEST_F(Compare, ShiftOfTheWholePartVanishesWithIcp) {
  const std::string moved =
      "PRIMER_2F.MPF --stock block.stl -q -o part.ply && sed 's/TRANS X50 /TRANS X50.3 /' "
      "PRIMER_2F.MPF >MOVED.MPF && '" +
      kProgram + "' MOVED.MPF --stock box:0.3,-60,0,100.3,0,10 -q -o moved.ply";
  ASSERT_EQ(run(moved).code, 0);
  EXPECT_EQ(run("compare moved.ply PRIMER_2F.nominal.stl --accept 0.02").code, 4);
  const Outcome o =
      run("compare moved.ply PRIMER_2F.nominal.stl --accept 0.02 --align icp --json r.json");
  EXPECT_EQ(o.code, 0) << o.out;
  EXPECT_NE(o.out.find("Aligned (icp)"), std::string::npos) << o.out;
  EXPECT_NEAR(Json::parse(read("r.json"))["transform"]["shift"][0].get<double>(), -0.3, 1e-3);
}

TEST_F(Compare, PicturesOfDeviationHaveALegend) {
  ASSERT_EQ(run("PRIMER_2F.MPF --stock block.stl -o part.ply -q --nominal PRIMER_2F.nominal.stl "
                "--tolerance 0.05 --accept 0.01 --deviation dev.ply")
                .code,
            4);
  EXPECT_NE(read("dev.ply").find("comment mrsim legend"), std::string::npos);
  EXPECT_NE(read("dev.ply").find("-0.01 .. +0.01 mm: in tolerance"), std::string::npos);
  const auto draw = [&](const std::string& what, const std::string& name) {
    const Outcome o = run("render " + what + " --size 320x240 -q -o " + name);
    EXPECT_EQ(o.code, 0) << o.err;
    return read(name);
  };
  const std::string of_file = draw("dev.ply", "a.png");
  const std::string direct =
      draw("part.ply --nominal PRIMER_2F.nominal.stl --accept 0.01", "b.png");
  EXPECT_EQ(of_file, direct);
  EXPECT_NE(draw("part.ply --nominal PRIMER_2F.nominal.stl --accept 0.01 --colors safe", "c.png"),
            direct);
  EXPECT_NE(draw("part.ply", "d.png"), direct);
  expect_failure("render part.ply --nominal missing.stl -o e.png", 1, "no such file");
  EXPECT_FALSE(exists("e.png"));
}

TEST_F(Compare, JsonOnTheStandardOutputStandsAlone) {
  const Outcome o =
      run("PRIMER_2F.MPF --stock block.stl -o part.stl --nominal PRIMER_2F.nominal.stl --json -");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(Json::parse(o.out, nullptr, false)["verdict"], "none");
}

TEST_F(Compare, EveryFormatWithOwnersNamesTheLine) {
  std::string program = read("PRIMER_2F.MPF");
  program.replace(program.find("N40 G2"), 6, "N40 G3");
  write("BAD.MPF", program);
  ASSERT_EQ(run("BAD.MPF --stock block.stl -q -o p.ply -o p.glb -o p.3mf -o p.obj").code, 0);
  for (const std::string name : {"p.ply", "p.glb", "p.3mf", "p.obj"}) {
    const Outcome o = run("compare " + name + " PRIMER_2F.nominal.stl --accept 0.02 --json r.json");
    EXPECT_EQ(o.code, 4) << o.err;
    EXPECT_EQ(o.err.find("no lines are named"), std::string::npos) << name;
    const Json j = Json::parse(read("r.json"));
    EXPECT_NE(j["regions"].dump().find("N40 G3 X7.5 Y0 CR=7.5"), std::string::npos) << name;
  }
}

// Corners of a cube, and its sides where they begin at corner `first`, in OFF.
std::string box_corners(int lo, int hi) {
  std::ostringstream out;
  for (int i = 0; i < 8; ++i)
    out << (i & 1 ? hi : lo) << ' ' << (i & 2 ? hi : lo) << ' ' << (i & 4 ? hi : lo) << '\n';
  return out.str();
}

std::string box_sides(int first) {
  constexpr int kSides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  std::ostringstream out;
  for (const auto& side : kSides) {
    out << 4;
    for (const int corner : side) out << ' ' << corner + first;
    out << '\n';
  }
  return out.str();
}

TEST_F(Compare, NominalsThatAreNearlySolidsAreRepairedAndToldOf) {
  write("box.off", "OFF\n8 6 0\n" + box_corners(0, 10) + box_sides(0));
  write("double.off", "OFF\n8 12 0\n" + box_corners(0, 10) + box_sides(0) + box_sides(0));
  const Outcome outcome = run("compare box.off double.off --accept 0.01");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "double.off was no solid and has been repaired"))
      << outcome.err;
  write("two.off",
        "OFF\n16 12 0\n" + box_corners(0, 10) + box_corners(5, 15) + box_sides(0) + box_sides(8));
  const Outcome crossing = run("compare box.off two.off");
  EXPECT_TRUE(contains(crossing.err, "two.off: the surface crosses itself")) << crossing.err;
  EXPECT_TRUE(contains(crossing.err, "counts twice in volumes")) << crossing.err;
  write("held.off",
        "OFF\n16 12 0\n" + box_corners(0, 10) + box_corners(2, 5) + box_sides(0) + box_sides(8));
  EXPECT_TRUE(
      contains(run("compare box.off held.off").err, "held.off: a body lies within another"));
}

TEST_F(Compare, BadInputLeavesNothing) {
  write("open.stl",
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
        "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n");
  const std::string tail = " --report r.html --json r.json";
  const auto fails = [&](const std::string& arguments, int code, const std::string& text) {
    expect_failure(arguments, code, text);
    EXPECT_FALSE(exists("r.html"));
    if (!exists("r.json")) return;
    EXPECT_EQ(Json::parse(read("r.json"), nullptr, false)["verdict"], "failed") << arguments;
    std::filesystem::remove(folder_ / "r.json");
  };
  fails("compare block.stl open.stl" + tail, 1, "compare-nominal-open");
  fails("compare block.stl missing.stl" + tail, 1, "no such file");
  fails("compare block.stl" + tail, 2, "a part and a nominal");
  fails("compare block.stl block.stl --acept 1", 2, "--accept");
  fails("compare block.stl block.stl -o deviation.stl" + tail, 2, ".ply and .glb");
  EXPECT_FALSE(exists("deviation.stl"));
  fails("compare block.stl block.stl --density 0" + tail, 2, "samples a mm2");
  fails("compare block.stl block.stl --report nowhere/r.html", 1, "nowhere");
  fails("compare block.stl block.stl --accept x" + tail, 2, "tolerance");
  write("bad.step", "no step");
  fails("compare block.stl bad.step" + tail, 1, "STEP");
  fails("PRIMER_2F.MPF --stock block.stl -o part.stl --nominal open.stl", 1, "open");
  write("empty.stl", "solid a\nendsolid a\n");
  fails("compare block.stl empty.stl" + tail, 1, "no triangles");
  write("nan.stl",
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 nan\n"
        "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n");
  fails("compare block.stl nan.stl" + tail, 1, "stl-nan");
  write("far.off", box_off(1e6, 100, 60, 10));
  write("inch.off", box_off(0, 100 / 25.4, 60 / 25.4, 10 / 25.4));
  write("metres.off", box_off(0, 0.1, 0.06, 0.01));
  const std::string page = " --report r.html";
  for (const std::string& run :
       {std::string("compare block.stl"),
        std::string("PRIMER_2F.MPF --stock block.stl -o part.stl --nominal")}) {
    fails(run + " far.off" + page, 1, "compare-apart");
    fails(run + " inch.off" + page, 1, "in inches");
    fails(run + " metres.off" + page, 1, "in metres");
  }
  fails("PRIMER_2F.MPF --stock block.stl -o part.stl --accept 0.02", 2, "--nominal");
}

// The bound of the largest distance exceeds the tolerance: said with the verdict, and in JSON.
TEST_F(Compare, AVerdictSaysWhatIsProven) {
  const Outcome o =
      run("PRIMER_2S.MPF --stock bar.stl --nominal PRIMER_2S.nominal.stl "
          "--accept 0.02 --json r.json");
  const Json j = Json::parse(read("r.json"))["comparison"];
  const double upper = j["hausdorff"]["symmetric"]["upper"];
  EXPECT_EQ(j["proven"].get<bool>(), upper <= 0.02);
  EXPECT_EQ(contains(o.out, "; by samples: proven is that no distance exceeds"), upper > 0.02)
      << o.out;
}

// A comparison that fails tells programs, too, as a run does; but not in the place of an input.
TEST_F(Compare, AFailureIsToldInItsFiles) {
  write("cut.stl", read("block.stl").substr(0, 300));
  const Outcome o = run("compare block.stl cut.stl --json r.json --junit r.xml");
  EXPECT_EQ(o.code, 1) << o.err;
  expect_valid("compare", "r.json");
  const Json j = Json::parse(read("r.json"));
  EXPECT_EQ(j["verdict"], "failed");
  EXPECT_EQ(j["part"], "block.stl");
  EXPECT_TRUE(contains(o.err, j["error"]["code"].get<std::string>())) << o.err;
  EXPECT_TRUE(contains(read("r.xml"), "<failure")) << read("r.xml");
  const std::string block = read("block.stl");
  EXPECT_NE(run("compare block.stl cut.stl --json block.stl").code, 0);
  EXPECT_EQ(read("block.stl"), block);
}

TEST_F(Compare, ABareMeshSaysOnceThatItKnowsNoLines) {
  const Outcome o = run("compare block.stl block.stl --accept 0.01 --junit r.xml");
  EXPECT_EQ(o.code, 0);
  const std::string word = "no lines are named";
  EXPECT_NE(o.err.find(word), std::string::npos);
  EXPECT_EQ(o.err.find(word, o.err.find(word) + 1), std::string::npos);
  EXPECT_NE(read("r.xml").find("failures=\"0\""), std::string::npos);
  // Nor does it know what is the stock's own surface.
  const Outcome far = run("compare block.stl PRIMER_2F.nominal.stl --accept 0.01 --json r.json");
  EXPECT_EQ(far.code, 4) << far.err;
  EXPECT_FALSE(contains(far.out, "own surface")) << far.out;
  EXPECT_EQ(Json::parse(read("r.json"))["regions"][0]["stock_share"], 0);
}

}  // namespace
}  // namespace mrsim
