// Whether a stock that a program states is where the program cuts.
#pragma once

#include <mrsim/types.h>

#include <span>

namespace mrsim {

/// The share of the length of all milling cuts below the top of `stock` that passes it, beside or
/// below, by more than the tool's diameter.
double share_beside(std::span<const Motion> motions, std::span<const Tool> tools,
                    const Box3& stock);

}  // namespace mrsim
