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
    } else if (tool_.pending.active) {
      hints_.insert_or_assign(tool_.pending.id, hint);
    }
  }
}

bool Engine::apply_tool() {
  if (is(Dialect::codesys) && is_circular(current_motion()) &&
      (peek('I') || peek('J') || peek('K') || motion_code_))
    return true;  // the opening angle
  const Word* word = take('T');
  if (word || tool_change_) saved_tool_ = tool_;
  if (word) {
    if (!word->string &&
        (word->value < 0 || word->value != std::floor(word->value) || word->value > 1e8))
      return error("value-range", "T is a whole number or a name", *word);
    tool_.pending.active = true;
    tool_.pending.id = id_of(*word, lathe() && is(Dialect::fanuc));
    const Activation& top = stack_.back();
    tool_.pending.at.file = top.file;
    tool_.pending.at.line = block_.line_number;
    tool_.pending.at.column = word->column + 1;
    tool_.pending.at.call = top.call;
    if (has_loose_hint_ && !hints_.count(tool_.pending.id)) hints_[tool_.pending.id] = loose_hint_;
    if (tool_change_) tool_.direct_change = false;  // M6
    if (lathe() || is(Dialect::codesys) || tool_.direct_change) tool_change_ = true;
  }
  if (tool_change_ && tool_.pending.active) {
    change_tool();
    if (is(Dialect::sinumerik) && !peek('D')) modal_.edge = 1;
  }
  return true;
}

void Engine::change_tool() {
  tool_.current = tool_.pending.id;
  tool_.place = tool_.pending.at;
  tool_.pending.active = false;
  tool_.chosen = true;
  tool_.index = -1;
  tool_.failed = false;
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
  if (tool_.index >= 0 || tool_.failed) return;
  if (!tool_.chosen && tool_.pending.active && cuts) {
    reporter_.once_at(
        Severity::note, "tool-not-changed",
        fmt::format("T{} is used without M6: it is taken to be in the spindle", tool_.pending.id),
        tool_.pending.at, "m6");
    change_tool();
    tool_.direct_change = true;  // and so are those after it, until an M6 comes
  }
  for (std::size_t i = 0; i < program_.tools.size(); ++i)
    if (program_.tools[i].id == tool_.current) {
      tool_.index = static_cast<int>(i);
      return;
    }
  Tool tool;
  if (!tool_.chosen && !cuts) return;
  if (!resolve_tool(tool_.current, tool)) {
    if (cuts) tool_missing(where);
    return;
  }
  tool.id = tool_.current;
  program_.tools.push_back(tool);
  tool_.index = static_cast<int>(program_.tools.size()) - 1;
  if (find_tool(options_.table, tool_.current)) return;
  const std::string text =
      fmt::format("tool {}: {} ({})", tool_.current.empty() ? "(none named)" : tool_.current,
                  tool_summary(tool), tool.origin);
  if (tool_.chosen)
    reporter_.add_at(Severity::note, "tool-inferred", text, tool_.place);
  else
    reporter_.add(Severity::note, "tool-inferred", text, where);
}

void Engine::tool_missing(const Word& where) {
  tool_.failed = true;
  if (!tool_.chosen) {
    const Severity severity = options_.require_tools ? Severity::error : Severity::warning;
    reporter_.add(severity, "tool-unknown",
                  "the program names no tool: give one with --tool endmill:d=10, or --tools",
                  where.column, where.length);
    return;
  }
  Tool unknown;  // so that traces can name it; the error stops everything else
  unknown.id = tool_.current;
  unknown.origin = "no data";
  program_.tools.push_back(unknown);
  tool_.index = static_cast<int>(program_.tools.size()) - 1;
  const auto hint = hints_.find(tool_.current);
  const std::string known =
      hint == hints_.end() ? std::string("there are no data for it")
                           : fmt::format("the comment \"{}\" gives no diameter", hint->second.text);
  reporter_.add_at(
      Severity::error, "tool-unknown",
      fmt::format("tool {} cuts, but {}: give --tool {}=endmill:d=10 or --tools tools.toml",
                  tool_.current, known, tool_.current),
      tool_.place);
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
