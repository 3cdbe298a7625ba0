// SweepTable: the queries, dispatched by the kind of sweep.
#include "removal/sweep.h"

#include "core/error.h"
#include "removal/sweep_columns.h"
#include "removal/sweep_lane_scalar.h"
#include "removal/sweep_motion.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

// Nearest point of a horizontal path, on one half of an arc when asked for.
struct PlanFoot {
  double x = 0, y = 0, rho = 0;
  int half = 0;
};

enum class Half { any = -1, first = 0, second = 1 };

PlanFoot line_foot(const double* c, const Vec3& p) {
  const lane::PlanLineFoot f = lane::line_foot(c, p.x, p.y);
  return {c[0] + f.t * c[2], c[1] + f.t * c[3], std::sqrt(f.squared), 0};
}

PlanFoot arc_foot(const double* c, const Vec3& p, Half wanted) {
  const double dx = p.x - c[0], dy = p.y - c[1];
  const double a = dx * c[3] + dy * c[4], off = dy * c[3] - dx * c[4];
  PlanFoot f;
  f.rho = lane::arc_rho(c, p.x, p.y);
  f.half = wanted == Half::any ? (off > 0 ? 1 : 0) : wanted == Half::second ? 1 : 0;
  const bool within = c[5] * (off < 0 ? -off : off) - c[6] * a <= 0;
  const double n = std::sqrt(dx * dx + dy * dy);
  if (within && n > 0) {
    f.x = c[0] + c[2] / n * dx, f.y = c[1] + c[2] / n * dy;
    return f;
  }
  const double ea = c[2] * c[5], eb = c[2] * c[6] * (f.half == 1 ? 1 : -1);
  f.x = c[0] + ea * c[3] - eb * c[4], f.y = c[1] + ea * c[4] + eb * c[3];
  return f;
}

Vec3 revolved(const Vec3& p, double foot_x, double foot_y, Vec2 g) {
  const double dx = p.x - foot_x, dy = p.y - foot_y, n = std::sqrt(dx * dx + dy * dy);
  return n > 0 ? Vec3{g.x * dx / n, g.x * dy / n, g.y} : Vec3{g.x, 0, g.y};
}

// Gradient of the asked face of a tool at rest.
Vec2 face_gradient(const Profile& tool, double rho, double z, std::int32_t patch) {
  if (!tool.is_rounded()) return tool.gradient({rho, z}, patch);
  return slab_face_gradient(tool, rho, z, patch);
}

// A horizontal or upright move of any tool: plan path, its lowest tip height, vertical travel.
struct LevelView {
  bool arc = false;
  const double* plan = nullptr;
  double z = 0;  // of the tip
};

LevelView level_view(const SweepColumns& c, const SweepRef& ref) {
  LevelView v;
  if (ref.kind == SweepKind::plane_line) {
    v.plan = c.plane_lines[ref.row].c;
    v.z = v.plan[4] - v.plan[6];
  } else if (ref.kind == SweepKind::plane_arc) {
    v.arc = true;
    v.plan = c.plane_arcs[ref.row].c;
    v.z = v.plan[7] - v.plan[9];
  } else {
    const ProfileRow& row = c.profiles[ref.row];
    v.arc = row.arc;
    v.plan = row.c;
    v.z = row.z;
  }
  return v;
}

double face_distance(const Profile& tool, double rho, double z, std::int32_t patch) {
  if (!tool.is_rounded()) return tool.face_distance({rho, z}, patch);
  return slab_face_distance(tool, rho, z, patch);
}

PlanFoot plan_foot(const LevelView& v, const Vec3& p, Half half) {
  return v.arc ? arc_foot(v.plan, p, half) : line_foot(v.plan, p);
}

SweepSample level_sample(const SweepColumns& c, const SweepRef& ref, const Vec3& p) {
  const LevelView v = level_view(c, ref);
  const PlanFoot f = plan_foot(v, p, Half::any);
  const Profile& tool = c.cutter(ref);
  const ProfileSample s = tool_sample(tool, f.rho, p.z - v.z);
  return {c.distance(ref, p), s.patch + (ref.split && f.half == 1 ? kBranchPatch : 0)};
}

// Where the face `patch` of a level sweep looks at p from.
PlanFoot face_foot(const LevelView& v, const SweepRef& ref, const Vec3& p, std::int32_t patch) {
  Half half = Half::any;
  if (ref.split) half = patch >= kBranchPatch ? Half::second : Half::first;
  return plan_foot(v, p, half);
}

