#include "removal/vdb/cut_grid.h"

#include "core/numbers/vec.h"
#include "core/process/parallel.h"
#include "removal/history/cut_rings.h"
#include "removal/history/removed_volumes.h"
#include "removal/history/staircase_walker.h"
#include "removal/vdb/leaf_writer.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <openvdb/tools/Prune.h>

namespace mrsim {
namespace {

// What a walk finds in one block, as leaves and as tiles of the size of a leaf.
class LeafCollector final : public CutSink {
 public:
  std::vector<std::unique_ptr<OwnerLeaf>> leaves;
  std::vector<std::pair<openvdb::Coord, std::int32_t>> tiles;

  void tile(const CutCell& cell, std::int32_t cut) override {
    if (cut == kNeverThere) return;
    if (cell.size < kLeafVoxels) return fill(cell, [cut](std::size_t) { return cut; });
    for (int x = 0; x < cell.size; x += kLeafVoxels)
      for (int y = 0; y < cell.size; y += kLeafVoxels)
        for (int z = 0; z < cell.size; z += kLeafVoxels)
          tiles.emplace_back(first(cell).offsetBy(x, y, z), cut);
  }
  void leaf(const CutCell& cell, const std::int32_t* cut) override {
    if (cell.size < kLeafVoxels) return fill(cell, [cut](std::size_t k) { return cut[k]; });
    leaves.push_back(std::make_unique<OwnerLeaf>(first(cell), kNeverThere, false));
    std::copy_n(cut, OwnerLeaf::SIZE, leaves.back()->buffer().data());
    auto* active = &leaves.back()->getValueMask().getWord<std::uint64_t>(0);
    for (std::size_t k = 0; k < OwnerLeaf::SIZE; ++k)
      active[k / 64] |= std::uint64_t(cut[k] != kNeverThere) << k % 64;
  }

 private:
  static openvdb::Coord first(const CutCell& cell) {
    return {cell.origin[0], cell.origin[1], cell.origin[2]};
  }
  // Cells of one leaf come one after the other.
  template <typename Value>
  void fill(const CutCell& cell, Value value) {
    const openvdb::Coord leaf = first(cell) & ~(kLeafVoxels - 1);
    if (leaves.empty() || leaves.back()->origin() != leaf)
      leaves.push_back(std::make_unique<OwnerLeaf>(leaf, kNeverThere, false));
    std::size_t k = 0;
    for (int x = 0; x < cell.size; ++x)
      for (int y = 0; y < cell.size; ++y)
        for (int z = 0; z < cell.size; ++z, ++k)
          if (value(k) != kNeverThere)
            leaves.back()->setValueOn(OwnerLeaf::coordToOffset(first(cell).offsetBy(x, y, z)),
                                      value(k));
  }
};

std::vector<LeafCollector> by_heights(const PartField& field, double voxel, int threads) {
  const StaircaseWalker walker(field, voxel);
  std::vector<LeafCollector> tiles(walker.tiles());
  parallel_for(tiles.size(), threads, [&](std::size_t t) { walker.walk(t, tiles[t]); });
  return tiles;
}

// Blocks at one height share their rings.
std::vector<LeafCollector> by_rings(const PartField& field, const BlockIndex& index, double voxel,
                                    int threads) {
  std::vector<std::int32_t> heights(index.size());
  for (std::size_t b = 0; b < heights.size(); ++b) heights[b] = index.origin(b)[2];
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  std::vector<std::optional<RingPlanes>> planes(heights.size());
  parallel_for(heights.size(), threads,
               [&](std::size_t i) { planes[i].emplace(field, voxel, heights[i], kBlockVoxels); });
  std::vector<LeafCollector> blocks(index.size());
  parallel_for(blocks.size(), threads, [&](std::size_t b) {
    const CutCell block{index.origin(b), kBlockVoxels};
    const auto at = std::lower_bound(heights.begin(), heights.end(), block.origin[2]);
    RingWalker(field, voxel)
        .walk(*planes[static_cast<std::size_t>(at - heights.begin())], block, blocks[b]);
  });
  return blocks;
}

std::vector<LeafCollector> by_distances(const PartField& field, const BlockIndex& index,
                                        double voxel, int threads) {
  const double near = 0.5 * voxel + field.slack();
  std::vector<LeafCollector> blocks(index.size());
  parallel_for(blocks.size(), threads, [&](std::size_t b) {
    const Candidates sweeps =
        field.sweeps().expanded(index.sweeps(b), inflated(index.box(b), near));
    std::vector<double> removed(sweeps.size(), 0.0);
    walk_block(field, {voxel, false}, index.origin(b), sweeps, &blocks[b], removed);
  });
  return blocks;
}

}  // namespace

openvdb::Int32Grid::Ptr make_cut_grid(const PartField& field, const BlockIndex& index,
                                      const openvdb::math::Transform::Ptr& transform, int threads) {
  const double voxel = transform->voxelSize().x();
  std::vector<LeafCollector> blocks = has_height_history(field) ? by_heights(field, voxel, threads)
                                      : history_lattice(field, voxel).half_plane
                                          ? by_rings(field, index, voxel, threads)
                                          : by_distances(field, index, voxel, threads);
  const auto grid = openvdb::Int32Grid::create(kNeverThere);
  grid->setName("cut");
  grid->setTransform(transform);
  for (LeafCollector& block : blocks) {
    for (const auto& [origin, cut] : block.tiles) grid->tree().addTile(1, origin, cut, true);
    for (auto& leaf : block.leaves)
      if (!leaf->isEmpty()) grid->tree().addLeaf(leaf.release());
    block = {};
  }
  openvdb::tools::prune(grid->tree(), 0, threads != 1);
  return grid;
}

}  // namespace mrsim
