#include "interp/tools/tool_notes.h"

#include "core/process/memory_limit.h"
#include "interp/comments/tool_hint.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

namespace mrsim {

namespace {

// "Required tools:" of Estlcam, "Tools used in this file:".
bool heads_list(const std::string& comment) {
  const std::string text = upper_case(comment);
  for (const std::string_view head : {"REQUIRED TOOLS", "TOOLS USED", "WERKZEUGE:"})
    if (text.find(head) != std::string::npos) return true;
  return false;
}

// Blocks of the head, "%" and "O0001". Behind them and a block of modes, a comment on its own is no
// title any more.
constexpr std::size_t kHeaderBlocks = 2;

// Whether the text is an operation as Fusion numbers them, "GROOVE4" or "PROFILE1". A title has
// other words ("BORE 25 H7 BUSH").
bool is_numbered_operation(std::string_view text) {
  const std::size_t digits = text.find_first_of("0123456789");
  return digits != text.npos && digits > 0 &&
         text.find_first_not_of("0123456789", digits) == text.npos &&
         std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(digits), is_letter);
}

// How many comments of a list are kept, so that a program of nothing but comments needs little
// memory.
constexpr std::size_t kLongestList = 1000;

// Whether the number ends what is said of a tool: "(BALL MILL D8)", "(TOOL NUMBER: 5)", "(DRILL
// D6)",
// "(TOOL NUMBER: 6)".
bool numbers_come_last(const std::vector<ToolHint>& comments) {
  return comments.front().id.empty() && comments.back().bare_id && !comments.back();
}

// Whether the text has the name as a whole word: "MILL_D10_R1" does not have MILL_D10.
bool has_name(const std::string& text, const std::string& id) {
  const auto inside = [&](std::size_t i) { return i < text.size() && is_name(text[i]); };
  for (std::size_t at = text.find(id); at != text.npos; at = text.find(id, at + 1))
    if (!inside(at + id.size()) && (at == 0 || !inside(at - 1))) return true;
  return false;
}

// Whether a name is distinct, as "MILL_D20R2" of a tool list; DRILL is a word of many comments.
bool is_distinct_name(const std::string& id) {
  return id.find_first_of("0123456789") != id.npos && id.find_first_not_of("0123456789") != id.npos;
}

// "6mm endmill" is a tool wherever it stands, while "drill 6mm" may be the work.
bool is_tool_with_size(const ToolHint& hint) {
  if (!hint.type || !hint.firm || hint.diameters.empty()) return false;
  return hint.diameters.front().unit > 0 || hint.diameters.front().fraction;
}

// "V-Bit 60 deg": its cone ends where the cuts do.
bool is_open_cone(const ToolHint& hint) {
  return hint.trade == ToolTrade::vee && hint.firm && hint.tip_angle + hint.taper_angle > 0;
}

// Checks the memory for that many comments, each time their number has doubled.
void require_notes(std::size_t count) {
  constexpr std::size_t kFew = 1024;
  constexpr double kNote = 550;  // bytes, measured
  if (count >= kFew && std::has_single_bit(count))
    require_memory(kNote * double(count), fmt::format("more than {} comments about tools", count));
}

}  // namespace

long turret_station(long number, std::size_t digits) {
  const long pair = number % 100;
  if (digits == 6 && number == pair * 10101) return pair;
  if (digits == 6 || digits == 8) return number / (digits == 6 ? 1000 : 10000);
  return number > 99 ? number / 100 : number;
}

void ToolNotes::add(const std::string& id, const ToolHint& hint) {
  require_notes(hints_.size());
  if (again_.has_cut(id)) {
    again_.add(id, hint);
    if (id == current_ && !cuts_since_change_) again_.bring(id, hints_);
    return;
  }
  const auto [at, fresh] = hints_.try_emplace(id, hint);
  const bool repeated = at->second.text.find(hint.text) != std::string::npos;
  if (!fresh && !repeated) merge_hint(at->second, hint);
}

