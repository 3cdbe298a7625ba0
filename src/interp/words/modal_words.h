// Modal G words: which mode each sets. Private to src/interp.
#pragma once

#include "interp/text/code_table.h"
#include "interp/tools/compensation_words.h"
#include "interp/words/maker_words.h"
#include "interp/words/path_modes.h"
#include "interp/words/plain_modes.h"
#include "interp/words/unread_modes.h"

#include <optional>

namespace mrsim {

class ModalWords : public ControlPart {
 public:
  ModalWords(Control& control, FrameWords& frames, CompensationWords& compensation)
      : ControlPart(control),
        codes_(code_table(control.dialect, control.program.machine)),
        frame_words_(frames),
        compensation_(compensation),
        makers_(control, frames),
        path_modes_(control),
        plain_(control),
        unread_(control) {}

  /// Applies all function words of the block, in order. False: errors were reported.
  bool apply();

 private:
  CodeEntry lookup(const Word& word) const;
  bool claim_group(const Word& word, const CodeEntry& entry);
  bool pause(const Word& word);
  bool apply_code(const Word& word, const CodeEntry& entry);
  std::optional<bool> apply_cycle(const Word& word, const CodeEntry& entry);
  bool units_of_mach(const Word& word);
  bool set_units(const Word& word);
  bool refuse(const Word& word);
  bool for_oneshot(const Word& word, Code code);
  bool for_one_block(const Word& word, Code code);
  bool for_frame(const Word& word, Code code);
  bool refuse_unknown(const Word& word);
  bool hole_pattern(const Word& word, Code code);
  bool ignore_words(const Word& word);
  bool select_motion(const Word& word, Code code);
  bool end_cycle(const Word& word, Code code);
  void select_cycle(const Word& word, int number);
  bool select_turning(const Word& word, int number);
  void keep_turning_end(const Word& word, int number);
  bool apply_modal_code(const Word& word, const CodeEntry& entry);
  bool select_distance(Code code, const Word& word);
  bool select_plane(int plane, const Word& word);
  bool select_normal(const Word& word);

  const CodeTable& codes_;
  FrameWords& frame_words_;
  CompensationWords& compensation_;
  MakerWords makers_;
  PathModes path_modes_;
  PlainModes plain_;
  UnreadModes unread_;
};

}  // namespace mrsim
