// The bar of a lathe, as the moves by which tools go into the material show it, beyond the sizes of
// the cuts: where the bar begins, which end is held, and whether it has a hole.
#pragma once

#include "removal/part/stock_margin.h"
#include <mrsim/types.h>

#include <cstdint>
#include <span>
#include <vector>

namespace mrsim {

/// The place in Z, mm, where tools begin to cut. It may lie in front of the program's zero.
struct FarWays {
  double begin = kNoHeight;
  bool is_front = false;  ///< the bar begins there, not at the zero: they cut in front of that
};

/// `begin` is kNoHeight if most moves into the material begin near the zero and lead behind it, or
/// begin after the zero has been faced.
FarWays far_ways(std::span<const Motion> motions, std::span<const Tool> tools, double zero);

/// The radius beyond which nothing is cut along Z: the largest one of all cuts that do not run
/// along Z. Infinite unless a tool goes straight inwards right behind a rapid: only such a move
/// shows where the air ends.
double air_radius(std::span<const Motion> motions);

/// Which end of the bar is held. `plus`: a counter spindle holds it, and its front looks to -Z: all
/// moves into the material lead towards +Z, beyond all places where the tools were (a way back in
/// the air does not count). `unsure`: such moves begin behind the zero, which tools also reach from
/// in front of a bar.
enum class HeldEnd : std::uint8_t { minus, plus, unsure };
HeldEnd held_end(std::span<const Motion> motions, double zero);

/// The same program at a bar that is held on the other side: Z turned round.
std::vector<Motion> mirrored_in_z(std::span<const Motion> motions);
std::vector<Tool> mirrored_in_z(std::span<const Tool> tools);

/// The largest radius at which the rapids of the first boring bar's first pass go behind `front`,
/// where nothing is drilled before: the raw part has a hole there. 0: none.
double entered_hole(std::span<const Motion> motions, std::span<const Tool> tools, double front);

/// The radius of a hole that the first boring bar needs, which goes in with the feed where nothing
/// is drilled before: a little less than what it cuts. 0: none, or it cuts from the axis on.
double needed_hole(std::span<const Motion> motions, std::span<const Tool> tools, double front);

}  // namespace mrsim