void ToolNotes::comment(std::string_view bytes, const std::string& called, bool alone, bool heads) {
  ToolHint hint = read_tool_comment(bytes);
  const bool is_lone = !std::exchange(commented_, true);
  operation_.reset();
  if (lathe_ && !cuts_ && alone && is_lone && blocks_ > kHeaderBlocks && !hint && hint.id.empty() &&
      (hint.operation || hint.bores) && is_numbered_operation(bytes))
    operation_ = hint;
  hint.at_call = !called.empty() || blocks_since_change_ <= 0;
  if (hint.of_other_tool()) return;
  if (hint.only_diameter()) {
    if (!called.empty()) not_understood_.try_emplace(called, hint.text);
    const bool added = called.empty() && alone && add_size(hint);
    if (added || !hint.names_tool) return;
  }
  if (turret_digits_ > 0 && hint.id_digits >= turret_digits_)
    hint.id = fmt::format("{}", turret_station(std::stol(hint.id), hint.id_digits));
  if (lathe_ && !hint.id.empty() && !hint) name_by_operation(hint);  // "T0505 ID FINISH"
  if (!hint.id.empty() && hint) {
    told_id_ = called.empty() && alone ? hint.id : std::string();
    return add(hint.id, hint);
  }
  if (const std::string& id = hint.id.empty() ? called : hint.id; !id.empty() && !hint)
    not_understood_.try_emplace(id, hint.text);
  if (!called.empty()) {
    if (lathe_ && !hint) name_by_operation(hint);
    const bool details = hint.only_angle() || hint.size_line;
    if (hint || (details && find(called))) add(called, hint);
    return;
  }
  if (alone) stands_alone(std::move(hint), heads);
}

void ToolNotes::stands_alone(ToolHint hint, bool heads) {
  // "USES BAR PULLER" is no name of the tool. If it were, the tool's moves would not be swept.
  if (lathe_ && hint.trade == ToolTrade::no_cutter && hint.id.empty() && !hint.bare_kind) return;
  // Behind the first cut, operations are no list of what the program does.
  if (lathe_ && (cuts_ || heads) && !hint && (hint.operation || hint.bores))
    name_by_operation(hint);
  if (tells_kind(hint)) return add(open_id(), hint);
  lists_ = lists_ || heads_list(hint.text);
  if (is_of_work(hint)) return;
  if (hint.only_corner()) {
    add_size(hint);
    return;
  }
  if (adds_details(hint) && add_size(hint)) return;
  if (!(hint || !hint.id.empty() || hint.only_angle())) return;
  if (!comments_.empty() && comments_.back().only_angle() && !hint.only_angle()) {
    merge_hint(hint, comments_.back());
    comments_.pop_back();
  }
  const bool is_tool = hint.names_tool || (hint.type && lists_) || is_tool_with_size(hint);
  const bool has_data = hint.diameter > 0 || hint.settings || is_open_cone(hint);
  if (hint.id.empty() && is_tool && has_data) add_nameless(hint);
  const bool known = find(current_) != nullptr;
  if (hint.id.empty() &&
      (blocks_since_change_ == 0 ? !known || tells_more(current_, hint) : behind_next_ && !known))
    return add(current_, hint);
  if (hint.id.empty()) add_unnumbered(hint);
  if (hint.id.empty() && !cuts_ && named_.size() < kLongestList) named_.push_back(hint);
  if (comments_.size() == kLongestList) settle_comments();
  told_id_.clear();
  comments_.push_back(std::move(hint));
}

// Sorts the comments between two blocks by the tools that they name. The last of them wait for
// their tool.
void ToolNotes::settle_comments() {
  if (comments_.empty()) return;
  end_group();
  const bool last = numbers_come_last(comments_);
  for (const ToolHint& hint : comments_) {
    const bool ends = last && hint.bare_id && !hint;
    if (!hint.id.empty() && !ends) end_group();  // "TOOL 3" begins what is said of it
    if (group_.text.empty())
      group_ = hint;
    else
      merge_hint(group_, hint);
    if (ends) end_group();
  }
  comments_.clear();
}

