// Tools: T words and names, what comments say, registers.
#include "core/text_io.h"
#include "core/units.h"
#include "interp/engine.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

std::string id_of(const Word& word, bool lathe_offsets) {
  if (word.string) return to_utf8(word.text.substr(0, 80));
  long number = static_cast<long>(word.value);
  if (lathe_offsets && number > 99) number /= 100;  // T0102: tool 1, offset 2
  return fmt::format("{}", number);
}

const Tool* find_tool(const ToolTable& table, const std::string& id) {
  for (const Tool& tool : table.tools)
    if (tool.id == id) return &tool;
  return nullptr;
}

}  // namespace

// Comments before the words of their block: a hint may be for the T in it.
void Engine::read_comments() {
  const Word* t = peek('T');
  for (const std::string_view comment : block_.comments) {
    ToolHint hint = read_tool_comment(comment);
    if (!hint) continue;
    if (!hint.id.empty()) {
      hints_.insert_or_assign(hint.id, hint);
    } else if (t) {
      hints_.insert_or_assign(id_of(*t, lathe() && is(Dialect::fanuc)), hint);
    } else if (block_.words.empty()) {
      loose_hint_ = hint;
      has_loose_hint_ = true;
    } else if (pending_tool_.active) {
      hints_.insert_or_assign(pending_tool_.id, hint);
    }
  }
}

bool Engine::apply_tool() {
  if (is(Dialect::codesys) && is_circular(current_motion()) &&
      (peek('I') || peek('J') || peek('K') || motion_code_))
    return true;  // the opening angle
  if (const Word* word = take('T')) {
    if (!word->string &&
        (word->value < 0 || word->value != std::floor(word->value) || word->value > 1e8))
      return error("value-range", "T is a whole number or a name", *word);
    pending_tool_.active = true;
    pending_tool_.id = id_of(*word, lathe() && is(Dialect::fanuc));
    const Activation& top = stack_.back();
    pending_tool_.at.file = top.file;
    pending_tool_.at.line = block_.line_number;
    pending_tool_.at.column = word->column + 1;
    pending_tool_.at.call = top.call;
    if (has_loose_hint_ && !hints_.count(pending_tool_.id)) hints_[pending_tool_.id] = loose_hint_;
    if (tool_change_) direct_change_ = false;  // M6
    if (lathe() || is(Dialect::codesys) || direct_change_) tool_change_ = true;
  }
  if (tool_change_ && pending_tool_.active) {
    change_tool();
    if (is(Dialect::sinumerik) && !peek('D')) modal_.edge = 1;
  }
  return true;
}

void Engine::change_tool() {
  current_tool_ = pending_tool_.id;
  current_tool_place_ = pending_tool_.at;
  pending_tool_.active = false;
  tool_chosen_ = true;
  tool_index_ = -1;
  tool_failed_ = false;
}

// The data of a tool, and where they came from. False when there are none.
bool Engine::resolve_tool(const std::string& id, Tool& out) const {
  if (const Tool* known = find_tool(options_.table, id)) {
    out = *known;
    return true;
  }
  const auto at = hints_.find(id);
  const bool hinted = at != hints_.end();
  if (hinted && at->second.type && (at->second.diameter > 0 || is_turning(*at->second.type))) {
    fill_from_hint(at->second, out);
    return true;
  }
  if (const Tool* any = find_tool(options_.table, "")) {
    out = *any;
    out.origin = fmt::format("{}, given for the program as a whole", any->origin);
    return true;
  }
  if (hinted && at->second.diameter > 0 && !lathe()) {
    fill_from_hint(at->second, out);
    return true;
  }
  if (!lathe()) return false;
  out.type = ToolType::turning;
  out.origin = "no data: a sharp 35 degree finishing insert, lead angle 93 degrees, edge 16 mm";
  complete_turning_tool(out);
  return true;
}

