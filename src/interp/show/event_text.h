// Events as text. Part of the facade's trace.
#pragma once

#include <mrsim/types.h>

#include <string>

namespace mrsim {

/// An event as a line of the trace, as JSON and for people.
std::string event_json(const Program& program, const Event& event);
std::string event_text(const Program& program, const Event& event);

}  // namespace mrsim
