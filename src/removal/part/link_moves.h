// Feeds that only link: they lead through the air, from a rapid to the first cut, from one cut to
// the next, or home.
#pragma once

#include <mrsim/types.h>

#include <span>
#include <vector>

namespace mrsim {

/// For each motion, whether it is a feed that shows nothing of the stock. Such feeds lie before
/// the program's zero (above Z0, on a lathe in front of it), and what follows them goes straight
/// behind it; or nothing follows, and the tool came up from there. On a lathe a way off a pass,
/// outwards and back over what that pass has turned, is one, too, with the feed or a rapid. Cost:
/// motions.
std::vector<bool> link_moves(std::span<const Motion> motions, double zero, bool lathe);

}  // namespace mrsim
