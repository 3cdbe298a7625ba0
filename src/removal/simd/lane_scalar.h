// The closed forms of sweep_lanes.inl for one sweep and one point: the reference of the SIMD ones.
#pragma once

#include "core/lane_scalar.h"
#include "core/rounding.h"
#include "removal/field/record_slots.h"
#include "removal/simd/chain_record.h"
#include "removal/simd/helix_record.h"
#include "removal/simd/outline_record.h"
#include "removal/simd/slant_record.h"
#include "removal/simd/upright_record.h"

#include <cmath>
#include <limits>

namespace mrsim::lane {

#define MRSIM_LANE inline
#include "removal/simd/all_lanes.inl"
#undef MRSIM_LANE

}  // namespace mrsim::lane
