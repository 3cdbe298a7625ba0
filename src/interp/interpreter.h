// NC text to motions, as the control would read it: streaming, one motion per cutting block. Every
// fault becomes a Diagnostic.
#pragma once

#include "interp/text/motion_sink.h"
#include <mrsim/options.h>
#include <mrsim/types.h>

#include <string>

namespace mrsim {

/// Reads the program at `path`, hands motions and diagnostics to `sink` as they come and returns
/// the rest of Program (its motions and diagnostics are empty). Memory does not grow with the
/// length of the program. Throws Error "file-...", "program-empty", "machine-unclear" (kind usage).
Program interpret(const std::string& path, const InterpOptions& options, MotionSink& sink);

}  // namespace mrsim
