// Radius compensation as a stage between the programmed contour and the sink.
#pragma once

#include "interp/path/outside_corner.h"

namespace mrsim {

/// Offsets the contour by the tool radius (G40 G41 G42).
class CompensationStage {
 public:
  CompensationStage(Reporter& reporter, NextStage next)
      : reporter_(reporter), next_(std::move(next)) {}
  void push(const PathMove& move);
  void flush();
  bool idle() const { return queue_.empty() && !active_; }

 private:
  static constexpr std::size_t kLookAhead = 5;  ///< compensated moves seen at once

  void same_axes(PathMove& move) const;
  std::size_t following(std::size_t n) const;
  bool ready(bool last) const;
  void settle(bool last);
  void enter();
  void enter_beside(double height);
  void skip_void_entry();
  void follow();
  void leave_void(const PathMove& first, double height);
  void leave_or_shift();
  bool squeezed(std::size_t i, std::size_t next, Vec2 entered) const;
  bool meets(const PlanePiece& piece, Vec2 from, std::size_t n, CornerWay& way,
             std::size_t& keep) const;
  bool meet_inside(const PlanePiece& piece, std::size_t nearest, CornerWay& way);
  void close_over(const PlanePiece& piece, CornerWay& way);
  void skip_before(std::size_t keep);
  CornerWay choose_end(const PlanePiece& piece);
  CornerWay step_to(const PlanePiece& piece, const PathMove& after);
  void step_onto(const PathMove& first, const PlanePiece& arc);
  void check_room(const PlanePiece& piece, Vec2 end, const Motion& next);
  void corner_too_tight(const Motion& next);
  bool crosses_over(const PlanePiece& piece, CornerWay& way);
  CornerWay leaving(const PlanePiece& piece) const;
  PlanePiece reach(std::size_t i, std::size_t next) const;
  void run_infeeds();
  void run_piece(const PathMove& first, PlanePiece piece, Vec2 end, double height);
  void run_corner(const PathMove& before, const CornerWay& way);
  void send(PathMove move, const PlanePiece& piece, double end_height);
  void send_line(const PathMove& like, Vec2 to, double end_height);

  Reporter& reporter_;
  NextStage next_;
  std::vector<PathMove> queue_;
  Basis basis_;  ///< of the contour under way
  bool active_ = false;
  bool resumes_ = false;  ///< the last one ran suspended (CUTCONON), or on the other side
  Vec3 at_;               ///< where the last motion given on ended
  Vec2 cursor_;           ///< the same in the plane, as tool centre
};

}  // namespace mrsim
