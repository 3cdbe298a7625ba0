// Profiles and inserts: shapes, exact distances, refusals.
#include "removal/tool/tool.h"

#include "core/numbers/units.h"
#include "support/rounds.h"
#include "sweep_support.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

Tool form(std::vector<ProfilePoint> points) {
  Tool t = mill(ToolType::form, 0);
  t.profile = std::move(points);
  return t;
}

// The outline as points, dense; rays to z = 40.
std::vector<Vec2> outline(const Profile& p, int n = 4000) {
  std::vector<Vec2> out;
  for (const ProfileEdge& e : p.edges()) {
    const Vec2 b = {e.b.x, std::min(e.b.y, 40.0)};
    for (int i = 0; i <= n; ++i) {
      const double t = i / double(n);
      Vec2 q = e.a + t * (b - e.a);
      if (e.radius > 0) {
        double from = std::atan2(e.a.y - e.center.y, e.a.x - e.center.x);
        double to = std::atan2(e.b.y - e.center.y, e.b.x - e.center.x);
        if (e.convex && to < from) to += kTwoPi;
        if (!e.convex && to > from) to -= kTwoPi;
        const double a = from + t * (to - from);
        q = e.center + e.radius * Vec2{std::cos(a), std::sin(a)};
      }
      out.push_back(q);
    }
  }
  return out;
}

double to_segment(Vec2 a, Vec2 b, Vec2 q) {
  const Vec2 d = b - a;
  const double t = dot(d, d) > 0 ? std::clamp(dot(q - a, d) / dot(d, d), 0.0, 1.0) : 0;
  return length(q - a - t * d);
}

// Widest r of the outline at height z, by its samples: inside means r below it.
bool inside(const std::vector<Vec2>& points, Vec2 q) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2 a = points[i - 1], b = points[i];
    if (a.y <= q.y && q.y < b.y) return q.x < a.x + (q.y - a.y) / (b.y - a.y) * (b.x - a.x);
  }
  return false;
}

std::vector<Tool> tools() {
  std::vector<Tool> t = {endmill(6), endmill(6, 1), ballmill(6), endmill(6, 0, 9), ballmill(6, 2)};
  t.push_back(mill(ToolType::chamfer, 8));
  t.push_back(mill(ToolType::drill, 5));
  t.push_back(mill(ToolType::taper, 9));
  t.back().taper_angle = radians(10);
  t.back().tip_diameter = 4;
  t.back().corner_radius = 0.7;
  t.push_back(mill(ToolType::tslot, 10));
  t.back().flute_length = 3;
  t.back().corner_radius = 0.5;
  t.push_back(mill(ToolType::lollipop, 6));
  t.back().neck_diameter = 3;
  t.push_back(mill(ToolType::barrel, 8));
  t.back().profile_radius = 30;
  t.back().corner_radius = 2;
  t.back().flute_length = 16;
  t.push_back(mill(ToolType::taper, 5));  // the tip's arc has its centre at the height of the lid
  t.back().corner_radius = 2;
  t.back().taper_angle = 1.45;
  t.back().flute_length = 2;
  t.push_back(form({{0, 0, 0}, {2, 0, 0}, {2, 1, -0.4142}, {5, 4, 0}, {5, 6, 0}}));
  t.push_back(form({{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 3, 0.2}, {3, 5, 0}, {0, 6, 0}}));
  return t;
}

