// The closed forms of sweep_lanes.inl for one sweep and one point: the reference of the SIMD ones.
#pragma once

#include "core/numbers/lane_scalar.h"
#include "core/numbers/rounding.h"
#include "removal/simd/form_records.h"

#include <cmath>
#include <limits>

namespace mrsim::lane {

#define MRSIM_LANE inline
#include "removal/simd/all_lanes.inl"
#undef MRSIM_LANE

}  // namespace mrsim::lane
