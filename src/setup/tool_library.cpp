#include "setup/tool_library.h"

#include "core/process/error.h"
#include "core/text/text_io.h"
#include "core/text/zip.h"
#include "setup/library_formats.h"
#include "setup/spec_text.h"
#include "setup/tool_keys.h"
#include "setup/tools_file.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace mrsim {
namespace {

constexpr std::size_t kLibraryFileLimit = std::size_t(64) << 20;
constexpr std::size_t kMostTools = 20000;

[[noreturn]] void fail_format(const std::string& name, const std::string& what) {
  throw Error(
      "tools-format",
      fmt::format("{} {}; tools are read from tools.toml, LinuxCNC .tbl, CAMotics .camotics "
                  "and .json, Fusion .json and .tools, FreeCAD .fctb and .fctl",
                  name, what));
}

// The JSON inside Fusion's .tools.
std::string unpack_tools(std::string_view bytes, const std::string& name) {
  for (const detail::ZipEntry& entry : detail::zip_directory(bytes, name))
    if (entry.name.ends_with(".json")) return detail::unzip(bytes, entry, kLibraryFileLimit, name);
  fail_format(name, "is a zip archive without a tool library");
}

void read_json(const Json& root, const std::string& name, ToolLibrary& out) {
  if (json_at(root, "data").is_array()) return read_fusion_tools(root, name, out);
  if (json_at(root, "parameter").is_object()) {
    out.format = LibraryFormat::freecad_bit;
    return read_freecad_bit(root, "", name, out);
  }
  if (json_at(root, "tools").is_array()) return read_freecad_library(root, name, out);
  const Json& tools = json_at(root, "tools");
  const Json& table = tools.is_object() ? tools : root;
  const bool numbered =
      table.is_object() && !table.empty() &&
      std::all_of(table.items().begin(), table.items().end(), [](const auto& item) {
        return item.value().is_object() &&
               item.key().find_first_not_of("0123456789") == std::string::npos;
      });
  if (numbered) return read_camotics_tools(table, name, out);
  fail_format(name, "is JSON, but no tool library that is known");
}

// The first line that is neither blank nor a comment.
std::string_view first_line(std::string_view text, char comment) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
    if (!line.empty() && line.front() != comment && line.front() != '\r') return line;
  }
  return {};
}

// "T1 P1 D6 ;end mill".
bool is_linuxcnc(std::string_view text) {
  const std::string_view line = first_line(text, ';');
  return line.size() > 1 && (line[0] == 'T' || line[0] == 't') && line[1] >= '0' && line[1] <= '9';
}

// "[[tool]]", "units = "; a program begins with "%", "O0001", "(T1 ...)".
bool may_be_toml(std::string_view text) {
  const std::string_view line = first_line(text, '#');
  return line.empty() || line.front() == '[' ||
         (line.find('=') != line.npos && std::string_view("(%;:/'!").find(line[0]) == line.npos);
}

// Two commas or semicolons at least in the first line, and no "=": as tables are exported.
bool is_csv(std::string_view text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  const auto several = [&](char c) { return std::count(line.begin(), line.end(), c) >= 2; };
  return line.find('=') == line.npos && line[0] != '[' && line[0] != '#' &&
         (several(',') || several(';') || several('\t'));
}

}  // namespace

std::string_view library_name(LibraryFormat format) {
  switch (format) {
    case LibraryFormat::linuxcnc:
      return "LinuxCNC tool table";
    case LibraryFormat::camotics:
      return "CAMotics tools";
    case LibraryFormat::fusion:
      return "Fusion tool library";
    case LibraryFormat::freecad_bit:
      return "FreeCAD tool bit";
    case LibraryFormat::freecad:
      return "FreeCAD tool library";
    case LibraryFormat::toml:
      break;
  }
  return "tools.toml";
}

void skip_library_tool(ToolLibrary& out, const std::string& id, const std::string& why) {
  out.skipped.push_back(fmt::format("tool {}: {}", id.empty() ? "without a number" : id, why));
}

void add_library_tool(ToolLibrary& out, LibraryTool entry, const std::string& name) {
  if (out.tools.size() >= kMostTools)
    fail_library(name, fmt::format("more than {} tools", kMostTools));
  for (const double value : {entry.tool.diameter, entry.tool.corner_radius, entry.tool.flute_length,
                             entry.tool.taper_angle, entry.tool.tip_angle, entry.tool.tip_diameter})
    if (!std::isfinite(value) || value < 0 || value > 1e5)
      return skip_library_tool(out, entry.tool.id, "a size is negative or too large");
  const std::string wrong = check_tool(entry.tool);
  if (!wrong.empty()) return skip_library_tool(out, entry.tool.id, wrong);
  for (const LibraryTool& other : out.tools)
    if (other.tool.id == entry.tool.id)
      return skip_library_tool(out, entry.tool.id, "its number is given twice: the first counts");
  out.tools.push_back(std::move(entry));
}

ToolLibrary parse_library(std::string_view bytes, const std::string& name) {
  ToolLibrary out;
  std::string unpacked;
  if (bytes.starts_with("PK\x03\x04")) {
    unpacked = unpack_tools(bytes, name);
    bytes = unpacked;
  }
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first == bytes.npos) fail_format(name, "is empty");
  if (is_utf16(bytes)) fail_format(name, "is UTF-16 text: save it as UTF-8");
  if (bytes.find('\0') != bytes.npos) fail_format(name, "is no text");
  const bool list = bytes[first] == '[' && bytes.find('"', first) != bytes.npos &&
                    bytes.find_first_not_of(" \t\r\n", first + 1) == bytes.find('{', first + 1);
  if (list) fail_format(name, "is a JSON list, but no tool library that is known");
  if (bytes[first] == '{') {
    read_json(parse_json(bytes, name), name, out);
  } else if (bytes[first] == '<') {
    fail_format(name, "is XML");
  } else if (is_linuxcnc(bytes)) {
    read_linuxcnc_table(bytes, name, out);
  } else if (is_csv(bytes.substr(first))) {
    fail_format(name, "is a table of values with commas (CSV)");
  } else if (!may_be_toml(bytes)) {
    fail_format(name, "is no table of tools");
  } else {
    out.table = parse_tools(bytes, name);
  }
  return out;
}

ToolLibrary load_library(const std::string& path) {
  return parse_library(read_file(path, kLibraryFileLimit), path);
}

}  // namespace mrsim
