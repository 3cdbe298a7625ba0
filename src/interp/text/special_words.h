// Words that only some controls have: names of CODESYS, corners of FANUC, instructions of Fagor's
// 8070, commands of Grbl. Each function reads the word at the place, or returns false.
// Private to src/interp.
#pragma once

#include "interp/text/line_parser.h"

namespace mrsim {

class SpecialWords : public LineParser {
 public:
  explicit SpecialWords(ParsedLine& line) : LineParser(line) {}

  bool macro_word(Block& block);
  bool fagor_instruction(Block& block);
  bool spindle_speed(Block& block, Word& word);
  bool skips_switch(const Block& block);
  /// Whether the number at the place is that of an M117 or M118 whose text may begin with a digit.
  bool begins_message() const;
  /// Whether a text for the display follows `word`, an M word. Reads nothing.
  bool has_message(const Word& word) const;
  bool corner_word(Block& block);
  bool bare_axis(Block& block);
  void jump_label();
  void codesys_name(Block& block);
  bool grbl_command(Block& block);
};

}  // namespace mrsim
