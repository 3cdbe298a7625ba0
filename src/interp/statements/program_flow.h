// Program flow in the words of a block: headers, calls, M words. Private to src/interp.
#pragma once

#include "interp/statements/statements.h"

namespace mrsim {

class ProgramFlow : public ControlPart {
 public:
  /// `statements`: null where the control has no language.
  ProgramFlow(Control& control, BlockReader& reader, Statements* statements)
      : ControlPart(control), reader_(reader), statements_(statements) {}

  /// Reads headers and finds the word that is a call. False: an error was reported.
  bool begin_block();
  /// Carries out the M words. False: errors were reported.
  bool m_words();
  /// Carries out calls, returns and ends, after everything else in the block.
  void end_block();

 private:
  bool alone(const Word& call);
  bool returns_by_m17() const;
  bool m_word(const Word& word);
  bool call_word(const Word& word, int m);
  bool z_home(const Word& word);
  void changer_retracts(const Word& word);
  void leave_length();
  bool okuma_return(int m);
  bool linuxcnc_signal(int m);
  bool call_at_block(const SubprogramName& name, long repeats, const Word& block);
  bool is_whole_number(long number);
  std::string program_name(const Word* p) const;
  bool fanuc_call(const Word& word);
  bool named_call(const Word& word);

  bool local_call(const Word& word);
  bool call(const SubprogramName& name, long repeats, const Word& word);

  BlockReader& reader_;
  Statements* statements_;
  const Word* call_begins_ = nullptr;  ///< Q or H of M98: the block at which the call begins
  bool centroid_ = false;              ///< the program has M25 beside G49
};

}  // namespace mrsim
