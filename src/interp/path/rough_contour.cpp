#include "interp/path/rough_contour.h"

#include "core/numbers/units.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr double kSameCorner = 1e-6;  // mm
constexpr double kFalls = 2e-3;       // slope of a unit tangent that rounded ends of arcs may have

// The places v where the piece passes the level u, in order from its start to its end.
std::vector<double> crossings(const PlanePiece& piece, double u) {
  std::vector<double> out{0, extent(piece)};
  const auto add = [&](Vec2 p) {
    const double along = position_on(piece, p);
    if (along > 0 && along < out[1]) out.push_back(along);
  };
  if (!piece.arc) {
    const double rise = piece.end.x - piece.start.x;
    if (rise != 0) add(piece.start + ((u - piece.start.x) / rise) * (piece.end - piece.start));
  } else if (const double du = u - piece.center.x; std::abs(du) < piece.radius) {
    const double h = std::sqrt(piece.radius * piece.radius - du * du);
    add({u, piece.center.y - h});
    add({u, piece.center.y + h});
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

PlanePiece turned_piece(const Motion& m, int u, int v, const Vec3& shift) {
  const auto flat = [&](const Vec3& p) { return Vec2{component(p, u), component(p, v)}; };
  PlanePiece piece;
  piece.arc = m.kind == MotionKind::arc;
  piece.start = flat(m.start + shift);
  piece.end = flat(m.end + shift);
  piece.center = flat(m.center + shift);
  piece.radius = m.radius;
  // The axis of arcs is Y: from Z to X; in (x, z) such an arc turns the other way.
  piece.sweep = (u == 0 ? -1 : 1) * (m.axis.y < 0 ? -m.sweep : m.sweep);
  return piece;
}

int RoughContour::runs_back() const { return against({0, along_}); }

int RoughContour::falls() const { return against({rise_, 0}); }

// Index of the first piece that does not go in the direction `way`, one of the axes.
int RoughContour::against(Vec2 way) const {
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const PlanePiece& piece = pieces_[i];
    bool back = dot(way, piece.end - piece.start) < -kSameCorner;
    if (piece.arc) {
      back = back || std::abs(piece.sweep) > kPi;
      for (const Vec2 t : {start_tangent(piece), end_tangent(piece)})
        back = back || dot(way, t) < -kFalls;
    }
    if (back) return static_cast<int>(i);
  }
  return -1;
}

double RoughContour::deepest() const {
  double low = 1e300;
  for (const PlanePiece& piece : pieces_) {
    low = std::min({low, rise_ * piece.start.x, rise_ * piece.end.x});
    if (!piece.arc) continue;
    const Vec2 bottom{piece.center.x - rise_ * piece.radius, piece.center.y};
    if (position_on(piece, bottom) <= extent(piece)) low = std::min(low, rise_ * bottom.x);
  }
  return rise_ * low;
}

// A flat piece at the level belongs to a stretch.
std::vector<FreeStretch> RoughContour::free_at(double u) const {
  std::vector<FreeStretch> out;
  bool free = false;
  for (const PlanePiece& piece : pieces_) {
    const std::vector<double> cuts = crossings(piece, u);
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      if (cuts[i] - cuts[i - 1] <= 0) continue;
      const Vec2 middle = point_at(piece, (cuts[i - 1] + cuts[i]) / 2);
      const bool below = rise_ * (middle.x - u) < kSameCorner;
      if (below && !free)
        out.push_back({point_at(piece, cuts[i - 1]).y, 0, &piece == pieces_.data() && i == 1});
      free = below;
      if (free) out.back().to = point_at(piece, cuts[i]).y;
    }
  }
  return out;
}

}  // namespace mrsim
