// Radius compensation as a stage between the programmed contour and the sink.
#pragma once

#include "interp/path/moves_ahead.h"

namespace mrsim {

/// Offsets the contour by the tool radius (G40 G41 G42).
class CompensationStage {
 public:
  CompensationStage(Reporter& reporter, NextStage next)
      : reporter_(reporter), next_(std::move(next)), ahead_(reporter) {}
  /// Takes the next move; finished ones go to the next stage.
  void push(const PathMove& move);
  /// Runs all moves that are held back: none follows.
  void flush();
  bool idle() const { return ahead_.empty() && !active_; }

 private:
  void same_axes(PathMove& move) const;
  void settle(bool last);
  void enter();
  void enter_beside(double height);
  void follow();
  void leave_void(const PathMove& first, double height);
  void leave_or_shift();
  CornerWay choose_end(const PlanePiece& piece);
  void step_onto(const PathMove& first, const PlanePiece& arc);
  void corner_too_tight(const Motion& next);
  bool crosses_over(const PlanePiece& piece, CornerWay& way);
  CornerWay leaving(const PlanePiece& piece) const;
  void run_infeeds();
  void run_piece(const PathMove& first, PlanePiece piece, Vec2 end, double height);
  void run_corner(const PathMove& before, const CornerWay& way);
  void send(PathMove move, const PlanePiece& piece, double end_height);
  void send_line(const PathMove& like, Vec2 to, double end_height);

  Reporter& reporter_;
  NextStage next_;
  MovesAhead ahead_;  ///< the moves not run yet; the first is run next
  Basis basis_;       ///< the axes of the contour being run
  bool active_ = false;
  bool resumes_ = false;  ///< the last move ran with CUTCONON, or on the other side
  Vec3 at_;               ///< where the last emitted motion ended
  Vec2 cursor_;           ///< the tool's centre at that place, in the plane
};

}  // namespace mrsim
