// Finds the main program in files whose subprograms stand before it, as some controls and shops do.
// Private to src/interp.
#pragma once

#include <mrsim/types.h>

#include <cstdint>
#include <optional>
#include <string>

namespace mrsim {

struct MainProgram {
  std::string name;          ///< "O1"
  std::string why;           ///< why it is the main program
  std::uint64_t offset = 0;  ///< offset of its header line
  int line = 0;              ///< number of the line before `offset`
};

/// The program that calls the first one and ends with M30 or M2, if the first one ends with M99
/// (Okuma: RTS; SINUMERIK: M17 or RET, and the caller is an _MPF). SINUMERIK, before that: the
/// first _MPF of a file that begins with another kind of file. Nothing: the file begins with its
/// main program.
std::optional<MainProgram> main_program_behind(const std::string& file, Dialect dialect);

}  // namespace mrsim
