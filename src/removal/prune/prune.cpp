#include "removal/prune/prune.h"

#include "removal/prune/expand_packs.h"
#include "removal/prune/measured_list.h"
#include "removal/prune/prune_turned.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

constexpr std::size_t kFewUndercuts = 4;  // their points are asked sooner than the region

// A slice of horizontal moves: a point below the tool's tip is at least (tip.z - z) away from each.
bool is_horizontal(const SweepClass& type) {
  return type.form == SweepClass::Form::line || type.form == SweepClass::Form::arc;
}

// Memory that each thread keeps from list to list.
TurnTree::Packs& packs_left() {
  static thread_local TurnTree::Packs packs;
  return packs;
}

// Drops the candidates of a measured list that are beaten everywhere in the region.
class Keeper {
 public:
  Keeper(const SweepTable& table, const PruneRegion& region, double reach,
         const MeasuredList& measured)
      : columns_(table.columns()),
        measured_(measured),
        in_(measured.list()),
        kernels_(candidate_kernels()),
        region_(region),
        slack_(distance_slack(table)),
        reach_(reach),
        at_(measured.at()) {}

  /// Copies the candidates within `limit` mm that no other one beats to `out`; none where the
  /// region comes near no candidate. False where the region turns out to be deep in one sweep.
  bool keep(double limit, double band, CandidateList& out) {
    if (measured_.has_packs()) {
      columns_.turn_tree.narrow(turn_region(region_), measured_.nearest_pack(), limit, slack_,
                                measured_.packs(), left_);
    }
    const std::size_t slots = in_.slices().empty() ? 0 : end_of(in_.slices().back());
    out.reset(slots + CandidateList::room(measured_.has_packs() ? left_.size() : 0, 1), in_.origin);
    out.extent = in_.extent;
    out.closed = in_.closed;
    const auto& slices = in_.slices();
    for (std::size_t from = 0; from < slices.size();) {
      std::size_t to = from + 1;
      const std::int32_t group = type(from).group;
      // Rows hold distances of some slices, heights of others.
      while (to < slices.size() && group >= 0 && type(to).group == group &&
             measured_.is_bounded(to) == measured_.is_bounded(from))
        ++to;
      if (type(from).form == SweepClass::Form::turn)
        keep_packs(slices[from].class_index, out);
      else if (measured_.is_bounded(from))
        keep_segments(from, to, out);
      else if (!keep_group(from, to, limit, band, out))
        return false;
      from = to;
    }
    if (!reaches_) out.reset(0, in_.origin);
    return true;
  }

 private:
  const SweepClass& type(std::size_t slice) const { return measured_.type(slice); }
  CandidateRows rows(std::size_t slice) const { return measured_.rows(slice); }
  float bottom() const { return at_.z - at_.tall - 2 * at_.delta; }
  float top() const { return at_.z + at_.tall + 2 * at_.delta; }
  /// mm: beyond that from a surface nothing is wanted; rounded up.
  float within_band() const {
    return static_cast<float>(kWider * (reach_ - region_.radius)) + 16 * at_.delta;
  }

  /// Entry k of a slice as what others have to be compared with. A pack wins no tie against sweeps
  /// before its last one.
  Beater beater_at(std::size_t slice, std::size_t k) {
    const CandidateRows r = rows(slice);
    float id = in_.column(kIdColumn)[in_.slices()[slice].first + k];
    if (type(slice).packs)
      id = std::bit_cast<float>(columns_.packs[in_.number(in_.slices()[slice], k)].last);
    return {r.squared[k], r.x[k], r.y[k], r.z[k], r.height_number[k], id};
  }

  void keep_segments(std::size_t from, std::size_t to, CandidateList& out) {
    for (std::size_t i = from; i < to; ++i) {
      const CandidateList::Slice& slice = in_.slices()[i];
      const std::size_t first = out.begin_slice(slice.class_index, slice.numbers);
      const std::size_t kept = kernels_.keep_low(
          measured_.lower(i), slice.count, measured_.height_limit(), in_.columns(slice.first),
          type(i).packs ? kPackColumn + 1 : kPackColumn, out.column(0) + first, out.stride());
      reaches_ = reaches_ || kept > 0;
      out.close_slice(kept);
    }
  }

  void keep_packs(std::uint32_t of, CandidateList& out) {
    const std::size_t first = out.begin_slice(of);
    const auto base = static_cast<std::uint32_t>(columns_.refs.size());
    for (std::size_t k = 0; k < left_.size(); ++k)
      out.column(kIdColumn)[first + k] = std::bit_cast<float>(base + left_[k]);
    reaches_ = reaches_ || !left_.empty();
    out.close_slice(left_.size());
  }

  // False where one of the group covers the region.
  bool keep_group(std::size_t from, std::size_t to, double limit, double band, CandidateList& out) {
    KeepArgs args;
    args.at = at_;
    args.plan = type(from).kind == SweepClass::Kind::plan;
    args.rising = args.plan && type(from).tool.rising;
    if (args.plan) {
      find_plan_beaters(from, to, band, args);
      if (args.has_cover && bottom() - args.cover.z > within_band()) return false;
    } else {
      find_beater(from, to, args);
    }
    for (std::size_t i = from; i < to; ++i) {
      const CandidateList::Slice& slice = in_.slices()[i];
      static constexpr std::size_t kColumns[] = {8, 7, 9, 0, 0, 8};  // by form
      const std::size_t columns =
          type(i).packs ? kPackColumn + 1 : kColumns[static_cast<std::size_t>(type(i).form)];
      args.limit = std::nextafter(static_cast<float>(limit + spread_of(type(i))), kFloatInfinity);
      float* to_slot = out.column(0) + out.begin_slice(slice.class_index, slice.numbers);
      at_.tool = type(i).tool;
      args.within = args.plan ? top() + within_band() : surely_within(at_, region_, reach_);
      bool reaches = reaches_ || !(is_strip(type(i)) || is_horizontal(type(i)));
      const std::size_t kept = kernels_.keep(args, rows(i), in_.columns(slice.first), slice.count,
                                             columns, to_slot, out.stride(), reaches);
      reaches_ = reaches_ || (reaches && kept > 0);
      out.close_slice(kept);
    }
    return true;
  }

