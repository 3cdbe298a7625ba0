// SINUMERIK cycles along contours of the program: CYCLE62 names them, CYCLE63, CYCLE72, CYCLE95 and
// CYCLE952 cut along them. This class finds the blocks of the contours, which are run as usual
// while their motions are kept; then it hands the contours to the cycle. Private to src/interp.
#pragma once

#include "interp/cycles/captured_contour.h"
#include "interp/cycles/cycle_call.h"
#include "interp/moves/moves.h"
#include "interp/statements/statements.h"
#include "interp/tools/tool_changer.h"

#include <vector>

namespace mrsim {

class SinumerikContours : public ControlPart {
 public:
  SinumerikContours(Control& control, BlockReader& reader, Statements* statements,
                    ToolChanger& tools, Moves& moves, MotionEmitter& out)
      : ControlPart(control),
        reader_(reader),
        statements_(statements),
        tools_(tools),
        moves_(moves),
        contour_(control, out) {}

  /// Whether run() knows the cycle of this name.
  static bool knows(std::string_view name);
  /// Reads the call. False: an error was reported.
  bool run(const CycleCall& call, const Word& where);
  /// Whether the blocks being read are the contour of a cycle.
  bool reads_contour() const { return contour_.is_read(); }
  /// Called after the block: goes on with the contour of a cycle.
  void end_block();
  /// Called at the end of the program, which may lie inside a contour.
  void end_program();

 private:
  bool name_contour();
  bool find_contours();
  bool find_contour(const std::string& name, CallRequest& request);
  void enter_contour();
  void begin_contour();
  void end_contour();
  void finish_contours();

  BlockReader& reader_;
  Statements* statements_;
  ToolChanger& tools_;
  Moves& moves_;
  CycleCall call_;
  Word where_;
  std::vector<std::string> named_;  ///< the contours that the last calls of CYCLE62 name
  bool named_used_ = false;  ///< a cycle has used them, so the next CYCLE62 begins a new list
  std::vector<CallRequest> requests_;
  bool waits_ = false;                         ///< the contours of call_ come next
  CapturedContour contour_;                    ///< the contour being read
  std::vector<std::vector<Motion>> contours_;  ///< the contours read so far
};

}  // namespace mrsim
