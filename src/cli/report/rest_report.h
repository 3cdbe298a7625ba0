// What is left to cut, for people and for programs: `mrsim rest` and --rest of a run.
#pragma once

#include <mrsim/rest.h>

#include <string>

namespace mrsim::cli {

/// Lines: the sum, then two for each piece.
std::string rest_text(const Rest& rest);

/// One JSON object, docs/schema/rest.json: its error is null.
std::string rest_json(const Rest& rest, const std::string& part, const std::string& nominal);
/// The same keys for one that has ended with an error; numbers that are not known are null.
std::string failed_rest_json(const std::string& part, const std::string& nominal,
                             const std::string& error_code, const std::string& error_text);

}  // namespace mrsim::cli
