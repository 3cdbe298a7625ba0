// --max-triangles: fewer triangles, with the distance that makes told.
#include "run_program.h"

#include <nlohmann/json.hpp>

namespace mrsim {
namespace {

using namespace mrsim::testing;

class MaxTriangles : public CliTest {
 protected:
  const std::string part_ = "PRIMER_2F.MPF --stock block.stl ";
};

TEST_F(MaxTriangles, ReducesAndSaysHowFar) {
  ASSERT_EQ(run(part_ + "-o whole.ply --json whole.json").code, 0);
  const auto whole = nlohmann::json::parse(read("whole.json"))["mesh"]["triangles"];
  const Outcome outcome = run(part_ + "--max-triangles 600 -o part.ply --json run.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "reduced from ")) << outcome.out;
  EXPECT_NEAR(number_after(outcome.out, "volume"), 58782.63285, 0.001);  // of the exact part
  const auto json = nlohmann::json::parse(read("run.json"));
  EXPECT_LE(json["mesh"]["triangles"], 600);
  EXPECT_EQ(json["mesh"]["reduced"]["before"], whole);
  const double least = json["mesh"]["reduced"]["distance"][0];
  const double most = json["mesh"]["reduced"]["distance"][1];
  EXPECT_GT(least, 0);
  EXPECT_GE(most, least);
  EXPECT_GT(json["bound"]["distance"], most);

  // The comparison of both files finds the same distance.
  ASSERT_EQ(run("compare part.ply whole.ply --json c.json").code, 0);
  const auto found = nlohmann::json::parse(read("c.json"));
  EXPECT_NEAR(found["hausdorff"]["symmetric"]["lower"], least, 0.02 * most);
}

TEST_F(MaxTriangles, FilesKeepTheirLines) {
  ASSERT_EQ(run(part_ + "--max-triangles 600 -o part.ply").code, 0);
  const std::string head = read("part.ply").substr(0, 2000);
  EXPECT_TRUE(contains(head, "owner")) << head;
}

TEST_F(MaxTriangles, ThreadsDoNotMatter) {
  ASSERT_EQ(run(part_ + "--max-triangles 500 --threads 1 -o a.stl").code, 0);
  ASSERT_EQ(run(part_ + "--max-triangles 500 --threads 3 -o b.stl").code, 0);
  EXPECT_EQ(read("a.stl"), read("b.stl"));
}

TEST_F(MaxTriangles, SmallMeshesDoNotChange) {
  ASSERT_EQ(run(part_ + "-o a.stl").code, 0);
  ASSERT_EQ(run(part_ + "--max-triangles 100000 -o b.stl").code, 0);
  EXPECT_EQ(read("a.stl"), read("b.stl"));
}

TEST_F(MaxTriangles, WhatIsTooFewIsRefusedWithWhatWorks) {
  const Outcome outcome = run(part_ + "--max-triangles 2 -o part.stl");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_FALSE(exists("part.stl"));
  EXPECT_TRUE(contains(outcome.err, "max-triangles")) << outcome.err;
  const std::string count = std::to_string(static_cast<int>(number_after(outcome.err, "itself;")));
  EXPECT_EQ(run(part_ + "--max-triangles " + count + " -o some.stl").code, 0) << count;
  expect_failure(part_ + "--max-triangles 0 -o none.stl", 2, "max-triangles");
}

}  // namespace
}  // namespace mrsim