void ToolNotes::end_group() {
  if (!group_.id.empty() && group_) add(group_.id, group_);
  group_ = {};
}

// A comment with a size and no number is about the tool that a T word has named and no M6 has
// brought yet (pcb2gcode), or about the one in the spindle before its first cut, else about the
// next.
void ToolNotes::add_unnumbered(const ToolHint& hint) {
  const bool coded = lathe_ && !hint.insert.empty();
  const bool is_ready = !called_.empty() && (current_.empty() || cuts_since_change_);
  if (!(hint.diameter > 0) && !coded) return;
  if (is_ready && hint.type && find(called_) == nullptr) return add(called_, hint);
  if (!hint.firm && !hint.names_tool && !coded) return;
  if (is_ready && find(called_) == nullptr) return add(called_, hint);
  const ToolHint* const known = find(current_);
  if ((hint.firm || coded) && !current_.empty() && !cuts_since_change_ &&
      (known == nullptr || (called_.empty() && (!known->type || again_.has_cut(current_)))))
    add(current_, hint);
}

// "(T1 D6.)" stands at the head and "(DRILL 118)" or "(BALL MILL D8)" at the call: the kind is
// added, and a contradiction becomes a doubt.
bool ToolNotes::tells_more(const std::string& id, const ToolHint& hint) const {
  const ToolHint* const known = find(id);
  return known && hint.id.empty() && hint.type && (hint.firm || !known->type || again_.has_cut(id));
}

// "T0303 (GROOVE 3MM)", "T0404 (OD THREAD)", "T0505 (FINISH BORE)", "T0101 (OD ROUGH R0.8)": on a
// lathe the operation names the kind of the block's tool. A groove needs a blade, not a pointed
// insert, so without a width the blade is asked for.
void ToolNotes::name_by_operation(ToolHint& hint) {
  if (hint.operation != ToolType::turning || hint.nose) hint.type = hint.operation;
  if (hint.inside && (!hint.operation || hint.type == ToolType::turning))
    hint.type = ToolType::boring;
}

// The numbered tool that the comment before is about, or the one just changed to.
const std::string& ToolNotes::open_id() const {
  return blocks_since_change_ == 0 && find(current_) != nullptr ? current_ : told_id_;
}

// Whether the comment adds the kind: "BALL NOSE" below "T1 6MM".
bool ToolNotes::tells_kind(const ToolHint& hint) const {
  const ToolHint* const open = open_id().empty() ? nullptr : find(open_id());
  return open && !open->type && open->diameter > 0 && hint.type && hint.id.empty() &&
         hint.diameters.empty() && (hint.firm || hint.bare_kind);
}

// Whether the comment is about the work: "FINISH R3" or "45 DEG" at the change to a tool whose kind
// is known. Next to the tool's own comment they may be about the tool.
bool ToolNotes::is_of_work(const ToolHint& hint) const {
  const ToolHint* const known = blocks_since_change_ == 0 ? find(current_) : nullptr;
  const bool is_tool = hint.firm && hint.diameter > 0;  // "Ball Nose {3 mm}"
  const bool is_open = (hint.plain_radius && !is_tool) || (hint.only_angle() && !hint.own_angle);
  return known && known->type && is_open;
}

// Whether the comment adds details: "TAPER ANGLE: 5." or "D10. R1." below a kind without its size.
bool ToolNotes::adds_details(const ToolHint& hint) const {
  if (hint.only_angle() || (hint.size_line && !hint)) return true;
  const ToolHint* const open = open_id().empty() ? nullptr : find(open_id());
  return hint.size_line && open && open->type;
}

