// Stocks by words: "box:x0,y0,z0,x1,y1,z1", "cylinder:d,z0,z1", "tube:d,bore,z0,z1", mm.
#pragma once

#include <mrsim/types.h>

#include <optional>
#include <string>

namespace mrsim {

/// The stock that `spec` describes, lengths in mm or with their unit; nothing when it is the name
/// of a file: no word, colon and numbers. Round stocks stand on the Z axis. Throws Error
/// "stock-spec" of kind usage that says what is wrong.
std::optional<StockShape> parse_stock_spec(const std::string& spec);

}  // namespace mrsim
