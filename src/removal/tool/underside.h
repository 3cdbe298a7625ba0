// The underside of a cutter that never narrows upwards: its height above the tip by the distance
// from the axis, and the place at which it touches on a slanted move. The heights of sweeps are
// computed from it (docs/history.md).
#pragma once

#include "removal/tool/tool.h"

#include <cmath>
#include <limits>
#include <vector>

namespace mrsim {

/// The square root; 0 of what rounding has made negative.
inline double root_or_zero(double square) { return square > 0 ? std::sqrt(square) : 0; }

class Underside {
 public:
  /// z = z0 + incline (rho - from), or of an arc about (center, z0) on its lower side (above: on
  /// its upper one), for from <= rho <= to.
  struct Edge {
    double from = 0, to = 0, z0 = 0, incline = 0;
    double center = 0, radius = 0;
    bool above = false;
    double height(double rho) const;
    double slope(double rho) const;  ///< infinite where the arc is upright
  };

  Underside() = default;
  /// Requires: tool.is_rising().
  explicit Underside(const Profile& tool);

  /// Height above the tip at distance rho >= 0 from the axis, mm; infinite beyond the wall.
  double height(double rho) const;
  /// What height() gains by rho; infinite where the tool is upright.
  double slope(double rho) const { return slope_at(rho).slope; }
  double radius() const { return radius_; }
  /// From the axis outwards, without gaps; at a wall the height jumps up.
  const std::vector<Edge>& edges() const { return edges_; }
  /// The height is a convex function of the distance: bottom() and bounds() may be called.
  bool is_convex() const { return convex_; }
  /// A flat end and a wall.
  bool is_flat() const {
    return edges_.size() == 1 && edges_[0].radius == 0 && edges_[0].incline == 0;
  }

  bool is_ball() const { return ball_; }

  /// A straight move of the tip, seen from a place in plan: the place lies u along and v >= 0
  /// across from the lower end, the move is `length` long in plan and rises by slope >= 0; mm.
  struct Slant {
    double u = 0, v = 0, length = 0, slope = 0;
  };
  /// Lowest height that the tool reaches at the place, above the lower end of the tip's path; may
  /// be infinite if the true height is at least `below`. Requires: is_convex().
  double bottom(const Slant& at, double below = std::numeric_limits<double>::infinity()) const;
  /// The least and the greatest bottom() of all places within r of this one, or bounds of them.
  struct Bounds {
    double lower = std::numeric_limits<double>::infinity(), upper = lower;
  };
  /// `upper` is infinite where `lower` is not below `below`.
  Bounds bounds(const Slant& at, double r,
                double below = std::numeric_limits<double>::infinity()) const;

 private:
  struct Bracket {
    double low = 0, high = 0;
  };
  struct Slope {
    double height, slope;
  };
  Slope slope_at(double rho) const;
  Bracket contact(const Slant& at, double shift, Bracket range, int steps) const;
  Bracket arc_contact(const Edge& e, const Slant& from, double shift, Bracket in, int steps) const;
  double lower(const Slant& at, double r) const;
  double upper(const Slant& at, double r) const;
  double ball_bottom(const Slant& at) const;
  double ball_lower(const Slant& at, double r) const;
  double ball_upper(const Slant& at, double r) const;

  std::vector<Edge> edges_;
  double radius_ = 0;
  bool convex_ = true, ball_ = false;
};

}  // namespace mrsim
