// A stock for those who give none: a plain solid around everything that the program cuts
// (docs/default_stock.md).
#pragma once

#include <mrsim/types.h>

#include <span>
#include <string>

namespace mrsim {

struct AssumedStock {
  StockShape shape;
  std::string guesses;  ///< what nothing in the program says for sure, in words; or ""
};

/// Mill: a box round the swept volume, with a margin of 5 % of its longest side (at least 1 mm) at
/// the sides and below. Its top is at `zero`, where all cuts below the start of the first
/// plunge lie below it; else the highest of those cuts (one margin above, where all are at one
/// height, but below the lowest rapid). A side is drawn in where a rapid goes down beside the part
/// into what nothing has cut. Lathe: a cylinder about Z up to the largest radius of a cut, or of
/// the nearest rapid beyond those towards the chuck, or into what nothing has cut; round bores with
/// a margin. Its front is at `zero` or up to 1 mm before the highest cut across, behind the nearest
/// rapid. Throws what SweepTable throws. Requires: at least one cutting motion. Cost: motions;
/// rapids down into the stock look back for the cut that made way. `zero`: height of the program's
/// zero, mm (Program::zero_height).
AssumedStock default_stock(std::span<const Motion> motions, std::span<const Tool> tools, bool lathe,
                           double zero = 0);

}  // namespace mrsim
