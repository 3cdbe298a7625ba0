#include "interp/comments/tool_comment.h"

#include "core/numbers/units.h"
#include "core/text/text_io.h"
#include "interp/comments/comment_tokens.h"
#include "interp/comments/tool_facts.h"
#include "interp/comments/tool_listing.h"
#include "interp/comments/tool_settle.h"
#include "interp/comments/turret_name.h"

#include <cmath>

namespace mrsim {

ToolHint read_tool_comment(std::string_view bytes) {
  ToolHint hint;
  if (bytes.size() > 400) bytes = bytes.substr(0, 400);
  hint.text = to_utf8(bytes);
  while (!hint.text.empty() && hint.text.front() == ' ') hint.text.erase(0, 1);
  while (!hint.text.empty() && hint.text.back() == ' ') hint.text.pop_back();
  std::string text = fold_comment(hint.text);
  spell_sides(text);
  if (!read_listed_tool(text, hint)) settle_tool(read_tool_facts(comment_tokens(text)), hint);
  hint.diameter = hint.diameters.empty() ? 0 : hint.diameters.front().value;
  hint.corner_radius = hint.corner.value;
  hint.nose_radius = hint.nose.value;
  return hint;
}

// The edges of inserts by the metric code are whole millimetres.
bool sized_in_inches(const ToolHint& hint) {
  if (hint.edge_length != std::floor(hint.edge_length)) return true;
  // Centre drills have such numbers in shops of either unit.
  if (hint.diameters.empty() || (hint.pilot && !hint.gauge.empty())) return false;
  const ToolLength& size = hint.diameters.front();
  return (size.fraction && size.unit != 1) || size.unit == kMmPerInch;
}

}  // namespace mrsim
