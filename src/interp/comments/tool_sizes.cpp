#include "interp/comments/tool_sizes.h"

#include "core/numbers/units.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

class SizeSettler {
 public:
  SizeSettler(const ToolFacts& facts, ToolHint& hint) : facts_(facts), hint_(hint) {}

  std::vector<double> settle();

 private:
  const ToolKind* kind() const { return facts_.kind(); }
  bool trade_is(ToolTrade trade) const { return facts_.trade_is(trade); }
  bool is_angle(const CommentToken& size, bool joined) const;
  void add(const ToolLength& length) { hint_.diameters.push_back(length); }
  void add_groups();
  void add_centre_gauge();
  void add_loose();
  void share_inches();
  void add_indexed_tip();
  bool stand_on_both_sides() const;
  void add_group(const SizeGroup& group);
  void add_further(const ToolLength& first, const ToolLength& next);
  bool may_be_work(const SizeGroup& group) const;
  bool may_count(const SizeGroup& group);

  const ToolFacts& facts_;
  ToolHint& hint_;
  std::vector<double> angles_;  ///< degrees
};

// Whether the size is a whole number and a usual angle of the kind: "1/2 X 90 SPOT", ".250 X 45
// CHAMFER", "1/4 135 DRILL". What stands behind the X of a twist drill is its length (`joined`).
bool SizeSettler::is_angle(const CommentToken& size, bool joined) const {
  using enum ToolTrade;
  const bool whole = size.value == std::floor(size.value);
  if (trade_is(ToolTrade::lathe) && kind()->type == ToolType::turning && !kind()->firm)
    return whole && (size.value == 35 || size.value == 55 || size.value == 80);  // "80. DIAMOND"
  if (!kind() || size.decimals || size.fraction || size.unit > 0) return false;
  return !(joined && kind()->trade == twist_drill) && is_usual_angle(kind()->trade, size.value);
}

std::vector<double> SizeSettler::settle() {
  angles_ = facts_.angles;
  hint_.diameters = facts_.named;
  if (hint_.diameters.empty() && (kind() || facts_.corner || facts_.names_tool || facts_.pair) &&
      facts_.letter_d)
    add(facts_.letter_d);
  if (facts_.thread && *facts_.thread && trade_is(ToolTrade::tap)) add(*facts_.thread);
  const bool centre = facts_.gauge && facts_.pilot;
  if (facts_.gauge && !centre) add(*facts_.gauge);
  hint_.gauge = facts_.gauge_name;
  hint_.bare_size = hint_.diameters.empty() && !centre;
  add_groups();
  if (centre) add_centre_gauge();
  share_inches();
  add_indexed_tip();
  return std::move(angles_);
}

// "CHAMFER MILL D16 D1=2" gives the diameter at its tip. D1 of half the diameter may be a radius
// instead, and D2 the shank.
void SizeSettler::add_indexed_tip() {
  if (!facts_.has_flat_tip() || hint_.tip) return;
  if (hint_.diameters.empty()) {  // "V-BIT D1=0.2 D2=6"
    const ToolLength& size = facts_.d1 ? facts_.d1 : facts_.d2;
    if (size && trade_is(ToolTrade::vee) && hint_.doubt.empty())
      hint_.doubt =
          fmt::format("can be read as a tip of {0:g} or as another size of {0:g}", size.value);
    return;
  }
  const double whole = hint_.diameters.front().mm(1);
  const auto smaller = [&](const ToolLength& size) { return size && size.mm(1) < whole; };
  const bool half = facts_.d1.mm(1) == whole / 2;
  if (smaller(facts_.d1) && !half) {
    hint_.tip = facts_.d1;
  } else if (smaller(facts_.d1) || smaller(facts_.d2)) {
    const ToolLength& size = smaller(facts_.d1) ? facts_.d1 : facts_.d2;
    if (hint_.doubt.empty())
      hint_.doubt =
          fmt::format("can be read as a tip of {0:g} or as another size of {0:g}", size.value);
  }
}

