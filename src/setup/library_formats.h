// The readers of one format each, for tool_library.cpp.
#pragma once

#include "setup/json_reader.h"
#include "setup/tool_library.h"

namespace mrsim {

/// Each adds the tools of a file `name` to `out`, those that cannot be used with a reason
/// (skip_library_tool()). Throws Error "tools-value" where the file is none of its format.
void read_linuxcnc_table(std::string_view text, const std::string& name, ToolLibrary& out);
void read_camotics_tools(const Json& root, const std::string& name, ToolLibrary& out);
void read_fusion_tools(const Json& root, const std::string& name, ToolLibrary& out);
void read_freecad_bit(const Json& root, const std::string& id, const std::string& name,
                      ToolLibrary& out);
void read_freecad_library(const Json& root, const std::string& name, ToolLibrary& out);

/// Adds the tool if its data are sound, else a sentence about it.
void add_library_tool(ToolLibrary& out, LibraryTool tool, const std::string& name);
/// Leaves a tool out, with the reason.
void skip_library_tool(ToolLibrary& out, const std::string& id, const std::string& why);

}  // namespace mrsim
