// Motions of cycles in the plane in force: places in its coordinates, heights along its normal. It
// does not know words; the motions have the place in the text of the cycle's block. Private to
// src/interp.
#pragma once

#include "interp/moves/moves.h"
#include "interp/path/clearing.h"

namespace mrsim {

class CycleMover : public ControlPart {
 public:
  CycleMover(Control& control, Moves& moves) : ControlPart(control), moves_(moves) {}

  /// Sets the word whose place in the text the motions have.
  void begin(const Word& where) { where_ = where; }
  Vec2 position() const { return in_plane(basis(), position_.programmed); }
  double height() const { return dot(position_.programmed, basis().w); }

  /// A rapid in the plane; in the functions below, `feed` 0 is the one in force.
  void rapid(Vec2 to);
  void line(Vec2 to, double feed);
  /// A rapid or line in the plane, with which radius compensation may begin or end.
  void compensated(Vec2 to, MotionKind kind);
  void rapid_height(double to);
  void line_height(double to, double feed);
  /// A line in the plane and along its normal.
  void slope(Vec2 to, double height, double feed);
  /// Runs the piece, which starts where the tool is, with a `rise` along the normal, mm.
  void piece(const PlanePiece& piece, double rise, double feed);
  void loop(const Loop& loop, double feed);

 private:
  void go(Vec2 to, double height, MotionKind kind, double feed);
  bool target(Vec2 to, Target& out) const;

  Moves& moves_;
  Word where_;
};

}  // namespace mrsim
