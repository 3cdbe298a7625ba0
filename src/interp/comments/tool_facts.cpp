#include "interp/comments/tool_facts.h"

#include "interp/comments/comment_view.h"
#include "interp/comments/comment_words.h"
#include "interp/comments/hyphenated_name.h"
#include "interp/comments/thread_name.h"
#include "interp/comments/tool_gauges.h"
#include "interp/comments/tool_id.h"
#include "interp/comments/tool_labels.h"
#include "interp/comments/tool_sides.h"
#include "interp/comments/tool_sizes.h"
#include "interp/comments/whole_comment.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

class FactReader {
 public:
  FactReader(std::vector<CommentToken> tokens, ToolFacts& facts)
      : view_(std::move(tokens)), facts_(facts) {}

  void read() {
    facts_.kinds = find_tool_kinds(view_.tokens());
    read_short_kind();
    facts_.insert = find_insert_code(view_.tokens());
    drop_rougher(view_, facts_);
    read_tool_id(view_, facts_);
    take_kinds();
    read_inch_word();
    read_thread();
    read_gauges(view_, facts_);
    read_tool_labels(view_, facts_);
    read_side_words(view_, facts_);
    read_groups();
    read_beside();
    read_loose();
    drop_count();
    read_rest();
    read_turning_words(view_, facts_);
    read_whole_comment(view_, facts_);
  }

 private:
  /// Tokens [first, end): numbers and the X between them.
  struct Group {
    std::size_t first = 0, end = 0;
    bool used = false;
  };

  void take_kinds();
  void drop_purpose();
  void read_inch_word();
  void read_thread();
  bool may_be_point(std::size_t i) const;
  bool splits_size(std::size_t i) const;
  void read_short_kind();
  bool numbers_it(std::size_t i) const;
  void read_groups();
  bool passable(std::size_t i) const;
  bool ends(std::size_t i) const;
  Group* group_at(std::size_t token);
  SizeGroup sizes(const Group& group) const;
  void use(Group& group, std::vector<SizeGroup>& into);
  void read_beside();
  void read_before(const ToolKind& kind);
  bool is_list_item(const Group& group) const;
  void read_behind(const ToolKind& kind);
  void read_loose();
  bool in_field_of_kind(const Group& group) const;
  void read_rest();
  bool kind_is_counted() const;
  void drop_count();
  const ToolKind* kind() const { return facts_.kind(); }

  CommentView view_;
  ToolFacts& facts_;
  std::vector<Group> groups_;
};

void FactReader::take_kinds() {
  drop_purpose();
  for (const ToolKind& k : facts_.kinds)
    if (same_trade(k, facts_.kinds.front())) view_.take(k.first, k.end);
  if (facts_.insert) view_.take(facts_.insert->first, facts_.insert->end);
}

// Drops the tool behind FOR or AFTER, which is another one: "6.8 DRILL FOR M8 TAP", "REST MILL
// AFTER 10MM ENDMILL". PREDRILL beside a tool is work: "1/2 EM AT PREDRILL".
void FactReader::drop_purpose() {
  std::vector<ToolKind>& kinds = facts_.kinds;
  if (kinds.size() > 1)
    std::erase_if(kinds, [&](const ToolKind& k) { return view_.is(k.first, "PREDRILL"); });
  for (std::size_t i = 1; i < view_.size(); ++i) {
    if (!view_.is_one(i, {"FOR", "FUER", "F~R", "POUR", "PARA", "DLA", "AFTER", "NACH", "APRES"}))
      continue;
    const bool told =
        std::any_of(kinds.begin(), kinds.end(), [&](const ToolKind& k) { return k.first < i; });
    if (!told) continue;
    std::size_t end = i + 1;
    for (const ToolKind& k : kinds)
      if (k.first > i) end = std::max(end, k.end);
    std::erase_if(kinds, [&](const ToolKind& k) { return k.first > i; });
    while (view_.number(end) || view_.is(end, "M")) ++end;
    view_.take(i, end);
  }
}

// IN between a whole number and the kind is a unit, "3 IN FACE MILL"; elsewhere it is a
// preposition, "5 IN PLATE".
void FactReader::read_inch_word() {
  if (!kind()) return;
  for (std::size_t i = 0; i + 1 < kind()->first; ++i) {
    if (!view_.is_size(i) || !view_.whole(i) || !view_.is(i + 1, "IN")) continue;
    std::size_t at = i + 2;
    while (at < kind()->first && (passable(at) || view_.is_one(at, {"DIA", "DIAM", "DIAMETER"})))
      ++at;
    if (at < kind()->first) continue;
    view_.say_inches(i);
    view_.take(i + 1);
  }
}

