#include "removal/part/default_bar.h"

#include "core/numbers/motions.h"
#include "core/numbers/units.h"
#include "core/words/tool_types.h"
#include "removal/part/bar_signs.h"
#include "removal/part/link_moves.h"
#include "removal/part/stock_margin.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

// What the cuts of a lathe show of its bar, in radius and Z.
struct TurnedCuts {
  double along = 0;               // largest radius at which a tool cuts towards the chuck
  double inside = 0;              // largest radius of a bore, a recess in it, or a drill
  double across = 0;              // of the points of inside tools
  double widest = 0;              // of all points
  double passes = 0;              // of passes straight towards the chuck
  bool only_passes = true;        // but for ways in from before the face
  double narrowest = -kNoHeight;  // smallest radius that one ends at
  double face = kNoHeight;        // highest Z at which a tool cuts across, towards the axis
  double level_face = kNoHeight;  // and the highest at one Z, but for grooves
  double lowest = -kNoHeight, highest = kNoHeight, turned = kNoHeight;  // turned: inwards, ends
};

// Whether the next move cuts on towards the chuck: then a move across at constant Z is an approach.
bool goes_on_inwards(std::span<const Motion> motions, std::size_t i) {
  return motions[i].start.z == motions[i].end.z && i + 1 < motions.size() &&
         is_cut(motions[i + 1]) && motions[i + 1].end.z < motions[i].end.z - kSameHeight;
}

// The largest radius of a cut, of a line that begins before the face from where it passes that: a
// slope leads into the cut, "G1 X52.8 Z1.4", "X50. Z0".
double widest_of(const Motion& m, double zero) {
  const double from = std::fabs(m.start.x), to = std::fabs(m.end.x);
  if (m.start.z <= zero + kSameHeight || m.end.z > zero + kSameHeight) return std::max(from, to);
  const double passed = (m.start.z - zero) / (m.start.z - m.end.z);
  return std::max(from + passed * (to - from), to);
}

// A slope from before the zero, and from a rapid or a link, to where a face begins: "X52.8 Z1.4",
// "X50. Z0", "X-1.6". Behind the zero it cuts a chamfer: "Z-38", "X46. Z-42", "X0".
bool leads_to_face(std::span<const Motion> motions, const std::vector<bool>& links, std::size_t i,
                   double zero) {
  if (i + 1 >= motions.size() || (i > 0 && is_cut(motions[i - 1]) && !links[i - 1])) return false;
  const Motion &m = motions[i], &next = motions[i + 1];
  const double to = std::fabs(m.end.x);
  return m.kind == MotionKind::line && m.start.z > zero + kSameHeight &&
         m.end.z < m.start.z - kSameHeight && to < std::fabs(m.start.x) - kSameHeight &&
         is_cut(next) && next.end.z == next.start.z && std::fabs(next.end.x) < to - kSameHeight;
}

TurnedCuts turned_cuts(std::span<const Motion> motions, std::span<const Tool> tools,
                       const std::vector<bool>& links, double zero) {
  const std::vector<double> radii = radii_of(motions, tools);
  TurnedCuts cuts;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Motion& m = motions[i];
    if (!is_cut(m) || links[i]) continue;
    const bool to_face = leads_to_face(motions, links, i, zero);
    const double from = std::fabs(m.start.x), to = std::fabs(m.end.x);
    const double wide = to_face ? to : widest_of(m, zero);
    const bool inwards = m.end.z < m.start.z - kSameHeight;
    const bool leads_in =
        to_face || (m.start.z > zero + kSameHeight && m.end.z <= zero + kSameHeight);
    cuts.lowest = std::min({cuts.lowest, m.start.z, m.end.z});
    cuts.highest = std::max({cuts.highest, m.start.z, m.end.z});
    const auto tool = static_cast<std::size_t>(std::max(m.tool, 0));
    const ToolType type = m.tool >= 0 ? tools[tool].type : ToolType::turning;
    if (m.tool >= 0 && is_turning(type) && is_inside_tool(tools[tool])) {
      const bool recesses = std::min(m.start.z, m.end.z) < zero - kSameHeight;
      if (inwards || recesses) cuts.inside = std::max(cuts.inside, wide);
      cuts.across = std::max(cuts.across, wide);
      continue;
    }
    if (!is_turning(type) && wide < kSameHeight) {  // a drill
      cuts.inside = std::max(cuts.inside, radii[tool]);
      continue;
    }
    cuts.widest = std::max(cuts.widest, wide);
    if (m.lead != 0) continue;
    cuts.narrowest = std::min(cuts.narrowest, to);
    // A slope that leads to a face begins in the air, where a rapid ended: only its end counts.
    if (inwards) cuts.along = std::max(cuts.along, to_face ? to : std::max(from, to));
    if (inwards && is_upright_line(m)) cuts.passes = std::max(cuts.passes, wide);
    cuts.only_passes = cuts.only_passes && (is_upright_line(m) || leads_in);
    if (inwards) cuts.turned = std::max(cuts.turned, m.end.z);
    if (to >= from - kSameHeight || leads_in || goes_on_inwards(motions, i)) continue;
    cuts.face = std::max(cuts.face, std::min(m.start.z, m.end.z));
    if (m.start.z == m.end.z && type != ToolType::grooving)
      cuts.level_face = std::max(cuts.level_face, m.end.z);
  }
  return cuts;
}

