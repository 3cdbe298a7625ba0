// The interpreter proper: one Engine reads one program, block after block. It owns the parts and
// says in which order they see a block; what words mean is theirs. Private to src/interp.
#pragma once

#include "interp/control/contour_cycles.h"
#include "interp/control/drill_words.h"
#include "interp/control/engraving.h"
#include "interp/control/fagor_pockets.h"
#include "interp/control/haas_cycles.h"
#include "interp/control/iso_words.h"
#include "interp/control/linuxcnc_turning.h"
#include "interp/control/modal_words.h"
#include "interp/control/oneshot_words.h"
#include "interp/control/program_flow.h"
#include "interp/control/sinumerik_cycles.h"
#include "interp/control/turn_words.h"
#include "interp/control/value_words.h"
#include "interp/control/word_index.h"
#include "interp/control/workpiece.h"

namespace mrsim {

class Engine {
 public:
  /// The first `leader_lines` of the file lie before the tape mark and are not read.
  /// `okuma`: the words are those of OSP.
  Engine(const InterpOptions& options, Program& program, int leader_lines, bool okuma,
         MotionSink& sink);
  void run();

 private:
  void execute();
  bool interpret_block();
  bool run_move();
  bool run_turning();
  bool ends_data();

  const InterpOptions& options_;
  Reporter reporter_;
  Control control_;
  BlockReader reader_;
  std::unique_ptr<Statements> statements_;  ///< null: a control without a language here
  ProgramFlow flow_;
  IsoWords iso_;
  WordIndex index_;
  AxisWords axes_;
  FrameWords frames_;
  ToolChanger tools_;
  CompensationWords compensation_;
  MotionEmitter out_;
  Moves moves_;
  ModalWords modes_;
  ValueWords values_;
  OneShotWords oneshots_;
  HoleMaker holes_;
  DrillWords drilling_;
  HaasCycles haas_;
  FagorPockets pockets_;
  Engraving engraving_;
  SinumerikCycles cycles_;
  TurnWords turning_;
  ContourCycles contours_;
  LinuxCncTurning profiles_;
  CommentedStock stock_;
  std::size_t executed_ = 0;
  bool moved_ = false;  ///< the block had a motion
};

}  // namespace mrsim
