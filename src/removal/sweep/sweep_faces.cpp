#include "removal/sweep/sweep_faces.h"

#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "removal/columns/plan_foot.h"
#include "removal/forms/path_sweep.h"
#include "removal/forms/tool_at_rest.h"
#include "removal/forms/upright_sweep.h"
#include "removal/simd/scalar_forms.h"
#include "removal/sweep/sheared_cylinder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

Vec3 revolved(const Vec3& p, double foot_x, double foot_y, Vec2 g) {
  const double dx = p.x - foot_x, dy = p.y - foot_y, n = std::sqrt(dx * dx + dy * dy);
  return n > 0 ? Vec3{g.x * dx / n, g.x * dy / n, g.y} : Vec3{g.x, 0, g.y};
}

// Gradient of the asked face of a tool at rest.
Vec2 face_gradient(const Profile& tool, double rho, double z, std::int32_t patch) {
  if (!tool.is_end_mill()) return tool.gradient({rho, z}, patch);
  return slab_face_gradient(tool, rho, z, patch);
}

double face_distance(const Profile& tool, double rho, double z, std::int32_t patch) {
  if (!tool.is_end_mill()) return tool.face_distance({rho, z}, patch);
  return slab_face_distance(tool, rho, z, patch);
}

SweepSample horizontal_sample(const SweepColumns& c, const SweepRef& ref, const Vec3& p) {
  const HorizontalView v = horizontal_view(c, ref);
  const PlanFoot f = plan_foot(v, p, Half::any);
  const Profile& tool = c.cutter(ref);
  const ProfileSample s = tool_sample(tool, f.rho, p.z - v.z);
  return {c.distance(ref, p), s.patch + (ref.split && f.half == 1 ? kBranchPatch : 0)};
}

// The foot in plan of p on the half of the path that the face `patch` of a horizontal sweep belongs
// to.
PlanFoot face_foot(const HorizontalView& v, const SweepRef& ref, const Vec3& p,
                   std::int32_t patch) {
  Half half = Half::any;
  if (ref.split) half = patch >= kBranchPatch ? Half::second : Half::first;
  return plan_foot(v, p, half);
}

FacePlane horizontal_face(const SweepColumns& c, const SweepRef& ref, const Vec3& p,
                          std::int32_t patch) {
  const HorizontalView v = horizontal_view(c, ref);
  const PlanFoot f = face_foot(v, ref, p, patch);
  const double rho =
      std::sqrt((p.x - f.x) * (p.x - f.x) + (p.y - f.y) * (p.y - f.y));  // of the wanted half
  const Profile& tool = c.cutter(ref);
  const std::int32_t face = patch & (kBranchPatch - 1);
  return {revolved(p, f.x, f.y, face_gradient(tool, f.rho, p.z - v.z, face)),
          face_distance(tool, rho, p.z - v.z, face)};
}

FacePlane ball_face(const double* c, const Vec3& p) {
  const lane::StripFoot f =
      lane::strip_foot(c, lane::strip_scale(c[BallSlot::slope]), p.x, p.y, p.z);
  const Vec3 g = p - Vec3{c[BallSlot::x] + f.along * c[BallSlot::ux],
                          c[BallSlot::y] + f.along * c[BallSlot::uy], f.z};
  const double n = std::sqrt(f.squared);
  // On the skeleton itself: any direction across it.
  return {n > 0 ? (1 / n) * g : Vec3{-c[BallSlot::uy], c[BallSlot::ux], 0},
          n - c[BallSlot::radius]};
}

// Path sweeps. Where a corner of the profile draws the surface, its normal is that of the surface
// drawn by the corner's circle, across both the circle and the path.
struct Contact {
  Vec3 q;       // p as seen from the tool's tip
  Vec3 travel;  // direction of the path
  double rho = 0;
  bool at_end = false;
};

Contact contact_at(const PathPoint& at, const Vec3& p) {
  Contact c;
  c.q = p - at.position;
  c.travel = at.direction;
  c.rho = std::sqrt(c.q.x * c.q.x + c.q.y * c.q.y);
  return c;
}
Contact contact_at(const SweepColumns& columns, const SweepRef& ref, double t, const Vec3& p) {
  Contact c = contact_at(columns.paths.point(ref.row, t), p);
  c.at_end = t <= 0 || t >= columns.paths.end(ref.row);
  return c;
}

Vec3 around(const Contact& c, Vec2 g) { return revolved(c.q, 0, 0, g); }

