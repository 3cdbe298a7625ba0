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

double CutFrame::half_across(const Vec3& p, const Vec2& side) const {
  Vec3 to = side_;
  if (is_arc_) to = normalized(Vec3{p.x - origin_.x, p.y - origin_.y, 0});
  return 0.5 * (std::abs(to.x) * side.x + std::abs(to.y) * side.y);
}

// On an arc the front of the cutter at the angle a from the feed has the distance
// sqrt(R^2 + r^2 + 2 R r sin a) from the axis of the arc.
double CutFrame::angle(double across, double r) const {
  if (kind_ != Kind::arc || !(radius_ > r)) return arcsine(across / r);
  const double from = radius_ + across;
  return arcsine((from * from - radius_ * radius_ - r * r) / (2 * radius_ * r));
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
  const auto at_edge = [&](double across, double edge) {
    return std::abs(across - edge) <= error ? edge : across;
  };
  const double left = at_edge(extent.left, -r), right = at_edge(extent.right, r);
  out.width = right - left;
  out.engagement = frame.angle(right, r) - frame.angle(left, r);
  return out;
}

}  // namespace mrsim
