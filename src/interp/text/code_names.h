// SINUMERIK's functions by name, and the names of what is not read yet. Private to src/interp.
#pragma once

#include "interp/text/codes.h"

#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace mrsim {

/// The meaning of a name ("TRANS", "CIP"), upper case; SINUMERIK only.
CodeEntry find_function(std::string_view name);

/// All names that find_function() knows.
std::vector<std::pair<std::string_view, CodeEntry>> function_names();

/// SINUMERIK calls whose arguments the interpreter reads, upper case.
std::span<const std::string_view> read_calls();
/// Cycles without brackets, whose values stand in R parameters.
std::span<const std::string_view> cycles_of_802();

/// What an upper-case name (WHEN, CYCLE64) announces that this reader does not do yet; or empty.
std::string_view unsupported_name(std::string_view name);

}  // namespace mrsim