  void find_beater(std::size_t from, std::size_t to, KeepArgs& args) {
    if (type(from).group < 0) return;
    Beater& best = args.beater[0];
    best.squared = kFloatInfinity;
    for (std::size_t i = from; i < to; ++i) {
      const float squared = measured_.least_of(i).squared;
      const std::size_t k = kernels_.find(rows(i).squared, in_.slices()[i].count, squared);
      if (squared < best.squared) best = beater_at(i, k);
    }
    if (best.squared < kFloatInfinity) args.beaters = 1;
  }

  void find_plan_beaters(std::size_t from, std::size_t to, double band, KeepArgs& args) {
    const ToolColumns& tool = type(from).tool;
    const auto spread = static_cast<float>(kWiderSpread * 2 * measured_.spread());
    const float slack = lateral(at_) + 2 * at_.delta + 1e-5f + spread;
    // Over the flat end, and farther inside its rim than above its floor, the floor decides.
    float lowest_tip = kFloatInfinity;
    for (std::size_t i = from; i < to; ++i)
      lowest_tip = std::min(lowest_tip, measured_.least_of(i).z);
    const float above = top() - lowest_tip;
    const float inside = tool.flat - slack - std::clamp(above, 0.0f, static_cast<float>(band));
    const bool covers = band > 0 && tool.rising && inside > 0;
    // A closed top is as far from all sweeps of one height that lie under it, too.
    const float beyond = (tool.rising ? tool.flat : tool.core + tool.round) + slack;
    args.beyond = tool.flat > 0 ? beyond * beyond : kFloatInfinity;
    Beater &nearest = args.beater[0], &lowest = args.beater[1];
    nearest.squared = kFloatInfinity, lowest.z = kFloatInfinity, args.cover.z = kFloatInfinity;
    for (std::size_t i = from; i < to; ++i) {
      const std::size_t n = in_.slices()[i].count;
      const CandidateRows r = rows(i);
      const PlanBeaters found =
          kernels_.plan(r, n, measured_.least_of(i), covers ? inside * inside : -1.0f);
      const auto take = [&](std::size_t k) { return beater_at(i, k); };
      if (found.nearest < n && r.squared[found.nearest] < nearest.squared)
        nearest = take(found.nearest);
      if (found.lowest < n && r.squared[found.lowest] < kFloatInfinity &&
          (r.z[found.lowest] < lowest.z ||
           (r.z[found.lowest] == lowest.z && r.squared[found.lowest] < lowest.squared)))
        lowest = take(found.lowest);
      if (found.cover < n && r.z[found.cover] < args.cover.z) args.cover = take(found.cover);
    }
    args.has_cover = args.cover.z < kFloatInfinity;
    args.beaters = lowest.z < kFloatInfinity ? 2 : nearest.squared < kFloatInfinity ? 1 : 0;
  }

  const SweepColumns& columns_;
  const MeasuredList& measured_;
  const CandidateList& in_;
  const CandidateKernels& kernels_;
  const PruneRegion& region_;
  double slack_, reach_;  // mm
  RegionArgs at_;
  TurnTree::Packs& left_ = packs_left();  // packs of turning sweeps that are kept
  bool reaches_ = false;                  // the region may come near what is kept
};

bool prune_once(const SweepTable& table, const PruneRegion& region, double reach, double band,
                const CandidateList& in, CandidateList& out, bool undercuts = false) {
  const MeasuredList measured(table, region, reach, band, in, undercuts);
  if (!measured.is_swept() && !measured.is_swept_by_nearest()) {
    const double delta = measured.delta();
    const double within = kept_within(measured.least() + delta, measured.unsure(), region, reach,
                                      distance_slack(table));
    if (Keeper(table, region, reach, measured).keep(within + delta, band, out)) return true;
  }
  out.reset(0, in.origin);
  return false;
}

// Distances are worth their time in regions that are small beside the mill.
bool has_small_undercuts(const SweepTable& table, const PruneRegion& region,
                         const CandidateList& list) {
  return std::any_of(list.slices().begin(), list.slices().end(),
                     [&](const CandidateList::Slice& slice) {
                       const SweepClass& type = table.columns().classes[slice.class_index];
                       return is_undercutting(type) && slice.count > kFewUndercuts &&
                              region.radius < type.heights.radius / 2;
                     });
}

}  // namespace

bool prune(const SweepTable& table, const PruneRegion& region, double reach, double band,
           const CandidateList& in, CandidateList& out) {
  static thread_local CandidateList expanded;
  if (in.empty()) {
    out.reset(0, in.origin);
    return true;
  }
  const bool by_heights = band > 0;
  if (!by_heights && expand_packs(table, region, by_heights, in, expanded))
    return prune_once(table, region, reach, band, expanded, out);
  if (!prune_once(table, region, reach, band, in, out)) return false;
  if (expand_packs(table, region, by_heights, out, expanded) &&
      !prune_once(table, region, reach, band, expanded, out))
    return false;
  if (!by_heights || !has_small_undercuts(table, region, out)) return true;
  std::swap(out, expanded);
  return prune_once(table, region, reach, band, expanded, out, true);
}

}  // namespace mrsim
