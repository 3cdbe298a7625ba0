#include "interp/path/corners.h"

#include "core/numbers/rounding.h"
#include "interp/path/arc.h"
#include "interp/path/plane_piece.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kHair = 1e-8;           // mm: a leftover shorter than this is rounding
constexpr double kTangent = 1e-6;        // |t1 x t2| below which there is no corner
constexpr double kLeastSize = 1e-6;      // mm: no smaller rounding or chamfer is inserted
constexpr double kSameAxis = 1e-12;      // distance of unit vectors: the moves have one plane
constexpr std::size_t kMostBetween = 3;  // blocks without plane travel inside a corner

// Where a rounding or chamfer touches its two elements.
struct Contact {
  Vec2 first, second, center;
};

// The point of a piece at a straight distance from the corner, its end or its start. False: it is
// not so long.
bool at_distance(const PlanePiece& piece, Vec2 corner, double distance, bool from_end, Vec2& out) {
  if (!piece.arc) {
    out = from_end ? corner - distance * end_tangent(piece)
                   : corner + distance * start_tangent(piece);
    return distance <= length(piece.end - piece.start) + kRounding;
  }
  PlanePiece ring;
  ring.arc = true;
  ring.center = corner;
  ring.radius = distance;
  std::array<Vec2, 2> hits;
  const int n = intersect(piece, ring, hits);
  double best = kInfinity;
  for (int i = 0; i < n; ++i) {
    const double along = position_on(piece, hits[static_cast<std::size_t>(i)]);
    const double gap = from_end ? extent(piece) - along : along;
    if (gap < -kRounding || gap > extent(piece) + kRounding || gap >= best) continue;
    best = gap;
    out = hits[static_cast<std::size_t>(i)];
  }
  return best < kInfinity;
}

Vec2 foot_on(const PlanePiece& piece, Vec2 p) {
  if (!piece.arc) {
    const Vec2 t = start_tangent(piece);
    return piece.start + dot(p - piece.start, t) * t;
  }
  const Vec2 d = p - piece.center;
  return piece.center + (piece.radius / std::max(length(d), kNoDivisor)) * d;
}

bool on_piece(const PlanePiece& piece, Vec2 p) {
  const double along = position_on(piece, p);
  return along >= -kRounding && along <= extent(piece) + kRounding;
}

// Finds where an arc of radius r touches both elements. False: it does not fit on them.
bool round_contacts(const PlanePiece& a, const PlanePiece& b, double side, double r, Contact& out) {
  const PlanePiece oa = offset_piece(a, side * r), ob = offset_piece(b, side * r);
  if ((oa.arc && oa.radius <= kRounding) || (ob.arc && ob.radius <= kRounding)) return false;
  std::array<Vec2, 2> hits;
  const int n = intersect(oa, ob, hits);
  double best = kInfinity;
  for (int i = 0; i < n; ++i) {
    const Vec2 c = hits[static_cast<std::size_t>(i)];
    const double far = length(c - a.end);
    if (far >= best) continue;
    const Vec2 first = foot_on(a, c), second = foot_on(b, c);
    if (!on_piece(a, first) || !on_piece(b, second)) continue;
    best = far;
    out = {first, second, c};
  }
  return best < kInfinity;
}

bool contacts(const CornerSpec& spec, const PlanePiece& a, const PlanePiece& b, double side,
              double size, Contact& out) {
  if (spec.kind == CornerSpec::Kind::round) return round_contacts(a, b, side, size, out);
  double leg = size;
  if (spec.kind == CornerSpec::Kind::cut) {
    const Vec2 t = end_tangent(a) + start_tangent(b);  // |t| = 2 cos(half the turn)
    leg = size / std::max(length(t), kRounding);
  }
  return at_distance(a, a.end, leg, true, out.first) &&
         at_distance(b, b.start, leg, false, out.second);
}

// The largest size up to the wanted one that fits.
double largest_fit(const CornerSpec& spec, const PlanePiece& a, const PlanePiece& b, double side,
                   Contact& out) {
  double low = 0, high = spec.size;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (contacts(spec, a, b, side, middle, out) ? low : high) = middle;
  }
  return low > 0 && contacts(spec, a, b, side, low, out) ? low : 0;
}

// Whether something is left of the element. False: the corner has taken all of it.
bool travels(const Motion& motion) {
  return distance(motion.start, motion.end) > kRounding ||
         (motion.kind == MotionKind::arc && motion.radius * std::abs(motion.sweep) > kRounding);
}

// Shortens the move to `piece`, whose coordinates are those of `basis`. The basis of the move may
// be turned against it. `keep_heights`: the shorter move has the whole change of height.
void shorten(PathMove& move, const Basis& basis, PlanePiece piece, bool at_end, Vec2 to,
             bool keep_heights) {
  const double start = dot(move.motion.start, basis.w);
  const double end = dot(move.motion.end, basis.w);
  const double share = position_on(piece, to) / extent(piece);
  if (piece.arc) piece.sweep *= at_end ? share : 1 - share;
  const double height = keep_heights ? (at_end ? end : start) : start + (end - start) * share;
  (at_end ? piece.end : piece.start) = to;
  from_piece(piece, basis, at_end ? start : height, at_end ? height : end, move.motion);
}

}  // namespace

