// `mrsim rest`: pieces left to cut against closed forms, and the tools that reach them.
#include "run_program.h"

#include <cmath>
#include <numbers>
#include <sstream>
#include <utility>
#include <vector>

namespace mrsim {
namespace {

using namespace mrsim::testing;

using Polygon = std::vector<std::pair<double, double>>;

class Rest : public CliTest {
 protected:
  // A polygon, counter-clockwise, all of which is seen from `middle`, from z = 0 to `height`.
  void write_prism(const std::string& name, const Polygon& polygon,
                   const std::pair<double, double>& middle, double height) {
    const std::size_t n = polygon.size();
    std::ostringstream out;
    out.precision(9);
    out << "OFF\n" << 2 * n + 2 << " " << 4 * n << " 0\n";
    for (const double z : {0.0, height}) {
      for (const auto& [x, y] : polygon) out << x << " " << y << " " << z << "\n";
      out << middle.first << " " << middle.second << " " << z << "\n";
    }
    const std::size_t up = n + 1;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      out << "3 " << n << " " << j << " " << i << "\n3 " << n + up << " " << i + up << " " << j + up
          << "\n3 " << i << " " << j << " " << j + up << "\n3 " << i << " " << j + up << " "
          << i + up << "\n";
    }
    write(name, out.str());
  }
  // Two walls 10 mm thick with a fillet between them.
  void write_corner(const std::string& name, double radius) {
    Polygon polygon = {{0, 0}, {40, 0}, {40, 10}};
    for (int k = 96; k >= 0; --k)  // from (10 + radius, 10) to (10, 10 + radius)
      polygon.emplace_back(10 + radius * (1 - std::cos(std::numbers::pi / 2 * k / 96)),
                           10 + radius * (1 - std::sin(std::numbers::pi / 2 * k / 96)));
    polygon.insert(polygon.end(), {{10, 40}, {0, 40}});
    write_prism(name, polygon, {5, 5}, 12);
  }
  Json rest(const std::string& arguments) {
    const Outcome outcome = run("rest " + arguments + " -q --json rest.json");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    expect_valid("rest", "rest.json");
    return Json::parse(read("rest.json"));
  }
};

TEST_F(Rest, StepHasItsVolumeThicknessAndPlace) {
  write_prism("part.off", {{0, 0}, {60, 0}, {60, 5}, {30, 5}, {30, 6}, {10, 6}, {10, 5}, {0, 5}},
              {20, 4.5}, 20);
  write_prism("nominal.off", {{0, 0}, {60, 0}, {60, 5}, {0, 5}}, {20, 4.5}, 20);
  for (const double voxel : {0.2, 0.1}) {
    const Json found = rest("part.off nominal.off --voxel " + std::to_string(voxel));
    ASSERT_EQ(found["pieces"].size(), 1U);
    const Json& piece = found["pieces"][0];
    EXPECT_NEAR(piece["volume"].get<double>(), 20 * 20 * 1, 400 * voxel * 0.02) << voxel;
    EXPECT_NEAR(piece["thickness"].get<double>(), 1, 1e-4);
    EXPECT_NEAR(piece["center"][0].get<double>(), 20, voxel / 2);
    EXPECT_NEAR(piece["center"][1].get<double>(), 5.5, voxel / 2);
    EXPECT_NEAR(piece["bounds"][0][1].get<double>(), 5, 1e-4);
    EXPECT_NEAR(piece["bounds"][1][1].get<double>(), 6, 1e-4);
    EXPECT_TRUE(piece["flat"]["or_more"].get<bool>());
  }
}

// Two steps, mirror images of each other, so they have one answer: their sharp inner edge.
TEST_F(Rest, SharpInnerEdgesAreFoundWhereverTheyLie) {
  write_prism("part.off", {{0, 0}, {60, 0}, {60, 10}, {0, 10}}, {30, 4.5}, 20);
  write_prism("nominal.off",
              {{0, 0}, {60, 0}, {60, 5}, {40, 5}, {40, 10}, {20, 10}, {20, 5}, {0, 5}}, {30, 4.5},
              20);
  const Json found = rest("part.off nominal.off");
  ASSERT_EQ(found["pieces"].size(), 2U);
  for (const Json& piece : found["pieces"]) {
    EXPECT_TRUE(piece["ball"]["leaves_edge"].get<bool>()) << piece.dump();
    EXPECT_LT(piece["ball"]["diameter"].get<double>(), 0.2);
  }
}

TEST_F(Rest, CornerNamesTheToolOfItsFillet) {
  write_corner("part.off", 6);
  write_corner("nominal.off", 3);
  const double exact = (6 * 6 - 3 * 3) * (1 - std::numbers::pi / 4) * 12;
  const Json found = rest("part.off nominal.off --voxel 0.1");
  ASSERT_EQ(found["pieces"].size(), 1U);
  const Json& piece = found["pieces"][0];
  EXPECT_NEAR(piece["volume"].get<double>(), exact, 0.02 * exact);
  EXPECT_NEAR(piece["thickness"].get<double>(), (std::sqrt(2) - 1) * 3, 0.002);
  // A tool of radius r leaves (sqrt(2) - 1) (r - 3) in the middle of the fillet.
  const double leaves = found["leaves"], diameter = 6 + 2 * leaves / (std::sqrt(2) - 1);
  for (const char* tool : {"flat", "ball"}) {
    EXPECT_LT(piece[tool]["error"], 0.03);
    EXPECT_LT(piece[tool]["diameter"].get<double>(), diameter + 0.03);
    EXPECT_GT(piece[tool]["diameter"].get<double>(), 6 - 0.03);
    EXPECT_FALSE(piece[tool]["leaves_edge"].get<bool>());
  }
}

// The bottom of a slot: an end mill of its width reaches it, a ball does not reach its edges.
TEST_F(Rest, SlotIsForAnEndMill) {
  const auto cut = [&](const std::string& name, int depth) {
    write(name + ".MPF", "G17 G90 G71\nT1 M6\nG0 X-10 Y15 Z5\nG1 Z-" + std::to_string(depth) +
                             " F200\nG1 X50\nG0 Z5\nM30\n");
    return run(name +
               ".MPF --machine mill --stock box:0,0,-10,40,30,0 --tool 1=endmill:d=10 -q -o " +
               name + ".stl")
        .code;
  };
  ASSERT_EQ(cut("part", 3), 0);
  ASSERT_EQ(cut("nominal", 5), 0);
  const Json found = rest("part.stl nominal.stl");
  ASSERT_EQ(found["pieces"].size(), 1U);
  const Json& piece = found["pieces"][0];
  EXPECT_NEAR(piece["volume"].get<double>(), 10 * 40 * 2, 8);
  EXPECT_NEAR(piece["flat"]["diameter"].get<double>(), 10, piece["flat"]["error"].get<double>());
  // In an inner edge of 90 degrees a ball of radius r leaves (sqrt(2) - 1) r.
  EXPECT_NEAR(piece["ball"]["diameter"].get<double>(),
              2 * found["leaves"].get<double>() / (std::sqrt(2) - 1),
              piece["ball"]["error"].get<double>() + 1e-3);
  EXPECT_TRUE(piece["ball"]["leaves_edge"].get<bool>());
  EXPECT_TRUE(contains(run("rest part.stl nominal.stl").out, "by a ball: none above"));
}

// The error depends on the voxel, not on the length of the slot.
TEST_F(Rest, LongSlotHasTheDiameterOfItsTool) {
  for (const int depth : {3, 5}) {
    const std::string name = "slot" + std::to_string(depth);
    write(name + ".MPF", "G17 G90 G71\nT1 M6\nG0 X-10 Y15 Z5\nG1 Z-" + std::to_string(depth) +
                             " F200\nG1 X190\nG0 Z5\nM30\n");
    ASSERT_EQ(run(name +
                  ".MPF --machine mill --stock box:0,0,-10,180,30,0 "
                  "--tool 1=endmill:d=5 -q -o " +
                  name + ".stl")
                  .code,
              0);
  }
  const Json flat = rest("slot3.stl slot5.stl")["pieces"][0]["flat"];
  EXPECT_LT(flat["error"], 0.1);
  EXPECT_NEAR(flat["diameter"].get<double>(), 5, flat["error"].get<double>());
}

TEST_F(Rest, RunTellsWhatIsLeftForItsNominal) {
  write("flat.MPF", "G17 G90 G71\nT1 M6\nG0 X-10 Y15 Z5\nG1 Z-3 F200\nG1 X50\nG0 Z5\nM30\n");
  const std::string words =
      "flat.MPF --machine mill --stock box:0,0,-10,40,30,0 --tool 1=endmill:d=10 ";
  write("deep.MPF", "G17 G90 G71\nT1 M6\nG0 X-10 Y15 Z5\nG1 Z-5 F200\nG1 X50\nG0 Z5\nM30\n");
  ASSERT_EQ(run("deep.MPF --machine mill --stock box:0,0,-10,40,30,0 --tool 1=endmill:d=10 -q "
                "-o nominal.stl")
                .code,
            0);
  const Outcome outcome = run(words + "--nominal nominal.stl --rest rest.json --json run.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "are left in 1 piece")) << outcome.out;
  expect_valid("rest", "rest.json");
  expect_valid("run", "run.json");
  const Json found = Json::parse(read("rest.json"));
  EXPECT_NEAR(found["volume"].get<double>(), 10 * 40 * 2, 8);
  EXPECT_EQ(Json::parse(read("run.json"))["rest"], found);
  expect_failure(words + "--rest rest.json", 2, "--nominal");
  expect_failure(words + "--nominal nominal.stl --rest rest.txt", 2, "--rest");
  expect_failure(words + "--nominal nominal.stl --rest nominal.json.json -o nominal.json.json", 2,
                 "nominal.json.json");
}

TEST_F(Rest, KeepsToItsMemory) {
  write_corner("part.off", 6);
  write_corner("nominal.off", 3);
  expect_failure("rest part.off nominal.off --voxel 0.1 --max-memory 60M", 1,
                 "a larger --voxel takes less");
  EXPECT_EQ(run("rest part.off nominal.off --voxel 1 --max-memory 200M -q").code, 0);
}

TEST_F(Rest, PiecesAreAMeshOfTheirVolume) {
  write_corner("part.off", 6);
  write_corner("nominal.off", 3);
  const Json found = rest("part.off nominal.off --voxel 0.2 -o pieces.stl --threads 1");
  const std::string bytes = read("pieces.stl");
  EXPECT_EQ(rest("part.off nominal.off --voxel 0.2 -o pieces.stl --threads 3"), found);
  EXPECT_EQ(read("pieces.stl"), bytes);
  const Json again = rest("pieces.stl nominal.off --voxel 0.2");
  EXPECT_NEAR(again["volume"].get<double>(), found["volume"].get<double>(),
              0.01 * found["volume"].get<double>());
}

TEST_F(Rest, NothingLeftIsSaidAndWritesNoMesh) {
  EXPECT_TRUE(contains(run("rest block.stl block.stl --voxel 1").out, "in 0 pieces"));
  expect_failure("rest block.stl block.stl --voxel 1 -o part.stl", 1, "nothing is left");
  expect_failure("rest block.stl", 2, "a part and a nominal");
  expect_failure("rest block.stl bar.stl --voxel 0.001", 2, "too small");
  expect_failure("rest block.stl bar.stl --voxel 0.05 --above 0.12469", 2,
                 "--voxel 0.0624 or more");
  expect_failure("rest block.stl bar.stl -o block.stl", 2, "the part");
}

}  // namespace
}  // namespace mrsim
