// The way out for finished moves: tool length, corner rounding, radius compensation, sink.
// Private to src/interp.
#pragma once

#include "interp/control/compensation_words.h"
#include "interp/motion_sink.h"
#include "interp/path/compensation.h"

namespace mrsim {

class MotionEmitter : public ControlPart {
 public:
  MotionEmitter(Control& control, CompensationWords& compensation, MotionSink& sink);

  /// Gives a move on, with the corner words of its block.
  void emit(const Motion& motion);
  void emit(Motion motion, const CornerSpec& corner);
  /// RND CHF CHR of the block, else RNDM.
  CornerSpec corner_spec();
  /// What is held back goes out: the program ends.
  void flush();
  /// Lines and arcs given on.
  std::size_t cuts() const { return cuts_; }

 private:
  CompensationWords& words_;
  MotionSink& sink_;
  CornerStage corners_;
  CompensationStage compensation_;
  bool idle_ = true;
  double last_length_ = 0;
  std::size_t cuts_ = 0;
};

}  // namespace mrsim
