// Puts together what several comments say of one tool.
#include "core/numbers/rounding.h"
#include "core/numbers/units.h"
#include "interp/comments/comment_tokens.h"
#include "interp/comments/insert_code.h"
#include "interp/comments/tool_hint.h"
#include "interp/comments/tool_sizes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

// Words about the work that may stand beside the shape that a cutter leaves.
constexpr std::string_view kWork[] = {
    "DOVETAIL", "DOVETAILS", "DOVE",     "TAIL",      "T",         "TSLOT",  "TEE",     "SLOT",
    "SLOTS",    "ROUND",     "OVER",     "ROUNDOVER", "ROUNDING",  "CORNER", "CORNERS", "EDGE",
    "EDGES",    "ROUGH",     "ROUGHING", "FINISH",    "FINISHING", "SEMI",   "PRE",     "CUT",
    "CUTS",     "PASS",      "OP",       "GROOVE",    "TOP",       "BOTTOM", "SIDE",    "SIDES",
    "LEFT",     "RIGHT",     "FRONT",    "BACK",      "OUTSIDE",   "INSIDE", "UPPER",   "LOWER",
    "THE",      "FOR",       "OF",       "IN",        "ON",        "WALL",   "WALLS",   "FLOOR",
    "CENTER",   "CENTRE",    "OPEN",     "MACHINE",   "MACHINING", "CLEAR",  "KEYSEAT"};

// A comment about the work has at least one of these: "T-SLOT", "CORNER ROUNDING" alone are names
// of cutters, too.
constexpr std::string_view kSurelyWork[] = {"ROUGH", "ROUGHING", "FINISH",   "FINISHING", "PASS",
                                            "OP",    "SIDES",    "EDGES",    "CORNERS",   "WALLS",
                                            "FLOOR", "MACHINE",  "MACHINING"};

bool has_form(const ToolHint& tool) {
  using enum ToolTrade;
  return tool.trade == dovetail || tool.trade == rounding || tool.trade == disc;
}

bool is_slot(std::string_view word) { return word == "SLOT" || word == "SLOTS"; }

// Whether the line may be about the work: "ROUGH T-SLOT", "DOVETAIL SLOT". It has no word and no
// size of a cutter, and stands at no change of tools.
bool may_be_work(const ToolHint& line) {
  if (!has_form(line) || line.names_tool || !line.id.empty() || !line.diameters.empty() ||
      line.width || line.corner || line.at_call)
    return false;
  const std::string folded = fold_comment(line.text);
  bool sure = false;
  std::string_view before;
  for (const CommentToken& token : comment_tokens(folded)) {
    if (token.kind == CommentToken::Kind::sign) continue;
    if (std::ranges::find(kWork, token.text) == std::end(kWork)) return false;
    const bool dovetail = before.starts_with("DOVETAIL") || before == "TAIL";
    sure = sure || (dovetail && is_slot(token.text)) ||
           std::ranges::find(kSurelyWork, token.text) != std::end(kSurelyWork);
    before = token.text;
  }
  return sure;
}

void pass_work(ToolHint& tool, const ToolHint& line) {
  constexpr std::size_t kMost = 400;
  tool.rounds_edges |= line.trade == ToolTrade::rounding;
  if (tool.work.size() < kMost) tool.work += (tool.work.empty() ? "" : "\", \"") + line.text;
}

// Whether the comment names a kind of tool and its size.
bool is_sized_tool(const ToolHint& tool) {
  return tool.type && !tool.diameters.empty() && tool.doubt.empty() && !tool.upkeep;
}

// Whether the size of another line may be the work's: "T1 BORE D30" beside "T1 10MM ENDMILL".
bool is_size_of_work(const ToolHint& line) {
  return line.size_of_work && !line.type && !line.diameters.empty() && line.doubt.empty() &&
         !line.at_call;
}

// Whether the tool is a plain mill, "10MM END MILL", which may cut the work of another line: slots
// and edges of any form.
bool is_plain_mill(const ToolHint& tool) {
  return tool.firm && tool.trade == ToolTrade::mill && !tool.diameters.empty() &&
         (tool.type == ToolType::endmill || tool.type == ToolType::bullmill ||
          tool.type == ToolType::ballmill);
}

