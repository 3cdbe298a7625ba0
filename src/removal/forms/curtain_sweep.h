// A ball end that reaches up, on an arc in an upright plane (G18, G19 and between), in closed form:
// all points within R of the *curtain*, the part of that plane that lies on the arc or above it.
#pragma once

#include "core/numbers/vec.h"
#include "removal/field/field.h"

namespace mrsim {

/// An arc of up to a full turn about the origin of a plane (x along the ground, y up), and all of
/// the plane above the arc.
struct Curtain {
  double radius = 0, mid_x = 1, mid_y = 0, cos_half = -1, sin_half = 0;
  double left = 0, right = 0;  ///< extent in x
  Vec2 hems[4];                ///< lower ends of upright edges: ends of the arc, extremes in x
  int hem_count = 0;
};
/// The curtain of the arc from angle `from`, counter-clockwise by `turn`, radians.
Curtain make_curtain(double radius, double from, double turn);

/// Whether the arc passes above one of its own ends, where the curtain has a reflex corner.
bool overhangs(const Curtain& c);

struct CurtainFoot {
  double squared = 0;
  Vec2 point;
};
/// Nearest point of the curtain; q itself inside.
CurtainFoot curtain_foot(const Curtain& c, Vec2 q);

/// The sweep. `whole` and its halves share the centre; halves are faces of their own when the ball
/// is larger than the arc or the arc is longer than half a turn.
struct BallArc {
  Vec3 center;                      ///< of the path of the ball's centre
  double along_x = 1, along_y = 0;  ///< x of the plane, on the ground
  double ball = 0;                  ///< mm
  double length = 0;                ///< of the path, mm
  Curtain whole, halves[2];
};
/// The nearest point of the curtain, and its squared distance, mm^2.
struct BallArcFoot {
  double squared = 0;
  Vec3 point;
};
/// The foot of p on `part` of the curtain of `s`.
BallArcFoot ball_arc_foot(const BallArc& s, const Curtain& part, const Vec3& p);
/// Signed distance of p from what the ball sweeps on that part, mm, and its gradient.
double ball_arc_distance(const BallArc& s, const Curtain& part, const Vec3& p);
Vec3 ball_arc_gradient(const BallArc& s, const Curtain& part, const Vec3& p);
/// Whether all of the path lies on the lower half of its circle: the curtain is convex then.
bool is_valley(const Curtain& c);
/// Encloses ball_arc_distance() on a triangle under a path on the upper half of its circle;
/// infinite elsewhere.
FaceRange hill_range(const BallArc& s, const Curtain& part, const Corners3& t);
/// The half that is nearer: 0 or 1.
int ball_arc_half(const BallArc& s, const Vec3& p);

}  // namespace mrsim