void FactReader::read_thread() {
  using enum ToolTrade;
  const ToolKind* k = kind();
  const bool threads = k && (k->trade == tap || k->trade == thread_mill ||
                             (k->trade == twist_drill && k->end > k->first + 1));
  const auto thread = find_thread_name(view_, threads);
  if (!thread) return;
  facts_.thread = thread->diameter;
  facts_.enlarged_thread = thread->enlarged;
  view_.take(thread->first, thread->end);
}

// Reads kinds in one letter or word: "end 1/4" of Kiri:Moto; "V90 D12", "60V", which are V-bits
// with their angle. Of "V90 ENGRAVER" it reads the angle.
void FactReader::read_short_kind() {
  using enum ToolTrade;
  const auto angle = [&](std::size_t i) {
    return view_.number(i) && view_.whole(i) && view_[i].value >= 15 && view_[i].value <= 150;
  };
  if (kind() && kind()->type != ToolType::chamfer) return;
  for (std::size_t i = 0; i < view_.size() && facts_.angles.empty(); ++i) {
    if (!kind() && view_.is(i, "END") && view_.number(i + 1) && view_[i + 1].fraction) {
      facts_.kinds.push_back({ToolType::endmill, mill, true, 0, i, i + 1});
      return;
    }
    if (!view_.is(i, "V")) continue;
    const bool before = i > 0 && view_.glued(i) && angle(i - 1);
    const bool behind = view_.glued(i + 1) && angle(i + 1) && !view_.glued(i + 2);
    if (!before && !behind) continue;
    if (!kind()) facts_.kinds.push_back({ToolType::chamfer, vee, false, 0, i, i + 1});
    view_.take(i);
    facts_.angles.push_back(view_[before ? i - 1 : i + 1].value);
    view_.take(before ? i - 1 : i + 1);
  }
}

// Whether the number at i only numbers the tool, "ENDMILL001", "DRILL2". In "EM10" and "BALL6" it
// is a size.
bool FactReader::numbers_it(std::size_t i) const {
  constexpr double kFewTools = 4;
  return view_[i].angle || (view_.whole(i) && view_.glued(i) &&
                            (view_[i].text.front() == '0' || view_[i].value < kFewTools));
}

// Collects numbers joined by X. A number that is explained already is left out of its group, and
// the group goes on behind it.
void FactReader::read_groups() {
  const auto element = [&](std::size_t i, bool first) {
    return view_.has(i) && view_[i].is_number() && (view_.taken(i) || !first || view_.is_size(i));
  };
  const auto skip_words = [&](std::size_t i) {  // ".25 DIA X .75 LOC X R2"
    while (view_.taken(i) && !view_[i].is_number()) ++i;
    return i;
  };
  for (std::size_t i = 0; i < view_.size(); ++i) {
    const bool glued_to_kind = kind() && i == kind()->end && view_.number(i) && !numbers_it(i);
    if (!element(i, true) && !glued_to_kind) continue;
    Group group{i, i + 1};
    for (;;) {
      const std::size_t sign = skip_words(group.end), next = skip_words(sign + 1);
      if (!view_.is_one(sign, {"X", "*", "/"}) || !element(next, false)) break;
      view_.take(sign);
      group.end = next + 1;
    }
    i = group.end - 1;
    if (!sizes(group).sizes.empty()) groups_.push_back(group);
  }
}

SizeGroup FactReader::sizes(const Group& group) const {
  SizeGroup out;
  out.continues = view_.taken(group.first);
  for (std::size_t i = group.first; i < group.end; ++i)
    if (view_.number(i) && !view_[i].angle && view_[i].value > 0) out.sizes.push_back(view_[i]);
  return out;
}

// Whether the token may stand between a size and the kind.
bool FactReader::passable(std::size_t i) const {
  const CommentToken& t = view_[i];
  if (view_.taken(i) || (t.is_number() && t.angle)) return true;
  if (t.is("-") || t.is("\"")) return t.glued;
  return view_.word(i) && comment_word(t.text).role == WordRole::adjective;
}

bool FactReader::ends(std::size_t i) const {
  if (!view_.has(i) || view_.taken(i) || (view_[i].is_number() && view_[i].angle)) return true;
  if (view_.is_one(i, {"|", ",", ";", ":", "-", "(", ")", "[", "]", "{", "}", "R"})) return true;
  return view_.word(i) && comment_word(view_[i].text).role != WordRole::none;
}

FactReader::Group* FactReader::group_at(std::size_t token) {
  for (Group& group : groups_)
    if (token >= group.first && token < group.end && !group.used) return &group;
  return nullptr;
}

