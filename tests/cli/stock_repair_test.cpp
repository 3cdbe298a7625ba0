// Stock files that are nearly solids: repaired where nothing has to be guessed, and said so;
// refused where something would.
#include "run_program.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace mrsim {
namespace {

using namespace mrsim::testing;

using Corner = std::vector<double>;
struct Facets {
  std::vector<Corner> corners;
  std::vector<std::vector<int>> triangles;
};

// Of a block that is no box: its corner at (100, 0, 10) is `cut` lower.
Facets block(double x = 0, double cut = 1) {
  Facets f;
  for (int i = 0; i < 8; ++i)
    f.corners.push_back(
        {x + (i & 1 ? 100 : 0), i & 2 ? 0.0 : -60.0, i & 4 ? (i == 7 ? 10 - cut : 10.0) : 0.0});
  f.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return f;
}

Facets joined(Facets a, const Facets& b) {
  const int shift = static_cast<int>(a.corners.size());
  a.corners.insert(a.corners.end(), b.corners.begin(), b.corners.end());
  for (std::vector<int> t : b.triangles) {
    for (int& v : t) v += shift;
    a.triangles.push_back(t);
  }
  return a;
}

std::string off_text(const Facets& f) {
  std::ostringstream out;
  out.precision(9);
  out << "OFF\n" << f.corners.size() << ' ' << f.triangles.size() << " 0\n";
  for (const Corner& c : f.corners) out << c[0] << ' ' << c[1] << ' ' << c[2] << '\n';
  for (const auto& t : f.triangles) out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  return out.str();
}

class StockRepair : public CliTest {
 protected:
  // A run on the stock, cut as the sound one is, with a warning that says `done` ("": without one).
  void expect_repaired(const Facets& stock, const std::string& done) {
    write("sound.off", off_text(block()));
    const std::string rest = " --voxel 1 -o ";
    ASSERT_EQ(run("PRIMER_2F.MPF --stock sound.off" + rest + "sound.stl").code, 0);
    write("stock.off", off_text(stock));
    const Outcome o = run("PRIMER_2F.MPF --stock stock.off" + rest + "part.stl");
    ASSERT_EQ(o.code, 0) << o.err;
    EXPECT_EQ(o.err.find("[stock-repaired]") != std::string::npos, !done.empty()) << o.err;
    EXPECT_NE(o.err.find(done), std::string::npos) << o.err;
    EXPECT_EQ(read("part.stl"), read("sound.stl"));
  }
  void expect_refused(const Facets& stock, const std::string& text) {
    write("stock.off", off_text(stock));
    expect_failure("PRIMER_2F.MPF --stock stock.off --voxel 1 -o part.stl", 1, text);
  }
};

TEST_F(StockRepair, LeavesSolidsAlone) { expect_repaired(block(), ""); }

TEST_F(StockRepair, WeldsVerticesOfOnePlace) {
  Facets apart;
  const Facets whole = block();
  for (const auto& t : whole.triangles) {
    const int first = static_cast<int>(apart.corners.size());
    for (const int v : t) apart.corners.push_back(whole.corners[static_cast<std::size_t>(v)]);
    apart.triangles.push_back({first, first + 1, first + 2});
  }
  expect_repaired(apart, "");  // every reader of triangles does that, and nothing was wrong
}

TEST_F(StockRepair, WeldsWhatRoundingHasTakenApart) {
  Facets torn = block();
  Corner beside = torn.corners[7];
  beside[0] += 2e-5;  // two steps of a float at 100
  torn.corners.push_back(beside);
  torn.triangles[2] = {4, 5, 8};
  expect_repaired(torn, "vertex of an open edge welded");
}

TEST_F(StockRepair, TurnsWhatLooksInwards) {
  Facets inside_out = block();
  for (auto& t : inside_out.triangles) std::swap(t[0], t[1]);
  expect_repaired(inside_out, "inside out");
  Facets mixed = block();
  for (const std::size_t k : {3, 5, 8}) std::swap(mixed.triangles[k][0], mixed.triangles[k][1]);
  expect_repaired(mixed, "3 triangles turned");
}

TEST_F(StockRepair, DropsDoubleTriangles) {
  Facets twice = block();
  twice.triangles.push_back(twice.triangles[4]);
  expect_repaired(twice, "1 double triangle dropped");
}

// Triangles back to back are closed and hold nothing, but the nearest of them would call one of
// their sides the inside.
TEST_F(StockRepair, DropsSheetsWithoutThickness) {
  Facets sheet = block();
  sheet.corners.insert(sheet.corners.end(), {{110, 5, -8}, {120, 6, -2}, {115, 25, -5}});
  sheet.triangles.push_back({8, 9, 10});
  sheet.triangles.push_back({10, 9, 8});
  expect_repaired(sheet, "1 sheet without thickness dropped");
}

TEST_F(StockRepair, DropsTrianglesWithoutCornersOfTheirOwn) {
  Facets flat = block();
  flat.corners.push_back(flat.corners[2]);
  flat.triangles.push_back({2, 8, 3});
  expect_repaired(flat, "");  // every reader of triangles does that, too
}

// Closed by indices, but two vertices have one place, so that two triangles have no area: the
// nearest of them would tell no side.
TEST_F(StockRepair, WeldsClosedMeshesWithTrianglesWithoutArea) {
  Facets split = block();
  split.corners.push_back(split.corners[2]);
  split.triangles[0] = {0, 8, 3};
  split.triangles.push_back({3, 8, 2});
  split.triangles.push_back({8, 0, 2});
  expect_repaired(split, "1 vertex welded, 2 triangles without area dropped");
}

TEST_F(StockRepair, KeepsTrianglesOnALine) {
  Facets cap = block();
  cap.corners.push_back({50, 0, 0});  // on the side from corner 2 to corner 3
  cap.triangles[7] = {2, 7, 8};
  cap.triangles.push_back({8, 7, 3});
  cap.triangles.push_back({3, 2, 8});
  expect_repaired(cap, "");
  for (auto& t : cap.triangles) std::swap(t[0], t[1]);
  write("stock.off", off_text(cap));
  EXPECT_EQ(run("PRIMER_2F.MPF --stock stock.off --voxel 1 -o part.stl").code, 0);
}

TEST_F(StockRepair, RefusesBodiesThatTouchAlongAnEdge) {
  Facets two = block(), other = block(100, 0);
  two.corners[7][2] = 10;
  for (Corner& c : other.corners) c[1] += 60;
  Facets all = joined(two, other);
  for (auto& t : all.triangles)
    for (int& v : t) v = v == 8 ? 3 : v == 12 ? 7 : v;  // the edge X100 Y0
  expect_refused(all, "more than two triangles meet at the edge at (100, 0, 5)");
}

TEST_F(StockRepair, RefusesHoles) {
  Facets open = block();
  open.triangles.pop_back();
  expect_refused(open, "open edge at (100, ");
  expect_refused(open, "3 open edges");
}

TEST_F(StockRepair, RefusesSurfacesThatCrossThemselves) {
  Facets inner = block(30);
  for (Corner& c : inner.corners) c[2] += 5;
  expect_refused(joined(block(), inner), "crosses itself near (");
}

TEST_F(StockRepair, RefusesBodiesThatTouchInAFace) {
  const Facets first = block(0, 0);
  const auto expect_crossing = [&](const Facets& second) {
    expect_refused(joined(first, second), "crosses itself near (");
  };
  Facets second = block(100, 0);  // by the other diagonal
  second.triangles[8] = {0, 4, 2};
  second.triangles[9] = {4, 6, 2};
  expect_crossing(second);
  second = block(100, 0);  // one edge in common
  for (Corner& c : second.corners) c[1] = std::min(c[1], -30.0);
  expect_crossing(second);
  for (Corner& c : second.corners) c[2] = std::min(c[2], 5.0);  // one corner
  expect_crossing(second);
}

// Two bodies in CAD that share a face are one piece of material.
TEST_F(StockRepair, UnitesBodiesThatTouchInTheSameTriangles) {
  const Facets two = joined(block(0, 0), block(100, 0));
  write("two.off", off_text(two));
  const std::string run_of = "PRIMER_2F.MPF --voxel 1 --stock two.off";
  const Outcome o = run(run_of + " --json j.json -o part.stl");
  ASSERT_EQ(o.code, 0) << o.err;
  EXPECT_TRUE(contains(o.err, "4 triangles dropped where bodies touch")) << o.err;
  EXPECT_NEAR(Json::parse(read("j.json"))["stock"]["volume"].get<double>(), 120000, 1e-3);
  write("one.off",
        "OFF\n8 6 0\n0 -60 0\n200 -60 0\n0 0 0\n200 0 0\n0 -60 10\n200 -60 10\n"
        "0 0 10\n200 0 10\n4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n"
        "4 0 4 6 2\n4 1 3 7 5\n");
  EXPECT_EQ(run("compare two.off one.off --accept 0.001").code, 0);
  write("cut.off", off_text(joined(two, block(300, 0))));  // a third one apart
  EXPECT_EQ(run("compare cut.off cut.off --accept 0.001").code, 0);
}

// As STL, where corners have no numbers, they were one body before.
TEST_F(StockRepair, TakesABodyThatIsThereTwiceOnce) {
  const Facets body = block(0, 0);
  Facets inverse = body;
  for (auto& t : inverse.triangles) std::swap(t[0], t[1]);
  expect_refused(joined(body, inverse), "nothing is left");
  write("twice.off", off_text(joined(body, body)));
  const Outcome o = run("PRIMER_2F.MPF --voxel 1 --stock twice.off --json j.json -o part.stl");
  ASSERT_EQ(o.code, 0) << o.err;
  EXPECT_TRUE(contains(o.err, "12 double triangles dropped")) << o.err;
  EXPECT_NEAR(Json::parse(read("j.json"))["stock"]["volume"].get<double>(), 60000, 1e-3);
}

TEST_F(StockRepair, RefusesBodiesWithinOthersOrInsideOut) {
  const auto turned = [](Facets f) {
    for (auto& t : f.triangles) std::swap(t[0], t[1]);
    return f;
  };
  const auto small = [](double x) {
    Facets f = block();
    for (Corner& c : f.corners) c = {x + 0.1 * c[0], 0.1 * c[1] - 20, 0.1 * c[2] + 2};
    return f;
  };
  expect_refused(joined(block(), small(40)), "a body lies within another at (4");
  expect_refused(joined(block(), turned(small(140))), "the body at (14");
  expect_refused(joined(block(), turned(small(140))), "is inside out");
  write("stock.off", off_text(joined(block(), turned(small(40)))));  // a cavity
  EXPECT_EQ(run("PRIMER_2F.MPF --stock stock.off --voxel 1 -o part.stl").code, 0);
}

// CGAL drew ray after ray from points on the line.
TEST_F(StockRepair, RefusesBodiesThatAreLines) {
  Facets line = joined(block(), block(20));
  for (Corner& c : line.corners) c[0] = c[1] = c[2] = c[0] + c[1] + c[2];
  expect_refused(line, "stock.off: ");
}

TEST_F(StockRepair, RefusesWallsInside) {
  Facets wall = block();
  wall.triangles.push_back({0, 3, 7});
  expect_refused(wall, "stock.off: ");
}

TEST_F(StockRepair, StrictRunsTakeNoRepairedStock) {
  Facets inside_out = block();
  for (auto& t : inside_out.triangles) std::swap(t[0], t[1]);
  write("stock.off", off_text(inside_out));
  const Outcome o = run("PRIMER_2F.MPF --strict --stock stock.off --voxel 1 -o part.stl");
  EXPECT_NE(o.code, 0);
  EXPECT_FALSE(exists("part.stl"));
}

class StockWrap : public CliTest {
 protected:
  // Cut in the air: the stock as it was read.
  Json stock(const std::string& words) {
    write("air.MPF", "G17 G90 G71\nT1 M6\nG0 X-50 Y-90 Z50\nG1 X-60 F500\nM30\n");
    const Outcome o = run(
        "air.MPF --machine mill --tool 1=endmill:d=5 --voxel 1 -q --json r.json --stock " + words);
    EXPECT_EQ(o.code, 0) << o.err;
    expect_valid("run", "r.json");
    return Json::parse(read("r.json"), nullptr, false)["stock"];
  }
};

TEST_F(StockWrap, BoxWithoutItsTopIsTheBox) {
  Facets box = block(0, 0);
  std::erase(box.triangles, std::vector<int>{4, 5, 7});
  std::erase(box.triangles, std::vector<int>{4, 7, 6});
  write("open.off", off_text(box));
  expect_failure("PRIMER_2F.MPF --stock open.off", 1, "mesh-open");
  const double area = 2 * (100 * 60 + 100 * 10 + 60 * 10), exact = 100 * 60 * 10;
  for (const double w : {0.4, 0.2}) {
    const Json found = stock("open.off --stock-repair wrap=" + std::to_string(w));
    EXPECT_EQ(found["repair"]["openings"], 1);
    EXPECT_NEAR(found["repair"]["widest"].get<double>(), 100, 1e-3);
    const double most = found["repair"]["distance"][1];
    EXPECT_LE(most, w);
    EXPECT_LE(found["repair"]["distance"][0], most);
    EXPECT_NEAR(found["volume"].get<double>(), exact, area * most);
    EXPECT_NEAR(found["volume"].get<double>(), exact, 0.002 * exact);
  }
}

// Triangles whose corners are each somewhere else by up to 0.05 mm: no two of them meet.
TEST_F(StockWrap, SphereOfApartTrianglesIsASphere) {
  constexpr double kPi = 3.14159265358979323846, kRadius = 20, kNoise = 0.05;
  constexpr int kRound = 90, kDown = 45;
  unsigned state = 1;
  Facets sphere;
  const auto add = [&](int i, int j) {
    state = state * 1664525u + 1013904223u;
    const double r = kRadius + kNoise * (state / 2147483648.0 - 1);
    const double t = kPi * j / kDown, p = 2 * kPi * i / kRound;
    sphere.corners.push_back(
        {r * std::sin(t) * std::cos(p), r * std::sin(t) * std::sin(p), r * std::cos(t)});
  };
  const auto triangle = [&](std::vector<std::pair<int, int>> at) {
    const int k = static_cast<int>(sphere.corners.size());
    for (const auto& [i, j] : at) add(i, j);
    sphere.triangles.push_back({k, k + 1, k + 2});
  };
  for (int j = 0; j < kDown; ++j)
    for (int i = 0; i < kRound; ++i) {
      if (j > 0) triangle({{i, j}, {i, j + 1}, {i + 1, j}});
      if (j + 1 < kDown) triangle({{i + 1, j}, {i, j + 1}, {i + 1, j + 1}});
    }
  write("sphere.off", off_text(sphere));
  const Json found = stock("sphere.off --stock-repair wrap=0.2");
  EXPECT_EQ(found["repair"]["openings"], 0);
  // The wrap lies within `most` of the triangles, which lie within the noise and a chord of the
  // sphere.
  const double chord = kRadius * (1 - std::cos(kPi / kDown));
  const double most = found["repair"]["distance"][1];
  EXPECT_LT(most, 0.2);
  const double exact = 4.0 / 3 * kPi * std::pow(kRadius, 3), area = 4 * kPi * kRadius * kRadius;
  EXPECT_NEAR(found["volume"].get<double>(), exact, area * (most + kNoise + chord));
  EXPECT_NEAR(found["volume"].get<double>(), exact, 0.005 * exact);
}

// The run without the wrap keeps to it.
TEST_F(StockWrap, KeepsToTheLimitOfMemory) {
  if (!kIsPlain) GTEST_SKIP();
  Facets box = block(0, 0);
  std::erase(box.triangles, std::vector<int>{4, 5, 7});
  write("open.off", off_text(box));
  write("kept.stl", "old");
  const std::string words = "PRIMER_2F.MPF --stock open.off --stock-repair wrap=0.2 --voxel 1 -o ";
  expect_failure(words + "kept.stl --max-memory 35M", 1, "--stock-repair wrap=0.2 takes");
  EXPECT_TRUE(read("kept.stl") == "old");
}

TEST_F(StockWrap, WhatItCannotDoIsSaid) {
  write("block.off", off_text(block()));
  expect_failure("PRIMER_2F.MPF --stock block.off --stock-repair glue", 2, "wrap=0.2");
  expect_failure("PRIMER_2F.MPF --stock block.off --stock-repair wrap=0", 2, "--stock-repair");
  expect_failure("PRIMER_2F.MPF --stock block.off --stock-repair wrap=1e-5", 2, "triangles");
  expect_failure("PRIMER_2F.MPF --stock block.off --stock-repair wrap=1e-300", 2, "a wrap of 0.03");
  expect_failure("PRIMER_2F.MPF --stock block.off --stock-repair wrap=1,1e-9", 2, "a gap of 0.3");
  // A needle has hardly any area, but the wrap goes round it.
  const Facets needle = {{{0, 0, 0}, {1e6, 0, 0}, {0, 1e-4, 0}, {0, 0, 1e-4}},
                         {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  write("needle.off", off_text(needle));
  expect_failure("PRIMER_2F.MPF --stock needle.off --stock-repair wrap=0.1", 2, "triangles");
}

// Bodies that are nearly in one place cross by pairs of triangles, the square of their number: the
// search ends early, with coordinates as mrsim writes them (a 128th) and with others.
TEST_F(StockRepair, ManyBodiesInOnePlaceAreRefusedAtOnce) {
  for (const double step : {0.01, 1.0 / 128}) {
    Facets all = block();
    for (int i = 1; i < 600; ++i) all = joined(all, block(step * i));
    write("stock.off", off_text(all));
    const Outcome outcome = run("PRIMER_2F.MPF --stock stock.off --json r.json");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_TRUE(contains(outcome.err, "100000 or more pairs of triangles")) << outcome.err;
    if (kIsPlain) {
      EXPECT_LT(Json::parse(read("r.json"))["memory"]["peak"], 60e6) << step;
    }
  }
}

}  // namespace
}  // namespace mrsim
