// Motions into rows: chooses the form of each sweep.
#include "core/error.h"
#include "core/trig.h"
#include "core/units.h"
#include "removal/sweep_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace mrsim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLevel = 1e-11;  // mm: less rise than this is none
constexpr double kClosedError =
    1e-10;  // mm: rounding of the closed forms within 10 m of the origin

[[noreturn]] void unsupported(const Motion& m, const Tool& tool, const std::string& why) {
  throw Error("motion-unsupported",
              "line " + std::to_string(m.line) + ", tool " + tool.id + ": " + why);
}

// A motion in the frame of its tool.
struct LocalMotion {
  bool arc = false;
  Vec3 start, end;
  Vec3 center, u, v, rise;  // arc: rise per radian
  double sweep = 0;         // radians, positive
};

LocalMotion localized(const Motion& m, const Frame* frame) {
  const auto in = [frame](const Vec3& p) { return frame != nullptr ? frame->in(p) : p; };
  LocalMotion l;
  l.arc = m.kind == MotionKind::arc;
  l.start = in(m.start);
  l.end = in(m.end);
  if (!l.arc) return l;
  const double way = m.sweep < 0 ? -1 : 1;
  l.sweep = way * m.sweep;
  l.center = in(m.center);
  const Vec3 axis = in(m.axis);
  l.u = l.start - l.center;
  l.u = l.u - dot(l.u, axis) * axis;
  l.v = way * cross(axis, l.u);
  l.rise = (m.rise / l.sweep) * axis;
  return l;
}

// Extent of c + u cos t + v sin t + rise t for t in [0, sweep] along one axis.
void arc_extent(double c, double u, double v, double rise, double sweep, double& lo, double& hi) {
  const auto add = [&](double x) { lo = std::min(lo, x), hi = std::max(hi, x); };
  const SinCos e = sincos(sweep);
  add(c + u);
  add(c + u * e.cos + v * e.sin + rise * sweep);
  const double swing = std::sqrt(u * u + v * v);
  if (swing == 0) return;
  if (rise != 0 || sweep >= kTwoPi) {
    add(c - swing + std::min(0.0, rise * sweep));
    add(c + swing + std::max(0.0, rise * sweep));
    return;
  }
  double t = mrsim::atan2(v, u);
  if (t < 0) t += kTwoPi;
  if (t <= sweep) add(c + swing);
  t = t >= kPi ? t - kPi : t + kPi;
  if (t <= sweep) add(c - swing);
}

Box3 path_bounds(const LocalMotion& l) {
  Box3 b;
  extend(b, l.start);
  if (!l.arc) {
    extend(b, l.end);
    return b;
  }
  for (int i = 0; i < 3; ++i) {
    double lo = component(b.lo, i), hi = component(b.hi, i);
    arc_extent(component(l.center, i), component(l.u, i), component(l.v, i), component(l.rise, i),
               l.sweep, lo, hi);
    component(b.lo, i) = lo;
    component(b.hi, i) = hi;
  }
  return b;
}

Box3 sweep_bounds(const Profile& tool, const LocalMotion& l, const Frame* frame) {
  Box3 b = path_bounds(l);
  const double r = tool.max_radius();
  b.lo = b.lo + Vec3{-r, -r, tool.bottom()};
  b.hi = b.hi + Vec3{r, r, tool.open_top() ? 0 : tool.top()};
  if (frame == nullptr) {
    if (tool.open_top()) b.hi.z = kInfinity;
    return b;
  }
  if (tool.open_top()) b.hi.z = b.hi.z < b.lo.z ? b.lo.z : b.hi.z;
  Box3 world;
  for (int k = 0; k < 8; ++k)
    extend(world,
           frame->out({k & 1 ? b.hi.x : b.lo.x, k & 2 ? b.hi.y : b.lo.y, k & 4 ? b.hi.z : b.lo.z}));
  for (int i = 0; tool.open_top() && i < 3; ++i) {
    const double way = component(frame->z, i);
    if (way > 1e-12) component(world.hi, i) = kInfinity;
    if (way < -1e-12) component(world.lo, i) = -kInfinity;
  }
  return world;
}

void line_in_plan(const Vec3& a, const Vec3& b, double* c) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const bool moves = dx * dx + dy * dy > kLevel * kLevel;
  c[0] = a.x, c[1] = a.y;
  c[2] = moves ? dx : 0, c[3] = moves ? dy : 0;
}

