#include "interp/comments/tool_labels.h"

#include "interp/comments/comment_words.h"
#include "interp/comments/letter_diameters.h"
#include "interp/comments/shank_words.h"
#include "interp/comments/tool_sizes.h"
#include "interp/comments/work_words.h"

#include <algorithm>
#include <utility>

namespace mrsim {
namespace {

constexpr std::size_t kNone = CommentView::kNone;
constexpr double kLeastAngle = 10;  // degrees: "POINT 1" is a place

/// Words that stand together: "CORNER RADIUS", "SHANK DIA".
struct Label {
  WordRole role = WordRole::none;
  NumberSide side = NumberSide::either;
  std::size_t first = 0, end = 0;
};

// What two words name together. none: the second word begins a label of its own.
WordRole joined(WordRole a, WordRole b) {
  using enum WordRole;
  const bool rounding = b == WordRole::radius || b == radius_letter;
  if ((a == other || a == work) && (b == diameter || b == other || rounding || b == angle))
    return a;
  if (a == diameter && b == register_of) return other;
  if ((a == corner || a == tip) && rounding) return WordRole::radius;
  if (a == nose && rounding) return nose;
  if (a == tip && (b == diameter || b == angle)) return b == diameter ? tip : angle;
  if (a == tip && b == tip) return tip;
  if (a == flutes && b == other) return length;
  if ((a == taper && b == angle) || (a == angle && b == taper)) return taper;
  if (a == angle && b == angle) return angle;
  return none;
}

class LabelReader {
 public:
  LabelReader(CommentView& view, ToolFacts& facts) : view_(view), facts_(facts) {}

  void read() {
    read_flutes();
    for (std::size_t i = 0; i < view_.size(); ++i) {
      const Label label = label_at(i);
      if (label.role == WordRole::none) continue;
      read_label(label);
      i = label.end - 1;
    }
  }

 private:
  CommentWord named(std::size_t i) const;
  WordRole role(std::size_t i) const { return named(i).role; }
  Label label_at(std::size_t i) const;
  void read_flutes();
  bool counts_flutes(std::size_t i) const;
  bool claimed(std::size_t number) const;
  bool begins_nose(std::size_t i) const;
  bool is_of_kind(std::size_t number) const;
  bool ends_size(std::size_t i) const {  // ".03R 1/2 EM"
    return i > 0 && view_.glued(i) && view_.number(i - 1) && !view_.whole(i - 1);
  }
  std::size_t number_behind(const Label& label) const;
  std::size_t number_before(const Label& label) const;
  bool may_be_round() const;
  bool has_corner() const;
  void read_label(const Label& label);
  void read_diameter(const Label& label);
  bool is_angle(std::size_t number) const {  // a usual one of the kind
    return !facts_.kinds.empty() && is_usual_angle(facts_.kinds.front().trade, view_[number].value);
  }
  void read_register(const Label& label);
  void read_corner(const Label& label);
  void keep(WordRole role, std::size_t number);
  void take(const Label& label, std::size_t number) {
    view_.take(std::min(label.first, number), std::max(label.end, number + 1));
  }

