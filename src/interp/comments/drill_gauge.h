// Number and letter drills of ANSI B94.11M: "#7 DRILL", "NO. 29 DRILL", "F DRILL", "LETTER Q
// DRILL"; keyseat cutters of ANSI B17.2: "WOODRUFF #404".
#pragma once

#include "interp/comments/comment_view.h"

#include <cstddef>
#include <optional>
#include <string>

namespace mrsim {

struct DrillGauge {
  std::string name;                ///< "7", "Q"
  double inches = 0;               ///< diameter
  std::size_t first = 0, end = 0;  ///< tokens [first, end)
};

/// The gauge beside the tokens [kind_first, kind_end), which name the drill.
std::optional<DrillGauge> find_drill_gauge(const CommentView& view, std::size_t kind_first,
                                           std::size_t kind_end);

/// A centre drill by its number: "#3", or "BS3" of BS 328. Its sizes are in inches.
struct CentreGauge {
  std::string name;                ///< "3"
  double pilot = 0, body = 0;      ///< diameters
  bool disputed = false;           ///< ANSI B94.11M, which is given, and BS 328 differ
  std::size_t first = 0, end = 0;  ///< tokens [first, end)
};

/// The number beside the tokens [kind_first, kind_end), which name a centre drill.
std::optional<CentreGauge> find_centre_gauge(const CommentView& view, std::size_t kind_first,
                                             std::size_t kind_end);

/// "#404": the last two digits are eighths of an inch of the diameter, those before them 32nds of
/// the width.
struct KeyNumber {
  double inches = 0, width = 0;
  std::size_t first = 0, end = 0;  ///< tokens [first, end)
};

/// The number beside the tokens [kind_first, kind_end), which name a keyseat cutter.
std::optional<KeyNumber> find_key_number(const CommentView& view, std::size_t kind_first,
                                         std::size_t kind_end);

}  // namespace mrsim