// Whether the rapid goes back along the stroke that was just cut.
bool goes_back_in(const Motion& cut, const Motion& rapid) {
  return is_cut(cut) && cut.start.z == cut.end.z && rapid.end.z == cut.end.z &&
         std::fabs(rapid.end.x) < std::fabs(cut.start.x) - kSameHeight;
}

// The least radius beyond what is cut towards the chuck that rapids lead to: the bar is thinner.
// A way off a cut, which rapids go on outwards from, says nothing.
double clear_radius(std::span<const Motion> motions, const std::vector<bool>& links,
                    const TurnedCuts& cuts) {
  double least = -kNoHeight, beyond = 0;  // beyond: the largest radius of the rapids that follow
  for (std::size_t i = motions.size(); i-- > 0;) {
    const Motion& m = motions[i];
    if (is_cut(m)) beyond = 0;
    const bool leads_on = i + 1 < motions.size() && !motions[i + 1].assumed_start;
    if (m.kind != MotionKind::rapid || (m.assumed_start && !leads_on)) continue;
    const double r = std::fabs(m.end.x);
    const bool is_off =
        links[i] || r < beyond - kSameHeight || (i > 0 && goes_back_in(motions[i - 1], m));
    if (!is_off && r > cuts.along + kSameHeight) least = std::min(least, r);
    beyond = std::max(beyond, r);
  }
  return least;
}

bool works_outside(const Motion& m, std::span<const Tool> tools) {
  if (m.tool < 0) return true;
  const Tool& tool = tools[static_cast<std::size_t>(m.tool)];
  return is_turning(tool.type) && !is_inside_tool(tool);
}

// The radius from which the tool comes to the widest pass, which cuts something. It is the least
// radius beyond the pass from which a feed leads in (from which a rapid does, if there is only one
// pass), or the radius to which a way off the pass leads, if that is more. 0: nothing tells it.
double approach_radius(std::span<const Motion> motions, std::span<const Tool> tools,
                       const std::vector<bool>& links, const TurnedCuts& cuts) {
  double least = -kNoHeight, off = 0;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const double from = std::fabs(motions[i].start.x), to = std::fabs(motions[i].end.x);
    if (!links[i] || !works_outside(motions[i], tools)) continue;
    if (from > std::max(cuts.widest, to) + kSameHeight) least = std::min(least, from);
    const bool off_pass =
        is_cut(motions[i]) && i > 0 && is_cut(motions[i - 1]) && is_upright_line(motions[i - 1]);
    if (off_pass && std::fabs(from - cuts.widest) < kSameHeight) off = std::max(off, to);
  }
  if (cuts.only_passes && cuts.widest - cuts.narrowest < kSameHeight)
    least = std::min(least, clear_radius(motions, links, cuts));
  return least == -kNoHeight ? off : std::max(least, off);
}

// Places outside that tools have cut, by their Z and least radius.
class CutPlaces {
 public:
  void add(const Motion& m, std::span<const Tool> tools) {
    const bool plain = m.tool < 0 || !lies_before_tip(tools[static_cast<std::size_t>(m.tool)]);
    places_.push_back({std::min(m.start.z, m.end.z) - (plain ? kBeside : 0),
                       std::max(m.start.z, m.end.z) + kBeside,
                       std::min(std::fabs(m.start.x), std::fabs(m.end.x))});
  }
  bool may_be_cut(const Vec3& p) const {
    return std::any_of(places_.begin(), places_.end(), [&](const Place& place) {
      return p.z > place.low && p.z < place.high && std::fabs(p.x) > place.radius - kSameHeight;
    });
  }

