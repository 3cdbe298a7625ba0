// Whether a stock that a program states is where the program cuts.
#pragma once

#include <mrsim/types.h>

#include <span>

namespace mrsim {

/// Of the way of all milling cuts below the top of `stock`, the share that passes it by at more
/// than the tool's diameter, beside it or below.
double share_beside(std::span<const Motion> motions, std::span<const Tool> tools,
                    const Box3& stock);

}  // namespace mrsim
