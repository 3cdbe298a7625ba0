#include "interp/path/spline.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr int kDeepest = 14;  // halvings of the parameter
constexpr int kSamples = 12;  // points of the curve that are measured in each span

class Approximation {
 public:
  Approximation(const std::array<Vec2, 4>& control, double tolerance)
      : control_(control), tolerance_(tolerance) {}

  void span(double from, double to, int depth) {
    const Vec2 a = point(from), b = point(to);
    std::vector<CurvePiece> pieces;
    // The first halvings are made blindly: an S could pass through all samples of one biarc.
    const bool made = depth > 0 && biarc(a, tangent(from, to), b, tangent(to, from), pieces);
    if ((made && error(from, to, a, pieces) <= tolerance_) || depth >= kDeepest) {
      if (!made) pieces = {{b, {}}};
      out.insert(out.end(), pieces.begin(), pieces.end());
      return;
    }
    const double middle = (from + to) / 2;
    span(from, middle, depth + 1);
    span(middle, to, depth + 1);
  }

  std::vector<CurvePiece> out;

 private:
  Vec2 point(double t) const {
    const double s = 1 - t;
    return s * s * s * control_[0] + 3 * s * s * t * control_[1] + 3 * s * t * t * control_[2] +
           t * t * t * control_[3];
  }
  // Unit direction of travel; where the derivative vanishes, that of a point close by.
  Vec2 tangent(double t, double towards) const {
    const double s = 1 - t;
    Vec2 d = 3 * s * s * (control_[1] - control_[0]) + 6 * s * t * (control_[2] - control_[1]) +
             3 * t * t * (control_[3] - control_[2]);
    if (length(d) < 1e-9) {
      const Vec2 chord = point(t + (towards - t) * 1e-3) - point(t);
      d = towards > t ? chord : Vec2{} - chord;
    }
    const double l = length(d);
    return l > 0 ? (1 / l) * d : Vec2{1, 0};
  }

  // Two arcs with the tangents of the curve at both ends, the control legs equally long.
  static bool biarc(Vec2 a, Vec2 ta, Vec2 b, Vec2 tb, std::vector<CurvePiece>& pieces) {
    const Vec2 v = b - a, t = ta + tb;
    const double vt = dot(v, t), denominator = 2 * (1 - dot(ta, tb)), vv = dot(v, v);
    if (vv == 0) return false;
    double d = 0;
    if (denominator > 1e-9) {
      d = (std::sqrt(vt * vt + denominator * vv) - vt) / denominator;
    } else {
      const double along = dot(v, tb);
      if (along <= 0) return false;
      d = vv / (4 * along);
    }
    const Vec2 joint = 0.5 * (a + b + d * (ta - tb));
    const Vec2 across = (b - d * tb) - (a + d * ta);
    const double l = length(across);
    if (l < 1e-12) return false;
    add(a, ta, joint, pieces);
    add(joint, (1 / l) * across, b, pieces);
    return true;
  }
  static void add(Vec2 from, Vec2 tangent, Vec2 to, std::vector<CurvePiece>& pieces) {
    CurvePiece piece{to, {}};
    const double chord = length(to - from);
    if (chord < 1e-9) return;
    const bool flat = std::abs(cross(tangent, to - from)) < 1e-7 * chord;
    if (!flat)
      if (const auto arc = arc_by_tangent(from, tangent, to)) piece.arc = *arc;
    pieces.push_back(piece);
  }

  double error(double from, double to, Vec2 start, const std::vector<CurvePiece>& pieces) const {
    double worst = 0;
    for (int i = 1; i < kSamples; ++i) {
      const Vec2 p = point(from + (to - from) * i / kSamples);
      double nearest = 1e30;
      Vec2 at = start;
      for (const CurvePiece& piece : pieces) {
        nearest = std::min(nearest, off(p, at, piece));
        at = piece.end;
      }
      worst = std::max(worst, nearest);
    }
    return worst;
  }
  static double off(Vec2 p, Vec2 from, const CurvePiece& piece) {
    if (piece.arc.sweep != 0) {
      const double round = std::abs(length(p - piece.arc.center) - piece.arc.radius);
      return std::abs(piece.arc.sweep) < 3 ? round : 1e30;
    }
    const Vec2 d = piece.end - from;
    return std::abs(cross(d, p - from)) / std::max(length(d), 1e-12);
  }

  std::array<Vec2, 4> control_;
  double tolerance_;
};

}  // namespace

std::vector<CurvePiece> bezier_arcs(const std::array<Vec2, 4>& control, double tolerance) {
  double extent = 0;
  for (const Vec2 p : control) extent = std::max(extent, length(p - control[0]));
  if (extent < 1e-9) return {};
  Approximation made(control, tolerance);
  made.span(0, 1, 0);
  return made.out;
}

}  // namespace mrsim
