// Turns a StockRecipe into bytes (little endian) and back. Every count is checked against the bytes
// that are there.
#pragma once

#include "removal/part/stock_file.h"

#include <string>
#include <string_view>

namespace mrsim {

/// The recipe as bytes, which decode_recipe() reads.
std::string encode_recipe(const StockRecipe& recipe);
/// Throws Error "vdb-damaged" for bytes that encode_recipe can not have made.
StockRecipe decode_recipe(std::string_view bytes, const std::string& name);

}  // namespace mrsim
