// G words that machine makers read in their own way on a control of FANUC's kind: Okuma's OSP,
// Brother, Haas, GSK. The words beside such a G word tell it from FANUC's. Private to src/interp.
#pragma once

#include "interp/frames/frame_words.h"

#include <optional>

namespace mrsim {

class MakerWords : public ControlPart {
 public:
  MakerWords(Control& control, FrameWords& frames) : ControlPart(control), frame_words_(frames) {}

  /// Reads the word. Nothing: it is no word of a maker. False: an error was reported.
  std::optional<bool> read(const Word& word, Code code);

 private:
  std::optional<bool> refuse(const Word& word);
  bool okuma_offset(const Word& word);
  bool okuma_level();
  bool okuma_home(const Word& word);
  bool okuma_macro(const Word& word);
  std::optional<bool> okuma_lap(const Word& word);
  void warn_of_mixed(const Word& word);
  std::optional<bool> okuma_frame(const Word& word);
  bool brother_change(const Word& word);
  bool haas_mirror(const Word& word);
  bool names_zero_places() const;
  bool is_cycle_of_system_c(const Word& word) const;
  bool is_pocket_of_gsk(const Word& word) const;
  bool refuse_pocket(const Word& word);
  bool has_m6() const;
  bool has_length_word() const;
  bool stands_for_level(const Word& word) const;

  FrameWords& frame_words_;
};

}  // namespace mrsim
