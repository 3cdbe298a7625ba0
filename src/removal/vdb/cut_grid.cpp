#include "removal/vdb/cut_grid.h"

#include "core/parallel.h"
#include "core/vec.h"
#include "removal/history/cut_heights.h"
#include "removal/history/removed_volumes.h"
#include "removal/vdb/leaf_writer.h"

#include <memory>
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
    fill(cell, [cut](std::size_t k) { return cut[k]; });
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

}  // namespace

openvdb::Int32Grid::Ptr make_cut_grid(const PartField& field, const BlockIndex& index,
                                      const openvdb::math::Transform::Ptr& transform, int threads) {
  const double voxel = transform->voxelSize().x(), near = 0.5 * voxel + field.slack();
  const bool by_heights = has_height_history(field);
  std::vector<LeafCollector> blocks;
  if (by_heights) {
    const StaircaseWalker walker(field, voxel);
    blocks.resize(walker.tiles());
    parallel_for(blocks.size(), threads, [&](std::size_t t) { walker.walk(t, blocks[t]); });
  }
  if (!by_heights) blocks.resize(index.size());
  parallel_for(by_heights ? 0 : index.size(), threads, [&](std::size_t b) {
    const Candidates sweeps = field.sweeps().opened(index.sweeps(b), inflated(index.box(b), near));
    std::vector<double> removed(sweeps.size(), 0.0);
    walk_block(field, {voxel, false}, index.origin(b), sweeps, &blocks[b], removed);
  });
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
