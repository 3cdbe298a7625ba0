// Enclosures of faces on triangles against dense samples: random tools, moves and triangles of all
// sizes about the surface, some of them with corners off it.
#include "removal/field/face_range.h"

#include "core/numbers/units.h"
#include "removal/part/part_field.h"
#include "removal/sweep_support.h"
#include "support/shapes.h"
#include "support/tools.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using testing::arc;
using testing::line;
using testing::mill;
using testing::Random;

constexpr double kRoundingRoom = 2e-9;  // mm, and searches that stop at 1e-13 of a distance

struct Count {
  int triangles = 0, known = 0;
  double tightness = 0;  // sum of largest sample / largest bound

  void operator+=(const Count& o) {
    triangles += o.triangles, known += o.known, tightness += o.tightness;
  }
};

// What a range may enclose: the distance of the face, or that of all that its owner has left.
FaceRange sampled(const ExactField& field, const Corners3& t, const FieldSample& face,
                  bool of_owner) {
  constexpr int n = 12;
  FaceRange range{1e300, -1e300};
  const Candidates owner{0};
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const double u = double(i) / n, v = double(j) / n;
      const Vec3 p = (1 - u - v) * t[0] + u * t[1] + v * t[2];
      const auto& part = static_cast<const PartField&>(field);
      const double g = of_owner ? -part.sweeps().distance(0, p) : field.patch_distance(p, face);
      range.lo = std::min(range.lo, g), range.hi = std::max(range.hi, g);
    }
  return range;
}

bool holds(const FaceRange& outer, const FaceRange& inner) {
  const double slack = kRoundingRoom + kBorder * kBorder;
  return inner.lo >= outer.lo - slack && inner.hi <= outer.hi + slack;
}

double size_of(const FaceRange& r) { return std::max(std::abs(r.lo), std::abs(r.hi)); }

// Samples on the triangle may not leave the range.
void check_triangle(const ExactField& field, const Corners3& t, const FieldSample& face,
                    Count& count, const std::string& what) {
  const FaceRange range = field.patch_range(t, face);
  ++count.triangles;
  if (!std::isfinite(range.lo)) return;
  ++count.known;
  FaceRange found = sampled(field, t, face, false);
  if (face.owner != kStockOwner && !holds(range, found)) found = sampled(field, t, face, true);
  EXPECT_TRUE(holds(range, found)) << what << " patch " << face.patch << ": " << found.lo << " .. "
                                   << found.hi << " in " << range.lo << " .. " << range.hi;
  count.tightness += size_of(range) > 1e-9 ? size_of(found) / size_of(range) : 1;
}

// Puts p on the face by steps along its normal; false if it does not get there.
bool put_on(const ExactField& field, const FieldSample& face, Vec3& p) {
  for (int k = 0; k < 20; ++k) {
    const double g = field.patch_distance(p, face);
    if (!(std::abs(g) < 100)) return false;
    p = p - g * field.gradient(p, face);
    if (std::abs(g) < 1e-9) return true;
  }
  return false;
}

// Triangles with corners on a face, of sizes between a hundredth of a millimetre and the part's.
Count check_faces(const ExactField& field, Random& random, int triangles, const std::string& what) {
  Count count;
  const Candidates all = field.all();
  const Vec3 lo = field.bounds().lo, size = field.bounds().hi - lo;
  for (int k = 0; k < 40 * triangles && count.triangles < triangles; ++k) {
    const Vec3 p = lo + Vec3{random(0, 1) * size.x, random(0, 1) * size.y, random(0, 1) * size.z};
    const FieldSample face = field.sample(p, all);
    if (face.owner == kStockOwner && !field.all().empty() && k % 64 != 0) continue;
    const double reach = std::pow(10, random(-2, 1));
    Corners3 t;
    bool on = true;
    for (Vec3& q : t) {
      q = p + Vec3{random(-reach, reach), random(-reach, reach), random(-reach, reach)};
      on = on && (k % 3 == 0 || put_on(field, face, q));
    }
    if (on) check_triangle(field, t, face, count, what);
  }
  return count;
}

