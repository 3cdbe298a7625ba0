#include "removal/part/default_stock.h"

#include "removal/sweep/sweep_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kMargin = 0.05;
constexpr double kLeastMargin = 1;  // mm

void include(Box3& box, const Vec3& p) {
  box.lo = {std::min(box.lo.x, p.x), std::min(box.lo.y, p.y), std::min(box.lo.z, p.z)};
  box.hi = {std::max(box.hi.x, p.x), std::max(box.hi.y, p.y), std::max(box.hi.z, p.z)};
}

double margin_of(const Box3& box) {
  const double longest = std::max({box.hi.x - box.lo.x, box.hi.y - box.lo.y, box.hi.z - box.lo.z});
  return std::ceil(std::max(kLeastMargin, kMargin * longest));
}

// Whole tenths of a millimetre, outwards: a stock that can be typed again.
double down(double v) { return std::floor(v * 10) / 10; }
double up(double v) { return std::ceil(v * 10) / 10; }

StockShape box_round(const Box3& cuts) {
  const double margin = margin_of(cuts);
  StockShape shape;
  shape.kind = StockShape::Kind::box;
  shape.box.lo = {down(cuts.lo.x - margin), down(cuts.lo.y - margin), down(cuts.lo.z - margin)};
  shape.box.hi = {up(cuts.hi.x + margin), up(cuts.hi.y + margin), cuts.hi.z};
  if (cuts.hi.z - cuts.lo.z < 1e-3) shape.box.hi.z += margin;  // one level only: cut into something
  const Box3& b = shape.box;
  shape.description =
      fmt::format("around the program's cuts: box:{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}",
                  b.lo.x, b.lo.y, b.lo.z, b.hi.x, b.hi.y, b.hi.z);
  return shape;
}

StockShape cylinder_round(const Box3& points) {
  const double margin = margin_of(points);
  StockShape shape;
  shape.kind = StockShape::Kind::cylinder;
  const double radius = up(std::max({std::fabs(points.lo.x), std::fabs(points.hi.x), 0.1}));
  shape.outer_radius = radius;
  shape.box.lo = {-radius, -radius, down(points.lo.z - margin)};
  shape.box.hi = {radius, radius, std::max(points.hi.z, shape.box.lo.z + margin)};
  shape.description = fmt::format("around the program's cuts: cylinder:{:.6g},{:.6g},{:.6g}",
                                  2 * radius, shape.box.lo.z, shape.box.hi.z);
  return shape;
}

}  // namespace

// Height of the stock's top: the highest point of a cut that lies below the start of the first
// plunge. A plunge counts with its lower end, where cuts aside follow it. Where nothing but plunges
// is cut, they are holes: the top is where their feed begins.
double top_of(std::span<const Motion> motions, double highest) {
  constexpr double kNoHeight = -std::numeric_limits<double>::infinity();
  double approach = kNoHeight, lateral = kNoHeight, plunge = kNoHeight;
  for (const Motion& motion : motions) {
    if (!is_cut(motion)) continue;
    if (approach == kNoHeight)
      approach = motion.end.z < motion.start.z ? motion.start.z : -kNoHeight;
    const bool aside = motion.kind == MotionKind::arc || motion.start.x != motion.end.x ||
                       motion.start.y != motion.end.y;
    if (!aside) {
      plunge = std::max(plunge, motion.start.z);
      continue;
    }
    for (const double z : {motion.start.z, motion.end.z})
      if (z < approach) lateral = std::max(lateral, z);
  }
  if (lateral != kNoHeight) return std::min(lateral, highest);
  return plunge != kNoHeight ? std::min(plunge, highest) : highest;
}

StockShape default_stock(std::span<const Motion> motions, std::span<const Tool> tools, bool lathe) {
  Box3 points;
  for (const Motion& motion : motions)
    if (is_cut(motion)) {
      include(points, motion.start);
      include(points, motion.end);
    }
  if (lathe) return cylinder_round(points);
  const SweepTable sweeps(motions, tools);
  Box3 cuts = points;
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    const Box3 box = sweeps.bounds(i);
    include(cuts, {box.lo.x, box.lo.y, box.lo.z});
    include(cuts, {box.hi.x, box.hi.y, cuts.hi.z});
  }
  cuts.hi.z = top_of(motions, points.hi.z);
  return box_round(cuts);
}

}  // namespace mrsim
