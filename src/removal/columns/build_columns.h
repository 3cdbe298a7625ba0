// Makes the columns of a program's sweeps. Motions become rows in parts that are made side by side
// and joined in the order of the program: the same columns for any number of threads.
#pragma once

#include "removal/columns/sweep_columns.h"
#include "removal/columns/sweep_selection.h"

#include <span>

namespace mrsim {

/// Fills empty columns, with packs, classes and the tree of turning sweeps. Throws as SweepTable.
void build_columns(std::span<const Motion> program, std::span<const Tool> tools,
                   const SweepSelection& selection, int threads, SweepColumns& out);

}  // namespace mrsim
