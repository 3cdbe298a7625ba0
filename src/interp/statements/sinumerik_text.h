// Words in the text of SINUMERIK's definitions. Private to src/interp.
#pragma once

#include "interp/language/variables.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace mrsim {

/// The type that DEF or PROC names: REAL, INT, AXIS.
std::optional<VariableType> type_named(const std::string& name);

/// A word of a structure, such as IF or ENDLOOP: where structures begin and end is found in the
/// lines as they are written.
bool is_structure(std::string_view word);

/// Behind the blanks at `p`.
std::size_t blanks(std::string_view line, std::size_t p);

/// The name at `p`, which ends behind it, in upper case.
std::string word_at(std::string_view line, std::size_t& p);

/// The program that a path names, in upper case: HOLES of /_N_WKS_DIR/_N_PART_WPD/_N_HOLES_SPF.
std::string program_of_path(std::string_view path);

}  // namespace mrsim
