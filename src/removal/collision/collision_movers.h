// Chooses the motions that could run a part of their tool into material and makes sweeps of those
// alone, so that a long program without shanks, holders and rapids in the stock costs next to
// nothing.
#pragma once

#include "removal/sweep/sweep_table.h"
#include <mrsim/collisions.h>

#include <cstdint>
#include <span>
#include <vector>

namespace mrsim {

inline constexpr double kSameTip = 1e-6;  ///< mm: tips no farther apart are at one place

/// One part of the tools along the motions that may collide.
struct Movers {
  SweepTable sweeps;
  std::vector<std::int32_t> motions;  ///< by sweep: its index among all motions, never falls
};

/// Motions from index `first` on whose part can meet `stock`: rapids for the cutter, rapids and
/// cuts for shank and holder. A rapid whose cutter stays where the cuts shortly before it have
/// been, above that, or within `touch` mm of it, is left out: the usual ways out and to the next
/// pass. Tools without a valid shape are added to `shapeless`. Cost: some nanoseconds for each
/// motion, some microseconds for each rapid in the stock. Same result for any number of threads.
Movers find_movers(ToolPart part, std::span<const Motion> motions, std::span<const Tool> tools,
                   std::size_t first, const Box3& stock, double touch, int threads,
                   std::vector<int>& shapeless);

}  // namespace mrsim
