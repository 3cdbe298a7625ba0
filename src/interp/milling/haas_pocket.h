// G150 of Haas mills: a pocket of any contour. The contour stands in the program P, behind a move
// that leads to it from the start hole X Y. Private to src/interp.
#pragma once

#include "interp/cycles/captured_contour.h"
#include "interp/milling/region_cutter.h"
#include "interp/statements/statements.h"

namespace mrsim {

class HaasPocket : public ControlPart {
 public:
  HaasPocket(Control& control, BlockReader& reader, Statements* statements, AxisWords& axes,
             CompensationWords& compensation, Moves& moves, MotionEmitter& out)
      : ControlPart(control),
        reader_(reader),
        statements_(statements),
        axes_(axes),
        compensation_(compensation),
        mover_(control, moves),
        cutter_(control, moves),
        contour_(control, out) {}

  /// Whether the block has G150.
  bool wants_block() const;
  /// Reads the words of G150. False: an error was reported.
  bool run();
  /// Called after the block: goes on with the contour.
  void end_block();
  /// Called at the end of the program, which may lie inside the contour.
  void end_program();

 private:
  bool read_words();
  bool find_contour();
  void end_contour();
  bool pocket();

  BlockReader& reader_;
  Statements* statements_;  ///< null: the control has no language here
  AxisWords& axes_;
  CompensationWords& compensation_;
  CycleMover mover_;
  RegionCutter cutter_;
  CapturedContour contour_;
  Word where_, program_;
  RegionCutter::Levels levels_;
  double radius_ = 0, step_ = 0, finish_ = 0;  ///< mm
  bool left_ = true;                           ///< G41
  CallRequest request_;
  bool waits_ = false;  ///< the contour comes next
};

}  // namespace mrsim