TEST(Profile, DistanceIsThatOfTheOutlineSignedByTheInside) {
  Random r(1);
  for (const Tool& tool : tools()) {
    const Profile profile = make_cutter(tool);
    const std::vector<Vec2> points = outline(profile);
    for (unsigned k = 0; k < rounds(300); ++k) {
      const Vec2 q = {r(0, 9), r(-4, 20)};
      double want = 1e300;
      for (std::size_t i = 1; i < points.size(); ++i)
        want = std::min(want, to_segment(points[i - 1], points[i], q));
      if (inside(points, q)) want = -want;
      EXPECT_NEAR(profile.distance(q), want, 1e-6) << "tool type " << static_cast<int>(tool.type);
      const ProfileSample s = profile.sample(q);
      EXPECT_EQ(s.distance, profile.distance(q));
      const double h = 1e-6;
      const Vec2 g = {
          (profile.distance({q.x + h, q.y}) - profile.distance({q.x - h, q.y})) / 2 / h,
          (profile.distance({q.x, q.y + h}) - profile.distance({q.x, q.y - h})) / 2 / h};
      EXPECT_LT(length(g) > 0.9999 ? length(g - s.gradient) : 0, 1e-4);
    }
  }
}

TEST(Profile, RadiusBelowAHeightIsTheLargestOfTheOutlineUpToIt) {
  Random r(2);
  for (const Tool& tool : tools()) {
    const Profile profile = make_cutter(tool);
    const std::vector<Vec2> points = outline(profile);
    for (int k = 0; k < 30; ++k) {
      const double z = r(0.01, 12);
      double want = 0;
      for (const Vec2& p : points)
        if (p.y <= z) want = std::max(want, p.x);
      EXPECT_NEAR(profile.max_radius_below(z), want, 0.02)
          << static_cast<int>(tool.type) << ' ' << z;
      EXPECT_GE(profile.max_radius_below(z), want);
    }
  }
}

TEST(Profile, FlagsTellWhatTheSweepsRelyOn) {
  EXPECT_TRUE(make_cutter(endmill(6)).is_end_mill());
  EXPECT_TRUE(make_cutter(endmill(6, 0, 9)).is_end_mill());
  EXPECT_FALSE(make_cutter(ballmill(6, 2)).is_end_mill());
  EXPECT_TRUE(make_cutter(ballmill(6)).is_ball_end());
  for (const Tool& tool : tools()) {
    const Profile p = make_cutter(tool);
    EXPECT_EQ(p.open_top(), std::isinf(p.top()));
    EXPECT_EQ(p.is_convex(), tool.type != ToolType::form);
    EXPECT_TRUE(p.is_unimodal() || tool.type == ToolType::form);
  }
  Tool slot = mill(ToolType::tslot, 10);
  slot.flute_length = 3;
  EXPECT_FALSE(make_cutter(slot).is_rising());
  EXPECT_TRUE(make_cutter(mill(ToolType::drill, 5)).is_rising());
  EXPECT_TRUE(make_cutter(mill(ToolType::drill, 5)).has_sharp_tip());
  EXPECT_FALSE(make_cutter(ballmill(6)).has_sharp_tip());
  EXPECT_FALSE(make_cutter(endmill(6)).has_sharp_tip());
}

TEST(Profile, SmoothJointsShareAPatchAndCornersDoNot) {
  const Profile bull = make_cutter(endmill(6, 1));
  EXPECT_EQ(bull.edges().back().patch, 0);
  const Profile flat = make_cutter(endmill(6));
  EXPECT_EQ(flat.edges().back().patch, 1);
  Tool barrel = mill(ToolType::barrel, 8);
  barrel.profile_radius = 30;
  barrel.corner_radius = 2;
  EXPECT_EQ(make_cutter(barrel).edges().back().patch, 0);
}

TEST(Profile, DrillPointHasItsAngle) {
  const Profile p = make_cutter(mill(ToolType::drill, 10));
  EXPECT_NEAR(p.edges()[0].b.y, 5 / std::tan(radians(59)), 1e-12);
  EXPECT_NEAR(p.distance({0, -1}), 1, 1e-12);
}

