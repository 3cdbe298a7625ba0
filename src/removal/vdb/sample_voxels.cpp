// Samples the exact part into a narrow-band level set: blocks from large to small, each with the
// list of sweeps that can matter in it (docs/removal.md). A voxel is a pure function of stock,
// motions and its position, so that the result does not depend on the order of the work.

#include "core/numbers/vec.h"
#include "core/process/error.h"
#include "core/process/parallel.h"
#include "removal/prune/list_candidates.h"
#include "removal/vdb/turned_carver.h"
#include "removal/vdb/vdb_grid.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <optional>

#include <openvdb/tools/SignedFloodFill.h>

namespace mrsim {
namespace {

// One block of 64 voxels, on one thread: its lists by depth and the leaves it makes.
class BlockCarver : LeafWriter {
 public:
  using Lists = std::array<CandidateList, 6>;  // by depth, from 64 voxels to what is left at kLast

  BlockCarver(const PartField& field, double voxel, Lists& lists)
      : LeafWriter(field, voxel), lists_(lists) {}

  std::vector<LeafPair> carve(const std::array<std::int32_t, 3>& origin,
                              std::span<const std::uint32_t> sweeps) {
    leaves_.clear();
    const openvdb::Coord first(origin[0], origin[1], origin[2]);
    list_candidates(field_.sweeps(), sweeps, center(first, kBlockVoxels, kBlockVoxels), lists_[0]);
    visit(first, kBlockVoxels, 0, false);
    return std::move(leaves_);
  }

 private:
  static constexpr int kLast = 4;  // voxels: smaller blocks are columns

  double half(int size) const { return 0.5 * (size - 1) * voxel_; }
  // Centre of a block of size x size x tall voxels.
  Vec3 center(const openvdb::Coord& origin, int size, int tall) const {
    return Vec3{lattice_position(voxel_, origin.x(), kLatticeShift.x),
                lattice_position(voxel_, origin.y(), kLatticeShift.y),
                lattice_position(voxel_, origin.z(), kLatticeShift.z)} +
           Vec3{half(size), half(size), half(tall)};
  }

  // Whether to evaluate the list instead of pruning it for columns. Evaluating one register of
  // sweeps at 64 samples costs as much as pruning it; sweeps without a closed form are costly to
  // evaluate.
  static bool is_short(const CandidateList& sweeps) {
    return sweeps.size() <= (sweeps.closed ? 16u : 4u);
  }

  // The list of the block is lists_[depth]; what is left of it goes to the next.
  void visit(const openvdb::Coord& origin, int size, std::size_t depth, bool in_stock) {
    CandidateList& left = lists_[depth + 1];
    PruneRegion block = PruneRegion::cube(center(origin, size, size), half(size));
    block.expand_packs = size == kLast;
    const auto region = field_.restrict_to(block, band_, lists_[depth], in_stock, left);
    if (size == kLeafVoxels && region != ExactField::Region::air) open_leaf(origin);
    if (region == ExactField::Region::material && size < kLeafVoxels)
      fill_material(origin, size, size);
    if (region == ExactField::Region::mixed) {
      if (size > kLast)
        visit_children(origin, size / 2, depth + 1, in_stock);
      else if (is_short(left))
        evaluate(origin, size, size, left, in_stock);
      else
        finish_columns(origin, block, left, in_stock);
    }
    if (size == kLeafVoxels && region != ExactField::Region::air) close_leaf();
  }

