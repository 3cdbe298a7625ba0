#include "removal/history/cut_extent.h"

#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "removal/tool/tool.h"

#include <cmath>

namespace mrsim {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kUprightFeed = 1e-6;  // sine: a feed along the tool
constexpr double kLying = 0.7;         // cosine: arcs about an axis that lies across the tool

double arcsine(double x) {
  const double sine = std::clamp(x, -1.0, 1.0);
  return mrsim::atan2(sine, std::sqrt((1 - sine) * (1 + sine)));
}

}  // namespace

bool is_along_axis(const Motion& line) {
  const Vec3 way = line.end - line.start;
  return length(cross(line.tool_axis, way)) <= kUprightFeed * length(way);
}

CutFrame::CutFrame(const Motion& motion, const Tool& tool, double radius)
    : is_arc_(motion.kind == MotionKind::arc),
      origin_(is_arc_ ? motion.center : motion.start),
      axis_(motion.tool_axis),
      turns_about_(motion.axis),
      radius_(is_arc_ ? motion.radius : 0) {
  if (mrsim::is_turning(tool.type)) {
    kind_ = Kind::turning;
    const Vec3 way = normalized(motion.end - motion.start);
    side_ = {way.z, 0, -way.x};
    return;
  }
  reach_ = radius;
  if (is_arc_ && std::abs(dot(turns_about_, axis_)) < kLying) {  // G18, G19: up and down on a line
    is_arc_ = false;
    side_ = turns_about_;
    return;
  }
  if (is_arc_) {
    kind_ = Kind::arc;
    return;
  }
  if (!is_along_axis(motion)) {
    side_ = normalized(cross(axis_, motion.end - motion.start));
    return;
  }
  kind_ = Kind::plunge;
  const Vec3 other = std::abs(axis_.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  side_ = normalized(other - dot(other, axis_) * axis_);
}

double CutFrame::along(const Vec3& p) const { return is_turning() ? across(p) : dot(p, axis_); }

double CutFrame::across(const Vec3& p) const {
  const Vec3 off = p - origin_;
  if (!is_arc_) return dot(off, side_);
  const Vec3 plan = off - dot(off, turns_about_) * turns_about_;
  return length(plan) - radius_;
}

Vec2 CutFrame::direction_across(const Vec3& p) const {
  if (!is_arc_) return {side_.x, side_.y};
  const Vec3 to = normalized(Vec3{p.x - origin_.x, p.y - origin_.y, 0});
  return {to.x, to.y};
}

// On an arc the front of the cutter at the angle a from the feed has the distance
// sqrt(R^2 + r^2 + 2 R r sin a) from the axis of the arc.
double CutFrame::angle(double across, double r) const {
  if (kind_ != Kind::arc || !(radius_ > 0)) return arcsine(across / r);
  const double from = radius_ + across;
  return arcsine((from * from - radius_ * radius_ - r * r) / (2 * radius_ * r));
}

PlanBand band_within(const Vec2& across, const Vec2& half, const Vec2& out, double d) {
  PlanBand band{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const auto take = [&](double v) {
    band.left = std::min(band.left, v), band.right = std::max(band.right, v);
  };
  const Vec2 corners[] = {
      {-half.x, -half.y}, {half.x, -half.y}, {half.x, half.y}, {-half.x, half.y}};
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec2 a = corners[k], b = corners[(k + 1) % 4];
    const double beyond = dot(out, a) + d, beyond_next = dot(out, b) + d;
    if (beyond <= 0) take(dot(across, a));
    if (beyond * beyond_next < 0)
      take(dot(across, a) + beyond / (beyond - beyond_next) * dot(across, b - a));
  }
  return band;
}

// The rectangle's corners lie at +-p +-q along `out`: a trapezoid's share.
double share_within(const Vec2& half, const Vec2& out, double d) {
  const double x = std::abs(out.x) * half.x, y = std::abs(out.y) * half.y;
  const double p = std::max(x, y), q = std::min(x, y);
  if (std::abs(d) <= p - q) return 0.5 - d / (2 * p);
  const double corner = std::max(p + q - std::abs(d), 0.0);
  const double cut = corner > 0 ? corner * corner / (8 * p * q) : 0;
  return d < 0 ? 1 - cut : cut;
}

CutExtent turned_about_axis(const CutExtent& half) {
  const double r = half.right, bore = std::max(half.left, 0.0);
  return {half.low, half.high, -r, r, kPi * (r * r - bore * bore)};
}

CutShape cut_shape(const CutFrame& frame, const CutExtent& extent, const Profile* mill,
                   double error) {
  if (extent.is_empty()) return {};
  CutShape out{extent.high - extent.low, kNone, kNone};
  if (mill == nullptr) return out;
  const double r = mill->max_radius_below(out.depth);
  if (frame.is_plunge()) {
    out.width = extent.right - extent.left;
    // In a bore the point of a drill is as long as before, and what it removes lower.
    const double outer = std::min(std::max(extent.right, -extent.left), mill->max_radius());
    const double circle = kPi * std::max(r, outer) * std::max(r, outer);
    if (mill->is_rising()) out.engagement = kTwoPi * std::min(extent.area / circle, 1.0);
    return out;
  }
  const bool is_inner_end = frame.inner_end(r) > -r ? extent.left <= frame.inner_end(r) + error
                                                    : std::abs(extent.left + r) <= error;
  const double left = is_inner_end ? -r : extent.left;
  const double right = std::abs(extent.right - r) <= error ? r : extent.right;
  out.width = right - left;
  out.engagement = frame.angle(right, r) - frame.angle(left, r);
  return out;
}

}  // namespace mrsim
