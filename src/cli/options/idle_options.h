// Options that were typed and do nothing in this command.
#pragma once

#include <string>
#include <vector>

namespace mrsim::cli {

struct CommandLine;
class TypedOptions;

/// A sentence for each option that has no effect in this run: what the option would need. What
/// depends on the program is reported by the program's reader.
std::vector<std::string> idle_options(const CommandLine& line, const TypedOptions& typed);

/// Prints them as notes, unless --quiet was typed.
void tell_idle_options(const CommandLine& line, const TypedOptions& typed);

}  // namespace mrsim::cli
