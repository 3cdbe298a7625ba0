// The report of a run for people: the facts in the order in which they were decided, then the part,
// then the time.
#pragma once

#include "cli/options/arguments.h"
#include <mrsim/mrsim.h>

#include <string>

namespace mrsim::cli {

/// The report of a simulation that ended well.
std::string format_report(const Arguments& arguments, const JobResult& result, bool colours);

/// Dialect, machine, tools of a program, and (verbose) the modes it starts in.
std::string format_program(const Program& program, bool verbose, bool colours);

/// "SINUMERIK"; "mill".
const char* dialect_name(Dialect dialect);
const char* machine_name(MachineKind kind);
/// "cutter", "shank", "holder".
const char* tool_part_name(ToolPart part);
/// "end mill Ø5, flutes 20 mm"
std::string tool_text(const Tool& tool);
}  // namespace mrsim::cli
