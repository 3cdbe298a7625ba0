#include "removal/history/wall_lines.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr double kSteep = 0.125;  // of the depth of cut: where it differs by more, a part halves
constexpr double kEven = 1e-3;    // the same: where it differs by less, parts join
constexpr double kInside = 1e-6;  // a wall on the square's side is none within
constexpr double kGauss = 0.28867513459481287;  // 1 / sqrt(12): the two lines of a square

bool differ(double share, double a, double b) { return std::abs(a - b) > share * std::max(a, b); }

}  // namespace

// Later sweeps lie lower as a rule, and those that can not be lower cost a comparison.
double WallLines::depth(const Vec2& at) const {
  double low = high_;
  for (auto i = list_.rbegin(); i != list_.rend() && low > low_; ++i)
    low = std::min(low, heights_.bottom(*i, at.x, at.y, low));
  return high_ - std::max(low, low_);
}

// The staircase in the middle stands for the whole stretch.
void WallLines::finish_stretch() {
  const Vec2 at = start_ + 0.5 * (stretch_.from + stretch_.to) * along_;
  const double share = stretch_.to - stretch_.from;
  double low = high_;
  for (std::size_t i = 0; i < list_.size() && low > low_; ++i) {
    const double bottom = std::max(heights_.bottom(list_[i], at.x, at.y, low), low_);
    if (!(bottom < low)) continue;
    depths_[i] += share * (low - bottom);
    low = bottom;
  }
}

void WallLines::extend(double from, double depth, double to, double depth_there) {
  const bool joins = stretch_.to > stretch_.from && !differ(kEven, stretch_.depth, depth) &&
                     !differ(kEven, stretch_.depth, depth_there);
  if (joins) {
    stretch_.to = to;
    return;
  }
  if (stretch_.to > stretch_.from) finish_stretch();
  stretch_ = {from, to, depth};
}

void WallLines::divide(double from, double depth, double to, double depth_there) {
  if (to - from <= fineness_.shortest || !differ(kSteep, depth, depth_there))
    return extend(from, depth, to, depth_there);
  const double middle = 0.5 * (from + to), between = depth_on_line(middle);
  divide(from, depth, middle, between);
  divide(middle, between, to, depth_there);
}

void WallLines::walk_line(const Vec2& start, const Vec2& along) {
  start_ = start, along_ = along, stretch_ = {};
  double depth = depth_on_line(0);
  for (int k = 1; k <= fineness_.parts; ++k) {
    const double to = double(k) / fineness_.parts, there = depth_on_line(to);
    divide(double(k - 1) / fineness_.parts, depth, to, there);
    depth = there;
  }
  finish_stretch();
}

std::span<const double> WallLines::depths(const Vec2& center, const Vec2& side,
                                          std::span<const std::uint32_t> list) {
  list_ = list;
  depths_.assign(list.size(), 0);
  const Vec2 half = (0.5 - kInside) * side;
  const auto corner = [&](double x, double y) {
    return depth(center + Vec2{x * half.x, y * half.y});
  };
  const double a = corner(-1, -1), b = corner(1, -1), c = corner(-1, 1), d = corner(1, 1);
  const bool along_x = std::abs(b - a) + std::abs(d - c) >= std::abs(c - a) + std::abs(d - b);
  for (const double offset : {-kGauss, kGauss})
    if (along_x)
      walk_line(center + Vec2{-half.x, offset * side.y}, {2 * half.x, 0});
    else
      walk_line(center + Vec2{offset * side.x, -half.y}, {0, 2 * half.y});
  for (double& depth : depths_) depth *= 0.5;
  return depths_;
}

}  // namespace mrsim
