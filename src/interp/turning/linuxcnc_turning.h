// G70, G71, G71.1, G71.2, G72, G72.1, G72.2 of LinuxCNC: the contour is a subprogram, O<Q> sub. Its
// blocks are not run; their lines and arcs are kept, and path/turn_profile makes the passes from
// them. Private to src/interp.
#pragma once

#include "interp/cycles/cycle_mover.h"
#include "interp/path/turn_profile.h"
#include "interp/statements/statements.h"

#include <vector>

namespace mrsim {

class LinuxCncTurning : public ControlPart {
 public:
  LinuxCncTurning(Control& control, BlockReader& reader, Statements* statements, AxisWords& axes,
                  Moves& moves)
      : ControlPart(control),
        reader_(reader),
        statements_(statements),
        axes_(axes),
        moves_(moves),
        mover_(control, moves),
        arcs_(control, axes) {}

  /// Reads the words of the cycle. False: an error was reported.
  bool run();
  /// Called after the block: goes on with the contour of a cycle.
  void end_block();
  /// Whether the blocks being read are the contour.
  bool reads_contour() const { return reading_; }
  /// Makes U and W of a block of the contour X and Z, before its words are looked up. False: an
  /// error was reported.
  bool rewrite_increments() { return increment('U', 'X') && increment('W', 'Z'); }
  /// Adds the block to the contour as a piece.
  void contour_block();
  /// Called at the end of the program, which may lie inside a contour.
  void end_program();

 private:
  bool own_words();
  bool go_to_start();
  bool contour_words(const Word*& axis_word);
  bool increment(char letter, char axis);
  bool move_to(const Word& where);
  Vec2 centre(Vec2 otherwise) const;
  bool add_corner();
  void end_contour();
  void cut();
  void run_move(const ProfileMove& move);

  BlockReader& reader_;
  Statements* statements_;
  AxisWords& axes_;
  Moves& moves_;
  CycleMover mover_;
  ArcSolver arcs_;

  Word where_;
  int number_ = 0;    ///< 70 to 72
  long contour_ = 0;  ///< Q
  Roughing rough_;
  Finishing finish_;
  bool waits_ = false, reading_ = false;
  std::vector<ProfilePiece> pieces_;
  std::vector<Motion> sources_;  ///< where the pieces stand in the text
  Vec3 at_;                      ///< end of the contour so far, in the frame in force, mm
  Modal modal_before_;
  BlockPlace place_;  ///< where the block of the cycle stands
  std::size_t errors_before_ = 0;
};

}  // namespace mrsim
