// Sweeps without a closed form: the least distance from the tool over its positions, found by a
// minimisation with a proven bracket. Tool revolved about Z; path a straight line, an arc in any
// plane or a helix about any axis.
#pragma once

#include "core/numbers/vec.h"
#include "removal/simd/sweep_kernels.h"
#include "removal/tool/tool.h"

#include <cstdint>
#include <utility>

namespace mrsim {

/// Tool tip along the path: start + t * travel, t in [0, 1] (line), or
/// center + cos(t) * u + sin(t) * v + t * rise, t in [0, sweep] (arc and helix, |u| = |v|).
struct ToolPath {
  bool arc = false;
  Vec3 start, travel;            ///< line
  Vec3 center, u, v, rise;       ///< arc; rise in mm per radian
  double sweep = 0;              ///< radians, positive
  double radius = 0, speed = 0;  ///< arc: |u|; both: largest |d position / dt|
  bool horizontal = false;       ///< arc in a horizontal plane, or helix about Z
  bool lowest_turn = false;      ///< horizontal and falling, at most one turn, tool rising
  bool bored = false;            ///< a whole lowest turn of an end mill
  Vec2 last{1, 0};               ///< arc: direction of its end from its centre, in (u, v)

  bool disc = false;  ///< disc_minimum() answers (disc_sweep.h)

  // Arc in an upright plane, at most one turn, of a tool that reaches up: an end mill
  // (upright_sweep.h), or one with has_flank() (flank_sweep.h).
  bool upright = false, flanked = false;
  Vec2 along;             ///< x of the plane, on the ground; the motion goes from x to z
  Vec2 begin, end;        ///< directions of the ends from the centre, in the plane
  int first_quarter = 0;  ///< of the circle, counter-clockwise from x: the one it begins in
  int quarters = 0;       ///< how many it passes
};
struct PathPoint {
  Vec3 position, direction;  ///< d position / dt
};
/// Where the tip is at t: 0 to 1 on a line, radians from the start on an arc.
PathPoint path_point(const ToolPath& path, double t);

/// Whether what an arc leaves has one flank on each side of it in plan: about Z, or in an upright
/// plane.
bool is_two_sided(const ToolPath& arc);

/// Radians: a place of an arc nearer than this to one of its ends is that end.
inline constexpr double kAtPathEnd = 1e-12;

/// The least distance, mm, and the place of the path from which it is reached.
struct PathSample {
  double distance = 0, t = 0;
};

/// Error bound: kPathError mm for arcs and helices and for lines of tools that are not convex,
/// 1e-12 of the size for lines of convex tools and where has_stretches(). Always from above:
/// distance(true) <= result.
inline constexpr double kPathError = 2e-7;
PathSample path_distance(const Profile& tool, const ToolPath& path, const Vec3& p);

/// Whether the distance is found stretch by stretch (falling_lanes.inl), without a search.
inline bool has_stretches(const Profile& tool, const ToolPath& path) {
  return path.disc || path.upright || (path.lowest_turn && tool.is_end_mill());
}

/// The distance alone, the same bits: beside the wall of a bore at the cost of a line.
double path_value(const Profile& tool, const ToolPath& path, const Vec3& p);

/// Branches of an arc, counted from its start: quarter turns, or the quarters of an upright circle.
/// The branch that holds t, its ends, and the least distance over one branch.
int path_branch(const ToolPath& path, double t);
std::pair<double, double> branch_ends(const ToolPath& path, int branch);  ///< not of upright arcs
PathSample branch_distance(const Profile& tool, const ToolPath& path, const Vec3& p, int branch);

/// Least distance of one of a tool's convex_pieces() alone, over a branch of an arc or over a line.
PathSample piece_distance(const Profile& piece, const ToolPath& path, const Vec3& p, int branch);

/// Distance of a revolved tool at rest from (rho, z), z above its tip.
ProfileSample tool_sample(const Profile& tool, double rho, double z);
double tool_distance(const Profile& tool, double rho, double z);
/// Gradient of one face of an end mill, that face continued beyond its edges.
Vec2 slab_face_gradient(const Profile& tool, double rho, double z, std::int32_t patch);
/// Signed distance to that face: what slab_face_gradient is the gradient of.
double slab_face_distance(const Profile& tool, double rho, double z, std::int32_t patch);

}  // namespace mrsim
