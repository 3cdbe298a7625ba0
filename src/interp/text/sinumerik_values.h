// What stands behind "=" in words of SINUMERIK: a number, AC(number) and its kin, a text, 'H1F'.
// Anything else is an expression of the control's language. Private to src/interp.
#pragma once

#include "interp/text/line_parser.h"

namespace mrsim {

class SinumerikValues : public LineParser {
 protected:
  explicit SinumerikValues(ParsedLine& line) : LineParser(line) {}

  /// Reads the value at the place. False: a fault, which is reported.
  bool value(Block& block, Word& word);
  /// A text in quotes.
  void text_value(Block& block, Word& word);

 private:
  bool any_value(Block& block, Word& word);
  bool more_follows() const;
  bool form_of_value(Block& block, Word& word);
  bool radix(Word& word);
};

}  // namespace mrsim
