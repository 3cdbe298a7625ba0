// Options that were typed and do nothing in what was asked for.
#pragma once

#include <string>
#include <vector>

namespace mrsim::cli {

struct CommandLine;
class TypedOptions;

/// One sentence each: what the option would need. What depends on the program, its reader tells.
std::vector<std::string> idle_options(const CommandLine& line, const TypedOptions& typed);

/// Prints them as notes, unless --quiet was typed.
void tell_idle_options(const CommandLine& line, const TypedOptions& typed);

}  // namespace mrsim::cli
