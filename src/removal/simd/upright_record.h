// What the loops of upright_lanes.inl know of an arc in an upright plane and its tool.
#pragma once

namespace mrsim {

/// A piece of the arc within a quarter of its circle, of a tool with is_rounded() that reaches up.
/// In the arc's plane x lies on the ground, from the centre towards the quarter, and z up.
struct alignas(64) UprightRecord {
  double x = 0, y = 0, z = 0;       ///< of the centre
  double along_x = 1, along_y = 0;  ///< direction of the plane's x
  double radius = 0;                ///< of the arc
  double high_x = 0, high_y = 0;    ///< directions of the ends from the centre, in the plane
  double low_x = 0, low_y = 0;
  double core = 0, round = 0;  ///< of the tool
  double half = 1;             ///< 1: above the centre, -1: below
};

}  // namespace mrsim