std::vector<Tool> mills() {
  std::vector<Tool> tools{mill(ToolType::endmill, 6), mill(ToolType::ballmill, 6),
                          mill(ToolType::bullmill, 8, 1.5)};
  Tool drill = mill(ToolType::drill, 6);
  drill.tip_angle = radians(118);
  Tool chamfer = mill(ToolType::chamfer, 8);
  chamfer.tip_angle = radians(90), chamfer.tip_diameter = 1;
  Tool lollipop = mill(ToolType::lollipop, 8);
  lollipop.neck_diameter = 4;
  Tool taper = mill(ToolType::taper, 8, 1);
  taper.tip_diameter = 2, taper.taper_angle = radians(12);
  Tool slot = mill(ToolType::tslot, 12, 1);
  slot.flute_length = 4;
  for (const Tool& t : {drill, chamfer, lollipop, taper, slot}) tools.push_back(t);
  return tools;
}

PartField block(const std::vector<Motion>& motions, const Tool& tool) {
  const StockShape shape = testing::box_stock({0, 0, 0}, {40, 40, 20});
  return PartField(StockSolid(shape), SweepTable(motions, std::span(&tool, 1)));
}

// Most triangles are enclosed, and as closely as samples on a tenth of their size tell.
void expect_useful(const Count& count, double least_known, const std::string& what) {
  EXPECT_GT(count.triangles, 100) << what;
  EXPECT_GE(count.known, least_known * count.triangles) << what;
  EXPECT_GE(count.tightness, 0.75 * count.known) << what;
}

TEST(FaceRange, FacesOfLevelLinesArcsAndPlungesLieInTheirRange) {
  Random random(1);
  for (const Tool& tool : mills()) {
    Count lines, arcs;
    for (int round = 0; round < 20; ++round) {
      const std::string what = "tool " + std::to_string(static_cast<int>(tool.type));
      const auto at = [&](double z) { return Vec3{random(0, 40), random(0, 40), z}; };
      const double z = random(4, 18);
      const Vec3 a = at(z);
      lines += check_faces(block({line(a, at(z))}, tool), random, 60, what);
      lines += check_faces(block({line({a.x, a.y, 25}, a)}, tool), random, 60, what);
      const Vec3 center = at(z);
      const double radius = std::pow(10, random(-0.5, 1.2));
      const double sweep = (round % 2 ? 1 : -1) * random(0.2, round % 5 == 0 ? kTwoPi : kPi);
      const double turn = round % 7 == 0 ? kTwoPi : sweep;
      const double angle = random(0, kTwoPi);
      const Vec3 start = center + radius * Vec3{std::cos(angle), std::sin(angle), 0};
      arcs += check_faces(block({arc(start, center, {0, 0, 1}, turn)}, tool), random, 60, what);
    }
    expect_useful(lines, 0.85, "lines, tool " + std::to_string(static_cast<int>(tool.type)));
    expect_useful(arcs, 0.8, "arcs, tool " + std::to_string(static_cast<int>(tool.type)));
  }
}

TEST(FaceRange, FacesOfSlantedLinesAndUprightArcsLieInTheirRange) {
  Random random(2);
  for (const Tool& tool : {mill(ToolType::ballmill, 6), mill(ToolType::bullmill, 8, 1.5),
                           mill(ToolType::endmill, 6)}) {
    Count lines, arcs;
    for (int round = 0; round < 20; ++round) {
      const auto at = [&] { return Vec3{random(0, 40), random(0, 40), random(4, 18)}; };
      lines += check_faces(block({line(at(), at())}, tool), random, 60, "slanted");
      const Vec3 center = at();
      const double from = random(0, kTwoPi), plan = random(0, kTwoPi);
      const Vec3 u{std::cos(plan), std::sin(plan), 0}, axis = cross(u, {0, 0, 1});
      const double radius = random(1, 15);
      const Vec3 start = center + radius * std::cos(from) * u + Vec3{0, 0, radius * std::sin(from)};
      const double sweep = random(0.3, round % 4 ? kPi / 2 : kTwoPi);
      arcs += check_faces(block({arc(start, center, axis, sweep)}, tool), random, 60, "upright");
    }
    expect_useful(lines, 1, "slanted lines");
    expect_useful(arcs, tool.type == ToolType::ballmill ? 0.5 : 0, "upright arcs");
  }
}

