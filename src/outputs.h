// What simulate() writes: files by their extension, all of them or none.
#pragma once

#include "mesh/mesh_source.h"
#include "removal/stock.h"
#include "removal/stock_file.h"
#include <mrsim/options.h>
#include <mrsim/types.h>

#include <string>
#include <vector>

namespace mrsim {

/// Whether the name ends in .vdb: a stock with its recipe rather than a mesh.
bool is_vdb(const std::string& path);

/// Whether the name ends in .step or .stp.
bool is_step(const std::string& path);

/// Finds faults of output names before any work: an unknown format, a folder that is missing or
/// read-only, a name given twice. Throws Error "mesh-format" (usage), "output-...".
void check_outputs(const std::vector<std::string>& paths);

/// Why these outputs can not be written in slabs; empty: they can.
std::string whole_output(const std::vector<std::string>& paths);

/// Where the mesh may be kept while it is made: the folder of the first output.
std::string spill_folder(const std::vector<std::string>& paths);

/// Writes the part under every name, or under none.
void write_outputs(const std::vector<std::string>& paths, const MeshSource& mesh,
                   const Stock& stock, const StockRecipe& recipe,
                   const MeshFileOptions& options = {});

}  // namespace mrsim
