// The contour that a roughing cycle leaves: where a pass at some level meets it. Works in two
// coordinates: u, along which the levels lie, and v, along which the tool cuts.
// Guarantees: only contours that rise in u and run on in v are accepted; each level then meets
// once.
#pragma once

#include "interp/path/plane_piece.h"

#include <optional>
#include <vector>

namespace mrsim {

class RoughContour {
 public:
  /// `pieces` from the end of the approach on; `rise` and `run` (1 or -1): the directions in which
  /// the contour rises and runs.
  RoughContour(std::vector<PlanePiece> pieces, double rise, double run)
      : pieces_(std::move(pieces)), rise_(rise), run_(run) {}

  /// Index of the first piece that falls back or runs back, or -1.
  int pocket() const;
  /// v where the level u meets the contour; none: it lies above its end.
  std::optional<double> meet(double u) const;

 private:
  std::vector<PlanePiece> pieces_;
  double rise_, run_;
};

}  // namespace mrsim