void arc_in_plan(const LocalMotion& l, double* c) {
  const double r = std::sqrt(l.u.x * l.u.x + l.u.y * l.u.y);
  c[0] = l.center.x, c[1] = l.center.y, c[2] = r;
  const double turn = std::min(l.sweep, kTwoPi);
  const SinCos mid = sincos(turn / 2);
  const double inverse = r > 0 ? 1 / r : 0;
  c[3] = inverse * (mid.cos * l.u.x + mid.sin * l.v.x);
  c[4] = inverse * (mid.cos * l.u.y + mid.sin * l.v.y);
  // Half the sweep is measured from the middle, so its sine and cosine are those of turn / 2.
  c[5] = turn < kTwoPi ? mid.cos : -1;
  c[6] = turn < kTwoPi ? mid.sin : 0;
}

// A cutter that reaches up removes nothing with the higher turns of a helix that the lowest does
// not. Turns the path so that it falls, and keeps its last turn.
void keep_lowest_turn(LocalMotion& l) {
  const auto start_at = [&l](double t, double way) {
    const SinCos sc = sincos(t);
    const Vec3 u = l.u, v = l.v;
    l.u = sc.cos * u + sc.sin * v;
    l.v = way * (sc.cos * v - sc.sin * u);
    l.center = l.center + t * l.rise;
    l.rise = way * l.rise;
  };
  if (l.rise.z > 0) start_at(l.sweep, -1);
  if (l.sweep <= kTwoPi) return;
  start_at(l.sweep - kTwoPi, 1);
  l.sweep = kTwoPi;
}

class Builder {
 public:
  Builder(SweepColumns& columns, std::span<const Tool> tools, const SweepSelection& selection)
      : columns_(columns), tools_(tools), selection_(selection), shapes_of_(tools.size()) {}

  void add(const Motion& m, std::int32_t index);

 private:
  struct ShapeRange {
    int first = -1, count = 0;
  };
  bool wanted(const Motion& m) const;
  ShapeRange shapes(const Motion& m);
  int drawn_out(int shape, double travel);
  std::uint16_t frame(const Vec3& axis);
  void add_milling(SweepRef ref, const Motion& m, const Tool& tool);
  void add_level(SweepRef& ref, const LocalMotion& l, const Profile& tool);
  void add_upright(SweepRef& ref, const LocalMotion& l, const Profile& tool);
  void add_path(SweepRef& ref, LocalMotion l, const Profile& tool);
  void add_turning(SweepRef ref, const Motion& m, const Tool& tool);
  void allow(double error) { columns_.max_error = std::max(columns_.max_error, error); }

  SweepColumns& columns_;
  std::span<const Tool> tools_;
  SweepSelection selection_;
  std::vector<ShapeRange> shapes_of_;
  std::map<std::pair<int, double>, int> drawn_out_;
};

// The shapes of the selected part of a motion's tool: one, or a piece of shank or holder each.
Builder::ShapeRange Builder::shapes(const Motion& m) {
  if (m.tool < 0 || static_cast<std::size_t>(m.tool) >= tools_.size())
    throw Error("tool-missing", "line " + std::to_string(m.line) + ": no tool is in use");
  ShapeRange& range = shapes_of_[m.tool];
  if (range.first >= 0) return range;
  ToolShape made;
  try {
    made = make_tool_shape(tools_[m.tool]);
  } catch (const Error& e) {
    throw Error(e.code(),
                std::string(e.what()) + " (first used in line " + std::to_string(m.line) + ")",
                e.kind());
  }
  range.first = static_cast<int>(columns_.shapes.size());
  if (selection_.part != SweepSelection::Part::cutter) {
    for (Profile& piece :
         selection_.part == SweepSelection::Part::shank ? made.shank : made.holder) {
      ToolShape shape;
      shape.cutter = std::move(piece);
      columns_.shapes.push_back(std::move(shape));
    }
  } else {
    double& least = columns_.smallest_radius;
    if (made.radius > 0 && (least == 0 || made.radius < least)) least = made.radius;
    columns_.shapes.push_back(std::move(made));
  }
  range.count = static_cast<int>(columns_.shapes.size()) - range.first;
  return range;
}

std::uint16_t Builder::frame(const Vec3& axis) {
  if (axis == Vec3{0, 0, 1}) return 0;
  const Vec3 z = normalized(axis);
  auto& frames = columns_.frames;
  for (std::size_t i = 0; i < frames.size(); ++i)
    if (frames[i].z == z) return static_cast<std::uint16_t>(i + 1);
  MRSIM_ASSERT(frames.size() < 65000);
  const Vec3 helper = z.x * z.x < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 y = normalized(cross(z, helper));
  frames.push_back({cross(y, z), y, z});
  return static_cast<std::uint16_t>(frames.size());
}

