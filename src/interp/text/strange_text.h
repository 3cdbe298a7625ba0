// Text that is no word: characters without a meaning, letters without a number. Also text that can
// be read but is probably a mistake. Private to src/interp.
#pragma once

#include "interp/text/line_parser.h"

namespace mrsim {

class StrangeText : public LineParser {
 public:
  explicit StrangeText(ParsedLine& line) : LineParser(line) {}

  /// Reports the character at the place and what belongs to it.
  void character(Block& block);
  /// Reports the word that begins at `from`.
  void word(Block& block, std::size_t from);
  /// Reports the letter O where a zero is meant. False: no such word is at the place.
  bool zero_as_letter(Block& block);
  /// Warns of a comment behind ";" that may be a block.
  void doubt_comment(const Block& block);
  /// Warns of blanks in a number that begins at `from` and ends at the place.
  void check_inner_blanks(std::size_t from);

 private:
  bool word_of_others(Block& block);
};

}  // namespace mrsim
