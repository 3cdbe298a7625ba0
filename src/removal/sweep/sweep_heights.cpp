#include "removal/sweep/sweep_heights.h"

#include "core/numbers/angles.h"
#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "removal/columns/height_segments.h"
#include "removal/columns/sweep_columns.h"
#include "removal/simd/scalar_forms.h"
#include "removal/sweep/arc_heights.h"
#include "removal/sweep/rising_heights.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr double kFound = kPathError;  // mm: to which a height is searched, as distances are
constexpr int kMostSteps = 80;

constexpr double kSlack = 1e-6;  // mm: above the error of distances

Underside::Slant seen_from(double dx, double dy, double ux, double uy) {
  return {.u = dx * ux + dy * uy, .v = std::fabs(dx * uy - dy * ux)};
}

Underside::Slant seen_from(double x, double y, const double* segment) {
  Underside::Slant at = seen_from(x - segment[BallSlot::x], y - segment[BallSlot::y],
                                  segment[BallSlot::ux], segment[BallSlot::uy]);
  at.length = segment[BallSlot::length], at.slope = segment[BallSlot::slope];
  return at;
}

Underside::Bounds slant_bounds(const Underside& tool, const Underside::Slant& at, double r,
                               double below) {
  return tool.is_convex() ? tool.bounds(at, r, below) : rising_bounds(tool, at, r, below);
}

// The tip's path.
ToolPath path_of(const BallArc& arc) {
  const Curtain& c = arc.whole;
  const Vec2 from{c.mid_x * c.cos_half + c.mid_y * c.sin_half,
                  c.mid_y * c.cos_half - c.mid_x * c.sin_half};
  const auto in_space = [&](double x, double y) {
    return c.radius * Vec3{x * arc.along_x, x * arc.along_y, y};
  };
  ToolPath path;
  path.arc = true;
  path.center = arc.center - Vec3{0, 0, arc.ball};
  path.u = in_space(from.x, from.y), path.v = in_space(-from.y, from.x);
  path.sweep = 2 * mrsim::atan2(c.sin_half, c.cos_half), path.radius = c.radius;
  return path;
}

}  // namespace

bool is_upward(const SweepTable& sweeps, std::uint32_t i) {
  const SweepRef& ref = sweeps.columns().refs[i];
  return ref.kind != SweepKind::turn && ref.frame == 0 && sweeps.columns().cutter(ref).is_rising();
}

SweepUndersides::SweepUndersides(const SweepTable& sweeps) {
  for (const ToolShape& shape : sweeps.columns().shapes)
    tools_.push_back(!shape.turning && shape.cutter.is_rising() ? Underside(shape.cutter)
                                                                : Underside());
}

void SweepHeights::assign(std::span<const std::uint32_t> sweeps) {
  rows_.clear(), segments_.clear();
  for (const std::uint32_t i : sweeps) rows_.push_back(row_of(i));
  find_runs();
  balls_.clear();
  if (!std::ranges::all_of(
          rows_, [](const Row& row) { return row.form == Form::slant && row.tool->is_ball(); }))
    return;
  for (const Row& row : rows_)
    balls_.push_back(
        {{row.x, row.y, row.z, row.ux, row.uy, row.length, row.slope, row.tool->radius()}});
}

void SweepHeights::find_runs() {
  const SweepColumns& c = sweeps_.columns();
  runs_.clear();
  run_of_.assign(rows_.size(), kNoRun);
  std::uint32_t last = 0;  // pack
  for (std::uint32_t index = 0; index < rows_.size(); ++index) {
    const Row& row = rows_[index];
    const std::uint32_t pack = c.packs.leaf_of(row.sweep);
    if (pack == 0 || row.form != Form::slant || c.refs[row.sweep].kind != SweepKind::path) {
      last = 0;
      continue;
    }
    if (pack != last) {
      Run& run = runs_.emplace_back();
      const double* segment = c.packs.chord(pack).c;
      run.chord = row;
      run.chord.x = segment[BallSlot::x], run.chord.y = segment[BallSlot::y],
      run.chord.z = segment[BallSlot::z];
      run.chord.ux = segment[BallSlot::ux], run.chord.uy = segment[BallSlot::uy];
      run.chord.length = segment[BallSlot::length], run.chord.slope = segment[BallSlot::slope];
      run.plan = c.packs[pack].spread + kSlack, run.up = segment[BallSlot::error] + kSlack;
      last = pack;
    }
    runs_.back().end = index + 1;
    run_of_[index] = static_cast<std::uint32_t>(runs_.size() - 1);
  }
}

Underside::Slant SweepHeights::seen(const Row& row, double x, double y) {
  Underside::Slant at = seen_from(x - row.x, y - row.y, row.ux, row.uy);
  at.length = row.length, at.slope = row.slope;
  return at;
}

