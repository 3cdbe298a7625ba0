// SINUMERIK's drilling cycles CYCLE81 to CYCLE89 and CYCLE840, the patterns HOLES1, HOLES2,
// CYCLE801 and CYCLE802, those of 802S and 802C (LCYC82 and its kin), and MCALL, which runs a
// cycle, also one of milling, behind every move in the plane. Private to src/interp.
#pragma once

#include "interp/milling/mill_cycles.h"
#include "interp/sinumerik/sinumerik_contours.h"
#include "interp/sinumerik/sinumerik_engraving.h"
#include "interp/statements/statements.h"
#include "interp/turning/turn_cycles.h"
#include "interp/words/dwell_time.h"

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
        dwell_(control),
        mills_(control, tools, moves),
        contours_(control, reader, statements, tools, moves, out),
        turns_(control, tools, moves),
        engraving_(control, moves) {}

  /// A name that run() knows.
  static bool knows(std::string_view name);
  /// The call of the block. False: an error was reported.
  bool run();
  /// MCALL, with a cycle or without. False: an error was reported.
  bool modal_call();
  /// The cycle of MCALL at the end of a move in the plane.
  bool run_modal(const Vec3& from);
  /// After a block, and at the end of the program: contours of cycles.
  void end_block() { contours_.end_block(); }
  void end_program() { contours_.end_program(); }

 private:
  using Call = CycleCall;

  bool measure();
  bool read_call(Call& call);
  static bool is_of_802(std::string_view name);
  bool read_802(std::string_view name, Call& call);
  bool pattern_802(const Call& places);
  bool hole(const Call& call, Hole& out);
  bool depth(const Call& call, std::size_t mode, double reference, double down, double& bottom);
  bool to_diameter(const Call& call, double reference, double down, double& bottom);
  double point_length();
  bool strokes(const Call& call, double reference, Hole& hole);
  double pause(const Call& call, std::size_t value, int mode_digit);
  void dwells(const Call& call, Hole& hole);
  void tapping(const Call& call, Hole& hole);
  bool pattern(const Call& call);
  bool reads_all_of(const Call& pattern);
  bool swivel(const Call& call);
  bool row(const Call& call);
  bool circle(const Call& call);
  bool grid(const Call& call);
  bool points(const Call& call);
  bool at_points(const std::vector<Vec2>& points);
  bool drill(const Call& call);
  bool choose_plane(const Call& call);
  bool mill(const Call& call);
  Word where() const;

  BlockReader& reader_;
  Statements* statements_;
  ToolChanger& tools_;
  HoleMaker& holes_;
  FrameWords& frame_words_;
  DwellTime dwell_;
  MillCycles mills_;
  SinumerikContours contours_;
  TurnCycles turns_;
  SinumerikEngraving engraving_;
  std::optional<Call> modal_call_;
};

}  // namespace mrsim
