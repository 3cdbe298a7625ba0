// Frames: work offsets, TRANS and its kin, FANUC's rotations, scalings and mirrors, poles. Keeps
// Frames::total up to date and the programmed position in the frame in force.
// Private to src/interp.
#pragma once

#include "interp/control/control.h"

namespace mrsim {

class FrameWords : public ControlPart {
 public:
  explicit FrameWords(Control& control) : ControlPart(control) {}

  /// What is in force before the first block.
  void start();
  /// The frame word of the block. False: an error was reported.
  bool run();
  /// G54 and its kin.
  bool select_work(const CodeEntry& entry, const Word& word);
  /// E1 beside the words of a place. False: an error was reported.
  bool select_fixture();
  /// G15 H of Okuma.
  bool select_numbered(const Word& h);
  /// Mirror images, scale and rotation of Fagor. False: an error was reported.
  bool fagor(Code code, const Word& word);
  /// CYCLE800 without a tilt: a new frame, or one more in the one in force.
  void swivel(const Frame& frame, bool adds, const Word& word);
  /// The work offset in force may have new values.
  void renew_work();
  /// The frame of this block's points.
  Frame now() const { return block_.suppress_frames ? Frame{} : frames_.total; }

  /// Before a change of frames_, so that a rejected block can be undone ...
  void save();
  /// ... and after it.
  void rebuild();

 private:
  bool in_range();
  void arguments(Vec3& values, unsigned& named, bool lengths);
  void rotation_arguments(Frame& frame);
  bool sinumerik();
  void trans_part(const Vec3& values, unsigned named);
  bool sinumerik_step(const Vec3& values, unsigned named);
  bool fanuc(const Word& word);
  bool fanuc_scaling(const Word& word, const Vec3& center);
  bool untilted_plane(Vec3 zero, unsigned named, const Word& word);
  void shift_locally(const Vec3& values, unsigned named, const Word& word);
  void turn_about(double angle, int axis, const Vec3& center, bool adds, const Word& word);
  bool turns_in_space();
  bool center_of_mach(Vec3& center, const Word& word);
  bool extends_work() const;
  const Word* offset_number();
  void set_mirror();
  bool turn_locally(Vec3 zero, unsigned named, const Word& word);
  bool codesys();
  bool pole();
  bool set_work(const std::string& written);
  bool use_work(const std::string& name, const Word& word);
  bool fagor_turn(const Word& word);
};

}  // namespace mrsim
