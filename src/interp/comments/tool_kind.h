// Which kind of tool the words of a comment name, in Slovenian, English, German, French, Spanish,
// Italian and Polish. Whole words only: GLOBALLY names no ball mill.
#pragma once

#include "interp/comments/comment_tokens.h"
#include <mrsim/types.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrsim {

/// What the tool is made for, which decides how the numbers beside the kind are read.
enum class ToolTrade : std::uint8_t {
  mill,
  face_mill,
  disc,  ///< T-slot and keyseat cutters, saws: diameter and width
  cone_mill,
  cone_ball,  ///< with a ball at the tip
  hole,       ///< reamers, counterbores, boring heads: cylinders
  twist_drill,
  spot_drill,
  center_drill,
  tap,
  thread_mill,
  chamfer_mill,
  countersink,
  vee,        ///< V-bits and engravers: nothing is known without the angle
  shaped,     ///< "OGEE": a comment can not give its shape
  dovetail,   ///< diameter, angle and height
  rounding,   ///< corner rounding mills
  no_cutter,  ///< probes, brushes
  lathe
};

struct ToolKind {
  ToolType type = ToolType::endmill;
  ToolTrade trade = ToolTrade::mill;
  /// The words name a tool and nothing else ("END MILL"); false: they may name an operation
  /// ("CHAMFER", "DRILL") and count only beside data of a tool.
  bool firm = false;
  double tip_angle = 0;            ///< degrees, where the kind implies it (spot drill)
  std::size_t first = 0, end = 0;  ///< tokens [first, end) are its name
};

/// All kinds that are named, the one that counts first: kinds that are certain stand before words
/// that may be operations, then particular kinds before general ones. Their tokens do not overlap.
std::vector<ToolKind> find_tool_kinds(const std::vector<CommentToken>& tokens);

/// Whether both may name one tool: "BALL" and "ENDMILL", "SPOT" and "CHAMFER".
bool same_trade(const ToolKind& a, const ToolKind& b);

}  // namespace mrsim
