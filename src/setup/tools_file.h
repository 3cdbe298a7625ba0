// tools.toml: tools, registers and work offsets of a machine (docs/tools.md).
//
// Every key is checked: an unknown one, a value of another type, out of range, or one that the type
// of tool does not have, is an error that names line and column. Nothing is ignored in silence.
#pragma once

#include <mrsim/types.h>

#include <string>
#include <string_view>

namespace mrsim {

/// The table in `text`; `name` is the file's, for messages. Throws PlacedError "tools-syntax",
/// "tools-key", "tools-value", "tools-duplicate".
ToolTable parse_tools(std::string_view text, const std::string& name);

}  // namespace mrsim
