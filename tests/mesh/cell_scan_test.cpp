#include "mesh/cells/cell_scan.h"

#include "core/numbers/vec.h"
#include "support/analytic_field.h"

#include <limits>

#include <gtest/gtest.h>

namespace mrsim::detail {
namespace {

using namespace mrsim::testing;

constexpr double kEdge = 0.25, kCellTolerance = 0.02, kDepth = kCellTolerance / 8;

// A cell of eight voxels about the middle of the top of a block of 20 x 20 x 10 mm.
struct TopCell {
  explicit TopCell(std::vector<Cut> cuts)
      : part({{0, 0, 0}, {20, 20, 10}}, false, std::move(cuts)),
        lattice(part.bounds(), kEdge, 3),
        list(part.all()) {
    origin = lattice.floor({9, 9, 9});
    const std::int32_t size = kVoxels * lattice.per_voxel();
    box = {lattice.position(origin),
           lattice.position({origin.x + size, origin.y + size, origin.z + size})};
    for (int k = 0; k < 8; ++k)
      corners[k] = part.sample({k & 1 ? box.hi.x : box.lo.x, k & 2 ? box.hi.y : box.lo.y,
                                k & 4 ? box.hi.z : box.lo.z},
                               list)
                       .distance;
    surface = surface_of(part, list, box, corners);
  }
  CellView view(std::span<const std::uint32_t> seen) const {
    return {origin, kVoxels, is_inside(corners[0]),      surface,
            list,   seen,    seen.size() == list.size(), true};
  }
  bool shows(std::span<const std::uint32_t> seen, double bend) const {
    return shows_more(part, lattice, view(seen), {kCellTolerance, kDepth, bend});
  }

  static constexpr std::int32_t kVoxels = 8;
  AnalyticField part;
  Lattice lattice;
  Candidates list;
  LatticePoint origin;
  Box3 box;
  double corners[8];
  CellSurface surface;
};

constexpr double kAnyBend = std::numeric_limits<double>::infinity();

TEST(CellScan, FindsTheSurfaceOnTheEdges) {
  const TopCell flat({});
  ASSERT_EQ(flat.surface.count, 4u);
  for (const CellSurface::Point& p : flat.surface.all()) {
    EXPECT_NEAR(p.position.z, 10, 1e-9);
    EXPECT_EQ(p.normal.z, 1);
  }
  EXPECT_EQ(bend_of(flat.part, flat.list, flat.surface, 2, kCellTolerance), Bend::even);
}

TEST(CellScan, TellsFacesThatBendFromFacesThatMeet) {
  const TopCell ball({ball_line({10, 10}, {10, 10}, 3, 12.5)});
  EXPECT_EQ(bend_of(ball.part, ball.list, ball.surface, 2, kCellTolerance), Bend::face);
  EXPECT_EQ(bend_of(ball.part, ball.list, ball.surface, 2, 1.0), Bend::even);
  // The wall of a wide slot, straight through the cell.
  const TopCell wall({flat_line({4, 0}, {4, 20}, 6.1, 5)});
  EXPECT_EQ(bend_of(wall.part, wall.list, wall.surface, 2, kCellTolerance), Bend::crease);
}

TEST(CellScan, SeesWhatIsDeeperThanTheLimitAlone) {
  for (const double deep : {0.5 * kDepth, 2 * kDepth, 0.1, 1.0}) {
    // A slot of 1.2 voxels in the middle of the cell, which no corner is near to.
    const TopCell slot({flat_line({0, 10.1}, {20, 10.1}, 0.6 * kEdge, 10 - deep)});
    EXPECT_EQ(slot.shows({}, kAnyBend), deep > kDepth) << deep;
    EXPECT_EQ(slot.shows(slot.list, kCellTolerance), deep > kCellTolerance) << deep;
    EXPECT_FALSE(slot.shows(slot.list, kAnyBend)) << deep;
  }
}

TEST(CellScan, SeesPocketsBetweenCorners) {
  for (const double top : {9.5, 8.9}) {  // in the cell below the surface, and the one above
    TopCell cell({ball_line({10, 10}, {10, 10}, 0.4, top)});
    for (double& d : cell.corners) d = -1;
    EXPECT_TRUE(hides_surface(cell.part, cell.lattice, cell.view(cell.list), kDepth));
  }
}

}  // namespace
}  // namespace mrsim::detail
