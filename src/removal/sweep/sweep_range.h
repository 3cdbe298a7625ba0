// Bounds of the distance from a face of a sweep, valid on all of a triangle.
#pragma once

#include "removal/columns/sweep_columns.h"

namespace mrsim {

/// Does what SweepTable::patch_range does; the default FaceRange where no enclosure is known.
FaceRange sweep_range(const SweepColumns& c, std::size_t i, const Corners3& t, std::int32_t patch);

}  // namespace mrsim