double SweepHeights::run_lower(std::uint32_t index, double x, double y, double r,
                               double below) const {
  const Run& run = runs_[run_of_[index]];
  const Row& row = run.chord;
  const double above = run.up - row.z;  // of a height, as the chord's tip sees it
  return row.tool->bounds(seen(row, x, y), r + run.plan, below + above).lower - above;
}

SweepHeights::Row SweepHeights::row_of(std::uint32_t sweep) {
  const SweepColumns& c = sweeps_.columns();
  const SweepRef& ref = c.refs[sweep];
  Row row{.sweep = sweep, .tool = &tools_[ref.shape]};
  if (ref.kind == SweepKind::ball_line) {
    const double* r = c.ball_lines[ref.row].c;
    const Vec3 start{r[BallSlot::x], r[BallSlot::y], r[BallSlot::z] - r[BallSlot::radius]};
    set_slant(
        row, start,
        start + r[BallSlot::length] * Vec3{r[BallSlot::ux], r[BallSlot::uy], r[BallSlot::slope]});
  } else if (ref.kind == SweepKind::plane_line) {
    const double* r = c.plane_lines[ref.row].c;
    row.form = Form::horizontal, row.z = r[LineSlot::low] - r[LineSlot::round];
  } else if (ref.kind == SweepKind::plane_arc) {
    const double* r = c.plane_arcs[ref.row].c;
    row.form = Form::horizontal, row.z = r[ArcSlot::low] - r[ArcSlot::round];
  } else if (ref.kind == SweepKind::ball_arc) {
    set_segments(row, path_of(c.ball_arcs[ref.row]));
  } else if (ref.kind == SweepKind::profile) {
    row.form = Form::horizontal, row.z = c.profiles[ref.row].z;
  } else if (ref.kind == SweepKind::path) {
    const bool line = c.paths.is_line(ref.row);
    if (line)
      set_slant(row, c.paths.line(ref.row).start, c.paths.line(ref.row).end());
    else
      set_arc(row, c.paths.arc(ref.row));
  }
  return row;
}

void SweepHeights::set_slant(Row& row, const Vec3& start, const Vec3& end) const {
  const Vec3 &low = start.z <= end.z ? start : end, &high = start.z <= end.z ? end : start;
  const double dx = high.x - low.x, dy = high.y - low.y, plan = std::sqrt(dx * dx + dy * dy);
  row.form = row.tool->is_convex() ? Form::slant : Form::rising_slant;
  row.x = low.x, row.y = low.y, row.z = low.z;
  if (plan < kRounding) return;
  row.ux = dx / plan, row.uy = dy / plan;
  row.length = plan, row.slope = (high.z - low.z) / plan;
}

void SweepHeights::set_arc(Row& row, const ToolPath& arc) {
  if (arc.lowest_turn && row.tool->is_flat())
    row.form = Form::bored, row.z = arc.center.z + arc.sweep * arc.rise.z;
  else
    set_segments(row, arc);
}

const ToolPath& SweepHeights::path(const Row& row) const {
  const SweepColumns& c = sweeps_.columns();
  return c.paths.arc(c.refs[row.sweep].row);
}

void SweepHeights::set_segments(Row& row, const ToolPath& path) {
  row.first = segments_.size();
  const bool has_chords =
      (row.tool->is_convex() || !path.horizontal) && append_segments(path, segments_);
  row.count = segments_.size() - row.first;
  if (path.horizontal)
    row.form = has_chords ? Form::helix : Form::rising_helix;
  else if (has_chords)
    row.form = Form::segments;
}

// Distance in plan from the path of a horizontal move.
double SweepHeights::rho(const Row& row, double x, double y) const {
  const SweepColumns& c = sweeps_.columns();
  const SweepRef& ref = c.refs[row.sweep];
  if (ref.kind == SweepKind::plane_line) return lane::line_rho(c.plane_lines[ref.row].c, x, y);
  if (ref.kind == SweepKind::plane_arc) return lane::arc_rho(c.plane_arcs[ref.row].c, x, y);
  const ProfileRow& profile = c.profiles[ref.row];
  return profile.arc ? lane::arc_rho(profile.c, x, y) : lane::line_rho(profile.c, x, y);
}

