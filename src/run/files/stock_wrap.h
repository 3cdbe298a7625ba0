// --stock-repair wrap=...: a stock's mesh that bounds no solid, wrapped and measured.
#pragma once

#include <mrsim/mrsim.h>

#include <string>

namespace mrsim {

/// Wraps `mesh` and measures how far that moves its surface. Throws Error "stock-wrap",
/// "cancelled".
StockRepair wrap_stock(TriMesh& mesh, const StockOptions& options);

/// What was done to the file `name`, a sentence.
std::string wrap_text(const std::string& name, const StockRepair& repair);

}  // namespace mrsim
