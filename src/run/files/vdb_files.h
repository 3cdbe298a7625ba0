// .vdb files as stocks and parts: those that mrsim saved go on from their recipe, others are the
// surface of their level set.
#pragma once

#include "removal/part/stock_file.h"
#include <mrsim/types.h>

#include <optional>
#include <string>

namespace mrsim {

/// What a .vdb file holds: a recipe of our own, else a surface.
struct VdbContent {
  std::optional<StockRecipe> recipe;
  TriMesh surface;       ///< not yet checked as a solid
  std::string accuracy;  ///< of the surface, and why it takes the recipe's place
};

/// Reads the file. Its voxels are read only where another program has made the file, or has written
/// it again: then they count if they have changed. OpenVDB reads them in a process of its own,
/// within limits of time and memory. Throws Error "vdb-unreadable", "vdb-damaged", "vdb-version",
/// "vdb-module".
VdbContent read_vdb_file(const std::string& path);

}  // namespace mrsim
