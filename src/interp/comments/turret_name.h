// Spells names of lathe tools as comments do, so that one reader serves both. Lists of tools of
// SINUMERIK have ROUGHING_T80_A, SCHLICHTER_35_I, STECHER_3_A, where A and I at the end say that
// the tool works outside (aussen) or inside; comments have I.D. GROOVE, OD_80_L. Private to
// src/interp.
#pragma once

#include <string>
#include <string_view>

namespace mrsim {

/// The name as a comment would say it: "TOOL ID TURNING TOOL 80 DEG".
std::string spelled_turret_name(std::string_view name);

/// A name with the points that names can not have: "MILL_D10_R0_5" is MILL_D10_R0.5.
std::string with_points(std::string_view name);

/// In a folded comment: "I.D." and "I/D" become "ID", NX's "OD_80_L" becomes "OD TURNING 80 DEG".
void spell_sides(std::string& folded);

}  // namespace mrsim
