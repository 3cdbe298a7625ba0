#include "interp/path/moves_ahead.h"

#include "core/numbers/units.h"
#include "interp/path/arc.h"
#include "interp/path/offset_contour.h"

namespace mrsim {
namespace {

constexpr std::size_t kLookAhead = 5;   // compensated moves seen at once
constexpr std::size_t kMostAhead = 64;  // moves of any kind: no longer wait

// Gives the piece new ends; the sweep of an arc follows from them.
void cut_to(PlanePiece& piece, Vec2 start, Vec2 end) {
  piece.start = start;
  piece.end = end;
  if (piece.arc)
    piece.sweep = fold_sweep(start - piece.center, end - piece.center, piece.sweep > 0);
}

void run_on_to(PlanePiece& piece, Vec2 end) {
  if (piece.arc) {
    const double more = progress(piece, piece.end, end);
    piece.sweep += piece.sweep < 0 ? -more : more;
  }
  piece.end = end;
}

}  // namespace

std::size_t MovesAhead::following(std::size_t n) const {
  std::size_t i = 1;
  for (; i < moves_.size(); ++i) {
    if (is_infeed(moves_[i])) continue;
    if (!takes_part(moves_[i])) return moves_.size();
    if (moves_[i].comp.side != moves_[0].comp.side) return moves_.size();
    if (--n == 0) return i;
  }
  return moves_.size();
}

bool MovesAhead::ready(bool last) const {
  if (moves_.empty()) return false;
  if (last || !takes_part(moves_.front()) || moves_.size() > kMostAhead) return true;
  std::size_t planar = 0;
  for (std::size_t i = 1; i < moves_.size(); ++i) {
    if (is_infeed(moves_[i])) continue;
    if (!takes_part(moves_[i])) return true;
    if (++planar >= kLookAhead) return true;
  }
  return false;
}

void MovesAhead::skip_void_entry() {
  const std::size_t j = following(1), next = following(2);
  if (next >= moves_.size() || moves_[j].block != moves_.front().block) return;
  if (!is_void(moved(moves_[j])) || is_void(moved(moves_[next]))) return;
  reporter_.add_at(Severity::warning, "comp-element-void",
                   "the tool is too large to reach this element: it is skipped", moves_[j].motion);
  moves_.erase(moves_.begin() + static_cast<std::ptrdiff_t>(j));
}

// The offset element, extended to the intersection where its end is an outside corner of that form.
PlanePiece MovesAhead::reach(std::size_t i, std::size_t next) const {
  PlanePiece piece = moved(moves_[i]);
  if (is_void(piece) || next >= moves_.size()) return piece;
  const PlanePiece after = moved(moves_[next]);
  if (is_void(after) || corner_kind(moves_[i], moves_[next]) != Corner::outside) return piece;
  run_on_to(piece, outside_corner(moves_[i].comp, corner_of(moves_[i]), piece, after).end);
  return piece;
}

bool MovesAhead::squeezed(std::size_t i, std::size_t next, Vec2 entered) const {
  const PlanePiece piece = moved(moves_[i]);
  if (is_void(piece)) return true;
  if (next >= moves_.size() || corner_kind(moves_[i], moves_[next]) != Corner::inside) return false;
  const PlanePiece after = moved(moves_[next]);
  if (is_void(after)) return false;
  std::array<Vec2, 2> hits;
  const int n = intersect(piece, after, hits);
  if (n == 0) return false;
  Vec2 out = hits[0];
  if (n == 2 && length(hits[1] - piece.end) < length(hits[0] - piece.end)) out = hits[1];
  Vec2 both;  // the other intersection; at a cusp of two arcs it is as near
  if (n == 2 && meeting(piece, after, piece.start, piece.end, both)) out = both;
  if (piece.arc && std::abs(piece.sweep) > kPi) return false;
  return progress(piece, entered, out) < -kTouch / (piece.arc ? piece.radius : 1);
}

// Whether `piece`, from `from` on, meets the n-th following element, or else the path round the
// outside corner after that element. Then `way` is the rest of that path and `keep` the next
// element to be offset.
bool MovesAhead::meets(const PlanePiece& piece, Vec2 from, std::size_t n, CornerWay& way,
                       std::size_t& keep) const {
  const std::size_t j = following(n), next = following(n + 1);
  if (j >= moves_.size()) return false;
  const PlanePiece other = reach(j, next);
  if (is_void(other)) return false;
  way.count = 0;
  keep = j;
  if (meeting(piece, other, from, piece.end, way.end) && !squeezed(j, next, way.end)) return true;
  if (next >= moves_.size() || is_void(moved(moves_[next])) ||
      corner_kind(moves_[j], moves_[next]) != Corner::outside)
    return false;
  keep = next;
  const CornerWay later =
      outside_corner(moves_[j].comp, corner_of(moves_[j]), moved(moves_[j]), moved(moves_[next]));
  for (std::size_t i = 0; i < later.count; ++i) {
    PlanePiece part = later.between[i];
    if (way.count == 0) {
      if (!meeting(piece, part, from, piece.end, way.end)) continue;
      cut_to(part, way.end, part.end);
    }
    way.add(part);
  }
  return way.count > 0;
}

// Drops the elements before `keep`, which have no room.
void MovesAhead::skip_before(std::size_t keep) {
  for (std::size_t k = keep; k-- > 1;) {
    if (is_infeed(moves_[k])) continue;
    if (!is_point(moved(moves_[k])))
      reporter_.add_at(Severity::warning, "comp-element-void",
                       "the tool is too large to reach this element: it is skipped",
                       moves_[k].motion);
    moves_.erase(moves_.begin() + static_cast<std::ptrdiff_t>(k));
  }
}

bool MovesAhead::meet_inside(const PlanePiece& piece, Vec2 from, std::size_t nearest,
                             CornerWay& way) {
  for (std::size_t n = nearest; n < kLookAhead; ++n) {
    CornerWay found;
    std::size_t keep = 0;
    if (!meets(piece, from, n, found, keep)) continue;
    way = found;
    skip_before(keep);
    return true;
  }
  return false;
}

void MovesAhead::close_over(const PlanePiece& piece, Vec2 from, CornerWay& way) {
  if (meet_inside(piece, from, 2, way)) return;
  for (std::size_t i = 0; i < way.count; ++i) {
    CornerWay rest;
    std::size_t keep = 0;
    PlanePiece& part = way.between[i];
    if (!meets(part, part.start, 2, rest, keep)) continue;
    cut_to(part, part.start, rest.end);
    way.count = i + 1;
    for (std::size_t k = 0; k < rest.count; ++k) way.add(rest.between[k]);
    return skip_before(keep);
  }
}

}  // namespace mrsim
