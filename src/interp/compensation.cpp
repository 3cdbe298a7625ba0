// G41 and G42: the contour moved aside by the tool radius. Each move needs to see the next ones: an
// inside corner ends where the moved elements meet, and an element that has no room left is void.
#include "core/trig.h"
#include "core/units.h"
#include "interp/arc.h"
#include "interp/contour.h"
#include "interp/offset_contour.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
constexpr std::size_t kLookAhead = 5;  // compensated moves seen at once

void CompensationStage::push(const PathMove& move) {
  if (queue_.empty() && !active_ && move.comp.side == 0) {
    at_ = move.motion.end;
    next_(move);
    return;
  }
  queue_.push_back(move);
  settle(false);
}

void CompensationStage::flush() {
  settle(true);
  queue_.clear();
  active_ = false;
}

// Index in the queue of the n-th following move that takes part (n >= 1), or queue size.
std::size_t CompensationStage::following(std::size_t n) const {
  std::size_t i = 1;
  for (; i < queue_.size(); ++i) {
    if (is_infeed(queue_[i])) continue;
    if (!takes_part(queue_[i])) return queue_.size();
    if (queue_[i].comp.side != queue_[0].comp.side) return queue_.size();
    if (--n == 0) return i;
  }
  return queue_.size();
}

// True when enough is known to move the first of the queue.
bool CompensationStage::ready(bool last) const {
  if (queue_.empty()) return false;
  if (last || !takes_part(queue_.front()) || queue_.size() > 64) return true;
  std::size_t planar = 0;
  for (std::size_t i = 1; i < queue_.size(); ++i) {
    if (is_infeed(queue_[i])) continue;
    if (!takes_part(queue_[i])) return true;
    if (++planar >= kLookAhead) return true;
  }
  return false;
}

