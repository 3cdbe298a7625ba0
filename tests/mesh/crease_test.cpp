#include "mesh/points/crease.h"

#include "core/numbers/units.h"
#include "mesh/points/vertex.h"
#include "removal/part/part_field.h"
#include "support/analytic_field.h"
#include "support/moves.h"
#include "support/shapes.h"
#include "support/tools.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using detail::CreaseSearch;
using testing::Cut;

// A row of ball ends of radius 1 in short pieces, from one point to another at z = 1.
void add_row(const Vec2& from, const Vec2& to, int pieces, std::vector<Cut>& cuts) {
  for (int k = 0; k < pieces; ++k) {
    Cut cut;
    cut.kind = Cut::Kind::ball;
    cut.path.a = from + (static_cast<double>(k) / pieces) * (to - from);
    cut.path.b = from + (static_cast<double>(k + 1) / pieces) * (to - from);
    cut.r = 1, cut.z = 1;
    cuts.push_back(cut);
  }
}

// Two rows in a V: where the cusp between them is as high as the plane z = 0.2, the distance of a
// point of the bisector from both is 0.6. Asked from pieces by which it is not drawn.
TEST(Crease, IsFoundByExchangeOfShortMoves) {
  constexpr int kPieces = 16;
  const double angle = std::atan2(0.4, 1.0);
  const Vec2 end{1, 1.4};
  std::vector<Cut> cuts;
  add_row({0, 0}, {1, 0}, kPieces, cuts);
  add_row({0, 1}, end, kPieces, cuts);
  const testing::AnalyticField field({{-5, -5, -5}, {5, 5, 1}}, false, cuts);
  const auto all = field.all();
  const detail::Probe probe{field, all};
  const Box3 room{{0.2, 0.2, 0.2}, {1, 1.2, 0.2}};
  const Vec3 from{0.66, 0.6, 0.2};
  const Vec2 foot = Vec2{0.47, 1.188} - 0.6 * Vec2{-std::sin(angle), std::cos(angle)};
  const Vec3 to{foot.x, foot.y, 0.2};
  const FieldSample a = field.sample(from, all), b = field.sample(to, all);
  ASSERT_EQ(a.owner, 10);
  ASSERT_EQ(b.owner, kPieces + 7);

  detail::SurfacePoint found;
  ASSERT_EQ(crease_by_exchange(probe, room, 2, 0.5 * (from + to), a, b, found),
            CreaseSearch::found);
  // y = 0.6 for the row along x, and 0.6 below the other one.
  const double x = (0.6 + 0.6 / std::cos(angle) - 1) / std::tan(angle);
  EXPECT_NEAR(found.position.x, x, 1e-6);
  EXPECT_NEAR(found.position.y, 0.6, 1e-6);
  EXPECT_EQ(found.position.z, 0.2);
  EXPECT_EQ(found.count, 2);
  EXPECT_EQ(found.faces[0].owner, static_cast<int>(x * kPieces));
}

// Two pieces of one row join smoothly by what lies between them.
TEST(Crease, IsToldFromARowOfShortMoves) {
  std::vector<Cut> cuts;
  add_row({0, 0}, {1, 0}, 4, cuts);
  const testing::AnalyticField field({{-5, -5, -5}, {5, 5, 1}}, false, cuts);
  const auto all = field.all();
  const detail::Probe probe{field, all};
  const Box3 room{{-1.1, 0.5, 0.2}, {2.1, 0.7, 0.2}};
  const Vec3 from{0, 0.6, 0.2}, to{1, 0.6, 0.2};
  const auto found =
      crease_in_face(probe, room, 2, from, field.sample(from, all), to, field.sample(to, all));
  EXPECT_FALSE(found && found->count > 0);
}

// Between two rows a cusp passes a cell, whose faces it meets between other pieces on each side.
TEST(Crease, PassesACellOfShortMoves) {
  constexpr int kPieces = 32;
  std::vector<Cut> cuts;
  add_row({0, 0}, {1, 0}, kPieces, cuts);
  add_row({0, 1.2}, {1, 1.2}, kPieces - 1, cuts);
  const testing::AnalyticField field({{-5, -5, -5}, {5, 5, 1}}, false, cuts);
  const auto all = field.all();
  const detail::Probe probe{field, all};
  const Box3 room{{0.3, 0.45, 0.1}, {0.6, 0.75, 0.4}};
  std::vector<detail::SurfacePoint> ends;
  for (const double x : {room.lo.x, room.hi.x}) {
    Box3 side = room;
    side.lo.x = side.hi.x = x;
    const Vec3 from{x, 0.5, 1 - std::sqrt(0.75)}, to{x, 0.7, 1 - std::sqrt(0.75)};
    const auto end =
        crease_in_face(probe, side, 0, from, field.sample(from, all), to, field.sample(to, all));
    ASSERT_TRUE(end && end->count == 2);
    EXPECT_NEAR(end->position.y, 0.6, 1e-6);
    EXPECT_NEAR(end->position.z, 0.2, 1e-6);
    ends.push_back(*end);
  }
  const std::vector<Vec3> crossings = {ends[0].position, ends[1].position};
  const std::vector<FieldSample> faces = {ends[0].faces[0], ends[0].faces[1], ends[1].faces[0],
                                          ends[1].faces[1]};
  const detail::SurfacePoint found = point_in_cell(probe, room, {crossings, faces, ends});
  ASSERT_EQ(found.count, 2);
  EXPECT_NEAR(found.position.x, 0.45, 0.01);
  EXPECT_NEAR(found.position.y, 0.6, 1e-6);
  EXPECT_NEAR(found.position.z, 0.2, 1e-6);
}

// On a slight slope the floor of a tip turns up into the flank within less than a micrometre: the
// two join smoothly, and that is a crease for a cell.
TEST(Crease, IsFoundWhereAFloorTurnsUpIntoAFlank) {
  const StockShape shape = testing::box_stock({0, 0, -3}, {10, 10, 0});
  Tool vee = testing::mill(ToolType::chamfer, 3);
  vee.tip_angle = radians(90), vee.tip_diameter = 0.2;
  const Motion m = testing::line({-3, 5, -0.4}, {13, 5, -0.5});
  const PartField field(StockSolid(shape), SweepTable(std::span(&m, 1), std::span(&vee, 1)));
  const Candidates all = field.all();
  const detail::Probe probe{field, all, 0.01};
  for (double x = 1; x < 9; x += 0.37) {
    const Vec3 from = detail::find_place(probe, {x, 5.03, -2}, {x, 5.03, 0.1}),
               to = detail::find_place(probe, {x, 5.14, -2}, {x, 5.14, 0.1});
    const FieldSample floor = field.sample(from, all), flank = field.sample(to, all);
    ASSERT_NE(floor.patch, flank.patch);
    const Box3 room{{x, 5, -0.6}, {x, 5.25, -0.3}};
    const auto found = crease_in_face(probe, room, 0, from, floor, to, flank);
    ASSERT_TRUE(found && found->count == 2) << x;
    EXPECT_NEAR(found->position.y, 5.1, 1e-5);
    EXPECT_NEAR(found->position.z, from.z, 1e-3);
  }
}

}  // namespace
}  // namespace mrsim
