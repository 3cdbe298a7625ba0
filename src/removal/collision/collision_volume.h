// How much material a part of a tool meets on one motion.
#pragma once

#include "removal/collision/collision_search.h"

#include <span>

namespace mrsim {

/// mm^3 of the material of that moment within the union of `movers`, which belong to one motion.
/// Boxes that the surface crosses are halved until they hold a 25th of the volume, or until there
/// are some thousands; these count as if it passed flat. `box` holds all places where
/// the movers can meet material; one that is flat in y stands for the ring about the Z axis.
double met_volume(const CollisionScene& scene, std::span<const std::uint32_t> movers,
                  const Box3& box);

}  // namespace mrsim
