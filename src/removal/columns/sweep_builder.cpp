// Motions into rows: chooses the form of each sweep.
#include "removal/columns/sweep_builder.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "core/process/error.h"
#include "removal/forms/disc_sweep.h"
#include "removal/forms/flank_sweep.h"
#include "removal/forms/path_sweep.h"
#include "removal/forms/sweep_motion.h"
#include "removal/forms/upright_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace mrsim {
namespace {

constexpr double kClosedError =
    1e-10;  // mm: rounding of the closed forms within 10 m of the origin

[[noreturn]] void unsupported(const Motion& m, const Tool& tool, const std::string& why) {
  throw Error("motion-unsupported",
              "line " + std::to_string(m.line) + ", tool " + tool.id + ": " + why);
}

bool is_upright(const LocalMotion& l) {
  const Vec3 axis = cross(l.u, l.v);  // length: radius squared
  const double size = length(axis);
  return l.arc && dot(l.rise, l.rise) == 0 && size > 0 &&
         std::fabs(axis.z) * std::sqrt(size) <= kNoTravel * size;
}

void set_upright(ToolPath& path, const Profile& tool) {
  path.upright = tool.is_end_mill();
  path.flanked = !path.upright && has_flank(tool);
  if (path.upright || path.flanked) set_upright_plane(path);
}

}  // namespace

// The shapes of the selected part of a motion's tool: one, or a piece of shank or holder each.
SweepBuilder::ShapeRange SweepBuilder::shapes(const Motion& m) {
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
    std::int32_t piece_number = 0;
    for (Profile& piece :
         selection_.part == SweepSelection::Part::shank ? made.shank : made.holder) {
      ToolShape shape;
      shape.cutter = std::move(piece);
      add_shape(std::move(shape), {m.tool, piece_number++, 0});
    }
  } else {
    double& least = columns_.smallest_radius;
    if (made.radius > 0 && (least == 0 || made.radius < least)) least = made.radius;
    add_shape(std::move(made), {m.tool, 0, 0});
  }
  range.count = static_cast<int>(columns_.shapes.size()) - range.first;
  return range;
}

void SweepBuilder::add_shape(ToolShape&& shape, const ShapeKey& key) {
  columns_.shapes.push_back(std::move(shape));
  keys_.push_back(key);
}

