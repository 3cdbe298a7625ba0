// SINUMERIK's cycles by name: reads the list of values, also that of 802S and 802C (LCYC82 and its
// kin), and hands it to the cycle. Patterns of holes and MCALL run a drilling cycle at every place;
// MCALL also runs a milling cycle. CYCLE800 shifts and turns the frame. Private to src/interp.
#pragma once

#include "interp/cycles/hole_maker.h"
#include "interp/frames/frame_words.h"
#include "interp/milling/mill_cycles.h"
#include "interp/sinumerik/sinumerik_contours.h"
#include "interp/sinumerik/sinumerik_engraving.h"
#include "interp/statements/statements.h"
#include "interp/turning/turn_cycles.h"

#include <optional>
#include <vector>

namespace mrsim {

class SinumerikCycles : public ControlPart {
 public:
  SinumerikCycles(Control& control, BlockReader& reader, Statements* statements, HoleMaker& holes,
                  FrameWords& frames, ToolChanger& tools, Moves& moves, MotionEmitter& out)
      : ControlPart(control),
        reader_(reader),
        statements_(statements),
        tools_(tools),
        holes_(holes),
        frame_words_(frames),
        mills_(control, tools, moves),
        contours_(control, reader, statements, tools, moves, out),
        turns_(control, tools, moves),
        engraving_(control, moves) {}

  /// Whether run() knows the name.
  static bool knows(std::string_view name);
  /// Carries out the call of the block. False: an error was reported.
  bool run();
  /// Carries out MCALL, with a cycle or without. False: an error was reported.
  bool modal_call();
  /// Runs the cycle of MCALL at the end of a move in the plane. False: an error was reported.
  bool run_modal(const Vec3& from);
  /// Called after a block and at the end of the program, for contours of cycles.
  void end_block() { contours_.end_block(); }
  void end_program() { contours_.end_program(); }

 private:
  using Call = CycleCall;

  bool measure();
  bool read_call(Call& call);
  bool pattern_802(const Call& places);
  bool pattern(const Call& call);
  bool swivel(const Call& call);
  void go_to(const Vec2& place, const Word& at);
  bool at_points(const std::vector<Vec2>& points);
  bool call_at(const std::vector<Vec2>& points);
  bool drill(const Call& call);
  bool mill(const Call& call);
  bool run_mill(const Call& call, bool at_position);
  void tell_unread(const Call& call);
  Word where() const;

  BlockReader& reader_;
  Statements* statements_;
  ToolChanger& tools_;
  HoleMaker& holes_;
  FrameWords& frame_words_;
  MillCycles mills_;
  SinumerikContours contours_;
  TurnCycles turns_;
  SinumerikEngraving engraving_;
  std::optional<Call> modal_call_;
};

}  // namespace mrsim
