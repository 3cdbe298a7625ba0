// Finds out which sweeps of a table may be compared with each other.
#pragma once

#include "removal/columns/sweep_columns.h"

namespace mrsim {

/// Cuts the paths of tools with heights into segments: fills `segments` and `first_segment`.
void cut_segments(SweepColumns& columns);

/// Fills `classes`, `class_of` and `height_numbers` of finished columns (cut_segments too), and the
/// classes of their packs. Same result for any number of threads.
void classify(SweepColumns& columns, int threads);

}  // namespace mrsim