Vec3 level_gradient(const SweepColumns& c, const SweepRef& ref, const Vec3& p, std::int32_t patch) {
  const LevelView v = level_view(c, ref);
  const PlanFoot f = face_foot(v, ref, p, patch);
  const Vec2 g = face_gradient(c.cutter(ref), f.rho, p.z - v.z, patch & (kBranchPatch - 1));
  return revolved(p, f.x, f.y, g);
}

double level_face_distance(const SweepColumns& c, const SweepRef& ref, const Vec3& p,
                           std::int32_t patch) {
  const LevelView v = level_view(c, ref);
  const PlanFoot f = face_foot(v, ref, p, patch);
  const double rho =
      std::sqrt((p.x - f.x) * (p.x - f.x) + (p.y - f.y) * (p.y - f.y));  // of the asked half
  return face_distance(c.cutter(ref), rho, p.z - v.z, patch & (kBranchPatch - 1));
}

Vec3 ball_gradient(const double* c, const Vec3& p) {
  const lane::StripFoot f = lane::strip_foot(c, lane::strip_scale(c[6]), p.x, p.y, p.z);
  const Vec3 g = p - Vec3{c[0] + f.along * c[3], c[1] + f.along * c[4], f.z};
  const double n = length(g);
  // On the skeleton itself: any direction across it.
  return n > 0 ? (1 / n) * g : Vec3{-c[4], c[3], 0};
}

// Path sweeps. Where a corner of the profile draws the surface, its normal is that of the surface
// drawn by the corner's circle, across both the circle and the path.
struct Contact {
  Vec3 q;       // p as seen from the tool's tip
  Vec3 travel;  // direction of the path
  double rho = 0;
  bool at_end = false;
};

Contact contact_at(const ToolPath& path, double t, const Vec3& p) {
  Contact c;
  const PathPoint at = path_point(path, t);
  c.q = p - at.position;
  c.travel = at.direction;
  c.rho = std::sqrt(c.q.x * c.q.x + c.q.y * c.q.y);
  c.at_end = t <= 0 || t >= (path.arc ? path.sweep : 1);
  return c;
}

Vec3 around(const Contact& c, Vec2 g) { return revolved(c.q, 0, 0, g); }

std::int32_t path_patch(const Profile& tool, const ToolPath& path, double t, const Vec3& p) {
  const Contact c = contact_at(path, t, p);
  const ProfileSample s = tool_sample(tool, c.rho, c.q.z);
  const std::int32_t branch = path.arc ? path_branch(path, t) * kBranchPatch : 0;
  if (c.at_end) return s.patch + branch;
  const double slope = dot(around(c, s.gradient), c.travel);
  const double steep = 1e-6 * length(c.travel);
  const int corner = tool.nearest_corner({c.rho, c.q.z});
  const bool drawn = slope > steep || slope < -steep || tool.foot_is_corner({c.rho, c.q.z});
  return branch + (drawn && corner >= 0 ? kCornerPatch + corner : s.patch);
}

// The face of a path sweep at p: its normal and its distance. Beyond its creases a face is
// continued by the tool at the position that is nearest to p.
struct PathFace {
  Vec3 gradient;
  double distance = 0;
};

// The surface drawn by a corner's circle, seen from its point that looks at p.
PathFace corner_face(const Profile& tool, const Contact& c, int corner) {
  const Vec3 radial = c.rho > 0 ? Vec3{c.q.x / c.rho, c.q.y / c.rho, 0} : Vec3{1, 0, 0};
  Vec3 normal = normalized(cross(c.travel, {-radial.y, radial.x, 0}));
  if (normal == Vec3{}) normal = around(c, tool_sample(tool, c.rho, c.q.z).gradient);
  const Vec2 out = tool.corner_direction(corner);
  if (out.x * dot(normal, radial) + out.y * normal.z < 0) normal = -normal;
  const Vec2 at = tool.corner_point(corner);
  return {normal, dot(normal, c.q - (at.x * radial + Vec3{0, 0, at.y}))};
}

PathFace path_face(const SweepColumns& columns, const SweepRef& ref, const Vec3& p,
                   std::int32_t patch) {
  const ToolPath& path = columns.paths[ref.row];
  const Profile& tool = columns.cutter(ref);
  const PathSample at = path.arc ? branch_distance(tool, path, p, patch / kBranchPatch)
                                 : path_distance(tool, path, p);
  const Contact c = contact_at(path, at.t, p);
  const std::int32_t face = patch % kBranchPatch;
  if (face >= kCornerPatch) return corner_face(tool, c, face - kCornerPatch);
  return {around(c, face_gradient(tool, c.rho, c.q.z, face)),
          face_distance(tool, c.rho, c.q.z, face)};
}

