#include "interp/tools/tool_changer.h"

#include "core/text/text_io.h"
#include "core/words/tool_types.h"
#include "interp/comments/form_outline.h"
#include "interp/text/characters.h"
#include "interp/tools/tool_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
ToolChanger::ToolChanger(Control& control)
    : ControlPart(control),
      tool_(control.tool),
      notes_(lathe(), turret_digits()),
      data_(control, notes_),
      edges_(control, data_) {}

const Tool* ToolChanger::used_tool(const std::string& id) const {
  const auto at = used_.find(id);
  return at == used_.end() ? nullptr : &program_.tools[static_cast<std::size_t>(at->second)];
}

void ToolChanger::use(Tool tool) {
  tool_.index = static_cast<int>(program_.tools.size());
  used_.emplace(tool.id, tool_.index);
  program_.tools.push_back(std::move(tool));
}

void ToolChanger::read_comments() {
  const Word* t = peek('T');
  std::string called;
  if (t != nullptr)
    called = id_of(*t);
  else if (!block_.words.empty() && tool_.pending.active)
    called = tool_.pending.id;
  if (!block_.comments.empty()) notes_.set_unit(scale());
  for (const std::string_view comment : block_.comments)
    notes_.comment(comment, called, block_.words.empty(), block_.name.starts_with("NAT"));
  if (const std::string other = notes_.other_nameless(); !other.empty())
    reporter_.add(Severity::error, "tool-unknown",
                  fmt::format("the comment \"{}\" names another tool than the first, and no T word "
                              "says that it comes: write one, with M6, or split the program",
                              other),
                  0, 1);
}

bool ToolChanger::apply() {
  if (is(Dialect::codesys) && is_circular(current_motion()) &&
      (peek('I') || peek('J') || peek('K') || block_.motion_code))
    return true;  // the opening angle
  const Word* word = block_.set_tool ? block_.set_tool : take('T');
  if (word && cancels_offset(*word)) return true;
  if (word || block_.tool_change) control_.saved_tool = tool_;
  const bool mill = is(Dialect::fanuc) && !lathe();
  if (mill && block_.tool_change && brings_assumed()) return false;
  if (mill && block_.tool_change && !word && !tool_.pending.active && !tool_.chosen)
    tool_.came_unnamed = true;
  if (word) {
    const bool brought = mill && brings_waiting(*word);
    if (!select(*word)) return false;
    if (brought) return true;
    if (block_.tool_change) tool_.direct_change = false;  // M6
    if (lathe() || is(Dialect::codesys) || tool_.direct_change) block_.tool_change = true;
  }
  if (block_.tool_change && tool_.pending.active) {
    change();
    if (word) edges_.compare_offset(*word, used_tool(tool_.current));
    if (is(Dialect::sinumerik) && !peek('D')) modal_.edge = 1;
  }
  if (!word) return true;
  // A second T beside M6 makes the next tool ready.
  for (const Word& next : block_.words)
    if (next.address == letter('T') && &next != word && !select(next)) return false;
  return true;
}

// "T1" and then "M6 T2": on machines whose T makes a tool ready, M6 brings T1, and T2 is the next.
bool ToolChanger::brings_waiting(const Word& word) {
  if (!block_.tool_change || !tool_.pending.active || tool_.pending.id == id_of(word)) return false;
  const bool behind = std::any_of(block_.words.begin(), block_.words.end(), [&](const Word& m) {
    return m.address == letter('M') && m.value == 6 && m.column < word.column;
  });
  if (!behind) return false;
  reporter_.once(
      Severity::warning, "tool-order",
      fmt::format("M6 {0} is read as the change to T{1}, which was called before, and {0} "
                  "as the call of the next: where it brings {0} at once, leave the call "
                  "of T{1} out",
                  text_of(word), tool_.pending.id),
      word, "tool-order");
  change();
  return true;
}

// "N3 G0 X1 Y1 T2", cuts, "M6", "T3": the first T made T2 ready, and only M6 brings it. True: an
// error was reported.
bool ToolChanger::brings_assumed() {
  const Word* word = peek('T');
  if (!tool_.assumed || (word && id_of(*word) != tool_.current)) return false;
  tool_.assumed = false;
  reporter_.add_at(Severity::error, "tool-unknown",
                   fmt::format("T{0} comes with an M6 only behind the first cuts: which tool is in "
                               "the spindle before it is not told: write T and its number, with "
                               "M6, before the first cut",
                               tool_.current),
                   tool_.place);
  return true;
}

