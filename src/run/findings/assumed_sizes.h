// Sizes of tools that no file gives: heights of cones, widths and reaches of turning inserts. They
// are taken from what the program cuts.
#pragma once

#include <mrsim/mrsim.h>
#include <mrsim/types.h>

#include <optional>

namespace mrsim {

/// A tapered mill without flute length, or a V tool without diameter.
bool is_open_cone(const Tool& tool);
/// Ends the cone at this height above its tip, mm, or just above the rounding of the tip.
void close_cone(Tool& tool, double height);

/// Tapered mills without flute length and V tools without diameter reach from their lowest cut up
/// to `top`, the stock's; where that is not known yet, as high as the cuts of the program begin.
/// Each is noted.
void complete_cones(JobResult& result, std::optional<double> top);

/// A neutral threading insert without width and edge is as wide as the largest lead that it cuts.
/// An inside tool without edge length, or a blade, reaches 16 mm from its point, or to the axis
/// where that is nearer.
void complete_inserts(Program& program);

}  // namespace mrsim
