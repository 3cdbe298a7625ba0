// Volumes that one solid has and the other has not, without a boolean operation.
#pragma once

#include <mrsim/types.h>

#include <cstddef>

namespace mrsim {

struct VolumeDifference {
  double only_first = 0, only_second = 0;  ///< mm^3
  double error = 0;                        ///< standard error of either, mm^3
};

/// Integrates along `rays` vertical lines at the points of the R2 sequence over both meshes'
/// outline: where walls stand upright, evenly spaced lines would all hit or all miss the layer
/// between them. Both volumes are known, which takes most of the error away. Requires: closed,
/// oriented meshes.
VolumeDifference volume_difference(const TriMesh& first, const TriMesh& second,
                                   std::size_t rays = 1 << 18, int threads = 0);

}  // namespace mrsim
