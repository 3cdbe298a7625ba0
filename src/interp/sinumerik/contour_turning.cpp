#include "interp/sinumerik/contour_turning.h"

#include "core/numbers/rounding.h"
#include "interp/path/arc.h"
#include "interp/path/clearing.h"
#include "interp/path/compensation.h"
#include "interp/turning/turn_call.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {

bool ContourTurning::run() {
  tools_.require(where_, true);
  std::optional<RemovalPlan> read = RemovalValues(control_, contour_call_).read();
  if (!read) return false;
  RemovalPlan& r = *read;
  contour_ = r.contour;
  const Vec3 from = position_.physical;
  const bool by_point = call_.name == "CYCLE95";  // CYCLE95 roughs in G40
  path_ = contour_;
  if (r.rough && !((by_point || beside(r, r.parallel)) && roughing(r))) return false;
  if (r.finish) {
    if (!beside(r, 0)) return false;
    Vec3 start = path_.front().end;
    component(start, r.v) = before_contour(r);
    if (r.rough) {  // starts at the contour's end, not to go through the material
      Vec3 over = position_.physical;
      component(over, r.u) = r.top - r.down * r.clear;
      go(over, MotionKind::rapid, 0);
      component(over, r.v) = component(start, r.v);
      go(over, MotionKind::rapid, 0);
    }
    go(start, MotionKind::rapid, 0);
    modal_.feed = r.last_feed > 0 ? r.last_feed : modal_before_.feed;
    follow_contour({});
  }
  modal_.feed = modal_before_.feed;
  Vec3 out = position_.physical;
  component(out, r.u) -= r.down * r.clear;
  go(out, MotionKind::rapid, 0);
  component(out, r.v) = component(from, r.v);
  go(out, MotionKind::rapid, 0);
  go(from, MotionKind::rapid, 0);
  return true;
}

// Makes the path of the tool's point, so that its nose cuts at `allowance` beside the contour:
// SINUMERIK's cycles take the radius of the edge into account. The ways to the path and from it are
// left out.
bool ContourTurning::beside(const RemovalPlan& r, double allowance) {
  path_ = contour_;
  PathMove move;
  move.comp = moves_.of_tool();
  move.comp.radius += allowance;
  if (move.comp.radius <= kRounding) return true;
  const bool left = r.u == 0 ? r.run == -r.down : r.run == r.down;
  move.comp.side = left ? 1 : -1;
  move.basis = stock_basis();
  const std::size_t errors = reporter_.errors();
  std::vector<Motion> moved;
  CompensationStage stage(reporter_, [&](const PathMove& m) { moved.push_back(m.motion); });
  const auto way = [&](const Motion& like, double at, bool leaves) {
    const Vec3 end = leaves ? like.end : like.start;
    Vec3 ahead = like.kind == MotionKind::arc ? arc_tangent(like, at) : like.end - like.start;
    ahead = normalized(ahead);
    const Vec3 out =
        (left ? 1 : -1) * (2 * move.comp.radius + 1) *
        (dot(ahead, move.basis.u) * move.basis.v - dot(ahead, move.basis.v) * move.basis.u);
    PathMove to = move;
    to.motion = like;
    to.motion.kind = MotionKind::line;
    to.motion.start = leaves ? end : end + out;
    to.motion.end = leaves ? end + out : end;
    if (leaves) to.comp.side = 0;
    stage.push(to);
  };
  way(contour_[1], 0, false);
  for (std::size_t i = 1; i < contour_.size(); ++i) {
    move.motion = contour_[i];
    stage.push(move);
  }
  way(contour_.back(), 1, true);
  stage.flush();
  if (reporter_.errors() != errors || moved.size() < 3) return false;
  path_.assign(moved.begin(), moved.end() - 1);
  return true;
}

// A place in v in front of the contour and of the path along it.
double ContourTurning::before_contour(const RemovalPlan& r) const {
  const double first = component(contour_.front().end, r.v);
  const double ahead = (component(path_.front().end, r.v) - first) * r.run;
  return first + r.run * (std::min(ahead, 0.0) - r.clear);
}

void ContourTurning::follow_contour(const Vec3& shift) {
  go(path_.front().end + shift, MotionKind::line, modal_.feed);
  for (std::size_t i = 1; i < path_.size(); ++i) moves_.follow(path_[i], shift, where_);
}

