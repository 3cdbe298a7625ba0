// Lists of candidates for places on the surface give what the cells' own lists do.
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "mesh/cells/octree.h"
#include "removal/part/part_field.h"
#include "support/moves.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/tools.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

// Loops of 16 short lines side by side, 3 mm deep: hundreds of sweeps share each place of the
// floor.
std::vector<Motion> loops() {
  std::vector<Motion> out;
  Vec3 from{10, 20, -3};
  for (int i = 0; i < 60 * 16; ++i) {
    const SinCos sc = sincos(kTwoPi * i / 16);
    const Vec3 to{12 + 0.6 * i / 16 + 4 * sc.cos, 20 + 4 * sc.sin, -3};
    out.push_back(line(from, to, i));
    from = to;
  }
  return out;
}

TEST(SurfaceLists, SamplesAreThoseOfTheWholeLists) {
  const Tool tool = endmill(10);
  const PartField part{StockSolid(box_stock({0, 0, -10}, {60, 40, 0})),
                       SweepTable(loops(), std::span(&tool, 1))};
  const detail::Lattice lattice(part.bounds(), 0.5, 5);
  detail::CellOctree tree(part, lattice, 0.02, 1);
  std::vector<Vec3> places;
  std::size_t longest = 0;
  Random r(31);
  for (int k = 0; k < 3000; ++k)
    places.push_back({r(0, 60), r(0, 40), k % 3 == 0 ? -3 : k % 3 == 1 ? 0 : r(-4, 1)});
  const auto samples = [&] {
    std::vector<FieldSample> out;
    for (const Vec3& p : places) {
      const std::int32_t cell = tree.locate(p);
      longest = std::max(longest, tree.candidates(cell).size());
      out.push_back(tree.sample_at(p, cell));
    }
    return out;
  };
  const std::vector<FieldSample> own = samples();
  EXPECT_GT(longest, 300u);  // else nothing is shown
  tree.shorten_lists();
  const std::vector<FieldSample> shortened = samples();
  for (std::size_t k = 0; k < places.size(); ++k) {
    EXPECT_EQ(shortened[k].distance, own[k].distance) << k;
    EXPECT_EQ(shortened[k].owner, own[k].owner) << k;
    EXPECT_EQ(shortened[k].patch, own[k].patch) << k;
  }
}

// All pecks pass the upper wall of the hole, so that halving makes no list of it shorter.
TEST(SurfaceLists, PecksInOneHoleTakeLittleMemory) {
  const Tool tool = ballmill(6);
  std::vector<Motion> pecks;
  for (int k = 1; k <= 200; ++k) {
    const Vec3 top{10, 10, 2}, bottom{10, 10, -0.05 * k};
    pecks.push_back(line(top, bottom, 2 * k));
    pecks.push_back(line(bottom, top, 2 * k + 1));
  }
  const PartField part{StockSolid(box_stock({0, 0, -20}, {20, 20, 0})),
                       SweepTable(pecks, std::span(&tool, 1))};
  const detail::Lattice lattice(part.bounds(), 0.2, 5);
  const detail::CellOctree tree(part, lattice, 0.02, 1);
  std::size_t whole = 0;
  for (std::size_t n = 0; n < tree.size(); ++n)
    whole += sizeof(detail::OctreeNode) +
             sizeof(std::uint32_t) * tree.candidates(static_cast<std::int32_t>(n)).size();
  EXPECT_LT(detail::SurfaceLists(part, tree, 1).memory(), 4 * whole);
}

}  // namespace
}  // namespace mrsim
