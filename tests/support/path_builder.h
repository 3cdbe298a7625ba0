// A tool's path, move after move.
#pragma once

#include "core/numbers/vec.h"
#include <mrsim/types.h>

#include <vector>

namespace mrsim::testing {

/// Moves of tool 0, or of another, from where the last one ended; lines are numbered from 1. `Path`
/// derives from this class, so that calls can be chained.
template <class Path>
class PathBuilder {
 public:
  explicit PathBuilder(Vec3 start) : at_(start) {}
  /// The moves that follow are those of `tool`.
  Path& by(int tool) {
    tool_ = tool;
    return static_cast<Path&>(*this);
  }
  Path& rapid(Vec3 to) { return add(MotionKind::rapid, to); }
  Path& cut(Vec3 to) { return add(MotionKind::line, to); }
  /// Sweep in radians about the axis. Requires: `to` is where that leads.
  Path& arc(Vec3 to, Vec3 center, double sweep, Vec3 axis = {0, 0, 1}) {
    add(MotionKind::arc, to);
    Motion& m = motions.back();
    m.center = center;
    m.axis = axis;
    m.radius = length(m.start - center);
    m.sweep = sweep;
    return static_cast<Path&>(*this);
  }
  std::vector<Motion> motions;

 private:
  Path& add(MotionKind kind, Vec3 to) {
    Motion m;
    m.kind = kind;
    m.start = at_;
    m.end = at_ = to;
    m.tool = tool_;
    m.line = static_cast<int>(motions.size()) + 1;
    motions.push_back(m);
    return static_cast<Path&>(*this);
  }
  Vec3 at_;
  int tool_ = 0;
};

}  // namespace mrsim::testing
