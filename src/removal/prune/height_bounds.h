// Bounds of heights over one region: which sweeps lie above all that matters, and whether the whole
// region lies above the lowest of them (docs/removal.md, Heights).
//
// Valid only where nothing but d within +-band is wanted: a sweep that is dropped may be the
// nearest one farther out in the air.
#pragma once

#include "removal/columns/sweep_class.h"
#include "removal/prune/candidate_list.h"

#include <limits>

namespace mrsim {

class HeightBounds {
 public:
  /// `band`: mm, with room for the rounding of a distance.
  explicit HeightBounds(double band) : band_(band) {}

  /// Sets the region, `lateral` mm wide in plan about its centre. To be called before anything
  /// else.
  void begin(const RegionArgs& at, float lateral);
  /// The arguments that the loops take for the sweeps, or packs, of a class.
  HeightArgs args(const SweepClass& type) const;
  /// Notes a sweep that reaches down to `upper` or lower over the whole square, and up beyond the
  /// region.
  void add(float upper) { least_ = upper < least_ ? upper : least_; }

  /// Whether the whole region lies deeper than the band in one sweep.
  bool is_swept() const { return least_ < swept_; }
  /// A sweep whose height is above this limit everywhere decides d nowhere within the band.
  float limit() const;

 private:
  double band_;
  HeightArgs args_;
  float least_ = std::numeric_limits<float>::infinity();
  float swept_ = -std::numeric_limits<float>::infinity(), above_ = 0, twice_ = 0;
};

}  // namespace mrsim
