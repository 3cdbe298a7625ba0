#include "interp/tools/tool_data.h"

#include "core/text/text_io.h"
#include "interp/comments/tool_hint.h"
#include "interp/comments/turning_hint.h"
#include "interp/comments/turret_name.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

// Whether the comment describes a round end, "R5 BUTTON", "ROUND 8MM", "FULL RADIUS R2", "RDMT 10":
// the tool is no sharp insert of 35 degrees.
bool tells_round_end(std::string_view comment) {
  if (std::none_of(comment.begin(), comment.end(), is_digit)) return false;
  const std::string text = upper_case(comment);
  for (const std::string_view word : {"BUTTON", "ROUND ", "FULL RADIUS", "RDMT", "RCMT", "RPMT"})
    if (text.find(word) != text.npos) return true;
  return false;
}

// Whether the comment has one number, of a few mm, such as "LAMA 3MM".
bool tells_blade_width(std::string_view comment) {
  constexpr double kThinnest = 1, kWidest = 6;  // mm
  const std::size_t first = comment.find_first_of("0123456789");
  if (first == comment.npos) return false;
  const std::size_t end = std::min(comment.find_first_not_of("0123456789.", first), comment.size());
  const std::optional<double> width = parse_number(comment.substr(first, end - first));
  std::string_view unit = comment.substr(end);
  while (unit.starts_with(' ')) unit.remove_prefix(1);
  const bool mm = unit.starts_with("MM") || unit.starts_with("mm");
  return mm && width && *width >= kThinnest && *width <= kWidest &&
         std::none_of(unit.begin(), unit.end(), is_digit);
}

// Whether the comment names a kind without a size, as "DRILL ALL HOLES" above T="DRILL_8".
bool lacks_size(const ToolHint& comment) {
  return comment.type && !is_turning(*comment.type) && comment.diameters.empty() &&
         comment.doubt.empty();
}

// Whether the name may add to the comment: what a comment calls an end mill may have a corner by
// its name, "MILL_D20R2".
bool is_kind_of(const ToolHint& name, const ToolHint& comment) {
  if (!name.type) return false;
  const bool corner = name.type == ToolType::bullmill && comment.type == ToolType::endmill;
  return corner || name.type == comment.type;
}

}  // namespace

ToolData::ToolData(Control& control, const ToolNotes& notes) : ControlPart(control), notes_(notes) {
  const std::vector<Tool>& tools = options_.table.tools;
  for (std::size_t i = 0; i < tools.size(); ++i) given_.emplace(tools[i].id, i);
}

const Tool* ToolData::given(const std::string& id) const {
  const auto at = given_.find(id);
  return at == given_.end() ? nullptr : &options_.table.tools[at->second];
}

// ".250 BALL EM" where no G word says inches: the program may be from a shop whose control starts
// in inches.
bool ToolData::of_unknown_unit(const ToolHint& hint) const {
  constexpr double kSmall = 1;  // a size that is rare in mm and usual in inches
  if (modal_.units_given || is(Dialect::sinumerik) || is(Dialect::codesys)) return false;
  if (hint.diameters.empty() || hint.diameter >= kSmall) return false;
  return hint.diameters.front().unit == 0 && !hint.diameters.front().fraction;
}

// Whether the comment only repeats the name, as '; T="ROUGHER_80" D1'.
bool ToolData::repeats_name(const std::string& comment, const std::string& id) const {
  const std::size_t at = comment.find(id);
  if (!lathe() || at == comment.npos || id.find_first_not_of("0123456789") == id.npos) return false;
  const std::string rest = comment.substr(0, at) + comment.substr(at + id.size());
  return std::count_if(rest.begin(), rest.end(), is_digit) <= 1;
}

// Finds the data of a tool in its comments, else in its name. False and a reason where they do not
// suffice; no reason: nothing is said of it. `said`: a warning where the shape is incomplete.
bool ToolData::infer(const std::string& id, Tool& out, std::string& why, Severity& said) const {
  const ToolHint* said_of_it = notes_.find(id);
  if (const ToolHint* hint = said_of_it) {
    if (hint->plain_teeth() || hint->may_be_another()) said = Severity::warning;
    if (fill_tool(*hint, scale(), lathe(), out, why)) {
      // "#7 DRILL" beside T7, unless another comment has that size, too.
      const bool number = !id.empty() && hint->gauge == id && hint->diameters.size() < 2;
      if (!number && !of_unknown_unit(*hint)) return true;
      why = number ? fmt::format("names drill {0}, or tool {0}", id)
                   : fmt::format(
                         "gives the diameter {:g} without a unit, in a program without G20 "
                         "and G21",
                         hint->diameter);
    }
    why = fmt::format("the comment \"{}\" {}", hint->text, why);
    if (!repeats_name(hint->text, id) && !lacks_size(*hint)) return false;
  }
  std::string name =
      with_points(id);  // "ENDMILL_D10"; "PLUNGE_CUTTER_3" of a lathe is a tool, not its work
  std::replace(name.begin(), name.end(), '_', ' ');
  if (lathe()) name = spelled_turret_name(with_points(id));
  if (!lathe() && name.starts_with("CUTTER"))
    name.replace(0, 6, "END MILL");  // CUTTER of ShopMill is an end mill
  ToolHint hint = read_tool_comment(name);
  if (lathe() && !hint.type && hint.inside) hint.type = ToolType::boring;  // "ID_ROUGH"
  hint.text = id;
  std::string ignored;
  if (said_of_it && lacks_size(*said_of_it) && !is_kind_of(hint, *said_of_it)) return false;
  if (!hint.type || !fill_tool(hint, scale(), lathe(), out, ignored)) {
    const bool asks = hint.type == ToolType::grooving || hint.insert == "R" || hint.padded_radius;
    if (why.empty() && hint.type && asks)  // the name is not that of a turning insert
      why = fmt::format("its name \"{}\" {}", id, ignored);
    return false;
  }
  why.clear();
  if (hint.plain_teeth() || hint.may_be_another()) said = Severity::warning;
  out.origin.replace(0, out.origin.find(' '), "its name");
  return true;
}

bool ToolData::resolve(const std::string& id, Tool& out, std::string& why, Severity& said) const {
  if (const Tool* known = given(id)) {
    out = *known;
    return true;
  }
  if (infer(id, out, why, said)) return true;
  if (const Tool* any = given("")) {
    out = *any;
    out.origin = fmt::format("{}, given for the program as a whole", any->origin);
    return true;
  }
  if (!lathe() || !why.empty()) return false;
  out = {};
  if (const std::string comment = notes_.not_understood(id); tells_blade_width(comment)) {
    out.type = ToolType::grooving;
    why = fmt::format("the comment \"{}\" tells a width as blades have, and no kind of tool",
                      comment);
    return false;
  }
  out.type = ToolType::turning;
  if (const std::string comment = notes_.not_understood(id); tells_round_end(comment)) {
    out.insert = "R";
    why = fmt::format("the comment \"{}\" tells of a round tool, and not its insert", comment);
    return false;
  }
  out.origin = fmt::format(
      "{} a sharp 35 degree finishing insert, lead angle 93 degrees, edge 16 mm", kNoToolData);
  complete_turning_tool(out);
  return true;
}

}  // namespace mrsim
