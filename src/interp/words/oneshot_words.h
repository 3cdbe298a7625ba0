// Functions of one block: dwell, reference points, setting the position. Private to src/interp.
#pragma once

#include "interp/frames/offset_words.h"
#include "interp/moves/moves.h"
#include "interp/words/dwell_time.h"

namespace mrsim {

class OneShotWords : public ControlPart {
 public:
  OneShotWords(Control& control, AxisWords& axes, FrameWords& frames, Moves& moves)
      : ControlPart(control),
        axes_(axes),
        frame_words_(frames),
        moves_(moves),
        offsets_(control, frames),
        dwell_(control) {}
  /// Carries out the one-shot word of the block. False: an error was reported.
  bool run();
  /// Called when a tool has changed: a G50 before it may have been meant for it.
  void settle_tip();

 private:
  bool dwell();
  bool reference();
  AxisSet reference_axes(AxisSet named) const;
  AxisSet bare_axes() const;
  bool reference_sinumerik();
  bool leave_reference();
  bool rapid_to();
  void end_local(int axis);
  bool suspend_position();
  bool states_tip() const;
  void note_tip(const Word& word);
  bool set_position();
  bool position_jump();

  AxisWords& axes_;
  FrameWords& frame_words_;
  Moves& moves_;
  OffsetWords offsets_;
  DwellTime dwell_;
};

}  // namespace mrsim
