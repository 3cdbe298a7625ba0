// G150 of Haas mills: a pocket of any contour. The contour stands in the program P, behind one move
// that leads to it from the start hole X Y. Private to src/interp.
#pragma once

#include "interp/milling/region_cutter.h"
#include "interp/statements/statements.h"

#include <vector>

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
        out_(out) {}

  bool wants_block() const;
  /// The words of G150. False: an error was reported.
  bool run();
  /// Goes on with the contour, after the block is done.
  void end_block();
  /// The program ends.
  void end_program();

 private:
  bool read_words();
  bool find_contour();
  void begin_contour();
  void end_contour();
  bool pocket();

  BlockReader& reader_;
  Statements* statements_;  ///< null: a control without a language
  AxisWords& axes_;
  CompensationWords& compensation_;
  CycleMover mover_;
  RegionCutter cutter_;
  MotionEmitter& out_;
  Word where_, program_;
  RegionCutter::Levels levels_;
  double radius_ = 0, step_ = 0, finish_ = 0;  ///< mm
  bool left_ = true;                           ///< G41
  CallRequest request_;
  bool waits_ = false;  ///< the contour comes next
  BlockPlace place_;    ///< of the cycle's block
  std::vector<Motion> contour_;
  Modal modal_before_;
  Position position_before_;
  std::size_t errors_before_ = 0;
};

}  // namespace mrsim
