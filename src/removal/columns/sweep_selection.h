// Which motions and which part of the tools become sweeps.
#pragma once

#include <cstdint>
#include <limits>

namespace mrsim {

/// Which motions and which part of the tools a table holds. The default is what removes material;
/// the others are asked for collisions: rapids with any part, and shank and holder on all moves.
struct SweepSelection {
  enum class Part : std::uint8_t { cutter, shank, holder };
  Part part = Part::cutter;
  bool cuts = true;     ///< lines and arcs
  bool rapids = false;  ///< rapids, as straight lines
  /// Height above which nothing is asked, mm: a cutter whose flutes end there or higher, all along
  /// a motion, counts as one without end, and one that stays above makes no sweep. Not for cutters
  /// in a tilted frame.
  double top = std::numeric_limits<double>::infinity();
};

}  // namespace mrsim
