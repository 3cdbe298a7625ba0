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

// Where the tool is so high above its tip.
double radius_at(const Underside& tool, double height) {
  double low = 0, high = tool.radius();
  if (tool.height(high) <= height) return high;
  for (int k = 0; k < 50; ++k) {
    const double middle = 0.5 * (low + high);
    (tool.height(middle) <= height ? low : high) = middle;
  }
  return high;
}

}  // namespace

bool is_along_axis(const Motion& line) {
  const Vec3 way = line.end - line.start;
  return length(cross(line.tool_axis, way)) <= kUprightFeed * length(way);
}

CutFrame::CutFrame(const Motion& motion, const Tool& tool)
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
  reach_ = 0.5 * tool.diameter;
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

CutShape cut_shape(const CutFrame& frame, const CutExtent& extent, const Underside& tool,
                   double radius) {
  if (extent.is_empty()) return {};
  CutShape out{extent.high - extent.low, kNone, kNone};
  if (frame.is_turning()) return out;
  out.width = extent.right - extent.left;
  const bool knows = tool.radius() > 0;
  const double r = knows ? radius_at(tool, out.depth) : radius;
  if (frame.is_plunge())
    out.engagement = knows ? kTwoPi * std::min(extent.area / (kPi * r * r), 1.0) : kNone;
  else if (r > 0)
    out.engagement = frame.angle(extent.right, r) - frame.angle(extent.left, r);
  return out;
}

}  // namespace mrsim