// A diameter without a unit beside a width in inches is in inches, too: "KEYSEAT CUTTER 1 X 1/8".
// Where that is larger than the width in mm, too, only a program in inches tells which it is:
// "T-SLOT CUTTER 6 X 1/8", "SAW 63 X 1/16".
void SizeSettler::share_inches() {
  constexpr double kWidest = 8;        // inches
  constexpr double kWidestHead = 1.5;  // inches: a usual size, and in mm a rare one
  const ToolLength& beside = trade_is(ToolTrade::dovetail) ? hint_.flute_length : hint_.width;
  const bool inches = beside.unit > 1 || (beside.fraction && beside.unit == 0);
  if (!kind() || is_turning(kind()->type) || !inches) return;
  for (ToolLength& diameter : hint_.diameters) {
    if (diameter.unit > 0 || diameter.fraction) continue;
    if (diameter.value > kWidest && hint_.doubt.empty())
      hint_.doubt = fmt::format("gives the diameter {:g} without a unit, beside a size in inches",
                                diameter.value);
    const bool head = trade_is(ToolTrade::dovetail) || facts_.t_slot;
    if (head && diameter.value > std::max(kWidestHead, beside.mm(kMmPerInch)))
      hint_.beside_inches = true;
    else
      diameter.unit = kMmPerInch;
  }
}

// Adds the body of a centre drill by its number. Sizes that the comment tells may be its pilot, "#4
// CENTER DRILL 1/8 DIA"; where they are neither, a number that the tool has, too, is the tool's:
// "T2 NO. 2 CENTER DRILL D4".
void SizeSettler::add_centre_gauge() {
  const auto is = [](const ToolLength& told, const ToolLength& size) {
    constexpr double kOfDecimals = 0.02;  // mm: ".109" is 7/64
    const double mm = size.mm(1);
    return std::abs(told.mm(kMmPerInch) - mm) < kOfDecimals ||
           std::abs(told.mm(1) - mm) < kOfDecimals;
  };
  std::erase_if(hint_.diameters, [&](const ToolLength& told) { return is(told, facts_.pilot); });
  const bool other = std::any_of(hint_.diameters.begin(), hint_.diameters.end(),
                                 [&](const ToolLength& told) { return !is(told, *facts_.gauge); });
  if (!other || facts_.id != facts_.gauge_name) return add(*facts_.gauge);
  hint_.gauge.clear();
  hint_.pilot = {};
  hint_.disputed_gauge = false;
}

// Adds the sizes beside the kind. Those elsewhere count only if nothing else gives the diameter.
void SizeSettler::add_groups() {
  for (const SizeGroup& group : facts_.before_kind) {
    if (!(facts_.holes && group.sizes.front().unit == 0)) add_group(group);
  }
  if (facts_.behind_kind && !may_be_work(*facts_.behind_kind)) {
    const CommentToken& size = facts_.behind_kind->sizes.front();
    const bool marked = size.unit > 0 || size.fraction;
    const bool certain = size.decimals && kind()->firm;
    if (marked || ((facts_.behind_ends || certain) && hint_.diameters.empty()) ||
        (facts_.behind_ends && is_angle(size, false)) || facts_.behind_kind->continues)
      add_group(*facts_.behind_kind);
    if (!marked && !size.decimals && hint_.diameters.size() == 1)
      add_loose();  // "DRILL (4) 1/4 HOLES", "ENDMILL 3 - 10MM": which of them?
    if (stand_on_both_sides()) add_group(*facts_.behind_kind);
  }
  const bool tap = facts_.thread && trade_is(ToolTrade::tap);
  if (!hint_.diameters.empty() || tap || !(kind() || hint_.names_tool)) return;
  add_loose();
  // "ENDMILL 10 40MM LONG": the number beside the kind may be the diameter, too.
  if (!hint_.diameters.empty() && facts_.behind_kind && !may_be_work(*facts_.behind_kind))
    add_group(*facts_.behind_kind);
}

// Whether whole numbers without a name stand before and behind the kind: "3 ENDMILL 10", "SLOT 12
// ENDMILL 8".
bool SizeSettler::stand_on_both_sides() const {
  if (facts_.before_kind.empty() || !facts_.named.empty() || !facts_.behind_ends) return false;
  const auto bare = [&](const SizeGroup& group) {
    const CommentToken& size = group.sizes.front();
    return group.sizes.size() == 1 && size.unit == 0 && !size.decimals && !size.fraction &&
           !is_angle(size, false);
  };
  return bare(facts_.before_kind.front()) && bare(*facts_.behind_kind);
}

void SizeSettler::add_loose() {
  for (const SizeGroup& group : facts_.loose) add_group(group);
}

// Whether the sizes may be those of the work: "CHAMFER 0.5". "T5 CHAMFER 10" and "CHAMFER 90 DEG
// 10" are tools.
bool SizeSettler::may_be_work(const SizeGroup& group) const {
  return trade_is(ToolTrade::chamfer_mill) && !kind()->firm && !facts_.names_tool &&
         facts_.angles.empty() && hint_.diameters.empty() && !group.sizes.front().fraction;
}