bool ToolChanger::select(const Word& word) {
  if (!word.string && (word.value < 0 || word.value > 1e8))
    return error("value-range", "T is a whole number or a name", word);
  if (!word.string && word.value != std::floor(word.value) && !suffix(word)) return false;
  tool_.written = word.string ? -1 : word.value;
  tool_.pending.active = true;
  tool_.pending.id = id_of(word);
  tool_.pending.at = block_.motion_at(word.column);
  tool_.pending.beside_motion = peek('X') || peek('Y') || peek('Z');
  tool_.pending.leaves = leaves_tool(word);
  if (!tool_.pending.leaves) notes_.call(tool_.pending.id);
  return true;
}

void ToolChanger::end_block() {
  const bool calls = block_.words.size() == 1 && block_.words.front().address == letter('T');
  notes_.end_block(calls);
}

void ToolChanger::change() {
  if (tool_.chosen && tool_.current != tool_.pending.id) position_.new_tool = true;
  if (tool_.current != tool_.pending.id) tool_.below = tool_.assumed = false;
  tool_.current = tool_.pending.id;
  tool_.place = tool_.pending.at;
  tool_.pending.active = false;
  tool_.chosen = true;
  tool_.index = -1;
  tool_.failed = false;
  if (tool_.pending.leaves) return;
  const auto file = static_cast<std::size_t>(tool_.place.file);
  std::string place = fmt::format("line {}", tool_.place.line);
  if (file > 0) place += " of " + program_.files[file];
  notes_.change(tool_.current, place);
  tool_.shown = notes_.tool_of(tool_.current);
}

// "(T1 - SPOT DRILL)" and "N3 G0 X1 Y1 S900 M3 T2" without an M6 before: T1 may be in the spindle
// and T2 the next tool. H2 would say that T2 is in the spindle.
bool ToolChanger::next_is_pending() const {
  const std::string named = notes_.only();
  const bool is_measured = parse_number(tool_.pending.id) == modal_.length_number;
  return is(Dialect::fanuc) && !lathe() && tool_.pending.beside_motion && !named.empty() &&
         named != tool_.pending.id && !is_measured;
}

// Posts for machines without a tool changer (Grbl) name the tool only in a comment.
void ToolChanger::take_commented(const Word& where) {
  const std::string id = notes_.only();
  if (id.empty()) {
    notes_.adopt_nameless();
    return;
  }
  tool_.pending.id = id;
  tool_.pending.at = block_.motion_at(where.column);
  change();
}

// A cut, and no M6 has changed to the tool that T has named: it is taken to be in the spindle.
// False: another tool may be there, which is reported.
bool ToolChanger::assume_pending() {
  const auto fail = [&](const std::string& text) {
    tool_.failed = true;
    reporter_.add_at(Severity::error, "tool-unknown", text, tool_.pending.at);
    return false;
  };
  if (tool_.came_unnamed && !given(""))
    return fail(
        fmt::format("T{0} is called behind M6, and no T word before it: which tool is in the "
                    "spindle here is not told: write T and its number before that M6",
                    tool_.pending.id));
  if (next_is_pending())
    return fail(
        fmt::format("T{0} is called without M6, and the comment names T{1} alone: which of them is "
                    "in the spindle here is not told: write T and its number, with M6, before the "
                    "first cut",
                    tool_.pending.id, notes_.only()));
  reporter_.once_at(
      Severity::note, "tool-not-changed",
      fmt::format("T{} is used without M6: it is taken to be in the spindle", tool_.pending.id),
      tool_.pending.at, "m6");
  change();
  tool_.assumed = true;
  tool_.direct_change = true;  // and so are those after it, until an M6 comes
  return true;
}

void ToolChanger::require(const Word& where, bool cuts) {
  if (cuts) notes_.cut();
  if (notes_.has_news()) hear_news(where);
  if (tool_.index >= 0 || tool_.failed) return;
  if (!tool_.chosen && tool_.pending.active && cuts && !assume_pending()) return;
  if (!tool_.chosen && cuts && !given("")) take_commented(where);
  const std::string id = data_id();
  if (const auto known = used_.find(id); known != used_.end()) {
    tool_.index = known->second;
    return edges_.compare_edge(*current(), where);
  }
  Tool tool;
  std::string why;
  if (!tool_.chosen && !cuts) return;
  Severity said = Severity::note;
  if (!data_.resolve(id, tool, why, said)) {
    if (cuts) missing(where, why, tool);
    return;
  }
  tool.id = id;
  edges_.settle_tip(tool, where);
  use(std::move(tool));
  edges_.compare_edge(*current(), where);
  edges_.compare_nose(*current(), where);
  if (given(id)) return;
  const std::string text =
      fmt::format("tool {}: {} ({})", tool_.current.empty() ? "(none named)" : id,
                  tool_summary(*current()), current()->origin);
  if (tool_.chosen)
    reporter_.add_at(said, "tool-inferred", text, tool_.place);
  else
    reporter_.add(said, "tool-inferred", text, where);
}

