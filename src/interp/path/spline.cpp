#include "interp/path/spline.h"

#include "core/numbers/rounding.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace mrsim {
namespace {

constexpr double kNoLength = 1e-12;  // mm: shorter ways have no direction
constexpr int kDeepest = 14;         // halvings of the parameter
constexpr int kSamples = 12;         // points that are measured in each span of the curve

/// A stretch of a curve, over a parameter that begins at 0 and ends at 1.
struct PlaneCurve {
  std::function<Vec2(double)> point, derivative;
};

class Approximation {
 public:
  Approximation(PlaneCurve curve, double tolerance)
      : curve_(std::move(curve)), tolerance_(tolerance) {}

  void span(double from, double to, int depth) {
    const Vec2 a = point(from), b = point(to);
    std::vector<CurvePiece> pieces;
    // The first halving is made without measuring: an S could pass through all samples of one
    // biarc.
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
  Vec2 point(double t) const { return curve_.point(t); }
  // Unit direction of travel; where the derivative vanishes, that of a point close by.
  Vec2 tangent(double t, double towards) const {
    Vec2 d = curve_.derivative(t);
    if (length(d) < kRounding) {
      const Vec2 chord = point(t + (towards - t) * 1e-3) - point(t);
      d = towards > t ? chord : Vec2{} - chord;
    }
    const double l = length(d);
    return l > 0 ? (1 / l) * d : Vec2{1, 0};
  }

  // Makes two arcs that have the tangents of the curve at both ends, with control legs of one
  // length.
  static bool biarc(Vec2 a, Vec2 ta, Vec2 b, Vec2 tb, std::vector<CurvePiece>& pieces) {
    const Vec2 v = b - a, t = ta + tb;
    const double vt = dot(v, t), denominator = 2 * (1 - dot(ta, tb)), vv = dot(v, v);
    if (vv == 0) return false;
    double d = 0;
    if (denominator > kTurnRounding) {
      d = (std::sqrt(vt * vt + denominator * vv) - vt) / denominator;
    } else {
      const double along = dot(v, tb);
      if (along <= 0) return false;
      d = vv / (4 * along);
    }
    const Vec2 joint = 0.5 * (a + b + d * (ta - tb));
    const Vec2 across = (b - d * tb) - (a + d * ta);
    const double l = length(across);
    if (l < kNoLength) return false;
    add(a, ta, joint, pieces);
    add(joint, (1 / l) * across, b, pieces);
    return true;
  }
  static void add(Vec2 from, Vec2 tangent, Vec2 to, std::vector<CurvePiece>& pieces) {
    CurvePiece piece{to, {}};
    const double chord = length(to - from);
    if (chord < kRounding) return;
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
    return std::abs(cross(d, p - from)) / std::max(length(d), kNoLength);
  }

  PlaneCurve curve_;
  double tolerance_;
};

PlaneCurve bezier(const std::array<Vec2, 4>& c) {
  const auto point = [c](double t) {
    const double s = 1 - t;
    return s * s * s * c[0] + 3 * s * s * t * c[1] + 3 * s * t * t * c[2] + t * t * t * c[3];
  };
  const auto derivative = [c](double t) {
    const double s = 1 - t;
    return 3 * s * s * (c[1] - c[0]) + 6 * s * t * (c[2] - c[1]) + 3 * t * t * (c[3] - c[2]);
  };
  return {point, derivative};
}

/// One stretch of a NURBS between two knots, by de Boor's scheme on (w x, w y, w).
class NurbsStretch {
 public:
  /// `first`: the first of the `order` control points that have an effect on it.
  NurbsStretch(const std::vector<NurbsPoint>& control, int order, std::size_t first)
      : degree_(order - 1), first_(static_cast<int>(first)) {
    last_knot_ = static_cast<int>(control.size()) - degree_;
    for (int i = 0; i < order; ++i) {
      const NurbsPoint& p = control[first + static_cast<std::size_t>(i)];
      points_.push_back({p.weight * p.at.x, p.weight * p.at.y, p.weight});
    }
  }
  Vec2 point(double t) const {
    const Vec3 h = combine(t, degree_)[static_cast<std::size_t>(degree_)];
    return {h.x / h.z, h.y / h.z};
  }
  Vec2 derivative(double t) const {
    const std::vector<Vec3> d = combine(t, degree_ - 1);
    const auto p = static_cast<std::size_t>(degree_);
    const Vec3 slope = degree_ * (d[p] - d[p - 1]);  // knots are 1 apart
    const Vec3 h = (1 - t) * d[p - 1] + t * d[p];
    return {(slope.x * h.z - h.x * slope.z) / (h.z * h.z),
            (slope.y * h.z - h.y * slope.z) / (h.z * h.z)};
  }

 private:
  double knot(int i) const { return std::clamp(i - degree_, 0, last_knot_); }
  std::vector<Vec3> combine(double t, int rounds) const {
    std::vector<Vec3> d = points_;
    const int span = first_ + degree_;
    const double u = knot(span) + t;
    for (int r = 1; r <= rounds; ++r)
      for (int i = degree_; i >= r; --i) {
        const double low = knot(first_ + i), high = knot(span + 1 + i - r);
        const double share = (u - low) / (high - low);
        const auto at = static_cast<std::size_t>(i);
        d[at] = (1 - share) * d[at - 1] + share * d[at];
      }
    return d;
  }

  int degree_, first_, last_knot_ = 1;
  std::vector<Vec3> points_;
};

}  // namespace

std::vector<CurvePiece> bezier_arcs(const std::array<Vec2, 4>& control, double tolerance) {
  double extent = 0;
  for (const Vec2 p : control) extent = std::max(extent, length(p - control[0]));
  if (extent < kRounding) return {};
  Approximation made(bezier(control), tolerance);
  made.span(0, 1, 0);
  return made.out;
}

std::vector<CurvePiece> nurbs_arcs(const std::vector<NurbsPoint>& control, int order,
                                   double tolerance) {
  double extent = 0;
  for (const NurbsPoint& p : control) extent = std::max(extent, length(p.at - control[0].at));
  if (extent < kRounding) return {};
  std::vector<CurvePiece> out;
  for (std::size_t i = 0; i + static_cast<std::size_t>(order) <= control.size(); ++i) {
    const NurbsStretch stretch(control, order, i);
    Approximation made({[&](double t) { return stretch.point(t); },
                        [&](double t) { return stretch.derivative(t); }},
                       tolerance);
    made.span(0, 1, 0);
    out.insert(out.end(), made.out.begin(), made.out.end());
    if (out.size() > kMostCurvePieces) break;
  }
  return out;
}

}  // namespace mrsim
