// Enters the words of a block by address: which addresses a control knows, how often each may stand
// in a block, and which of them no part has taken. Private to src/interp.
#pragma once

#include "interp/control/control.h"

namespace mrsim {

class WordIndex : public ControlPart {
 public:
  explicit WordIndex(Control& control);
  /// Enters the words of the block by address. False: errors were reported.
  bool run();
  /// Warns of each known address in the block that no part has taken.
  void report_unused();

 private:
  const Word* dialogue_cycle() const;
  const Word* number_of_offset() const;
  void read_okuma_corner();
  bool chooses_fixture() const;
  bool use_own_register(Word& word);
  bool refuse_address(const Word& word);
  bool leave_out_dialogue(const Word& cycle);
  bool may_repeat(const Word& word) const;
  bool refuse_repeat(const Word& word);

  std::array<bool, static_cast<std::size_t>(Address::count)> legal_{};  ///< by address
};

}  // namespace mrsim
