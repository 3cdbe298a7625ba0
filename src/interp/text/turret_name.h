// Names of tools in the lists of SINUMERIK's lathes: ROUGHING_T80_A, SCHLICHTER_35_I, STECHER_3_A.
// A and I at the end say that they work outside (aussen) or inside. Private to src/interp.
#pragma once

#include <string>
#include <string_view>

namespace mrsim {

/// The name as a comment would say it: "TOOL ID TURNING TOOL 80 DEG".
std::string spelled_turret_name(std::string_view name);

}  // namespace mrsim
