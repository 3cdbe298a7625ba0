// G47 of Haas mills cuts a text, or the serial number of #599. Places, heights and depths are those
// of the program, the letters those of a plain font. Private to src/interp.
#pragma once

#include "interp/milling/letter_cutter.h"
#include "interp/statements/statements.h"

#include <optional>
#include <string>

namespace mrsim {

class Engraving : public ControlPart {
 public:
  Engraving(Control& control, Statements* statements, AxisWords& axes, Moves& moves)
      : ControlPart(control), statements_(statements), axes_(axes), cutter_(control, moves) {}

  /// Whether the comment of the block is a text to engrave.
  bool wants_block() const { return block_.oneshot && block_.oneshot_code == Code::engrave; }
  /// As wants_block(), before the meaning of the words is read.
  static bool holds_text(const BlockWords& block);
  /// Cuts the text of the block. False: an error was reported.
  bool run();

 private:
  /// A text. Lengths are in mm, levels along Z.
  struct Text {
    std::string letters;
    double height = 0, turn = 0;
    double retract = 0, depth = 0;
    double plunge = 0;  ///< feed; 0: the one in force
  };

  bool allowed();
  bool read(Text& out);
  bool read_letters(Text& out);
  bool serial_number(std::string_view form, std::string& out);
  void cut(const Text& text);

  Statements* statements_;  ///< null: the control has no language here
  AxisWords& axes_;
  LetterCutter cutter_;
};

}  // namespace mrsim
