// The last step of pruning long lists of one ball's lines: nothing but their indices is wanted.
#include "core/heap.h"
#include "removal/near_args.h"
#include "removal/sweep_columns.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Found {
  float squared = kInfinity;
  std::size_t slot = 0;
};

// The first of the nearest ones.
Found nearest_strip(const NearList& list, const NearArgs& at) {
  static thread_local std::vector<float> squared;
  const NearKernels& kernels = near_kernels();
  Found found;
  for (const NearList::Run& run : list.runs()) {
    squared.resize(std::max(squared.size(), run.count + NearList::kPad));
    const float own = kernels.strip_squares(list.columns(run.first), run.count, at, squared.data());
    if (own < found.squared)
      found = {own, run.first + kernels.find(squared.data(), run.count, own)};
  }
  return found;
}

}  // namespace

bool SweepTable::is_of_strips(const NearList& list) const {
  const auto& runs = list.runs();
  return !runs.empty() && std::all_of(runs.begin(), runs.end(), [&](const NearList::Run& run) {
    const SweepClass& type = columns_->classes[run.of];
    return type.form == SweepClass::Form::strip && !type.packs &&
           type.group == columns_->classes[runs[0].of].group;
  });
}

bool SweepTable::prune_strips(const PruneRegion& region, double reach, const NearList& in,
                              std::vector<std::uint32_t>& out) const {
  const NearKernels& kernels = near_kernels();
  out.clear();
  NearArgs at = near_args(region, in.origin);
  at.tool = columns_->classes[in.runs()[0].of].tool;
  set_delta(at, near_extent(at, in), region.radius);
  set_margin(at, 0);
  const Found nearest = nearest_strip(in, at);
  const double delta = at.delta, round = at.tool.round;
  const double least = std::sqrt(double(nearest.squared)) - round + delta;
  if (least < -reach) return false;
  const double slack = 2 * max_error() + kPruneRounding;
  const double limit = kept_within(least, 2 * delta, region, reach, slack) + delta + round;
  if (limit < 0) return true;
  const Beater beater = kernels.strip_beater(in.columns(nearest.slot), 0, at);
  const double band = reach - region.radius;
  if (farthest(region, beater.x, beater.y, beater.z) - round + 2 * delta < -band) return false;
  const auto limits = static_cast<float>(limit * limit * (1 + 1e-6));
  const float within = surely_within(at, region, reach);
  bool reaches = false;
  static thread_local std::vector<float> memory;
  std::vector<float>& bits = memory;
  for (const NearList::Run& run : in.runs()) {
    bits.resize(std::max(bits.size(), run.count + NearList::kPad));
    const std::size_t left = kernels.strip_ids(in.columns(run.first), run.count, at, beater, limits,
                                               within, bits.data(), reaches);
    for (std::size_t k = 0; k < left; ++k) {
      out.push_back(std::bit_cast<std::uint32_t>(bits[k]));
      prefetch(columns_->ball_lines[columns_->tags[out.back()] & kTagRow]);
      prefetch(columns_->motions[out.back()]);
    }
  }
  if (!reaches) out.clear();
  return true;
}

}  // namespace mrsim
