// Where a block goes: axis words, diameters, increments, polar coordinates, angles. The only state
// that it changes is the last polar values; Moves goes there. Private to src/interp.
#pragma once

#include "interp/control/control.h"

namespace mrsim {

/// Where a move goes, in the frame in force.
struct Target {
  Vec3 programmed;
  AxisSet named;     ///< the axes with a word
  AxisSet absolute;  ///< the named axes whose value is absolute
  const Word* first = nullptr;
};

/// Whether the block names an axis that has a share of `direction`.
bool named_along(const Target& target, const Vec3& direction);

class AxisWords : public ControlPart {
 public:
  explicit AxisWords(Control& control) : ControlPart(control) {}

  /// The target of the block's axis words, from `from` on. False: an error was reported.
  bool target(Target& out, const Vec3& from);
  /// ANG= with one coordinate: completes `out` by the other.
  bool angle_target(Target& out, const Vec3& from);
  /// The word that makes the block a move to `to`.
  const Word* motion_word(const Target& to) const;
  /// Whether words are left that make the block a move.
  bool has_move() const;

 private:
  bool axis_word(Target& out, int axis, const Word& word, bool incremental_word);
  void warn_of_increments(const Word& word);
  void tell_of_point(const Word& word);
  void tell_of_radius(int axis, const Word& word);
  bool polar_target(Target& out);
  bool ngc_polar_target(Target& out, const Vec3& from);
  bool fanuc_polar_target(Target& out, const Vec3& from);
  void tell_of_polar_word(const Word& where, const char* left_out, Vec2 at);
  double last_polar_angle(const Basis& b) const;
  double last_polar_radius(const Basis& b) const;
};

}  // namespace mrsim
