// The parameter lists of SINUMERIK's milling cycles: which value stands where. RTP, RFP, SDIS and
// DP lead all of them. Private to src/interp.
#pragma once

#include <string_view>

namespace mrsim {

/// Where the values of a cycle stand in its list; -1: it has none. The depth of the tip follows
/// behind the width of a chamfer.
struct MillList {
  std::string_view name;
  int dpr = -1, num = -1, length = -1, width = -1, corner = -1, at = -1, radius = -1, start = -1,
      step = -1, infeed = -1, side = -1, floor = -1, feed = -1, plunge = -1, direction = -1,
      mode = -1, width_step = -1, blank = -1, helix = -1, finish_infeed = -1, gmode = -1,
      amode = -1, chamfer = -1;
};

/// Null: no milling cycle that is read.
const MillList* find_mill_list(std::string_view name);

}  // namespace mrsim
