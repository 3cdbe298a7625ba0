// The levels at the beginning of a SINUMERIK cycle's list: RTP RFP SDIS DP, and DPR where it has
// one. Private to src/interp.
#pragma once

#include "interp/cycles/cycle_call.h"

namespace mrsim {

/// Heights along the normal of the plane, mm.
struct CyclePlanes {
  double top = 0, reference = 0, safe = 0, bottom = 0;
  double up = 1;  ///< sign of the way out of the part
  bool cuts() const { return (reference - bottom) * up > 0; }
};

/// `mode` is the unit of AMODE: 0, DPR holds where it is not 0; 1, the depth counts from the
/// reference plane; 2, the depth is a level. `unit`: mm of a length of 1. Nothing: a value is
/// missing.
std::optional<CyclePlanes> cycle_planes(const CycleCall& call, int mode, double unit);

}  // namespace mrsim
