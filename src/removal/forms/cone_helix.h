// The distance from a convex tool with conical flanks (V tool, drill, taper) on a helix about Z
// or an arc in a horizontal plane, where one of its flanks is what is nearest: closed, without a
// search (docs/sweeps.md, Cones on helices).
#pragma once

#include "removal/forms/tool_path.h"
#include "removal/tool/profile.h"

#include <limits>
#include <optional>

namespace mrsim {

/// A helix about Z, or a horizontal arc, prepared for one point p; it serves every tool on the
/// path.
class ConeHelix {
 public:
  /// Requires: path.horizontal, at most one turn from `begin` to `end`; the path outlives this.
  ConeHelix(const ToolPath& path, const Vec3& p, double begin, double end);

  struct Minimum {
    PathSample least;
    bool is_exact = false;  ///< false: `least` is a lower bound, its place about the nearest
  };
  /// The least distance over the positions from `begin` to `end`, up to 1e-12 of the size; not
  /// exact where a corner, a ball or a torus may be nearest. If it is at least `limit`, the result
  /// may be any lower bound that is too. Requires: tool.is_convex().
  Minimum minimum(const Profile& tool,
                  double limit = std::numeric_limits<double>::infinity()) const;

 private:
  // Seen from the tool's tip at t.
  struct Place {
    double t, rho, z;
  };
  struct Least {
    double f = -std::numeric_limits<double>::infinity();
    Place at{};
  };
  Least least(double a, double c, double offset, double wanted) const;
  Place end_at(double t) const;
  std::optional<Place> inner(const Vec2& w) const;
  Place at(double t, const Vec2& w) const;

  const ToolPath& path_;
  const Vec3 away_;    // p from the centre
  const Vec2 facing_;  // `away_` in plan, in (u, v)
  const double d_;     // from the axis
  const Place ends_[2];
  std::optional<Place> nearest_;  // in plan, but for the ends
};

}  // namespace mrsim
