// Words that set frames: work offsets, TRANS and its kin, the decoder's frame of CODESYS, poles.
// TransformWords has those that turn, scale and mirror by G words. Private to src/interp.
#pragma once

#include "interp/frames/transform_words.h"
#include "interp/text/code_table.h"

#include <string>

namespace mrsim {

class FrameWords : public FrameChain {
 public:
  explicit FrameWords(Control& control) : FrameChain(control), transforms_(control) {}

  /// Puts the frame in force that holds before the first block.
  void start();
  /// The frame word of the block. False: an error was reported.
  bool run();
  /// G54 to G59, G54.1 P and their kin. False: an error was reported.
  bool select_work(const CodeEntry& entry, const Word& word);
  /// E1 of Fadal and Centroid, a work offset. False: an error was reported.
  bool select_fixture();
  /// G15 H of Okuma. False: an error was reported.
  bool select_numbered(const Word& h);
  /// Takes over new values of the work offset in force.
  void renew_work();
  /// The frames that G words and CYCLE800 turn, scale and mirror.
  TransformWords& transforms() { return transforms_; }

 private:
  bool in_range();
  void rotation_arguments(Frame& frame);
  bool sinumerik();
  void trans_part(const Vec3& values, AxisSet named);
  bool sinumerik_step(const Vec3& values, AxisSet named);
  bool extends_work() const;
  const Word* offset_number();
  bool codesys();
  bool pole();
  bool set_work(const std::string& written);
  bool use_work(const std::string& name, const Word& word);

  TransformWords transforms_;
};

}  // namespace mrsim
