// Finds the main program in files whose subprograms stand before it, as some controls and shops do.
// Private to src/interp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace mrsim {

struct MainProgram {
  std::string name, first;   ///< "O1", and the subprogram at the head of the file, "O1000"
  std::uint64_t offset = 0;  ///< offset of its header line
  int line = 0;              ///< number of the line before `offset`
};

/// The program of a FANUC file that calls the first one and ends with M30 or M2, if the first one
/// ends with M99. Nothing: the first one is the main program.
std::optional<MainProgram> program_that_calls_the_first(const std::string& file);

}  // namespace mrsim
