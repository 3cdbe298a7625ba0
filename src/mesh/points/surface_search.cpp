#include "mesh/points/surface_search.h"

#include "core/numbers/rounding.h"

#include <algorithm>
#include <cmath>

namespace mrsim::detail {
namespace {

constexpr double kMargin = 1e-6;     ///< share of a cell that its vertex keeps from its sides
constexpr double kCrossing = 1e-10;  ///< mm: what crossings are found to
constexpr double kLeastSlope = 0.1;  ///< of a face against the segment that crosses it
constexpr int kCrossingSteps = 80, kFaceSteps = 4;

struct Line {
  const Vec3 &from, &along;
};
// Newton's method along the line: the parameter at which the line passes the face. `plane` is the
// face's tangent plane at t; on return it is that of the last step.
double zero_on_line(const ExactField& field, const FieldSample& face, FacePlane& plane,
                    const Line& line, double t) {
  for (int k = 0; k < kFaceSteps; ++k) {
    if (k > 0) plane = field.face_plane(line.from + t * line.along, face);
    const double f = plane.distance + kInsideTolerance;
    if (std::abs(f) < 0.2 * kCrossing) return t;
    const double slope = dot(plane.normal, line.along);
    if (!(slope > 0)) return t;
    t -= f / slope;
  }
  return t;
}

}  // namespace

bool strictly_inside(const Vec3& p, const Box3& room, int flat) {
  for (int a = 0; a < 3; ++a) {
    if (a == flat) continue;
    const double lo = component(room.lo, a), hi = component(room.hi, a), m = kMargin * (hi - lo);
    if (!(component(p, a) > lo + m && component(p, a) < hi - m)) return false;
  }
  return true;
}

bool in_reach(const Vec3& p, const Box3& room) {
  const Vec3 size = room.hi - room.lo;
  const double beyond = kCellReach * std::max({size.x, size.y, size.z});
  for (int a = 0; a < 3; ++a)
    if (!(component(p, a) >= component(room.lo, a) - beyond &&
          component(p, a) <= component(room.hi, a) + beyond))
      return false;
  return true;
}

CrossingSearch::CrossingSearch(const SegmentEnd& inside, const SegmentEnd& outside)
    : from_(inside.position),
      along_(outside.position - inside.position),
      size_(length(along_)),
      fa_(inside.offset),
      fb_(outside.offset),
      t_(fb_ > fa_ ? -fa_ / (fb_ - fa_) : 0.5) {
  if (!(t_ > a_ && t_ < b_)) t_ = 0.5;
  point_ = from_ + t_ * along_;
}

bool CrossingSearch::take(const ExactField& field, const FieldSample& sample) {
  const double f = sample.distance + kInsideTolerance;
  const bool has_normal = steps_ > 0 && steps_ <= kFaceSteps && same_face(sample, at_);
  at_ = sample;
  if (std::abs(f) < kCrossing || (b_ - a_) * size_ <= kCrossing || steps_ == kCrossingSteps) {
    if (!has_normal) normal_ = field.face_plane(point_, at_).normal;
    return true;
  }
  if (f < 0) {
    a_ = t_;
    fa_ = f;
    if (side_ < 0) fb_ *= 0.5;
    side_ = -1;
  } else {
    b_ = t_;
    fb_ = f;
    if (side_ > 0) fa_ *= 0.5;
    side_ = 1;
  }
  // First where the line passes the face that decides here; if that does not end the search, the
  // Illinois method; where that is slow, halving.
  if (steps_ < kFaceSteps) {
    FacePlane plane = field.face_plane(point_, at_);
    t_ = zero_on_line(field, at_, plane, {from_, along_}, t_);
    normal_ = plane.normal;
  } else {
    t_ = steps_ < 24 && fb_ > fa_ ? a_ + (b_ - a_) * (-fa_ / (fb_ - fa_)) : 0.5 * (a_ + b_);
  }
  if (!(t_ > a_ && t_ < b_)) t_ = 0.5 * (a_ + b_);
  point_ = from_ + t_ * along_;
  ++steps_;
  return false;
}

Vec3 CrossingSearch::position() const {
  const double slope = dot(normal_, along_) / size_;
  if (slope < kLeastSlope) return point_;
  return point_ + kInsideTolerance / (slope * size_) * along_;
}

namespace {

CrossingSearch search_crossing(const Probe& probe, const Vec3& inside, const Vec3& outside) {
  CrossingSearch search({inside, probe.offset(inside)}, {outside, probe.offset(outside)});
  run_together(probe, std::span(&search, 1));
  return search;
}

}  // namespace

Vec3 find_crossing(const Probe& probe, const Vec3& inside, const Vec3& outside) {
  return search_crossing(probe, inside, outside).point();
}

Vec3 find_place(const Probe& probe, const Vec3& inside, const Vec3& outside) {
  return search_crossing(probe, inside, outside).position();
}

SmoothSearch::SmoothSearch(const ExactField& field, const Box3& room, const Vec3& start,
                           const FieldSample* face)
    : room_(room), point_(start) {
  if (face != nullptr) follow(field, *face, field.face_plane(start, *face));
}

// Newton's iteration on one face.
void SmoothSearch::follow(const ExactField& field, const FieldSample& face, FacePlane plane) {
  for (int i = 0; i < 3 && std::abs(plane.distance) > kCrossing; ++i) {
    point_ = point_ - plane.distance * plane.normal;
    plane = field.face_plane(point_, face);
  }
}

bool SmoothSearch::take(const ExactField& field, const FieldSample& sample) {
  // The first face may have led out of the region for which the candidates are complete.
  if (!in_reach(point_, room_)) return true;
  at_ = sample;
  if (std::abs(sample.distance) > kRounding && steps_ < kNewtonSteps) {
    follow(field, sample, field.face_plane(point_, sample));
    ++steps_;
    return !in_reach(point_, room_);
  }
  found_ = strictly_inside(point_, room_, -1) && std::abs(at_.distance) <= kOnSurface;
  return true;
}

SurfacePoint SmoothSearch::result() const {
  SurfacePoint result;
  if (!found_) return result;
  result.position = point_;
  result.faces[0] = at_;
  result.count = 1;
  return result;
}

}  // namespace mrsim::detail
