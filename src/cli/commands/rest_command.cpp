#include "cli/commands/commands.h"
#include "cli/console/standard_streams.h"
#include "cli/console/stop.h"
#include "cli/console/terminal.h"
#include "cli/options/idle_options.h"
#include "cli/options/option_values.h"
#include "cli/options/typed_options.h"
#include "cli/report/rest_report.h"
#include "core/output/publish.h"
#include "core/text/text_io.h"
#include <mrsim/rest.h>
#include <mrsim/solid_files.h>

#include <array>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace mrsim::cli {
namespace {

// Checks all output files before any work, and returns them.
std::vector<NamedPath> checked_outputs(const TypedOptions& typed) {
  std::vector<NamedPath> outputs;
  for (const std::string& path : typed.texts("--output")) {
    encode_mesh({}, path, [](const void*, std::size_t) {});  // refuses an unknown format
    outputs.push_back({path, "-o"});
  }
  if (typed.has("--json")) outputs.push_back({typed.text("--json"), "--json"});
  const std::array<NamedPath, 2> inputs{
      {{typed.inputs()[0], "the part"}, {typed.inputs()[1], "the nominal"}}};
  prepare_outputs(outputs, inputs);
  return outputs;
}

int write_rest(const TypedOptions& typed) {
  typed.refuse_unknown();
  if (typed.inputs().size() != 2)
    fail_usage("rest takes a part and a nominal; usage: mrsim rest PART NOMINAL [-o pieces.stl]");
  RestOptions options;
  typed.read("--voxel", options.voxel, positive_value);
  typed.read("--above", options.above, positive_value);
  typed.read("--threads", options.threads, threads_value);
  limit_memory(typed);
  double deflection = 0.001;
  typed.read("--deflection", deflection, positive_value);
  tell_idle_options(command_line(kUseRest), typed);
  const std::vector<NamedPath> outputs = checked_outputs(typed);
  const auto read = [&](const std::string& path) {
    std::string note;
    TriMesh mesh = read_solid(path, deflection, options.threads, &note);
    if (!note.empty() && !typed.flag("--quiet")) say(printable(note) + "\n");
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
                       set_last_words({});  // from here on these are the words
                       const std::string text =
                           rest_json(rest, typed.inputs()[0], typed.inputs()[1]);
                       sink(text.data(), text.size());
                     }});
  write_files_atomically(files);
  all_is_written();
  if (!typed.flag("--quiet") && typed.text("--json") != "-") print(rest_text(rest));
  return finish_output(kDone);
}

// --json of a command that has failed. It replaces no input and no other output.
void tell_failure(const TypedOptions& typed, const Failure& failure) {
  std::vector<NamedPath> kept;
  for (const std::string& path : typed.inputs()) kept.push_back({path, "an input"});
  for (const std::string& path : typed.texts("--output")) kept.push_back({path, "-o"});
  const auto input = [&](std::size_t i) {
    return i < typed.inputs().size() ? typed.inputs()[i] : std::string();
  };
  write_last_words({typed.text("--json"),
                    failed_rest_json(input(0), input(1), failure.code, failure.text),
                    {},
                    {}},
                   kept);
}

}  // namespace

int run_rest(int argc, const char* const* argv) {
  const TypedOptions typed(command_line(kUseRest), argc, argv);
  if (!typed.help().empty()) {
    print(typed.help());
    return finish_output(kDone);
  }
  return run_told([&] { return write_rest(typed); },
                  [&](const Failure& failure) { tell_failure(typed, failure); });
}

}  // namespace mrsim::cli