// Reports that the tool has no data. `read`: what the comments say of it.
void ToolChanger::missing(const Word& where, const std::string& why, const Tool& read) {
  tool_.failed = true;
  if (!tool_.chosen) {
    const Severity severity = options_.require_tools ? Severity::error : Severity::warning;
    reporter_.add(severity, "tool-unknown",
                  fmt::format("the program names no tool{}: give one with --tool endmill:d=10, or "
                              "--tools",
                              why.empty() ? "" : ", and " + why),
                  where.column, where.length);
    return;
  }
  Tool unknown;  // so that traces can name it; the error prevents everything else
  unknown.id = tool_.shown;
  unknown.origin = "no data";
  use(std::move(unknown));
  const std::string comment = notes_.not_understood(tool_.current);
  const std::string none = comment.empty()
                               ? "there are no data for it"
                               : fmt::format("no tool is known in its comment \"{}\"", comment);
  std::string spec = fmt::format("{}={}", tool_.shown, tool_example(read, lathe()));
  if (tool_.shown.find(' ') != std::string::npos) spec = '"' + spec + '"';  // for the shell
  const ToolHint* hint = notes_.find(tool_.current);
  const std::string outline = hint ? outline_example(*hint, scale()) : std::string();
  const std::string remedy =
      read.type == ToolType::form
          ? fmt::format("give its profile (type = \"form\") with --tools tools.toml{}{}",
                        outline.empty() ? "" : ": ", outline)
          : fmt::format("give --tool {} or --tools tools.toml", spec);
  reporter_.add_at(
      Severity::error, "tool-unknown",
      fmt::format("tool {} cuts, but {}: {}", tool_.shown, why.empty() ? none : why, remedy),
      tool_.place);
}

bool ToolChanger::sized_in_inches() const {
  return std::any_of(program_.tools.begin(), program_.tools.end(), [&](const Tool& tool) {
    const ToolHint* hint = tool.origin.starts_with("comment") ? notes_.find(tool.id) : nullptr;
    return hint && mrsim::sized_in_inches(*hint);
  });
}

bool ToolChanger::only_touches(const Word& where) {
  if (!lathe() || !tool_.chosen || tool_.index >= 0 || given(tool_.current)) return false;
  const ToolHint* hint = notes_.find(tool_.current);
  if (!hint || hint->trade != ToolTrade::no_cutter || hint->rivals) return false;
  note_once("tool-touches",
            fmt::format("tool {} cuts nothing, as the comment \"{}\" says: its moves are not swept",
                        tool_.current, hint->text),
            where, tool_.current);
  return true;
}

const OffsetRegister* ToolChanger::find_register(const std::string& name) const {
  for (const OffsetRegister& reg : control_.registers)
    if (reg.name == name) return &reg;
  return nullptr;
}

// The cycle cuts, so a tool without M6 is in the spindle from here on.
double ToolChanger::radius_for(const std::string& cycle, int edge, const Word& where) {
  require(where, true);
  const double found = radius(edge);
  const bool told = tool_.failed && (tool_.chosen || options_.require_tools);
  if (found <= 0 && !told)
    reporter_.once(Severity::error, "tool-unknown",
                   fmt::format("{} needs the radius of {} (alarm 61000): give --tool or --tools",
                               cycle, tool_.current.empty() ? "its tool" : "tool " + tool_.current),
                   where, "cycle-radius:" + tool_.current);
  return found;
}

double ToolChanger::radius(int edge) {
  if (edge == 0) return 0;
  Word where;
  where.length = 1;
  require(where, false);
  const OffsetRegister* reg = nullptr;
  if (edge > 0) {
    reg = find_register(fmt::format("T{}.D{}", tool_.current, edge));
    if (!reg) reg = find_register(fmt::format("D{}", edge));
  }
  if (reg) return reg->radius + reg->wear;
  const Tool* tool = current();
  if (!tool) return 0;
  const double own = is_turning(tool->type) ? nose_radius(*tool) : tool->diameter / 2;
  return own + control_.bare_wear(fmt::format("D{}", edge));
}

CompRadius ToolChanger::commented_radius() const {
  const ToolHint* hint = notes_.find(tool_.current);
  if (!hint) return CompRadius::automatic;
  const std::string text = upper_case(hint->text);
  const bool wear = text.find("WEAR COMP") != std::string::npos;
  const bool control = text.find("CONTROL COMP") != std::string::npos;
  if (wear == control) return CompRadius::automatic;
  return wear ? CompRadius::wear : CompRadius::radius;
}

}  // namespace mrsim
