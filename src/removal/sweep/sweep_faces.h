// The faces of one sweep: which face (patch) is nearest to a point, its distance and its normal.
// Dispatched by the kind of the sweep; each function means what its namesake in SweepTable says.
#pragma once

#include "removal/sweep/sweep_columns.h"

namespace mrsim {

SweepSample sweep_sample(const SweepColumns& c, std::size_t i, const Vec3& p);
Vec3 sweep_gradient(const SweepColumns& c, std::size_t i, const Vec3& p, std::int32_t patch);
double sweep_patch_distance(const SweepColumns& c, std::size_t i, const Vec3& p,
                            std::int32_t patch);
std::optional<SweepTable::FlatFloor> flat_floor(const SweepColumns& c, std::size_t i,
                                                const Vec3& p);

}  // namespace mrsim