double SweepHeights::bottom(std::uint32_t index, double x, double y, double below) const {
  const Row& row = rows_[index];
  const bool has_lowest = row.form == Form::horizontal || row.form == Form::slant ||
                          row.form == Form::rising_slant || row.form == Form::bored;
  if (has_lowest && !(row.z < below)) return kInfinity;
  if (row.form == Form::horizontal) return row.z + row.tool->height(rho(row, x, y));
  if (row.form == Form::slant) return row.z + row.tool->bottom(seen(row, x, y), below - row.z);
  if (row.form == Form::bored) return bored_bottom(row, x, y, row.tool->radius());
  if (row.form == Form::rising_slant)
    return row.z + rising_bottom(*row.tool, seen(row, x, y), below - row.z);
  if (row.form == Form::rising_helix) return rising_bottom(*row.tool, path(row), x, y, below);
  const Underside::Bounds within = bounds(index, x, y, 0, below);
  if (!(within.lower < below)) return kInfinity;
  if (within.upper - within.lower <= close_) return 0.5 * (within.lower + within.upper);
  return row.form == Form::helix ? arc_bottom(*row.tool, path(row), x, y)
                                 : search(row.sweep, x, y, within);
}

Underside::Bounds SweepHeights::bounds(std::uint32_t index, double x, double y, double r,
                                       double below) const {
  const Row& row = rows_[index];
  if (row.form == Form::horizontal) {
    const double from = rho(row, x, y);
    return {row.z + row.tool->height(std::max(from - r, 0.0)), row.z + row.tool->height(from + r)};
  }
  if (row.form == Form::slant || row.form == Form::rising_slant) {
    const Underside::Bounds found = slant_bounds(*row.tool, seen(row, x, y), r, below - row.z);
    return {row.z + found.lower, row.z + found.upper};
  }
  if (row.form == Form::bored) {
    if (!(row.z < below)) return {row.z, kInfinity};
    return {bored_bottom(row, x, y, row.tool->radius() + r),
            bored_bottom(row, x, y, row.tool->radius() - r)};
  }
  if (row.form == Form::rising_helix) return rising_bounds(*row.tool, path(row), x, y, r, below);
  if (row.form == Form::segments || row.form == Form::helix)
    return segment_bounds(row, x, y, r, below);
  const Box3 box = sweeps_.bounds(row.sweep);
  const bool meets =
      x + r >= box.lo.x && x - r <= box.hi.x && y + r >= box.lo.y && y - r <= box.hi.y;
  return {meets ? box.lo.z : kInfinity, kInfinity};
}

// The path is within a segment's eps of the segment.
Underside::Bounds SweepHeights::segment_bounds(const Row& row, double x, double y, double r,
                                               double below) const {
  Underside::Bounds out;
  for (std::size_t k = row.first; k < row.first + row.count; ++k) {
    const double* segment = segments_[k].c;
    const double z = segment[BallSlot::z], eps = segment[BallSlot::error] + kSlack;
    const Underside::Bounds found = slant_bounds(*row.tool, seen_from(x, y, segment), r + eps,
                                                 std::min(below, out.upper) + eps - z);
    out.lower = std::min(out.lower, z + found.lower - eps);
    out.upper = std::min(out.upper, z + found.upper + eps);
  }
  return out;
}

// The lowest bottom of a cylinder on a falling helix of at most one turn: that of the last position
// within `radius` of the place.
double SweepHeights::bored_bottom(const Row& row, double x, double y, double radius) const {
  const ToolPath& path = this->path(row);
  const Vec3 off{x - path.center.x, y - path.center.y, 0};
  const double from = std::sqrt(dot(off, off)), turn = path.radius;
  if (radius < 0 || std::fabs(from - turn) > radius) return kInfinity;
  if (from + turn <= radius) return row.z;
  const double a = dot(off, path.u), b = dot(off, path.v);  // `turn` times the place about the axis
  // Positions within `radius` face the place up to an angle with this cosine.
  const double cosine = (from * from + turn * turn - radius * radius) / (2 * from * turn);
  if (a * path.last.x + b * path.last.y >= cosine * from * turn) return row.z;
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  const double end = wrapped_angle(mrsim::atan2(b * cosine + a * sine, a * cosine - b * sine));
  return end <= path.sweep ? path.center.z + end * path.rise.z : kInfinity;
}

// Searches the height at which the distance is 0. There is one, since distances do not grow
// upwards.
double SweepHeights::search(std::uint32_t sweep, double x, double y,
                            const Underside::Bounds& within) const {
  double low = std::max(low_, within.lower) - kFound, high = std::min(high_, within.upper);
  if (low >= high) return within.lower < high_ ? high : kInfinity;
  double below = sweeps_.distance(sweep, {x, y, low}),
         above = sweeps_.distance(sweep, {x, y, high});
  if (above > 0) return kInfinity;
  if (below <= 0) return low;
  for (int k = 0; k < kMostSteps && high - low > kFound; ++k) {
    double z = low + (high - low) * below / (below - above);
    if (k % 3 == 2 || !(z > low && z < high)) z = 0.5 * (low + high);
    const double d = sweeps_.distance(sweep, {x, y, z});
    if (d > 0)
      low = z, below = d, above *= 0.5;
    else
      high = z, above = d, below *= 0.5;
  }
  return high;
}

}  // namespace mrsim
