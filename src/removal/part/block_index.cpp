#include "removal/part/block_index.h"

#include "core/numbers/vec.h"
#include "core/process/heap.h"
#include "core/process/parallel.h"
#include "removal/field/lattice.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

// Enough parts for the cores of a workstation, each worth a thread.
constexpr std::size_t kIndexParts = 16, kPartSweeps = 4096;

}  // namespace

std::int32_t BlockIndex::block_of(double x, int axis) const {
  const double block =
      std::floor((x / voxel_ - component(kLatticeShift, axis) + 0.5) / kBlockVoxels);
  return static_cast<std::int32_t>(std::clamp(block, -3.0e7, 3.0e7));
}

bool BlockIndex::range_of(const Box3& box, Range& range) const {
  for (std::size_t a = 0; a < 3; ++a) {
    const int axis = static_cast<int>(a);
    range.low[a] = std::max(block_of(component(box.lo, axis), axis), first_[a]);
    range.high[a] = std::min(block_of(component(box.hi, axis), axis), first_[a] + count_[a] - 1);
    if (range.low[a] > range.high[a]) return false;
  }
  return true;
}

template <typename Body>
void BlockIndex::for_each_block(const Range& range, Body body) const {
  for (std::int32_t k = range.low[2]; k <= range.high[2]; ++k)
    for (std::int32_t j = range.low[1]; j <= range.high[1]; ++j)
      for (std::int32_t i = range.low[0]; i <= range.high[0]; ++i)
        body(static_cast<std::size_t>((k - first_[2]) * count_[1] + (j - first_[1])) *
                 static_cast<std::size_t>(count_[0]) +
             static_cast<std::size_t>(i - first_[0]));
}

BlockIndex::BlockIndex(const PartField& field, double voxel, double band, std::size_t max_memory,
                       int threads)
    : voxel_(voxel) {
  const Box3 whole = inflated(field.bounds(), band);
  double blocks = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    const int axis = static_cast<int>(a);
    first_[a] = block_of(component(whole.lo, axis), axis);
    count_[a] = block_of(component(whole.hi, axis), axis) - first_[a] + 1;
    blocks *= count_[a];
  }
  if (blocks * sizeof(std::size_t) > static_cast<double>(max_memory))
    throw Error("memory", fmt::format("a voxel of {:.6g} mm needs {:.3g} blocks for this stock, "
                                      "more than memory holds; take a larger "
                                      "--voxel",
                                      voxel, blocks));
  start_.assign(static_cast<std::size_t>(blocks) + 1, 0);
  fill(field.sweeps(), field.sweeps().all(kBlockVoxels * voxel / 2), band, threads);
}

BlockIndex::BlockIndex(const BlockIndex& blocks, const SweepTable& sweeps)
    : voxel_(blocks.voxel_), first_(blocks.first_), count_(blocks.count_) {
  start_.assign(blocks.size() + 1, 0);
  std::vector<std::uint32_t> ids(sweeps.size());
  std::iota(ids.begin(), ids.end(), 0u);
  fill(sweeps, ids, 0, 1);
}

// A counting sort in parts of the sweeps, which are counted and placed each on its own: a part's
// sweeps come after those of the parts before it, so every block's list ascends.
void BlockIndex::fill(const SweepTable& sweeps, std::span<const std::uint32_t> ids, double band,
                      int threads) {
  const std::size_t blocks = start_.size() - 1;
  const bool few = ids.size() < kPartSweeps || blocks > ids.size();
  const std::size_t parts = few ? 1 : kIndexParts;
  const auto first_of = [&](std::size_t part) { return ids.size() * part / parts; };
  std::vector<Range> ranges;
  reserve_large(ranges, ids.size());
  ranges.resize(ids.size());
  std::vector<std::size_t> next(parts * blocks, 0);  // by part and block: count, then next index
  parallel_for(parts, threads, [&](std::size_t part) {
    std::size_t* count = next.data() + part * blocks;
    for (std::size_t i = first_of(part); i < first_of(part + 1); ++i)
      if (range_of(inflated(sweeps.bounds(ids[i]), band), ranges[i]))
        for_each_block(ranges[i], [&](std::size_t b) { ++count[b]; });
  });
  std::size_t total = 0;
  for (std::size_t b = 0; b < blocks; ++b) {
    start_[b] = total;
    for (std::size_t part = 0; part < parts; ++part)
      total += std::exchange(next[part * blocks + b], total);
  }
  start_[blocks] = total;
  reserve_large(ids_, total);
  ids_.resize(total);
  parallel_for(parts, threads, [&](std::size_t part) {
    std::size_t* next_of = next.data() + part * blocks;
    for (std::size_t i = first_of(part); i < first_of(part + 1); ++i)
      for_each_block(ranges[i], [&](std::size_t b) { ids_[next_of[b]++] = ids[i]; });
  });
}

std::array<std::int32_t, 3> BlockIndex::origin(std::size_t b) const {
  const auto x = static_cast<std::int32_t>(b % static_cast<std::size_t>(count_[0]));
  const auto rest = b / static_cast<std::size_t>(count_[0]);
  const auto y = static_cast<std::int32_t>(rest % static_cast<std::size_t>(count_[1]));
  const auto z = static_cast<std::int32_t>(rest / static_cast<std::size_t>(count_[1]));
  return {(first_[0] + x) * kBlockVoxels, (first_[1] + y) * kBlockVoxels,
          (first_[2] + z) * kBlockVoxels};
}

Box3 BlockIndex::box(std::size_t b) const {
  const std::array<std::int32_t, 3> at = origin(b);
  Box3 box;
  for (std::size_t a = 0; a < 3; ++a) {
    const int axis = static_cast<int>(a);
    const double low =
        lattice_position(voxel_, at[a], component(kLatticeShift, axis)) - 0.5 * voxel_;
    component(box.lo, axis) = low;
    component(box.hi, axis) = low + kBlockVoxels * voxel_;
  }
  return box;
}

std::vector<std::size_t> BlockIndex::blocks_of(const Box3& box) const {
  std::vector<std::size_t> out;
  Range range;
  if (range_of(box, range)) for_each_block(range, [&](std::size_t b) { out.push_back(b); });
  return out;
}

std::size_t BlockIndex::find(const Vec3& p) const {
  const std::vector<std::size_t> found = blocks_of({p, p});
  return found.empty() ? size() : found.front();
}

}  // namespace mrsim
