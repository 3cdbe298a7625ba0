// The stock as a .vdb file: three grids, "distance" (mm, level set), "owner" and "cut" (when each
// voxel was removed: docs/history.md), that any OpenVDB tool opens, and as metadata of the file the
// recipe they were made from, so that the next setup goes on exactly and not from samples, even
// when another program has read the file and written it again.
//
// Metadata: "mrsim:recipe", a string: base64 of the version, a hash of the rest, and the recipe
// (little endian); "mrsim:voxels", a string: the hash of the grid "distance" (level_set.h), which
// shows whether another program has changed it. The random identifier that OpenVDB writes is
// replaced by a hash of the recipe. Behind OpenVDB's stream follow 16 bytes: the word "MRSIMVDB"
// and a hash of all before, by which a file that nobody has written again is known to be whole.
#pragma once

#include "core/text/text_io.h"
#include "removal/part/stock.h"
#include <mrsim/types.h>

#include <optional>
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

/// What is known of a .vdb file without its voxels.
struct VdbFile {
  std::optional<StockRecipe> recipe;  ///< nothing: another program made the file
  std::string voxels;                 ///< the metadata "mrsim:voxels"
  bool rewritten = false;             ///< by another program: the voxels may be others
};

/// Reads the recipe; OpenVDB's reader, which gives no guarantee on damaged files, never sees the
/// bytes. `name` is for messages. Throws Error "vdb-unreadable" for what is no .vdb at all,
/// "vdb-damaged" when bytes are missing or changed, "vdb-version" for a newer version.
VdbFile read_vdb(std::string_view bytes, const std::string& name);

}  // namespace mrsim
