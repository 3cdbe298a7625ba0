#include "interp/path/plane_piece.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "interp/path/arc.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr double kParallel = 1e-12;  // sine between two lines that never meet
constexpr double kConcentric =
    1e-12;  // mm: distance of centres below which two circles are concentric

// +1 when u x v points along the arc's axis, -1 when the basis is seen from behind or mirrored.
double sense(const Motion& motion, const Basis& basis) {
  return dot(motion.axis, cross(basis.u, basis.v)) < 0 ? -1 : 1;
}

int line_line(const PlanePiece& a, const PlanePiece& b, std::array<Vec2, 2>& out) {
  const auto place = lines_meet(a.start, a.end - a.start, b.start, b.end - b.start, kParallel);
  if (!place) return 0;
  out[0] = *place;
  return 1;
}

int line_circle(const PlanePiece& line, const PlanePiece& circle, std::array<Vec2, 2>& out) {
  const Vec2 d = line.end - line.start;
  const double l = length(d);
  if (l == 0) return 0;
  const Vec2 unit = (1 / l) * d;
  const Vec2 foot = line.start + dot(circle.center - line.start, unit) * unit;
  const double h2 = dot(circle.center - foot, circle.center - foot),
               r2 = circle.radius * circle.radius;
  if (h2 > r2 * (1 + kTurnRounding)) return 0;
  const double half = std::sqrt(std::max(0.0, r2 - h2));
  out[0] = foot - half * unit;
  out[1] = foot + half * unit;
  return 2;
}

int circle_circle(const PlanePiece& a, const PlanePiece& b, std::array<Vec2, 2>& out) {
  const Vec2 d = b.center - a.center;
  const double l = length(d);
  if (l <= kConcentric) return 0;
  const double along = (l * l + a.radius * a.radius - b.radius * b.radius) / (2 * l);
  const double h2 = a.radius * a.radius - along * along;
  if (h2 < -kTurnRounding * a.radius * a.radius) return 0;
  const double h = std::sqrt(std::max(0.0, h2));
  const Vec2 unit = (1 / l) * d, foot = a.center + along * unit;
  out[0] = foot - h * left_of(unit);
  out[1] = foot + h * left_of(unit);
  return 2;
}

bool beside_arc(const PlanePiece& arc, Vec2 p) {
  return length(p - arc.center) > kRounding && position_on(arc, p) <= extent(arc) + kTurnRounding;
}

Vec2 nearest_of_line(const PlanePiece& line, Vec2 p) {
  const Vec2 d = line.end - line.start;
  const double square = dot(d, d);
  if (square <= kRounding * kRounding) return line.start;
  return line.start + std::clamp(dot(p - line.start, d) / square, 0.0, 1.0) * d;
}

}  // namespace

PlanePiece to_plane(const Motion& motion, const Basis& basis) {
  PlanePiece p;
  p.start = in_plane(basis, motion.start);
  p.end = in_plane(basis, motion.end);
  p.arc = motion.kind == MotionKind::arc;
  if (!p.arc) return p;
  p.center = in_plane(basis, motion.center);
  p.radius = motion.radius;
  p.sweep = motion.sweep * sense(motion, basis);
  return p;
}

bool is_infeed(const PathMove& move) {
  if (move.motion.kind == MotionKind::arc) return false;
  return length(in_plane(move.basis, move.motion.end - move.motion.start)) <= kRounding;
}

bool is_tilted(const PathMove& move) {
  return move.motion.kind == MotionKind::arc &&
         std::abs(dot(move.motion.axis, move.basis.w)) < 1 - kTurnRounding;
}

Vec2 start_tangent(const PlanePiece& p) {
  if (!p.arc) return (1 / std::max(length(p.end - p.start), kNoDivisor)) * (p.end - p.start);
  const Vec2 radial = (1 / p.radius) * (p.start - p.center);
  return (p.sweep < 0 ? -1.0 : 1.0) * left_of(radial);
}

Vec2 end_tangent(const PlanePiece& p) {
  if (!p.arc) return start_tangent(p);
  const Vec2 radial = (1 / p.radius) * (p.end - p.center);
  return (p.sweep < 0 ? -1.0 : 1.0) * left_of(radial);
}

