// LinuxCNC's splines: arcs that keep to the curve, and G33.1.
#include "interp/path/arc.h"
#include "interp/support.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

using namespace mrsim::testing;

// The largest distance of the curve's points from the nearest point of the motions.
double deviation(const Program& program, const std::vector<Vec2>& control) {
  std::vector<Vec3> path;
  for (const Motion& m : program.motions)
    for (int i = 0; i <= 400; ++i) {
      const double t = i / 400.0;
      path.push_back(m.kind == MotionKind::arc
                         ? arc_point(m, t)
                         : Vec3{m.start.x + t * (m.end.x - m.start.x),
                                m.start.y + t * (m.end.y - m.start.y), m.start.z});
    }
  double worst = 0;
  for (int i = 0; i <= 200; ++i) {
    std::vector<Vec2> p = control;
    const double t = i / 200.0;
    while (p.size() > 1) {
      for (std::size_t k = 0; k + 1 < p.size(); ++k) p[k] = (1 - t) * p[k] + t * p[k + 1];
      p.pop_back();
    }
    double nearest = 1e9;
    for (const Vec3& q : path) nearest = std::min(nearest, std::hypot(q.x - p[0].x, q.y - p[0].y));
    worst = std::max(worst, nearest);
  }
  return worst;
}

TEST(Splines, CubicStaysWithinAMicrometre) {
  const Program p = read_text("F100\nG5 I0 J3 P0 Q-3 X1 Y1\n", at_origin(Dialect::ngc));
  ASSERT_EQ(codes(p), "");
  ASSERT_GT(p.motions.size(), 1U);
  EXPECT_EQ(p.motions.back().end, (Vec3{1, 1, 0}));
  // 400 points an arc of at most 3 mm: 4 um between neighbours, 0.01 um of sagitta.
  EXPECT_LE(deviation(p, {{0, 0}, {0, 3}, {1, -2}, {1, 1}}), 5e-3);
  for (std::size_t i = 1; i < p.motions.size(); ++i)
    EXPECT_EQ(p.motions[i].start, p.motions[i - 1].end);
}

TEST(Splines, ACubicTakesItsDirectionFromTheOneBefore) {
  const Program p = read_text("F100\nG5 I0 J3 P0 Q-3 X1 Y1\nG5 P0 Q-3 X2 Y2\nG5.1 X4 Y2 I1 J3\n",
                              at_origin(Dialect::ngc));
  EXPECT_EQ(codes(p), "");
  EXPECT_EQ(p.motions.back().end, (Vec3{4, 2, 0}));
  EXPECT_EQ(codes(read_text("F100\nG5 P0 Q-3 X1 Y1\n", at_origin(Dialect::ngc))), "value-missing");
  EXPECT_EQ(codes(read_text("F100\nG18\nG5 I1 J1 P0 Q-3 X1\n", at_origin(Dialect::ngc))),
            "spline-plane");
}

TEST(Threads, RigidTapGoesInAndOut) {
  const Program p = read_text("S1000 M3\nG0 Z1\nG33.1 Z-1.2 K0.5\n", at_origin(Dialect::ngc));
  EXPECT_EQ(codes(p), "");
  ASSERT_EQ(p.motions.size(), 3U);
  EXPECT_EQ(p.motions[1].end.z, -1.2);
  EXPECT_EQ(p.motions[2].end.z, 1);
  EXPECT_EQ(p.motions[2].lead, 0.5);
}

TEST(Polar, AtAndCaretArePolarOnLinuxCnc) {
  const Program p = read_text("F100\nG1 @10 ^90\nG1 ^180\nG91 @5\n", at_origin(Dialect::ngc));
  EXPECT_EQ(codes(p), "");
  ASSERT_EQ(p.motions.size(), 3U);
  expect_near(p.motions[0].end, {0, 10, 0});
  expect_near(p.motions[1].end, {-10, 0, 0});
  expect_near(p.motions[2].end, {-15, 0, 0});
}

// They are no letters: a reader of names that skips them finds nothing, and must go on all the
// same.
TEST(Polar, WithoutANumberIsAnError) {
  for (const char* line : {"G1^X\n", "G1 @\n", "G1 X1 @ ^ Y2\n"}) {
    SCOPED_TRACE(line);
    EXPECT_NE(codes(read_text(line, at_origin(Dialect::ngc))).find("address-without-number"),
              std::string::npos);
  }
}

// A quarter of a circle as a NURBS of order 3; of order 2 it is the polygon.
TEST(Splines, NurbsIsTheCurveOfItsControlPoints) {
  const InterpOptions options = at_origin(Dialect::ngc);
  const Program p = read_text(
      "F100\nG0 X10\nG5.2 P1 L3\nX10 Y10 P0.7071067811865476\nX0 Y10 P1\nG5.3\nG1 X-5\nM2\n",
      options);
  ASSERT_EQ(codes(p), "") << listing(p);
  ASSERT_GT(p.motions.size(), 3U);
  for (std::size_t i = 1; i + 1 < p.motions.size(); ++i) {
    const Motion& m = p.motions[i];
    ASSERT_EQ(m.kind, MotionKind::arc);
    for (const double t : {0.0, 0.3, 0.7, 1.0}) {
      const Vec3 at = arc_point(m, t);
      EXPECT_NEAR(std::hypot(at.x, at.y), 10, 1e-3);
    }
  }
  expect_near(p.motions[p.motions.size() - 2].end, {0, 10, 0}, 1e-9);
  const Program polygon =
      read_text("F100\nG5.2 X0 Y10 L2\nX10 Y10\nX10 Y0 P3\nG5.3\nM2\n", options);
  ASSERT_EQ(codes(polygon), "");
  double way = 0;
  for (const Motion& m : polygon.motions) {
    EXPECT_EQ(m.kind, MotionKind::line);
    way += distance(m.start, m.end);
  }
  EXPECT_NEAR(way, 30, 1e-9) << "three sides";
  expect_near(polygon.motions.back().end, {10, 0, 0});
}

TEST(Splines, NurbsNeedsItsBlocks) {
  const InterpOptions options = at_origin(Dialect::ngc);
  EXPECT_EQ(codes(read_text("F1\nG1 X1\nG5.2 P1 L3\nX1 Y1\nG1 X5\nM2\n", options)), "nurbs-open");
  EXPECT_EQ(codes(read_text("F1\nG1 X1\nG5.2 P1 L4\nX1 Y1\nG5.3\nM2\n", options)), "value-missing");
  EXPECT_EQ(codes(read_text("F1\nG1 X1\nG5.3\nM2\n", options)), "value-missing");
  const Program open = read_text("F1\nG1 X1\nN9 G5.2 X1 Y1\nX2 Y2\nM2\n", options);
  ASSERT_EQ(codes(open), "nurbs-open");
  EXPECT_EQ(open.diagnostics[0].place.line, 3) << "where it begins";
  EXPECT_EQ(open.diagnostics[0].place.column, 4);
  EXPECT_EQ(codes(read_text("F1\nG1 X1\nG5.2 X1 Y1 P0\nM2\n", options)), "value-range");
}

}  // namespace
}  // namespace mrsim
