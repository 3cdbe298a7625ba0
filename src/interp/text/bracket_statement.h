// Statements that some ISO controls write between brackets, where others have comments.
#pragma once

#include <string>
#include <string_view>

namespace mrsim {

/// The statement's name ("P100=", "IF", "RPT") where the text between ( and ) is one of the
/// Fagor controls that changes what moves; empty for comments and for statements without effect on
/// the path (MSG, DGWZ).
std::string bracket_statement(std::string_view text);

}  // namespace mrsim
