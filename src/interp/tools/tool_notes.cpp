#include "interp/tools/tool_notes.h"

#include "interp/text/characters.h"

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

// "6mm endmill" is a tool wherever it stands; "drill 6mm" may be the work.
bool is_tool_with_size(const ToolHint& hint) {
  if (!hint.type || !hint.firm || hint.diameters.empty()) return false;
  return hint.diameters.front().unit > 0 || hint.diameters.front().fraction;
}

}  // namespace

long turret_station(long number, std::size_t digits) {
  const long pair = number % 100;
  if (digits == 6 && number == pair * 10101) return pair;
  if (digits == 6 || digits == 8) return number / (digits == 6 ? 1000 : 10000);
  return number > 99 ? number / 100 : number;
}

void ToolNotes::add(const std::string& id, const ToolHint& hint) {
  const auto [at, fresh] = hints_.try_emplace(id, hint);
  const bool repeated = at->second.text.find(hint.text) != std::string::npos;
  if (!fresh && !repeated) merge_hint(at->second, hint);
}

void ToolNotes::comment(std::string_view bytes, const std::string& called, bool alone, bool heads) {
  ToolHint hint = read_tool_comment(bytes);
  if (turret_digits_ > 0 && hint.id_digits >= turret_digits_)
    hint.id = fmt::format("{}", turret_station(std::stol(hint.id), hint.id_digits));
  if (!hint.id.empty() && hint) return add(hint.id, hint);
  if (const std::string& id = hint.id.empty() ? called : hint.id; !id.empty() && !hint)
    not_understood_.try_emplace(id, hint.text);
  if (!called.empty()) {
    if (lathe_ && !hint) name_by_operation(hint);
    if (hint) add(called, hint);
    return;
  }
  if (!alone) return;
  // Behind the first cut it is no list of what the program does.
  if (lathe_ && (cuts_ || heads) && !hint && (hint.operation || hint.bores))
    name_by_operation(hint);
  lists_ = lists_ || heads_list(hint.text);
  if (hint.only_corner()) return add_corner(hint);
  if (!(hint || !hint.id.empty())) return;
  const bool is_tool = hint.names_tool || (hint.type && lists_) || is_tool_with_size(hint);
  if (hint.id.empty() && is_tool && hint.diameter > 0) add_nameless(hint);
  if (hint.id.empty() && blocks_since_change_ == 0 && find(current_) == nullptr)
    return add(current_, hint);
  if (hint.id.empty()) add_unnumbered(hint);
  if (!hint.id.empty() || interrupted_) {  // "TOOL 3" begins what is said of it
    if (!group_.id.empty() && group_) add(group_.id, group_);
    group_ = {};
  }
  interrupted_ = false;
  if (group_.text.empty())
    group_ = hint;
  else
    merge_hint(group_, hint);
}

// A tool with its size: one that a T word has named and no M6 brought yet (pcb2gcode), or the one
// in the spindle before its first cut; or the next, as that may be none.
void ToolNotes::add_unnumbered(const ToolHint& hint) {
  if (!(hint.firm || hint.names_tool) || !(hint.diameter > 0)) return;
  const bool is_ready = !called_.empty() && (current_.empty() || cuts_since_change_);
  if (is_ready && find(called_) == nullptr) return add(called_, hint);
  if (hint.firm && !current_.empty() && !cuts_since_change_ && find(current_) == nullptr)
    add(current_, hint);
}

// "T0303 (GROOVE 3MM)", "T0404 (OD THREAD)", "T0505 (FINISH BORE)", "T0101 (OD ROUGH R0.8)": on a
// lathe the tool of the block does that. No pointed insert cuts a groove: without its width the
// blade is asked for.
void ToolNotes::name_by_operation(ToolHint& hint) {
  if (hint.operation != ToolType::turning || hint.nose) hint.type = hint.operation;
  if (hint.inside && (!hint.operation || hint.type == ToolType::turning))
    hint.type = ToolType::boring;
}

// It counts beside other comments about the tool only.
void ToolNotes::add_corner(const ToolHint& hint) {
  if (blocks_since_change_ == 0 && find(current_) != nullptr)
    add(current_, hint);
  else if (!group_.text.empty() && !interrupted_)
    merge_hint(group_, hint);
}

// "(Endmill 3mm)" in a program without T words.
void ToolNotes::add_nameless(const ToolHint& hint) {
  if (cuts_) {
    const bool same = !nameless_.diameters.empty() &&
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
  const bool other = !group_.id.empty() && group_.id != id;
  if (group_ && (other || find(id) == nullptr)) add(other ? group_.id : id, group_);
  group_ = {};
  called_ = id;
}

void ToolNotes::change(const std::string& id) {
  current_ = id;
  called_.clear();
  cuts_since_change_ = false;
  blocks_since_change_ = -1;  // the block of the change is still to end
}

void ToolNotes::end_block() {
  interrupted_ = true;
  if (blocks_since_change_ < 1) ++blocks_since_change_;
}

std::string ToolNotes::not_understood(const std::string& id) const {
  const auto at = not_understood_.find(id);
  return at == not_understood_.end() ? std::string() : at->second;
}

const ToolHint* ToolNotes::find(const std::string& id) const {
  const auto at = hints_.find(id);
  return at == hints_.end() ? nullptr : &at->second;
}

}  // namespace mrsim
