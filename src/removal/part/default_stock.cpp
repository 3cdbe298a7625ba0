#include "removal/part/default_stock.h"

#include "removal/sweep/sweep_motion.h"
#include "removal/sweep/sweep_table.h"
#include "removal/tool/tool.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kMargin = 0.05;
constexpr double kLeastMargin = 1;   // mm
constexpr double kSameLevel = 1e-6;  // mm: heights nearer than this are one
constexpr double kNoHeight = -std::numeric_limits<double>::infinity();

double margin_of(const Box3& box) {
  const double longest = std::max({box.hi.x - box.lo.x, box.hi.y - box.lo.y, box.hi.z - box.lo.z});
  return std::ceil(std::max(kLeastMargin, kMargin * longest));
}

// Whole tenths of a millimetre, outwards: a stock that can be typed again.
double down(double v) { return std::floor(v * 10) / 10; }
double up(double v) { return std::ceil(v * 10) / 10; }

// The heights of a program's cuts, infinite where there is none of a kind.
struct Heights {
  double first = kNoHeight;       // where the first cut begins
  double lateral = kNoHeight;     // highest end of a cut aside, below the approach
  double lowest = -kNoHeight;     // and the lowest
  double entered = kNoHeight;     // highest of them but for ways into the material and out
  double hole_mouth = kNoHeight;  // highest beginning of a plunge
  double hole_end = kNoHeight;    // highest end of one
  double deepest = -kNoHeight;    // lowest end of any cut

  // Whether no cut lies above z and one below.
  bool reach_below(double z) const {
    return (lateral != kNoHeight ? entered : hole_end) < z + kSameLevel && deepest < z - kSameLevel;
  }
};

class HeightsReader {
 public:
  Heights read(std::span<const Motion> motions) {
    for (const Motion& motion : motions) {
      if (is_cut(motion))
        add_cut(motion);
      else
        end_entry();
    }
    end_entry();
    return heights_;
  }

 private:
  void add_cut(const Motion& m) {
    if (heights_.first == kNoHeight) {
      heights_.first = m.start.z;
      approach_ = m.end.z < m.start.z ? m.start.z : -kNoHeight;
    }
    const Box3 path = path_bounds(localized(m, nullptr));
    heights_.deepest = std::min(heights_.deepest, path.lo.z);
    if (m.kind != MotionKind::arc && m.start.x == m.end.x && m.start.y == m.end.y) {
      if (m.end.z > m.start.z) return;  // a tap or a reamer on its way back
      heights_.hole_mouth = std::max(heights_.hole_mouth, m.start.z);
      heights_.hole_end = std::max(heights_.hole_end, m.end.z);
      return;
    }
    is_entry_ = is_entry_ && m.end.z < m.start.z - kSameLevel;
    if (is_entry_) entry_end_ = m.end.z;
    heights_.entered = std::max(heights_.entered, way_out_);
    way_out_ = kNoHeight;
    const bool leaves = m.kind == MotionKind::arc && m.axis.z == 0 && m.end.z > m.start.z;
    add_height(path.lo.z, heights_.entered);
    add_height(m.start.z, heights_.entered);
    add_height(m.end.z, leaves ? way_out_ : heights_.entered);
    if (path.hi.z <= std::max(m.start.z, m.end.z) + kSameLevel) return;
    heights_.lateral = std::max(heights_.lateral, path.hi.z);  // over the top of an arch
    heights_.entered = std::max(heights_.entered, path.hi.z);
  }

  void add_height(double z, double& entered) {
    if (z >= approach_) return;
    heights_.lateral = std::max(heights_.lateral, z);
    heights_.lowest = std::min(heights_.lowest, z);
    if (!is_entry_) entered = std::max(entered, z);
  }

  // A ramp that nothing follows has cut to its end.
  void end_entry() {
    if (is_entry_) heights_.entered = std::max(heights_.entered, entry_end_);
    is_entry_ = true;
    entry_end_ = way_out_ = kNoHeight;
  }

  Heights heights_;
  double approach_ = kNoHeight, entry_end_ = kNoHeight;
  double way_out_ = kNoHeight;  // end of an upright arc, if a rapid follows it
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
    if ((is_rapid || is_cut(m)) && !again && height > z + kSameLevel)
      least = std::min(least, height);
  }
  return least;
}

