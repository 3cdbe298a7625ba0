#include "removal/prune/prune_strips.h"

#include "core/numbers/rounding.h"
#include "core/process/heap.h"
#include "removal/columns/sweep_columns.h"
#include "removal/prune/region_args.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace mrsim {

bool is_of_strips(const SweepTable& table, const CandidateList& list) {
  const std::vector<SweepClass>& classes = table.columns().classes;
  const auto& slices = list.slices();
  return !slices.empty() &&
         std::all_of(slices.begin(), slices.end(), [&](const CandidateList::Slice& slice) {
           const SweepClass& type = classes[slice.class_index];
           return type.form == SweepClass::Form::strip && !type.packs &&
                  type.group == classes[slices[0].class_index].group;
         });
}

std::array<std::size_t, kStripQuarters> nearest_strips(const PruneRegion& region, double beside,
                                                       const CandidateList& in) {
  const RegionArgs at = region_args(region, in.origin);
  std::array<std::size_t, kStripQuarters> slots{};
  float least[kStripQuarters];
  std::fill_n(least, kStripQuarters, std::numeric_limits<float>::infinity());
  for (const CandidateList::Slice& slice : in.slices()) {
    StripAt own[kStripQuarters];
    candidate_kernels().strip_quarters(in.columns(slice.first), slice.count, at,
                                       static_cast<float>(beside), own);
    for (std::size_t part = 0; part < kStripQuarters; ++part)
      if (own[part].squared < least[part])
        least[part] = own[part].squared, slots[part] = slice.first + own[part].slot;
  }
  return slots;
}

bool prune_strips(const SweepTable& table, const PruneRegion& region, double reach,
                  const CandidateList& in, std::size_t near, std::vector<std::uint32_t>& out) {
  const SweepColumns& columns = table.columns();
  const CandidateKernels& kernels = candidate_kernels();
  out.clear();
  RegionArgs at = region_args(region, in.origin);
  at.tool = columns.classes[in.slices()[0].class_index].tool;
  set_delta(at, near_extent(at, in), region.radius);
  set_margin(at, 0);
  const Beater beater = kernels.strip_beater(in.columns(near), 0, at);
  const double delta = at.delta, round = at.tool.round;
  const double least = std::sqrt(double(beater.squared)) - round + delta;
  if (least < -reach) return false;
  const double slack = 2 * columns.max_error + kRounding;
  const double limit = kept_within(least, 2 * delta, region, reach, slack) + delta + round;
  if (limit < 0) return true;
  const double band = reach - region.radius;
  if (farthest(region, beater.x, beater.y, beater.z) - round + 2 * delta < -band) return false;
  const auto limits = static_cast<float>(limit * limit * kWider);
  const float within = surely_within(at, region, reach);
  bool reaches = false;
  static thread_local std::vector<float> memory;
  std::vector<float>& bits = memory;
  for (const CandidateList::Slice& slice : in.slices()) {
    bits.resize(std::max(bits.size(), slice.count + CandidateList::kPad));
    const std::size_t left = kernels.strip_ids(in.columns(slice.first), slice.count, at, beater,
                                               limits, within, bits.data(), reaches);
    const std::size_t first = out.size();
    out.resize(first + left);
    for (std::size_t k = 0; k < left; ++k) out[first + k] = std::bit_cast<std::uint32_t>(bits[k]);
  }
  if (!reaches) out.clear();
  for (const std::uint32_t id : out) {
    prefetch(columns.ball_lines[columns.row_of(id)]);
    prefetch(columns.motions[id]);
  }
  return true;
}

}  // namespace mrsim