 private:
  // A right-hand insert whose leading edge does not lean towards the chuck cuts nothing behind it.
  static bool lies_before_tip(const Tool& tool) {
    return tool.type == ToolType::turning && tip_orientation(tool) == 3 &&
           !tool.tip_is_nose_centre && tool.lead_angle >= radians(90);
  }
  static constexpr double kBeside = 16;  // mm: as far as an insert reaches
  struct Place {
    double low, high, radius;
  };
  std::vector<Place> places_;
};

// The least radius behind `front` to which a rapid leads where nothing has been cut: the bar must
// be thinner than that. Radii within the part, or where a cut has passed, say nothing.
double entered_radius(std::span<const Motion> motions, std::span<const Tool> tools,
                      const TurnedCuts& cuts, double front) {
  const double part = std::max(cuts.along, cuts.narrowest) + kSameHeight;
  double least = -kNoHeight;
  CutPlaces places;
  for (const Motion& m : motions) {
    if (is_cut(m)) {
      if (m.lead == 0) places.add(m, tools);
      continue;
    }
    const double radius = std::fabs(m.end.x);
    if (m.kind == MotionKind::rapid && !m.assumed_start && works_outside(m, tools) &&
        m.end.z < front - kSameHeight && radius > part && radius < least &&
        !places.may_be_cut(m.end))
      least = radius;
  }
  return least;
}

bool rapids_reach(std::span<const Motion> motions, double radius) {
  return std::any_of(motions.begin(), motions.end(), [&](const Motion& m) {
    return m.kind == MotionKind::rapid && std::fabs(std::fabs(m.end.x) - radius) < kSameHeight;
  });
}

// The least Z before the face that a rapid leads to within the bar's radius: the bar is shorter.
double clear_front(std::span<const Motion> motions, const TurnedCuts& cuts, double radius) {
  double least = -kNoHeight;
  for (const Motion& m : motions) {
    if (m.kind != MotionKind::rapid || m.assumed_start) continue;
    for (const Vec3& p : {m.start, m.end})
      if (std::fabs(p.x) < radius && p.z > cuts.face + kSameHeight) least = std::min(least, p.z);
  }
  return least;
}

// Most programs have their zero on the finished face; what they face is there to be cut.
double front_of(const TurnedCuts& cuts, double clearance, double zero) {
  if (cuts.face < zero - kSameHeight && cuts.lowest < zero - kSameHeight)
    return cuts.turned > zero + 5 * kLeastMargin ? cuts.highest : zero;  // zero in the chuck
  if (cuts.face == kNoHeight || clearance == -kNoHeight) return cuts.highest;
  return cuts.face + std::min(kLeastMargin, (clearance - cuts.face) / 2);
}

// mm: how far cuts run out in the air, and links lead beside the bar. What would make it thinner or
// shorter by more is no sign of that.
constexpr double kMostAir = 6;

// The radius of the bar and its ends in Z, rounded.
struct Bar {
  double radius = 0, low = 0, front = 0;
};

Bar bar_of(std::span<const Motion> motions, std::span<const Tool> tools,
           const std::vector<bool>& links, double zero, TurnedCuts& cuts) {
  cuts = turned_cuts(motions, tools, links, zero);
  if (std::max(cuts.widest, cuts.inside) == 0) cuts.inside = cuts.across;  // G72 in a bore alone
  const double wide = std::max(cuts.widest, cuts.inside);
  const double margin = margin_of({{-wide, -wide, cuts.lowest}, {wide, wide, cuts.highest}});
  const double clear = clear_radius(motions, links, cuts);
  if (cuts.widest > 0 && cuts.passes > cuts.widest - kSameHeight) {
    const double limit = approach_radius(motions, tools, links, cuts);
    cuts.widest = std::clamp(limit, cuts.widest, cuts.widest + margin);
  }
  const bool is_thinner =
      clear < cuts.widest && clear > cuts.narrowest + kSameHeight && clear > cuts.widest - kMostAir;
  const double edge =
      std::min(is_thinner ? clear : cuts.widest, entered_radius(motions, tools, cuts, zero));
  const double outer =
      is_thinner || rapids_reach(motions, edge) ? round_down(edge) : round_up(edge);
  const double bored = cuts.inside > 0 ? round_up(cuts.inside + margin) : 0;
  Bar bar{std::max({outer, bored, 0.1}), round_down(cuts.lowest - margin), 0};
  const double front = front_of(cuts, clear_front(motions, cuts, bar.radius), zero);
  bar.front = std::max(front, bar.low + margin);
  return bar;
}

