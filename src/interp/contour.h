// Moves on their way from the interpreter to the sink: the programmed contour, with what corner
// rounding and radius compensation need to know about each move. Coordinates are the stock's.
#pragma once

#include "interp/frames.h"
#include "interp/reporter.h"

#include <functional>

namespace mrsim {

/// What is put between a move and the next one.
struct CornerSpec {
  enum class Kind : std::uint8_t { none, round, leg, cut };  ///< RND, CHR, CHF
  Kind kind = Kind::none;
  double size = 0;  ///< mm
  double feed = 0;  ///< of the inserted element, 0 = that of the move before
};

/// Radius compensation in force for a move.
struct Compensation {
  int side = 0;  ///< +1 left of the path (G41), -1 right (G42), 0 off
  bool suspended = false;
  double radius = 0;        ///< mm
  Vec2 tip;                 ///< lathe: from the programmed point to the nose centre, in the plane
  bool arcs = false;        ///< outside corners are arcs about the corner, else intersections
  bool two_points = false;  ///< where an intersection is too far: two points, else an arc
  double sharpest = 0;      ///< turns above this angle, radians, have no intersection
  friend bool operator==(const Compensation&, const Compensation&) = default;
};

struct PathMove {
  Motion motion;
  Basis basis;  ///< of the plane in force, orthonormal, may be left-handed under a mirror
  CornerSpec corner;
  Compensation comp;
  std::size_t block = 0;  ///< running number of its block
};

struct PlanePiece;
using NextStage = std::function<void(const PathMove&)>;

/// Inserts roundings and chamfers (RND, CHF, CHR). Holds back one move, and the pure infeeds behind
/// it.
class CornerStage {
 public:
  CornerStage(Reporter& reporter, NextStage next) : reporter_(reporter), next_(std::move(next)) {}
  void push(const PathMove& move);
  void flush();
  bool idle() const { return held_.empty(); }

 private:
  bool may_insert(const PathMove& after);
  void nothing_inserted(const char* why);
  bool insert(PathMove& before, PathMove& after, PathMove& inserted);

  Reporter& reporter_;
  NextStage next_;
  std::vector<PathMove> held_;  ///< the move with the corner, then moves without plane travel
};

/// Offsets the contour by the tool radius (G40 G41 G42).
class CompensationStage {
 public:
  CompensationStage(Reporter& reporter, NextStage next)
      : reporter_(reporter), next_(std::move(next)) {}
  void push(const PathMove& move);
  void flush();
  bool idle() const { return queue_.empty() && !active_; }

 private:
  std::size_t following(std::size_t n) const;
  bool ready(bool last) const;
  void settle(bool last);
  void enter();
  void skip_void_entry();
  void follow();
  void leave_or_shift();
  bool squeezed(std::size_t i, std::size_t next, Vec2 entered) const;
  bool meet_inside(const PlanePiece& piece, std::size_t nearest, Vec2& end, bool& round);
  void choose_end(const PlanePiece& piece, Vec2& end, bool& corner, bool& round);
  PlanePiece reach(std::size_t i, std::size_t next) const;
  PlanePiece corner_arc(const PathMove& first, const PlanePiece& piece,
                        const PlanePiece& next) const;
  void send_corner(const PathMove& after, const PlanePiece& arc);
  void run_infeeds();
  void run_piece(const PathMove& first, PlanePiece piece, Vec2 end, double height);
  Vec2 extended_end(const PlanePiece& piece, const PlanePiece& next) const;
  void round_outside(const PathMove& first, const PathMove& after, const PlanePiece& piece);
  void send(PathMove move, const PlanePiece& piece, double end_height);
  void send_line(const PathMove& like, Vec2 to, double end_height);
  static double half_tangent(double turn);

  Reporter& reporter_;
  NextStage next_;
  std::vector<PathMove> queue_;
  bool active_ = false;
  bool resumes_ = false;  ///< the last one ran suspended (CUTCONON)
  Vec3 at_;               ///< where the last motion given on ended
  Vec2 cursor_;           ///< the same in the plane, as tool centre
};

}  // namespace mrsim
