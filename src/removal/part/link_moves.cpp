#include "removal/part/link_moves.h"

#include "core/numbers/motions.h"
#include "removal/part/stock_margin.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace mrsim {
namespace {

class LinkFinder {
 public:
  LinkFinder(std::span<const Motion> motions, double zero) : motions_(motions), zero_(zero) {}

  template <typename EndOfLink>
  std::vector<bool> find(EndOfLink&& end_of_link) const {
    std::vector<bool> links(motions_.size(), false);
    for (std::size_t i = 0; i < motions_.size(); ++i) {
      if (!is_aside_before_zero(i)) continue;
      for (const std::size_t end = (this->*end_of_link)(i); i < end; ++i) links[i] = true;
    }
    return links;
  }

  // Index of the motion behind the link that begins with motion `i`; `i` if that is none.
  std::size_t end_on_mill(std::size_t i) const {
    const bool from_rapid = i == 0 || !is_cut(motions_[i - 1]);
    const bool came_up = i > 0 && is_upright_line(motions_[i - 1]) && rises(motions_[i - 1]);
    if (came_up && leads_home(i)) return motions_.size();
    if (!from_rapid && !came_up) return i;
    if (!is_horizontal(motions_[i]))
      return from_rapid && goes_down(motions_[i]) ? i : end_before_plunge(i);
    if (!from_rapid && is_cut_at(i + 1) && goes_down(motions_[i + 1])) return i + 1;
    if (!from_rapid) return end_of_two_legs(i);
    return end_before_way_down(i);
  }

  std::size_t end_on_lathe(std::size_t i) const {
    const Motion& m = motions_[i];
    const bool from_rapid = comes_from_rapid(i);
    const bool came_out = !from_rapid && motions_[i - 1].start.z <= zero_ + kSameHeight;
    const bool passes_axis = m.start.x * m.end.x < 0;  // a face
    if (passes_axis || is_shoulder(i) || (!from_rapid && !came_out)) return i;
    if (came_out && std::fabs(m.end.x) > std::fabs(m.start.x)) return i + 1;
    std::size_t level = i + 1;
    while (is_aside_before_zero(level) && is_horizontal(motions_[level])) ++level;
    std::size_t nearer = level;
    while (is_aside_before_zero(nearer) && nears_part(motions_[nearer])) ++nearer;
    const auto goes_in = [&](std::size_t j) {
      return is_cut_at(j) && goes_down(motions_[j]) && motions_[j].start.z < zero_ + kFarthest;
    };
    if (goes_in(nearer) && motions_[nearer].end.z <= zero_ + kSameHeight) return nearer;
    return goes_in(level) && slopes_in(motions_[level]) ? level : i;
  }

  // Straight feeds in front of the part lead to a link.
  void add_straight(std::vector<bool>& links) const {
    for (std::size_t i = links.size(); i-- > 1;)
      if (links[i] && is_straight_before_zero(i - 1)) links[i - 1] = true;
  }

 private:
  // mm from the zero to where ways in begin: others turn a part with its zero in the chuck.
  static constexpr double kFarthest = 10;

  bool is_straight_before_zero(std::size_t i) const {
    return is_cut(motions_[i]) && is_upright_line(motions_[i]) &&
           std::min(motions_[i].start.z, motions_[i].end.z) > zero_ + kSameHeight;
  }

  bool is_cut_at(std::size_t i) const { return i < motions_.size() && is_cut(motions_[i]); }

  bool is_aside_before_zero(std::size_t i) const {
    return is_cut_at(i) && motions_[i].kind == MotionKind::line && !is_upright_line(motions_[i]) &&
           std::min(motions_[i].start.z, motions_[i].end.z) > zero_ + kSameHeight;
  }

  // "Z10.", "X30.": a pass towards the chuck ends there, with its zero farther in.
  bool is_shoulder(std::size_t i) const {
    return i > 0 && is_straight_before_zero(i - 1) && goes_down(motions_[i - 1]) &&
           std::fabs(motions_[i].end.x) > std::fabs(motions_[i].start.x) + kSameHeight;
  }

  // With straight feeds in front of the part in between.
  bool comes_from_rapid(std::size_t i) const {
    while (i > 0 && is_straight_before_zero(i - 1)) --i;
    return i == 0 || !is_cut(motions_[i - 1]);
  }

