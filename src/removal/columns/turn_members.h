// Distances of points from a few turning sweeps, side by side. A sweep counts on the side of the
// spindle axis where it is and, mirrored, behind the axis.
#pragma once

#include "removal/forms/turn_sweep.h"
#include "removal/simd/sweep_kernels.h"
#include "removal/tool/polygon.h"

#include <cstdint>
#include <span>
#include <vector>

namespace mrsim {

/// The turning sweeps of a table, by row.
using TurnRows = std::span<const TurnSweep>;

/// A sweep, or its mirror image.
struct TurnMember {
  std::uint32_t sweep = 0, row = 0;
  bool behind = false;
};

/// Appends sweep `sweep` of row `row`, and its mirror image where that counts.
void append_sides(TurnRows turns, std::uint32_t sweep, std::uint32_t row,
                  std::vector<TurnMember>& out);

/// Brings `points`, as (rho, 0, z), up to date with some sweeps, the bits of turn_distance.
void least_of(TurnRows turns, std::span<const TurnMember> members, PointColumns& points);

/// A member with those of its sides that matter to points of one stretch of rho.
struct FacingMember {
  TurnMember member;
  std::uint32_t first = 0, count = 0;  ///< sides in the list; none: an arc, or a point
  double round = 0;
};
using TurnSides = std::vector<ConvexPolygon::Side>;

/// For points from (from, z) to (to, z). Appends to `sides` the sides of the member's polygon that
/// can decide its distance there.
FacingMember facing(TurnRows turns, const TurnMember& member, double from, double to, double z,
                    TurnSides& sides);
/// Does what the other least_of() does, to the same bits, for points of the stretch that `members`
/// were made for.
void least_of(TurnRows turns, std::span<const FacingMember> members, const TurnSides& sides,
              PointColumns& points);

}  // namespace mrsim
