#include "removal/part/default_stock.h"

#include "core/numbers/motions.h"
#include "removal/forms/sweep_motion.h"
#include "removal/part/default_bar.h"
#include "removal/part/link_moves.h"
#include "removal/part/stock_margin.h"
#include "removal/sweep/sweep_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

// The heights of a program's cuts, infinite where there is none of a kind.
struct Heights {
  double first = kNoHeight;       // where the first cut begins
  double lateral = kNoHeight;     // highest end of a cut aside, below the approach
  double lowest = -kNoHeight;     // and the lowest
  double entered = kNoHeight;     // highest such end that is no way into or out of the material
  double hole_mouth = kNoHeight;  // highest beginning of a plunge
  double hole_end = kNoHeight;    // highest bottom of a hole
  double deepest = -kNoHeight;    // lowest end of any cut

  // Whether no cut lies above z and one below.
  bool reach_below(double z) const {
    return (lateral != kNoHeight ? entered : hole_end) < z + kSameHeight &&
           deepest < z - kSameHeight;
  }
};

class HeightsReader {
 public:
  explicit HeightsReader(double zero) : zero_(zero) {}

  Heights read(std::span<const Motion> motions, const std::vector<bool>& links) {
    for (std::size_t i = 0; i < motions.size(); ++i) {
      const Motion& motion = motions[i];
      if (motion.start.x != motion.end.x || motion.start.y != motion.end.y) end_hole();
      if (is_cut(motion)) note_first(motion);
      if (!is_cut(motion) || links[i])
        end_entry();
      else
        add_cut(motion);
    }
    end_entry();
    end_hole();
    return heights_;
  }

 private:
  void note_first(const Motion& m) {
    if (heights_.first != kNoHeight) return;
    heights_.first = m.start.z;
    approach_ = m.end.z < m.start.z ? m.start.z : -kNoHeight;
  }

  void add_cut(const Motion& m) {
    const Box3 path = path_bounds(localized(m, nullptr));
    heights_.deepest = std::min(heights_.deepest, path.lo.z);
    if (is_upright_line(m)) {
      if (m.end.z > m.start.z) return;  // a tap or a reamer on its way back
      heights_.hole_mouth = std::max(heights_.hole_mouth, m.start.z);
      if (hole_low_ == -kNoHeight) mouth_ = m.start.z, first_stroke_ = m.end.z;
      hole_low_ = std::min(hole_low_, m.end.z);
      return;
    }
    is_entry_ = is_entry_ && m.end.z < m.start.z - kSameHeight;
    if (is_entry_) entry_end_ = m.end.z;
    heights_.entered = std::max(heights_.entered, way_out_);
    way_out_ = kNoHeight;
    const bool leaves = m.kind == MotionKind::arc && m.axis.z == 0 && m.end.z > m.start.z;
    add_height(path.lo.z, heights_.entered);
    add_height(m.start.z, heights_.entered);
    add_height(m.end.z, leaves ? way_out_ : heights_.entered);
    if (path.hi.z <= std::max(m.start.z, m.end.z) + kSameHeight) return;
    heights_.lateral = std::max(heights_.lateral, path.hi.z);  // over the top of an arch
    heights_.entered = std::max(heights_.entered, path.hi.z);
  }

  void add_height(double z, double& entered) {
    if (z >= approach_) return;
    heights_.lateral = std::max(heights_.lateral, z);
    heights_.lowest = std::min(heights_.lowest, z);
    if (!is_entry_) entered = std::max(entered, z);
  }

  // The first strokes of a drill that pecks may end above the stock. Where a hole goes less than a
  // third as far below the zero as it begins above it, the zero is that of the table.
  void end_hole() {
    if (hole_low_ == -kNoHeight) return;
    const bool is_below = 3 * (zero_ - hole_low_) > mouth_ - zero_;
    heights_.hole_end = std::max(heights_.hole_end, is_below ? hole_low_ : first_stroke_);
    hole_low_ = -kNoHeight;
  }

  // A ramp that nothing followed has cut to its end; what goes down next is a way in.
  void end_entry() {
    if (is_entry_) heights_.entered = std::max(heights_.entered, entry_end_);
    entry_end_ = way_out_ = kNoHeight;
    is_entry_ = true;
  }

  double zero_;
  Heights heights_;
  double approach_ = kNoHeight, entry_end_ = kNoHeight;
  double way_out_ = kNoHeight;           // end of an upright arc, if a rapid follows it
  double mouth_ = 0, first_stroke_ = 0;  // of the first plunge at the place where the tool is
  double hole_low_ = -kNoHeight;         // and the lowest one of all there
  bool is_entry_ = true;
};

// The lowest height above `z` that a rapid reaches or a plunge begins at: the stock ends below.
// Strokes after the first of a hole, and rapids between them, say nothing.
double clearance_above(std::span<const Motion> motions, double z) {
  double least = -kNoHeight;
  bool in_hole = false;
  for (const Motion& m : motions) {
    const bool is_rapid = m.kind == MotionKind::rapid && !m.assumed_start;
    const bool upright = m.start.x == m.end.x && m.start.y == m.end.y;
    const bool again = std::exchange(in_hole, upright && (in_hole || is_cut(m))) && upright;
    const double height = is_rapid ? m.end.z : m.start.z;
    if ((is_rapid || is_cut(m)) && !again && height > z + kSameHeight)
      least = std::min(least, height);
  }
  return least;
}

