// G72.1 and G72.2 of FANUC mills: a subprogram that is run several times, each time turned or
// shifted further. Private to src/interp.
#pragma once

#include "interp/calls/block_reader.h"
#include "interp/frames/transform_words.h"

namespace mrsim {

class FigureCopy : public ControlPart {
 public:
  FigureCopy(Control& control, BlockReader& reader, TransformWords& transforms)
      : ControlPart(control), reader_(reader), transforms_(transforms) {}

  /// Whether the block has G72.1 or G72.2.
  bool wants_block() const;
  /// Reads the words of the block. False: an error was reported.
  bool run();
  /// Called after the block: calls the subprogram.
  void end_block();

 private:
  /// How a run lies beside the one before it.
  struct Step {
    double angle = 0;  ///< degrees, about `center`
    Vec3 center, shift;
  };

  bool read_turn();
  bool read_shift();
  bool whole(const Word* word, long least, long& out);

  BlockReader& reader_;
  TransformWords& transforms_;
  Word where_, program_;
  Step step_;
  long number_ = 0, runs_ = 1;
  bool waits_ = false;  ///< the subprogram comes next
};

}  // namespace mrsim
