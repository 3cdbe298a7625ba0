// What the loops of chain_lanes.inl know of a straight move of a convex tool.
#pragma once

#include "removal/tool/tool.h"

#include <cstddef>

namespace mrsim {

inline constexpr std::size_t kMostFlanks = 4;  ///< others have neither planes nor guesses

/// A convex tool whose profile is a chain of lines and of arcs below half a turn.
struct ChainTool {
  /// A straight edge of the profile that draws a cone or a cylinder.
  struct Flank {
    std::size_t edge;
    double across, up;  ///< outward normal, from the axis and along it
    double offset;      ///< the tool lies in across r + up z <= offset
  };
  const ProfileEdge* edges = nullptr;  ///< the profile's
  std::size_t count = 0;               ///< 0: the tool is none
  bool tipped = false;  ///< its lower end is a disc about the axis, or a point, thickened by a ball
  double core = 0, tip = 0, ball = 0;  ///< the disc's radius and height, the ball's radius
  Vec2 last;                           ///< last normal of the lower end
  double radius = 0, bottom = 0, top = 0;
  std::size_t flank_count = 0;
  Flank flanks[kMostFlanks] = {};
};

/// A straight move. u and v are along and across it in plan, from its start, v >= 0; w is the
/// height above the start.
struct alignas(64) ChainLine {
  double x = 0, y = 0, z = 0;  ///< of the tip at the start
  double ux = 1, uy = 0;       ///< direction in plan, unit
  double plan = -1, rise = 0;  ///< of the whole move, in plan and upwards, mm; plan < 0: no move
  double per_plan = 0, per_way = 0;  ///< 1 / plan and 1 / length^2
  /// The move is tangent to a flank where the normal has `tilt` times as much along u as along v;
  /// infinity where it is steeper than the flank and tangent nowhere.
  double tilt[kMostFlanks] = {};
};

/// Moves side by side, number by number: those of a ChainLine in their order.
struct ChainColumns {
  static constexpr std::size_t kCount = 9 + kMostFlanks;
  const double* base = nullptr;
  std::size_t stride = 0;
  const double* operator[](std::size_t i) const { return base + i * stride; }
};

}  // namespace mrsim
