// A stock for those who give none: a plain solid around everything that the program cuts.
#pragma once

#include <mrsim/types.h>

#include <span>

namespace mrsim {

/// Mill: a box round the swept volume, with a margin of 5 % of its longest side (at least 1 mm) at
/// the sides and below; its top is the highest cut below the start of the first plunge. Lathe: a
/// cylinder about Z up to the largest radius of a programmed point, with that margin towards the
/// chuck. Throws what SweepTable throws. Requires: at least one cutting motion.
StockShape default_stock(std::span<const Motion> motions, std::span<const Tool> tools, bool lathe);

/// Whether removal cuts with this motion: a line or an arc, not of assumed start.
inline bool is_cut(const Motion& m) { return m.kind != MotionKind::rapid && !m.assumed_start; }

}  // namespace mrsim
