// The bar of a lathe for those who give no stock.
#pragma once

#include "removal/part/default_stock.h"
#include <mrsim/types.h>

#include <span>

namespace mrsim {

/// The bar that default_stock() takes for a lathe. Requires: at least one cutting motion.
AssumedStock default_bar(std::span<const Motion> motions, std::span<const Tool> tools, double zero);

}  // namespace mrsim
