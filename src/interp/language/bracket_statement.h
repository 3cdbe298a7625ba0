// Statements in brackets, as controls of the ISO family (Fagor 8055) write them: (P1=5),
// (IF P1 EQ 2 GOTO N10), (RPT N10,N20). Tells them from comments, which also stand in brackets.
#pragma once

#include <string>
#include <string_view>

namespace mrsim {

/// The word that makes a statement of the text between brackets ("IF", "RPT"); empty: a comment.
std::string bracket_statement(std::string_view text);

}  // namespace mrsim
