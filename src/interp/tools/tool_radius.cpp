// What a tool's data say besides its shape: its radius by the register or its own, and whether it
// cuts at all.
#include "interp/text/characters.h"
#include "interp/tools/tool_changer.h"

#include <cmath>
#include <string>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kSameNose = 0.01;  // mm: of radii in inches with three decimals

}  // namespace

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

// T0303 and T0313: a blade often has an offset for each of its corners, and which is which no
// program tells.
void ToolChanger::compare_offset(const Word& word) {
  const long number = static_cast<long>(word.value), offset = number % 100;
  if (!lathe() || !is(Dialect::fanuc) || word.string || number < 100 || number > 9999 ||
      offset == 0 || tool_.current == fmt::format("{}", number))
    return;
  const auto [at, first] = offsets_.emplace(tool_.current, offset);
  const auto known = used_.find(tool_.current);
  if (first || at->second == offset || known == used_.end()) return;
  const Tool& tool = program_.tools[static_cast<std::size_t>(known->second)];
  if (tool.type != ToolType::grooving) return;
  tell_second(text_of(word), fmt::format("{}", number), tool, word);
}

void ToolChanger::tell_second(const std::string& offset, const std::string& id, const Tool& tool,
                              const Word& where) {
  reporter_.once(
      Severity::warning, "second-offset",
      fmt::format("{0} is a second offset of blade {1}: its point is read as before. Where it is "
                  "the other corner, these cuts lie {2:g} mm beside: say so with --tool "
                  "{3}=grooving:w={2:g},tip=..",
                  offset, tool.id, tool.width, id),
      where, id);
}

// "3.D2" of a SINUMERIK lathe where the tool table has it: another edge, with a point of its own.
std::string ToolChanger::id_at_edge() const {
  if (!lathe() || !is(Dialect::sinumerik) || modal_.edge < 2) return tool_.current;
  std::string id = fmt::format("{}.D{}", tool_.current, modal_.edge);
  return given(id) ? id : tool_.current;
}

// D2 of a blade is often its right corner.
void ToolChanger::compare_edge(const Word& where) {
  const Tool& tool = program_.tools[static_cast<std::size_t>(tool_.index)];
  if (!lathe() || !is(Dialect::sinumerik) || modal_.edge < 1 || tool.type != ToolType::grooving ||
      tool.id != tool_.current)
    return;
  const auto [at, first] = offsets_.emplace(tool_.current, modal_.edge);
  if (first || at->second == modal_.edge) return;
  const std::string edge = fmt::format("D{}", modal_.edge);
  tell_second(edge, fmt::format("{}.{}", tool_.current, edge), tool, where);
}

// R of G10 P, whose offset is that of T0101.
void ToolChanger::compare_nose(const Tool& tool, const Word& where) {
  const auto told = control_.told_noses.find(static_cast<long>(tool_.written) % 100);
  if (told == control_.told_noses.end() || !is_turning(tool.type)) return;
  if (std::abs(told->second - tool.nose_radius) < kSameNose) return;
  reporter_.once(
      Severity::warning, "nose-differs",
      fmt::format("G10 gives tool {0} a nose radius of {1:.4g} mm, its data say {2:.4g}, which "
                  "cuts here: where {1:.4g} is right, say --tool {0}=turning:insert=..,r={1:.4g}",
                  tool.id, told->second, tool.nose_radius),
      where, tool.id);
}

const OffsetRegister* ToolChanger::find_register(const std::string& name) const {
  for (const OffsetRegister& reg : control_.registers)
    if (reg.name == name) return &reg;
  return nullptr;
}

double ToolChanger::radius_for(const std::string& cycle, int edge, const Word& where) {
  const double found = radius(edge);
  const bool told = tool_.failed && tool_.chosen;
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
  const double own = is_turning(tool->type) ? tool->nose_radius : tool->diameter / 2;
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
