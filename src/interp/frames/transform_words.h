// Frames that G words turn, scale, mirror and shift: those of FANUC, Okuma, Mach and Fagor, and of
// CYCLE800 without a tilt. Private to src/interp.
#pragma once

#include "interp/frames/frame_chain.h"

namespace mrsim {

class TransformWords : public FrameChain {
 public:
  explicit TransformWords(Control& control) : FrameChain(control) {}

  /// The block's frame word on a control of FANUC's kind: G68 R, G51 P or I J K, G51.1, G52, G11
  /// P. False: an error was reported.
  bool run(const Word& word);
  /// G69 and G50 of the block, which leave its axes to other words.
  void end();
  /// Fagor's mirror images (G11 to G13 about the zero, one beside the other; G10 ends them), scale
  /// (G72 S) and rotation (G73). False: an error was reported.
  bool fagor(Code code, const Word& word);
  /// CYCLE800 without a tilt. `adds`: `frame` acts within the one in force; else it replaces that
  /// frame and deletes the one of TRANS, ROT, SCALE and MIRROR.
  void swivel(const Frame& frame, bool adds, const Word& word);
  /// A figure lies turned about `center` in the plane and shifted, inside of the rotation `base`.
  void place_figure(const Frame& base, double angle, const Vec3& center, const Vec3& shift);

 private:
  Frame turned(double angle, int axis, const Vec3& center) const;
  bool scale_axes(const Word& word, const Vec3& center);
  bool names_factors() const;
  bool scale_as_mach(const Word& word, Vec3 factors, AxisSet named);
  bool untilted_plane(Vec3 zero, AxisSet named, const Word& word);
  void shift_locally(const Vec3& values, AxisSet named, const Word& word);
  bool turn_locally(Vec3 zero, AxisSet named, const Word& word);
  void turn_about(double angle, int axis, const Vec3& center, bool adds, const Word& word);
  bool turns_in_space();
  bool turn_in_plane(Vec3 center, const Word& word);
  bool center_of_mach(Vec3& center, const Word& word);
  bool fagor_turn(const Word& word);
  void set_mirror();
};

}  // namespace mrsim
