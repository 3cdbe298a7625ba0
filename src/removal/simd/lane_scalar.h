// The closed forms of sweep_lanes.inl for one sweep and one point: the reference of the SIMD ones.
#pragma once

#include "core/lane_scalar.h"
#include "removal/helix_record.h"

namespace mrsim::lane {

#define MRSIM_LANE inline
#include "removal/sweep_lanes.inl"
//
#include "removal/sweep_falling.inl"
//
#include "removal/sweep_helix.inl"
#undef MRSIM_LANE

}  // namespace mrsim::lane
