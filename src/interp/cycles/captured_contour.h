// The contour of a cycle: blocks that are run as usual while their motions are kept for the cycle,
// which finds everything as it was before them. Private to src/interp.
#pragma once

#include "interp/moves/motion_emitter.h"

#include <cstddef>
#include <vector>

namespace mrsim {

class CapturedContour : public ControlPart {
 public:
  CapturedContour(Control& control, MotionEmitter& out) : ControlPart(control), out_(out) {}

  /// Remembers what end() gives back; `cycle`: where the block of the cycle stands.
  void keep_state(const BlockPlace& cycle);
  /// From here on the motions are kept.
  void begin();
  /// Behind the contour: modes, position and the block of the cycle are as they were. False: an
  /// error was reported in between.
  bool end();
  /// Whether there are at least two motions, and not too many, which is reported at `cycle`.
  bool has_usual_size(const Word& cycle);
  /// At the end of the program. Inside the contour that is an error; `name` is that of the cycle.
  void end_program(const Word& cycle, const char* name = "this cycle");

  bool is_read() const { return out_.captures(); }
  /// They belong to the cycle, which may change them.
  std::vector<Motion>& motions() { return motions_; }
  const Position& position_before() const { return position_before_; }

 private:
  MotionEmitter& out_;
  std::vector<Motion> motions_;
  BlockPlace place_;
  Modal modal_before_;
  Position position_before_;
  std::size_t errors_before_ = 0;
};

}  // namespace mrsim