  // "X52.8 Z1.4", "X50. Z0": towards the axis and the chuck.
  static bool slopes_in(const Motion& m) {
    return std::fabs(m.end.x) < std::fabs(m.start.x) - kSameHeight;
  }
  static bool nears_part(const Motion& m) {
    return m.end.z <= m.start.z + kSameHeight &&
           std::fabs(m.end.x) <= std::fabs(m.start.x) + kSameHeight;
  }
  static bool rises(const Motion& m) { return m.end.z > m.start.z; }
  static bool goes_down(const Motion& m) { return m.end.z < m.start.z - kSameHeight; }
  static bool is_horizontal(const Motion& m) {
    return std::fabs(m.end.z - m.start.z) <= kSameHeight;
  }

  // "G1 Z5", "X20", "Y10", "Z-2": one leg an axis, from behind the zero and back.
  std::size_t end_of_two_legs(std::size_t i) const {
    const bool level = is_aside_before_zero(i + 1) && is_horizontal(motions_[i + 1]);
    const bool came_from_behind = motions_[i - 1].start.z < zero_ - kSameHeight;
    return level && came_from_behind && plunges_behind_zero(i + 2) ? i + 2 : i;
  }

  // "G1 X20 Z5", "Z-2".
  std::size_t end_before_plunge(std::size_t i) const {
    std::size_t j = i + 1;
    while (is_cut_at(j) && is_upright_line(motions_[j]) && goes_down(motions_[j]) &&
           motions_[j].end.z > zero_ - kSameHeight)
      ++j;
    return plunges_behind_zero(j) ? i + 1 : i;
  }

  bool plunges_behind_zero(std::size_t i) const {
    return is_cut_at(i) && is_upright_line(motions_[i]) && motions_[i].end.z < zero_ - kSameHeight;
  }

  // Feeds at one height to the place above which a way down through the zero begins: "G0 Z2", "G1
  // X10", "G1 Z-3".
  std::size_t end_before_way_down(std::size_t i) const {
    const double height = motions_[i].start.z;
    std::size_t end = i + 1;
    while (is_aside_before_zero(end) && is_horizontal(motions_[end])) ++end;
    for (std::size_t j = end; is_cut_at(j); ++j) {
      if (motions_[j].end.z < zero_ - kSameHeight) return end;
      if (!goes_down(motions_[j]) || motions_[j].start.z > height + kSameHeight) return i;
    }
    return i;
  }

  // One line or two ("X0", "Y0") behind the program's last cut, which lay behind the zero: nothing
  // follows, or a way up from where the program began.
  bool leads_home(std::size_t i) const {
    if (motions_[i - 1].start.z > zero_ - kSameHeight) return false;
    std::size_t end = is_aside_before_zero(i + 1) ? i + 2 : i + 1;
    if (end < motions_.size() && !is_home(motions_[end - 1].end)) return false;
    while (end < motions_.size() && is_upright_line(motions_[end]) && rises(motions_[end])) ++end;
    return end == motions_.size();
  }

  bool is_home(const Vec3& p) const {
    const Motion& first = motions_.front();
    return (p.x == first.start.x && p.y == first.start.y) ||
           (p.x == first.end.x && p.y == first.end.y);
  }

  std::span<const Motion> motions_;
  double zero_;
};

// Ways off a pass: outwards and forwards over what the pass has turned, and straight back. Long
// slopes with the feed cut: dished faces, flanks that are turned from behind.
void add_ways_off(std::span<const Motion> motions, std::vector<bool>& links) {
  constexpr double kLongest = 5;  // mm in radius and in Z
  bool is_off = false;
  double front = kNoHeight, widest = 0;  // of the cuts since the last rapid
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Motion& m = motions[i];
    if (links[i]) continue;
    const double from = std::fabs(m.start.x), to = std::fabs(m.end.x);
    const bool is_short = std::max(to - from, m.end.z - m.start.z) < kLongest + kSameHeight;
    const bool slopes_off = m.end.z > m.start.z + kSameHeight && m.end.z < front &&
                            to > from + kSameHeight && to > widest && (is_short || !is_cut(m));
    const bool goes_on = is_off && m.end.z > m.start.z - kSameHeight && to > from - kSameHeight &&
                         (is_cut(m) || to < from + kSameHeight);
    is_off = slopes_off || goes_on;
    if (is_off) {
      links[i] = true;
    } else if (!is_cut(m)) {
      front = kNoHeight, widest = 0;
    } else {
      if (m.end.z < m.start.z) front = std::max(front, m.start.z);
      widest = std::max(widest, to);
    }
  }
}

}  // namespace

std::vector<bool> link_moves(std::span<const Motion> motions, double zero, bool lathe) {
  const LinkFinder finder(motions, zero);
  if (!lathe) return finder.find(&LinkFinder::end_on_mill);
  std::vector<bool> links = finder.find(&LinkFinder::end_on_lathe);
  finder.add_straight(links);
  add_ways_off(motions, links);
  return links;
}

}  // namespace mrsim
