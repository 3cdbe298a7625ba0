#include "interp/path/rough_contour.h"

#include "core/units.h"

#include <cmath>

namespace mrsim {
namespace {

constexpr double kSame = 1e-6;   // mm
constexpr double kFalls = 2e-3;  // of a unit tangent: rounded ends of arcs

}  // namespace

int RoughContour::pocket() const {
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const PlanePiece& piece = pieces_[i];
    const Vec2 d = piece.end - piece.start;
    bool back = rise_ * d.x < -kSame || run_ * d.y < -kSame;
    if (piece.arc) {
      back = back || std::abs(piece.sweep) > kPi;
      for (const Vec2 t : {start_tangent(piece), end_tangent(piece)})
        back = back || rise_ * t.x < -kFalls || run_ * t.y < -kTangent;
    }
    if (back) return static_cast<int>(i);
  }
  return -1;
}

std::optional<double> RoughContour::meet(double u) const {
  for (const PlanePiece& piece : pieces_) {
    if (rise_ * (piece.end.x - u) < kSame) continue;  // a flat piece at the level is run along
    if (rise_ * (piece.start.x - u) >= 0) return piece.start.y;
    if (!piece.arc) {
      const double t = (u - piece.start.x) / (piece.end.x - piece.start.x);
      return piece.start.y + t * (piece.end.y - piece.start.y);
    }
    const double du = u - piece.center.x;
    const double h = std::sqrt(std::max(0.0, piece.radius * piece.radius - du * du));
    const double low = piece.center.y - h, high = piece.center.y + h;
    const double middle = (piece.start.y + piece.end.y) / 2;
    return std::abs(low - middle) < std::abs(high - middle) ? low : high;
  }
  return std::nullopt;
}

}  // namespace mrsim