void FactReader::use(Group& group, std::vector<SizeGroup>& into) {
  group.used = true;
  into.push_back(sizes(group));
}

void FactReader::read_beside() {
  if (!kind()) return;
  read_before(*kind());
  read_behind(*kind());
}

// Takes the sizes before the kind: "10 FLAT", "1/4 IN. 2 FLUTE ENDMILL", ".25 X .75 X 2.5 ENDMILL".
void FactReader::read_before(const ToolKind& kind) {
  for (std::size_t i = kind.first; i > 0;) {
    --i;
    if (Group* group = group_at(i)) {
      i = group->first;
      if (is_list_item(*group)) break;
      use(*group, facts_.before_kind);
    } else if (!passable(i)) {
      break;
    }
  }
}

// Whether the number before a size numbers the line of a list: "1. 6MM ENDMILL", "2 .500 EM".
bool FactReader::is_list_item(const Group& group) const {
  if (facts_.before_kind.empty()) return false;
  const CommentToken size = sizes(group).sizes.front();
  const CommentToken& nearest = facts_.before_kind.front().sizes.front();
  const bool bare = size.unit == 0 && !size.fraction && size.value == std::floor(size.value);
  return bare && (nearest.unit > 0 || nearest.fraction || nearest.decimals);
}

// Takes the sizes behind the kind: "End Mill 6 mm", "EM .375 LOC 1.0", "BALL6".
void FactReader::read_behind(const ToolKind& kind) {
  std::size_t at = kind.end;
  const auto pass = [&] {
    while (view_.has(at) && group_at(at) == nullptr && passable(at)) ++at;
  };
  pass();
  while (view_.is_one(at, {"{", "(", "[", ":", "-", "="})) ++at;
  pass();
  if (view_.is(at, "D") && view_.has(at + 1) && !view_.glued(at + 1)) ++at;  // "D 10"
  Group* group = group_at(at);
  if (group == nullptr) return;
  group->used = true;
  const std::size_t of = view_.is(group->end, "OUT") ? group->end + 1 : group->end;
  if (view_.is(of, "OF") && view_.number(of + 1)) return;  // "DRILL 1 OF 2", "1 OUT OF 2"
  if (view_.is(group->end, "LONG")) return;                // "ENDMILL 40MM LONG"
  const bool numbered = !kind.firm && kind.trade == ToolTrade::vee && view_.whole(group->first);
  if (numbered && !is_usual_angle(kind.trade, view_[group->first].value)) return;  // "ENGRAVING 1"
  facts_.behind_ends = ends(group->end);
  facts_.behind_kind = sizes(*group);
}

// Takes sizes that stand elsewhere: those with a unit anywhere, a plain ".375" only in the words
// before the kind, ".375 GARR EM", and beside a count of flutes, ".500 4FL". "1/2 4FL 1.0" has its
// size in the fraction.
void FactReader::read_loose() {
  const auto is_marked = [](const CommentToken& size) { return size.unit > 0 || size.fraction; };
  const bool marked = std::any_of(groups_.begin(), groups_.end(), [&](const Group& group) {
    return !group.used && is_marked(sizes(group).sizes.front());
  });
  for (Group& group : groups_) {
    if (group.used) continue;
    const CommentToken size = sizes(group).sizes.front();
    const bool beside_tool = (facts_.counts_flutes && !marked) || in_field_of_kind(group);
    if (is_marked(size) || (size.decimals && beside_tool)) use(group, facts_.loose);
  }
}

bool FactReader::in_field_of_kind(const Group& group) const {
  const ToolKind* k = kind();
  if (!k || group.end > k->first) return false;
  std::size_t strangers = 0;  // "1.5 WIDE PART WITH ENDMILL" has too many
  for (std::size_t i = group.end; i < k->first; ++i) {
    if (passable(i)) continue;
    if (!view_.word(i) || view_.is_one(i, {"WITH", "AND", "TO", "BY", "AT", "ON"})) return false;
    ++strangers;
  }
  return strangers < 2;
}

bool FactReader::kind_is_counted() const {
  if (!kind()) return false;
  std::size_t at = kind()->end;
  while (view_.has(at) && passable(at)) ++at;
  return view_.is_one(kind()->end - 1, {"MILLS", "ENDMILLS", "BITS"}) ||
         view_.is_one(at, {"SIZES", "TYPES", "OPERATIONS", "OPS", "CYCLES", "SETUPS", "POINTS",
                           "POSITIONS", "LOCATIONS"});
}

