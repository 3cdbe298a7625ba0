// What the text of a STEP file tells before Open CASCADE reads it.
#pragma once

#include <string>
#include <string_view>

namespace mrsim {

/// Throws Error "step-too-far" for a point at infinity, which a damaged exponent gives: it keeps
/// Open CASCADE busy for minutes. `path` names the file.
void require_near(std::string_view text, const std::string& path);

/// Throws Error "step-unreadable" where an entity names one that the file does not hold: Open
/// CASCADE puts any other in its place.
void require_references(std::string_view text, const std::string& path);

}  // namespace mrsim
