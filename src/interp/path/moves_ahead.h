// The moves that radius compensation has received and not run yet: which of them belong to the
// contour, where they meet at inside corners, and for which the tool has no room. Private to
// src/interp.
#pragma once

#include "interp/path/outside_corner.h"

#include <vector>

namespace mrsim {

class MovesAhead {
 public:
  explicit MovesAhead(Reporter& reporter) : reporter_(reporter) {}

  bool empty() const { return moves_.empty(); }
  std::size_t size() const { return moves_.size(); }
  PathMove& operator[](std::size_t i) { return moves_[i]; }
  const PathMove& operator[](std::size_t i) const { return moves_[i]; }
  PathMove& front() { return moves_.front(); }
  const PathMove& front() const { return moves_.front(); }
  PathMove& back() { return moves_.back(); }
  void push(const PathMove& move) { moves_.push_back(move); }
  void pop() { moves_.erase(moves_.begin()); }
  void clear() { moves_.clear(); }

  /// Index of the n-th move (n >= 1) behind the first that takes part in the same contour, or
  /// size().
  std::size_t following(std::size_t n) const;
  /// Whether enough is known to run the first move. `last`: no move follows.
  bool ready(bool last) const;
  /// Drops the first move's own rounding where it is too small for the tool: the element after it
  /// is approached.
  void skip_void_entry();
  /// Whether nothing is left of move `i` between `entered` and where it meets move `next`.
  bool squeezed(std::size_t i, std::size_t next, Vec2 entered) const;
  /// Finds the move that `piece`, run from `from`, meets: the first one with room, `nearest` or
  /// later. The moves before it are dropped. False, and `way` is unchanged: the tool does not fit.
  bool meet_inside(const PlanePiece& piece, Vec2 from, std::size_t nearest, CornerWay& way);
  /// Where the element behind an outside corner has no room, extends `piece`, or the path round the
  /// corner, to where it meets a later element.
  void close_over(const PlanePiece& piece, Vec2 from, CornerWay& way);

 private:
  PlanePiece reach(std::size_t i, std::size_t next) const;
  bool meets(const PlanePiece& piece, Vec2 from, std::size_t n, CornerWay& way,
             std::size_t& keep) const;
  void skip_before(std::size_t keep);

  Reporter& reporter_;
  std::vector<PathMove> moves_;
};

}  // namespace mrsim
