// Scenes of collisions: moves one after the other, a block and a bar, and what a check finds there.
#pragma once

#include "removal/collision/collisions.h"
#include "support/path_builder.h"
#include "support/shapes.h"
#include "support/tools.h"

#include <vector>

#include <gtest/gtest.h>

namespace mrsim::testing {

inline StockShape block() { return box_stock({0, 0, -20}, {100, 60, 0}); }

inline StockShape bar() { return round_stock(25, 0, 0, 50); }

class Moves : public PathBuilder<Moves> {
 public:
  using PathBuilder::PathBuilder;
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
