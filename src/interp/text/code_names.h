// SINUMERIK's functions by name, and the names of what is not read yet. Private to src/interp.
#pragma once

#include "interp/text/code_table.h"

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
/// SINUMERIK calls that change nothing in the part and are passed over, upper case.
std::span<const std::string_view> harmless_calls();
/// Whether the upper-case name is in one of these two lists.
bool is_built_in_call(std::string_view name);
/// Cycles of SINUMERIK 802 without brackets: R parameters hold their values.
std::span<const std::string_view> cycles_of_802();

/// What the upper-case name (WHEN, CYCLE64) does, for the message that it is not read yet; empty
/// where the name is unknown.
std::string_view unsupported_name(std::string_view name);

}  // namespace mrsim