void merge_kind(ToolHint& into, const ToolHint& more) {
  const bool plain = into.type == ToolType::endmill;  // "CR=2" makes a bull-nose mill of it
  // The second comment gives the kind of a mill that the first one only calls a mill: "TOOL NAME:
  // MILL_D10", "DESCRIPTION: MILLING TOOL-BALL MILL"; "MILL D25", "T-SLOT CUTTER".
  const bool kind_of_it = plain && !into.firm && more.type && !is_turning(*more.type) &&
                          more.diameters.empty() &&
                          ((more.firm && more.names_tool) || has_form(more));
  if (kind_of_it) into.trade = more.trade;
  if (!into.type || kind_of_it || (plain && more.type == ToolType::bullmill)) {
    into.type = more.type;
  } else if (more.type && *more.type != *into.type && into.doubt.empty() &&
             ((!more.diameters.empty() && !into.diameters.empty()) ||
              (more.firm && (into.firm || !plain))) &&
             !(*into.type == ToolType::bullmill && *more.type == ToolType::endmill)) {
    into.doubt = "name different kinds of tool";
  }
  // "DRILL 8.5MM" has 118 degrees, "SPOT DRILL HOLES" 90: they contradict each other.
  const bool angle_told = into.tip_angle > 0 && !into.assumed_angle;
  if (into.type == ToolType::drill && more.type == into.type && more.assumed_angle && !angle_told &&
      into.trade && more.trade != into.trade && into.doubt.empty())
    into.doubt = "name different kinds of tool";
}

// The texts of both as one comment: 'A", "B' becomes "A, B".
std::string in_one_line(const ToolHint& hint, const ToolHint& line) {
  constexpr std::string_view kBetween = "\", \"";
  std::string text = hint.text;
  for (std::size_t at; (at = text.find(kBetween)) != text.npos;) text.replace(at, 4, ", ");
  return text + " " + line.text;
}

// The angle between the cone's side and its axis, radians.
double half_angle(const ToolHint& tool) {
  return tool.taper_angle > 0 ? tool.taper_angle : tool.tip_angle / 2;
}

// The same where the comment says it, and it is not that of the kind; else 0.
double told_angle(const ToolHint& tool) { return tool.assumed_angle ? 0 : half_angle(tool); }

// Whether the angle is that of a drill's point, "TIP ANGLE: 130", "118 DEG", and not that of a
// slope which the drill makes.
bool may_be_point(const ToolHint& into, const ToolHint& line, const ToolHint& both) {
  constexpr double kSharpest = 60;
  const double angle = degrees(both.tip_angle), whole = std::round(angle);
  return (std::abs(angle - whole) < kRounding &&
          is_usual_angle(into.trade.value_or(*both.trade), whole)) ||
         (line.own_angle && angle >= kSharpest);
}

std::string doubt_of_angle(const ToolHint& into, const ToolHint& line, const ToolHint& both) {
  if (into.insert_angle > 0 && both.insert_angle != into.insert_angle)
    return "give two angles of the insert";
  const bool told = into.taper_angle > 0 || (into.tip_angle > 0 && !into.assumed_angle);
  if (told && std::abs(half_angle(both) - half_angle(into)) > kTurnRounding)
    return "give two angles of the tool";
  if (both.type == ToolType::drill && both.trade && !both.assumed_angle &&
      both.tip_angle != into.tip_angle && !may_be_point(into, line, both))
    return fmt::format(
        "can be read as having a point of {0:g} degrees or as made for such a slope: say TIP ANGLE "
        "{0:g}",
        degrees(both.tip_angle));
  return "";
}

// Adds an angle from a line of its own, "TAPER ANGLE: 5.", "ANGLE: 60". The kind says which angle
// of the tool it is.
void merge_angle(ToolHint& into, const ToolHint& line) {
  if (line.tip_angle > 0) {  // F-Engrave's
    if (into.trade != ToolTrade::vee) return;
    into.tip_angle = line.tip_angle;
    return into.doubt.clear();
  }
  if (!into.insert.empty() && !line.own_angle) return;  // it has its own; "3 DEG TAPER"
  const ToolHint both = read_tool_comment(in_one_line(into, line));
  const std::string doubt = doubt_of_angle(into, line, both);
  if (both.type) into.type = both.type;
  into.tip_angle = both.tip_angle;
  into.taper_angle = both.taper_angle;
  into.assumed_angle = both.assumed_angle;
  into.insert_angle = both.insert_angle;
  into.lead_angle = both.lead_angle;
  if (into.doubt.empty() || !both.doubt.empty() || both.tip_angle + both.taper_angle > 0)
    into.doubt = both.doubt;
  if (into.doubt.empty()) into.doubt = doubt;
}

// Without the program's unit; both of two sizes that are compared are taken to be in mm then.
double about_mm(const ToolLength& length) { return length.mm(1); }

// Keeps two sizes that may contradict each other.
void add_pair(ToolHint& into, const char* what, const ToolLength& first, const ToolLength& second) {
  constexpr std::size_t kMost = 8;
  const bool equal = first.value == second.value && first.unit == second.unit;
  if (!equal && into.pairs.size() < kMost) into.pairs.push_back({what, first, second});
}

// Whether the words tell of a tool. "GROOVE 3MM", "FINISH R0.4" name the work, perhaps.
bool tells_tool(const ToolHint& hint) {
  return hint.firm || !hint.insert.empty() || hint.insert_angle > 0;
}