  // A block of the last size with a long list, in its four columns: along the tool, which mostly is
  // upright, nearest places change least.
  void finish_columns(const openvdb::Coord& origin, const PruneRegion& block,
                      const CandidateList& sweeps, bool in_stock) {
    constexpr int kSize = kLast / 2;
    const auto first = [&](std::size_t part) {
      return origin.offsetBy(part >> 1 ? kSize : 0, part & 1 ? kSize : 0, 0);
    };
    for (std::size_t part = 0; part < quarters_.size(); ++part) {
      PruneRegion& quarter = quarters_[part].region;
      quarter = PruneRegion::column(center(first(part), kSize, kLast), half(kSize), half(kLast));
      quarter.expand_packs = true;
    }
    field_.restrict_quarters(block, band_, sweeps, in_stock, quarters_);
    for (std::size_t part = 0; part < quarters_.size(); ++part) {
      const PartField::Quarter& c = quarters_[part];
      if (c.found == ExactField::Region::material) fill_material(first(part), kSize, kLast);
      if (c.found == ExactField::Region::mixed)
        evaluate(first(part), kSize, kLast, c.left, c.in_stock);
    }
  }

  void visit_children(const openvdb::Coord& origin, int size, std::size_t depth, bool in_stock) {
    for (int child = 0; child < 8; ++child)
      visit(origin.offsetBy(child >> 2 & 1 ? size : 0, child >> 1 & 1 ? size : 0,
                            child & 1 ? size : 0),
            size, depth, in_stock);
  }

  // The last leaf, where it has been found to hold no active voxels: one in three.
  void open_leaf(const openvdb::Coord& origin) {
    if (!leaf_.distance) {
      leaf_ = new_leaf(origin), view_ = LeafView(leaf_);
      return;
    }
    leaf_.distance->setOrigin(origin), leaf_.owner->setOrigin(origin);
    std::fill_n(view_.distance, FloatLeaf::SIZE, static_cast<float>(band_));
  }
  void close_leaf() {
    if (!leaf_.distance->isEmpty()) leaves_.push_back(std::move(leaf_));
  }

  // Calls body(index of the voxel, x, y, z) for each voxel of a block, z fastest.
  template <typename Body>
  static void for_each_voxel(int size, int tall, Body body) {
    std::size_t k = 0;
    for (int x = 0; x < size; ++x)
      for (int y = 0; y < size; ++y)
        for (int z = 0; z < tall; ++z) body(k++, x, y, z);
  }

  void fill_material(const openvdb::Coord& origin, int size, int tall) {
    for_each_voxel(size, tall, [&](std::size_t, int x, int y, int z) {
      view_.distance[FloatLeaf::coordToOffset(origin.offsetBy(x, y, z))] =
          -static_cast<float>(band_);
    });
  }

  // Brings points_ up to date with a list.
  void ask(const CandidateList& sweeps) { least_distances(field_.sweeps(), sweeps, points_); }
  void ask(const Candidates& sweeps) { field_.sweeps().least(sweeps, points_); }

  // `sweeps`: a CandidateList or Candidates.
  template <typename List>
  void evaluate(const openvdb::Coord& origin, int size, int tall, const List& sweeps,
                bool in_stock) {
    double axis[3][kLast];
    for (int i = 0; i < kLast; ++i) {
      axis[0][i] = lattice_position(voxel_, origin.x() + i, kLatticeShift.x);
      axis[1][i] = lattice_position(voxel_, origin.y() + i, kLatticeShift.y);
      axis[2][i] = lattice_position(voxel_, origin.z() + i, kLatticeShift.z);
    }
    points_.count = static_cast<std::size_t>(size * size * tall);
    for_each_voxel(size, tall, [&](std::size_t k, int x, int y, int z) {
      points_.x[k] = axis[0][x], points_.y[k] = axis[1][y], points_.z[k] = axis[2][z];
      points_.least[k] = std::numeric_limits<double>::infinity(), points_.nearest[k] = 0;
    });
    ask(sweeps);
    combine_stock(in_stock);
    const auto row = static_cast<std::size_t>(tall);
    std::size_t k = 0;
    for (int x = 0; x < size; ++x)
      for (int y = 0; y < size; ++y, k += row)
        store(view_, k, FloatLeaf::coordToOffset(origin.offsetBy(x, y, 0)), row);
  }