std::uint16_t SweepBuilder::frame(const Vec3& axis) {
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

bool SweepBuilder::wanted(const Motion& m) const {
  if (m.assumed_start) return false;
  if (m.kind == MotionKind::arc) return selection_.cuts && m.sweep != 0;
  if (m.start == m.end) return false;
  if (m.kind == MotionKind::rapid) return selection_.rapids && m.tool >= 0;
  return selection_.cuts;
}

// The tool stays above the highest point that is ever evaluated: its sweep cannot matter.
bool SweepBuilder::stays_above(const Motion& m, const Profile& tool) const {
  constexpr double kClear = 1e-3;  // mm
  if (std::isinf(selection_.top) || m.tool_axis != Vec3{0, 0, 1}) return false;
  return lowest_tip(localized(m, nullptr)) + tool.bottom() > selection_.top + kClear;
}

void SweepBuilder::add(const Motion& m, std::int32_t index) {
  if (!wanted(m)) return;
  const ShapeRange range = shapes(m);
  for (int i = 0; i < range.count; ++i) {
    SweepRef ref;
    ref.shape = range.first + i;
    const bool turning = columns_.shapes[ref.shape].turning;
    if (turning && m.lead != 0) continue;  // no body of revolution
    if (!turning && stays_above(m, columns_.shapes[ref.shape].cutter)) continue;
    columns_.motions.push_back(index);
    if (turning)
      add_turning(ref, m, tools_[m.tool]);
    else
      add_milling(ref, m, tools_[m.tool]);
  }
}

void SweepBuilder::add_milling(SweepRef ref, const Motion& m, const Tool& tool) {
  if (!(length(m.tool_axis) > 0.5)) unsupported(m, tool, "the tool has no axis direction");
  ref.frame = frame(m.tool_axis);
  const ToolFrame* local = ref.frame > 0 ? &columns_.frames[ref.frame - 1] : nullptr;
  const LocalMotion l = localized(m, local);
  if (local == nullptr) ref.shape = extended_up(ref.shape, lowest_tip(l));
  const Profile& cutter = columns_.cutter(ref);
  const double dz = l.end.z - l.start.z, lean = dz < 0 ? -dz : dz;
  const bool about_z = l.arc && l.u.z * l.u.z + l.v.z * l.v.z < kNoTravel * kNoTravel;
  const double rise = l.rise.z * l.sweep;
  const double dx = l.end.x - l.start.x, dy = l.end.y - l.start.y;
  allow(kClosedError);
  const std::int32_t shape = ref.shape;
  if (l.arc ? about_z && rise > -kNoTravel && rise < kNoTravel : lean < kNoTravel)
    add_horizontal(ref, l, cutter);
  else if (!l.arc && dx * dx + dy * dy < kNoTravel * kNoTravel)
    add_upright(ref, l, cutter);
  else
    add_path(ref, l, cutter);
  bool two_sided =
      l.arc ? ref.kind == SweepKind::profile : dx * dx + dy * dy >= kNoTravel * kNoTravel;
  if (l.arc && ref.kind == SweepKind::path) two_sided = is_two_sided(*columns_.paths[ref.row]);
  ref.grooves = two_sided && columns_.shapes[shape].cutter.has_sharp_tip();
  if (ref.kind != SweepKind::ball_line && ref.kind != SweepKind::plane_line)
    columns_.bounds[static_cast<std::size_t>(ref.kind)].push_back(
        sweep_bounds(columns_.shapes[shape].cutter, l, local));  // shapes may have moved
  columns_.refs.push_back(ref);
}

void SweepBuilder::add_horizontal(SweepRef& ref, const LocalMotion& l, const Profile& tool) {
  const double z = std::min(l.start.z, l.arc ? l.start.z : l.end.z);
  const double radius = std::sqrt(dot(l.u, l.u));
  ref.split = l.arc && l.sweep < kTwoPi && (l.sweep > kPi || tool.max_radius() > radius);
  if (!l.arc && tool.is_ball_end()) {
    add_path(ref, l, tool);  // balls on lines all have one form
    return;
  }
  if (!tool.is_end_mill()) {
    ProfileRow row;
    row.arc = l.arc;
    row.z = z;
    l.arc ? arc_in_plan(l, row.c) : line_in_plan(l.start, l.end, row.c);
    row.length = l.arc ? row.c[ArcSlot::radius] * l.sweep
                       : std::sqrt(row.c[LineSlot::dx] * row.c[LineSlot::dx] +
                                   row.c[LineSlot::dy] * row.c[LineSlot::dy]);
    ref.kind = SweepKind::profile;
    ref.row = static_cast<std::uint32_t>(columns_.profiles.size());
    columns_.profiles.push_back(row);
  } else if (l.arc) {
    ArcRecord row;
    arc_in_plan(l, row.c);
    row.c[ArcSlot::low] = z + tool.round(), row.c[ArcSlot::core] = tool.core(),
    row.c[ArcSlot::round] = tool.round();
    row.c[ArcSlot::top] = z + tool.top();
    row.c[ArcSlot::length] = row.c[ArcSlot::radius] * l.sweep;
    ref.kind = SweepKind::plane_arc;
    ref.row = static_cast<std::uint32_t>(columns_.plane_arcs.size());
    columns_.plane_arcs.push_back(row);
  } else {
    LineRecord row;
    line_in_plan(l.start, l.end, row.c);
    row.c[LineSlot::low] = z + tool.round(), row.c[LineSlot::core] = tool.core(),
    row.c[LineSlot::round] = tool.round();
    row.c[LineSlot::top] = z + tool.top();
    ref.kind = SweepKind::plane_line;
    ref.row = static_cast<std::uint32_t>(columns_.plane_lines.size());
    columns_.plane_lines.push_back(row);
  }
}

// Up and down: a cutter that never narrows upwards counts at its lowest; one that widens once and
// narrows again is drawn out at its widest.
void SweepBuilder::add_upright(SweepRef& ref, const LocalMotion& l, const Profile& tool) {
  LocalMotion at = l;
  at.start.z = at.end.z = std::min(l.start.z, l.end.z);
  at.end.x = at.start.x, at.end.y = at.start.y;
  if (tool.is_rising()) {
    add_horizontal(ref, at, tool);
    return;
  }
  if (!tool.is_unimodal()) {
    add_path(ref, l, tool);
    return;
  }
  ref.shape = drawn_out(ref.shape, std::max(l.start.z, l.end.z) - at.start.z);
  add_horizontal(ref, at, columns_.cutter(ref));
}

// The shape whose profile is drawn out by `travel`; holes of one depth share one.
int SweepBuilder::drawn_out(int shape, double travel) {
  const auto [at, added] =
      drawn_out_.try_emplace({shape, travel}, static_cast<int>(columns_.shapes.size()));
  if (added) {
    ToolShape made;
    made.cutter = columns_.shapes[shape].cutter.drawn_out(travel);
    made.radius = columns_.shapes[shape].radius;
    ShapeKey key = keys_[static_cast<std::size_t>(shape)];
    key.travel = travel;
    add_shape(std::move(made), key);
  }
  return at->second;
}

// The shape without an upper end, if its flutes reach above selection_.top with the tip at
// `lowest`.
int SweepBuilder::extended_up(int shape, double lowest) {
  const Profile& tool = columns_.shapes[shape].cutter;
  if (tool.open_top() || !(lowest + tool.top() >= selection_.top)) return shape;
  const double without_end = std::numeric_limits<double>::infinity();
  if (const auto known = drawn_out_.find({shape, without_end}); known != drawn_out_.end())
    return known->second;
  ToolShape made;
  made.cutter = tool.extended_up();
  made.radius = columns_.shapes[shape].radius;
  int& found = drawn_out_[{shape, without_end}];
  found = shape;
  if (!made.cutter.is_rising()) return shape;
  found = static_cast<int>(columns_.shapes.size());
  ShapeKey key = keys_[static_cast<std::size_t>(shape)];
  key.travel = without_end;
  add_shape(std::move(made), key);
  return found;
}

// A ball on an arc in an upright plane: false if it is none.
bool SweepBuilder::add_curtain(SweepRef& ref, const LocalMotion& l, const Profile& tool) {
  if (!tool.is_ball_end() || !is_upright(l)) return false;
  const Vec3 axis = cross(l.u, l.v);
  const double reach = std::sqrt(length(axis));
  BallArc row;
  row.center = l.center + Vec3{0, 0, tool.round()};
  const double plan = std::sqrt(axis.x * axis.x + axis.y * axis.y);
  row.along_x = axis.y / plan, row.along_y = -axis.x / plan;
  row.ball = tool.round();
  row.length = reach * l.sweep;
  const double turn = std::min(l.sweep, kTwoPi);
  const double start = mrsim::atan2(l.u.z, l.u.x * row.along_x + l.u.y * row.along_y);
  const double way = l.v.z * (l.u.x * row.along_x + l.u.y * row.along_y) -
                     l.u.z * (l.v.x * row.along_x + l.v.y * row.along_y);
  const double from = way < 0 ? start - turn : start;
  row.whole = make_curtain(reach, from, turn);
  row.halves[0] = make_curtain(reach, from, turn / 2);
  row.halves[1] = make_curtain(reach, from + turn / 2, turn / 2);
  ref.split = l.sweep < kTwoPi && (l.sweep > kPi || tool.round() > reach || overhangs(row.whole));
  ref.kind = SweepKind::ball_arc;
  ref.row = static_cast<std::uint32_t>(columns_.ball_arcs.size());
  columns_.ball_arcs.push_back(row);
  return true;
}

void SweepBuilder::add_path(SweepRef& ref, LocalMotion l, const Profile& tool) {
  if (add_curtain(ref, l, tool)) return;
  if (!l.arc && tool.is_ball_end()) {
    LineRecord row;
    const double dx = l.end.x - l.start.x, dy = l.end.y - l.start.y;
    const double n = std::sqrt(dx * dx + dy * dy);
    row.c[BallSlot::x] = l.start.x, row.c[BallSlot::y] = l.start.y;
    row.c[BallSlot::z] = (n > kNoTravel ? l.start.z : std::min(l.start.z, l.end.z)) + tool.round();
    row.c[BallSlot::ux] = n > kNoTravel ? dx / n : 1,
    row.c[BallSlot::uy] = n > kNoTravel ? dy / n : 0;
    row.c[BallSlot::length] = n > kNoTravel ? n : 0;
    row.c[BallSlot::slope] = n > kNoTravel ? (l.end.z - l.start.z) / n : 0;
    row.c[BallSlot::radius] = tool.round();
    ref.kind = SweepKind::ball_line;
    ref.row = static_cast<std::uint32_t>(columns_.ball_lines.size());
    columns_.ball_lines.push_back(row);
    return;
  }
  ToolPath path;
  path.arc = l.arc;
  if (l.arc) {
    path.horizontal = l.u.z * l.u.z + l.v.z * l.v.z < kNoTravel * kNoTravel &&
                      l.rise.x * l.rise.x + l.rise.y * l.rise.y < kNoTravel * kNoTravel;
    path.lowest_turn = path.horizontal && tool.is_rising();
    if (path.lowest_turn) keep_lowest_turn(l);
    path.center = l.center, path.u = l.u, path.v = l.v, path.rise = l.rise, path.sweep = l.sweep;
    path.radius = length(l.u);
    path.speed = std::sqrt(path.radius * path.radius + dot(l.rise, l.rise));
    const SinCos last = sincos(path.sweep);
    path.last = {last.cos, last.sin};
    path.bored = path.lowest_turn && path.sweep >= kTwoPi && tool.is_end_mill();
    if (tool.is_rising() && is_upright(l)) set_upright(path, tool);
  } else {
    path.start = l.start;
    path.travel = l.end - l.start;
    path.speed = length(path.travel);
  }
  path.disc = is_disc_helix(tool, path);
  const bool exact = l.arc ? has_stretches(tool, path) : tool.is_convex();
  allow(exact ? kClosedError : kPathError);
  ref.kind = SweepKind::path;
  ref.row = static_cast<std::uint32_t>(columns_.paths.size());
  columns_.paths.push_back(path);
}

void SweepBuilder::add_turning(SweepRef ref, const Motion& m, const Tool& tool) {
  const double off = std::max({std::fabs(m.start.y), std::fabs(m.end.y), std::fabs(m.center.y)});
  if (off > kRounding) unsupported(m, tool, "a turning tool moves in the plane of X and Z only");
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
  columns_.bounds[static_cast<std::size_t>(ref.kind)].push_back(
      {{-reach, -reach, s.lo.y}, {reach, reach, s.hi.y}});
}

}  // namespace mrsim