void SizeSettler::add_group(const SizeGroup& group) {
  std::vector<ToolLength> sizes;
  const bool joined = group.continues || group.sizes.size() > 1;
  for (const CommentToken& t : group.sizes)
    if (is_angle(t, joined))
      angles_.push_back(t.value);
    else
      sizes.push_back({t.value, t.unit, t.fraction, false, t.inch_style()});
  if (sizes.empty()) return;
  if (group.continues) {  // "R3 X 50"
    if (!hint_.diameters.empty()) add_further(hint_.diameters.front(), sizes.front());
    return;
  }
  // "WOODRUFF 1/8 X 1/2": the width of a key stands first.
  const bool key = sizes.size() > 1 && trade_is(ToolTrade::disc) && sizes[0].fraction &&
                   sizes[1].fraction && sizes[0].value < sizes[1].value;
  if (key) std::swap(sizes[0], sizes[1]);
  add(sizes.front());
  if (sizes.size() > 1 && may_count(group)) return;
  if (sizes.size() > 1) add_further(sizes[0], sizes[1]);
}

// Whether the first number may count holes, "DRILL 4X 8.5"; sets a doubt then. "8.5 X 117" are a
// diameter and a length.
bool SizeSettler::may_count(const SizeGroup& group) {
  using enum ToolTrade;
  const CommentToken &first = group.sizes[0], &next = group.sizes[1];
  const bool makes_holes = trade_is(twist_drill) || trade_is(spot_drill) || trade_is(hole) ||
                           trade_is(tap) || trade_is(countersink);
  const bool bare = !first.decimals && !first.fraction && first.unit == 0;
  const bool size = next.decimals || next.fraction || next.unit > 0;
  if (!makes_holes || !bare || !size) return false;
  if (hint_.doubt.empty())
    hint_.doubt = fmt::format("can be read as diameter {0} or as {0} places", first.text);
  return true;
}

// Adds the size behind the X of a diameter: a width, a length, a corner or another diameter.
void SizeSettler::add_further(const ToolLength& first, const ToolLength& next) {
  using enum ToolTrade;
  const bool inches = first.unit > 1 || next.unit > 1 || first.fraction || next.fraction;
  const auto mm = [&](const ToolLength& l) {
    return l.value * (l.unit > 0 ? l.unit : inches ? kMmPerInch : 1);
  };
  const double size = mm(first), other = mm(next);
  if (trade_is(disc) && other < size && !hint_.width) {
    hint_.width = next;
    if (hint_.width.unit == 0 && !next.fraction) hint_.width.unit = first.unit;
    return;
  }
  if (trade_is(dovetail) && other < size && !hint_.flute_length) {
    hint_.flute_length = next;
    return;
  }
  const bool ignored =
      trade_is(face_mill) || trade_is(tap) || is_turning(kind() ? kind()->type : ToolType::endmill);
  constexpr double kLeastBody = 2, kWidestBody = 3.2;  // pilots, ISO 866
  if (trade_is(center_drill) && other > size && other < kWidestBody * size) {
    constexpr double kSmall = 2, kWidestLarge = 2.7;  // "6.3 X 20" is form B, with two cones
    const bool wide = size >= kSmall && other > kWidestLarge * size;
    if (other < kLeastBody * size || wide || hint_.diameters.size() > 1) return add(next);
    hint_.pilot = first;  // "3.15 X 8"
    hint_.diameters.front() = next;
    return;
  }
  if (ignored || other >= size) return;  // lengths
  if (kind() && kind()->type == ToolType::bullmill && other <= size / 2 && !hint_.corner)
    hint_.corner = next;
  else
    add(next);  // "ENDMILL 20 X 2": which is the diameter?
}

}  // namespace

bool is_usual_angle(ToolTrade trade, double degrees) {
  using enum ToolTrade;
  const auto one_of = [&](std::initializer_list<double> usual) {
    return std::find(usual.begin(), usual.end(), degrees) != usual.end();
  };
  switch (trade) {
    case twist_drill:
      return one_of({118, 135, 140});
    case spot_drill:
      return one_of({60, 82, 90, 118, 120, 135, 140, 142, 145});
    case center_drill:
      return one_of({60, 90, 120});
    case countersink:
      return one_of({60, 75, 82, 90, 100, 110, 120});
    case chamfer_mill:
      return one_of({30, 45, 60, 82, 90, 120});
    case vee:
      return one_of({30, 45, 60, 90, 120});
    default:
      return false;
  }
}

std::vector<double> settle_sizes(const ToolFacts& facts, ToolHint& hint) {
  return SizeSettler(facts, hint).settle();
}

}  // namespace mrsim
