// Sizes of turning inserts that nothing tells.
#pragma once

#include <mrsim/types.h>

namespace mrsim {

/// A neutral threading insert without width and edge is as wide as the largest lead that it cuts.
/// An inside tool without edge length, or a blade, reaches 16 mm from its point, or to the axis
/// where that is nearer.
void complete_inserts(Program& program);

}  // namespace mrsim