// Adds a size of another comment; where both have it, the program's unit tells whether they agree.
// A size beside words for the work does not contradict that of a lathe's tool.
void add_size_of(ToolHint& into, ToolLength ToolHint::*size, const char* what,
                 const ToolHint& more) {
  const bool turns = into.type && is_turning(*into.type);
  const bool of_work = turns && tells_tool(into) && !tells_tool(more);
  if (into.*size && more.*size && !of_work) add_pair(into, what, into.*size, more.*size);
  if (!(into.*size)) into.*size = more.*size;
}

// "T1 D=10. CR=0. - FLAT END MILL" and "CR=0.5 - BULLNOSE END MILL" are two tools.
void compare_corners(ToolHint& into, const ToolHint& more) {
  const auto square = [](const ToolHint& tool) { return tool.square && !tool.corner; };
  const auto round = [](const ToolHint& tool) {
    return bool(tool.corner) && tool.type != ToolType::ballmill;
  };
  if (!into.doubt.empty()) return;
  if (square(into) && round(more))
    into.doubt = fmt::format("give the corner radius 0 and {:g}", more.corner.value);
  else if (round(into) && square(more))
    into.doubt = fmt::format("give the corner radius {:g} and 0", into.corner.value);
}

// Takes a size over; if both have it, they must agree.
void take_size(ToolHint& into, ToolLength ToolHint::*size, const char* what, const ToolHint& both) {
  if (!(both.*size)) return;
  if (into.*size) add_pair(into, what, into.*size, both.*size);
  into.*size = both.*size;
}

bool makes_holes(const ToolHint& tool) {
  return tool.type == ToolType::drill || tool.trade == ToolTrade::tap ||
         tool.trade == ToolTrade::hole;
}

// Whether the radius can be the tool's corner. One larger than half the diameter is the work's;
// half the diameter is that of a ball.
bool may_be_corner(const ToolHint& tool, const ToolLength& corner) {
  if (tool.diameters.empty()) return true;
  const double half = about_mm(tool.diameters.front()) / 2, radius = about_mm(corner);
  return radius < half || (radius == half && tool.type != ToolType::ballmill);
}

// Whether a radius in a line of its own is one of the tool's. Where it only may be, a doubt is set.
bool counts(ToolHint& into, const ToolHint& line, const ToolHint& both) {
  const bool turns = into.type && is_turning(*into.type);
  if (line.tool_radius && !into.diameters.empty() &&
      std::abs(about_mm(into.diameters.front()) / 2 - about_mm(both.corner)) < kRounding)
    return false;
  const bool pointed = bool(into.tip) && !into.corner;  // "CHAMFER MILL 90 DEG TIP 0.2"
  const bool square = into.square && !into.corner && line.at_call && !into.at_call;
  if ((pointed || square) && both.corner && !line.plain_radius && into.doubt.empty())
    into.doubt = fmt::format(
        "can be read as having a corner of {0:g}, or none and as made for a radius of {0:g}",
        both.corner.value);
  if (!line.plain_radius) return true;
  const ToolLength& radius = both.corner ? both.corner : both.nose;
  const bool told = into.corner || into.nose;
  if (turns) return !told && usual_nose_unit(radius.value) > 0;
  if (told || makes_holes(into) || !may_be_corner(into, radius)) return false;
  if (radius && into.doubt.empty())
    into.doubt = fmt::format(
        "can be read as having a corner of {0:g} or as made for a radius of {0:g}: say CR {0:g}",
        radius.value);
  return true;
}

// Adds sizes from a line below the kind, "D10. R1.", "TIP DIA 0.2", read as if they stood behind
// it.
void merge_sizes(ToolHint& into, const ToolHint& line) {
  const ToolHint both = read_tool_comment(in_one_line(into, line));
  const bool turns = into.type && is_turning(*into.type);
  if (turns && !(both.type && is_turning(*both.type))) return;  // "BALL R10" is turned
  if (!counts(into, line, both)) return;
  const std::vector<ToolLength>& told = into.diameters.empty() ? both.diameters : line.diameters;
  const bool other = into.type && into.type != both.type && both.type == ToolType::ballmill;
  if (other && (into.firm || into.type != ToolType::endmill) && into.doubt.empty())
    into.doubt = "name different kinds of tool";
  if (both.type) into.type = both.type;
  into.diameters.insert(into.diameters.end(), told.begin(), told.end());
  if (into.diameter == 0 && !told.empty()) into.diameter = told.front().value;
  take_size(into, &ToolHint::corner, "corner radius", both);
  take_size(into, &ToolHint::nose, "nose radius", both);
  take_size(into, &ToolHint::tip, "tip", both);
  if (!turns || line.width || !into.width) take_size(into, &ToolHint::width, "width", both);
  take_size(into, &ToolHint::flute_length, "length", both);
  if (into.doubt.empty()) into.doubt = both.doubt;
}

