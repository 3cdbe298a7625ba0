#include "removal/part/bar_signs.h"

#include "core/numbers/motions.h"
#include "core/words/tool_types.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mrsim {
namespace {

bool goes_to_chuck(const Motion& m) { return m.end.z < m.start.z - kSameHeight; }

bool is_level_feed(const Motion& m) { return std::fabs(m.end.z - m.start.z) < kSameHeight; }

// A cut at one Z that reaches the axis, or the hole that has been drilled around it.
bool faces_to_axis(const Motion& m, double drilled) {
  const double least = std::min(std::fabs(m.start.x), std::fabs(m.end.x));
  const bool meets = m.start.x * m.end.x < 0 || least < drilled + kLeastMargin;
  return is_level_feed(m) && m.start.x != m.end.x && meets;
}

// Reads where the ways in begin, each with the feeds towards the chuck that go on from it.
class WaysReader {
 public:
  WaysReader(std::span<const Motion> motions, std::span<const Tool> tools, double zero)
      : motions_(motions), tools_(tools), radii_(radii_of(motions, tools)), zero_(zero) {}

  FarWays read() {
    bool is_new = true;  // no feed along Z since the last rapid
    for (std::size_t i = 0; i < motions_.size(); ++i) {
      const Motion& m = motions_[i];
      is_new = is_new || !is_cut(m);
      if (!is_cut(m) || m.lead != 0) continue;
      if (is_new && goes_to_chuck(m) && m.start.z > zero_ + kSameHeight && !leads_near(i)) note(i);
      is_new = is_new && (is_level_feed(m) || leads_near(i));
      note_face(m);
    }
    FarWays ways;
    if (has_front_) return ways;
    if (far_ > 0 && 2 * far_ >= all_)
      ways = {far_front_, true};
    else if (deep_ > 0 && 2 * deep_ >= all_)
      ways = {deep_front_, false};
    else if (necks_ && std::fabs(faced_ - zero_) > kLeastMargin)
      ways = {neck_front_, true};
    return ways;
  }

 private:
  // mm: farther in front of the bar nobody begins to feed; roughing cycles add their allowance.
  static constexpr double kFarthest = 10 + kLeastMargin;
  static constexpr double kUsual = 6;  // mm: nor many farther than that

  bool works_outside(const Motion& m) const {
    return m.tool < 0 || !is_inside_tool(tools_[static_cast<std::size_t>(m.tool)]);
  }

  // A slope towards the axis and the zero, which a feed follows, in the place of a rapid.
  bool leads_near(std::size_t i) const {
    const Motion& m = motions_[i];
    return goes_to_chuck(m) && m.end.z > zero_ + kSameHeight && m.end.z < zero_ + kFarthest &&
           i + 1 < motions_.size() && is_cut(motions_[i + 1]) &&
           std::fabs(m.end.x) < std::fabs(m.start.x) - kSameHeight;
  }

  // A blade parts off at the zero in the chuck; an insert faces the front.
  void note_face(const Motion& m) {
    if (m.tool >= 0 && !is_turning(type_of(m))) {
      drilled_ = std::max(drilled_, radii_[static_cast<std::size_t>(m.tool)]);
    } else if (works_outside(m) && faces_to_axis(m, drilled_)) {
      faced_ = std::min(faced_, m.start.z);
      has_front_ = has_front_ || (type_of(m) != ToolType::grooving &&
                                  m.start.z > zero_ - kLeastMargin - kSameHeight);
    }
  }

  ToolType type_of(const Motion& m) const {
    return m.tool < 0 ? ToolType::turning : tools_[static_cast<std::size_t>(m.tool)].type;
  }

  void note(std::size_t i) {
    const double begin = std::min(motions_[i].start.z, faced_);  // in front of a face is nothing
    double end = motions_[i].end.z;
    std::size_t next = i + 1;
    for (; next < motions_.size() && is_cut(motions_[next]) && goes_to_chuck(motions_[next]);
         ++next)
      end = motions_[next].end.z;
    ++all_;
    if (begin > zero_ + kFarthest) {
      const bool is_deep = 3 * (zero_ - end) >= begin - zero_;
      double& front = is_deep ? deep_front_ : far_front_;
      ++(is_deep ? deep_ : far_);
      front = std::max(front, begin);
    } else if (begin > zero_ + kUsual && end > zero_ - kSameHeight) {
      note_neck(i, next, begin);
    }
  }

  // If two passes end in front of the zero or at it, at different radii, the zero is at a shoulder.
  // A way in that a face follows is no such pass.
  void note_neck(std::size_t i, std::size_t next, double begin) {
    const double radius = std::fabs(motions_[i].start.x);
    if (!is_upright_line(motions_[i]) || radius < kLeastMargin || !works_outside(motions_[i]))
      return;
    if (next < motions_.size() && is_cut(motions_[next]) &&
        std::fabs(motions_[next].end.x) < radius - kSameHeight)
      return;
    necks_ = necks_ || (neck_front_ != kNoHeight && std::fabs(radius - neck_radius_) > kSameHeight);
    neck_radius_ = radius;
    neck_front_ = std::max(neck_front_, begin);
  }