std::int32_t path_patch(const SweepColumns& columns, const SweepRef& ref, double t, const Vec3& p) {
  const Profile& tool = columns.cutter(ref);
  const Contact c = contact_at(columns, ref, t, p);
  const ProfileSample s = tool_sample(tool, c.rho, c.q.z);
  const bool line = columns.paths.is_line(ref.row);
  const std::int32_t branch = line ? 0 : path_branch(columns.paths.arc(ref.row), t) * kBranchPatch;
  if (c.at_end) return s.patch + branch;
  const double slope = dot(around(c, s.gradient), c.travel);
  const double steep = 1e-6 * length(c.travel);
  const bool drawn = slope > steep || slope < -steep || tool.foot_is_corner({c.rho, c.q.z});
  const int corner = drawn ? tool.nearest_corner({c.rho, c.q.z}) : -1;
  return branch + (corner >= 0 ? kCornerPatch + corner : s.patch);
}

// The faces of a path sweep at p. Beyond its creases a face is continued by the tool at the
// position that is nearest to p.

// The surface drawn by a corner's circle, seen from its point that looks at p.
FacePlane corner_face(const Profile& tool, const Contact& c, int corner) {
  const Vec3 radial = c.rho > 0 ? Vec3{c.q.x / c.rho, c.q.y / c.rho, 0} : Vec3{1, 0, 0};
  Vec3 normal = normalized(cross(c.travel, {-radial.y, radial.x, 0}));
  if (normal == Vec3{}) normal = around(c, tool_sample(tool, c.rho, c.q.z).gradient);
  const Vec2 out = tool.corner_direction(corner);
  if (out.x * dot(normal, radial) + out.y * normal.z < 0) normal = -normal;
  const Vec2 at = tool.corner_point(corner);
  return {normal, dot(normal, c.q - (at.x * radial + Vec3{0, 0, at.y}))};
}

// The angle in `from` .. `to` at which an arc in the plan is nearest to p.
double facing_angle(const ToolPath& path, const Vec3& p, double from, double to) {
  const Vec3 w = p - path.center;
  double t = mrsim::atan2(dot(w, path.v), dot(w, path.u));
  while (t < from) t += kTwoPi;
  if (t <= to) return t;
  return t - to < from + kTwoPi - t ? to : from;
}

bool is_upright_wall(const Profile& tool, std::int32_t patch) {
  constexpr std::int32_t kWall = 1;  // of an end mill without a fillet
  return tool.is_end_mill() && tool.is_rising() && tool.round() == 0 &&
         patch % kBranchPatch == kWall;
}

// The upright wall of a flat mill that reaches up, continued to all heights: the position that is
// nearest to p in space may touch p with its lower edge, so that its wall would be the floor.
std::optional<FacePlane> path_wall(const SweepColumns& columns, const SweepRef& ref, const Vec3& p,
                                   std::int32_t patch) {
  const Profile& tool = columns.cutter(ref);
  if (!is_upright_wall(tool, patch)) return std::nullopt;
  double t;
  if (columns.paths.is_line(ref.row)) {
    const PathColumn::Line& path = columns.paths.line(ref.row);
    const Vec3 d{path.travel.x, path.travel.y, 0};
    if (d.x == 0 && d.y == 0) return std::nullopt;
    t = std::clamp(dot(p - path.start, d) / dot(d, d), 0.0, 1.0);
  } else {
    const ToolPath& path = columns.paths.arc(ref.row);
    if (!path.horizontal) return std::nullopt;
    const auto [from, to] = branch_ends(path, patch / kBranchPatch);
    t = facing_angle(path, p, from, to);
  }
  const Vec3 foot = columns.paths.point(ref.row, t).position;
  const double dx = p.x - foot.x, dy = p.y - foot.y, rho = std::sqrt(dx * dx + dy * dy);
  return FacePlane{revolved(p, foot.x, foot.y, {1, 0}), rho - tool.core()};
}

// The place of the path where the tool is nearest to p; of a tool of several pieces, the piece that
// has the face, which another one may cover there.
PathPoint face_place(const SweepColumns& columns, const SweepRef& ref, const Vec3& p,
                     std::int32_t patch) {
  const Profile& tool = columns.cutter(ref);
  const std::int32_t branch = patch / kBranchPatch, face = patch % kBranchPatch;
  if (const ToolPath* arc = columns.upright_arc(ref))
    return upright_branch_point(tool, *arc, p, branch);
  const auto least = [&] {
    if (!tool.convex_pieces().empty() && (face >= kCornerPatch || !tool.bends_in(face)))
      return piece_distance(face >= kCornerPatch ? tool.piece_of_corner(face - kCornerPatch)
                                                 : tool.piece_of_patch(face),
                            *columns.paths[ref.row], p, branch);
    return columns.paths.is_line(ref.row)
               ? columns.path_sample(ref, p)
               : branch_distance(tool, columns.paths.arc(ref.row), p, branch);
  };
  return columns.paths.point(ref.row, least().t);
}