// A ramp along a wall: below the mill's lower edge the wall is that of the pass beneath, on which
// triangles that reach down from the ramp's face lie.
TEST(FaceRange, TheWallOfASlantedLineIsEnclosedBelowIt) {
  const PartField field = block({line({10, 20, 12}, {30, 20, 10})}, mill(ToolType::endmill, 6));
  const Vec3 beside{20, 17, 14};
  const FieldSample wall = field.sample(beside, field.all());
  ASSERT_NEAR(wall.distance, 0, 1e-9);
  const FaceRange range = field.patch_range({Vec3{20, 17, 14}, {24, 17, 2}, {21, 17, 3}}, wall);
  EXPECT_LT(size_of(range), 1e-9) << range.lo << " .. " << range.hi;
}

TEST(FaceRange, RangesOfTurnedFacesHoldTheirSamples) {
  const StockShape shape = testing::round_stock(25, 0, 0, 50);
  Random random(3);
  for (const double nose : {0.0, 0.4, 1.2}) {
    Tool tool;
    tool.type = ToolType::turning;
    tool.insert_angle = radians(35);
    tool.lead_angle = radians(93);
    tool.edge_length = 16;
    tool.nose_radius = nose;
    Count lines, arcs;
    for (int round = 0; round < 20; ++round) {
      const auto at = [&] { return Vec3{random(-1, 24), 0, random(5, 45)}; };
      const Vec3 center = at();
      const double radius = random(0.5, 10), from = random(0, kTwoPi);
      const Vec3 start = center + radius * Vec3{std::cos(from), 0, std::sin(from)};
      const double sweep = (round % 2 ? 1 : -1) * random(0.3, kPi);
      for (const bool is_arc : {false, true}) {
        const std::vector<Motion> motions{is_arc ? arc(start, center, {0, 1, 0}, sweep)
                                                 : line(at(), at())};
        const PartField field(StockSolid(shape), SweepTable(motions, std::span(&tool, 1)));
        (is_arc ? arcs : lines) += check_faces(field, random, 60, is_arc ? "arc" : "line");
      }
    }
    expect_useful(lines, 1, "turned lines");
    expect_useful(arcs, 0.8, "turned arcs");
  }
}

TEST(FaceRange, FacesOfTubesAndBoxesLieInTheirRange) {
  StockShape tube;
  tube.kind = StockShape::Kind::tube;
  tube.axis_point = {3, -2, 0};
  tube.outer_radius = 25, tube.inner_radius = 8;
  tube.box = {{-22, -27, 0}, {28, 23, 50}};
  const StockShape box = testing::box_stock({0, 0, 0}, {40, 30, 20});
  Random random(4);
  for (const StockShape& shape : {tube, box}) {
    const PartField field(StockSolid(shape), SweepTable({}, {}));
    expect_useful(check_faces(field, random, 1000, "stock"), 1, "stock");
  }
}

TEST(FaceRange, RangesOfTiltedToolsHoldTheirSamples) {
  Random random(5);
  for (const ToolType type : {ToolType::endmill, ToolType::ballmill}) {
    Count count;
    for (int round = 0; round < 20; ++round) {
      const auto at = [&] { return Vec3{random(5, 35), random(5, 35), random(4, 18)}; };
      Motion m = line(at(), at());
      m.tool_axis = normalized(Vec3{random(-1, 1), random(-1, 1), 1.5});
      count += check_faces(block({m}, mill(type, 6)), random, 60, "tilted");
    }
    expect_useful(count, 1, "tilted");
  }
}

}  // namespace
}  // namespace mrsim