// Drops numbers that count tools or operations, "2 DRILL BIT SIZES", "NEEDS 2 END MILLS". A kind
// without another size then names no tool.
void FactReader::drop_count() {
  if (!kind_is_counted()) return;
  const std::size_t counts = std::erase_if(facts_.before_kind, [](const SizeGroup& group) {
    const CommentToken& t = group.sizes.front();
    return !t.decimals && !t.fraction && t.unit == 0;
  });
  if (counts > 0 && facts_.before_kind.empty() && !facts_.behind_kind && facts_.loose.empty() &&
      facts_.named.empty())
    facts_.kinds.clear();
}

// Whether the number at i may go on behind a sign, as names of tools have no point: "DRILL_8-5",
// "DRILL 8P5" for 8.5.
bool FactReader::splits_size(std::size_t i) const {
  if (!kind() || is_turning(kind()->type) || facts_.thread || !view_.whole(i)) return false;
  const bool sign = view_.is_one(i + 1, {"-", "P"}) && view_.glued(i + 1);
  const bool digit = view_.whole(i + 2) && view_.glued(i + 2) && view_[i + 2].text.size() == 1;
  if (!sign || !digit || view_.glued(i + 3)) return false;
  return !view_.word(i + 3) || comment_word(view_[i + 3].text).role != WordRole::flutes;
}

// Whether the number at i may be the angle of the point, "DRILL D10 90", "DRILL D10 A90". The usual
// angles of drills (118, 135, 140) are known as such without this.
bool FactReader::may_be_point(std::size_t i) const {
  if (!view_.number(i) || !view_.whole(i) || (i > 0 && view_.is(i - 1, "X"))) return false;
  const bool lettered = i > 0 && view_.is(i - 1, "A") && view_.glued(i);
  if (!lettered && !view_.is_size(i)) return false;
  const double value = view_[i].value;
  return facts_.trade_is(ToolTrade::twist_drill)
             ? value == 90 || value == 120
             : facts_.trade_is(ToolTrade::face_mill) && value == 45;
}

void FactReader::read_rest() {
  facts_.holes = kind() && view_.is_one(kind()->end, {"HOLES", "HOLE"});
  facts_.tapered = facts_.taper > 0;
  const bool trade_is_mill =
      facts_.trade_is(ToolTrade::mill) && kind()->type == ToolType::endmill && !facts_.corner;
  for (std::size_t i = 0; i < view_.size(); ++i) {
    facts_.tapered |= view_.is_one(i, {"TAPER", "TAPERED"}) && !view_.taken(i);
    if (view_.number(i) && view_[i].angle) facts_.angles.push_back(view_[i].value);
    facts_.square |= trade_is_mill && view_.is_one(i, {"FLAT", "SQUARE"});
    facts_.helix |= view_.is_one(i, {"HELIX", "DRALL", "HELICE"});
    if (splits_size(i))
      facts_.split_size = fmt::format("{0} or {0}.{1}", view_[i].text, view_[i + 2].text);
    if (may_be_point(i)) facts_.bare_point = view_[i].value;
    facts_.bare_angle |= facts_.names_tool && view_.may_be_angle(i);
    facts_.left_hand |= is_left_hand(view_, i);
    facts_.fusion |= view_.is(i, "CR") && view_.is(i + 1, "=");
    facts_.included |= view_.is_one(i, {"INCLUDED", "INCL"});
    facts_.t_slot |= view_.is(i, "TSLOT") || (view_.is_one(i, {"T", "TEE"}) && kind() &&
                                              view_.is_one(i + 1, {"SLOT", "SLOTTER", "-"}));
    facts_.slot_mill |= view_.is(i, "KEYWAY") || names_slot_mill(view_, i);
    facts_.per_side |= view_.is(i, "SIDE") && i > 0 && view_.is_one(i - 1, {"PER", "/", "A"});
  }
  const bool slot =
      kind() && view_.is(kind()->first, "SLOT") && view_.is(kind()->first + 1, "MILL");
  facts_.fusion_slot = facts_.fusion && slot;
  facts_.slot_mill |= slot || (kind() && view_.is(kind()->first, "SLOTMILL"));
  if (kind() && kind()->first > 0 && view_.is(kind()->first, "MILL"))
    facts_.slot_mill |= view_.is_one(kind()->first - 1, {"GROOVE", "GROOVING"});
}

}  // namespace

ToolFacts read_tool_facts(std::vector<CommentToken> tokens) {
  ToolFacts facts;
  part_hyphenated_name(tokens);
  FactReader(std::move(tokens), facts).read();
  return facts;
}

}  // namespace mrsim
