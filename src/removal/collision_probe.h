// Movers that a few of their own points show to collide, before boxes are searched: a rapid through
// material is told by the point that leads it, at the cost of some distances. It proves nothing of
// the others.
#pragma once

#include "removal/block_index.h"
#include "removal/collision_search.h"

#include <functional>
#include <vector>

namespace mrsim {

/// One hit for each mover it finds, by mover. `box_of`: where the mover can meet material, flat in
/// y for turned parts, empty where it can not. `near`: mm about a block in which its list of cuts
/// is complete. The same for any number of threads.
std::vector<CollisionHit> probe_movers(const CollisionScene& scene, const BlockIndex& blocks,
                                       double near,
                                       const std::function<Box3(std::uint32_t mover)>& box_of,
                                       int threads);

}  // namespace mrsim
