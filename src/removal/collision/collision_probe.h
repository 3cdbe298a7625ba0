// Finds movers that collide by a few of their own points, before boxes are searched: the leading
// point of a rapid through material shows the collision at the cost of a few distances. A mover
// that is not found here may still collide.
#pragma once

#include "removal/collision/collision_search.h"
#include "removal/part/block_index.h"

#include <functional>
#include <vector>

namespace mrsim {

/// One hit for each mover that it finds, in the order of movers. `box_of`: where the mover can meet
/// material; flat in y for turned parts, empty where it can meet none. `near`: mm about a block in
/// which the list of cuts of the block is complete. Same result for any number of threads.
std::vector<CollisionHit> probe_movers(const CollisionScene& scene, double near,
                                       const std::function<Box3(std::uint32_t mover)>& box_of,
                                       int threads);

}  // namespace mrsim
