// The contour that a roughing cycle leaves: where a level lies above it. Works in two coordinates:
// u, along which the levels lie, and v, along which the tool cuts. Guarantees: a contour that runs
// on in v is a height over v, so that the stretches of a level that lie above it are found in
// order. It may rise and fall (pockets, type II).
#pragma once

#include "interp/path/plane_piece.h"

#include <vector>

namespace mrsim {

/// A stretch of a level that lies above the contour.
struct FreeStretch {
  double from = 0, to = 0;  ///< v
  bool first = false;       ///< it begins where the contour does
};

/// A motion of a turning contour in the coordinates (u, v), axes 0 (X) and 2 (Z), `shift` aside.
PlanePiece turned_piece(const Motion& motion, int u, int v, const Vec3& shift);

class RoughContour {
 public:
  /// `pieces` from the end of the approach on; `rise` and `along` (1 or -1): away from the
  /// material, and the direction in which the contour runs.
  RoughContour(std::vector<PlanePiece> pieces, double rise, double along)
      : pieces_(std::move(pieces)), rise_(rise), along_(along) {}

  /// Index of the first piece that runs back in v, or -1.
  int runs_back() const;
  /// The stretches of the level `u`, in the order of the contour.
  std::vector<FreeStretch> free_at(double u) const;
  /// u of the deepest point.
  double deepest() const;

 private:
  std::vector<PlanePiece> pieces_;
  double rise_, along_;
};

}  // namespace mrsim
