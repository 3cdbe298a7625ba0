// Blocks of Okuma that have a name instead of a number, and the contours of its LAP: "NLAP1 G81",
// the blocks of the contour, "G80". Private to src/interp.
#pragma once

#include "interp/language/program_outline.h"

#include <optional>
#include <string>
#include <string_view>

namespace mrsim {

struct LapContour {
  int number = 0;  ///< G81 along Z, G82 along X, G83 begins with the blank
  Place begin, end;
  Place behind;  ///< G80
};

/// Finds the block of this name between two places of a file: "NEND M9".
std::optional<Place> find_named_block(const std::string& file, const Place& from, const Place& to,
                                      std::string_view name);
/// Finds the contour of this name between two places of a file.
std::optional<LapContour> find_lap_contour(const std::string& file, const Place& from,
                                           const Place& to, std::string_view name);

}  // namespace mrsim
