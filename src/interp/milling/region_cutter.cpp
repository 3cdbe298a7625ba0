#include "interp/milling/region_cutter.h"

#include "core/numbers/rounding.h"
#include "interp/path/arc.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kMostRuns = 1e5;  // loops at all levels
constexpr std::size_t kMostBorderPieces = 3'000;
constexpr double kClosed = 0.01;  // mm: the largest gap between the ends of a closed contour

}  // namespace

bool RegionCutter::closed_loop(const std::vector<Motion>& contour, std::size_t first, Loop& out) {
  const Basis b = basis();
  const auto flat = [&](const Vec3& p) { return in_plane(b, apply_inverse(frames_.total, p)); };
  for (std::size_t i = first; i < contour.size(); ++i) {
    const Motion& m = contour[i];
    PlanePiece piece;
    piece.start = flat(m.start);
    piece.end = flat(m.end);
    piece.arc = m.kind == MotionKind::arc;
    if (!piece.arc && length(piece.end - piece.start) <= kRounding) continue;
    if (piece.arc) {
      piece.center = flat(m.center);
      piece.radius = length(piece.start - piece.center);
      const Vec2 ahead = in_plane(b, turn_inverse(frames_.total, arc_tangent(m, 0)));
      piece.sweep = std::copysign(std::abs(m.sweep), cross(piece.start - piece.center, ahead));
    }
    out.push_back(piece);
  }
  const double gap = out.empty() ? 0 : length(out.front().start - out.back().end);
  if (out.empty() || gap > kClosed) {
    reporter_.add_at(Severity::error, "pocket-contour",
                     fmt::format("the contour of the pocket is not closed: its ends are {:.4g} mm "
                                 "apart",
                                 gap),
                     contour.back());
    return false;
  }
  if (gap > kRounding) {
    PlanePiece rest;
    rest.start = out.back().end;
    rest.end = out.front().start;
    out.push_back(rest);
  }
  return true;
}

bool RegionCutter::clear(const Region& region, double radius, double aside, double step,
                         const Levels& levels, const Word& where) {
  std::vector<Loop> loops;
  if (region.pieces() > kMostBorderPieces)
    return error("value-range", "the contours of the pocket have more than 3000 pieces", where);
  if (!clearing_loops(region, radius, aside, step, loops))
    return error("pocket-contour",
                 "no loops can be found for the cutter: a contour that crosses itself?", where);
  return cut(region, loops, radius + aside, levels, where);
}

bool RegionCutter::follow(const Region& region, double radius, double aside, const Levels& levels,
                          const Word& where) {
  std::vector<Loop> loops;
  if (!region.inset(radius + aside, loops))
    return error("pocket-contour",
                 "no loops can be found for the cutter: a contour that crosses itself?", where);
  return cut(region, loops, radius + aside, levels, where);
}

bool RegionCutter::cut(const Region& region, const std::vector<Loop>& loops, double distance,
                       const Levels& l, const Word& where) {
  mover_.begin(where);
  if (loops.empty())
    return error("value-range", "the cutter is too large for the pocket (alarm 61105)", where);
  const double whole = l.bottom - l.reference;
  const int n = steps_of(std::abs(whole), l.infeed);
  if (static_cast<double>(n) * static_cast<double>(loops.size()) > kMostRuns)
    return error("value-range", "more than 100000 loops", where);
  double from = l.safe;
  mover_.rapid_height(l.top);
  for (int i = 1; i <= n; ++i) {
    const double to = i == n ? l.bottom : l.reference + whole * i / n;
    level(region, loops, distance, from, to, l);
    from = to + (l.safe - l.reference);
  }
  mover_.rapid_height(l.top);
  return true;
}

// Goes straight from loop to loop where that stays clear of the contours, else over the part.
void RegionCutter::level(const Region& region, const std::vector<Loop>& loops, double distance,
                         double from, double to, const Levels& l) {
  bool down = false;
  for (const Loop& each : loops) {
    Loop loop = begun_near(each, mover_.position());
    if (l.clockwise) loop = reversed(loop);
    const Vec2 start = loop.front().start;
    if (down && region.keeps(mover_.position(), start, distance)) {
      mover_.line(start, l.feed);
    } else {
      mover_.rapid_height(down || std::abs(from - l.safe) > kRounding ? l.safe : l.top);
      mover_.rapid(start);
      mover_.rapid_height(from);
      mover_.line_height(to, l.plunge);
    }
    mover_.loop(loop, l.feed);
    down = true;
  }
}

}  // namespace mrsim
