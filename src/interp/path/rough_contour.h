// The contour that a roughing cycle leaves, and the stretches of a level that lie above it, in two
// coordinates: each level has one u, and the tool cuts along v. Guarantees: a contour that never
// runs back in v has one height for each v, so that the stretches are found in order. It may rise
// and fall (pockets, type II).
#pragma once

#include "interp/path/plane_piece.h"

#include <vector>

namespace mrsim {

/// A stretch of a level that lies above the contour.
struct FreeStretch {
  double from = 0, to = 0;  ///< v
  bool first = false;       ///< the stretch begins where the contour does
};

/// A motion of a turning contour in the coordinates (u, v), axes 0 (X) and 2 (Z), moved by `shift`.
PlanePiece turned_piece(const Motion& motion, int u, int v, const Vec3& shift);

class RoughContour {
 public:
  /// `pieces` begin at the end of the approach. `rise`, 1 or -1, is the direction in u away from
  /// the material; `along`, 1 or -1, the direction in v in which the contour runs.
  RoughContour(std::vector<PlanePiece> pieces, double rise, double along)
      : pieces_(std::move(pieces)), rise_(rise), along_(along) {}

  /// Index of the first piece that runs back in v, or -1.
  int runs_back() const;
  /// Index of the first piece that falls towards the material, or -1: the contour only rises.
  int falls() const;
  /// The stretches of the level `u`, in the order of the contour.
  std::vector<FreeStretch> free_at(double u) const;
  /// u of the deepest point.
  double deepest() const;

 private:
  int against(Vec2 way) const;

  std::vector<PlanePiece> pieces_;
  double rise_, along_;
};

}  // namespace mrsim
