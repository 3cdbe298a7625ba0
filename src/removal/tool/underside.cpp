#include "removal/tool/underside.h"

#include "core/numbers/rounding.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr int kAllSteps = 60, kBoundSteps = 4;
constexpr double kContact = 1e-6;  // mm: the height changes by its square, 1e-12 / radius

// Where on its move a ball touches, e before the place: at slope wide / sqrt(1 + slope^2), or at
// the end of the range nearest to it, which is found without roots.
double ball_contact(double slope, double square, double low, double high) {
  const double rise = slope * slope, found = rise * square;
  if (high <= 0 || found >= high * high * (1 + rise)) return high;
  if (low >= 0 && found <= low * low * (1 + rise)) return low;
  return std::clamp(std::sqrt(found / (1 + rise)), low, high);
}

}  // namespace

Underside::Underside(const Profile& tool) : radius_(tool.max_radius()), convex_(tool.is_convex()) {
  for (const ProfileEdge& e : tool.edges()) {
    if (e.b.x <= e.a.x || std::isinf(e.b.y)) continue;  // upright
    Edge edge{.from = e.a.x, .to = e.b.x, .z0 = e.a.y};
    if (e.radius > 0) {
      edge.center = e.center.x, edge.z0 = e.center.y;
      edge.radius = e.radius, edge.above = !e.convex;
    } else {
      edge.incline = (e.b.y - e.a.y) / (e.b.x - e.a.x);
    }
    edges_.push_back(edge);
  }
  ball_ = edges_.size() == 1 && !edges_[0].above && edges_[0].center == 0 &&
          edges_[0].radius == radius_ && edges_[0].z0 == radius_;
}

double Underside::Edge::height(double rho) const {
  if (radius == 0) return z0 + incline * (rho - from);
  const double up = root_or_zero(radius * radius - (rho - center) * (rho - center));
  return above ? z0 + up : z0 - up;
}

double Underside::Edge::slope(double rho) const {
  if (radius == 0) return incline;
  const double off = above ? center - rho : rho - center;
  const double up = root_or_zero(radius * radius - off * off);
  return up > 0 ? off / up : kInfinity;
}

double Underside::height(double rho) const {
  for (const Edge& e : edges_)
    if (rho <= e.to) return e.height(std::max(rho, e.from));
  return kInfinity;
}

// The tool touches at a place where it is as steep as the move: with the axis at distance rho of
// the place, e of it along the move, slope(rho) e / rho = slope. The tool is widened by `shift`.
// Steepness grows with e, so the contact is looked for in the part of one edge, and an end of
// `range` is the answer where the contact lies beyond it.
Underside::Bracket Underside::contact(const Slant& at, double shift, Bracket range,
                                      int steps) const {
  const double v = at.v, slope = at.slope;
  double first = shift > 0 ? root_or_zero(shift * shift - v * v) : 0;  // e where the edge begins
  for (const Edge& e : edges_) {
    if (range.high <= first) return {range.high, range.high};
    const double end = e.to + shift;
    if (end <= v) continue;
    const double last = root_or_zero(end * end - v * v);
    const Bracket in{std::max(first, range.low), std::min(last, range.high)};
    if (in.low <= in.high && (last >= range.high || !(e.slope(e.to) * last < slope * end))) {
      if (e.radius > 0) return arc_contact(e, at, shift, in, steps);
      const double tilt = root_or_zero(e.incline * e.incline - slope * slope);
      const double found = tilt > 0 ? std::clamp(slope * v / tilt, in.low, in.high) : in.high;
      return {found, found};
    }
    first = last;
  }
  const double last = std::clamp(first, range.low, range.high);
  return {last, last};
}

Underside::Bracket Underside::arc_contact(const Edge& e, const Slant& from, double shift,
                                          Bracket in, int steps) const {
  const double v = from.v, slope = from.slope;
  const double center = e.center + shift, square = e.radius * e.radius;
  if (center == 0) {
    const double at = slope * root_or_zero((square - v * v) / (1 + slope * slope));
    return {std::clamp(at, in.low, in.high), std::clamp(at, in.low, in.high)};
  }
  const auto excess = [&](double along) {
    const double rho = std::sqrt(along * along + v * v), off = rho - center;
    return std::max(off, 0.0) * along - slope * rho * root_or_zero(square - off * off);
  };
  double below = excess(in.low);
  if (!(below < 0)) return {in.low, in.low};
  double above = excess(in.high);
  if (!(above > 0)) return {in.high, in.high};
  const double enough = std::max(std::fabs(shift), kContact);
  for (int k = 0; k < steps && in.high - in.low > enough; ++k) {
    double at = in.low + (in.high - in.low) * below / (below - above);
    if (k % 3 == 2 || !(at > in.low && at < in.high)) at = 0.5 * (in.low + in.high);
    const double value = excess(at);
    if (value < 0)
      in.low = at, below = value, above *= 0.5;
    else
      in.high = at, above = value, below *= 0.5;
  }
  return in;
}

