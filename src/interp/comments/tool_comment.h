// What comments say about tools: "Steblasto frezalo Ø5", "T1 D=6. CR=0. - FLAT END MILL",
// "T239 | 10 FLAT ENDMILL | H239 | D239 | TOOL DIA. - 10.", "OD ROUGH - CNMG 120408".
//
// Guarantees: only whole words count; a register (D239 beside H239, DIA. OFF. - 41) is no diameter;
// where two readings of a comment differ no tool is made and the reason is reported. Does not know
// the units of the program: fill_tool() of tool_hint.h is given them.
#pragma once

#include "core/numbers/units.h"
#include "interp/comments/tool_kind.h"
#include <mrsim/types.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

/// A length as it was written.
struct ToolLength {
  double value = 0;
  double unit = 0;            ///< mm per unit where the comment says so, 0 = the program's units
  bool fraction = false;      ///< "1/4": inches, unless something else is said
  bool letter_point = false;  ///< "D.10": 0.10, or D. 10
  bool inch_style = false;    ///< ".1875": thousandths without a 0 before the point
  /// In a program whose unit is `program_unit` mm. A fraction is in inches in every program.
  double mm(double program_unit) const {
    return value * (unit > 0 ? unit : fraction ? kMmPerInch : program_unit);
  }
  explicit operator bool() const { return value > 0; }
};

/// Which point of a grooving blade the comment calls the programmed one.
enum class BladePoint : std::uint8_t {
  untold,
  left,
  right,
  middle,
  unclear  ///< "RIGHT SIDE": of the blade, or of the groove
};

/// What a comment says in so many words: these facts do not depend on the kind of tool.
struct PlainFacts {
  std::string id;             ///< when the comment names the tool's number itself
  std::size_t id_digits = 0;  ///< in how many digits the number was written
  bool names_tool = false;    ///< "TOOL", "TC:", a number: the comment is about a tool
  ToolLength corner, nose, width;
  bool square = false;          ///< "CR=0.", "FLAT ENDMILL": it has no corner radius
  ToolLength tip;               ///< diameter of a V tool's tip
  ToolLength flute_length;      ///< "LOC 1.0"
  ToolLength pilot;             ///< diameter of a centre drill's pilot
  bool disputed_gauge = false;  ///< two standards give a centre drill of this number other sizes
  bool inside = false;          ///< "ID", "INTERNAL", "BORE", and nothing of the outside
  bool bores = false;           ///< "BORE", "BORING" alone
  bool face_groove = false;     ///< "FACE GROOVE": the blade stands along Z
  BladePoint blade_point = BladePoint::untold;
  int orientation = 0;  ///< of a lathe's tool: "TIP 3", "TIP DIRECTION 2"; 0: not given

  // The comment has one thing and nothing else.
  bool bare_id = false;        ///< "TOOL NUMBER: 5"
  bool bare_kind = false;      ///< the kind and its attributes: "BAR STOP"
  bool diameter_line = false;  ///< "DIAMETER: 8.0"
  bool angle_line = false;     ///< "TAPER ANGLE: 5.", "ANGLE: 60"
  bool own_angle = false;      ///< an angle_line that names the tool's angle: "TIP ANGLE 140"
  bool size_line = false;      ///< "D10. R1.", "TIP DIA 0.2"
  bool plain_radius = false;   ///< a size_line that may be a radius of the work: "R5"
  bool tool_radius = false;    ///< a size_line that may be half the diameter: "TOOL RADIUS 5"

  bool other_work = false;     ///< "KREISTASCHE D30", "BOHREN D8": work that another tool may do
  bool unknown_word = false;   ///< no table has one of its words, "D8 XYZW": perhaps a kind of tool
  bool unknown_shape = false;  ///< such a word stands beside "FREZALO", "FRESA": perhaps a shape
  bool next_tool = false;      ///< "NEXT TOOL - 6MM DRILL"
  bool last_tool = false;      ///< "LAST TOOL WAS 6MM DRILL"
};

/// Two comments about one tool give it this size.
struct SizePair {
  const char* what = "";  ///< "corner radius"
  ToolLength first, second;
};

struct ToolHint : PlainFacts {
  bool firm = false;  ///< the words of the kind can only mean a tool: "END MILL"
  std::optional<ToolType> type;
  std::optional<ToolTrade> trade;
  std::optional<ToolType> operation;  ///< "GROOVE 3MM": names the work, perhaps not the tool
  std::vector<ToolLength> diameters;  ///< all readings, the most explicit first
  std::vector<SizePair> pairs;        ///< the program's unit tells whether they agree
  double diameter = 0;                ///< value of the first reading, 0 = none
  bool bare_size = false;             ///< the diameter has no name: "FACE MILL 1MM"
  bool beside_inches = false;  ///< it has no unit, and its width has: "T-SLOT CUTTER 6 X 1/8"
  double corner_radius = 0, nose_radius = 0;  ///< values of corner and nose
  double taper_angle = 0, tip_angle = 0;      ///< radians; per side, and included
  bool assumed_angle = false;                 ///< the angle follows from the kind alone
  bool rivals = false;                        ///< the comment names another kind of tool, too
  std::string gauge;                          ///< "7" of a number drill, "Q" of a letter drill
  std::string insert;                         ///< "CNMG"
  double insert_angle = 0, lead_angle = 0;    ///< radians
  double edge_length = 0;                     ///< mm
  bool left_hand = false;
  bool padded_radius = false;  ///< "R05", which may be R5 or R0.5
  bool settings = false;       ///< settings of the program that wrote the NC program
  bool upkeep = false;         ///< when it is seen to: "REPLACE 10MM ENDMILL EVERY 20 PARTS"
  bool size_of_work = false;  ///< a size of the work perhaps, and no kind: "BORE D30", "D30 POCKET"
  bool at_call = false;       ///< in the block of the change or right behind it
  std::string work;  ///< other comments at the tool that are about the work: 'ROUGH T-SLOT'
  bool rounds_edges = false;  ///< a line about the work says so: "ROUND OVER EDGES"
  std::string doubt;  ///< why no tool can be made of it, after "the comment ... "; empty: it can
  std::string text;   ///< the comment, UTF-8, for the report
  /// Whether the comment is about another tool than the one at hand.
  bool of_other_tool() const { return id.empty() && (last_tool || (next_tool && at_call)); }
  explicit operator bool() const { return type || diameter > 0 || !doubt.empty(); }
  /// A thread mill, of which nothing but a cylinder is known.
  bool plain_teeth() const { return trade == ToolTrade::thread_mill; }
  /// Whether the tool may be another than the end mill for which it is taken.
  bool may_be_another() const { return unknown_shape || (!type && unknown_word); }
  /// Whether the comment only adds a corner radius to what others say of the tool.
  bool only_corner() const { return !type && diameter == 0 && id.empty() && corner; }
  /// Whether it only adds a diameter.
  bool only_diameter() const { return diameter_line && !type && id.empty(); }
  /// Whether it only adds an angle. The kind of the tool says which angle that is.
  bool only_angle() const { return angle_line; }
};

/// Its size is one of the trade in inches: "1/2 END MILL", "CNMG-432".
bool sized_in_inches(const ToolHint& hint);

/// `bytes` in whatever encoding they came.
ToolHint read_tool_comment(std::string_view bytes);

}  // namespace mrsim
