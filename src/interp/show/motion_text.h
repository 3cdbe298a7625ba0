// Motions, events and diagnostics as text: the JSON lines of `mrsim trace --json` (docs/interp.md),
// and a line for people. The functions for motions and diagnostics are declared in <mrsim/mrsim.h>.
#pragma once

#include <mrsim/mrsim.h>
#include <mrsim/types.h>

#include <string>

namespace mrsim {

/// Shortest text of at most 9 decimals and 12 significant digits: 42.5, never 42.50000000000001,
/// never -0.
std::string number_text(double value);

/// The tool's id; of -1 nothing.
std::string tool_of(const Program& program, int tool);
/// File and calls of what stands in a subprogram, as JSON and for people; else nothing.
std::string called_json(const Program& program, int file, int call);
std::string called_text(const Program& program, int file, int call);

/// "[x,y,z]"
std::string vector_text(const Vec3& v);

/// An event as a line of the trace, as JSON and for people.
std::string event_json(const Program& program, const Event& event);
std::string event_text(const Program& program, const Event& event);

}  // namespace mrsim
