// G70 to G73 of FANUC lathes: the contour is the blocks N(P) to N(Q), of Okuma's LAP those of a
// name. They are read like any others with their motions kept; then the passes follow from them.
// G70 runs the blocks as they stand. Private to src/interp.
#pragma once

#include "interp/moves/moves.h"
#include "interp/path/rough_contour.h"
#include "interp/statements/lap_contour.h"
#include "interp/statements/statements.h"

#include <optional>
#include <string_view>
#include <vector>

namespace mrsim {

class ContourCycles : public ControlPart {
 public:
  ContourCycles(Control& control, BlockReader& reader, Statements* statements, Moves& moves,
                MotionEmitter& out)
      : ControlPart(control), reader_(reader), statements_(statements), moves_(moves), out_(out) {}

  /// The words of G70 to G73. False: an error was reported.
  bool run();
  /// Goes on with the contour, after the block is done.
  void end_block();
  /// The program ends.
  void end_program();

 private:
  /// A cycle whose contour is read next.
  struct Call {
    int number = 0;
    Word where, first, last;
    std::optional<Word> program;    ///< A of Mitsubishi: the program that holds the contour
    std::optional<LapContour> lap;  ///< of Okuma
    Vec3 allowance;                 ///< mm, X as radius
  };
  /// A roughing cycle as levels in u, cuts in v; see RoughContour.
  struct Rough {
    int u = 0, v = 2;           ///< axes
    double top = 0, start = 0;  ///< where the passes begin, u and v
    double down = 1;            ///< from the start to the contour, in u
    double along = -1;          ///< from the start to the contour's end, in v
  };

  bool settings();
  bool find_contour(CallRequest& request);
  void prefer_contour_before(long first, long last, Place& begin, Place& end);
  bool lap();
  bool lap_depth();
  std::optional<LapContour> lap_contour(std::string_view name, const Word& where);
  void orient_allowance();
  void pass_over_lap();
  bool read_repeats(const Word& word);
  bool old_words(bool given);
  bool counts_thousandths(std::string_view letters, double least);
  double cycle_unit(const Word& word) const;
  void finish();
  void begin_contour();
  void end_contour();
  void leave_out_return();
  bool rough();
  bool levels(const Rough& rough, const RoughContour& shape);
  void pass(const Rough& rough, double at, double end);
  void pocket_pass(const Rough& rough, double at, const FreeStretch& stretch);
  void cut(const Rough& rough, double at, double begin, double end);
  bool repeat_pattern();
  void go(const Vec3& to, MotionKind kind);

  BlockReader& reader_;
  Statements* statements_;
  Moves& moves_;
  MotionEmitter& out_;
  Call call_;
  Vec3 semi_finish_;    ///< I and K: what the passes leave for the cut along the contour, mm
  bool waits_ = false;  ///< the contour of call_ comes next
  std::vector<Motion> contour_;
  Modal modal_before_;
  Position position_before_;
  BlockPlace place_;  ///< of the cycle's block
  std::size_t errors_before_ = 0;
};

}  // namespace mrsim
