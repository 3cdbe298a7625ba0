// Collisions as findings about the program's lines.
#pragma once

#include "run/cuts/cuts.h"
#include <mrsim/collisions.h>

namespace mrsim {

/// Adds a warning for each line of the report, one for those beyond, and a note for tools that were
/// not checked, to the program's diagnostics. Makes the indices of the report those of the program.
void add_collisions(Program& program, const CutList& cuts, CollisionReport& report);

}  // namespace mrsim
