// Comments that list a tool's data in a fixed order or by keys.
#pragma once

#include "interp/comments/tool_comment.h"

namespace mrsim {

/// Makera's "@MKR|TOOL|number=1|type=Flat End|diameter=3.175" and the APT forms
/// "TOOL/MILL,3.17,0,0" and "TOOL/DRILL,5,118", CamBam's "T1 : 3.0". `folded` as by fold_comment().
/// False: the comment has none of these forms.
bool read_listed_tool(std::string_view folded, ToolHint& hint);

}  // namespace mrsim
