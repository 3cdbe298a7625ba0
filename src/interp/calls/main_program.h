// Files whose subprograms stand before the main program, as some controls and shops want them.
// Private to src/interp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace mrsim {

struct MainProgram {
  std::string name, first;   ///< "O1", and the subprogram at the head of the file, "O1000"
  std::uint64_t offset = 0;  ///< of its header line
  int line = 0;              ///< number of the line before `offset`
};

/// The program of a FANUC file that calls the first one and ends with M30 or M2, where the first
/// ends with M99. Nothing: the first one is the main program.
std::optional<MainProgram> program_that_calls_the_first(const std::string& file);

}  // namespace mrsim