// Shortens both moves and makes the element between them. False: nothing fits or nothing is needed.
bool CornerStage::insert(PathMove& before, PathMove& after, PathMove& inserted) {
  const PlanePiece a = to_plane(before.motion, before.basis),
                   b = to_plane(after.motion, before.basis);
  const double turn = cross(end_tangent(a), start_tangent(b));
  if (std::abs(turn) < kTangent) {
    if (dot(end_tangent(a), start_tangent(b)) < 0)
      nothing_inserted("the path turns straight back", before);
    return false;
  }
  const double side = turn > 0 ? 1 : -1;
  // Behind an infeed, which may be a retract, the next move begins at the infeed's height, and the
  // element ends at the height of the corner.
  const double corner_height = dot(before.motion.end, before.basis.w);
  const bool apart = held_.size() > 1;
  Contact c;
  if (!contacts(before.corner, a, b, side, before.corner.size, c)) {
    const double size = largest_fit(before.corner, a, b, side, c);
    reduced(before, size);
    if (size <= kLeastSize) return false;
  }
  if (length(c.first - a.start) < kHair) c.first = a.start;
  if (length(c.second - b.end) < kHair) c.second = b.end;
  inserted = before;
  inserted.corner = {};
  if (before.corner.feed > 0) inserted.motion.feed = before.corner.feed;
  shorten(before, before.basis, a, true, c.first, false);
  shorten(after, before.basis, b, false, c.second, apart);
  PlanePiece piece;
  piece.start = c.first;
  piece.end = c.second;
  if (before.corner.kind == CornerSpec::Kind::round) {
    piece.arc = true;
    piece.center = c.center;
    piece.radius = length(c.first - c.center);
    piece.sweep = fold_sweep(c.first - c.center, c.second - c.center, side > 0);
  }
  from_piece(piece, before.basis, dot(before.motion.end, before.basis.w),
             apart ? corner_height : dot(after.motion.start, before.basis.w), inserted.motion);
  inserted.motion.assumed_start = false;
  return true;
}

void CornerStage::flush() {
  if (!held_.empty() && !held_.front().corner.modal)
    nothing_inserted("no move in the plane follows", held_.front());
  for (const PathMove& move : held_) next_(move);
  held_.clear();
}

void CornerStage::nothing_inserted(const char* why, const PathMove& move) {
  reporter_.add_at(Severity::warning, "corner-void",
                   fmt::format("{}: no rounding or chamfer is inserted", why), move.motion);
}

void CornerStage::reduced(const PathMove& move, double size) {
  reporter_.add_at(Severity::warning, "corner-reduced",
                   fmt::format("{} mm does not fit on the neighbours: reduced to {:.4g} mm",
                               move.corner.size, size),
                   move.motion);
}

bool CornerStage::may_insert(const PathMove& after) {
  const PathMove& before = held_.front();
  if (after.block > before.block + kMostBetween + 1 || is_infeed(after)) {
    nothing_inserted("more than three blocks without travel in the plane follow", before);
    return false;
  }
  if (before.corner.next && held_.size() > 1) {
    nothing_inserted("the next block does not move in the plane, where FANUC's controls stop",
                     before);
    return false;
  }
  if (before.corner.next && after.motion.kind == MotionKind::rapid) {
    nothing_inserted("the next block is a rapid, where FANUC's controls stop (alarm 052)", before);
    return false;
  }
  if (!is_tilted(after) && length(before.basis.w - after.basis.w) < kSameAxis) return true;
  if (!before.corner.modal) nothing_inserted("the next move lies in another plane", before);
  return false;
}

void CornerStage::push(const PathMove& move) {
  if (held_.empty()) {
    const bool cornered = move.corner.kind != CornerSpec::Kind::none;
    const bool flat = !is_infeed(move) && !is_tilted(move);
    if (cornered && !flat && !move.corner.modal)
      nothing_inserted("the block does not move in the plane", move);
    if (!cornered || !flat) return next_(move);
    held_.push_back(move);
    return;
  }
  if (is_infeed(move) && move.block <= held_.front().block + kMostBetween) {
    held_.push_back(move);
    return;
  }
  PathMove before = held_.front(), after = move, inserted;
  const bool fits = may_insert(move) && insert(before, after, inserted);
  if (travels(before.motion)) next_(before);
  if (fits) next_(inserted);
  for (std::size_t i = 1; i < held_.size(); ++i) {
    PathMove infeed = held_[i];
    if (fits) {  // the infeed happens where the inserted element ends
      const Vec3 shift = inserted.motion.end - before.motion.end;
      const Vec3 old = held_.front().motion.end;
      infeed.motion.start = infeed.motion.start - old + before.motion.end + shift;
      infeed.motion.end = infeed.motion.end - old + before.motion.end + shift;
    }
    next_(infeed);
  }
  held_.clear();
  if (travels(after.motion)) return push(after);
  if (after.corner.kind != CornerSpec::Kind::none) reduced(after, 0);  // its element is used up
}

}  // namespace mrsim
