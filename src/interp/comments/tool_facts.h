// Sorts the words and numbers of a comment: a diameter, a radius, an angle, a thread, or a size
// without a name. What a size without a name means is decided by settle_tool() (tool_settle.h),
// which knows the kind of tool.
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

struct ToolFacts : PlainFacts {
  bool several_ids = false;  ///< it names two numbers of tools

  std::vector<ToolKind> kinds;  ///< the one that counts first
  std::optional<InsertCode> insert;
  std::optional<BladeCode> blade;

  std::vector<ToolLength> named;     ///< diameters with a name: "DIA 10", "Ø5", "D=6"
  ToolLength letter_d;               ///< "D10": a diameter, or a register
  ToolLength second_d;               ///< of a pointed mill: a tip, or a register
  ToolLength d1, d2;                 ///< "D1=2": of a pointed mill perhaps the tip
  std::optional<ToolLength> thread;  ///< diameter of the thread that is named; 0 = not given
  bool enlarged_thread = false;      ///< for a wire insert
  std::optional<ToolLength> gauge;   ///< "#7", "LETTER Q"
  std::string gauge_name;
  std::vector<SizeGroup> before_kind;    ///< sizes before the kind, the nearest first
  std::optional<SizeGroup> behind_kind;  ///< sizes right behind the kind
  bool behind_ends = false;      ///< no word behind these sizes could give them another meaning
  std::vector<SizeGroup> loose;  ///< sizes elsewhere, with a unit or as a fraction

  bool pair = false;                        ///< "D12R2", "D10R0": diameter and radius in one word
  std::vector<double> angles;               ///< degrees
  double taper = 0;                         ///< degrees, of TAPER=
  bool tapered = false;                     ///< "1/8 BALL 5 DEG TAPER"
  bool included = false, per_side = false;  ///< "INCLUDED", "PER SIDE": how the angle is counted
  bool helix = false;                       ///< the angle may be that of the flutes
  std::string split_size;                   ///< "8 or 8.5": what "8-5" and "8P5" may mean
  double bare_point = 0;    ///< "90" beside a drill, "45" beside a face mill, degrees
  bool bare_angle = false;  ///< a "90" that nothing explains, beside a tool's number
  bool left_hand = false;
  bool fusion = false;           ///< "CR=", which posts of Fusion write of every tool
  bool fusion_slot = false;      ///< Fusion's "slot mill", which is a disc on a neck
  bool t_slot = false;           ///< "T-SLOT CUTTER", no saw
  bool slot_mill = false;        ///< "SLOT MILL", "GROOVE MILL": a disc if a width is given
  bool flat_thread = false;      ///< "TR20X4", "ACME": the end of the tooth is no point
  bool whitworth = false;        ///< "WHITWORTH", "BSP": teeth of 55 degrees
  bool back_turn = false;        ///< "BACK TURN", "BACK BORING" without the hand of the tool
  bool turned_side = false;      ///< "OD", "ID", "TURN": words of a lathe
  bool turns_before = false;     ///< "TURN FOR THREAD": the turning before the thread
  bool full_radius = false;      ///< "FULL RADIUS": the end of a blade is half a circle
  bool corner_line = false;      ///< "TIP RADIUS: 1.0" and nothing else
  bool padded_radius = false;    ///< "R05"
  bool alternatives = false;     ///< "12MM OR 1/2 ENDMILL"
  bool shaped = false;           ///< "TAPER", "UNDERCUT": no end mill, if nothing else names a kind
  bool upkeep = false;           ///< when a tool is seen to: "REPLACE 10MM ENDMILL EVERY 20 PARTS"
  bool size_of_work = false;     ///< names a hollow: "BORE D30", "D30 POCKET"
  bool round_work = false;       ///< "CIRCLE MILL 30 DIA": the diameter may be that of the work
  bool round_insert = false;     ///< "BUTTON TOOL", "ROUND INSERT"
  std::vector<ToolLength> bare;  ///< numbers that nothing names: "CNMG .8", "CNMG 1/32"
  bool counts_flutes = false;    ///< "4FL" without a kind
  bool holes = false;            ///< "4 DRILL HOLES": the number before the kind may count holes

  const ToolKind* kind() const { return kinds.empty() ? nullptr : &kinds.front(); }
  bool trade_is(ToolTrade trade) const { return kind() && kind()->trade == trade; }
  /// Whether the tool may have a flat tip with a diameter. In "CARBIDE TIP 10MM DRILL" the tip is
  /// no size.
  bool has_flat_tip() const {
    return trade_is(ToolTrade::vee) || trade_is(ToolTrade::chamfer_mill) ||
           trade_is(ToolTrade::countersink) || trade_is(ToolTrade::cone_mill);
  }
};

/// Reads the tokens of a folded comment.
ToolFacts read_tool_facts(std::vector<CommentToken> tokens);

}  // namespace mrsim
