// Tool libraries of other programs: LinuxCNC .tbl, CAMotics projects and tool tables, Fusion .json
// and .tools, FreeCAD .fctb and .fctl. The content decides the format, not the name.
//
// Guarantees: sizes and nesting are bounded; a tool whose data do not make a tool is left out with
// a sentence in `skipped`, never changed into another. What the formats do not hold (LinuxCNC: the
// kind of tool, and units) is left to the caller with the tool's remark.
#pragma once

#include <mrsim/types.h>

#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

enum class LibraryFormat : std::uint8_t { toml, linuxcnc, camotics, fusion, freecad_bit, freecad };

/// A tool of a library, with what its author wrote about it.
struct LibraryTool {
  Tool tool;
  std::string remark;
};

struct ToolLibrary {
  LibraryFormat format = LibraryFormat::toml;
  ToolTable table;                   ///< of tools.toml; else empty
  std::vector<LibraryTool> tools;    ///< of the other formats
  std::vector<std::string> skipped;  ///< sentences about tools that were left out
};

/// The name of a format for people, "Fusion tool library".
std::string_view library_name(LibraryFormat format);

/// Reads a file of any format. Throws what read_file throws, Error "tools-format" for a file that
/// is none of them, "tools-syntax", "tools-value", and what parse_tools() throws.
ToolLibrary load_library(const std::string& path);

/// load_library() from memory; `name` stands in messages, FreeCAD's bits are looked for beside it.
ToolLibrary parse_library(std::string_view bytes, const std::string& name);

}  // namespace mrsim
