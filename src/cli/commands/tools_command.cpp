#include "cli/commands/commands.h"
#include "cli/console/standard_streams.h"
#include "cli/console/terminal.h"
#include "cli/options/option_values.h"
#include "cli/options/typed_options.h"
#include "cli/report/findings.h"
#include "cli/report/report.h"
#include "core/numbers/units.h"
#include "core/output/publish.h"
#include "core/text/json_text.h"
#include "core/text/text_io.h"
#include "core/words/tool_types.h"
#include <mrsim/mrsim.h>

#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace mrsim::cli {
namespace {

// [lower diameter, upper diameter, length] of each piece.
std::string pieces_json(const char* name, const std::vector<ToolSegment>& pieces) {
  std::vector<std::string> out;
  for (const ToolSegment& s : pieces)
    out.push_back(fmt::format("[{:.9g},{:.9g},{:.9g}]", s.diameter_low, s.diameter_high, s.length));
  return out.empty() ? "" : fmt::format(",\"{}\":[{}]", name, fmt::join(out, ","));
}

std::string profile_json(const std::vector<ProfilePoint>& profile) {
  std::vector<std::string> out;
  for (const ProfilePoint& p : profile)
    out.push_back(p.bulge == 0 ? fmt::format("[{:.9g},{:.9g}]", p.r, p.z)
                               : fmt::format("[{:.9g},{:.9g},{:.9g}]", p.r, p.z, p.bulge));
  return out.empty() ? "" : fmt::format(",\"profile\":[{}]", fmt::join(out, ","));
}

std::string tool_json(const Tool& tool) {
  std::string out =
      fmt::format("{{\"id\":{},\"type\":\"{}\"", json_string(tool.id), tool_type_name(tool.type));
  const auto add = [&](const char* name, double value) {
    if (value != 0) out += fmt::format(",\"{}\":{:.9g}", name, value);
  };
  add("diameter", tool.diameter);
  add("corner_radius", tool.corner_radius);
  add("taper_angle", degrees(tool.taper_angle));
  add("tip_angle", degrees(tool.tip_angle));
  add("tip_diameter", tool.tip_diameter);
  add("neck_diameter", tool.neck_diameter);
  add("profile_radius", tool.profile_radius);
  add("flute_length", tool.flute_length);
  add("nose_radius", tool.nose_radius);
  add("insert_angle", degrees(tool.insert_angle));
  add("lead_angle", degrees(tool.lead_angle));
  add("edge_length", tool.edge_length);
  add("width", tool.width);
  add("tip", tool.tip_is_nose_centre ? 9 : tool.tip);
  if (tool.left_hand) out += ",\"hand\":\"left\"";
  if (!tool.insert.empty()) out += fmt::format(",\"insert\":{}", json_string(tool.insert));
  out += pieces_json("shank", tool.shank) + pieces_json("holder", tool.holder);
  out += profile_json(tool.profile);
  return out + fmt::format(",\"origin\":{}}}\n", json_string(tool.origin));
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

// Checks the pictures to be written before any work.
void check_places(const TypedOptions& typed) {
  std::vector<NamedPath> pictures;
  for (const std::string& path : typed.texts("--output")) pictures.push_back({path, "-o"});
  const NamedPath input{typed.inputs()[0], "the tools"};
  prepare_outputs(pictures, {&input, 1});
}

int show_tools(const TypedOptions& typed) {
  typed.refuse_unknown();
  const std::vector<std::string>& inputs = typed.inputs();
  if (inputs.size() != 1 || inputs[0].empty())
    fail_usage("one file is needed; usage: mrsim tools FILE [-o tools.svg]");
  limit_memory(typed);
  check_places(typed);
  const bool quiet = typed.flag("--quiet");
  std::vector<std::string> notes;
  const ToolTable table = load_tools(inputs[0], &notes);
  std::vector<OutputFile> pictures;
  for (const std::string& path : typed.texts("--output"))
    pictures.push_back({path, [&table, &path](const ByteSink& sink) {
                          encode_tools_picture(table.tools, path, sink);
                        }});
  if (!quiet)
    for (const std::string& note : notes) say("note: " + printable(note) + "\n");
  if (!quiet) list(table, typed.flag("--json"));
  write_files_atomically(pictures);
  return finish_output(kDone);
}

}  // namespace

int run_tools(int argc, const char* const* argv) {
  const TypedOptions typed(command_line(kUseTools), argc, argv);
  if (!typed.help().empty()) {
    print(typed.help());
    return finish_output(kDone);
  }
  try {
    return show_tools(typed);
  } catch (const Error& error) {
    Arguments told;
    told.json = typed.flag("--json");
    if (told.json) Findings(told).add(error);
    throw;
  }
}

}  // namespace mrsim::cli