void CompensationStage::settle(bool last) {
  while (ready(last)) {
    const PathMove& first = queue_.front();
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
    queue_.erase(queue_.begin());
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
  if (!shown.arc && length(shown.end - shown.start) <= 1e-9 && std::abs(end_height - from) <= 1e-9)
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

// The first move's own rounding, too small for the tool: the element after it is approached.
void CompensationStage::skip_void_entry() {
  const std::size_t j = following(1), next = following(2);
  if (next >= queue_.size() || queue_[j].block != queue_.front().block) return;
  if (!is_void(moved(queue_[j])) || is_void(moved(queue_[next]))) return;
  reporter_.add_at(Severity::warning, "comp-element-void",
                   "the tool is too large to reach this element: it is skipped", queue_[j].motion);
  queue_.erase(queue_.begin() + static_cast<std::ptrdiff_t>(j));
}

// The first compensated move: straight to the point square to the contour at the next start.
void CompensationStage::enter() {
  const PathMove& first = queue_.front();
  if (!takes_part(first)) {
    at_ = first.motion.end;
    next_(first);
    return;
  }
  at_ = first.motion.start;
  skip_void_entry();
  const std::size_t j = following(1);
  active_ = true;
  const double h = height(first, first.motion.end);
  if (j < queue_.size()) {
    const PlanePiece next = moved(queue_[j]);
    if (!is_void(next)) return send_line(first, next.start, h);
  }
  send_line(first, moved(first).end, h);
}

// A move of an active compensation that is not itself compensated: infeeds, CUTCONON, G40.
void CompensationStage::leave_or_shift() {
  PathMove first = queue_.front();
  const Vec3 w = first.basis.w;
  if (is_infeed(first)) {
    const Vec3 start = at_;
    at_ = at_ + (height(first, first.motion.end) - dot(at_, w)) * w;
    first.motion.start = start;
    first.motion.end = at_;
    if (distance(start, at_) > 1e-9) next_(first);
    return;
  }
  if (first.comp.side == 0) {
    active_ = false;
    first.motion.start = at_;
    at_ = first.motion.end;
    if (distance(first.motion.start, at_) > 1e-9) next_(first);
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

// The moved element, run on to the intersection where its end is such an outside corner.
PlanePiece CompensationStage::reach(std::size_t i, std::size_t next) const {
  PlanePiece piece = moved(queue_[i]);
  if (piece.arc || next >= queue_.size()) return piece;
  const PlanePiece after = moved(queue_[next]);
  if (is_void(after) || corner_kind(queue_[i], queue_[next]) != Corner::outside) return piece;
  piece.end = extended_end(piece, after);
  return piece;
}

// A void element: between the meeting points with its neighbours nothing of it is left.
bool CompensationStage::squeezed(std::size_t i, std::size_t next, Vec2 entered) const {
  const PlanePiece piece = moved(queue_[i]);
  if (is_void(piece)) return true;
  if (next >= queue_.size() || corner_kind(queue_[i], queue_[next]) != Corner::inside) return false;
  const PlanePiece after = moved(queue_[next]);
  if (is_void(after)) return false;
  std::array<Vec2, 2> hits;
  const int n = intersect(piece, after, hits);
  if (n == 0) return false;
  Vec2 out = hits[0];
  if (n == 2 && length(hits[1] - piece.end) < length(hits[0] - piece.end)) out = hits[1];
  if (piece.arc && std::abs(piece.sweep) > kPi) return false;
  return progress(piece, entered, out) < -kTouch / (piece.arc ? piece.radius : 1);
}

// The first of the following elements with room that `piece` meets, or the arc round the corner
// behind one (then `round` is set). What lies between is void and leaves the queue. False: the tool
// does not fit.
bool CompensationStage::meet_inside(const PlanePiece& piece, std::size_t nearest, Vec2& end,
                                    bool& round) {
  for (std::size_t n = nearest; n < kLookAhead; ++n) {
    const std::size_t j = following(n), next = following(n + 1);
    if (j >= queue_.size()) return false;
    const PlanePiece other = reach(j, next);
    Vec2 p;
    std::size_t keep = 0;
    round = false;
    if (!is_void(other) && meeting(piece, other, cursor_, piece.end, p) && !squeezed(j, next, p))
      keep = j;
    if (keep == 0 && next < queue_.size() &&
        corner_kind(queue_[j], queue_[next]) == Corner::outside && queue_[j].comp.arcs &&
        !is_void(other) && !is_void(moved(queue_[next]))) {
      round =
          meeting(piece, corner_arc(queue_[j], other, moved(queue_[next])), cursor_, piece.end, p);
      if (round) keep = next;
    }
    if (keep == 0) continue;
    end = p;
    for (std::size_t k = keep; k-- > 1;)
      if (!is_infeed(queue_[k])) {
        reporter_.add_at(Severity::warning, "comp-element-void",
                         "the tool is too large to reach this element: it is skipped",
                         queue_[k].motion);
        queue_.erase(queue_.begin() + static_cast<std::ptrdiff_t>(k));
      }
    return true;
  }
  return false;
}

PlanePiece CompensationStage::corner_arc(const PathMove& first, const PlanePiece& piece,
                                         const PlanePiece& next) const {
  PlanePiece arc;
  arc.arc = true;
  arc.center = in_plane(first.basis, first.motion.end);
  arc.radius = first.comp.radius;
  arc.start = piece.end;
  arc.end = next.start;
  arc.sweep = fold_sweep(piece.end - arc.center, next.start - arc.center, first.comp.side < 0);
  return arc;
}

// Infeeds between the first of the queue and the next contour element happen before its corner.
void CompensationStage::run_infeeds() {
  while (queue_.size() > 1 && is_infeed(queue_[1])) {
    std::swap(queue_[0], queue_[1]);
    leave_or_shift();
    queue_.erase(queue_.begin());
  }
}

void CompensationStage::follow() {
  const PathMove first = queue_.front();
  PlanePiece piece = moved(first);
  const double h = height(first, first.motion.end);
  if (is_void(piece)) {
    reporter_.add_at(
        Severity::error, "comp-interference",
        fmt::format("the tool of radius {:.6g} does not fit into the arc of radius {:.6g}",
                    first.comp.radius, first.motion.radius),
        first.motion);
    return send_line(first, in_plane(first.basis, first.motion.end), h);
  }
  const bool off_arc = piece.arc && length(cursor_ - piece.start) > kTouch &&
                       std::abs(length(cursor_ - piece.center) - piece.radius) > kTouch;
  if (resumes_ || off_arc)  // bridge the gap that CUTCONON left
    send_line(first, piece.start, dot(at_, first.basis.w));
  resumes_ = false;
  Vec2 end = piece.end;
  bool corner = false, round = false;
  choose_end(piece, end, corner, round);
  const PathMove before = queue_.front();
  run_piece(before, piece, end, h);
  if (!corner && !round) return;
  run_infeeds();
  const std::size_t j = following(1);
  if (j >= queue_.size()) return;
  if (corner) return round_outside(before, queue_[j], piece);
  PlanePiece arc = corner_arc(before, piece, moved(queue_[j]));
  arc.center = in_plane(queue_[j].basis, queue_[j].motion.start);
  arc.start = end;
  arc.sweep = fold_sweep(end - arc.center, arc.end - arc.center, before.comp.side < 0);
  send_corner(queue_[j], arc);
}

// Where the first element of the queue ends: inside corners and void elements; `corner`: a way
// round an outside corner follows; `round`: the rest of a later corner's arc follows.
void CompensationStage::choose_end(const PlanePiece& piece, Vec2& end, bool& corner, bool& round) {
  const std::size_t j = following(1);
  if (j >= queue_.size()) return;
  const PathMove& first = queue_.front();
  const PlanePiece next = moved(queue_[j]);
  const Corner kind = is_void(next) ? Corner::inside : corner_kind(first, queue_[j]);
  if (kind == Corner::outside) {
    // An element that the corner after it leaves no room for is skipped, if that closes the path.
    if (squeezed(j, following(2), next.start) && meet_inside(piece, 2, end, round)) return;
    corner = true;
    if (!piece.arc) end = extended_end(piece, next);
    return;
  }
  if (kind == Corner::smooth) return;
  if (meet_inside(piece, 1, end, round) || nearly_tangent(first, queue_[j])) return;
  reporter_.add_at(Severity::error, "comp-interference",
                   fmt::format("the tool of radius {:.6g} does not fit into this inside corner{}",
                               first.comp.radius, first.comp.two_points ? " (alarm 041)" : ""),
                   queue_[j].motion);
}

// The piece from where the tool is to `end`.
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
    if (full > kTwoPi - 1e-6 && left < full - 1e-4)
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

// Outside, straight element: how far it runs on.
Vec2 CompensationStage::extended_end(const PlanePiece& piece, const PlanePiece& next) const {
  const PathMove& first = queue_.front();
  const Vec2 t1 = end_tangent(piece), t2 = start_tangent(next);
  const double turn = std::abs(fold_sweep(t1, t2, cross(t1, t2) >= 0));
  if (turn <= first.comp.sharpest + 1e-9 && !first.comp.arcs)
    return piece.end + (first.comp.radius * half_tangent(turn)) * t1;
  if (first.comp.two_points && !first.comp.arcs) return piece.end + first.comp.radius * t1;
  return piece.end;
}

double CompensationStage::half_tangent(double turn) {
  const SinCos half = sincos(turn / 2);
  return half.sin / half.cos;
}

// The way round an outside corner; it belongs to the next block.
void CompensationStage::round_outside(const PathMove& first, const PathMove& after,
                                      const PlanePiece& piece) {
  const PlanePiece next = moved(after);
  const Vec2 t1 = end_tangent(piece), t2 = start_tangent(next);
  const double r = first.comp.radius, h = dot(at_, first.basis.w);
  const double turn = std::abs(fold_sweep(t1, t2, cross(t1, t2) >= 0));
  PathMove between = after;
  between.corner = {};
  if (between.motion.kind == MotionKind::arc) between.motion.kind = MotionKind::line;
  if (!first.comp.arcs && (turn <= first.comp.sharpest + 1e-9 || first.comp.two_points)) {
    const bool meets = turn <= first.comp.sharpest + 1e-9;
    const double out = meets ? r * half_tangent(turn) : r;
    if (piece.arc) send_line(between, piece.end + out * t1, h);
    if (!meets) send_line(between, next.start - out * t2, h);
    if (next.arc) send_line(between, next.start, h);
    return;
  }
  send_corner(after, corner_arc(first, piece, next));
}

void CompensationStage::send_corner(const PathMove& after, const PlanePiece& arc) {
  PathMove between = after;
  between.corner = {};
  const double h = dot(at_, after.basis.w);
  send(between, arc, h);
  cursor_ = arc.end;
}

}  // namespace mrsim
