// Measures the candidates of a list for one region: how far each is from the region's centre, and
// which is the nearest. prune() then drops those that lose to another one.
#pragma once

#include "core/numbers/rounding.h"
#include "removal/columns/sweep_columns.h"
#include "removal/prune/candidate_list.h"
#include "removal/prune/height_bounds.h"
#include "removal/prune/region_args.h"
#include "removal/sweep/sweep_table.h"

#include <limits>
#include <vector>

namespace mrsim {

/// Segments of a mill that narrows upwards: their heights never prove that a region is swept.
inline bool is_undercutting(const SweepClass& type) {
  return type.form == SweepClass::Form::segment && !type.packs && type.heights.lift > 0;
}

/// Each thread has one of these at a time; the next one uses the same memory again.
class MeasuredList {
 public:
  /// Measures the list. `reach` and `band` (mm) as for prune(). `undercuts`: mills that narrow
  /// upwards are measured by their distances, which are costly; else by heights, which drop few of
  /// them.
  MeasuredList(const SweepTable& table, const PruneRegion& region, double reach, double band,
               const CandidateList& in, bool undercuts);

  /// Whether the whole region lies deep in one sweep; the others need not have been measured then.
  bool is_swept() const {
    return double(least_) + at_.delta < deep_ || (by_heights_ && heights_.is_swept());
  }
  /// Whether the nearest point of the nearest strip shows that the whole region lies deep in it.
  bool is_swept_by_nearest() const;

  /// mm: the least distance of all, and what single precision may err by in it.
  float least() const { return least_; }
  double delta() const { return at_.delta; }
  /// mm: by how much the nearest sweep may be nearer than least() + delta(): the distance of a pack
  /// is known only up to its spread.
  double unsure() const { return 2.0 * at_.delta + kTwoSpreads * spread_; }

  const CandidateList& list() const { return in_; }
  const SweepClass& type(std::size_t slice) const {
    return columns_.classes[in_.slices()[slice].class_index];
  }
  CandidateRows rows(std::size_t slice) const {
    return scratch_.rows.at(in_.slices()[slice].first);
  }
  const LeastDistance& least_of(std::size_t slice) const { return scratch_.least[slice]; }
  /// mm: the largest spread of a pack of the list.
  double spread() const { return spread_; }
  /// The region as the loops see it; `tool` is that of the slice that was measured last.
  const RegionArgs& at() const { return at_; }

  /// Whether the slice is kept or dropped by heights alone, by their lower bounds and the largest
  /// height to keep.
  bool is_bounded(std::size_t slice) const {
    return type(slice).form == SweepClass::Form::segment && by_heights_ &&
           !(undercuts_ && is_undercutting(type(slice)));
  }
  const float* lower(std::size_t slice) const {
    return scratch_.lower.data() + in_.slices()[slice].first;
  }
  float height_limit() const { return heights_.limit(); }

  /// Packs of turning sweeps: they are the last slice.
  bool has_packs() const {
    return !in_.slices().empty() && type(in_.slices().size() - 1).form == SweepClass::Form::turn;
  }
  const TurnTree::Packs& packs() const { return scratch_.packs; }
  const TurnTree::Nearest& nearest_pack() const { return scratch_.turned; }

 private:
  // Two packs of the largest spread, and more than the spread is rounded.
  static constexpr double kTwoSpreads = 2.001;

  // What the loops find for each slot of a list, in rows.
  class Rows {
   public:
    void resize(std::size_t slots);
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
    std::vector<LeastDistance> least;  ///< by slice
    std::vector<float> lower;          ///< bounds of heights by slot
    std::vector<double> distance;
    std::vector<std::uint32_t> ids;
    TurnTree::Packs packs;
    TurnTree::Nearest turned;
  };
  static Scratch& scratch();

  bool is_other(std::size_t slice) const {
    return type(slice).form == SweepClass::Form::other ||
           (type(slice).form == SweepClass::Form::segment && !is_bounded(slice));
  }
  // Its rows hold heights.
  bool is_measured_horizontal(std::size_t slice) const {
    return !type(slice).packs && (type(slice).form == SweepClass::Form::line ||
                                  type(slice).form == SweepClass::Form::arc);
  }
  void measure(const SweepTable& table);
  double measure_others(const SweepTable& table, const CandidateList::Slice& slice);
  LeastDistance measure_packs(const CandidateList::Slice& slice);
  void probe_slice(std::size_t slice);
  void measure_slice(std::size_t slice);
  void measure_heights();
  void drop_high(std::size_t slice);

  const SweepColumns& columns_;
  const CandidateList& in_;
  Scratch& scratch_ = scratch();
  const CandidateKernels& kernels_;
  const PruneRegion& region_;
  double deep_;  // mm: a region whose distances are below this is of no interest
  RegionArgs at_;
  HeightBounds heights_;
  bool by_heights_ = false;  // the list has segments, and only d within the band is wanted
  bool undercuts_;
  float least_ = std::numeric_limits<float>::infinity();
  double spread_ = 0;
};

/// mm: of the distance of a pack, which is known up to its spread; rounded up.
inline float spread_of(const SweepClass& type) {
  return static_cast<float>(kWiderSpread * type.spread);
}

/// Whether a class holds single lines of ball mills, whose rows hold their nearest points.
inline bool is_strip(const SweepClass& type) {
  return type.form == SweepClass::Form::strip && !type.packs;
}

/// The slot behind a slice.
inline std::size_t end_of(const CandidateList::Slice& slice) { return slice.first + slice.count; }

/// The half width in plan of a region.
inline float lateral(const RegionArgs& a) { return a.box ? a.half * 1.4142137f : a.radius; }

/// mm: what rounding may change in a difference of two distances.
inline double distance_slack(const SweepTable& table) { return 2 * table.max_error() + kRounding; }

}  // namespace mrsim
