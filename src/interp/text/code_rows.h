// The G words of each control as rows of tables. code_table.h finds what a word means in a program.
// Private to src/interp.
#pragma once

#include "interp/text/codes.h"

#include <span>

namespace mrsim {

struct CodeRow {
  int number;  ///< G number * 10
  Code code;
  Group group;
};

/// Words that mean the same on all controls.
std::span<const CodeRow> shared_codes();
std::span<const CodeRow> sinumerik_codes();
/// Words that mean the same on FANUC's mills and lathes. Rows of one machine take precedence.
std::span<const CodeRow> fanuc_codes();
std::span<const CodeRow> fanuc_mill_codes();
std::span<const CodeRow> fanuc_lathe_codes();
std::span<const CodeRow> iso_codes();
std::span<const CodeRow> codesys_codes();
std::span<const CodeRow> linuxcnc_codes();

}  // namespace mrsim