  Lists& lists_;
  std::vector<LeafPair> leaves_;
  LeafPair leaf_;
  LeafView view_;  // of leaf_
  PartField::Quarters quarters_;
};

class ProgressMeter {
 public:
  ProgressMeter(const Progress& progress, std::size_t total) : progress_(progress), total_(total) {}
  void step() {
    const std::size_t done = ++done_;
    if (!progress_ || done % 16 != 0) return;
    const std::scoped_lock lock(mutex_);
    if (!progress_("removal", static_cast<double>(done) / static_cast<double>(total_)))
      throw Error("cancelled", "the run was stopped");
  }

 private:
  const Progress& progress_;
  std::size_t total_;
  std::atomic<std::size_t> done_{0};
  std::mutex mutex_;
};

std::unique_ptr<VdbGrid> collect(std::vector<std::vector<LeafPair>>& blocks, double voxel,
                                 int threads) {
  auto made = std::make_unique<VdbGrid>();
  VdbGrid& grid = *made;
  grid.threads = threads;
  const double band = kBandVoxels * voxel;
  const auto transform = openvdb::math::Transform::createLinearTransform(voxel);
  transform->postTranslate(voxel *
                           openvdb::Vec3d(kLatticeShift.x, kLatticeShift.y, kLatticeShift.z));
  grid.distance = openvdb::FloatGrid::create(static_cast<float>(band));
  grid.distance->setGridClass(openvdb::GRID_LEVEL_SET);
  grid.distance->setName("distance");
  grid.distance->setTransform(transform);
  grid.owner = openvdb::Int32Grid::create(kStockOwner);
  grid.owner->setName("owner");
  grid.owner->setTransform(transform);
  for (const std::vector<LeafPair>& leaves : blocks)
    for (const LeafPair& leaf : leaves)
      grid.leaves.emplace_back(leaf.distance.get(), leaf.owner.get());
  // A tree takes one leaf at a time, so at most the two trees can be filled side by side.
  parallel_for(2, threads, [&](std::size_t tree) {
    openvdb::FloatGrid::Accessor distance(grid.distance->tree());
    openvdb::Int32Grid::Accessor owner(grid.owner->tree());
    for (std::vector<LeafPair>& leaves : blocks)
      for (LeafPair& leaf : leaves)
        if (tree == 0)
          distance.addLeaf(leaf.distance.release());
        else
          owner.addLeaf(leaf.owner.release());
  });
  // Leaves hold all their signs: only the tiles between them are to be filled.
  openvdb::tools::signedFloodFill(grid.distance->tree(), true, 1, 1);
  return made;
}

}  // namespace

std::unique_ptr<VoxelGrid> sample_voxels(const PartField& field, const BlockIndex& index,
                                         double voxel, const CarvePlan& options) {
  openvdb::initialize();
  std::vector<std::vector<LeafPair>> blocks(index.size());
  std::unique_ptr<VdbGrid> grid;
  std::atomic<std::size_t> active{0};
  ProgressMeter meter(options.progress, index.size());
  with_threads(options.threads, [&] {
    const bool turned = field.solid().is_turned() && !field.sweeps().turn_tree().roots().empty();
    std::optional<TurnLayers> layers;
    if (turned) layers.emplace(field, voxel, kBandVoxels * voxel, options.threads);
    parallel_for(index.size(), options.threads, [&](std::size_t b) {
      static thread_local BlockCarver::Lists lists;  // their memory serves all blocks
      const auto sweeps = index.sweeps(b);
      if (turned && (sweeps.empty() || sweeps.front() >= field.sweeps().size()))
        blocks[b] = TurnedCarver(field, voxel, *layers).carve(index.origin(b));
      else
        blocks[b] = BlockCarver(field, voxel, lists).carve(index.origin(b), sweeps);
      for (const LeafPair& leaf : blocks[b]) active += leaf.distance->onVoxelCount();
      meter.step();
    });
    grid = collect(blocks, voxel, options.threads);
    grid->active = active;
  });
  return grid;
}

}  // namespace mrsim
