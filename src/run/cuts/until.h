// Which motions of a program come before a moment that the user names.
#pragma once

#include <mrsim/types.h>

#include <cstddef>
#include <string>

namespace mrsim {

/// Number of motions up to the moment `until`:
///   "#5000"      after motion 5000, counted from 1
///   "12"         when line 12 of the program, or the subprograms that it calls, are done for the
///                first time; for a line that moves nothing, the line before it that does
///   "O100:7"     the same for line 7 of a file by its name, with or without extension, or by its
///   number
///                (O0100.nc)
/// Throws Error "until-invalid", "until-file", "until-beyond" (kind usage), naming what would do.
std::size_t motions_until(const Program& program, const std::string& until);

}  // namespace mrsim
