// G41 and G42 offset the contour by the tool radius. A move depends on the next ones: an inside
// corner ends where the offset elements meet, and an element that has no room left is left out.
#include "interp/path/compensation.h"

#include "core/numbers/rounding.h"
#include "core/numbers/units.h"
#include "interp/path/offset_contour.h"
#include "interp/path/stepwise_corners.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kNoTurn = 1e-9;      // mm^2: cross product of lines that are parallel
constexpr double kFullCircle = 1e-6;  // rad: an arc this near to a turn is a full circle
constexpr double kLeastUncut = 1e-4;  // rad: less of a circle that is not cut is not reported

// Makes an arc begin at `cursor`, earlier on its circle, where the corner before it ends.
void begin_at(PlanePiece& piece, Vec2 cursor) {
  if (!piece.arc || std::abs(length(cursor - piece.center) - piece.radius) > kTouch) return;
  const double late = progress(piece, piece.start, cursor);
  if (late >= 0) return;
  piece.sweep += piece.sweep < 0 ? late : -late;
  piece.start = cursor;
}

bool behind(const Compensation& comp, Vec2 tangent, Vec2 corner, Vec2 outer) {
  return comp.side * cross(tangent, outer - corner) < -kTouch;
}

}  // namespace

void CompensationStage::push(const PathMove& move) {
  if (ahead_.empty() && !active_ && move.comp.side == 0) {
    at_ = move.motion.end;
    next_(move);
    return;
  }
  if (ahead_.empty() && !active_) basis_ = move.basis;
  ahead_.push(move);
  same_axes(ahead_.back());
  settle(false);
}

// A frame may turn or mirror the plane's axes between two moves, but a corner needs both elements
// in the same axes.
void CompensationStage::same_axes(PathMove& move) const {
  const Basis& b = move.basis;
  if (length(b.w - basis_.w) > kTurnRounding) return;
  if (dot(cross(b.u, b.v), cross(basis_.u, basis_.v)) < 0) move.comp.side = -move.comp.side;
  move.basis = basis_;
}

void CompensationStage::flush() {
  settle(true);
  ahead_.clear();
  active_ = false;
}

void CompensationStage::settle(bool last) {
  while (ahead_.ready(last)) {
    const PathMove& first = ahead_.front();
    if (is_tilted(first) && (active_ || first.comp.side != 0))
      reporter_.add_at(Severity::error, "comp-plane",
                       "radius compensation needs arcs in its own plane (alarm 10760)",
                       first.motion);
    if (!active_)
      enter();
    else if (takes_part(first))
      follow();
    else
      leave_or_shift();
    ahead_.pop();
  }
}

void CompensationStage::send(PathMove move, const PlanePiece& piece, double end_height) {
  const Basis& b = move.basis;
  PlanePiece shown = piece;
  const Vec2 tip = active_ ? move.comp.tip : Vec2{};
  shown.start = in_plane(b, at_);
  shown.end = piece.end - tip;
  shown.center = piece.center - tip;
  const double from = dot(at_, b.w);
  if (!shown.arc && length(shown.end - shown.start) <= kRounding &&
      std::abs(end_height - from) <= kRounding)
    return;
  const Vec3 start = at_;
  from_piece(shown, b, from, end_height, move.motion);
  move.motion.start = start;
  at_ = move.motion.end;
  next_(move);
}

void CompensationStage::send_line(const PathMove& like, Vec2 to, double end_height) {
  PathMove move = like;
  if (move.motion.kind == MotionKind::arc) move.motion.kind = MotionKind::line;
  PlanePiece line;
  line.end = to;
  send(move, line, end_height);
  cursor_ = to;
}

// The first compensated move leads straight to the point square to the contour at the next start.
void CompensationStage::enter() {
  const PathMove& first = ahead_.front();
  if (!takes_part(first)) {
    at_ = first.motion.end;
    next_(first);
    return;
  }
  at_ = first.motion.start;
  if (!first.comp.stepwise) ahead_.skip_void_entry();
  const std::size_t j = ahead_.following(1);
  active_ = true;
  const double h = height(first, first.motion.end);
  if (j >= ahead_.size()) return send_line(first, moved(first).end, h);
  if (first.comp.stepwise) return enter_beside(h);
  const PlanePiece next = moved(ahead_[j]);
  if (is_point(next)) return send_line(first, next.center, h);
  if (is_void(next)) return send_line(first, moved(first).end, h);
  const Vec2 corner = corner_of(first), outer = in_plane(first.basis, at_) + first.comp.tip;
  PlanePiece line;
  if (!first.comp.around || !behind(first.comp, start_tangent(next), corner, outer) ||
      !touching_line(first.comp, corner, outer, false, line))
    return send_line(first, next.start, h);
  const PathMove before = first;
  const CornerWay way = outside_corner(before.comp, corner, line, next);
  send_line(before, way.end, h);
  run_corner(before, way);
}

