// Which motions of a program come before a moment that the user names.
#pragma once

#include "interp/text/motion_sink.h"
#include <mrsim/types.h>

#include <cstddef>
#include <functional>
#include <string>

namespace mrsim {

/// A moment of a program, by how many motions and events lie before it.
struct Moment {
  std::size_t motions = 0, events = 0;
  double dwell =
      0;  ///< s of the last event that have passed, where it is a dwell of several blocks
};

/// The moment `until`:
///   "#5000"      after motion 5000, counted from 1
///   "12"         when line 12 of the program, with the subprograms that it calls, is done for the
///                first time; where it is no block, before the first block behind it
///   "O100:7"     the same for line 7 of a file by its name, with or without extension, or by its
///                number (O0100.nc)
/// `read_again`: hands the program on once more. Throws Error "until-invalid", "until-file",
/// "until-beyond" (kind usage), naming what would do.
Moment moment_until(const Program& program, const std::string& until,
                    const std::function<void(MotionSink&)>& read_again);

}  // namespace mrsim