// Up and down on the Z axis, as lathes drill.
bool is_on_axis(const Motion& m) {
  const auto has_no_plan = [](const Vec3& v) { return v.x == 0 && v.y == 0; };
  return m.kind != MotionKind::arc && has_no_plan(m.start) && has_no_plan(m.end) &&
         has_no_plan(m.tool_axis);
}

}  // namespace

// An open cutter reaches to infinity, so that `top` is only a promise of the caller.
SweepTable::SweepTable(std::span<const Motion> motions, std::span<const Tool> tools, double,
                       const SweepSelection& selection, int threads)
    : columns_(std::make_unique<Columns>()) {
  columns_->build(motions, tools, selection, threads);
  columns_->all_turned = std::all_of(motions.begin(), motions.end(), [&](const Motion& m) {
    const bool counts = m.tool >= 0 && (selection.rapids || m.kind != MotionKind::rapid);
    return !counts || is_turning(tools[static_cast<std::size_t>(m.tool)].type) || is_on_axis(m);
  });
}
bool SweepTable::is_turned() const { return columns_->all_turned; }
SweepTable::SweepTable(SweepTable&&) noexcept = default;
SweepTable& SweepTable::operator=(SweepTable&&) noexcept = default;
SweepTable::~SweepTable() = default;

std::size_t SweepTable::size() const { return columns_->refs.size(); }
std::int32_t SweepTable::motion(std::size_t i) const { return columns_->motions[i]; }
Box3 SweepTable::bounds(std::size_t i) const {
  if (i < size()) return columns_->bounds_of(columns_->refs[i]);
  if (i >= kFirstPack) {
    const auto number = static_cast<std::uint32_t>(i);
    const SweepPack& pack = columns_->packs[number];
    const SweepRef& ref = columns_->refs[pack.first];
    return inflated(columns_->bounds_of_line(ref, columns_->packs.chord(number)), pack.spread);
  }
  std::vector<std::uint32_t> sweeps;
  columns_->turn_tree.append_sweeps(static_cast<std::uint32_t>(i - size()), sweeps);
  Box3 box;
  for (const std::uint32_t s : sweeps) extend(box, columns_->bounds_of(columns_->refs[s]));
  return box;
}
const TurnTree& SweepTable::turn_tree() const { return columns_->turn_tree; }
double SweepTable::max_error() const { return columns_->max_error; }
double SweepTable::smallest_radius() const { return columns_->smallest_radius; }

Box3 SweepColumns::bounds_of(const SweepRef& ref) const {
  if (ref.kind == SweepKind::ball_line) return bounds_of_line(ref, ball_lines[ref.row]);
  if (ref.kind == SweepKind::plane_line) return bounds_of_line(ref, plane_lines[ref.row]);
  return bounds[static_cast<std::size_t>(ref.kind)][ref.row];
}

Box3 SweepColumns::bounds_of_line(const SweepRef& ref, const LineRecord& record) const {
  const Profile& tool = cutter(ref);
  const double* c = record.c;
  Box3 path;
  if (ref.kind == SweepKind::ball_line) {
    extend(path, Vec3{c[0], c[1], c[2] - c[7]});
    extend(path, Vec3{c[0] + c[3] * c[5], c[1] + c[4] * c[5], c[2] - c[7] + c[6] * c[5]});
  } else {
    extend(path, Vec3{c[0], c[1], c[4] - c[6]});
    extend(path, Vec3{c[0] + c[2], c[1] + c[3], c[4] - c[6]});
  }
  return sweep_bounds(tool, path, ref.frame > 0 ? &frames[ref.frame - 1] : nullptr);
}

double SweepColumns::distance(const SweepRef& ref, const Vec3& p) const {
  switch (ref.kind) {
    case SweepKind::ball_line:
      return lane::ball_line(ball_lines[ref.row].c, p.x, p.y, p.z);
    case SweepKind::plane_line:
      return lane::plane_line(plane_lines[ref.row].c, p.x, p.y, p.z);
    case SweepKind::plane_arc:
      return lane::plane_arc(plane_arcs[ref.row].c, p.x, p.y, p.z);
    case SweepKind::ball_arc:
      return ball_arc_distance(ball_arcs[ref.row], ball_arcs[ref.row].whole, p);
    case SweepKind::profile: {
      const ProfileRow& row = profiles[ref.row];
      const double rho = row.arc ? lane::arc_rho(row.c, p.x, p.y) : lane::line_rho(row.c, p.x, p.y);
      return tool_distance(cutter(ref), rho, p.z - row.z);
    }
    case SweepKind::path:
      return path_value(cutter(ref), paths[ref.row], p);
    case SweepKind::turn:
      return turn_distance(turns[ref.row], p);
  }
  return 0;
}