// Runs a move that is not itself compensated while compensation is on: infeeds, CUTCONON, G40.
void CompensationStage::leave_or_shift() {
  PathMove first = ahead_.front();
  const Vec3 w = first.basis.w;
  if (is_infeed(first)) {
    const Vec3 start = at_;
    at_ = at_ + (height(first, first.motion.end) - dot(at_, w)) * w;
    first.motion.start = start;
    first.motion.end = at_;
    if (distance(start, at_) > kRounding) next_(first);
    return;
  }
  if (first.comp.side == 0) {
    active_ = false;
    const bool arc = first.motion.kind == MotionKind::arc;  // a rounding that took the whole line
    if (arc) send_line(first, in_plane(first.basis, first.motion.start), dot(at_, w));
    first.motion.start = at_;
    at_ = first.motion.end;
    if (arc || distance(first.motion.start, at_) > kRounding) next_(first);
    return;
  }
  const Vec3 shift = at_ - first.motion.start;
  first.motion.start = at_;
  first.motion.end = first.motion.end + shift;
  first.motion.center = first.motion.center + shift;
  at_ = first.motion.end;
  cursor_ = in_plane(first.basis, at_) + first.comp.tip;
  resumes_ = true;
  next_(first);
}

// On LinuxCNC the entry is an element like others, and must be longer than the radius. Where the
// tool is not beside a line, that line may end any distance before its start.
void CompensationStage::enter_beside(double h) {
  const PathMove first = ahead_.front();
  const Vec2 start = in_plane(first.basis, at_) + first.comp.tip;
  const double travel = length(corner_of(first) - start);
  if (travel <= first.comp.radius && first.comp.radius > 0)
    reporter_.add_at(Severity::error, "comp-entry",
                     fmt::format("the entry into compensation is {:.6g} long and must be longer "
                                 "than the tool's radius {:.6g}",
                                 travel, first.comp.radius),
                     first.motion);
  PlanePiece piece = moved(first);
  if (piece.arc) {
    if (travel <= first.comp.radius || is_void(piece) || !lead_to_end(piece, start))
      return leave_void(first, h);
  }
  cursor_ = piece.arc ? start : piece.start - kFarBack * end_tangent(piece);
  const CornerWay way = choose_end(piece);
  if (piece.arc)
    run_piece(first, piece, way.end, h);
  else
    send_line(first, way.end, h);
  run_corner(first, way);
}

// Leads to an arc behind so small a turn that the element before it ends beside its circle.
void CompensationStage::step_onto(const PathMove& first, const PlanePiece& arc) {
  const Vec2 out = cursor_ - arc.center;
  send_line(first, arc.center + (arc.radius / length(out)) * out, dot(at_, first.basis.w));
}

// Infeeds between the first of the queue and the next contour element happen before its corner.
void CompensationStage::run_infeeds() {
  while (ahead_.size() > 1 && is_infeed(ahead_[1])) {
    std::swap(ahead_[0], ahead_[1]);
    leave_or_shift();
    ahead_.pop();
  }
}

void CompensationStage::follow() {
  const PathMove first = ahead_.front();
  PlanePiece piece = moved(first);
  const double h = height(first, first.motion.end);
  const std::size_t after = ahead_.following(1);
  if (is_point(piece) && (after >= ahead_.size() || nearly_tangent(first, ahead_[after])))
    return send_line(first, piece.center, h);
  if (is_void(piece)) return leave_void(first, h);
  const bool off_arc = piece.arc && length(cursor_ - piece.start) > kTouch &&
                       std::abs(length(cursor_ - piece.center) - piece.radius) > kTouch;
  if (off_arc && first.comp.stepwise)
    step_onto(first, piece);
  else if (resumes_ || off_arc)  // bridge the gap that CUTCONON left
    send_line(first, piece.start, dot(at_, first.basis.w));
  resumes_ = false;
  begin_at(piece, cursor_);
  const CornerWay way = choose_end(piece);
  run_piece(first, piece, way.end, h);
  run_corner(first, way);
}

// Runs an arc for which the tool is too large.
void CompensationStage::leave_void(const PathMove& first, double h) {
  reporter_.add_at(Severity::error, "comp-interference",
                   fmt::format("the tool of radius {:.6g} does not fit into the arc of radius "
                               "{:.6g}",
                               first.comp.radius, first.motion.radius),
                   first.motion);
  send_line(first, in_plane(first.basis, first.motion.end), h);
}

