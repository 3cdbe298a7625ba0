// CYCLE95 turns down to a contour.
#include "core/rounding.h"
#include "interp/sinumerik/sinumerik_contours.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kMostTurningPasses = 1e5;

}  // namespace

// NPP MID FALZ FALX FAL FF1 FF2 FF3 VARI DT DAM VRT
bool SinumerikContours::turn_modes(Removal& r) {
  const double unit = scale(), number = call_.get(8);
  if (number < 1 || number > 12 || number != std::floor(number))
    return error("value-range", "CYCLE95: VARI is 1 to 12", where_);
  const int kind = (static_cast<int>(number) - 1) % 4;  // outside, face outside, inside, face
  r.rough = number <= 4 || number > 8;
  r.finish = number > 4;
  const bool face = kind % 2 == 1;
  r.u = face ? 2 : 0;
  r.v = 2 - r.u;
  r.clear = call_.get(11) > 0 ? call_.get(11) * unit : 1;
  const double first = component(contour_.front().end, r.u);
  const double last = component(contour_.back().end, r.u);
  const double now = component(position_.physical, r.u);
  r.down = face ? ((first + last) / 2 < now ? -1 : 1) : (kind >= 2 ? 1 : -1);
  const double along = std::abs(call_.get(4)) * unit;
  const double x = std::abs(call_.get(3)) * unit + along, z = std::abs(call_.get(2)) * unit + along;
  orient(r);
  r.run = component(contour_.back().end, r.v) > component(contour_.front().end, r.v) ? 1 : -1;
  component(r.allowance, r.u) = -r.down * (face ? z : x);
  component(r.allowance, r.v) = -r.run * (face ? x : z);
  return true;
}

// The contour begins at its deepest end.
void SinumerikContours::orient(const Removal& r) {
  const double first = component(contour_.front().end, r.u);
  const double last = component(contour_.back().end, r.u);
  if ((first - last) * r.down >= 0) return;
  std::vector<Motion> turned{contour_.front()};
  turned.front().end = contour_.back().end;
  for (std::size_t i = contour_.size() - 1; i > 0; --i) {
    turned.push_back(contour_[i]);
    std::swap(turned.back().start, turned.back().end);
    turned.back().sweep = -turned.back().sweep;
  }
  contour_ = std::move(turned);
}

bool SinumerikContours::turn_down() {
  Removal r;
  if (!turn_modes(r)) return false;
  const Vec3 from = position_.physical;
  if (r.rough && !roughing(r)) return false;
  if (r.finish) {
    Vec3 start = contour_.front().end;
    component(start, r.v) -= r.run * r.clear;
    if (r.rough) {  // from the contour's end back over the material, not through it
      Vec3 over = position_.physical;
      component(over, r.u) = r.top - r.down * r.clear;
      go(over, MotionKind::rapid, 0);
      component(over, r.v) = component(start, r.v);
      go(over, MotionKind::rapid, 0);
    }
    go(start, MotionKind::rapid, 0);
    modal_.feed = call_.get(7) > 0 ? call_.get(7) * feed_scale() : modal_before_.feed;
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

void SinumerikContours::follow_contour(const Vec3& shift) {
  go(contour_.front().end + shift, MotionKind::line, modal_.feed);
  for (std::size_t i = 1; i < contour_.size(); ++i) moves_.follow(contour_[i], shift, where_);
}

// Passes at equal levels down to the contour, then once along it, the allowances aside.
bool SinumerikContours::roughing(Removal& r) {
  std::vector<PlanePiece> pieces;
  r.top = component(contour_.front().end, r.u);
  for (std::size_t i = 1; i < contour_.size(); ++i) {
    pieces.push_back(turned_piece(contour_[i], r.u, r.v, r.allowance));
    const double end = component(contour_[i].end, r.u);
    if ((end - r.top) * r.down < 0) r.top = end;
  }
  const RoughContour shape(std::move(pieces), -r.down, r.run);
  if (const int bad = shape.runs_back(); bad >= 0) {
    reporter_.add_at(Severity::error, "not-supported",
                     "the contour of the cycle runs back here (an undercut), which is not "
                     "supported yet",
                     contour_[static_cast<std::size_t>(bad) + 1]);
    return false;
  }
  r.start = component(contour_.front().end, r.v) - r.run * r.clear;
  const double depth = std::abs(call_.get(1)) * scale();
  const double whole = (shape.deepest() - r.top) * r.down;
  if (depth <= 0) return error("value-missing", "CYCLE95 needs MID, the depth of a pass", where_);
  if (whole / depth > kMostTurningPasses) return error("value-range", "too many passes", where_);
  Vec3 begin = position_.physical;
  component(begin, r.v) = r.start;
  go(begin, MotionKind::rapid, 0);
  modal_.feed = call_.get(5) > 0 ? call_.get(5) * feed_scale() : modal_before_.feed;
  levels(r, shape, whole, steps_of(whole, depth));
  Vec3 start = contour_.front().end + r.allowance;
  component(start, r.v) = r.start;
  go(start, MotionKind::rapid, 0);
  follow_contour(r.allowance);
  return true;
}

// First the stretches that begin at the start, from the top down; then the relief cuts, fed into
// with FF2.
void SinumerikContours::levels(const Removal& r, const RoughContour& shape, double whole, int n) {
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
    go(p, MotionKind::line, call_.get(6) > 0 ? call_.get(6) * feed_scale() : feed);
    level(r, at, stretch.from, stretch.to);
  }
  if (reliefs.empty()) return;
  p = position_.physical;
  component(p, r.u) = r.top - r.down * r.clear;
  go(p, MotionKind::rapid, 0);
  component(p, r.v) = r.start;
  go(p, MotionKind::rapid, 0);
}

// One pass: to the level, along it to the contour, off at 45 degrees, back.
void SinumerikContours::level(const Removal& r, double at, double from, double to) {
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

}  // namespace mrsim
