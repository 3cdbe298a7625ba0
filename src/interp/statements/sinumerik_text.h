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

/// Whether the word belongs to a structure, such as IF or ENDLOOP. The outline finds such words
/// only in lines as they are written.
bool is_structure(std::string_view word);

/// The name at `p` in upper case; `p` ends behind it.
std::string word_at(std::string_view line, std::size_t& p);

/// The program that a path names, in upper case: HOLES of /_N_WKS_DIR/_N_PART_WPD/_N_HOLES_SPF.
std::string program_of_path(std::string_view path);

}  // namespace mrsim
