// What the loops of helix_lanes.inl know of a helix and its tool.
#pragma once

namespace mrsim {

/// The lowest turn of a falling helix about Z, or a part of it, of a tool with is_rounded() that
/// reaches up.
struct HelixRecord {
  /// A position by its parameter and the direction from the helix's axis, in (u, v).
  struct End {
    double t = 0, sin = 0, cos = 1;
  };
  double x = 0, y = 0, z = 0;  ///< of the axis; of the first position's flat core
  double ux = 0, uy = 0, vx = 0, vy = 0;
  double radius = 0, fall = 0;  ///< mm; mm per radian
  double core = 0, round = 0;   ///< of the tool
  End begin, end;
};

}  // namespace mrsim