void Engine::fill_from_hint(const ToolHint& hint, Tool& out) const {
  const double unit = scale();
  out.type = hint.type.value_or(ToolType::endmill);
  out.diameter = hint.diameter * unit;
  out.corner_radius = hint.corner_radius * unit;
  out.taper_angle = hint.taper_angle;
  out.nose_radius = hint.nose_radius * unit;
  out.origin = fmt::format("comment \"{}\"", hint.text);
  if (!hint.type) out.origin += ", taken to be an end mill";
  if (!is_turning(out.type)) return;
  complete_turning_tool(out);
  out.origin += fmt::format(": 35 degree finishing insert, lead angle 93 degrees, edge 16 mm, {}",
                            out.nose_radius > 0 ? fmt::format("nose radius {:g}", out.nose_radius)
                                                : std::string("sharp"));
}

// Gives the tool in the spindle an entry in Program::tools. A tool without data is a fault only
// when it cuts.
void Engine::require_tool(const Word& where, bool cuts) {
  if (tool_index_ >= 0 || tool_failed_) return;
  if (!tool_chosen_ && pending_tool_.active && cuts) {
    reporter_.once_at(
        Severity::note, "tool-not-changed",
        fmt::format("T{} is used without M6: it is taken to be in the spindle", pending_tool_.id),
        pending_tool_.at, "m6");
    change_tool();
    direct_change_ = true;  // and so are those after it, until an M6 comes
  }
  for (std::size_t i = 0; i < program_.tools.size(); ++i)
    if (program_.tools[i].id == current_tool_) {
      tool_index_ = static_cast<int>(i);
      return;
    }
  Tool tool;
  if (!tool_chosen_ && !cuts) return;
  if (!resolve_tool(current_tool_, tool)) {
    if (cuts) tool_missing(where);
    return;
  }
  tool.id = current_tool_;
  program_.tools.push_back(tool);
  tool_index_ = static_cast<int>(program_.tools.size()) - 1;
  if (find_tool(options_.table, current_tool_)) return;
  const std::string text =
      fmt::format("tool {}: {} ({})", current_tool_.empty() ? "(none named)" : current_tool_,
                  tool_summary(tool), tool.origin);
  if (tool_chosen_)
    reporter_.add_at(Severity::note, "tool-inferred", text, current_tool_place_);
  else
    reporter_.add(Severity::note, "tool-inferred", text, where);
}

void Engine::tool_missing(const Word& where) {
  tool_failed_ = true;
  if (!tool_chosen_) {
    const Severity severity = options_.require_tools ? Severity::error : Severity::warning;
    reporter_.add(severity, "tool-unknown",
                  "the program names no tool: give one with --tool endmill:d=10, or --tools",
                  where.column, where.length);
    return;
  }
  Tool unknown;  // so that traces can name it; the error stops everything else
  unknown.id = current_tool_;
  unknown.origin = "no data";
  program_.tools.push_back(unknown);
  tool_index_ = static_cast<int>(program_.tools.size()) - 1;
  const auto hint = hints_.find(current_tool_);
  const std::string known =
      hint == hints_.end() ? std::string("there are no data for it")
                           : fmt::format("the comment \"{}\" gives no diameter", hint->second.text);
  reporter_.add_at(
      Severity::error, "tool-unknown",
      fmt::format("tool {} cuts, but {}: give --tool {}=endmill:d=10 or --tools tools.toml",
                  current_tool_, known, current_tool_),
      current_tool_place_);
}

const OffsetRegister* Engine::find_register(const std::string& name) const {
  for (const OffsetRegister& reg : options_.table.offsets)
    if (reg.name == name) return &reg;
  return nullptr;
}

std::string tool_summary(const Tool& tool) {
  static constexpr const char* kNames[] = {
      "end mill",     "ball mill",     "bull-nose mill", "chamfer mill",  "tapered mill",
      "drill",        "T-slot mill",   "lollipop mill",  "barrel mill",   "form mill",
      "turning tool", "grooving tool", "boring bar",     "threading tool"};
  std::string text = kNames[static_cast<std::size_t>(tool.type)];
  if (tool.diameter > 0) text += fmt::format(" {:g} mm", tool.diameter);
  if (tool.corner_radius > 0) text += fmt::format(", corner radius {:g} mm", tool.corner_radius);
  return text;
}

}  // namespace mrsim
