// Cycles of SINUMERIK 802S and 802C, LCYC82 and its kin, which read R parameters: each is one of
// the later cycles with these values. Private to src/interp.
#pragma once

#include "interp/cycles/cycle_call.h"
#include "interp/statements/statements.h"

#include <string_view>

namespace mrsim {

bool is_cycle_of_802(std::string_view name);

/// Fills in the name and the values of the later cycle. Requires: is_cycle_of_802(name). False: an
/// error was reported at `where`.
bool read_cycle_of_802(std::string_view name, Statements* statements, const Word& where,
                       CycleCall& call);

}  // namespace mrsim