TEST(Profile, DrawnOutIsTheUnionOfAllHeights) {
  Random r(9);
  for (const Tool& tool : tools()) {
    const Profile p = make_cutter(tool);
    if (p.open_top() || !p.is_unimodal()) continue;
    const Profile drawn = p.drawn_out(5);
    for (int k = 0; k < 200; ++k) {
      const Vec2 q = {r(0, 9), r(-4, 25)};
      const double want = least([&](double t) { return p.distance({q.x, q.y - 5 * t}); }, 200);
      EXPECT_LE(drawn.distance(q), want + 1e-7);
      EXPECT_GE(drawn.distance(q), want > 0 ? want - 1e-7 : -100);
    }
  }
}

void expect_invalid(Tool tool, const char* part) {
  tool.id = "7";
  try {
    make_tool_shape(tool);
    ADD_FAILURE() << "accepted: " << part;
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), "tool-invalid");
    EXPECT_NE(std::string(e.what()).find("tool 7"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
  }
}

TEST(Profile, WidthIsTheHeightOfATSlotHead) {
  Tool slot = mill(ToolType::tslot, 10);
  slot.flute_length = 8, slot.width = 2;
  EXPECT_EQ(make_cutter(slot).top(), 2);
  slot.flute_length = 0;
  EXPECT_EQ(make_cutter(slot).top(), 2);
  slot.width = 0, slot.flute_length = 8;
  EXPECT_EQ(make_cutter(slot).top(), 8);
  slot.width = 9;
  expect_invalid(slot, "larger than the flute length");
}

// A thread mill with its neck, two of its teeth, a slot mill, a stepped drill, a groove with a
// point, a ball on its neck, and bulbs of one arc.
TEST(Profile, ConvexPiecesTogetherAreTheSolid) {
  const std::vector<std::vector<ProfilePoint>> profiles = {
      {{0, 0, 0}, {4, 0, 0}, {5, 0.5, 0}, {4, 1, 0}, {4, 20, 0}},
      {{0, 0, 0}, {4, 0, 0}, {5, 1, 0}, {4, 2, 0}, {5, 3, 0}, {4, 4, 0}, {2, 4, 0}, {2, 9, 0}},
      {{0, 0, 0}, {5, 0, 0}, {5, 3, 0}, {2, 3, 0}, {2, 20, 0}},
      {{0, 0, 0}, {2, 1, 0}, {2, 6, 0}, {4, 8, 0}, {4, 15, 0}},
      {{0, 0, 0}, {5, 1, 0}, {3, 4, 0}, {6, 8, 0}, {6, 15, 0}},
      {{0, 0, 0}, {3, 3, std::tan(kPi / 8)}, {2, 4, 0}, {2, 8, 0}},
      {{0, 0, 0}, {1, 0, 0.6}, {2, 4, 0}, {2, 10, 0}},
      {{0, 0, 0}, {2, 0, 0}, {2, 3, 0.6}, {1, 7, 0}, {1, 12, 0}}};
  for (const auto& points : profiles) {
    const Profile whole = make_cutter(form(points));
    ASSERT_FALSE(whole.is_convex());
    ASSERT_GE(whole.convex_pieces().size(), 2u);
    Random r(17);
    for (int k = 0; k < 4000; ++k) {
      const Vec2 q{r(0, 8), r(-2, 18)};
      double least = 1e9;
      for (const Profile& piece : whole.convex_pieces()) {
        EXPECT_TRUE(piece.is_convex());
        least = std::min(least, piece.distance(q));
      }
      const double d = whole.distance(q);
      if (d >= 0)
        EXPECT_NEAR(least, d, 1e-9);
      else
        EXPECT_TRUE(least < 0 && least >= d - 1e-9)
            << q.x << ' ' << q.y << ' ' << least << ' ' << d;
    }
  }
}

TEST(Profile, ConvexProfilesAndArcsThatTurnFarHaveNoPieces) {
  EXPECT_TRUE(make_cutter(form({{0, 0, 0}, {2, 0, 0}, {5, 3, 0}})).convex_pieces().empty());
  const double far = std::tan(radians(160) / 4);
  EXPECT_TRUE(make_cutter(form({{0, 0, 0}, {5, 0, 0}, {5, 1, -far}, {5, 3, 0}, {5, 6, 0}}))
                  .convex_pieces()
                  .empty());
}

