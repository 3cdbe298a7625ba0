// Options that were typed and do nothing in this command.
#pragma once

#include <string>
#include <vector>

namespace mrsim::cli {

struct CommandLine;
class TypedOptions;

/// One sentence each: what the option would need. The reader of a program reports what depends on
/// it.
std::vector<std::string> idle_options(const CommandLine& line, const TypedOptions& typed);

/// Prints them as notes, unless --quiet was typed.
void tell_idle_options(const CommandLine& line, const TypedOptions& typed);

}  // namespace mrsim::cli