bool Builder::wanted(const Motion& m) const {
  if (m.assumed_start) return false;
  if (m.kind == MotionKind::arc) return selection_.cuts && m.sweep != 0;
  if (m.start == m.end) return false;
  if (m.kind == MotionKind::rapid) return selection_.rapids && m.tool >= 0;
  return selection_.cuts;
}

void Builder::add(const Motion& m, std::int32_t index) {
  if (!wanted(m)) return;
  const ShapeRange range = shapes(m);
  for (int i = 0; i < range.count; ++i) {
    SweepRef ref;
    ref.shape = range.first + i;
    ref.motion = index;
    if (columns_.shapes[ref.shape].turning)
      add_turning(ref, m, tools_[m.tool]);
    else
      add_milling(ref, m, tools_[m.tool]);
  }
}

void Builder::add_milling(SweepRef ref, const Motion& m, const Tool& tool) {
  if (!(length(m.tool_axis) > 0.5)) unsupported(m, tool, "the tool has no axis direction");
  ref.frame = frame(m.tool_axis);
  const Frame* local = ref.frame > 0 ? &columns_.frames[ref.frame - 1] : nullptr;
  const Profile& cutter = columns_.cutter(ref);
  const LocalMotion l = localized(m, local);
  const double dz = l.end.z - l.start.z, lean = dz < 0 ? -dz : dz;
  const bool about_z = l.arc && l.u.z * l.u.z + l.v.z * l.v.z < kLevel * kLevel;
  const double rise = l.rise.z * l.sweep;
  const double dx = l.end.x - l.start.x, dy = l.end.y - l.start.y;
  allow(kClosedError);
  columns_.bounds.push_back(sweep_bounds(cutter, l, local));  // first: shapes may move in memory
  if (l.arc ? about_z && rise > -kLevel && rise < kLevel : lean < kLevel)
    add_level(ref, l, cutter);
  else if (!l.arc && dx * dx + dy * dy < kLevel * kLevel)
    add_upright(ref, l, cutter);
  else
    add_path(ref, l, cutter);
  columns_.refs.push_back(ref);
}

void Builder::add_level(SweepRef& ref, const LocalMotion& l, const Profile& tool) {
  const double z = std::min(l.start.z, l.arc ? l.start.z : l.end.z);
  const double radius = std::sqrt(dot(l.u, l.u));
  ref.split = l.arc && l.sweep < kTwoPi && (l.sweep > kPi || tool.max_radius() > radius);
  if (!l.arc && tool.is_ball_end()) {
    add_path(ref, l, tool);  // balls on lines all have one form
    return;
  }
  if (!tool.is_rounded()) {
    ProfileRow row;
    row.arc = l.arc;
    row.z = z;
    l.arc ? arc_in_plan(l, row.c) : line_in_plan(l.start, l.end, row.c);
    row.length = l.arc ? row.c[2] * l.sweep : std::sqrt(row.c[2] * row.c[2] + row.c[3] * row.c[3]);
    ref.kind = SweepKind::profile;
    ref.row = static_cast<std::uint32_t>(columns_.profiles.size());
    columns_.profiles.push_back(row);
  } else if (l.arc) {
    ArcRecord row;
    arc_in_plan(l, row.c);
    row.c[7] = z + tool.round(), row.c[8] = tool.core(), row.c[9] = tool.round();
    row.c[10] = z + tool.top();
    row.c[11] = row.c[2] * l.sweep;
    ref.kind = SweepKind::plane_arc;
    ref.row = static_cast<std::uint32_t>(columns_.plane_arcs.size());
    columns_.plane_arcs.push_back(row);
  } else {
    LineRecord row;
    line_in_plan(l.start, l.end, row.c);
    row.c[4] = z + tool.round(), row.c[5] = tool.core(), row.c[6] = tool.round();
    row.c[7] = z + tool.top();
    ref.kind = SweepKind::plane_line;
    ref.row = static_cast<std::uint32_t>(columns_.plane_lines.size());
    columns_.plane_lines.push_back(row);
  }
}

// Up and down: a cutter that never narrows upwards counts at its lowest; one that widens once and
// narrows again is drawn out at its widest.
void Builder::add_upright(SweepRef& ref, const LocalMotion& l, const Profile& tool) {
  const LocalMotion& low = l;
  LocalMotion at = low;
  at.start.z = at.end.z = std::min(l.start.z, l.end.z);
  at.end.x = at.start.x, at.end.y = at.start.y;
  if (tool.is_rising()) {
    add_level(ref, at, tool);
    return;
  }
  if (!tool.is_unimodal()) {
    add_path(ref, l, tool);
    return;
  }
  ref.shape = drawn_out(ref.shape, std::max(l.start.z, l.end.z) - at.start.z);
  add_level(ref, at, columns_.cutter(ref));
}

