// The words of a thread's block: the lead of G33 G34 G35 and of taps, and words that only say where
// the spindle stands. Private to src/interp.
#pragma once

#include "interp/frames/axis_words.h"

namespace mrsim {

class ThreadWords : public ControlPart {
 public:
  explicit ThreadWords(Control& control) : ControlPart(control) {}

  /// The lead that the move from `from` to `to` has becomes the one in force, in mm a revolution: F
  /// of FANUC, on SINUMERIK K along Z and I along X. The sign of a tap's lead is the hand of its
  /// thread; the hand of a cut thread follows from the spindle and the direction, so that its lead
  /// is above 0. False: an error was reported.
  bool take_lead(const Target& to, const Vec3& from);

 private:
  void read_lead_along(const Vec3& way);
  void read_lead_of_feed();
};

}  // namespace mrsim
