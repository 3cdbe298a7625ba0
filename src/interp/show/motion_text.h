// Motions, events and diagnostics as text: JSON lines of `mrsim trace --json` (docs/interp.md), and
// lines for people. The functions for motions and diagnostics are declared in <mrsim/mrsim.h>.
#pragma once

#include <mrsim/mrsim.h>
#include <mrsim/types.h>

#include <string>

namespace mrsim {

/// The shortest text of at most 9 decimals and 12 significant digits: 42.5, never 42.50000000000001
/// or -0.
std::string number_text(double value);

/// The id of the tool with this index; empty for -1.
std::string tool_of(const Program& program, int tool);
/// File and calls of a place in a subprogram, as JSON and for people; empty in the main program.
std::string called_json(const Program& program, int file, int call);
std::string called_text(const Program& program, int file, int call);

/// The vector as "[x,y,z]".
std::string vector_text(const Vec3& v);

/// An event as a line of the trace, as JSON and for people.
std::string event_json(const Program& program, const Event& event);
std::string event_text(const Program& program, const Event& event);

}  // namespace mrsim
