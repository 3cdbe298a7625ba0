// The frames in force as one: work offset, shifts, the program's frame, rotation, scaling, mirror.
// Code that changes one of them calls save() before and rebuild() after. Private to src/interp.
#pragma once

#include "interp/control/control.h"

namespace mrsim {

class FrameChain : public ControlPart {
 public:
  explicit FrameChain(Control& control) : ControlPart(control) {}

  /// Keeps a copy of the frames, so that a rejected block can be undone.
  void save();
  /// Composes Frames::total anew, and gives the programmed position in it.
  void rebuild();
  /// The frame of this block's points.
  Frame now() const { return block_.suppress_frames ? Frame{} : frames_.total; }

 protected:
  /// Takes X Y Z of a frame word: their values, and the axes that have one in `named`. Lengths
  /// are converted to mm; factors and angles are not.
  void arguments(Vec3& values, AxisSet& named, bool lengths);
};

}  // namespace mrsim
