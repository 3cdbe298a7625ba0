// Emits what a block does beside moving as events: spindle, coolant, stops, path mode, tool
// changes. Dwells come from the words and cycles that make them. Events of a spindle with a number
// (M2=3 of SINUMERIK, $1 of LinuxCNC) are left out, because it is not the spindle of the tool.
// Private to src/interp.
#pragma once

#include "interp/moves/motion_emitter.h"
#include "interp/text/m_codes.h"

#include <vector>

namespace mrsim {

class EventWords : public ControlPart {
 public:
  EventWords(Control& control, MotionEmitter& out) : ControlPart(control), out_(out) {}

  /// Emits the events that take effect with the block's motion.
  void before_motion();
  /// Emits the events that follow the motion. A cycle may have read other blocks by then.
  void after_motion();

 private:
  void read_words();
  bool is_late(MCode code) const;
  void tell(MCode code);
  void spindle(SpindleTurn turn);
  void coolant(Coolant coolant);
  void stop(StopKind stop);
  void path_mode(PathMode mode);
  double speed() const { return modal_.surface_speed ? modal_.cutting_speed : modal_.speed; }

  MotionEmitter& out_;
  std::vector<MCode> late_;  ///< M words that wait for the block's motion
  bool stops_once_ = false;  ///< a G9 also waits for the motion
  SpindleTurn turn_ = SpindleTurn::off;
  double told_speed_ = 0;
  bool told_surface_ = false;
};

}  // namespace mrsim
