// What --help says of each command beside its options.
#pragma once

#include "core/words/option_table.h"

#include <string_view>
#include <vector>

namespace mrsim::cli {

struct CommandLine {
  std::string_view word;  ///< "trace"; empty: a run
  OptionUse uses;         ///< whose options it takes
  const char* summary;
  const char* usage;
  std::vector<OptionGroup> groups;  ///< of its options, in the order of its --help
  const char* examples;
};

const CommandLine& command_line(OptionUse use);

}  // namespace mrsim::cli
