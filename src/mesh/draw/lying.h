// Pictures of turned parts: a lathe's axis lies.
#pragma once

#include <mrsim/types.h>

namespace mrsim {

/// Whether the part's walls are turned about Z: nine tenths of what of its area does not face along
/// Z faces to or from the axis, and that is not all but nothing.
bool is_turned(const TriMesh& mesh);

/// The mesh with Z from left to right and X upwards, where X went from left to right and Z upwards.
TriMesh laid_down(TriMesh mesh);

}  // namespace mrsim
