// Cones whose height no comment tells.
#pragma once

#include <mrsim/mrsim.h>

#include <optional>

namespace mrsim {

/// A taper without flute length, or a V tool without diameter.
bool is_open_cone(const Tool& tool);
/// Ends the cone at this height above its tip, mm, or just above the rounding of the tip.
void close_cone(Tool& tool, double height);

/// Tapers without flute length and V tools without diameter reach from their lowest cut up to
/// `top`, the stock's; where that is not known yet, as high as the cuts of the program begin. Each
/// is noted.
void complete_cones(JobResult& result, std::optional<double> top);

}  // namespace mrsim