// Height of the top where it is not the program's zero.
double top_of_cuts(std::span<const Motion> motions, const Heights& h, double margin) {
  if (h.lateral == kNoHeight) return h.hole_mouth;
  if (h.lateral - h.lowest > kSameLevel) return h.lateral;
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

// A place where a rapid goes down below the stock's top before anything is cut there: beside it.
struct WayDown {
  Vec3 place;
  double radius = 0;
};

// Radius of each tool that cuts, 0 of the others.
std::vector<double> radii_of(std::span<const Motion> motions, std::span<const Tool> tools) {
  std::vector<double> radii(tools.size(), 0);
  for (const Motion& m : motions) {
    if (!is_cut(m) || m.tool < 0) continue;
    double& radius = radii[static_cast<std::size_t>(m.tool)];
    if (radius == 0) radius = make_tool_shape(tools[static_cast<std::size_t>(m.tool)]).radius;
  }
  return radii;
}

bool is_cut_before(std::span<const Motion> motions, std::size_t index, double radius) {
  const Vec3& place = motions[index].end;
  for (std::size_t i = index; i-- > 0;)  // most often the last move
    if (is_cut(motions[i]) && distance_in_plan(motions[i], place) < radius) return true;
  return false;
}

std::vector<WayDown> ways_down(std::span<const Motion> motions, std::span<const double> radii,
                               double top) {
  constexpr std::size_t kMost = 16;
  std::vector<WayDown> ways;
  for (std::size_t i = 0; i < motions.size() && ways.size() < kMost; ++i) {
    const Motion& m = motions[i];
    if (m.kind != MotionKind::rapid || m.assumed_start || m.tool < 0 || m.end.z >= m.start.z ||
        m.end.z > top - kSameLevel)
      continue;
    const double radius = radii[static_cast<std::size_t>(m.tool)];
    const bool known = std::any_of(ways.begin(), ways.end(), [&](const WayDown& w) {
      return std::hypot(w.place.x - m.end.x, w.place.y - m.end.y) < radius;
    });
    if (radius > 0 && !known && !is_cut_before(motions, i, radius)) ways.push_back({m.end, radius});
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
    const double most = ways.empty() ? 0 : kMostOfCuts * cut_beyond(0, kEverywhere);
    bool all = true;
    for (const WayDown& way : ways) all = keep_beside(box, way, most) && all;
    return all;
  }

 private:
  // The side beyond which the least is cut, `most` mm at most, the nearest of several.
  bool keep_beside(Box3& box, const WayDown& way, double most) const {
    constexpr double kGap = 0.1, kMostOfSide = 1.0 / 3;
    const double reach = way.radius + kGap;
    const double places[] = {up(way.place.x + reach), down(way.place.x - reach),
                             up(way.place.y + reach), down(way.place.y - reach)};
    double* const sides[] = {&box.lo.x, &box.hi.x, &box.lo.y, &box.hi.y};
    int best = -1;
    std::pair<double, double> least;
    for (int side = 0; side < 4; ++side) {
      const double drawn = (side % 2 == 0 ? 1 : -1) * (places[side] - *sides[side]);
      if (drawn <= 0) return true;  // outside already
      const double length = side < 2 ? box.hi.x - box.lo.x : box.hi.y - box.lo.y;
      if (drawn > kMostOfSide * length) continue;
      const double lost = cut_beyond(side, places[side]);
      const std::pair<double, double> costs(std::floor(lost / way.radius), drawn);
      if (lost > most || (best >= 0 && costs >= least)) continue;
      best = side;
      least = costs;
    }
    if (best >= 0) *sides[best] = places[best];
    return best >= 0;
  }

  // How much of the way below the top tools would go beside a stock that ends at `at`.
  double cut_beyond(int side, double at) const {
    const double sign = side % 2 == 0 ? 1 : -1;
    const auto along = [&](const Vec3& p) { return sign * (side < 2 ? p.x : p.y); };
    double lost = 0;
    for (const Motion& m : motions_) {
      if (!is_cut(m) || m.tool < 0 || std::min(m.start.z, m.end.z) > top_ - kSameLevel) continue;
      const bool arc = m.kind == MotionKind::arc;
      const double way = arc ? std::fabs(m.sweep) * m.radius : length(m.end - m.start);
      const double from = arc ? along(m.center) - m.radius : along(m.start);
      const double to = arc ? along(m.center) + m.radius : along(m.end);
      const double end = sign * at - radii_[static_cast<std::size_t>(m.tool)];
      const double low = std::min(from, to), span = std::fabs(to - from);
      lost += way * std::clamp((end - low) / std::max(span, kSameLevel), 0.0, 1.0);
    }
    return lost;
  }

  std::span<const Motion> motions_;
  std::span<const double> radii_;
  double top_;
};

// Most programs have their zero on the stock's top; those whose cuts or first move down say
// otherwise end at the highest cut.
void set_top(Box3& box, std::span<const Motion> motions, std::span<const double> radii,
             double margin, double zero) {
  const Heights heights = HeightsReader().read(motions);
  if (heights.reach_below(zero)) {
    Box3 narrowed = box;
    if (SideKeeper(motions, radii, zero).keep_beside(narrowed) ||
        heights.first > zero - kSameLevel) {
      box = narrowed;
      box.hi.z = zero;
      return;
    }
  }
  box.hi.z = std::min(top_of_cuts(motions, heights, margin), box.hi.z + margin);
  SideKeeper(motions, radii, box.hi.z).keep_beside(box);
}

StockShape box_round(const Box3& cuts, std::span<const Motion> motions, std::span<const Tool> tools,
                     double zero) {
  const double margin = margin_of(cuts);
  StockShape shape;
  shape.kind = StockShape::Kind::box;
  shape.box.lo = {down(cuts.lo.x - margin), down(cuts.lo.y - margin), down(cuts.lo.z - margin)};
  shape.box.hi = {up(cuts.hi.x + margin), up(cuts.hi.y + margin), cuts.hi.z};
  set_top(shape.box, motions, radii_of(motions, tools), margin, zero);
  const Box3& b = shape.box;
  shape.description =
      fmt::format("around the program's cuts: box:{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}",
                  b.lo.x, b.lo.y, b.lo.z, b.hi.x, b.hi.y, b.hi.z);
  return shape;
}

// What the cuts of a lathe tell of its bar, in radius and Z.
struct TurnedCuts {
  double along = 0;               // largest radius at which a tool cuts towards the chuck
  double inside = 0;              // largest radius of a bore or a drill
  double widest = 0;              // of all points
  double narrowest = -kNoHeight;  // smallest radius that one ends at
  double face = kNoHeight;        // highest Z at which a tool cuts across, towards the axis
  double lowest = -kNoHeight, highest = kNoHeight, turned = kNoHeight;  // turned: inwards, ends
};

// Whether the next move cuts on towards the chuck: then a move across at constant Z is an approach.
bool goes_on_inwards(std::span<const Motion> motions, std::size_t i) {
  return motions[i].start.z == motions[i].end.z && i + 1 < motions.size() &&
         is_cut(motions[i + 1]) && motions[i + 1].end.z < motions[i].end.z - kSameLevel;
}

TurnedCuts turned_cuts(std::span<const Motion> motions, std::span<const Tool> tools) {
  const std::vector<double> radii = radii_of(motions, tools);
  TurnedCuts cuts;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Motion& m = motions[i];
    if (!is_cut(m)) continue;
    const double from = std::fabs(m.start.x), to = std::fabs(m.end.x), wide = std::max(from, to);
    const bool inwards = m.end.z < m.start.z - kSameLevel;
    cuts.lowest = std::min({cuts.lowest, m.start.z, m.end.z});
    cuts.highest = std::max({cuts.highest, m.start.z, m.end.z});
    const auto tool = static_cast<std::size_t>(std::max(m.tool, 0));
    const ToolType type = m.tool >= 0 ? tools[tool].type : ToolType::turning;
    if (type == ToolType::boring) {
      if (inwards) cuts.inside = std::max(cuts.inside, wide);
      continue;
    }
    if (!is_turning(type) && wide < kSameLevel) {  // a drill
      cuts.inside = std::max(cuts.inside, radii[tool]);
      continue;
    }
    cuts.widest = std::max(cuts.widest, wide);
    if (m.lead != 0) continue;
    cuts.narrowest = std::min(cuts.narrowest, to);
    if (inwards) cuts.along = std::max(cuts.along, wide);
    if (inwards) cuts.turned = std::max(cuts.turned, m.end.z);
    if (to < from - kSameLevel && !goes_on_inwards(motions, i))
      cuts.face = std::max(cuts.face, std::min(m.start.z, m.end.z));
  }
  return cuts;
}

