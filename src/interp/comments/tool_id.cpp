#include "interp/comments/tool_id.h"

#include "core/words/tool_number.h"

#include <string>

namespace mrsim {
namespace {

// Makes the number at i the tool's, if it is whole and has neither a point nor a unit.
void set_id(CommentView& view, ToolFacts& facts, std::size_t i) {
  const CommentToken& t = view[i];
  if (!view.whole(i) || t.text.size() > 8) return;
  const std::string id(without_leading_zeros(t.text));
  view.take(i);
  facts.names_tool = true;
  facts.several_ids |= !facts.id.empty() && facts.id != id;
  facts.id = id;
  facts.id_digits = t.text.size();
}

// Whether the T at `t` is the temper of an alloy: "6061-T6", "7075 T651".
bool is_temper(const CommentView& view, std::size_t t) {
  const std::size_t alloy = t > 1 && view.is(t - 1, "-") ? t - 2 : t - 1;
  return t > 0 && view.has(alloy) && view[alloy].is_number() && view[alloy].text.size() == 4 &&
         !view[alloy].decimals;
}

bool begins_id(const CommentView& view, const ToolFacts& facts, std::size_t i) {
  for (const ToolKind& k : facts.kinds)
    if (i > k.first && i < k.end) return false;  // "GROOVING TOOL 3"
  if (i > 0 && view.is(i - 1, "BUTTON")) return false;
  if (is_word_for_tool(view, i)) return true;
  return i == 0 && view.is_one(i, {"NO", "NR"}) && view.is(i + 2, ":");
}

}  // namespace

bool is_word_for_tool(const CommentView& view, std::size_t i) {
  return view.is_one(i, {"TOOL", "WERKZEUG", "WKZ", "HERRAMIENTA", "ORODJE", "OUTIL", "UTENSILE",
                         "NARZEDZIE", "ALAT"});
}

// Reads "T12", "TOOL 12", "TOOL NO. 12", "TOOL -5-", "TOOL #1", "NO. 1:", "STATION 1" at the head,
// and "1 = End Mill {6 mm}" of Vectric.
void read_tool_id(CommentView& view, ToolFacts& facts) {
  if (facts.kind() && view.number(0) && view.is(1, "=")) set_id(view, facts, 0);
  if (facts.kind() && view.is(0, "TYPE") && view.is_one(1, {":", "="})) facts.names_tool = true;
  for (std::size_t i = 0; i < view.size(); ++i) {
    const bool inside = facts.insert && i >= facts.insert->first && i < facts.insert->end;
    if (view.is(i, "T") && !inside && view.number(i + 1) && view.glued(i + 1)) {
      if (!is_temper(view, i)) set_id(view, facts, i + 1);
      continue;
    }
    if (view.is_one(i, {"TC", "TOOL", "WERKZEUG", "HERRAMIENTA", "ORODJE"}))
      facts.names_tool = true;
    if (i == 0 && view.is(0, "CUTTER") && view.is(1, ":")) facts.names_tool = true;
    if (!begins_id(view, facts, i)) continue;
    std::size_t at = i + 1;
    while (view.is_one(at, {"NO", "NR", "NUMBER", "NUMMER", "#", "-", ":", "=", "T"})) ++at;
    const bool diameter = view.is_one(at + 1, {"DIA", "DIAM", "DIAMETER"}) &&
                          !view.is(at + 2, "OFF") &&
                          view.value_behind(at + 1) == CommentView::kNone;  // "TOOL 10 DIA"
    if (view.is_one(at + 1, {"PARAMETERS", "PARAMETER"})) continue;  // "MILLING TOOL-5 PARAMETERS"
    if (view.number(at) && !diameter)
      set_id(view, facts, at);
    else if (view.is_one(at, {"CHANGE", "PATH", "STEEL", "OFFSET", "COMP", "STICK", "MUST"}))
      facts.names_tool = false;
  }
  if (!facts.id.empty() || !view.is_one(0, {"STATION", "STA", "POT", "TL"})) return;
  std::size_t at = 1;  // "STATION 1 - 10MM EM", "TL2 8.5 DRILL"
  while (view.is_one(at, {"NO", "#", "-", ":", "="})) ++at;
  if (view.number(at)) set_id(view, facts, at);
}

}  // namespace mrsim