// Height of the top where it is not the program's zero.
double top_of_cuts(std::span<const Motion> motions, const Heights& h, double margin) {
  if (h.lateral == kNoHeight) return h.hole_mouth;
  if (h.lateral - h.lowest > kSameHeight) return h.lateral;
  return std::min(h.lateral + margin, clearance_above(motions, h.lateral));  // cut into something
}

// Distance in plan of a motion's chord from a place.
double distance_in_plan(const Motion& m, const Vec3& p) {
  const double dx = m.end.x - m.start.x, dy = m.end.y - m.start.y;
  const double length2 = dx * dx + dy * dy;
  double t = length2 > 0 ? ((p.x - m.start.x) * dx + (p.y - m.start.y) * dy) / length2 : 0;
  t = std::clamp(t, 0.0, 1.0);
  return std::hypot(m.start.x + t * dx - p.x, m.start.y + t * dy - p.y);
}

// A place beside the stock: a rapid goes down there below the stock's top before anything is cut
// there, or straight down below what has been cut. A rapid to the next pass, horizontal and below
// the top, also leads to such a place.
struct WayDown {
  Vec3 place, from;
  double radius = 0;
  bool is_horizontal = false;
};

// Whether a cut has made way for this rapid. Where the rapid goes straight down, the cut must reach
// down to its end. Other rapids, from row to row of a raster, follow the surface that the next row
// cuts.
bool is_cut_before(std::span<const Motion> motions, std::size_t index, double radius) {
  const Vec3 &from = motions[index].start, &place = motions[index].end;
  const bool is_straight = from.x == place.x && from.y == place.y;
  for (std::size_t i = index; i-- > 0;) {  // most often the last move
    const Motion& m = motions[i];
    if (is_cut(m) && distance_in_plan(m, place) < radius &&
        (!is_straight || std::min(m.start.z, m.end.z) < place.z + kSameHeight))
      return true;
  }
  return false;
}

std::vector<WayDown> ways_down(std::span<const Motion> motions, std::span<const double> radii,
                               double top) {
  constexpr std::size_t kMost = 16;
  std::vector<WayDown> ways;
  bool is_beside = false;  // down there, and nothing cut since: the next rapid is beside it, too
  for (std::size_t i = 0; i < motions.size() && ways.size() < kMost; ++i) {
    const Motion& m = motions[i];
    const bool goes_on = is_beside && m.end.z <= m.start.z;
    const bool is_horizontal = !goes_on && m.end.z == m.start.z;
    is_beside = false;
    if (m.kind != MotionKind::rapid || m.assumed_start || m.tool < 0 ||
        !(m.end.z < m.start.z || goes_on || is_horizontal) || m.end.z > top - kSameHeight)
      continue;
    const double radius = radii[static_cast<std::size_t>(m.tool)];
    const bool known = std::any_of(ways.begin(), ways.end(), [&](const WayDown& w) {
      return std::hypot(w.place.x - m.end.x, w.place.y - m.end.y) <
             (goes_on ? kSameHeight : radius);
    });
    if (!(radius > 0) || (known && is_horizontal) ||
        is_cut_before(motions, i, is_horizontal ? radius / 2 : radius))
      continue;
    is_beside = !is_horizontal;
    if (!known) ways.push_back({m.end, is_horizontal ? m.start : m.end, radius, is_horizontal});
  }
  return ways;
}

// Draws in sides of a stock with this top, so that a tool beside it goes down there.
class SideKeeper {
 public:
  SideKeeper(std::span<const Motion> motions, std::span<const double> radii, double top)
      : motions_(motions), radii_(radii), top_(top) {}

  /// False: for some place a side would take more than a third of the box, or a tenth of what is
  /// cut: the place is inside.
  bool keep_beside(Box3& box) const {
    constexpr double kMostOfCuts = 0.1, kEverywhere = std::numeric_limits<double>::infinity();
    const std::vector<WayDown> ways = ways_down(motions_, radii_, top_);
    const double most = ways.empty() ? 0 : kMostOfCuts * cut_beyond(0, kEverywhere).whole;
    const Vec3 size = box.hi - box.lo;
    bool all = true;
    for (const WayDown& way : ways) all = keep_beside(box, size, way, most) && all;
    return all;
  }