// What a bar is taken for beyond its sizes, in words.
struct Guesses {
  std::string text;
  void add(const std::string& guess) { text += (text.empty() ? "" : "; ") + guess; }
};

// The Z that the cuts count from: the program's zero, or where the bar begins far in front of that.
// `ways`: where tools begin to cut, for the report; reset if a face in front of that decides.
double origin_of(std::span<const Motion> motions, std::span<const Tool> tools, double zero,
                 FarWays& ways) {
  const TurnedCuts cuts = turned_cuts(motions, tools, link_moves(motions, zero, true), zero);
  ways = far_ways(motions, tools, zero);
  const double nearest = ways.is_front ? ways.begin - kMostAir : zero + kMostAir;
  if (cuts.level_face <= nearest) return ways.is_front ? ways.begin : zero;
  ways = {};
  return cuts.level_face;  // the bar begins at it
}

std::string guess_of_front(const FarWays& ways, double zero, double front) {
  return fmt::format(
      "tools begin to cut {:.6g} mm in front of the zero, and the bar is taken to begin {}",
      ways.begin - zero, front > ways.begin - kLeastMargin ? "there" : "behind that");
}

StockShape bar_of_program(std::span<const Motion> motions, std::span<const Tool> tools, double zero,
                          Guesses& guesses) {
  TurnedCuts all, cuts;
  FarWays ways;
  const double from = origin_of(motions, tools, zero, ways);
  const Bar with_links = bar_of(motions, tools, std::vector<bool>(motions.size()), from, all);
  Bar bar = bar_of(motions, tools, link_moves(motions, from, true), from, cuts);
  if (bar.radius < with_links.radius - kMostAir) bar.radius = with_links.radius;
  if (bar.front < with_links.front - kMostAir) bar.front = with_links.front;
  if (ways.begin != kNoHeight)
    guesses.add(guess_of_front(ways, zero, bar.front));
  else if (from == zero && bar.front > zero + kMostAir)
    guesses.add(
        fmt::format("nothing faces the bar, which is taken to begin {:.6g} mm in front of "
                    "the zero",
                    bar.front - zero));
  StockShape shape;
  shape.kind = StockShape::Kind::cylinder;
  shape.outer_radius = bar.radius;
  shape.box = {{-bar.radius, -bar.radius, bar.low}, {bar.radius, bar.radius, bar.front}};
  const double bored = std::max(cuts.inside, cuts.across);
  double hole = round_up(entered_hole(motions, tools, bar.front));
  if (!(hole >= kLeastMargin && hole < bored)) {
    hole = round_down(needed_hole(motions, tools, bar.front));
    if (hole > 0)
      guesses.add(
          fmt::format("a boring bar goes in where nothing drills before, and a hole of {:.6g} mm "
                      "is taken to be there",
                      2 * hole));
  }
  if (hole >= kLeastMargin && hole < bored) {
    shape.kind = StockShape::Kind::tube;
    shape.inner_radius = hole;
  }
  return shape;
}

}  // namespace

AssumedStock default_bar(std::span<const Motion> motions, std::span<const Tool> tools,
                         double zero) {
  StockShape shape;
  Guesses guesses;
  const HeldEnd end = held_end(motions, zero);
  if (end == HeldEnd::plus) {
    shape = bar_of_program(mirrored_in_z(motions), mirrored_in_z(tools), -zero, guesses);
    shape.box = {{shape.box.lo.x, shape.box.lo.y, 0 - shape.box.hi.z},
                 {shape.box.hi.x, shape.box.hi.y, 0 - shape.box.lo.z}};
  } else {
    shape = bar_of_program(motions, tools, zero, guesses);
  }
  if (end != HeldEnd::minus)
    guesses.add(
        fmt::format("all tools cut towards +Z, and the bar is taken to be held at its end "
                    "towards {}Z",
                    end == HeldEnd::plus ? '+' : '-'));
  const bool is_hollow = shape.kind == StockShape::Kind::tube;
  shape.description = fmt::format("around the program's cuts: {}:{:.6g},{}{:.6g},{:.6g}",
                                  is_hollow ? "tube" : "cylinder", 2 * shape.outer_radius,
                                  is_hollow ? fmt::format("{:.6g},", 2 * shape.inner_radius) : "",
                                  shape.box.lo.z, shape.box.hi.z);
  return {std::move(shape), std::move(guesses.text)};
}

}  // namespace mrsim
