#include "interp/language/program_outline.h"

#include "interp/language/flow_scan.h"
#include "interp/text/characters.h"
#include "interp/text/source.h"

#include <algorithm>

#include <fmt/format.h>

namespace mrsim {
namespace {

const char* shown(FlowWord word) {
  switch (word) {
    case FlowWord::branch:
    case FlowWord::branch_else_if:
    case FlowWord::branch_else:
    case FlowWord::branch_end:
      return "IF";
    case FlowWord::sub:
    case FlowWord::sub_end:
      return "sub";
    case FlowWord::loop_while:
      return "WHILE";
    case FlowWord::loop_do:
      return "DO";
    case FlowWord::loop_for:
      return "FOR";
    case FlowWord::loop_forever:
      return "LOOP";
    case FlowWord::loop_repeat:
      return "REPEAT";
    default:
      return "loop";
  }
}

// The word that continues or ends a structure, as programs write it.
std::string shown_end(const FlowEntry& entry) {
  switch (entry.word) {
    case FlowWord::branch_else_if:
      return "ELSEIF";
    case FlowWord::branch_else:
      return "ELSE";
    case FlowWord::branch_end:
      return "ENDIF";
    case FlowWord::sub_end:
      return "endsub";
    case FlowWord::loop_until:
      return "UNTIL";
    default:
      return entry.ends == FlowWord::none ? "END" : fmt::format("END{}", shown(entry.ends));
  }
}

bool opens(FlowWord word) {
  return word == FlowWord::branch || word == FlowWord::sub ||
         (word >= FlowWord::loop_while && word <= FlowWord::loop_repeat);
}

}  // namespace

ProgramOutline::ProgramOutline(const std::string& file, OutlineForm form) : names_(1) {
  LineSource source(file);
  std::string_view line;
  std::vector<Open> open;
  std::vector<FoundWord> found;
  sections_.emplace_back();
  int tape_marks = 0;
  for (std::uint64_t offset = 0; source.next(line); offset = source.next_offset()) {
    found.clear();
    const Place start{offset, source.line_number() - 1, 0};
    const bool tape = form == OutlineForm::owords && line.starts_with('%') &&
                      line.find_first_not_of("% \t\r") == line.npos;
    if (tape && ++tape_marks == 2) break;  // nothing behind the second mark is read
    if (form == OutlineForm::sinumerik && upper_case(line.substr(0, 4)) == "%_N_")
      begin_section(start, open);
    scan_flow(form, line, found);
    for (FoundWord& one : found) {
      FlowEntry entry;
      entry.at = {offset, start.line, one.at};
      entry.behind = one.behind;
      entry.word = one.word;
      entry.ends = one.ends;
      entry.name = one.name.empty() ? 0 : name_index(one.name);
      entry.skip = one.skip;
      if (one.fault) fault(entry.at, one.fault);
      if (one.word == FlowWord::none) continue;
      if (one.word == FlowWord::section)
        begin_section(entry.at, open);
      else
        add(entry, open);
    }
  }
  end_ = {source.next_offset(), source.line_number(), 0};
  begin_section(end_, open);
  sections_.pop_back();
}

std::uint32_t ProgramOutline::name_index(const std::string& name) {
  const auto [at, fresh] =
      name_indices_.try_emplace(name, static_cast<std::uint32_t>(names_.size()));
  if (fresh) names_.push_back(name);
  return at->second;
}

void ProgramOutline::fault(const Place& at, std::string text) {
  faults_.try_emplace(static_cast<int>(sections_.size()) - 1, OutlineFault{at, std::move(text)});
}

void ProgramOutline::begin_section(const Place& at, std::vector<Open>& open) {
  if (!open.empty()) {
    const FlowEntry& entry = entries_[static_cast<std::size_t>(open.back().entry)];
    fault(entry.at, fmt::format("the {} that begins here is not closed", shown(entry.word)));
  }
  open.clear();
  sections_.push_back(at);
}

void ProgramOutline::add(FlowEntry entry, std::vector<Open>& open) {
  entry.section = static_cast<int>(sections_.size()) - 1;
  const int index = static_cast<int>(entries_.size());
  entries_.push_back(entry);
  if (entry.word == FlowWord::label || entry.word == FlowWord::sub)
    named_.emplace(entry.name, index);
  const bool closes_do = entry.word == FlowWord::loop_while && entry.name != 0 && !open.empty() &&
                         open.back().word == FlowWord::loop_do && open.back().name == entry.name;
  if (closes_do) {  // LinuxCNC: o1 do ... o1 while [...]
    entries_.back().word = FlowWord::loop_until;
    return close(index, open);
  }
  if (entry.word == FlowWord::sub) {
    for (const Open& one : open)
      if (one.word == FlowWord::sub) fault(entry.at, "a subprogram begins inside of another");
  }
  if (opens(entry.word)) {
    open.push_back({index, entry.word, entry.name});
    entries_.back().first = index;
    return;
  }
  switch (entry.word) {
    case FlowWord::branch_else_if:
    case FlowWord::branch_else:
      return chain(index, open, false);
    case FlowWord::branch_end:
    case FlowWord::loop_end:
    case FlowWord::loop_until:
    case FlowWord::sub_end:
      return close(index, open);
    case FlowWord::loop_break:
    case FlowWord::loop_continue:
      return leave_loop(index, open);
    default:
      return;
  }
}

// Ties entry `index` to the structure that it continues or ends: the innermost, or the one of its
// name.
void ProgramOutline::chain(int index, std::vector<Open>& open, bool last) {
  FlowEntry& entry = entries_[static_cast<std::size_t>(index)];
  const bool branch = entry.word >= FlowWord::branch && entry.word <= FlowWord::branch_end;
  const auto fits = [&](const Open& one) {
    const bool kind = branch                            ? one.word == FlowWord::branch
                      : entry.word == FlowWord::sub_end ? one.word == FlowWord::sub
                      : entry.ends != FlowWord::none
                          ? one.word == entry.ends
                          : one.word != FlowWord::branch && one.word != FlowWord::sub;
    return kind && one.name == entry.name;
  };
  const auto at = std::find_if(open.rbegin(), open.rend(), fits);
  if (at == open.rend() || (entry.name == 0 && at != open.rbegin()))
    return fault(entry.at, unmatched(entry, open));
  const int first = at->entry;
  FlowEntry& head = entries_[static_cast<std::size_t>(first)];
  const int tail = head.last < 0 ? first : head.last;
  FlowEntry& before = entries_[static_cast<std::size_t>(tail)];
  if (before.word == FlowWord::branch_else && entry.word != FlowWord::branch_end)
    fault(entry.at, fmt::format("{} behind the ELSE of line {}: ELSE is the last part of its IF",
                                shown_end(entry), before.at.line + 1));
  before.next = index;
  entry.first = first;
  head.last = index;
  if (!last) return;
  for (int i = first; i >= 0; i = i == index ? -1 : entries_[static_cast<std::size_t>(i)].next)
    entries_[static_cast<std::size_t>(i)].last = index;
  if (at != open.rbegin()) {
    const FlowEntry& inner = entries_[static_cast<std::size_t>(open.back().entry)];
    fault(inner.at, fmt::format("the {} that begins here is not closed", shown(inner.word)));
  }
  open.erase(std::next(at).base(), open.end());
}

// Why `entry` neither continues nor ends an open structure.
std::string ProgramOutline::unmatched(const FlowEntry& entry, const std::vector<Open>& open) const {
  for (auto one = open.rbegin(); one != open.rend(); ++one)
    if (one->name == entry.name)
      return fmt::format("{} does not belong to the {} of line {}, which is not closed",
                         shown_end(entry), shown(one->word),
                         entries_[static_cast<std::size_t>(one->entry)].at.line + 1);
  return fmt::format("nothing begins what {} goes on with or ends", shown_end(entry));
}

void ProgramOutline::close(int index, std::vector<Open>& open) { chain(index, open, true); }

// break and continue of LinuxCNC name the loop that they leave.
void ProgramOutline::leave_loop(int index, const std::vector<Open>& open) {
  FlowEntry& entry = entries_[static_cast<std::size_t>(index)];
  for (auto one = open.rbegin(); one != open.rend(); ++one)
    if (one->name == entry.name && one->word != FlowWord::branch && one->word != FlowWord::sub) {
      entry.first = one->entry;
      return;
    }
  fault(entry.at, "there is no loop of this name about it");
}

int ProgramOutline::find(const Place& at) const {
  const auto found = std::lower_bound(
      entries_.begin(), entries_.end(), at,
      [](const FlowEntry& entry, const Place& wanted) { return entry.at < wanted; });
  if (found == entries_.end() || !(found->at == at)) return -1;
  return static_cast<int>(found - entries_.begin());
}

int ProgramOutline::find_name(FlowWord word, std::string_view name, int behind) const {
  const auto known = name_indices_.find(name);
  if (known == name_indices_.end()) return -1;
  const auto [begin, end] = named_.equal_range(known->second);
  for (auto i = begin; i != end; ++i)
    if (entry(i->second).word == word && i->second > behind) return i->second;
  return -1;
}

int ProgramOutline::find_label(std::string_view name, const Place& from, const Place& to,
                               bool last) const {
  const auto known = name_indices_.find(name);
  if (known == name_indices_.end()) return -1;
  const auto [begin, end] = named_.equal_range(known->second);
  int result = -1;
  for (auto i = begin; i != end; ++i) {
    const FlowEntry& one = entry(i->second);
    if (one.word != FlowWord::label || one.at < from || to < one.at) continue;
    if (result < 0 || last) result = i->second;
  }
  return result;
}

int ProgramOutline::section_at(const Place& at) const {
  const auto above = std::upper_bound(sections_.begin(), sections_.end(), at);
  return static_cast<int>(above - sections_.begin()) - 1;
}

Place ProgramOutline::section_begin(int section) const {
  return sections_[static_cast<std::size_t>(section)];
}

Place ProgramOutline::section_end(int section) const {
  const auto next = static_cast<std::size_t>(section) + 1;
  return next < sections_.size() ? sections_[next] : end_;
}

const OutlineFault* ProgramOutline::fault_in(int section) const {
  const auto at = faults_.find(section);
  return at == faults_.end() ? nullptr : &at->second;
}

}  // namespace mrsim
