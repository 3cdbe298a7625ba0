// Sizes that the default stocks of mills and lathes share.
#pragma once

#include <mrsim/types.h>

#include <limits>
#include <span>
#include <vector>

namespace mrsim {

inline constexpr double kLeastMargin = 1;    ///< mm
inline constexpr double kSameHeight = 1e-6;  ///< mm: heights nearer than this are one
inline constexpr double kNoHeight = -std::numeric_limits<double>::infinity();

/// Between the cuts and the sides of the stock.
double margin_of(const Box3& cuts);

/// Whole tenths of a millimetre: a stock that can be typed again.
double round_down(double v);
double round_up(double v);

/// Radius of each tool that cuts, 0 of the others.
std::vector<double> radii_of(std::span<const Motion> motions, std::span<const Tool> tools);

}  // namespace mrsim
