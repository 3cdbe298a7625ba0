// What each G word means on a control: its code, its group and a number, from the tables of
// code_rows.h.
#pragma once

#include "interp/text/codes.h"
#include <mrsim/types.h>

#include <array>
#include <string_view>

namespace mrsim {

struct CodeEntry {
  Code code = Code::unknown;
  Group group = Group::none;
  int number = 0;  ///< which one, of a work offset or a cycle
};

/// The meaning of "G<number>" (number * 10, so that G54.1 is 541 and G54 is 540).
CodeEntry find_g_code(Dialect dialect, MachineKind machine, int number_by_10);
/// What an unsupported G word does, in a few words ("tilted working plane"); may be empty.
std::string_view unsupported_code(Dialect dialect, int number_by_10);
using CodeTable = std::array<CodeEntry, 1000>;  ///< the entries of G0 to G999, made once
const CodeTable& code_table(Dialect dialect, MachineKind machine);

}  // namespace mrsim
