#include "interp/comments/turning_hint.h"

#include "core/numbers/trig.h"
#include "core/words/tool_types.h"
#include "interp/comments/insert_code.h"
#include "interp/comments/tool_hint.h"

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kWidestBlade = 25;   // mm: a wider one is rather given in another unit
constexpr double kLargestRound = 16;  // mm: radius of a round insert, ISO 1832

// Whether the hint has neither the code nor the angle of an insert, so that the blade itself cuts.
bool insert_is_blade(const ToolHint& hint) { return hint.insert.empty() && hint.insert_angle == 0; }

// Whether the tool is a neutral tooth without a width: the lead of the thread gives its width.
bool is_thread_tooth(const Tool& tool) {
  return tool.type == ToolType::threading && tool.lead_angle == 0 && tool.edge_length == 0;
}

// Orientation of a blade whose point the comment gives; 0: the usual one.
int blade_tip(const ToolHint& hint) {
  switch (hint.blade_point) {
    case BladePoint::left:
      return hint.inside ? 2 : 3;
    case BladePoint::right:
      return hint.inside ? 1 : 4;
    case BladePoint::middle:
      return hint.inside ? 6 : 8;
    default:
      return hint.inside ? 2 : 0;
  }
}

const char* blade_point_name(const Tool& blade) {
  const int tip = tip_orientation(blade);
  return tip == 6 || tip == 8 ? "middle" : tip == 1 || tip == 4 ? "right corner" : "left corner";
}

}  // namespace

void fill_turning(const ToolHint& hint, double unit, Tool& out) {
  out.insert = hint.insert;
  out.insert_angle = hint.insert_angle;
  out.lead_angle = hint.lead_angle;
  out.edge_length = hint.edge_length;
  out.left_hand = hint.left_hand;
  if (hint.inside && out.type == ToolType::threading) out.tip = 6;
  if (out.type == ToolType::grooving) out.tip = blade_tip(hint);
  ToolLength round = hint.nose ? hint.nose : hint.corner;  // "TIP RADIUS: 0.4" in its own line
  if (round.unit == 0 && out.insert != "R") round.unit = usual_nose_unit(round.value);
  out.nose_radius = round ? round.mm(unit) : 0;
  out.width = hint.width ? hint.width.mm(unit) : 0;
  if (out.insert == "R" && out.edge_length == 0) out.edge_length = 2 * out.nose_radius;
  complete_turning_tool(out);
  const std::string insert =
      out.insert.empty()
          ? fmt::format("{:.4g} degree {}insert", degrees(out.insert_angle),
                        hint.insert_angle > 0 ? "" : "finishing ")
          : fmt::format("insert {} of {:.4g} degrees", out.insert, degrees(out.insert_angle));
  if (out.tip > 0 && is_inside_tool(out)) out.origin += ": for the inside";
  if (out.type == ToolType::grooving && insert_is_blade(hint)) {
    out.origin +=
        fmt::format(": blade {:.4g} mm wide, its {} programmed", out.width, blade_point_name(out));
    return;
  }
  const std::string nose = out.nose_radius > 0 ? fmt::format("nose radius {:.4g}", out.nose_radius)
                                               : std::string("sharp");
  if (is_thread_tooth(out)) {
    out.origin += fmt::format(": {}, as wide as its lead, {}", insert, nose);
    return;
  }
  const std::string edge = out.edge_length > 0
                               ? fmt::format("edge {:.4g} mm", out.edge_length)
                               : std::string("edge as its bore allows, 16 mm at most");
  out.origin +=
      fmt::format(": {}, lead angle {:.4g} degrees, {}, {}{}", insert, degrees(out.lead_angle),
                  edge, nose, out.left_hand ? ", left-hand" : "");
}

namespace {

// What a comment about a grooving tool leaves open; empty: nothing.
std::string doubt_of_blade(const ToolHint& hint, double unit, const Tool& out) {
  if (hint.face_groove)
    return "names a face groove, and does not say which corner of the blade is programmed";
  if (hint.blade_point == BladePoint::unclear)
    return "names a right side or corner, of the blade or of the groove: tip=4 says that the right "
           "corner of the blade is programmed, tip=3 the left one";
  if (!(out.width > 0)) return "gives no width of the blade";
  const bool thousandths = unit == 1 && hint.width.inch_style;  // ".118 WIDE"
  if (hint.width.unit == 0 && (thousandths || out.width > kWidestBlade))
    return fmt::format("gives the width {} of the blade without a unit, in a program in {}",
                       as_written(hint.width), unit > 1 ? "inches" : "mm");
  return "";
}

}  // namespace

std::string doubt_of_turning(const ToolHint& hint, double unit, const Tool& out) {
  // Controls count orientations in two ways, so another one than the usual is not taken over.
  const int usual = tip_orientation(out);
  if (hint.orientation > 0 && out.type != ToolType::threading && hint.orientation != usual)
    return fmt::format("says tip {0}, and {1} is usual here: tip={0} or tip={1} tells which counts",
                       hint.orientation, usual);
  if (out.insert == "R" && unit > 1 && hint.nose.unit == 0 && !hint.nose.fraction &&
      out.nose_radius > kLargestRound)
    return fmt::format(
        "gives the radius {} of its round insert without a unit, in a program in "
        "inches",
        as_written(hint.nose));
  return out.type == ToolType::grooving ? doubt_of_blade(hint, unit, out) : "";
}

void complete_turning_tool(Tool& tool) {
  const bool round = !tool.insert.empty() && tool.insert.front() == 'R';
  const bool thread = tool.type == ToolType::threading;  // neutral, 60 degrees
  if (tool.insert.empty() && tool.insert_angle == 0) tool.insert_angle = radians(thread ? 60 : 35);
  if (tool.lead_angle == 0 && !round && !thread) tool.lead_angle = radians(93);
  // The cuts show how large a tooth is, and how much room there is inside.
  if (tool.edge_length == 0 && !thread && !is_inside_tool(tool)) tool.edge_length = 16;
}

}  // namespace mrsim