 private:
  // The side beyond which the least is cut, `most` mm at most, the nearest of several.
  // `size`: of the whole box.
  bool keep_beside(Box3& box, const Vec3& size, const WayDown& way, double most) const {
    constexpr double kGap = 0.1, kMostOfSide = 1.0 / 3;
    const double reach = way.radius + kGap;
    const Vec3 &a = way.place, &b = way.from;
    const double places[] = {
        round_up(std::max(a.x, b.x) + reach), round_down(std::min(a.x, b.x) - reach),
        round_up(std::max(a.y, b.y) + reach), round_down(std::min(a.y, b.y) - reach)};
    double* const sides[] = {&box.lo.x, &box.hi.x, &box.lo.y, &box.hi.y};
    int best = -1;
    std::pair<double, double> least;
    for (int side = 0; side < 4; ++side) {
      const double drawn = (side % 2 == 0 ? 1 : -1) * (places[side] - *sides[side]);
      if (drawn <= 0) return true;  // outside already
      if (drawn > kMostOfSide * (side < 2 ? size.x : size.y)) continue;
      const auto [lost, longest] = cut_beyond(side, places[side]);
      const std::pair<double, double> costs(std::floor(lost / way.radius), drawn);
      const bool cuts_along = way.is_horizontal && longest > way.radius / 2;
      if (lost > most || cuts_along || (best >= 0 && costs >= least)) continue;
      best = side;
      least = costs;
    }
    if (best >= 0) *sides[best] = places[best];
    return best >= 0 || way.is_horizontal;  // between two passes inside: through the stock
  }

  struct Lost {
    double whole = 0, longest = 0;  // mm; of all cuts, and of one in plan
  };

  // How much of the way below the top tools would go beside a stock that ends at `at`.
  Lost cut_beyond(int side, double at) const {
    const double sign = side % 2 == 0 ? 1 : -1;
    const auto along = [&](const Vec3& p) { return sign * (side < 2 ? p.x : p.y); };
    Lost lost;
    for (const Motion& m : motions_) {
      if (!is_cut(m) || m.tool < 0 || std::min(m.start.z, m.end.z) > top_ - kSameHeight) continue;
      const bool arc = m.kind == MotionKind::arc;
      const double way = arc ? std::fabs(m.sweep) * m.radius : length(m.end - m.start);
      const double from = arc ? along(m.center) - m.radius : along(m.start);
      const double to = arc ? along(m.center) + m.radius : along(m.end);
      const double end = sign * at - radii_[static_cast<std::size_t>(m.tool)];
      const double low = std::min(from, to), span = std::fabs(to - from);
      const double beside = way * std::clamp((end - low) / std::max(span, kSameHeight), 0.0, 1.0);
      lost.whole += beside;
      if (m.start.x != m.end.x || m.start.y != m.end.y || arc)
        lost.longest = std::max(lost.longest, beside);
    }
    return lost;
  }

  std::span<const Motion> motions_;
  std::span<const double> radii_;
  double top_;
};

// Most programs have their zero on the stock's top; those whose cuts or first move down say
// otherwise end at the highest cut.
void set_top(Box3& box, std::span<const Motion> motions, const std::vector<bool>& links,
             std::span<const double> radii, double margin, double zero) {
  const Heights heights = HeightsReader(zero).read(motions, links);
  if (heights.reach_below(zero)) {
    Box3 narrowed = box;
    if (SideKeeper(motions, radii, zero).keep_beside(narrowed) ||
        heights.first > zero - kSameHeight) {
      box = narrowed;
      box.hi.z = zero;
      return;
    }
  }
  box.hi.z = std::min(top_of_cuts(motions, heights, margin), box.hi.z + margin);
  SideKeeper(motions, radii, box.hi.z).keep_beside(box);
}

StockShape box_round(const Box3& cuts, std::span<const Motion> motions,
                     const std::vector<bool>& links, std::span<const Tool> tools, double zero) {
  const double margin = margin_of(cuts);
  StockShape shape;
  shape.kind = StockShape::Kind::box;
  shape.box.lo = {round_down(cuts.lo.x - margin), round_down(cuts.lo.y - margin),
                  round_down(cuts.lo.z - margin)};
  shape.box.hi = {round_up(cuts.hi.x + margin), round_up(cuts.hi.y + margin), cuts.hi.z};
  set_top(shape.box, motions, links, radii_of(motions, tools), margin, zero);
  const Box3& b = shape.box;
  shape.description =
      fmt::format("around the program's cuts: box:{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}",
                  b.lo.x, b.lo.y, b.lo.z, b.hi.x, b.hi.y, b.hi.z);
  return shape;
}

}  // namespace

AssumedStock default_stock(std::span<const Motion> motions, std::span<const Tool> tools, bool lathe,
                           double zero) {
  if (lathe) return default_bar(motions, tools, zero);
  const std::vector<bool> links = link_moves(motions, zero, false);
  Box3 points;
  for (std::size_t i = 0; i < motions.size(); ++i)
    if (is_cut(motions[i]) && !links[i])
      extend(points, path_bounds(localized(motions[i], nullptr)));
  const SweepTable sweeps(motions, tools);
  Box3 cuts = points;
  for (std::size_t i = 0; i < sweeps.size(); ++i)
    if (!links[static_cast<std::size_t>(sweeps.motion(i))]) extend(cuts, sweeps.bounds(i));
  cuts.hi.z = points.hi.z;
  return {box_round(cuts, motions, links, tools, zero), ""};
}

}  // namespace mrsim
