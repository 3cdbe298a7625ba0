// TOML of files that anybody may have written.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <toml++/toml.h>

namespace mrsim {

/// What toml::parse() gives and throws. A key of more than 16 parts ("a.b.c ...") is a
/// toml::parse_error, too: the library makes a table of each part, and frees them by recursion,
/// which takes all of the stack. Throws Error "memory" as well (core/process/memory_limit.h).
toml::table parse_toml(std::string_view text);

/// The value of a number that is finite; nothing if `node` is none.
std::optional<double> finite_number(const toml::node& node);

/// Throws PlacedError `code` that says `what` of a place in `text`, the content of the file `name`,
/// and shows the line there.
[[noreturn]] void fail_at(const toml::source_position& at, std::string_view text,
                          const std::string& name, const char* code, const std::string& what);

/// Whether a word of a program can be `name`, which is compared with them as it stands ("G54",
/// "D1", "T4.D1"): an empty one or one in small letters would count for nothing. Behind the first
/// letter, names of tools have small ones.
bool is_program_word(std::string_view name);

/// Whether a control has a work offset of that name, as the program selects it: G54, "G54.1 P2",
/// G505, "G15 H2", E3, EXT. Another one would count for nothing.
bool is_work_offset(std::string_view name);
/// The fault of a name that is no work offset.
std::string no_offset(std::string_view name);

}  // namespace mrsim
