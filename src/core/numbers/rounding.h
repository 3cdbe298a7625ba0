// Numbers that are no geometry: below what size a difference of doubles is rounding, and infinity.
#pragma once

#include <limits>

namespace mrsim {

/// A distance from nothing, or the end of something without one.
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// mm: lengths and gaps up to this are none. Coordinates up to 10 m are rounded by 1e-12, sums of
/// some of them by 1e-11; no control reads steps below 1e-5.
inline constexpr double kRounding = 1e-9;

/// mm: distances that bound others are widened by this, more than they are rounded.
inline constexpr double kBoundError = 1e-8;

/// Radians, and products of unit vectors: turns up to this are none.
inline constexpr double kTurnRounding = 1e-9;

/// In place of a divisor that is 0, so that the quotient stays finite or counts for nothing.
inline constexpr double kNoDivisor = 1e-300;

/// Shares: sizes that differ by less are equal, a sum of products is rounded by less.
inline constexpr double kShareRounding = 1e-9;

}  // namespace mrsim
