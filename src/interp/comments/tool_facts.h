// What the words and numbers of a comment say, each as what it is: a diameter, a radius, an angle,
// a thread, or a size without a name. Nothing is settled here: settle_tool() of tool_settle.h
// does, by the kind of tool.
#pragma once

#include "interp/comments/blade_code.h"
#include "interp/comments/comment_tokens.h"
#include "interp/comments/insert_code.h"
#include "interp/comments/tool_comment.h"
#include "interp/comments/tool_kind.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace mrsim {

/// Numbers joined by X: "12 X 26", ".250 X 45"; most have one number.
struct SizeGroup {
  std::vector<CommentToken> sizes;
  bool continues = false;  ///< the first number has a name and is left out: "D20 X 4"
};

struct ToolFacts {
  std::string id;
  std::size_t id_digits = 0;
  bool names_tool = false, several_ids = false;

  std::vector<ToolKind> kinds;  ///< the one that counts first
  std::optional<InsertCode> insert;
  std::optional<BladeCode> blade;

  std::vector<ToolLength> named;     ///< diameters with a name: "DIA 10", "Ø5", "D=6"
  ToolLength letter_d;               ///< "D10": a diameter, or a register
  ToolLength second_d;               ///< of a pointed mill: a tip, or a register
  std::optional<ToolLength> thread;  ///< diameter of the thread that is named; 0 = not given
  bool enlarged_thread = false;      ///< for a wire insert
  std::optional<ToolLength> gauge;   ///< "#7", "LETTER Q"
  std::string gauge_name;
  std::vector<SizeGroup> before_kind;  ///< beside it, the nearest first
  std::optional<SizeGroup> behind_kind;
  bool behind_ends = false;      ///< nothing follows that could make something else of it
  std::vector<SizeGroup> loose;  ///< elsewhere, with a unit or as a fraction

  ToolLength corner, nose, width, tip, flute_length;
  bool pair = false;           ///< "D12R2", "D10R0"
  std::vector<double> angles;  ///< degrees
  double taper = 0;            ///< degrees, of TAPER=
  bool tapered = false;        ///< "1/8 BALL 5 DEG TAPER"
  bool included = false, per_side = false;
  bool helix = false;       ///< the angle may be that of the flutes
  std::string split_size;   ///< "8-5", "8P5": 8.5 perhaps; as "8 or 8.5"
  double bare_point = 0;    ///< "90" beside a drill, "45" beside a face mill, degrees
  bool bare_angle = false;  ///< a "90" that nothing explains, beside a tool's number
  bool left_hand = false;
  bool fusion = false;        ///< "CR=", which posts of Fusion write of every tool
  bool fusion_slot = false;   ///< its "slot mill", the disc on a neck of its lists
  bool slot_mill = false;     ///< a "slot mill" or of keyways: with a width a disc, too
  bool inside = false;        ///< "ID", "INTERNAL", "BORE", and nothing of the outside
  bool flat_thread = false;   ///< "TR20X4", "ACME": the end of the tooth is no point
  bool whitworth = false;     ///< "WHITWORTH", "BSP": teeth of 55 degrees
  bool back_turn = false;     ///< "BACK TURN", and no hand
  bool turned_side = false;   ///< "OD", "ID", "TURN": a lathe's words
  bool turns_before = false;  ///< "TURN FOR THREAD": not the thread itself
  bool bores = false;         ///< "BORE", "BORING" alone
  bool full_radius = false;   ///< "FULL RADIUS": the end of a blade is half a circle
  bool face_groove = false;   ///< "FACE GROOVE": the blade stands along Z
  BladePoint blade_point = BladePoint::untold;
  int orientation = 0;           ///< "TIP 3", "TIP DIRECTION 2"; 0: not given
  bool corner_line = false;      ///< "TIP RADIUS: 1.0" and nothing else
  bool diameter_line = false;    ///< "DIAMETER: 8.0" and nothing else
  bool angle_line = false;       ///< "TAPER ANGLE: 5.", "ANGLE: 60" and nothing else
  bool size_line = false;        ///< "D10. R1.", "TIP DIA 0.2" and nothing else
  bool plain_radius = false;     ///< such a line, "R5": perhaps the work's
  bool bare_id = false;          ///< "TOOL NUMBER: 5" and nothing else
  bool bare_kind = false;        ///< nothing but the kind and its attributes: "BAR STOP"
  bool padded_radius = false;    ///< "R05"
  bool alternatives = false;     ///< "12MM OR 1/2 ENDMILL"
  bool shaped = false;           ///< "TAPER", "UNDERCUT": no end mill, if nothing else names a kind
  bool other_work = false;       ///< "KREISTASCHE D30", "BOHREN D8"
  bool unknown_word = false;     ///< has words that no table has
  bool next_tool = false;        ///< "NEXT TOOL - 6MM DRILL"
  bool last_tool = false;        ///< "LAST TOOL WAS 6MM DRILL"
  bool round_work = false;       ///< "CIRCLE MILL 30 DIA"
  bool round_insert = false;     ///< "BUTTON TOOL", "ROUND INSERT"
  std::vector<ToolLength> bare;  ///< numbers with a point that nothing names: "CNMG .8"
  bool holes = false;            ///< "4 DRILL HOLES"
  bool tool_radius = false;      ///< such a line, "TOOL RADIUS 5": perhaps half the diameter
  bool own_angle = false;        ///< a line with the tool's angle: "TIP ANGLE 140", "ANGLE: 60"

  const ToolKind* kind() const { return kinds.empty() ? nullptr : &kinds.front(); }
  bool trade_is(ToolTrade trade) const { return kind() && kind()->trade == trade; }
};

/// Reads the tokens of a folded comment.
ToolFacts read_tool_facts(std::vector<CommentToken> tokens);

}  // namespace mrsim