// Runs passes at equal levels down to the contour, then once along it with the allowances.
bool ContourTurning::roughing(RemovalPlan& r) {
  std::vector<PlanePiece> pieces;
  r.top = component(path_.front().end, r.u);
  for (std::size_t i = 1; i < path_.size(); ++i) {
    pieces.push_back(turned_piece(path_[i], r.u, r.v, r.allowance));
    const double end = component(path_[i].end, r.u);
    if ((end - r.top) * r.down < 0) r.top = end;
  }
  if (r.blank && (*r.blank - r.top) * r.down < 0) r.top = *r.blank;
  const RoughContour shape(std::move(pieces), -r.down, r.run);
  if (const int bad = shape.runs_back(); bad >= 0) {
    reporter_.add_at(Severity::error, "not-supported",
                     "the contour of the cycle runs back here (an undercut), which is not "
                     "supported yet",
                     path_[static_cast<std::size_t>(bad) + 1]);
    return false;
  }
  r.start = before_contour(r);
  const double whole = (shape.deepest() - r.top) * r.down;
  if (r.depth <= 0)
    return error("value-missing", fmt::format("{} needs the depth of a pass", call_.name), where_);
  if (whole / r.depth > kMostTurningPasses) return error("value-range", "too many passes", where_);
  Vec3 begin = position_.physical;
  component(begin, r.v) = r.start;
  go(begin, MotionKind::rapid, 0);
  modal_.feed = r.feed > 0 ? r.feed : modal_before_.feed;
  if (!levels(r, shape, whole, steps_of(whole, r.depth))) return false;
  Vec3 start = path_.front().end + r.allowance;
  component(start, r.v) = r.start;
  go(start, MotionKind::rapid, 0);
  follow_contour(r.allowance);
  return true;
}

// Cuts the stretches that begin at the start, from the top down; then the relief cuts, which the
// tool enters with FF2.
bool ContourTurning::levels(const RemovalPlan& r, const RoughContour& shape, double whole, int n) {
  std::vector<std::pair<double, FreeStretch>> reliefs;
  for (int i = 1; i < n; ++i) {
    const double at = r.top + r.down * whole * i / n;
    for (const FreeStretch& stretch : shape.free_at(at)) {
      if (!stretch.first)
        reliefs.emplace_back(at, stretch);
      else
        level(r, at, r.start, stretch.to);
    }
  }
  if (!reliefs.empty() && !r.reliefs)
    return error("not-supported",
                 fmt::format("{}: the contour has a relief cut, and VARI leaves it: where the cuts "
                             "end then is not supported yet",
                             call_.name),
                 where_);
  const double feed = modal_.feed;
  Vec3 p = position_.physical;
  for (const auto& [at, stretch] : reliefs) {
    if ((stretch.to - stretch.from) * r.run <= kRounding) continue;
    p = position_.physical;
    component(p, r.u) = r.top - r.down * r.clear;
    go(p, MotionKind::rapid, 0);
    component(p, r.v) = stretch.from;
    go(p, MotionKind::rapid, 0);
    component(p, r.u) = at;
    go(p, MotionKind::line, r.plunge > 0 ? r.plunge : feed);
    level(r, at, stretch.from, stretch.to);
  }
  if (reliefs.empty()) return true;
  p = position_.physical;
  component(p, r.u) = r.top - r.down * r.clear;
  go(p, MotionKind::rapid, 0);
  component(p, r.v) = r.start;
  go(p, MotionKind::rapid, 0);
  return true;
}

// Runs one pass: to the level, along it to the contour, away at 45 degrees, back.
void ContourTurning::level(const RemovalPlan& r, double at, double from, double to) {
  const double travel = (to - from) * r.run;
  if (travel <= kRounding) return;
  Vec3 p = position_.physical;
  component(p, r.u) = at;
  go(p, MotionKind::rapid, 0);
  component(p, r.v) = to;
  go(p, MotionKind::line, modal_.feed);
  const double escape = std::min(r.clear, travel);
  component(p, r.u) = at - r.down * escape;
  component(p, r.v) = to - r.run * escape;
  go(p, MotionKind::rapid, 0);
  component(p, r.v) = from;
  go(p, MotionKind::rapid, 0);
}

void ContourTurning::go(const Vec3& to, MotionKind kind, double feed) {
  if (distance(to, position_.physical) <= kRounding) return;
  Target target;
  target.programmed = apply_inverse(frames_.total, to);
  target.named = lathe() ? kAxisX | kAxisZ : kAllAxes;
  moves_.step(target, where_, kind, 0, feed);
}

}  // namespace mrsim
