#include "removal/prune/prune.h"

#include "removal/prune/heights.h"
#include "removal/prune/list_candidates.h"
#include "removal/prune/prune_turned.h"
#include "removal/prune/region_args.h"
#include "removal/sweep/sweep_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Shorter lists of costly sweeps are not worth the nearest points of their skeletons.
constexpr std::size_t kFewOthers = 6;
constexpr double kRoom = 1e-3;  // mm: far above the slack of rounding

// Rows of all slots of a list.
class Rows {
 public:
  void resize(std::size_t slots) {
    stride_ = slots + CandidateList::kPad;
    if (data_.size() < 7 * stride_) data_.resize(7 * stride_);
  }
  CandidateRows at(std::size_t slot) {
    float* p = data_.data() + slot;
    return {p,
            p + stride_,
            p + 2 * stride_,
            p + 3 * stride_,
            p + 4 * stride_,
            p + 5 * stride_,
            p + 6 * stride_};
  }

 private:
  std::vector<float> data_;
  std::size_t stride_ = 0;
};

struct Scratch {
  Rows rows;
  std::vector<LeastDistance> least;
  std::vector<float> lower;  ///< bounds of heights by slot
  std::vector<double> distance;
  std::vector<std::uint32_t> ids;
  TurnTree::Packs packs, left;
  TurnTree::Nearest turned;
};
Scratch& scratch() {
  static thread_local Scratch s;
  return s;
}

// The in-plane radius of a region.
float lateral(const RegionArgs& a) { return a.box ? a.half * 1.4142137f : a.radius; }

// Sweeps without columns: in double, then rounded. Returns the largest value.
double near_others(const SweepTable& table, const CandidateList& list,
                   const CandidateList::Run& run, const PruneRegion& region, double reach) {
  const SweepColumns& c = table.columns();
  Scratch& s = scratch();
  s.ids.resize(run.count), s.distance.resize(run.count);
  for (std::size_t k = 0; k < run.count; ++k) s.ids[k] = list.number(run, k);
  const Vec3& p = region.center;
  table.distances(s.ids, p, s.distance.data());
  const CandidateRows out = s.rows.at(run.first);
  LeastDistance& least = s.least.emplace_back(LeastDistance{kInfinity, kInfinity, kInfinity});
  const std::size_t padded =
      (run.count + CandidateList::kPad - 1) / CandidateList::kPad * CandidateList::kPad;
  std::fill(out.distance + run.count, out.distance + padded, kInfinity);
  std::fill(out.squared + run.count, out.squared + padded, kInfinity);
  std::fill(out.z + run.count, out.z + padded, kInfinity);
  // Where a sweep is dropped by its distance, its nearest point is not asked for.
  const double nearest = *std::min_element(s.distance.begin(), s.distance.end());
  const double limit =
      run.count < kFewOthers || nearest > reach ? -reach : nearest + 2 * region.radius + kRoom;
  double extent = 0;
  for (std::size_t k = 0; k < run.count; ++k) {
    const SweepColumns::Foot f =
        s.distance[k] > limit ? SweepColumns::Foot{} : c.foot(c.refs[s.ids[k]], p);
    out.distance[k] = static_cast<float>(s.distance[k]);
    out.squared[k] = static_cast<float>(f.squared);
    out.x[k] = static_cast<float>(f.offset.x), out.y[k] = static_cast<float>(f.offset.y);
    out.z[k] = static_cast<float>(f.offset.z);
    out.rest[k] =
        f.convex ? static_cast<float>(region.radius * region.radius * 1.00001) : kInfinity;
    out.level[k] = c.levels.empty() ? 0 : static_cast<float>(sweep_level(c.levels[s.ids[k]]));
    least.distance = std::min(least.distance, out.distance[k]);
    least.squared = std::min(least.squared, out.squared[k]);
    least.z = std::min(least.z, out.z[k]);
    extent = std::max({extent, std::fabs(s.distance[k]), length(f.offset)});
  }
  return extent;
}

