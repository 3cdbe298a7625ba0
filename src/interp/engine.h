// The interpreter itself: one Engine reads one program, block after block. It owns the parts and
// decides in which order they see a block; the parts know what words mean. Private to src/interp.
#pragma once

#include "interp/drilling/drill_words.h"
#include "interp/drilling/haas_cycles.h"
#include "interp/milling/engraving.h"
#include "interp/milling/fagor_pockets.h"
#include "interp/milling/haas_pocket.h"
#include "interp/sinumerik/sinumerik_cycles.h"
#include "interp/statements/figure_copy.h"
#include "interp/statements/program_flow.h"
#include "interp/turning/contour_cycles.h"
#include "interp/turning/linuxcnc_turning.h"
#include "interp/turning/turn_words.h"
#include "interp/words/event_words.h"
#include "interp/words/iso_words.h"
#include "interp/words/modal_words.h"
#include "interp/words/oneshot_words.h"
#include "interp/words/operator_stops.h"
#include "interp/words/value_words.h"
#include "interp/words/word_index.h"
#include "interp/words/workpiece.h"

namespace mrsim {

class Engine {
 public:
  /// The first `leader_lines` lines of the file lie before the tape mark and are not read.
  /// `okuma`: the words are those of OSP.
  Engine(const InterpOptions& options, Program& program, int leader_lines, bool okuma,
         MotionSink& sink);
  void run();

 private:
  void execute();
  void tell_of_missing_end();
  void tell_unused_options();
  bool interpret_or_restore();
  bool interpret_block();
  void end_block();
  bool run_move();
  bool run_turning();
  bool ends_data();

  const InterpOptions& options_;
  Reporter reporter_;
  Control control_;
  BlockReader reader_;
  std::unique_ptr<Statements> statements_;  ///< null: the control has no language here
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
  EventWords events_;
  OneShotWords oneshots_;
  HoleMaker holes_;
  DrillWords drilling_;
  HaasCycles haas_;
  FagorPockets pockets_;
  HaasPocket haas_pocket_;
  FigureCopy figures_;
  Engraving engraving_;
  SinumerikCycles cycles_;
  TurnWords turning_;
  ContourCycles contours_;
  LinuxCncTurning profiles_;
  CommentedStock stock_;
  OperatorStops operator_;
  BlockPlace last_block_;  ///< the last one with words
  std::size_t executed_ = 0;
  unsigned skip_levels_ = 0;  ///< of blocks that were read, a bit each
  bool moved_ = false;        ///< the block had a motion
};

}  // namespace mrsim