  std::span<const Motion> motions_;
  std::span<const Tool> tools_;
  std::vector<double> radii_;  // of tools
  double zero_;
  double drilled_ = 0;         // radius of the widest drill so far
  double faced_ = -kNoHeight;  // Z of what has been faced down to the axis
  bool has_front_ = false;     // an insert faces the front, at the zero or before it
  int all_ = 0, far_ = 0, deep_ = 0;
  double far_front_ = kNoHeight, deep_front_ = kNoHeight;
  bool necks_ = false;
  double neck_radius_ = 0, neck_front_ = kNoHeight;
};

// The tip orientation 1 to 9 in a mirror in Z; 0 stays.
int mirrored_tip(int tip) {
  constexpr int kTips[] = {0, 2, 1, 4, 3, 7, 6, 5, 8, 9};
  return tip >= 0 && tip <= 9 ? kTips[tip] : tip;
}

// The cuts and rapids of the first inside tool; none where a tool that turns nothing cuts before.
class FirstBar {
 public:
  explicit FirstBar(std::span<const Tool> tools) : tools_(tools) {}
  // Whether the motion is one of that tool; `is_drilled()` where there is no such tool.
  bool takes(const Motion& m) {
    if (drilled_ || m.tool < 0 || (bar_ >= 0 && m.tool != bar_)) return false;
    const Tool& tool = tools_[static_cast<std::size_t>(m.tool)];
    drilled_ = is_cut(m) && !is_turning(tool.type);
    if (!is_turning(tool.type) || !is_inside_tool(tool)) return false;
    bar_ = m.tool;
    return true;
  }
  bool is_drilled() const { return drilled_; }

 private:
  std::span<const Tool> tools_;
  int bar_ = -1;
  bool drilled_ = false;
};

}  // namespace

FarWays far_ways(std::span<const Motion> motions, std::span<const Tool> tools, double zero) {
  return WaysReader(motions, tools, zero).read();
}

double air_radius(std::span<const Motion> motions) {
  double widest = 0;
  bool plunges = false;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Motion& m = motions[i];
    if (!is_cut(m) || is_upright_line(m)) continue;
    const double from = std::fabs(m.start.x), to = std::fabs(m.end.x);
    widest = std::max({widest, from, to});
    const bool goes_inwards = is_level_feed(m) && to < from - kSameHeight;
    plunges = plunges || (goes_inwards && (i == 0 || !is_cut(motions[i - 1])));
  }
  return plunges ? widest : -kNoHeight;
}

HeldEnd held_end(std::span<const Motion> motions, double zero) {
  const double air = air_radius(motions) - kSameHeight;
  bool is_new = true;  // no feed along Z since the last rapid
  bool is_plus = false, leads_to_plus = false;
  double farthest = kNoHeight;  // towards +Z, of all places where tools were
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Motion& m = motions[i];
    const double before = std::exchange(farthest, std::max(farthest, m.end.z));
    is_new = is_new || !is_cut(m);
    if (!is_new || !is_cut(m) || m.lead != 0) continue;
    is_new = is_level_feed(m);
    if (is_new) continue;
    if (goes_to_chuck(m)) return HeldEnd::minus;
    if (i > 0 && is_cut(motions[i - 1])) continue;  // from a plunge, or the way out of a face
    if (std::min(std::fabs(m.start.x), std::fabs(m.end.x)) >= air) continue;  // a way back
    const bool is_behind = m.end.z > zero + kSameHeight && m.end.z - zero > zero - m.start.z;
    is_plus = is_plus || (is_behind && m.end.z > before + kSameHeight);
    leads_to_plus = leads_to_plus || is_upright_line(m);
  }
  if (is_plus) return HeldEnd::plus;
  return leads_to_plus ? HeldEnd::unsure : HeldEnd::minus;
}

std::vector<Motion> mirrored_in_z(std::span<const Motion> motions) {
  std::vector<Motion> mirrored(motions.begin(), motions.end());
  for (Motion& m : mirrored) {
    for (Vec3* p : {&m.start, &m.end, &m.center}) p->z = 0 - p->z;
    m.sweep = -m.sweep;
  }
  return mirrored;
}

std::vector<Tool> mirrored_in_z(std::span<const Tool> tools) {
  std::vector<Tool> mirrored(tools.begin(), tools.end());
  for (Tool& tool : mirrored) {
    tool.left_hand = !tool.left_hand;
    tool.tip = mirrored_tip(tool.tip);
  }
  return mirrored;
}

double entered_hole(std::span<const Motion> motions, std::span<const Tool> tools, double front) {
  double hole = 0;
  FirstBar bar(tools);
  bool has_cut = false, is_back = false;
  for (const Motion& m : motions) {
    if (!bar.takes(m)) continue;
    if (is_cut(m) && is_back) break;
    has_cut = has_cut || is_cut(m);
    if (is_cut(m) || m.assumed_start || std::min(m.start.z, m.end.z) > front - kSameHeight)
      continue;
    hole = std::max(hole, std::min(std::fabs(m.start.x), std::fabs(m.end.x)));
    is_back = has_cut;
  }
  return bar.is_drilled() ? 0 : hole;
}

double needed_hole(std::span<const Motion> motions, std::span<const Tool> tools, double front) {
  double least = -kNoHeight;
  FirstBar bar(tools);
  for (const Motion& m : motions) {
    if (!bar.takes(m) || !is_cut(m)) continue;
    if (m.start.z < front - kSameHeight) least = std::min(least, std::fabs(m.start.x));
    if (m.end.z < front - kSameHeight) least = std::min(least, std::fabs(m.end.x));
  }
  const bool is_none = bar.is_drilled() || least == -kNoHeight || least < 2 * kLeastMargin;
  return is_none ? 0 : least - kLeastMargin;
}

}  // namespace mrsim
