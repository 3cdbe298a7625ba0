// What the ways in of tools show of the bar of a lathe beyond the sizes of its cuts: where it
// begins, on which side it is held, and whether it has a hole.
#pragma once

#include "removal/part/stock_margin.h"
#include <mrsim/types.h>

#include <cstdint>
#include <span>
#include <vector>

namespace mrsim {

/// Where tools begin to cut, mm in Z, where that may be in front of the program's zero.
struct FarWays {
  double begin = kNoHeight;
  bool is_front = false;  ///< the bar begins there, not at the zero: they cut in front of that
};

/// `begin` is kNoHeight where most ways in begin near the zero and lead behind it, or begin after a
/// face at it.
FarWays far_ways(std::span<const Motion> motions, std::span<const Tool> tools, double zero);

/// The radius from which on nothing is cut along Z: the largest of all cuts across, where tools go
/// in level from a rapid. Infinite where none does.
double air_radius(std::span<const Motion> motions);

/// Which end of the bar is held. `plus`: a counter spindle holds it, and its front looks to -Z, as
/// all ways in lead towards +Z, beyond all places where the tools were. A way back in the air
/// is none. `unsure`: they lead there
/// from behind the zero, where tools come to from in front of a bar, too.
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
