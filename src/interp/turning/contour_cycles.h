// G70 to G73 of FANUC lathes, whose contour is the blocks N(P) to N(Q), and Okuma's LAP, whose
// contour is the blocks of a name. These blocks are run as usual, but their motions are kept;
// ContourPasses makes the passes from them. G70 runs the blocks as they stand. Private to
// src/interp.
#pragma once

#include "interp/cycles/captured_contour.h"
#include "interp/statements/blocks_between.h"
#include "interp/statements/lap_contour.h"
#include "interp/statements/statements.h"
#include "interp/turning/contour_passes.h"

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace mrsim {

class ContourCycles : public ControlPart {
 public:
  ContourCycles(Control& control, BlockReader& reader, Statements* statements, Moves& moves,
                MotionEmitter& out)
      : ControlPart(control),
        reader_(reader),
        statements_(statements),
        moves_(moves),
        contour_(control, out) {}

  /// Reads the words of G70 to G73, G85 or G87. False: an error was reported.
  bool run();
  /// Called after the block: goes on with the contour of a cycle.
  void end_block();
  /// Called at the end of the program, which may lie inside a contour.
  void end_program();

 private:
  /// A cycle whose contour is read next.
  struct Call {
    ContourCut cut;
    Word first, last;
    std::optional<Word> program;    ///< A of Mitsubishi: the program that holds the contour
    std::optional<LapContour> lap;  ///< the contour of Okuma's cycle
  };

  bool settings();
  bool find_contour(CallRequest& request);
  void prefer_contour_before(long first, long last, Place& begin, Place& end);
  void warn_of_blocks_before(const Place& contour);
  bool lap();
  bool lap_depth();
  std::optional<LapContour> lap_contour(std::string_view name, const Word& where);
  void pass_over_lap();
  bool read_repeats(const Word& word);
  bool old_words(bool given, Vec3& semi_finish);
  bool counts_thousandths(std::string_view letters, double least);
  double cycle_unit(const Word& word);
  void finish();
  void read_first_block();
  void begin_contour();
  void end_contour();

  BlockReader& reader_;
  Statements* statements_;
  Moves& moves_;
  CapturedContour contour_;
  Call call_;
  bool waits_ = false;        ///< the contour of call_ comes next
  bool first_block_ = false;  ///< the block of the contour that leads to it comes next
  std::set<std::pair<std::string, std::uint64_t>> looked_between_;  ///< files and lines of cycles
};

}  // namespace mrsim