// Arcs that join an edge smoothly but for the last digits of their bulge.
TEST(Profile, PlacesAcrossAnAlmostSmoothCornerHaveTheirSide) {
  for (const double quarter : {0.41421356, 0.414213, 0.4142, 0.414}) {
    const Profile hollow =
        make_cutter(form({{0, 0, 0}, {2, 0, 0}, {2, 1, -quarter}, {5, 4, 0}, {5, 6, 0}}));
    const Profile bull = make_cutter(form({{0, 0, 0}, {2, 0, quarter}, {5, 3, 0}, {5, 6, 0}}));
    for (const double off : {0.1, 0.5, 1.0, 1.5}) {
      EXPECT_NEAR(hollow.distance({2 + off, 1}), off, 1e-3) << quarter;
      EXPECT_NEAR(hollow.distance({2 - 0.5 * off, 1}), -0.5 * off, 1e-3) << quarter;
      EXPECT_NEAR(bull.distance({2, off}), -off, 1e-3) << quarter;
      EXPECT_NEAR(bull.distance({5 - off, 3}), -off, 1e-3) << quarter;
      EXPECT_NEAR(bull.distance({5 + off, 3}), off, 1e-3) << quarter;
    }
  }
}

// Between the pieces and the arc lies what search_fillet() looks at.
TEST(Profile, PiecesBesideAConcaveArcEndAtItsTangents) {
  const double quarter = std::tan(kPi / 8);
  const Profile whole =
      make_cutter(form({{0, 0, 0}, {2, 0, 0}, {2, 1, -quarter}, {5, 4, 0}, {5, 6, 0}}));
  ASSERT_GE(whole.convex_pieces().size(), 2u);
  const auto least = [&](Vec2 q) {
    double d = std::numeric_limits<double>::infinity();
    for (const Profile& piece : whole.convex_pieces()) d = std::min(d, piece.distance(q));
    return d;
  };
  EXPECT_NEAR(least({2.5, 3}), 0.5, 1e-9);  // from the tangent at the arc's begin
  EXPECT_LT(whole.distance({2.5, 3}), 0);
  EXPECT_NEAR(least({2.5, 0.5}), whole.distance({2.5, 0.5}), 1e-9);
  EXPECT_NEAR(least({6, 5}), whole.distance({6, 5}), 1e-9);
}

TEST(ToolShape, RefusesWhatCannotBe) {
  expect_invalid(endmill(0), "diameter is missing");
  expect_invalid(endmill(-1), "negative");
  expect_invalid(endmill(std::nan("")), "not a number");
  expect_invalid(endmill(6, 4), "corner radius");
  expect_invalid(mill(ToolType::taper, 6), "taper angle");
  expect_invalid(mill(ToolType::tslot, 6), "flute length");
  expect_invalid(mill(ToolType::barrel, 6), "profile radius");
  expect_invalid(form({}), "profile of two points");
  expect_invalid(form({{1, 0, 0}, {2, 1, 0}}), "on the axis");
  expect_invalid(form({{0, 0, 0}, {2, 0, 0}, {3, -1, 0}}), "goes down");
  expect_invalid(form({{0, 0, 0}, {2, 0, 0}, {-1, 2, 0}}), "crosses the axis");
  Tool neck = mill(ToolType::lollipop, 6);
  neck.neck_diameter = 6;
  expect_invalid(neck, "neck");
  neck.type = ToolType::tslot;
  neck.width = 2;
  expect_invalid(neck, "neck");
  Tool insert = mill(ToolType::turning, 0);
  insert.insert = "XNMG";
  expect_invalid(insert, "insert shape");
  insert.insert = "V";
  insert.nose_radius = 6;
  expect_invalid(insert, "nose radius");
  insert.nose_radius = 0;
  insert.tip = 10;
  expect_invalid(insert, "orientation");
}