// Decides where the first element of the queue ends, and which way leads to the next one.
CornerWay CompensationStage::choose_end(const PlanePiece& piece) {
  CornerWay way;
  way.end = piece.end;
  const std::size_t j = ahead_.following(1);
  const PathMove& first = ahead_.front();
  if (j >= ahead_.size()) {
    if (first.comp.stepwise && turns_round(piece, cursor_, piece.end))
      corner_too_tight(first.motion);
    return crosses_over(piece, way) ? way : leaving(piece);
  }
  const PlanePiece next = moved(ahead_[j]);
  if (first.comp.stepwise) {
    bool too_tight = false;
    way = stepwise_way(first, piece, ahead_[j], cursor_, too_tight);
    if (too_tight) corner_too_tight(ahead_[j].motion);
    return way;
  }
  const Corner kind = is_void(next) ? Corner::inside : corner_kind(first, ahead_[j]);
  if (kind == Corner::outside) {
    way = outside_corner(first.comp, corner_of(first), piece, next);
    if (ahead_.squeezed(j, ahead_.following(2), way.entry)) ahead_.close_over(piece, cursor_, way);
    return way;
  }
  if (kind == Corner::smooth || ahead_.meet_inside(piece, cursor_, 1, way) ||
      nearly_tangent(first, ahead_[j]))
    return way;
  corner_too_tight(ahead_[j].motion);
  return way;
}

void CompensationStage::corner_too_tight(const Motion& next) {
  const Compensation& comp = ahead_.front().comp;
  reporter_.add_at(Severity::error, "comp-interference",
                   fmt::format("the tool of radius {:.6g} does not fit into this inside corner{}",
                               comp.radius, comp.two_points ? " (alarm 041)" : ""),
                   next);
}

// G41 follows G42, or G42 follows G41, without G40. FANUC goes to where the offset lines meet. Else
// the element ends square to its end, and a line leads to the point square to the start of the next
// one.
bool CompensationStage::crosses_over(const PlanePiece& piece, CornerWay& way) {
  std::size_t k = 1;
  while (k < ahead_.size() && is_infeed(ahead_[k])) ++k;
  const PathMove& first = ahead_.front();
  if (k >= ahead_.size() || !takes_part(ahead_[k]) || ahead_[k].comp.side == first.comp.side)
    return false;
  const PlanePiece next = moved(ahead_[k]);
  const Vec2 d = piece.end - piece.start, e = next.end - next.start;
  const double turn = cross(d, e);
  if (first.comp.two_points && !piece.arc && !next.arc && std::abs(turn) > kNoTurn) {
    const double along = cross(next.start - piece.start, e) / turn;
    const double beyond = cross(next.start - piece.start, d) / turn;
    if (along > 0 && beyond < 1) {
      way.end = piece.start + along * d;
      return true;
    }
  }
  resumes_ = true;
  return true;
}

// The way out of the last element ends square to its end, or with KONT behind the contour.
CornerWay CompensationStage::leaving(const PlanePiece& piece) const {
  CornerWay way;
  way.end = piece.end;
  std::size_t k = 1;
  while (k < ahead_.size() && is_infeed(ahead_[k])) ++k;
  if (k >= ahead_.size() || ahead_[k].comp.side != 0 || !ahead_[k].comp.around) return way;
  const PathMove& first = ahead_.front();
  Compensation comp = ahead_[k].comp;  // the block that leaves decides the form of the corner
  comp.side = first.comp.side;
  comp.radius = first.comp.radius;
  const Vec2 outer = corner_of(ahead_[k]) + first.comp.tip;
  PlanePiece line;
  if (!behind(comp, end_tangent(piece), corner_of(first), outer) ||
      !touching_line(comp, corner_of(first), outer, true, line))
    return way;
  return outside_corner(comp, corner_of(first), piece, line);
}

// Runs the piece from where the tool is to `end`.
void CompensationStage::run_piece(const PathMove& first, PlanePiece piece, Vec2 end, double h) {
  if (piece.arc) {
    const double full = std::abs(piece.sweep);
    const double late = progress(piece, piece.start, cursor_),
                 early = progress(piece, end, piece.end);
    const double left = full - late - early;
    if (left <= 0) {
      reporter_.add_at(Severity::error, "comp-interference",
                       "nothing is left of the arc: its inside corners overlap", first.motion);
      return send_line(first, end, h);
    }
    if (std::abs(full - kTwoPi) < kFullCircle && left < full - kLeastUncut)
      reporter_.add_at(
          Severity::warning, "comp-circle-open",
          fmt::format("{:.1f}\u00B0 of the circle are not cut: the compensated path enters "
                      "or leaves it at an inside corner",
                      degrees(full - left)),
          first.motion);
    piece.sweep = piece.sweep < 0 ? -left : left;
  }
  piece.end = end;
  send(first, piece, h);
  cursor_ = end;
}

// Runs the way round a corner, which belongs to the next block.
void CompensationStage::run_corner(const PathMove& before, const CornerWay& way) {
  if (way.count == 0) return;
  run_infeeds();
  if (ahead_.size() < 2) return;
  PathMove between = ahead_[1];
  between.corner = {};
  between.comp = before.comp;
  const double h = dot(at_, between.basis.w);
  for (std::size_t i = 0; i < way.count; ++i) {
    send(between, way.between[i], h);
    cursor_ = way.between[i].end;
  }
}

}  // namespace mrsim
