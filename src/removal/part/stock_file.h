// The stock as a .vdb file: three grids, "distance" (mm, level set), "owner" and "cut" (when each
// voxel was removed: docs/history.md), that any OpenVDB tool opens, followed by the recipe they
// were made from, so that the next setup goes on exactly and not from samples.
//
// Layout: an OpenVDB stream, then the recipe (little endian), then 32 bytes: length of the recipe,
// hash of all before, the word "MRSIMVDB" and the version. Reading checks the hash and takes the
// recipe alone; OpenVDB's reader, which gives no guarantee on damaged files, never sees the bytes.
// The random identifier that OpenVDB writes is replaced by a hash of the recipe.
#pragma once

#include "core/text_io.h"
#include "removal/part/stock.h"
#include <mrsim/types.h>

#include <string>
#include <string_view>

namespace mrsim {

/// Everything that fixes a stock to the last bit: `shape` with its history (the cuts so far) and
/// the voxel in mm.
struct StockRecipe {
  StockShape shape;
  double voxel = 0;
};

/// Writes `stock`, made from `recipe`, to `out`. The same recipe gives the same bytes. Requires:
/// its grid was kept.
void write_vdb(const Stock& stock, const StockRecipe& recipe, const ByteSink& out);

/// The recipe of a file that write_vdb wrote. `name` is for messages. Throws Error "vdb-foreign"
/// for a .vdb of another program, "vdb-damaged" when bytes are missing or changed, "vdb-version"
/// for a newer version.
StockRecipe read_vdb(std::string_view bytes, const std::string& name);

}  // namespace mrsim
