// A tool's outline as a union of convex solids, whose distances have closed forms.
#pragma once

#include "removal/tool/profile.h"

#include <vector>

namespace mrsim {

/// What Profile::convex_pieces() promises. The pieces that have edges of the profile come first, in
/// the order of the edges: a new one begins at each reflex corner, and amid each concave arc.
std::vector<Profile> convex_pieces_of(std::vector<ProfileEdge> edges,
                                      std::vector<Profile::Corner> corners);

}  // namespace mrsim