FacePlane path_face(const SweepColumns& columns, const SweepRef& ref, const Vec3& p,
                    std::int32_t patch) {
  const Profile& tool = columns.cutter(ref);
  if (const auto wall = path_wall(columns, ref, p, patch)) return *wall;
  const Contact c = contact_at(face_place(columns, ref, p, patch), p);
  const std::int32_t face = patch % kBranchPatch;
  if (face >= kCornerPatch) return corner_face(tool, c, face - kCornerPatch);
  return {around(c, face_gradient(tool, c.rho, c.q.z, face)),
          face_distance(tool, c.rho, c.q.z, face)};
}

// The surface that a corner's circle draws where its normal needs no search.
std::optional<FacePlane> corner_plane(const SweepColumns& columns, const SweepRef& ref,
                                      const Vec3& p, std::int32_t patch) {
  const std::int32_t corner = patch % kBranchPatch - kCornerPatch;
  if (corner < 0) return std::nullopt;
  const Profile& tool = columns.cutter(ref);
  return sheared_cylinder(columns.paths, ref.row,
                          {tool.corner_point(corner), tool.corner_side(corner)}, p);
}

// The tip's face, which a sharp tip draws on both sides of its path.
bool is_flank(const SweepRef& ref, std::int32_t patch) {
  return ref.grooves && (patch & (kFlankPatch - 1)) == 0;
}

// Exact: the distance is that of the face at p, however far.
FacePlane local_face(const SweepColumns& c, const SweepRef& ref, const Vec3& p,
                     std::int32_t patch) {
  switch (ref.kind) {
    case SweepKind::ball_line:
      return ball_face(c.ball_lines[ref.row].c, p);
    case SweepKind::ball_arc: {
      const BallArc& arc = c.ball_arcs[ref.row];
      const Curtain& part = c.ball_arc_face(ref, patch);
      return {ball_arc_gradient(arc, part, p), ball_arc_distance(arc, part, p)};
    }
    case SweepKind::path:
      return path_face(c, ref, p, patch);
    case SweepKind::turn:
      return {turn_gradient(c.turns[ref.row], p, patch),
              turn_face_distance(c.turns[ref.row], p, patch)};
    default:
      return horizontal_face(c, ref, p, patch);
  }
}

// The face of local_face(), to first order.
FacePlane local_face_plane(const SweepColumns& c, const SweepRef& ref, const Vec3& p,
                           std::int32_t patch) {
  if (ref.kind == SweepKind::path) {
    if (const auto plane = corner_plane(c, ref, p, patch)) return *plane;
    if (c.is_chain(ref))
      if (const auto plane = chain_face(c.chain_tools[ref.shape], c.chain_lines[ref.row], p, patch))
        return *plane;
  }
  return local_face(c, ref, p, patch);
}

SweepSample local_sample(const SweepColumns& c, const SweepRef& ref, const Vec3& p) {
  switch (ref.kind) {
    case SweepKind::ball_line:
      return {c.distance(ref, p), 0};
    case SweepKind::ball_arc: {
      const int half = ref.split ? ball_arc_half(c.ball_arcs[ref.row], p) : 0;
      return {c.distance(ref, p), half * kBranchPatch};
    }
    case SweepKind::path: {
      const PathSample s = c.path_sample(ref, p);
      return {s.distance, path_patch(c, ref, s.t, p)};
    }
    case SweepKind::turn:
      return turn_sample(c.turns[ref.row], p);
    default:
      return horizontal_sample(c, ref, p);
  }
}

// `patch` with the side of the path, where the face is a flank.
std::int32_t with_flank(const SweepColumns& c, const SweepRef& ref, const Vec3& p,
                        std::int32_t patch) {
  return is_flank(ref, patch) && groove_side(c, ref, p).off > 0 ? patch + kFlankPatch : patch;
}

// The point on the flank's side of the path from which the flank is seen as from p: p itself, or,
// from beyond the groove's bottom, its mirror image.
Vec3 flank_view(const SweepColumns& c, const SweepRef& ref, const Vec3& p, std::int32_t patch) {
  constexpr double kLeast = 1e-7;  // mm from the bottom, where the flank's normal is known
  const GrooveSide at = groove_side(c, ref, p);
  const double side = (patch & kFlankPatch) != 0 ? 1 : -1;
  if (side * at.off >= kLeast) return p;
  const double seen = std::min(std::max(kLeast, -side * at.off), at.most);
  return p + (side * seen - at.off) * at.across;
}

