// Words of Okuma's OSP beside those of FANUC: names of blocks, programs and contours, variables,
// registers, patterns of holes. Each function reads the word at the place, or returns false.
// Private to src/interp.
#pragma once

#include "interp/text/line_parser.h"

namespace mrsim {

class OkumaWords : public LineParser {
 public:
  explicit OkumaWords(ParsedLine& line) : LineParser(line) {}

  bool register_word(Block& block);
  bool pattern(Block& block);
  bool program(Block& block);
  /// "<PART-1>", which FANUC's 30i has, too.
  bool program_in_brackets(Block& block);
  /// Whether an assignment follows. Reads nothing.
  bool assigns_name() const;
  bool block_name(Block& block);
  bool contour_name(Block& block);
  /// Passes over the words behind G84 of LAP.
  void skip_conditions(Block& block);
};

}  // namespace mrsim
