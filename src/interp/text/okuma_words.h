// The text of Okuma's OSP beside that of FANUC: names of blocks, programs and contours, variables,
// registers, patterns of holes, and blocks of several lines. Private to src/interp.
#pragma once

#include "interp/text/line_parser.h"
#include "interp/text/source.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace mrsim {

/// Adds the lines that continue `line`, the one that `source` has given last at `offset`. If there
/// are any, `line` refers to `joined` then.
void join_okuma_lines(LineSource& source, std::uint64_t offset, std::string_view& line,
                      std::vector<char>& joined);

/// Each function reads the word at the place, or returns false.
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
