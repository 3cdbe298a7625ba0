// The line of PROC at the head of SINUMERIK's subprograms. Private to src/interp.
#pragma once

#include "interp/calls/subprogram.h"

#include <cstddef>
#include <optional>
#include <string>

namespace mrsim {

struct ProcLine {
  std::string line;
  std::size_t behind = 0;  ///< the place behind PROC
};

/// PROC in the first block of a subprogram, below comments; nothing: it has none.
std::optional<ProcLine> find_proc_line(const SubprogramPlace& place);

/// The file of a subprogram, with the line of its header if it is one of several in the file.
std::string shown_place(const SubprogramPlace& place);

}  // namespace mrsim