// "DIAMETER: 10.0" and "CORNER RADIUS: 1.0" count only beside other comments about the tool.
bool ToolNotes::add_size(const ToolHint& hint) {
  if (const std::string& id = open_id(); !id.empty()) {
    add(id, hint);
    return true;
  }
  if (comments_.empty()) return false;
  if (nameless_.text == comments_.back().text) merge_hint(nameless_, hint);
  if (!named_.empty() && named_.back().text == comments_.back().text)
    merge_hint(named_.back(), hint);
  merge_hint(comments_.back(), hint);
  return true;
}

// "(Endmill 3mm)" in a program without T words.
void ToolNotes::add_nameless(const ToolHint& hint) {
  if (cuts_) {
    const bool same = !nameless_.diameters.empty() && !hint.diameters.empty() &&
                      nameless_.diameters.front().value == hint.diameters.front().value &&
                      nameless_.diameters.front().unit == hint.diameters.front().unit;
    if (adopted_ && !same) other_ = hint.text;
    return;
  }
  if (nameless_.text.empty())
    nameless_ = hint;
  else if (nameless_.text.find(hint.text) == std::string::npos)
    merge_hint(nameless_, hint);
}

bool ToolNotes::adopt_nameless() {
  if (!hints_.empty() || nameless_.text.empty()) return false;
  hints_.try_emplace("", nameless_);
  adopted_ = true;
  return true;
}

void ToolNotes::call(const std::string& id) {
  settle_comments();
  const bool other = !group_.id.empty() && group_.id != id;
  const bool listed = !other && add_by_name(id);
  if (lathe_) add_no_cutter(id);
  if (operation_ && find(id) == nullptr) {
    name_by_operation(*operation_);
    if (*operation_) add(id, *operation_);
  }
  if (group_ && !listed && (other || find(id) == nullptr || tells_more(id, group_)))
    add(other ? group_.id : id, group_);
  group_ = {};
  called_ = id;
}

// T="BAR_STOP" names no cutter.
void ToolNotes::add_no_cutter(const std::string& id) {
  if (id.find_first_not_of("0123456789") == id.npos || find(id) != nullptr) return;
  std::string name = id;
  std::replace(name.begin(), name.end(), '_', ' ');
  const ToolHint hint = read_tool_comment(name);
  if (hint.trade == ToolTrade::no_cutter && hint.bare_kind) add(id, hint);
}

// Takes what a list says behind the name, "; MILL_D20R2 (D20 R2)". False: no comment names the
// tool.
bool ToolNotes::add_by_name(const std::string& id) {
  if (!is_distinct_name(id)) return false;
  bool found = false;
  for (const ToolHint& hint : named_) {
    const bool sized = hint.diameter > 0 || !hint.insert.empty();
    if (!sized || !has_name(hint.text, id)) continue;
    add(id, hint);
    found = true;
  }
  return found;
}

void ToolNotes::change(const std::string& id, const std::string& place) {
  current_ = id;
  called_.clear();
  cuts_since_change_ = false;
  blocks_since_change_ = -1;  // because the block of the change has not ended
  again_.change(place);
  again_.bring(id, hints_);
}

void ToolNotes::end_block(bool calls_next) {
  settle_comments();
  told_id_.clear();
  operation_.reset();
  commented_ = false;
  ++blocks_;
  behind_next_ = calls_next && blocks_since_change_ == 0;
  if (blocks_since_change_ < 1) ++blocks_since_change_;
}

void ToolNotes::end_waiting() {
  settle_comments();
  end_group();
}

std::string ToolNotes::not_understood(const std::string& id) const {
  const auto at = not_understood_.find(id);
  return at == not_understood_.end() ? std::string() : at->second;
}

const ToolHint* ToolNotes::find(const std::string& id) const {
  const auto at = hints_.find(tool_of(id));
  return at == hints_.end() ? nullptr : &at->second;
}

}  // namespace mrsim
