// Bounds of heights over one region: which sweeps lie above all that matters, and whether the
// whole region lies above the lowest of them (docs/removal.md, Heights).
//
// Holds where no more is wanted than d within +-band: sweeps that go may be the nearest deeper in
// the air than that.
#pragma once

#include "removal/columns/sweep_class.h"
#include "removal/prune/candidate_list.h"

#include <limits>

namespace mrsim {

class HeightBounds {
 public:
  /// `band` holds what rounding may change in a distance, too.
  explicit HeightBounds(double band) : band_(band) {}

  /// Before the first question: the region as the loops see it, `lateral` mm wide in plan about its
  /// centre.
  void begin(const RegionArgs& at, float lateral);
  /// What the loops take for the sweeps, or packs, of a class.
  HeightArgs args(const SweepClass& type) const;
  /// Notes that some sweep reaches down to `upper` over the whole square, and up beyond the region.
  void add(float upper) { least_ = upper < least_ ? upper : least_; }

  /// The whole region is deeper in one sweep than the band.
  bool is_swept() const { return least_ < swept_; }
  /// A sweep whose height is more than this everywhere decides nothing that matters.
  float limit() const;

 private:
  double band_;
  HeightArgs args_;
  float least_ = std::numeric_limits<float>::infinity();
  float swept_ = -std::numeric_limits<float>::infinity(), above_ = 0, twice_ = 0;
};

}  // namespace mrsim
