#include "removal/history/removed_volumes.h"

#include "core/numbers/rounding.h"
#include "core/numbers/vec.h"
#include "core/process/error.h"
#include "core/process/parallel.h"
#include "removal/field/lattice.h"
#include "removal/history/cut_columns.h"
#include "removal/history/cut_heights.h"
#include "removal/part/block_index.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <mutex>
#include <utility>

namespace mrsim {
namespace {

// How exactly the height of an arc is found where only sums are wanted: in mm, and as a share of
// the stock's height. Searching it takes 20 to 100 times as long as its bounds.
constexpr double kClose = 0.1, kCloseShare = 0.01;

// What a sweep removes of one block.
struct BlockSum {
  std::int32_t motion = 0;
  double removed = 0;  // mm^3, above 0
  CutExtent extent;
};
using BlockSums = std::vector<BlockSum>;

// What all ways of summing take.
struct Task {
  const PartField& field;
  const CutLattice& lattice;
  int threads = 0;
  CutSink* sink = nullptr;
  const Progress& progress;
  std::span<const CutFrame> frames;
};

// Blocks, tiles or rows in parallel; after each the caller may stop the work.
void for_each_task(std::size_t count, int threads, const Progress& progress,
                   const std::function<void(std::size_t)>& body) {
  std::mutex mutex;
  std::size_t done = 0;
  parallel_for(count, threads, [&](std::size_t i) {
    body(i);
    if (!progress) return;
    const std::scoped_lock lock(mutex);
    if (!progress("history", static_cast<double>(++done) / static_cast<double>(count)))
      throw Error("cancelled", "the run was stopped");
  });
}

void add_removed(const PartField& field, std::span<const std::uint32_t> sweeps,
                 std::span<const double> removed, std::span<const CutExtent> extents,
                 BlockSums& out) {
  for (std::size_t i = 0; i < sweeps.size(); ++i)
    if (removed[i] > 0)
      out.push_back({field.sweeps().motion(sweeps[i]), removed[i],
                     extents.empty() ? CutExtent{} : extents[i]});
}

std::vector<BlockSums> sums_in_space(const Task& task) {
  const PartField& field = task.field;
  const CutLattice& lattice = task.lattice;
  const double near = 0.5 * lattice.voxel + field.slack();
  const BlockIndex index(field, lattice.voxel, near, std::numeric_limits<std::size_t>::max(),
                         task.threads);
  std::vector<BlockSums> blocks(index.size());
  for_each_task(index.size(), task.threads, task.progress, [&](std::size_t b) {
    const Candidates sweeps =
        field.sweeps().expanded(index.sweeps(b), inflated(index.box(b), near));
    if (sweeps.empty() && task.sink == nullptr) return;
    std::vector<double> removed(sweeps.size(), 0.0);
    if (task.frames.empty()) {
      walk_block(field, lattice, index.origin(b), sweeps, task.sink, removed);
      return add_removed(field, sweeps, removed, {}, blocks[b]);
    }
    CutWalker walker(field, lattice, task.frames);
    walker.walk({index.origin(b), kBlockVoxels}, sweeps, task.sink, removed);
    add_removed(field, sweeps, removed, walker.extents(), blocks[b]);
  });
  return blocks;
}

std::vector<BlockSums> sums_of_heights(const Task& task) {
  const PartField& field = task.field;
  const HeightGrid grid(field.bounds(), task.lattice.voxel);
  const SweepUndersides tools(field.sweeps());
  const std::vector<std::vector<std::uint32_t>> sweeps = grid.sweeps_of_tiles(field.sweeps());
  const double height = field.bounds().hi.z - field.bounds().lo.z;
  const double close = task.frames.empty() ? std::min(kClose, kCloseShare * height) : 0;
  std::vector<BlockSums> tiles(sweeps.size());
  for_each_task(tiles.size(), task.threads, task.progress, [&](std::size_t t) {
    if (sweeps[t].empty()) return;
    std::vector<double> removed(sweeps[t].size(), 0.0);
    HeightWalker walker(field, tools, task.frames, close);
    walker.walk(grid, t, sweeps[t], removed);
    add_removed(field, sweeps[t], removed, walker.extents(), tiles[t]);
  });
  return tiles;
}

// Rows of blocks across the axis: the sweeps of a row are found once.
std::vector<BlockSums> sums_in_half_plane(const Task& task) {
  constexpr int kSize = 32;
  const PartField& field = task.field;
  const CutLattice& lattice = task.lattice;
  const double h = lattice.voxel, near = 0.5 * h + field.slack();
  const Box3 stock = inflated(field.bounds(), near);
  const auto first = static_cast<std::int32_t>(lattice_floor(h, stock.lo.z, kLatticeShift.z));
  const auto last = static_cast<std::int32_t>(lattice_floor(h, stock.hi.z, kLatticeShift.z)) + 1;
  const auto wide = static_cast<std::int32_t>(std::ceil(stock.hi.x / h)) + 1;
  const Candidates all = field.all();
  std::vector<BlockSums> rows(static_cast<std::size_t>((last - first) / kSize + 1));
  for_each_task(rows.size(), task.threads, task.progress, [&](std::size_t r) {
    const std::int32_t z = first + static_cast<std::int32_t>(r) * kSize;
    const double low = lattice.position({0, 0, z}).z, high = low + kSize * h;
    const Box3 box{{-kInfinity, -kInfinity, low - h}, {kInfinity, kInfinity, high + h}};
    const Candidates sweeps = field.sweeps().expanded(all, box);
    if (sweeps.empty() && task.sink == nullptr) return;
    CutWalker walker(field, lattice, task.frames);
    std::vector<double> removed(sweeps.size(), 0.0);
    for (std::int32_t x = 0; x < wide; x += kSize)
      walker.walk({{x, 0, z}, kSize}, sweeps, task.sink, removed);
    add_removed(field, sweeps, removed, walker.extents(), rows[r]);
  });
  return rows;
}

}  // namespace

void walk_block(const PartField& field, const CutLattice& lattice,
                const std::array<std::int32_t, 3>& origin, std::span<const std::uint32_t> sweeps,
                CutSink* sink, std::span<double> removed) {
  const bool upward =
      !sweeps.empty() && std::all_of(sweeps.begin(), sweeps.end(),
                                     [&](std::uint32_t i) { return is_upward(field.sweeps(), i); });
  if (upward)
    ColumnWalker(field, lattice.voxel).walk(origin, sweeps, sink, removed);
  else
    CutWalker(field, lattice).walk({origin, kBlockVoxels}, sweeps, sink, removed);
}

CutLattice history_lattice(const PartField& field, double voxel) {
  return {voxel, field.solid().is_turned() && field.sweeps().is_turned()};
}

std::vector<double> removed_volumes(const PartField& field, const CutLattice& lattice,
                                    std::size_t motions, int threads, CutSink* sink,
                                    const Progress& progress, CutExtents* extents) {
  const Task task{field,    lattice,
                  threads,  sink,
                  progress, extents != nullptr ? extents->frames : std::span<const CutFrame>()};
  const bool by_heights = sink == nullptr && has_height_history(field);
  const std::vector<BlockSums> blocks = lattice.half_plane ? sums_in_half_plane(task)
                                        : by_heights       ? sums_of_heights(task)
                                                           : sums_in_space(task);
  std::vector<double> removed(motions, 0.0);
  if (extents != nullptr) extents->extents.assign(motions, {});
  for (const BlockSums& block : blocks)
    for (const BlockSum& sum : block) {
      removed[static_cast<std::size_t>(sum.motion)] += sum.removed;
      if (extents != nullptr)
        extents->extents[static_cast<std::size_t>(sum.motion)].add(sum.extent);
    }
  return removed;
}

}  // namespace mrsim