// A flank goes on beyond the groove's bottom as its tangent plane.
template <class Face>
FacePlane face_at(const SweepColumns& c, std::size_t i, const Vec3& point, std::int32_t patch,
                  const Face& face) {
  const SweepRef& ref = c.refs[i];
  const ToolFrame* frame = ref.frame > 0 ? &c.frames[ref.frame - 1] : nullptr;
  const Vec3 p = frame != nullptr ? frame->in(point) : point;
  const Vec3 from = is_flank(ref, patch) ? flank_view(c, ref, p, patch) : p;
  FacePlane plane = face(c, ref, from, patch & ~kFlankPatch);
  if (!(from == p)) plane.distance += dot(plane.normal, p - from);
  if (frame != nullptr) plane.normal = frame->out(plane.normal);
  return plane;
}

}  // namespace

std::optional<SweepTable::FlatFloor> flat_floor(const SweepColumns& c, std::size_t i,
                                                const Vec3& p) {
  const SweepRef& ref = c.refs[i];
  if (ref.frame > 0 || (ref.kind != SweepKind::plane_line && ref.kind != SweepKind::plane_arc &&
                        ref.kind != SweepKind::profile))
    return std::nullopt;
  const Profile& tool = c.cutter(ref);
  if (!tool.is_end_mill()) return std::nullopt;
  const HorizontalView v = horizontal_view(c, ref);
  return SweepTable::FlatFloor{v.z, v.z + tool.top(), tool.core() - plan_foot(v, p, Half::any).rho};
}

GrooveSide groove_side(const SweepColumns& c, const SweepRef& ref, const Vec3& p) {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  const auto beside_line = [&](double x, double y, double dx, double dy) {
    const double n = std::sqrt(dx * dx + dy * dy);
    const Vec3 across{-dy / n, dx / n, 0};
    return GrooveSide{across.x * (p.x - x) + across.y * (p.y - y), across, kEndless};
  };
  const auto beside_circle = [&](double x, double y, double radius) {
    const double rx = p.x - x, ry = p.y - y, r = std::sqrt(rx * rx + ry * ry);
    if (!(r > 0)) return GrooveSide{-radius, {1, 0, 0}, radius};
    return GrooveSide{r - radius, {rx / r, ry / r, 0}, radius};
  };
  if (ref.kind == SweepKind::path) {
    if (c.paths.is_line(ref.row)) {
      const auto& [start, travel] = c.paths.line(ref.row);
      return beside_line(start.x, start.y, travel.x, travel.y);
    }
    const ToolPath& path = c.paths.arc(ref.row);
    const Vec3 &at = path.center, normal = cross(path.u, path.v);
    if (path.horizontal) return beside_circle(at.x, at.y, path.radius);
    return beside_line(at.x, at.y, -normal.y, normal.x);
  }
  const ProfileRow& row = c.profiles[ref.row];
  return row.arc ? beside_circle(row.c[ArcSlot::x], row.c[ArcSlot::y], row.c[ArcSlot::radius])
                 : beside_line(row.c[LineSlot::x], row.c[LineSlot::y], row.c[LineSlot::dx],
                               row.c[LineSlot::dy]);
}

SweepSample sweep_sample(const SweepColumns& c, std::size_t i, const Vec3& point) {
  const SweepRef& ref = c.refs[i];
  const Vec3 p = ref.frame > 0 ? c.frames[ref.frame - 1].in(point) : point;
  SweepSample s = local_sample(c, ref, p);
  s.patch = with_flank(c, ref, p, s.patch);
  return s;
}

std::int32_t sweep_patch(const SweepColumns& c, std::size_t i, const Vec3& p, double t) {
  const SweepRef& ref = c.refs[i];
  return with_flank(c, ref, p, path_patch(c, ref, t, p));
}

FacePlane sweep_face_plane(const SweepColumns& c, std::size_t i, const Vec3& p,
                           std::int32_t patch) {
  return face_at(c, i, p, patch, local_face_plane);
}

Vec3 sweep_gradient(const SweepColumns& c, std::size_t i, const Vec3& p, std::int32_t patch) {
  return face_at(c, i, p, patch, local_face).normal;
}

double sweep_patch_distance(const SweepColumns& c, std::size_t i, const Vec3& p,
                            std::int32_t patch) {
  return face_at(c, i, p, patch, local_face).distance;
}

bool is_moved_wall(const SweepColumns& c, std::size_t i, std::int32_t patch) {
  const SweepRef& ref = c.refs[i];
  if (ref.kind != SweepKind::path || !c.paths.is_line(ref.row)) return false;
  const Vec3& d = c.paths.line(ref.row).travel;
  return (d.x != 0 || d.y != 0) && is_upright_wall(c.cutter(ref), patch);
}

}  // namespace mrsim
