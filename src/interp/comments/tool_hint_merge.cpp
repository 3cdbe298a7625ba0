// What several comments say of one tool, put together.
#include "interp/comments/tool_hint.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

void merge_kind(ToolHint& into, const ToolHint& more) {
  const bool plain = into.type == ToolType::endmill;  // "CR=2" makes a bull-nose mill of it
  // "TOOL NAME: MILL_D10", "DESCRIPTION: MILLING TOOL-BALL MILL".
  const bool kind_of_it = plain && !into.firm && more.type && more.firm && more.names_tool &&
                          more.diameters.empty() && !is_turning(*more.type);
  if (kind_of_it) into.trade = more.trade;
  if (!into.type || kind_of_it || (plain && more.type == ToolType::bullmill)) {
    into.type = more.type;
  } else if (more.type && *more.type != *into.type && into.doubt.empty() &&
             ((!more.diameters.empty() && !into.diameters.empty()) || (into.firm && more.firm)) &&
             !(*into.type == ToolType::bullmill && *more.type == ToolType::endmill)) {
    into.doubt = "name different kinds of tool";
  }
}

// The comments as one: 'A", "B' is "A, B".
std::string in_one_line(const ToolHint& hint, const ToolHint& line) {
  constexpr std::string_view kBetween = "\", \"";
  std::string text = hint.text;
  for (std::size_t at; (at = text.find(kBetween)) != text.npos;) text.replace(at, 4, ", ");
  return text + " " + line.text;
}

// "TAPER ANGLE: 5.", "ANGLE: 60": which angle of the tool that is, the kind says.
void merge_angle(ToolHint& into, const ToolHint& line) {
  if (line.tip_angle > 0) {  // F-Engrave's
    if (into.trade != ToolTrade::vee) return;
    into.tip_angle = line.tip_angle;
    return into.doubt.clear();
  }
  const ToolHint both = read_tool_comment(in_one_line(into, line));
  const bool other = into.insert_angle > 0 && both.insert_angle != into.insert_angle;
  if (both.type) into.type = both.type;
  into.tip_angle = both.tip_angle;
  into.taper_angle = both.taper_angle;
  into.assumed_angle = both.assumed_angle;
  into.insert_angle = both.insert_angle;
  into.lead_angle = both.lead_angle;
  if (into.doubt.empty() || !both.doubt.empty() || both.tip_angle + both.taper_angle > 0)
    into.doubt = both.doubt;
  if (other && into.doubt.empty()) into.doubt = "give two angles of the insert";
}

void take_size(ToolLength& into, const ToolLength& more) {
  if (more) into = more;
}

double about_mm(const ToolLength& length) {
  return length.value * (length.unit > 0 ? length.unit : length.fraction ? 25.4 : 1);
}

// One larger than half the diameter is the work's, and half the diameter is that of a ball.
bool may_be_corner(const ToolHint& tool, const ToolLength& corner) {
  if (tool.diameters.empty()) return true;
  const double half = about_mm(tool.diameters.front()) / 2, radius = about_mm(corner);
  return radius < half || (radius == half && tool.type != ToolType::ballmill);
}

// "D10. R1.", "TIP DIA 0.2" below the kind: read as if it stood behind it.
void merge_sizes(ToolHint& into, const ToolHint& line) {
  const ToolHint both = read_tool_comment(in_one_line(into, line));
  const std::vector<ToolLength>& told = into.diameters.empty() ? both.diameters : line.diameters;
  const bool plain = line.plain_radius && !(both.type && is_turning(*both.type));
  if (plain && !may_be_corner(into, both.corner)) return;
  if (plain && both.corner.value != into.corner.value && into.doubt.empty())
    into.doubt = fmt::format(
        "can be read as having a corner of {0:g} or as made for a radius of {0:g}: say CR {0:g}",
        both.corner.value);
  if (both.type) into.type = both.type;
  into.diameters.insert(into.diameters.end(), told.begin(), told.end());
  if (into.diameter == 0 && !told.empty()) into.diameter = told.front().value;
  take_size(into.corner, both.corner);
  take_size(into.nose, both.nose);
  take_size(into.tip, both.tip);
  take_size(into.width, both.width);
  take_size(into.flute_length, both.flute_length);
  if (into.doubt.empty()) into.doubt = both.doubt;
}

}  // namespace

void merge_hint(ToolHint& into, const ToolHint& more) {
  if (into.only_angle() && !more.only_angle()) {
    const ToolHint line = std::exchange(into, more);
    return merge_hint(into, line);
  }
  if (more.size_line && (into.type || into.diameter > 0)) {
    merge_sizes(into, more);
    into.text += "\", \"" + more.text;
    return;
  }
  if (into.id.empty()) {
    into.id = more.id;
    into.id_digits = more.id_digits;
  }
  into.names_tool |= more.names_tool;
  merge_kind(into, more);
  into.bare_size = into.diameters.empty() ? more.bare_size : into.bare_size && more.bare_size;
  into.diameters.insert(into.diameters.end(), more.diameters.begin(), more.diameters.end());
  if (into.diameter == 0) into.diameter = more.diameter;
  if (!into.corner) into.corner = more.corner;
  if (!into.nose) into.nose = more.nose;
  if (!into.width) into.width = more.width;
  if (!into.tip) into.tip = more.tip;
  if (!into.flute_length) into.flute_length = more.flute_length;
  if (into.taper_angle == 0) into.taper_angle = more.taper_angle;
  if (more.tip_angle > 0 && (into.tip_angle == 0 || into.assumed_angle)) {
    into.tip_angle = more.tip_angle;
    into.assumed_angle = more.assumed_angle;
  }
  const bool inserts = !into.insert.empty() && !more.insert.empty();
  if (inserts && into.insert_angle != more.insert_angle && into.doubt.empty())
    into.doubt = "name different inserts";
  if (into.insert.empty()) into.insert = more.insert;
  if (into.insert_angle == 0) into.insert_angle = more.insert_angle;
  if (into.lead_angle == 0) into.lead_angle = more.lead_angle;
  if (into.edge_length == 0) into.edge_length = more.edge_length;
  into.left_hand |= more.left_hand;
  into.rivals |= more.rivals || (into.trade && more.trade && *into.trade != *more.trade);
  into.inside |= more.inside;
  into.bores |= more.bores;
  into.face_groove |= more.face_groove;
  if (into.orientation == 0) into.orientation = more.orientation;
  if (into.blade_point == BladePoint::untold) into.blade_point = more.blade_point;
  if (!into.trade) into.trade = more.trade;
  if (into.gauge.empty()) into.gauge = more.gauge;
  if (into.doubt.empty()) into.doubt = more.doubt;
  if (more.only_angle() && !into.only_angle()) merge_angle(into, more);
  if (into.text.size() < 400) into.text += "\", \"" + more.text;
}

}  // namespace mrsim