std::optional<SweepTable::FlatFloor> SweepTable::flat_floor(std::size_t i, const Vec3& p) const {
  const SweepRef& ref = columns_->refs[i];
  if (ref.frame > 0 || (ref.kind != SweepKind::plane_line && ref.kind != SweepKind::plane_arc &&
                        ref.kind != SweepKind::profile))
    return std::nullopt;
  const Profile& tool = columns_->cutter(ref);
  if (!tool.is_rounded() || !tool.is_rising()) return std::nullopt;
  const LevelView v = level_view(*columns_, ref);
  return FlatFloor{v.z, tool.core() - plan_foot(v, p, Half::any).rho};
}

double SweepTable::distance(std::size_t i, const Vec3& p) const {
  const SweepRef& ref = columns_->refs[i];
  return columns_->distance(ref, ref.frame > 0 ? columns_->frames[ref.frame - 1].in(p) : p);
}

SweepColumns::Foot SweepColumns::foot(const SweepRef& ref, const Vec3& p) const {
  if (ref.frame != 0) return {};
  if (ref.kind == SweepKind::ball_arc) {
    const BallArcFoot f = ball_arc_foot(ball_arcs[ref.row], ball_arcs[ref.row].whole, p);
    return {f.squared, f.point - p, false};
  }
  if (ref.kind != SweepKind::profile) return {};
  const PlanFoot f = plan_foot(level_view(*this, ref), p, Half::any);
  return {f.rho * f.rho, {f.x - p.x, f.y - p.y, profiles[ref.row].z - p.z}, !profiles[ref.row].arc};
}

SweepSample SweepTable::sample(std::size_t i, const Vec3& point) const {
  const SweepRef& ref = columns_->refs[i];
  const Vec3 p = ref.frame > 0 ? columns_->frames[ref.frame - 1].in(point) : point;
  switch (ref.kind) {
    case SweepKind::ball_line:
      return {columns_->distance(ref, p), 0};
    case SweepKind::ball_arc: {
      const int half = ref.split ? ball_arc_half(columns_->ball_arcs[ref.row], p) : 0;
      return {columns_->distance(ref, p), half * kBranchPatch};
    }
    case SweepKind::path: {
      const ToolPath& path = columns_->paths[ref.row];
      const PathSample s = path_distance(columns_->cutter(ref), path, p);
      return {s.distance, path_patch(columns_->cutter(ref), path, s.t, p)};
    }
    case SweepKind::turn:
      return turn_sample(columns_->turns[ref.row], p);
    default:
      return level_sample(*columns_, ref, p);
  }
}

std::int32_t SweepTable::patch(std::size_t i, const Vec3& p) const {
  return columns_->refs[i].kind == SweepKind::ball_line ? 0 : sample(i, p).patch;
}

Vec3 SweepTable::gradient(std::size_t i, const Vec3& point, std::int32_t patch) const {
  const SweepRef& ref = columns_->refs[i];
  const Frame* frame = ref.frame > 0 ? &columns_->frames[ref.frame - 1] : nullptr;
  const Vec3 p = frame != nullptr ? frame->in(point) : point;
  Vec3 g;
  switch (ref.kind) {
    case SweepKind::ball_line:
      g = ball_gradient(columns_->ball_lines[ref.row].c, p);
      break;
    case SweepKind::ball_arc:
      g = ball_arc_gradient(columns_->ball_arcs[ref.row], columns_->ball_arc_face(ref, patch), p);
      break;
    case SweepKind::path:
      g = path_face(*columns_, ref, p, patch).gradient;
      break;
    case SweepKind::turn:
      g = turn_gradient(columns_->turns[ref.row], p, patch);
      break;
    default:
      g = level_gradient(*columns_, ref, p, patch);
  }
  return frame != nullptr ? frame->out(g) : g;
}

double SweepTable::patch_distance(std::size_t i, const Vec3& point, std::int32_t patch) const {
  const SweepRef& ref = columns_->refs[i];
  const Vec3 p = ref.frame > 0 ? columns_->frames[ref.frame - 1].in(point) : point;
  switch (ref.kind) {
    case SweepKind::ball_line:
      return columns_->distance(ref, p);
    case SweepKind::ball_arc:
      return ball_arc_distance(columns_->ball_arcs[ref.row], columns_->ball_arc_face(ref, patch),
                               p);
    case SweepKind::path:
      return path_face(*columns_, ref, p, patch).distance;
    case SweepKind::turn:
      return turn_face_distance(columns_->turns[ref.row], p, patch);
    default:
      return level_face_distance(*columns_, ref, p, patch);
  }
}

}  // namespace mrsim
