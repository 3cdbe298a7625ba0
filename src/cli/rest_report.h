// What is left to cut, for people and for programs: `mrsim rest` and --rest of a run.
#pragma once

#include <mrsim/rest.h>

#include <string>

namespace mrsim::cli {

/// Lines: the sum, then two for each piece.
std::string rest_text(const Rest& rest);

/// One JSON object, docs/schema/rest.json.
std::string rest_json(const Rest& rest, const std::string& part, const std::string& nominal);

}  // namespace mrsim::cli
