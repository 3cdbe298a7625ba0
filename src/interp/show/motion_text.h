// Motions and diagnostics as text: the JSON lines of `mrsim trace --json` (docs/interp.md), and a
// line for people. The functions themselves are declared in <mrsim/mrsim.h>.
#pragma once

#include <mrsim/mrsim.h>

#include <string>

namespace mrsim {

/// Shortest text of at most 9 decimals and 12 significant digits: 42.5, never 42.50000000000001,
/// never -0.
std::string number_text(double value);

/// A dwell as a line of the trace, as JSON and for people.
std::string dwell_json(const Program& program, const Dwell& dwell);
std::string dwell_text(const Program& program, const Dwell& dwell);

/// "[x,y,z]"
std::string vector_text(const Vec3& v);

/// With quotes; control characters and quotes escaped.
std::string json_string(std::string_view text);

}  // namespace mrsim
