// The grid `cut` of a .vdb: for any motion L, {cut < L} is the air of the part that a program of
// the first L motions leaves, at every voxel centre that is not on a surface.
#include "carve_support.h"
#include "core/numbers/vec.h"
#include "removal/part/stock_file.h"
#include "removal/part/stock_grid.h"
#include "removal/vdb/grids.h"
#include "support/moves.h"
#include "support/rounds.h"
#include "support/shapes.h"
#include "support/tools.h"
#include "sweep_support.h"
#include "turn_scenes.h"

#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <openvdb/io/Stream.h>

namespace mrsim {
namespace {

using namespace testing;

constexpr double kSurface = 1e-6;  // mm: nearer places may be on either side
constexpr std::int32_t kInStock = -1;

struct UntilScene {
  StockShape stock;
  std::vector<Tool> tools;
  std::vector<Motion> motions;

  Stock part(std::size_t motions_until, double voxel) const {
    CarvePlan options;
    options.voxel = voxel;
    return carve(stock, std::span(motions).first(motions_until), tools, options);
  }
};

openvdb::Int32Grid::Ptr written_cut(const UntilScene& scene, double voxel) {
  openvdb::initialize();
  StockRecipe recipe{scene.stock, voxel};
  recipe.shape.history = {{"a.MPF"}, scene.tools, scene.motions};
  std::string bytes;
  write_vdb(scene.part(scene.motions.size(), voxel), recipe,
            [&](const void* data, std::size_t size) {
              bytes.append(static_cast<const char*>(data), size);
            });
  std::istringstream in(bytes);
  openvdb::io::Stream archive(in);
  return openvdb::gridPtrCast<openvdb::Int32Grid>((*archive.getGrids())[2]);
}

void expect_air_until_any_motion(Random& r, const UntilScene& scene, double voxel) {
  const openvdb::Int32Grid::Ptr cut = written_cut(scene, voxel);
  ASSERT_TRUE(cut);
  openvdb::CoordBBox box = cut->evalActiveVoxelBoundingBox();
  box.expand(2);
  const openvdb::Int32Grid::ConstAccessor at = cut->getConstAccessor();
  const int last = static_cast<int>(scene.motions.size());
  for (const int until : {1 + r.pick(last), 1 + r.pick(last), last}) {
    const Stock part = scene.part(static_cast<std::size_t>(until), voxel);
    const PartField& field = *part.grid().field;
    const Candidates all = field.all();
    std::size_t wrong = 0, air = 0;
    for (auto ijk = box.begin(); ijk; ++ijk) {
      const openvdb::Vec3d p = cut->indexToWorld(*ijk);
      const double d = field.sample({p.x(), p.y(), p.z()}, all).distance;
      if (std::abs(d) < kSurface) continue;
      const std::int32_t first = at.getValue(*ijk);
      const bool gone = first < until && first != kInStock;
      wrong += gone != (d > 0), air += gone && first >= 0;
    }
    EXPECT_EQ(wrong, 0u) << "until motion " << until;
    EXPECT_GT(until < last ? 1 : air, 0u);
  }
}

// By its definition, voxel by voxel.
void expect_first_sweeps(const UntilScene& scene, double voxel) {
  const openvdb::Int32Grid::Ptr cut = written_cut(scene, voxel);
  ASSERT_TRUE(cut);
  const Stock part = scene.part(scene.motions.size(), voxel);
  const PartField& field = *part.grid().field;
  ASSERT_TRUE(field.is_turned(field.all()));
  openvdb::CoordBBox box = cut->evalActiveVoxelBoundingBox();
  box.expand(2);
  std::size_t wrong = 0;
  for (auto ijk = box.begin(); ijk; ++ijk) {
    const openvdb::Vec3d at = cut->indexToWorld(*ijk);
    const Vec3 p{at.x(), at.y(), at.z()};
    std::int32_t first = -2;
    if (field.solid().distance(p) < 0) {
      first = kInStock;
      for (std::size_t i = field.sweeps().size(); i-- > 0;)
        if (field.sweeps().distance(i, p) <= 0) first = field.sweeps().motion(i);
    }
    wrong += first != cut->getConstAccessor().getValue(*ijk);
  }
  EXPECT_EQ(wrong, 0u);
}

TEST(CutUntil, IsTheAirOfMilledParts) {
  Random r(23);
  for (unsigned round = 0; round < rounds(2); ++round) {
    UntilScene scene{
        box_stock({0, 0, -6}, {9, 8, 0}),
        {endmill(3), ballmill(3), endmill(4, 1), endmill(3, 0.5, 4), mill(ToolType::drill, 3)},
        {}};
    Vec3 from{1, 1, 2};
    for (int i = 0; i < 24; ++i) {
      const Vec3 to{r(-1, 10), r(-1, 9), r(-5, 1)};
      Motion m = i % 5 == 4 ? arc(from, {from.x + r(-3, 3), from.y + r(-3, 3), from.z}, {0, 0, 1},
                                  r(-6, 6))
                            : line(from, i % 3 == 0 ? Vec3{to.x, to.y, from.z} : to, i + 1);
      m.tool = r.pick(5);
      scene.motions.push_back(m);
      from = m.end;
    }
    expect_air_until_any_motion(r, scene, 0.3);
  }
}

TEST(CutUntil, IsTheAirOfTurnedParts) {
  Random r(29);
  for (unsigned round = 0; round < rounds(2); ++round) {
    const UntilScene scene{round_stock(6, 0, 0, 10), inserts(), turning_moves(r, 60, 6, 10)};
    expect_air_until_any_motion(r, scene, 0.35);
  }
}

TEST(CutUntil, IsTheFirstSweepThatHoldsAPlaceOfTurnedParts) {
  Random r(31);
  for (unsigned round = 0; round < rounds(2); ++round) {
    UntilScene scene{round_stock(6, 0, 0, 10), inserts(), turning_moves(r, 40, 6, 10)};
    if (round % 2 == 1) scene.stock = round_stock(6, 2, 0, 10);
    // A drill on the axis, which is no insert.
    scene.motions.push_back(line({0, 0, 12}, {0, 0, r(1, 8)}));
    scene.motions.back().tool = static_cast<int>(scene.tools.size());
    scene.tools.push_back(mill(ToolType::drill, 5));
    expect_first_sweeps(scene, 0.2);
  }
}

}  // namespace
}  // namespace mrsim