// The least radius beyond what is cut towards the chuck that a rapid leads to: the bar is thinner.
double clear_radius(std::span<const Motion> motions, const TurnedCuts& cuts) {
  double least = -kNoHeight;
  for (const Motion& m : motions) {
    if (m.kind != MotionKind::rapid || m.assumed_start) continue;
    for (const double r : {std::fabs(m.start.x), std::fabs(m.end.x)})
      if (r > cuts.along + kSameLevel) least = std::min(least, r);
  }
  return least;
}

bool rapids_reach(std::span<const Motion> motions, double radius) {
  return std::any_of(motions.begin(), motions.end(), [&](const Motion& m) {
    return m.kind == MotionKind::rapid && std::fabs(std::fabs(m.end.x) - radius) < kSameLevel;
  });
}

// The least Z before the face that a rapid leads to within the bar's radius: the bar is shorter.
double clear_front(std::span<const Motion> motions, const TurnedCuts& cuts, double radius) {
  double least = -kNoHeight;
  for (const Motion& m : motions) {
    if (m.kind != MotionKind::rapid || m.assumed_start) continue;
    for (const Vec3& p : {m.start, m.end})
      if (std::fabs(p.x) < radius && p.z > cuts.face + kSameLevel) least = std::min(least, p.z);
  }
  return least;
}