PlanePiece offset_piece(const PlanePiece& p, double distance) {
  PlanePiece out = p;
  if (!p.arc) {
    const Vec2 shift = distance * left_of(start_tangent(p));
    out.start = p.start + shift;
    out.end = p.end + shift;
    return out;
  }
  out.radius = p.radius - (p.sweep < 0 ? -distance : distance);
  const double factor = out.radius / p.radius;
  out.start = p.center + factor * (p.start - p.center);
  out.end = p.center + factor * (p.end - p.center);
  return out;
}

std::optional<Vec2> lines_meet(Vec2 a, Vec2 d, Vec2 b, Vec2 e, double parallel) {
  const double det = cross(d, e);
  if (std::abs(det) <= parallel * length(d) * length(e)) return std::nullopt;
  return a + (cross(b - a, e) / det) * d;
}

int intersect(const PlanePiece& a, const PlanePiece& b, std::array<Vec2, 2>& out) {
  if (a.arc && b.arc) return circle_circle(a, b, out);
  if (a.arc) return line_circle(b, a, out);
  return b.arc ? line_circle(a, b, out) : line_line(a, b, out);
}

double progress(const PlanePiece& p, Vec2 from, Vec2 to) {
  if (!p.arc) return dot(to - from, start_tangent(p));
  const Vec2 a = from - p.center, b = to - p.center;
  const double angle = mrsim::atan2(cross(a, b), dot(a, b));
  return p.sweep < 0 ? -angle : angle;
}

double position_on(const PlanePiece& p, Vec2 q) {
  const double along = progress(p, p.start, q);
  return p.arc && along < 0 ? along + kTwoPi : along;
}

double extent(const PlanePiece& p) { return p.arc ? std::abs(p.sweep) : length(p.end - p.start); }

Vec2 point_at(const PlanePiece& piece, double along) {
  if (!piece.arc) return piece.start + along * start_tangent(piece);
  return rotated(piece.start, piece.center, piece.sweep < 0 ? -along : along);
}

void from_piece(const PlanePiece& p, const Basis& basis, double start_height, double end_height,
                Motion& motion) {
  motion.start = from_plane(basis, p.start, start_height);
  motion.end = from_plane(basis, p.end, end_height);
  if (!p.arc) {
    if (motion.kind == MotionKind::arc) motion.kind = MotionKind::line;
    motion.sweep = motion.radius = motion.rise = 0;
    motion.center = {};
    motion.axis = {0, 0, 1};
    return;
  }
  motion.kind = MotionKind::arc;
  motion.center = from_plane(basis, p.center, start_height);
  motion.radius = p.radius;
  motion.axis = normalized(cross(basis.u, basis.v));
  motion.sweep = p.sweep;
  const double up = dot(basis.w, motion.axis) < 0 ? -1 : 1;
  motion.rise = up * (end_height - start_height);
  normalise_axis(motion);
}

double distance_to(const PlanePiece& piece, Vec2 p) {
  if (!piece.arc) return length(p - nearest_of_line(piece, p));
  if (beside_arc(piece, p)) return std::abs(length(p - piece.center) - piece.radius);
  return std::min(length(p - piece.start), length(p - piece.end));
}

double nearest_along(const PlanePiece& piece, Vec2 p) {
  if (!piece.arc) return length(nearest_of_line(piece, p) - piece.start);
  if (beside_arc(piece, p)) return std::min(position_on(piece, p), extent(piece));
  return length(p - piece.start) <= length(p - piece.end) ? 0 : extent(piece);
}

// The least distance is at an end of one of the two, at the foot of the centre, or where both meet.
double distance_between(const PlanePiece& way, const PlanePiece& piece) {
  double least = std::min(distance_to(piece, way.start), distance_to(piece, way.end));
  least = std::min({least, distance_to(way, piece.start), distance_to(way, piece.end)});
  std::array<Vec2, 2> hits;
  const int n = intersect(way, piece, hits);
  for (int i = 0; i < n; ++i) {
    const Vec2 p = nearest_of_line(way, hits[static_cast<std::size_t>(i)]);
    least = std::min(least, distance_to(piece, p));
  }
  if (piece.arc) least = std::min(least, distance_to(piece, nearest_of_line(way, piece.center)));
  return least;
}

}  // namespace mrsim
