#include "interp/comments/tool_listing.h"

#include "core/numbers/units.h"
#include "core/text/text_io.h"
#include "core/words/tool_number.h"
#include "interp/comments/comment_tokens.h"
#include "interp/comments/tool_kind.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

std::vector<std::string_view> fields_of(std::string_view text, char separator) {
  std::vector<std::string_view> out;
  while (out.size() < 50) {
    const std::size_t end = text.find(separator);
    std::string_view field = text.substr(0, end);
    while (field.starts_with(' ')) field.remove_prefix(1);
    while (field.ends_with(' ')) field.remove_suffix(1);
    out.push_back(field);
    if (end == text.npos) break;
    text.remove_prefix(end + 1);
  }
  return out;
}

ToolLength length_of(std::string_view text) {
  for (const CommentToken& token : comment_tokens(text))
    if (token.is_number()) return {token.value, token.unit, token.fraction};
  return {};
}

void set_diameter(ToolHint& hint, const ToolLength& length) {
  if (length) hint.diameters.push_back(length);
}

bool read_key_values(std::string_view text, ToolHint& hint) {
  const std::size_t mark = text.find("@MKR|TOOL|");
  if (mark == text.npos) return false;
  hint.names_tool = true;
  for (const std::string_view field : fields_of(text.substr(mark), '|')) {
    const std::size_t equal = field.find('=');
    if (equal == field.npos) continue;
    const std::string_view key = field.substr(0, equal), value = field.substr(equal + 1);
    if (key == "NUMBER" || key == "ID") {
      hint.id = std::string(value);
    } else if (key == "TYPE") {
      const std::vector<ToolKind> kinds = find_tool_kinds(comment_tokens(value));
      if (!kinds.empty()) hint.type = kinds.front().type;
    } else if (key == "DIAMETER" || key == "DIA" || key == "D") {
      set_diameter(hint, length_of(value));
    } else if (key.find("CORNER") != key.npos) {
      hint.corner = length_of(value);
    } else if (key == "ANGLE" || key == "TIPANGLE" || key == "TIP_ANGLE") {
      hint.tip_angle = radians(std::clamp(length_of(value).value, 0.0, 179.0));
    }
  }
  if (hint.type == ToolType::endmill && hint.corner) hint.type = ToolType::bullmill;
  return true;
}

// Reads "TOOL/MILL, diameter, corner radius, height, taper" and "TOOL/DRILL, diameter, tip angle,
// height".
bool read_apt(std::string_view text, ToolHint& hint) {
  const std::size_t from = text.find_first_not_of(' ');
  if (from == text.npos || !text.substr(from).starts_with("TOOL/")) return false;
  const std::vector<std::string_view> fields = fields_of(text.substr(from + 5), ',');
  const auto value = [&](std::size_t i) {
    return i < fields.size() ? parse_number(fields[i]).value_or(0) : 0.0;
  };
  const bool mill = fields[0] == "MILL" || fields[0] == "CRAD";
  if ((!mill && fields[0] != "DRILL" && fields[0] != "CHAMFER") || !(value(1) > 0)) return false;
  hint.names_tool = true;
  set_diameter(hint, {value(1), 0, false});
  if (!mill) {
    hint.type = fields[0] == "DRILL" ? ToolType::drill : ToolType::chamfer;
    if (value(2) > 0 && value(2) < 180) hint.tip_angle = radians(value(2));
    if (hint.type == ToolType::chamfer && value(2) > 0 && value(2) <= 60)
      hint.doubt = fmt::format("gives {:g} degrees, of its side or of the whole", value(2));
    return true;
  }
  hint.type = value(2) > 0 ? ToolType::bullmill : ToolType::endmill;
  hint.corner = {std::max(value(2), 0.0), 0, false};
  if (value(4) > 0 && value(4) < 90) {
    hint.type = ToolType::taper;
    hint.taper_angle = radians(value(4));
    hint.flute_length = {std::max(value(3), 0.0), 0, false};
  } else if (value(4) != 0) {
    hint.doubt = "names a taper that is no angle of a mill";
  }
  return true;
}

// Reads CamBam's "T1 : 3.0".
bool read_number_and_size(std::string_view text, ToolHint& hint) {
  const std::vector<CommentToken> tokens = comment_tokens(text);
  if (tokens.size() != 4 || !tokens[0].is("T") || !tokens[1].is_number() || tokens[1].decimals ||
      tokens[1].text.size() > 8 || !tokens[2].is(":") || !tokens[3].is_number() ||
      !tokens[3].decimals || !(tokens[3].value > 0))
    return false;
  hint.names_tool = true;
  hint.id_digits = tokens[1].text.size();
  hint.id = without_leading_zeros(tokens[1].text);
  set_diameter(hint, {tokens[3].value, tokens[3].unit, tokens[3].fraction});
  return true;
}

// Reads F-Engrave's settings. Those of the V-bit describe the tool only where no other tool carves.
bool read_fengrave(std::string_view text, ToolHint& hint) {
  const std::size_t mark = text.find("FENGRAVE_SET ");
  if (mark == text.npos) return false;
  std::string_view value = text.substr(mark + 13);
  value.remove_prefix(std::min(value.size(), value.find_first_not_of(' ')));
  const std::string_view key = value.substr(0, value.find(' '));
  value.remove_prefix(key.size());
  value.remove_prefix(std::min(value.size(), value.find_first_not_of(' ')));
  while (value.ends_with(' ')) value.remove_suffix(1);
  if (key == "V_BIT_ANGLE") {
    hint.angle_line = true;
    hint.tip_angle = radians(std::clamp(length_of(value).value, 0.0, 179.0));
  } else if (key == "V_BIT_DIA") {
    hint.names_tool = true;
    hint.type = ToolType::chamfer;
    hint.trade = ToolTrade::vee;
    hint.doubt = "gives no angle";
    set_diameter(hint, length_of(value));
  } else if ((key == "BIT_SHAPE" && value != "VBIT") || (key == "CUT_TYPE" && value == "ENGRAVE")) {
    hint.names_tool = hint.settings = true;
    hint.doubt = "is of F-Engrave, whose settings tell the tool where a V-bit carves alone";
  }
  return true;
}

}  // namespace

bool read_listed_tool(std::string_view folded, ToolHint& hint) {
  return read_key_values(folded, hint) || read_apt(folded, hint) ||
         read_number_and_size(folded, hint) || read_fengrave(folded, hint);
}

}  // namespace mrsim