// One step of pruning: rows of all runs, then what to keep of each.
class Pruner {
 public:
  Pruner(const SweepTable& table, const PruneRegion& region, double reach, double band,
         const CandidateList& in)
      : columns_(table.columns()),
        in_(in),
        kernels_(candidate_kernels()),
        region_(region),
        slack_(2 * table.max_error() + kPruneRounding),
        deep_(-reach),
        at_(region_args(region, in.origin)),
        heights_(band + slack_) {
    const auto& runs = in.runs();
    for (std::size_t i = 0; band > 0 && i < runs.size(); ++i)
      by_heights_ = by_heights_ || type(i).form == SweepClass::Form::piece;
    measure(table, region);
  }

  float least() const { return least_; }
  double delta() const { return at_.delta; }
  /// By how much the nearest sweep may be nearer than least() + delta(): packs count from above.
  double unsure() const { return 2.0 * at_.delta + 2.001 * spread_; }
  /// The whole region is deep in one sweep; the others were not asked.
  bool is_swept() const {
    return double(least_) + at_.delta < deep_ || (by_heights_ && heights_.is_swept());
  }
  /// The same, as the nearest strip tells by where its nearest point lies.
  bool is_swept_by_nearest() {
    const double band = -deep_ - region_.radius;
    if (!(double(least_) + at_.delta < -band)) return false;
    const auto& runs = in_.runs();
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (!is_strip(i) || scratch_.least[i].distance > least_) continue;
      const std::size_t k = kernels_.find(rows(i).distance, runs[i].count, least_);
      if (k == runs[i].count) continue;
      const CandidateRows r = rows(i);
      return farthest(region_, r.x[k], r.y[k], r.z[k]) - type(i).tool.round + 2 * at_.delta < -band;
    }
    return false;
  }

  /// What is not beaten within the limit; nothing where the region comes near none of it. False
  /// where the region turns out to be deep in one sweep.
  bool keep(double limit, double band, CandidateList& out) {
    if (has_packs()) {
      columns_.turn_tree.narrow(turn_region(region_), scratch_.turned, limit, slack_,
                                scratch_.packs, scratch_.left);
    }
    const std::size_t slots = in_.runs().empty() ? 0 : end_of(in_.runs().back());
    out.reset(slots + CandidateList::room(has_packs() ? scratch_.left.size() : 0, 1), in_.origin);
    out.extent = in_.extent;
    out.closed = in_.closed;
    const auto& runs = in_.runs();
    for (std::size_t from = 0; from < runs.size();) {
      std::size_t to = from + 1;
      const std::int32_t group = type(from).group;
      while (to < runs.size() && group >= 0 && type(to).group == group) ++to;
      if (type(from).form == SweepClass::Form::turn)
        keep_packs(runs[from].of, out);
      else if (is_bounded(from))
        keep_pieces(from, to, out);
      else if (!keep_group(from, to, limit, band, out))
        return false;
      from = to;
    }
    if (!reaches_) out.reset(0, in_.origin);
    return true;
  }

 private:
  static std::size_t end_of(const CandidateList::Run& run) { return run.first + run.count; }
  const SweepClass& type(std::size_t run) const { return columns_.classes[in_.runs()[run].of]; }
  bool is_strip(std::size_t run) const {
    return type(run).form == SweepClass::Form::strip && !type(run).packs;
  }
  // Below its tip a level move is at least as far as that is high.
  bool is_level(std::size_t run) const {
    return type(run).form == SweepClass::Form::line || type(run).form == SweepClass::Form::arc;
  }
  float bottom() const { return at_.z - at_.tall - 2 * at_.delta; }
  float top() const { return at_.z + at_.tall + 2 * at_.delta; }
  /// mm: beyond that from a surface nothing is wanted; rounded up.
  float within_band() const {
    return static_cast<float>(1.000001 * (-deep_ - region_.radius)) + 16 * at_.delta;
  }
  CandidateRows rows(std::size_t run) { return scratch_.rows.at(in_.runs()[run].first); }
  /// Entry k of a run as what others have to be compared with. A pack wins no tie against sweeps
  /// before its last one.
  Beater beater_at(std::size_t run, std::size_t k) {
    const CandidateRows r = rows(run);
    float id = in_.column(kIdColumn)[in_.runs()[run].first + k];
    if (type(run).packs)
      id = std::bit_cast<float>(columns_.packs[in_.number(in_.runs()[run], k)].last);
    return {r.squared[k], r.x[k], r.y[k], r.z[k], r.level[k], id};
  }

  bool is_other(std::size_t run) const {
    return type(run).form == SweepClass::Form::other ||
           (type(run).form == SweepClass::Form::piece && !by_heights_);
  }
  // Kept by its heights.
  bool is_bounded(std::size_t run) const {
    return type(run).form == SweepClass::Form::piece && by_heights_;
  }
  // Its rows tell heights.
  bool is_measured_level(std::size_t run) const {
    return !type(run).packs &&
           (type(run).form == SweepClass::Form::line || type(run).form == SweepClass::Form::arc);
  }

  // What the list's heights are in the square: a sweep above the lowest of them, or above the
  // region, is out of all that is asked.
  void measure_heights() {
    heights_.begin(at_, lateral(at_));
    scratch_.lower.resize(
        std::max(scratch_.lower.size(), end_of(in_.runs().back()) + CandidateList::kPad));
    for (std::size_t i = 0; i < in_.runs().size() && !heights_.is_swept(); ++i) {
      const CandidateList::Run& run = in_.runs()[i];
      float* lower = scratch_.lower.data() + run.first;
      if (is_bounded(i))
        heights_.add(kernels_.piece_heights(in_.columns(run.first), run.count,
                                            heights_.args(type(i).heights), lower));
      else if (is_measured_level(i))
        heights_.add(
            kernels_.level_heights(rows(i), run.count, heights_.args(type(i).heights), lower));
    }
    for (std::size_t i = 0; i < in_.runs().size() && !heights_.is_swept(); ++i)
      if (is_measured_level(i)) drop_high(i);
  }
  void drop_high(std::size_t i) {
    const CandidateRows r = rows(i);
    const float* lower = scratch_.lower.data() + in_.runs()[i].first;
    for (std::size_t k = 0; k < in_.runs()[i].count; ++k)
      if (lower[k] > heights_.limit()) r.distance[k] = kInfinity;
  }
  void keep_pieces(std::size_t from, std::size_t to, CandidateList& out) {
    for (std::size_t i = from; i < to; ++i) {
      const CandidateList::Run& run = in_.runs()[i];
      const std::size_t first = out.open_run(run.of, run.numbers);
      const std::size_t kept =
          kernels_.keep_low(scratch_.lower.data() + run.first, run.count, heights_.limit(),
                            in_.columns(run.first), out.column(0) + first, out.stride());
      reaches_ = reaches_ || kept > 0;
      out.close_run(kept);
    }
  }

  // Packs are the last run.
  bool has_packs() const {
    return !in_.runs().empty() && type(in_.runs().size() - 1).form == SweepClass::Form::turn;
  }

  void keep_packs(std::uint32_t of, CandidateList& out) {
    const std::vector<std::uint32_t>& left = scratch_.left;
    const std::size_t first = out.open_run(of);
    const auto base = static_cast<std::uint32_t>(columns_.refs.size());
    for (std::size_t k = 0; k < left.size(); ++k)
      out.column(kIdColumn)[first + k] = std::bit_cast<float>(base + left[k]);
    reaches_ = reaches_ || !left.empty();
    out.close_run(left.size());
  }

  // The nearest of all packs; its distance.
  LeastDistance near_packs(const CandidateList::Run& run) {
    scratch_.packs.clear(), scratch_.turned = {};
    const Vec3& c = region_.center;
    const double rho = std::sqrt(c.x * c.x + c.y * c.y);
    for (std::size_t k = 0; k < run.count; ++k) {
      scratch_.packs.push_back(in_.number(run, k) -
                               static_cast<std::uint32_t>(columns_.refs.size()));
      columns_.turn_tree.nearest(scratch_.packs.back(), rho, c.z, scratch_.turned);
    }
    return {static_cast<float>(scratch_.turned.distance), kInfinity, kInfinity};
  }

  void measure(const SweepTable& table, const PruneRegion& region) {
    scratch_.least.clear();
    if (in_.runs().empty()) return;
    scratch_.rows.resize(end_of(in_.runs().back()) + CandidateList::kPad);
    double extent = near_extent(at_, in_);
    for (std::size_t i = 0; i < in_.runs().size(); ++i)
      if (is_other(i))
        extent = std::max(extent, near_others(table, in_, in_.runs()[i], region, -deep_));
      else
        scratch_.least.push_back({});
    if (has_packs()) {
      scratch_.least.back() = near_packs(in_.runs().back());
      extent = std::max(extent, std::fabs(scratch_.turned.distance));
    }
    set_delta(at_, extent, region.radius);
    for (const CandidateList::Run& run : in_.runs())
      spread_ = std::max(spread_, columns_.classes[run.of].spread);
    for (std::size_t i = 0; i < in_.runs().size() && !is_swept(); ++i) probe_run(i);
    for (std::size_t i = 0; i < in_.runs().size() && !is_swept(); ++i)
      if (!is_bounded(i)) measure_run(i);
    if (by_heights_ && !is_swept()) measure_heights();
  }

  using Kernel = decltype(CandidateKernels::strip);
  Kernel kernel_of(std::size_t run) const {
    const SweepClass::Form form = type(run).form;
    return form == SweepClass::Form::strip  ? kernels_.strip
           : form == SweepClass::Form::line ? kernels_.line
                                            : kernels_.arc;
  }

  // A few sweeps here and there in a long run tell most regions that are deep in one, which is no
  // farther away than the tool is wide.
  void probe_run(std::size_t i) {
    const CandidateList::Run& run = in_.runs()[i];
    if (run.count < kLongRun || type(i).form > SweepClass::Form::arc) return;
    at_.tool = type(i).tool;
    if (at_.tool.core + at_.tool.round < -deep_) return;
    const std::size_t stretch = run.count / kProbes / CandidateList::kPad * CandidateList::kPad;
    for (std::size_t k = 0; k < run.count && !is_swept(); k += stretch) {
      const std::size_t some = std::min(run.count - k, CandidateList::kPad);
      const LeastDistance found =
          kernel_of(i)(in_.columns(run.first + k), some, at_, scratch_.rows.at(run.first + k));
      least_ = std::min(least_, found.distance + spread_of(i));
    }
  }

  void measure_run(std::size_t i) {
    const CandidateList::Run& run = in_.runs()[i];
    LeastDistance& least = scratch_.least[i];
    at_.tool = type(i).tool;
    set_margin(at_, static_cast<float>(1.0001 * (type(i).spread + spread_)));
    if (type(i).form == SweepClass::Form::turn) {
      least_ = std::min(least_, least.distance);
      return;
    }
    if (is_other(i)) {
      const CandidateRows r = rows(i);
      for (std::size_t k = 0; k < run.count; ++k)
        r.rest[k] += at_.fixed + at_.per_root * std::sqrt(r.squared[k]) + 1e-9f * r.squared[k];
      least_ = std::min(least_, least.distance);
      return;
    }
    const Kernel kernel = kernel_of(i);
    least = {kInfinity, kInfinity, kInfinity};
    for (std::size_t k = 0; k < run.count && !is_swept(); k += kTogether) {
      const LeastDistance some =
          kernel(in_.columns(run.first + k), std::min(run.count - k, kTogether), at_,
                 scratch_.rows.at(run.first + k));
      least.distance = std::min(least.distance, some.distance);
      least.squared = std::min(least.squared, some.squared);
      least.z = std::min(least.z, some.z);
      least_ = std::min(least_, some.distance + spread_of(i));
    }
  }

  // Of a pack the distance is known up to it; rounded up.
  float spread_of(std::size_t run) const { return static_cast<float>(1.0001 * type(run).spread); }

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
      const CandidateList::Run& run = in_.runs()[i];
      static constexpr std::size_t kColumns[] = {8, 7, 9, 0, 0, 8};  // by form
      const std::size_t columns =
          type(i).packs ? kPackColumn + 1 : kColumns[static_cast<std::size_t>(type(i).form)];
      args.limit = std::nextafter(static_cast<float>(limit + spread_of(i)), kInfinity);
      float* to_slot = out.column(0) + out.open_run(run.of, run.numbers);
      at_.tool = type(i).tool;
      args.within = args.plan ? top() + within_band() : surely_within(at_, region_, -deep_);
      bool reaches = reaches_ || !(is_strip(i) || is_level(i));
      const std::size_t kept = kernels_.keep(args, rows(i), in_.columns(run.first), run.count,
                                             columns, to_slot, out.stride(), reaches);
      reaches_ = reaches_ || (reaches && kept > 0);
      out.close_run(kept);
    }
    return true;
  }

  void find_beater(std::size_t from, std::size_t to, KeepArgs& args) {
    if (type(from).group < 0) return;
    Beater& best = args.beater[0];
    best.squared = kInfinity;
    for (std::size_t i = from; i < to; ++i) {
      const float squared = scratch_.least[i].squared;
      const std::size_t k = kernels_.find(rows(i).squared, in_.runs()[i].count, squared);
      if (squared < best.squared) best = beater_at(i, k);
    }
    if (best.squared < kInfinity) args.beaters = 1;
  }

  void find_plan_beaters(std::size_t from, std::size_t to, double band, KeepArgs& args) {
    const ToolColumns& tool = type(from).tool;
    const auto spread = static_cast<float>(1.0001 * 2 * spread_);
    const float slack = lateral(at_) + 2 * at_.delta + 1e-5f + spread;
    // Over the flat end, and farther inside its rim than above its floor, the floor decides.
    float lowest_tip = kInfinity;
    for (std::size_t i = from; i < to; ++i) lowest_tip = std::min(lowest_tip, scratch_.least[i].z);
    const float above = top() - lowest_tip;
    const float inside = tool.flat - slack - std::clamp(above, 0.0f, static_cast<float>(band));
    const bool covers = band > 0 && tool.rising && inside > 0;
    const float beyond = tool.flat + slack;
    args.beyond = tool.flat > 0 ? beyond * beyond : kInfinity;
    Beater &nearest = args.beater[0], &lowest = args.beater[1];
    nearest.squared = kInfinity, lowest.z = kInfinity, args.cover.z = kInfinity;
    for (std::size_t i = from; i < to; ++i) {
      const std::size_t n = in_.runs()[i].count;
      const CandidateRows r = rows(i);
      const PlanBeaters found =
          kernels_.plan(r, n, scratch_.least[i], covers ? inside * inside : -1.0f);
      const auto take = [&](std::size_t k) { return beater_at(i, k); };
      if (found.nearest < n && r.squared[found.nearest] < nearest.squared)
        nearest = take(found.nearest);
      if (found.lowest < n && r.squared[found.lowest] < kInfinity &&
          (r.z[found.lowest] < lowest.z ||
           (r.z[found.lowest] == lowest.z && r.squared[found.lowest] < lowest.squared)))
        lowest = take(found.lowest);
      if (found.cover < n && r.z[found.cover] < args.cover.z) args.cover = take(found.cover);
    }
    args.has_cover = args.cover.z < kInfinity;
    args.beaters = lowest.z < kInfinity ? 2 : nearest.squared < kInfinity ? 1 : 0;
  }

  static constexpr std::size_t kTogether = 512;  // a multiple of any register
  static constexpr std::size_t kLongRun = 512, kProbes = 16;

  const SweepColumns& columns_;
  const CandidateList& in_;
  Scratch& scratch_ = scratch();
  const CandidateKernels& kernels_;
  const PruneRegion& region_;
  double slack_;  // mm: what rounding may change in a difference of two distances
  double deep_;
  RegionArgs at_;
  HeightBounds heights_;
  bool by_heights_ = false;  // the list has pieces, and no more than the band is asked
  float least_ = kInfinity;
  double spread_ = 0;     // mm: the largest of a pack
  bool reaches_ = false;  // the region may come near what is kept
};

bool prune_once(const SweepTable& table, const PruneRegion& region, double reach, double band,
                const CandidateList& in, CandidateList& out) {
  Pruner pruner(table, region, reach, band, in);
  if (pruner.is_swept() || pruner.is_swept_by_nearest()) {
    out.reset(0, in.origin);
    return false;
  }
  const double slack = 2 * table.max_error() + kPruneRounding, delta = pruner.delta();
  if (pruner.keep(
          kept_within(pruner.least() + delta, pruner.unsure(), region, reach, slack) + delta, band,
          out))
    return true;
  out.reset(0, in.origin);
  return false;
}

}  // namespace

bool prune(const SweepTable& table, const PruneRegion& region, double reach, double band,
           const CandidateList& in, CandidateList& out) {
  static thread_local CandidateList expanded;
  if (in.empty()) {
    out.reset(0, in.origin);
    return true;
  }
  if (!prune_once(table, region, reach, band, in, out)) return false;
  return !expand_packs(table, region, out, expanded) ||
         prune_once(table, region, reach, band, expanded, out);
}

}  // namespace mrsim
