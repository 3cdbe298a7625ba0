// Collisions of a whole program: which lines run the tool into material, how deep, and where.
#pragma once

#include "removal/part/stock.h"
#include <mrsim/collisions.h>
#include <mrsim/options.h>

#include <cstddef>
#include <span>

namespace mrsim {

/// Checks the motions from index `first` on (those before it belong to earlier setups) against the
/// material of their moment. `stock` is what carve() made of the same motions and tools. The result
/// does not depend on the number of threads. Throws Error "cancelled", and "option-invalid" for a
/// depth below 0.001 mm. Cost: docs/collisions.md.
CollisionReport find_collisions(const Stock& stock, std::span<const Motion> motions,
                                std::span<const Tool> tools, std::size_t first,
                                const CollisionOptions& options = {});

}  // namespace mrsim