TEST(Insert, DefaultIsASharpFinishingInsertWithItsTipAtTheProgrammedPoint) {
  Tool tool = mill(ToolType::turning, 0);
  const InsertOutline o = make_insert(tool);
  ASSERT_EQ(o.core.size(), 4u);
  EXPECT_EQ(o.round, 0);
  double low_x = 1e300, low_z = 1e300, area = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 a = o.core[i], b = o.core[(i + 1) % 4];
    low_x = std::min(low_x, a.x), low_z = std::min(low_z, a.y), area += cross(a, b) / 2;
    EXPECT_NEAR(length(b - a), 16, 1e-12);
  }
  EXPECT_NEAR(area, 16 * 16 * std::sin(radians(35)), 1e-10);
  EXPECT_EQ(low_x, 0);  // the tip is the lowest point in X, and the foremost in Z
  EXPECT_EQ(low_z, 0);
}

TEST(Insert, LeftHandMirrorsZAndInsideMirrorsX) {
  Tool tool = mill(ToolType::turning, 0);
  const InsertOutline right = make_insert(tool);
  tool.left_hand = true;
  const InsertOutline left = make_insert(tool);
  tool.type = ToolType::boring;
  tool.left_hand = false;
  const InsertOutline bore = make_insert(tool);
  EXPECT_TRUE(bore.inside);
  double right_z = 0, left_z = 0, bore_x = 0;
  for (Vec2 v : right.core) right_z = std::max(right_z, v.y);
  for (Vec2 v : left.core) left_z = std::min(left_z, v.y);
  for (Vec2 v : bore.core) bore_x = std::min(bore_x, v.x);
  EXPECT_NEAR(left_z, -right_z, 1e-12);
  EXPECT_LT(bore_x, -10);
}

TEST(Insert, ToothIsAsWideAsItSays) {
  Tool tool;
  tool.type = ToolType::threading;
  tool.width = 1.5;
  const InsertOutline out = make_insert(tool);
  double low = 0, high = 0;
  for (const Vec2& v : out.core) low = std::min(low, v.y), high = std::max(high, v.y);
  EXPECT_NEAR(low, -0.75, 1e-12);
  EXPECT_NEAR(high, 0.75, 1e-12);
  tool.nose_radius = 0.2;
  EXPECT_EQ(make_insert(tool).core.size(), 5u);
}

TEST(Insert, BladeIsAsWideAsItSays) {
  for (int tip : {0, 3, 4, 8, 2, 1, 6, 7, 5}) {
    Tool tool = mill(ToolType::grooving, 0);
    tool.width = 4;
    tool.nose_radius = 0.3;
    tool.tip = tip;
    const InsertOutline o = make_insert(tool);
    Vec2 lo = {1e9, 1e9}, hi = {-1e9, -1e9};
    double area = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec2 v = o.core[i];
      lo = {std::min(lo.x, v.x - 0.3), std::min(lo.y, v.y - 0.3)};
      hi = {std::max(hi.x, v.x + 0.3), std::max(hi.y, v.y + 0.3)};
      area += cross(v, o.core[(i + 1) % 4]);
    }
    EXPECT_GT(area, 0) << "counter-clockwise";
    const bool face = tip == 7 || tip == 5;
    EXPECT_NEAR(face ? hi.x - lo.x : hi.y - lo.y, 4, 1e-12) << tip;
    EXPECT_NEAR(face ? hi.y - lo.y : hi.x - lo.x, 16, 1e-12) << tip;
    // The programmed point touches the working end.
    const double touch = face ? std::min(std::fabs(lo.y), std::fabs(hi.y))
                              : std::min(std::fabs(lo.x), std::fabs(hi.x));
    EXPECT_NEAR(touch, 0, 1e-12) << tip;
  }
}

}  // namespace
}  // namespace mrsim