// The shape whose profile is drawn out by `travel`; holes of one depth share one.
int Builder::drawn_out(int shape, double travel) {
  const auto [at, added] =
      drawn_out_.try_emplace({shape, travel}, static_cast<int>(columns_.shapes.size()));
  if (added) {
    ToolShape made;
    made.cutter = columns_.shapes[shape].cutter.drawn_out(travel);
    made.radius = columns_.shapes[shape].radius;
    columns_.shapes.push_back(std::move(made));
  }
  return at->second;
}

void Builder::add_path(SweepRef& ref, LocalMotion l, const Profile& tool) {
  if (!l.arc && tool.is_ball_end()) {
    LineRecord row;
    const double dx = l.end.x - l.start.x, dy = l.end.y - l.start.y;
    const double n = std::sqrt(dx * dx + dy * dy);
    row.c[0] = l.start.x, row.c[1] = l.start.y;
    row.c[2] = (n > kLevel ? l.start.z : std::min(l.start.z, l.end.z)) + tool.round();
    row.c[3] = n > kLevel ? dx / n : 1, row.c[4] = n > kLevel ? dy / n : 0;
    row.c[5] = n > kLevel ? n : 0;
    row.c[6] = n > kLevel ? (l.end.z - l.start.z) / n : 0;
    row.c[7] = tool.round();
    ref.kind = SweepKind::ball_line;
    ref.row = static_cast<std::uint32_t>(columns_.ball_lines.size());
    columns_.ball_lines.push_back(row);
    return;
  }
  ToolPath path;
  path.arc = l.arc;
  if (l.arc) {
    path.level = l.u.z * l.u.z + l.v.z * l.v.z < kLevel * kLevel &&
                 l.rise.x * l.rise.x + l.rise.y * l.rise.y < kLevel * kLevel;
    path.lowest_turn = path.level && tool.is_rising();
    if (path.lowest_turn) keep_lowest_turn(l);
    path.center = l.center, path.u = l.u, path.v = l.v, path.rise = l.rise, path.sweep = l.sweep;
    path.radius = length(l.u);
    path.speed = std::sqrt(path.radius * path.radius + dot(l.rise, l.rise));
  } else {
    path.start = l.start;
    path.travel = l.end - l.start;
    path.speed = length(path.travel);
  }
  allow(tool.is_convex() && !l.arc ? kClosedError : kPathError);
  ref.kind = SweepKind::path;
  ref.row = static_cast<std::uint32_t>(columns_.paths.size());
  columns_.paths.push_back(path);
}

void Builder::add_turning(SweepRef ref, const Motion& m, const Tool& tool) {
  const double off = std::max({std::fabs(m.start.y), std::fabs(m.end.y), std::fabs(m.center.y)});
  if (off > 1e-9) unsupported(m, tool, "a turning tool moves in the plane of X and Z only");
  if (m.lead != 0) unsupported(m, tool, "thread cutting is not simulated");
  const InsertOutline& insert = columns_.shapes[ref.shape].insert;
  const Vec2 start = {m.start.x, m.start.z};
  allow(kClosedError);
  if (m.kind == MotionKind::arc) {
    if (m.axis.x != 0 || m.axis.z != 0 || m.rise != 0)
      unsupported(m, tool, "a turning tool moves in the plane of X and Z only");
    // About +Y, counter-clockwise leads from Z to X: clockwise in (X, Z).
    columns_.turns.push_back(
        turn_arc(insert, start, {m.center.x, m.center.z}, m.axis.y > 0 ? -m.sweep : m.sweep));
  } else {
    columns_.turns.push_back(turn_line(insert, start, {m.end.x, m.end.z}));
  }
  const TurnSweep& s = columns_.turns.back();
  double reach = std::max(0.0, s.hi.x);
  if (!s.inside) reach = std::max(reach, -s.lo.x);
  ref.kind = SweepKind::turn;
  ref.row = static_cast<std::uint32_t>(columns_.turns.size() - 1);
  columns_.refs.push_back(ref);
  columns_.bounds.push_back({{-reach, -reach, s.lo.y}, {reach, reach, s.hi.y}});
}

}  // namespace

void SweepColumns::build(std::span<const Motion> motions, std::span<const Tool> tools,
                         const SweepSelection& selection) {
  Builder builder(*this, tools, selection);
  for (std::size_t i = 0; i < motions.size(); ++i)
    builder.add(motions[i], static_cast<std::int32_t>(i));
  uniform = !refs.empty();
  for (std::size_t i = 0; i < refs.size(); ++i)
    uniform = uniform && refs[i].kind == refs[0].kind && refs[i].frame == 0 && refs[i].row == i;
}

}  // namespace mrsim