// One of two lines may say nothing of the tool, but name upkeep, or sizes of the work. True if it
// does; `into` then holds what the other line says.
bool merge_without_work(ToolHint& into, const ToolHint& more) {
  if (is_sized_tool(into) && more.upkeep) return true;
  if (is_sized_tool(into) && is_size_of_work(more)) return pass_work(into, more), true;
  if (is_sized_tool(more) && (into.upkeep || is_size_of_work(into))) {
    const ToolHint line = std::exchange(into, more);
    if (!line.upkeep) pass_work(into, line);
    return true;
  }
  if (is_plain_mill(into) && may_be_work(more)) return pass_work(into, more), true;
  if (is_plain_mill(more) && may_be_work(into)) {
    const ToolHint line = std::exchange(into, more);
    return pass_work(into, line), true;
  }
  return false;
}

// Sizes that `into` lacks.
void add_sizes(ToolHint& into, const ToolHint& more) {
  into.bare_size = into.diameters.empty() ? more.bare_size : into.bare_size && more.bare_size;
  into.diameters.insert(into.diameters.end(), more.diameters.begin(), more.diameters.end());
  if (into.diameter == 0) into.diameter = more.diameter;
  compare_corners(into, more);
  add_size_of(into, &ToolHint::corner, "corner radius", more);
  add_size_of(into, &ToolHint::nose, "nose radius", more);
  add_size_of(into, &ToolHint::width, "width", more);
  add_size_of(into, &ToolHint::tip, "tip", more);
  into.square |= more.square;
  into.pairs.insert(into.pairs.end(), more.pairs.begin(), more.pairs.end());
  if (!into.flute_length) into.flute_length = more.flute_length;
  if (told_angle(into) > 0 && told_angle(more) > 0 &&
      std::abs(told_angle(into) - told_angle(more)) > kTurnRounding && into.doubt.empty())
    into.doubt = "give two angles of the tool";
  if (into.taper_angle == 0) into.taper_angle = more.taper_angle;
  if (more.tip_angle > 0 && (into.tip_angle == 0 || into.assumed_angle)) {
    into.tip_angle = more.tip_angle;
    into.assumed_angle = more.assumed_angle;
  }
}

// The insert, and how its holder stands.
void add_insert(ToolHint& into, const ToolHint& more) {
  const bool inserts = !into.insert.empty() && !more.insert.empty();
  if (inserts && into.insert_angle != more.insert_angle && into.doubt.empty())
    into.doubt = "name different inserts";
  if (into.insert.empty()) into.insert = more.insert;
  if (into.insert_angle == 0) into.insert_angle = more.insert_angle;
  if (into.lead_angle == 0) into.lead_angle = more.lead_angle;
  if (into.edge_length == 0) into.edge_length = more.edge_length;
  if (into.orientation == 0) into.orientation = more.orientation;
  if (into.blade_point == BladePoint::untold) into.blade_point = more.blade_point;
  into.left_hand |= more.left_hand;
}

// What the words say of the tool's work: its trade, bores, faces.
void add_work(ToolHint& into, const ToolHint& more) {
  into.rivals |= more.rivals || (into.trade && more.trade && *into.trade != *more.trade);
  into.inside |= more.inside;
  const bool bar =
      more.inside && more.bores && !more.id.empty() && more.id == into.id;  // "T10 - ID BORE"
  if (bar && into.type == ToolType::turning) into.type = ToolType::boring;
  into.bores |= more.bores;
  into.face_groove |= more.face_groove;
  into.other_work |= more.other_work;
  into.unknown_word |= more.unknown_word;
  into.unknown_shape |= more.unknown_shape;
  if (!into.trade) into.trade = more.trade;
}

}  // namespace

void merge_hint(ToolHint& into, const ToolHint& more) {
  if (merge_without_work(into, more)) return;
  if (into.only_angle() && !more.only_angle()) {
    const ToolHint line = std::exchange(into, more);
    return merge_hint(into, line);
  }
  // "Ball Nose {3 mm}" beside "End Mill {6 mm}" is a tool, and no line about it.
  const bool is_tool = into.firm && more.firm && !more.diameters.empty();
  if (more.size_line && !is_tool && (into.type || into.diameter > 0)) {
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
  add_sizes(into, more);
  add_insert(into, more);
  add_work(into, more);
  if (into.gauge.empty()) into.gauge = more.gauge;
  if (!into.pilot) into.pilot = more.pilot;
  into.disputed_gauge |= more.disputed_gauge;
  if (into.doubt.empty()) into.doubt = more.doubt;
  if (more.only_angle() && !into.only_angle()) merge_angle(into, more);
  if (into.text.size() < 400) into.text += "\", \"" + more.text;
}

}  // namespace mrsim
