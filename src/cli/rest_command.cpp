#include "cli/rest_command.h"

#include "cli/commands.h"
#include "cli/findings.h"
#include "cli/option_values.h"
#include "cli/rest_report.h"
#include "cli/terminal.h"
#include "cli/typed_options.h"
#include "core/output_place.h"
#include "core/publish.h"
#include "core/text_io.h"
#include <mrsim/rest.h>
#include <mrsim/solid_files.h>

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace mrsim::cli {
namespace {

// All that is written, before any work.
std::vector<NamedPath> checked_outputs(const TypedOptions& typed) {
  std::vector<NamedPath> outputs;
  for (const std::string& path : typed.texts("--output")) {
    encode_mesh({}, path, [](const void*, std::size_t) {});  // refuses an unknown format
    outputs.push_back({path, "-o"});
  }
  if (typed.has("--json")) outputs.push_back({typed.text("--json"), "--json"});
  std::vector<std::string> paths;
  for (const NamedPath& output : outputs) {
    check_writable(output.path);
    paths.push_back(output.path);
  }
  const std::array<NamedPath, 2> inputs{
      {{typed.inputs()[0], "the part"}, {typed.inputs()[1], "the nominal"}}};
  refuse_overwrites(outputs, inputs);
  recover_outputs(paths);
  return outputs;
}

}  // namespace

int run_rest(int argc, const char* const* argv) {
  const TypedOptions typed(command_line(kUseRest), argc, argv);
  if (!typed.help().empty()) {
    print(typed.help());
    return kDone;
  }
  typed.refuse_unknown();
  if (typed.inputs().size() != 2)
    fail_usage("rest takes a part and a nominal; usage: mrsim rest PART NOMINAL [-o pieces.stl]");
  RestOptions options;
  typed.read("--voxel", options.voxel, positive_value);
  typed.read("--above", options.above, positive_value);
  typed.read("--threads", options.threads, threads_value);
  double deflection = 0.001;
  typed.read("--deflection", deflection, positive_value);
  const std::vector<NamedPath> outputs = checked_outputs(typed);
  const auto read = [&](const std::string& path) {
    std::string note;
    TriMesh mesh = read_solid(path, deflection, options.threads, &note);
    if (!note.empty() && !typed.flag("--quiet")) fmt::print(stderr, "{}\n", note);
    return mesh;
  };
  const TriMesh part = read(typed.inputs()[0]), nominal = read(typed.inputs()[1]);
  const Rest rest = find_rest(part, nominal, options);
  if (!typed.texts("--output").empty() && rest.pieces.empty())
    throw Error("rest-none", "nothing is left to cut, so there is no mesh to write");
  const TriMesh pieces = joined_pieces(rest);
  std::vector<OutputFile> files;
  for (const NamedPath& output : outputs)
    files.push_back({output.path, [&, path = output.path](const ByteSink& sink) {
                       if (path != typed.text("--json")) return encode_mesh(pieces, path, sink);
                       const std::string text =
                           rest_json(rest, typed.inputs()[0], typed.inputs()[1]);
                       sink(text.data(), text.size());
                     }});
  write_files_atomically(files);
  if (!typed.flag("--quiet") && typed.text("--json") != "-") print(rest_text(rest));
  return finish_output(kDone);
}

}  // namespace mrsim::cli
