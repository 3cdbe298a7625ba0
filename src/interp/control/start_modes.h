// What is in force when a program starts: a table per dialect and machine.
#pragma once

#include "interp/control/state.h"

#include <string>
#include <utility>
#include <vector>

namespace mrsim {

/// The modes in force before the first block.
Modal start_modal(Dialect dialect, MachineKind machine);

/// The modes of start_modal() as text for people: "plane" -> "G17".
std::vector<std::pair<std::string, std::string>> start_mode_names(Dialect dialect,
                                                                  MachineKind machine);

/// The dialect as --dialect writes it.
const char* dialect_name(Dialect dialect);

}  // namespace mrsim