  CommentView& view_;
  ToolFacts& facts_;
};

// What the word at i names. FLAT and MIN DIA of a chamfer mill are its tip.
CommentWord LabelReader::named(std::size_t i) const {
  if (!view_.word(i)) return {};
  const bool least = view_.is(i, "MIN") && view_.is_one(i + 1, {"DIA", "DIAM", "DIAMETER"});
  if ((least || view_.is(i, "FLAT")) && facts_.has_flat_tip())
    return {WordRole::tip, NumberSide::either};
  const bool letter_behind = view_.is(i, "W") && ends_size(i) && !view_.number(i + 1);
  if (letter_behind) return {WordRole::width, NumberSide::before};  // ".125W GROOVE"
  if (view_.is(i, "OUT")) {  // "DRILL 10 OUT OF 20", "EM 12 OUT 40"
    if (view_.is(i + 1, "OF") && view_.number(i + 2)) return {};
    const bool behind_kind = i > 0 && !facts_.kinds.empty() && facts_.kinds.front().end == i - 1;
    if (behind_kind && view_.number(view_.behind(i))) return {WordRole::other, NumberSide::behind};
  }
  return comment_word(view_[i].text);
}

Label LabelReader::label_at(std::size_t i) const {
  if (!view_.word(i) || view_.taken(i)) return {};
  const CommentWord word = named(i);
  if (word.role == WordRole::adjective) return {};
  Label label{word.role, word.side, i, i + 1};
  while (label.role != WordRole::none && view_.word(label.end)) {
    const bool of_work = is_diameter_of_work(view_, facts_.kind(), label.first, label.end);
    const WordRole both = of_work ? WordRole::work : joined(label.role, role(label.end));
    if (both == WordRole::none || begins_nose(label.end)) break;
    label.role = both;
    label.side = NumberSide::either;
    ++label.end;
  }
  return label;
}

// Takes the number of flutes, so that no other word gets it: "4 FLUTE", "3-FLUTE", "4FL", "Z4",
// "Z=4", "FLUTES: 2".
void LabelReader::read_flutes() {
  for (std::size_t i = 0; i < view_.size(); ++i) {
    const Label label = label_at(i);
    if (label.role != WordRole::flutes) continue;
    const bool dash = i > 1 && view_.is(i - 1, "-") && view_.glued(i - 1);
    const std::size_t before = dash ? i - 2 : i - 1;
    const bool glued_before = i > 0 && before > 0 && view_.glued(before) && view_.word(before - 1);
    const std::size_t behind = view_.behind(i);
    const bool names_it = behind > i + 1 ? !view_.is(i + 1, "-") : view_.glued(i + 1);
    if (names_it && view_.number(behind) && view_.whole(behind)) {
      view_.take(i, behind + 1);
    } else if (i > 0 && view_.number(before) && view_.whole(before) && !glued_before) {
      facts_.counts_flutes |= facts_.kinds.empty() && counts_flutes(i);
      facts_.names_tool |= facts_.counts_flutes;
      view_.take(before, i + 1);
    }
  }
}

// Whether the word behind a number counts flutes and nothing else, so that the comment is about a
// tool: "10MM CRB 2FL", "1/2 HSS 2 FLUTE", "D10 4F". F and Z elsewhere are a feed and a height.
bool LabelReader::counts_flutes(std::size_t i) const {
  if (view_.is(i, "F")) return view_.glued(i) && !view_.glued(i + 1);
  return view_.is_one(i, {"FL", "FLT", "FLUTE", "FLUTES", "FLUTED", "SCHNEIDER", "SCHNEIDEN",
                          "DENTS", "TAILLES", "LABIOS", "TAGLIENTI", "DENTI", "OSTRZY", "OSTRZA"});
}

// Whether the number belongs to the word behind it, which has no other: the 3.0 in "1.0 LOC 3.0
// OAL".
bool LabelReader::claimed(std::size_t number) const {
  const Label next = label_at(number + 1);
  using enum WordRole;
  if (next.role == none || next.role == corner || next.role == register_of) return false;
  if (next.side == NumberSide::behind) return false;
  if (next.role == radius_letter) return view_.glued(next.first) && !view_.glued(next.end);
  const std::size_t behind = view_.behind(next.end - 1);
  return !view_.number(behind);
}

// Whether R at i begins the nose radius of a lathe's tool: "FINISH BORE R0.4", "35 DEG PROFILE
// R.8".
bool LabelReader::begins_nose(std::size_t i) const {
  if (!facts_.kinds.empty() && !is_turning(facts_.kinds.front().type)) return false;
  return i > 0 && view_.is_one(i - 1, {"BORE", "PROFILE"}) && view_.is(i, "R") &&
         view_.number(i + 1) && !view_.whole(i + 1) && view_[i + 1].value < 1.7;
}

// Whether the number stands before the kind and is its size: the 0.8 in "1/8 SHANK 0.8MM DRILL".
bool LabelReader::is_of_kind(std::size_t number) const {
  if (facts_.kinds.empty()) return false;
  std::size_t i = number + 1;
  while (view_.taken(i) || role(i) == WordRole::adjective) {
    if (i == facts_.kinds.front().first) return true;
    ++i;
  }
  return false;
}

std::size_t LabelReader::number_behind(const Label& label) const {
  const bool width = label.role == WordRole::width && number_before(label) == kNone;
  if (label.side == NumberSide::before && !width) return kNone;  // "THK 2" has it behind
  const bool letter = label.end == label.first + 1 && view_[label.first].text.size() == 1;
  const bool radius = label.role == WordRole::radius_letter && !ends_size(label.first);
  if (letter && !view_.glued(label.end) && !(radius && has_corner())) return kNone;  // "BALL R 3"
  std::size_t number = view_.behind(label.end - 1);
  const bool sign_of_size = view_.is(number, "D") || view_.is(number, "~");
  if (label.role == WordRole::tip && sign_of_size) number = view_.behind(number);  // "TIP D2"
  const bool angle = label.role == WordRole::angle || label.role == WordRole::taper;
  if (!view_.number(number) || (view_[number].angle && !angle)) return kNone;
  const bool sign = number > label.end && !view_.is(label.end, "-");
  if (sign || view_.glued(number)) return number;
  const bool other = label.role == WordRole::work ||
                     (label.role == WordRole::other && number_before(label) != kNone);
  return claimed(number) || (other && is_of_kind(number)) ? kNone : number;
}

std::size_t LabelReader::number_before(const Label& label) const {
  if (label.side == NumberSide::behind || label.first == 0) return kNone;
  const std::size_t number = label.first - 1;
  if (label.role == WordRole::radius_letter) {  // ".030R", ".031 R"
    const bool behind_word = number > 0 && view_.number(number) && view_.word(number - 1) &&
                             view_[number - 1].text.size() > 2 &&
                             view_[number].text.starts_with('.');  // "FIN.015R"
    if ((!view_.is_size(number) && !behind_word) || (view_.whole(number) && !may_be_round()))
      return kNone;
    const bool ends = ends_size(label.first) || !view_.number(label.end);
    return !view_.glued(label.end) && ends ? number : kNone;
  }
  return view_.is_size(number) ? number : kNone;
}

void LabelReader::read_label(const Label& label) {
  if (label.role == WordRole::flutes) return;
  if (label.role == WordRole::corner) return read_corner(label);
  if (label.role == WordRole::register_of) return read_register(label);
  if (label.role == WordRole::diameter) return read_diameter(label);
  std::size_t number = number_behind(label);
  if (number != kNone && cuts_behind_shank(view_, label.first, number)) {
    facts_.named.push_back(view_.length(number));  // "6MM SHANK 3MM CUT"
    view_.take(number, number + 2);
    number = kNone;
  }
  if (number == kNone) number = number_before(label);
  if (number == kNone) return;
  if (label.role == WordRole::tip && !facts_.has_flat_tip()) return;
  if (label.role == WordRole::count && !view_.whole(number)) return;  // "1/4 HOLES"
  if (label.role == WordRole::angle && view_[number].value < kLeastAngle) return;
  const bool letter = view_.is(label.first, "A");  // "SPOT DRILL D10 A90"; a rotary axis, or A36
  if (letter && !is_angle(number)) return;
  keep(label.role, number);
  take(label, number);
  if (label.role != WordRole::other && label.role != WordRole::work) return;
  for (std::size_t i = number + 1; view_.is(i, "X") && view_.number(i + 1); i += 2)
    view_.take(i, i + 2);  // "STOCK 100 X 50"
}

// Takes a number that tells what is taken off the work: "FACE MILL 0.5MM OFF TOP".
void LabelReader::read_register(const Label& label) {
  const bool off = view_.is(label.first, "OFF") && label.first > 0;
  if (off && number_behind(label) == kNone && view_.is_size(label.first - 1))
    view_.take(label.first - 1);
}

// Reads a corner radius: "D10 ENDMILL CORNER 0.5", "CORNER=1", ".03 CORNER" at the end. "CORNER 1"
// is a place on the part.
void LabelReader::read_corner(const Label& label) {
  std::size_t number = number_behind(label);
  const bool ends = !view_.word(label.end) || view_.taken(label.end);
  if (number == kNone && ends) number = number_before(label);
  const bool corner = has_corner() || (facts_.kinds.empty() && facts_.names_tool);
  if (number == kNone || !corner) return;
  const bool signed_size = view_.is(label.end, "=") || view_.is(label.end, ":");
  if (!view_[number].decimals && !signed_size) return;
  keep(WordRole::radius, number);
  take(label, number);
}

// Whether R names a corner radius, "DIA 12 R 1": of mills, inserts and cutters. In "DRILL R 5" it
// is a height.
bool LabelReader::has_corner() const {
  using enum ToolTrade;
  if (facts_.kinds.empty()) return facts_.names_tool && !facts_.named.empty();
  const ToolTrade trade = facts_.kinds.front().trade;
  return trade == mill || trade == face_mill || trade == lathe;
}

// Whether R behind a number may be a radius: "BALL NOSE 3 R". "CNMG 432 R" is right-handed.
bool LabelReader::may_be_round() const {
  if (facts_.kinds.empty()) return false;
  const ToolType type = facts_.kinds.front().type;
  return type == ToolType::ballmill || type == ToolType::bullmill || type == ToolType::lollipop;
}

void LabelReader::keep(WordRole role, std::size_t number) {
  const ToolLength length = view_.length(number);
  switch (role) {
    case WordRole::radius:
    case WordRole::radius_letter:
      facts_.corner = length;
      facts_.square = length.value == 0;
      facts_.padded_radius = view_.number(number) && !view_[number].decimals &&
                             view_[number].text.size() > 1 && view_[number].text.front() == '0' &&
                             length;
      return;
    case WordRole::nose:
      facts_.nose = length;
      return;
    case WordRole::width:
      facts_.width = length;
      return;
    case WordRole::length:
      facts_.flute_length = length;
      return;
    case WordRole::tip:
      facts_.tip = length;
      return;
    case WordRole::angle:
      facts_.angles.push_back(length.value);
      return;
    case WordRole::taper:
      facts_.taper = length.value;
      return;
    default:
      return;
  }
}

// Reads "DIA. - 10.", ".5 DIA". Numbers on both sides of the word are two readings of the diameter.
void LabelReader::read_diameter(const Label& label) {
  const std::size_t i = label.first;
  facts_.names_tool |= i > 0 && view_.is_one(i - 1, {"TOOL", "CUTTER", "BIT"});
  if (!facts_.kinds.empty()) {
    const ToolKind& kind = facts_.kinds.front();
    facts_.names_tool |= i > 0 && kind.firm && kind.first == 0 && kind.end == i;
  }
  std::size_t behind = number_behind(label), before = number_before(label);
  const bool sign = behind != kNone && behind > label.end;
  if (before != kNone && behind != kNone && !sign && is_angle(before) != is_angle(behind))
    (is_angle(before) ? before : behind) = kNone;  // "SPOT 90 DIA 12"
  if (behind != kNone && is_size_of_shank(view_, behind)) {
    take(label, behind);  // "DIA 6 SHANK DIA 3 CUT"
    return;
  }
  if (behind != kNone && view_[behind].value > 0) {
    facts_.named.push_back(view_.length(behind));
    take(label, behind);
  }
  if (before != kNone && !sign) {
    facts_.named.push_back(view_.length(before));
    take(label, before);
  }
}

void read_blade(CommentView& view, ToolFacts& facts) {
  facts.blade = find_blade_code(view.tokens());
  if (!facts.blade) return;
  if (facts.blade->width > 0) facts.width = {facts.blade->width, 1, false};
  facts.inside = facts.blade->inside;
  view.take(facts.blade->first, facts.blade->end);
}

}  // namespace

void read_tool_labels(CommentView& view, ToolFacts& facts) {
  read_blade(view, facts);
  LabelReader(view, facts).read();
  read_letter_diameters(view, facts);
}

}  // namespace mrsim
