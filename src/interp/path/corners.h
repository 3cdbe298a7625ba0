// Moves on their way from the interpreter to the sink: the programmed contour, with what corner
// rounding and radius compensation need to know about each move. Coordinates are the stock's.
#pragma once

#include "core/numbers/axis_set.h"
#include "interp/path/frames.h"
#include "interp/text/reporter.h"

#include <functional>

namespace mrsim {

/// The element that is inserted between a move and the next one.
struct CornerSpec {
  enum class Kind : std::uint8_t { none, round, leg, cut };  ///< RND, CHR, CHF
  Kind kind = Kind::none;
  double size = 0;     ///< mm
  double feed = 0;     ///< of the inserted element; 0: the feed of the move before
  bool modal = false;  ///< of RNDM: it holds for each corner, and need not have one
  bool next = false;   ///< ,R ,C: a feed move in the plane must be next
};

/// Radius compensation in force for a move.
struct Compensation {
  int side = 0;  ///< +1 left of the path (G41), -1 right (G42), 0 off
  bool suspended = false;
  double radius = 0;        ///< mm
  Vec2 tip;                 ///< lathe: from the programmed point to the nose centre, in the plane
  bool arcs = false;        ///< outside corners are arcs about the corner, else intersections
  double disc = 0;          ///< DISC / 100: how far such arcs are sharpened
  bool two_points = false;  ///< intersection of tangents; if too far, two points
  double sharpest = 0;      ///< turns above this angle, radians, have no intersection
  bool around = false;      ///< KONT: contours are approached and left round their ends
  bool stepwise = false;    ///< an element, also the entry, depends on the next alone (LinuxCNC)
};

struct PathMove {
  Motion motion;
  Basis basis;  ///< of the plane in force, orthonormal, may be left-handed under a mirror
  CornerSpec corner;
  Compensation comp;
  std::size_t block = 0;  ///< running number of its block
  AxisSet checked_axes;   ///< axes whose travel limits are checked
  std::size_t order = 0;  ///< running number among the moves that were held back
};

using NextStage = std::function<void(const PathMove&)>;

/// Inserts roundings and chamfers (RND, CHF, CHR). It holds back one move and the infeeds behind
/// it, because a corner needs the move that follows.
class CornerStage {
 public:
  CornerStage(Reporter& reporter, NextStage next) : reporter_(reporter), next_(std::move(next)) {}
  /// Takes the next move; finished ones go to the next stage.
  void push(const PathMove& move);
  /// Gives on all moves that are held back.
  void flush();
  bool idle() const { return held_.empty(); }

 private:
  bool may_insert(const PathMove& after);
  void nothing_inserted(const char* why, const PathMove& move);
  void reduced(const PathMove& move, double size);
  bool insert(PathMove& before, PathMove& after, PathMove& inserted);

  Reporter& reporter_;
  NextStage next_;
  std::vector<PathMove> held_;  ///< the move with the corner, then moves without plane travel
};

}  // namespace mrsim