// Most programs have their zero on the finished face; what they face is there to be cut.
double front_of(const TurnedCuts& cuts, double clearance, double zero) {
  if (cuts.face < zero - kSameLevel && cuts.lowest < zero - kSameLevel)
    return cuts.turned > zero + 5 * kLeastMargin ? cuts.highest : zero;  // zero in the chuck
  if (cuts.face == kNoHeight || clearance == -kNoHeight) return cuts.highest;
  return cuts.face + std::min(kLeastMargin, (clearance - cuts.face) / 2);
}

StockShape cylinder_round(std::span<const Motion> motions, std::span<const Tool> tools,
                          double zero) {
  const TurnedCuts cuts = turned_cuts(motions, tools);
  const double wide = std::max(cuts.widest, cuts.inside);
  const double margin = margin_of({{-wide, -wide, cuts.lowest}, {wide, wide, cuts.highest}});
  const double clear = clear_radius(motions, cuts);
  const bool is_thinner = clear < cuts.widest && clear > cuts.narrowest + kSameLevel;
  const double edge = is_thinner ? clear : cuts.widest;
  const double outer = is_thinner || rapids_reach(motions, edge) ? down(edge) : up(edge);
  const double bored = cuts.inside > 0 ? up(cuts.inside + margin) : 0;
  const double radius = std::max({outer, bored, 0.1});
  StockShape shape;
  shape.kind = StockShape::Kind::cylinder;
  shape.outer_radius = radius;
  shape.box.lo = {-radius, -radius, down(cuts.lowest - margin)};
  const double front = front_of(cuts, clear_front(motions, cuts, radius), zero);
  shape.box.hi = {radius, radius, std::max(front, shape.box.lo.z + margin)};
  shape.description = fmt::format("around the program's cuts: cylinder:{:.6g},{:.6g},{:.6g}",
                                  2 * radius, shape.box.lo.z, shape.box.hi.z);
  return shape;
}

}  // namespace

StockShape default_stock(std::span<const Motion> motions, std::span<const Tool> tools, bool lathe,
                         double zero) {
  if (lathe) return cylinder_round(motions, tools, zero);
  Box3 points;
  for (const Motion& motion : motions)
    if (is_cut(motion)) extend(points, path_bounds(localized(motion, nullptr)));
  const SweepTable sweeps(motions, tools);
  Box3 cuts = points;
  for (std::size_t i = 0; i < sweeps.size(); ++i) extend(cuts, sweeps.bounds(i));
  cuts.hi.z = points.hi.z;
  return box_round(cuts, motions, tools, zero);
}

}  // namespace mrsim
