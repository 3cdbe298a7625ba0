// What a tool's data say besides its shape: its radius by the register or its own, and whether it
// cuts at all.
#include "interp/control/tool_changer.h"
#include "interp/text/characters.h"

#include <string>

#include <fmt/format.h>

namespace mrsim {

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