// A sphere about (e, v) touches at e = slope wide / sqrt(1 + slope^2), or at an end of the move.
double Underside::ball_bottom(const Slant& at) const {
  const double square = radius_ * radius_ - at.v * at.v;
  if (square < 0) return kInfinity;
  const double wide = std::sqrt(square);
  const double low = std::max(at.u - at.length, -wide), high = std::min(at.u, wide);
  if (low > high) return kInfinity;
  const double e = ball_contact(at.slope, square, low, high);
  return at.slope * (at.u - e) + radius_ - root_or_zero(square - e * e);
}

double Underside::bottom(const Slant& at, double below) const {
  if (ball_) return ball_bottom(at);
  const double wide = root_or_zero(radius_ * radius_ - at.v * at.v);
  const double low = std::max(at.u - at.length, -wide), high = std::min(at.u, wide);
  if (at.v > radius_ || low > high) return kInfinity;
  if (at.slope * (at.u - high) + height(at.v) >= below) return kInfinity;
  const Bracket found = contact(at, 0, {low, high}, kAllSteps);
  const double e = 0.5 * (found.low + found.high);
  return at.slope * (at.u - e) + height(std::min(std::sqrt(e * e + at.v * at.v), radius_));
}

// Height and steepness at rho.
Underside::Slope Underside::slope_at(double rho) const {
  for (const Edge& e : edges_) {
    if (rho > e.to) continue;
    const double on = std::max(rho, e.from);
    if (e.radius == 0) return {e.z0 + e.incline * (on - e.from), e.incline};
    const double off = on - e.center, up = root_or_zero(e.radius * e.radius - off * off);
    return {e.above ? e.z0 + up : e.z0 - up, up > 0 ? off / up : kInfinity};
  }
  return {kInfinity, kInfinity};
}

// A lower bound by the tool widened by r. That is convex as well, and so is the height as a
// function of e, so it lies above its tangents at both ends of a bracket of the contact. A bracket
// no longer than r will do: what the tangents lose grows with the square of its length.
double Underside::lower(const Slant& at, double r) const {
  const double reach = radius_ + r, wide = root_or_zero(reach * reach - at.v * at.v);
  const double low = std::max(at.u - at.length, -wide), high = std::min(at.u, wide);
  if (at.v > reach || low > high) return kInfinity;
  const Bracket in =
      high - low <= r ? Bracket{low, high} : contact(at, r, {low, high}, kBoundSteps);
  const auto tangent = [&](double e) {
    const double rho = std::sqrt(e * e + at.v * at.v);
    const Slope on = slope_at(std::clamp(rho - r, 0.0, radius_));
    return Slope{at.slope * (at.u - e) + on.height - kRounding,
                 (rho > r ? on.slope * e / rho : 0) - at.slope};
  };
  const Slope first = tangent(in.low);
  if (in.low == in.high || first.slope >= 0) return first.height;
  const Slope last = tangent(in.high);
  const double length = in.high - in.low;
  if (last.slope <= 0) return last.height;
  if (std::isinf(last.slope)) return first.height + first.slope * length;
  const double met =
      (last.height - first.height - last.slope * length) / (first.slope - last.slope);
  return first.height + first.slope * std::clamp(met, 0.0, length);
}

// Any position of the tool narrowed by r is an upper bound.
double Underside::upper(const Slant& at, double r) const {
  const double reach = radius_ - r, wide = root_or_zero(reach * reach - at.v * at.v);
  const double low = std::max(at.u - at.length, -wide), high = std::min(at.u, wide);
  if (at.v > reach || low > high) return kInfinity;
  const auto value = [&](double e) {
    const double rho = std::min(std::sqrt(e * e + at.v * at.v) + r, radius_);
    return at.slope * (at.u - e) + height(rho) + kRounding;
  };
  const Bracket in =
      high - low <= r ? Bracket{low, high} : contact(at, -r, {low, high}, kBoundSteps);
  return std::min(value(in.low), value(in.high));
}

// The bottom of a ball's move grows with the distance across, and along it away from the place
// above its lower end: of all places in the square about the disc, the one nearest to both has the
// least.
double Underside::ball_lower(const Slant& at, double r) const {
  const double lowest = at.slope > 0 ? 0 : std::clamp(at.u, 0.0, at.length);
  return ball_bottom({std::clamp(lowest, at.u - r, at.u + r), std::max(at.v - r, 0.0), at.length,
                      at.slope}) -
         kRounding;
}

// An upper bound: the height of the position that touches at the far side of the disc.
double Underside::ball_upper(const Slant& at, double r) const {
  const double reach = radius_ - r, square = reach * reach - at.v * at.v;
  if (reach < 0 || square < 0) return kInfinity;
  const double wide = std::sqrt(square);
  const double low = std::max(at.u - at.length, -wide), high = std::min(at.u, wide);
  if (low > high) return kInfinity;
  const double e = ball_contact(at.slope, square, low, high);
  const double rho = std::sqrt(e * e + at.v * at.v) + r;
  return at.slope * (at.u - e) + radius_ - root_or_zero(radius_ * radius_ - rho * rho) + kRounding;
}

Underside::Bounds Underside::bounds(const Slant& at, double r, double below) const {
  const double least = ball_ ? ball_lower(at, r) : lower(at, r);
  if (!(least < below)) return {least, kInfinity};
  return {least, ball_ ? ball_upper(at, r) : upper(at, r)};
}

}  // namespace mrsim
