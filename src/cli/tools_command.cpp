#include "cli/tools_command.h"

#include "cli/commands.h"
#include "cli/findings.h"
#include "cli/option_values.h"
#include "cli/report.h"
#include "cli/terminal.h"
#include "core/units.h"
#include <mrsim/mrsim.h>

#include <cstdio>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace mrsim::cli {
namespace {

constexpr const char* kHelp =
    "Lists the tools of a file, and draws them.\n\n"
    "Usage: mrsim tools FILE [-o tools.svg|tools.png] [--json] [-q]\n\n"
    "FILE is tools.toml, LinuxCNC .tbl, CAMotics .camotics or .json, Fusion .json or .tools,\n"
    "FreeCAD .fctb or .fctl. What can not be read is named.\n\n"
    "Output:\n"
    "  -o, --output FILE       draw the tools: .svg or .png\n"
    "  --json                  one JSON object a tool\n"
    "  -q, --quiet             print errors only\n"
    "  -h, --help              print this and exit\n\n"
    "Examples:\n"
    "  mrsim tools tools.toml\n"
    "  mrsim tools library.tools -o library.svg\n";

constexpr const char* kTypeNames[] = {"endmill", "ballmill", "bullmill", "chamfer",  "taper",
                                      "drill",   "tslot",    "lollipop", "barrel",   "form",
                                      "turning", "grooving", "boring",   "threading"};

std::string tool_json(const Tool& tool) {
  std::string out = fmt::format("{{\"id\":{},\"type\":\"{}\"", json_quoted(tool.id),
                                kTypeNames[static_cast<std::size_t>(tool.type)]);
  const auto add = [&](const char* name, double value) {
    if (value != 0) out += fmt::format(",\"{}\":{:.9g}", name, value);
  };
  add("diameter", tool.diameter);
  add("corner_radius", tool.corner_radius);
  add("taper_angle", degrees(tool.taper_angle));
  add("tip_angle", degrees(tool.tip_angle));
  add("tip_diameter", tool.tip_diameter);
  add("flute_length", tool.flute_length);
  add("nose_radius", tool.nose_radius);
  add("insert_angle", degrees(tool.insert_angle));
  add("lead_angle", degrees(tool.lead_angle));
  add("width", tool.width);
  if (!tool.insert.empty()) out += fmt::format(",\"insert\":{}", json_quoted(tool.insert));
  return out + fmt::format(",\"origin\":{}}}\n", json_quoted(tool.origin));
}

void list(const ToolTable& table, bool json) {
  for (const Tool& tool : table.tools) {
    if (json) {
      print(tool_json(tool));
      continue;
    }
    const std::string id = tool.id.empty() ? "any" : "T" + tool.id;
    print(fmt::format("{:<8}{}  ({})\n", printable(id), tool_text(tool), printable(tool.origin)));
  }
}

}  // namespace

int run_tools(int argc, const char* const* argv) {
  CLI::App app;
  std::vector<std::string> inputs, outputs;
  bool json = false, quiet = false, help = false;
  app.set_help_flag("");
  app.allow_extras();
  app.add_option("INPUT", inputs)->expected(0, -1);
  app.add_option("-o,--output", outputs)->allow_extra_args(false);
  app.add_flag("--json", json);
  app.add_flag("-q,--quiet", quiet);
  app.add_flag("-h,--help", help);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    fail_usage(error.what());
  }
  if (help) {
    print(kHelp);
    return kDone;
  }
  refuse_unknown(app);
  if (inputs.size() != 1 || inputs[0].empty())
    fail_usage("one file is needed; usage: mrsim tools FILE [-o tools.svg]");
  std::vector<std::string> notes;
  const ToolTable table = load_tools(inputs[0], &notes);
  if (!quiet)
    for (const std::string& note : notes) fmt::print(stderr, "note: {}\n", printable(note));
  if (!quiet) list(table, json);
  for (const std::string& output : outputs) write_tools_picture(table.tools, output);
  return finish_output(kDone);
}

}  // namespace mrsim::cli
