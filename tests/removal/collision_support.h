// Scenes of collisions: moves one after the other, a block and a bar, and what a check finds there.
#pragma once

#include "core/vec.h"
#include "removal/collision/collisions.h"
#include "support/shapes.h"
#include "support/tools.h"

#include <vector>

#include <gtest/gtest.h>

namespace mrsim::testing {

inline StockShape block() { return box_stock({0, 0, -20}, {100, 60, 0}); }

inline StockShape bar() { return round_stock(25, 0, 0, 50); }

// Moves from where the last one ended; lines are numbered from 1.
class Moves {
 public:
  explicit Moves(Vec3 start) : at_(start) {}
  Moves& rapid(Vec3 to) { return add(MotionKind::rapid, to); }
  Moves& cut(Vec3 to) { return add(MotionKind::line, to); }
  Moves& arc(Vec3 to, Vec3 center, double sweep) {
    add(MotionKind::arc, to);
    Motion& m = motions.back();
    m.center = center;
    m.radius = distance(m.start, center);
    m.sweep = sweep;
    return *this;
  }
  std::vector<Motion> motions;

 private:
  Moves& add(MotionKind kind, Vec3 to) {
    Motion m;
    m.kind = kind;
    m.start = at_;
    m.end = at_ = to;
    m.tool = 0;
    m.line = static_cast<int>(motions.size()) + 1;
    motions.push_back(m);
    return *this;
  }
  Vec3 at_;
};

inline CollisionReport check(const StockShape& stock, const std::vector<Motion>& motions,
                             const Tool& tool, double voxel = 0.5, int threads = 0,
                             double depth = 0.01) {
  const std::vector<Tool> tools{tool};
  CarvePlan carving;
  carving.voxel = voxel;
  CollisionOptions options;
  options.threads = threads;
  options.depth = depth;
  return find_collisions(carve(stock, motions, tools, carving), motions, tools, 0, options);
}

inline void expect_none(const CollisionReport& report) {
  for (const Collision& c : report.lines)
    ADD_FAILURE() << "motion " << c.motion << ", part " << static_cast<int>(c.part) << ", "
                  << c.depth << " mm at " << c.place.x << " " << c.place.y << " " << c.place.z;
}

inline void expect_one(const CollisionReport& report, std::size_t motion, ToolPart part,
                       double depth, double tolerance = 1e-3) {
  ASSERT_EQ(report.lines.size(), 1u);
  EXPECT_EQ(report.lines[0].motion, motion);
  EXPECT_EQ(report.lines[0].part, part);
  EXPECT_NEAR(report.lines[0].depth, depth, tolerance);
}

}  // namespace mrsim::testing
