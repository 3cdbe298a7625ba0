#include "cli/rest_command.h"

#include "cli/commands.h"
#include "cli/findings.h"
#include "cli/option_values.h"
#include "cli/rest_report.h"
#include "cli/terminal.h"
#include "core/output_place.h"
#include "core/publish.h"
#include "core/text_io.h"
#include <mrsim/rest.h>
#include <mrsim/solid_files.h>

#include <array>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

namespace mrsim::cli {
namespace {

constexpr const char* kRestHelp =
    "Says what is left to cut of a part: pieces with volume, thickness and place, and the largest\n"
    "tool that reaches each of them without cutting the nominal.\n\n"
    "Usage: mrsim rest PART NOMINAL [-o pieces.stl] [options]\n\n"
    "PART and NOMINAL are meshes, STEP files or .vdb stocks.\n\n"
    "Options:\n"
    "  -o, --output FILE       write the pieces as one mesh, format by extension\n"
    "  --json FILE             the pieces as JSON, - for the standard output\n"
    "  --voxel H               mm; default: longest side / 400. Pieces of a voxel or less are "
    "lost\n"
    "  --above T               leave out what is no thicker, mm; default: half a voxel\n"
    "  --deflection D          STEP: largest distance from the exact faces, mm; default: 0.001\n"
    "  --threads N             default: all cores; the result is the same for any number\n"
    "  -q, --quiet             print errors only\n"
    "  -h, --help              print this and exit\n\n"
    "Examples:\n"
    "  mrsim rest part.stl nominal.step\n"
    "  mrsim rest part.ply nominal.stl --voxel 0.1 --above 0.05 -o pieces.stl --json rest.json\n";

struct RestTyped {
  std::vector<std::string> inputs, outputs;
  std::string json, voxel, above, deflection, threads;
  bool quiet = false, help = false;
};

RestTyped typed_words(int argc, const char* const* argv) {
  RestTyped typed;
  CLI::App app;
  app.set_help_flag("");
  app.allow_extras();
  app.add_option("INPUT", typed.inputs)->expected(0, -1);
  app.add_option("-o,--output", typed.outputs)->allow_extra_args(false);
  for (const auto& [name, value] : {std::pair("--json", &typed.json),
                                    {"--voxel", &typed.voxel},
                                    {"--above", &typed.above},
                                    {"--deflection", &typed.deflection},
                                    {"--threads", &typed.threads}})
    app.add_option(name, *value);
  app.add_flag("-q,--quiet", typed.quiet);
  app.add_flag("-h,--help", typed.help);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    fail_usage(error.what());
  }
  if (typed.help) return typed;
  refuse_unknown(app);
  if (typed.inputs.size() != 2)
    fail_usage("rest takes a part and a nominal; usage: mrsim rest PART NOMINAL [-o pieces.stl]");
  return typed;
}

// All that is written, before any work.
std::vector<NamedPath> checked_outputs(const RestTyped& typed) {
  std::vector<NamedPath> outputs;
  for (const std::string& path : typed.outputs) {
    encode_mesh({}, path, [](const void*, std::size_t) {});  // refuses an unknown format
    outputs.push_back({path, "-o"});
  }
  if (!typed.json.empty()) outputs.push_back({typed.json, "--json"});
  std::vector<std::string> paths;
  for (const NamedPath& output : outputs) {
    check_writable(output.path);
    paths.push_back(output.path);
  }
  const std::array<NamedPath, 2> inputs{
      {{typed.inputs[0], "the part"}, {typed.inputs[1], "the nominal"}}};
  refuse_overwrites(outputs, inputs);
  recover_outputs(paths);
  return outputs;
}

}  // namespace

int run_rest(int argc, const char* const* argv) {
  const RestTyped typed = typed_words(argc, argv);
  if (typed.help) {
    print(kRestHelp);
    return kDone;
  }
  RestOptions options;
  if (!typed.voxel.empty()) options.voxel = positive_value("--voxel", typed.voxel);
  if (!typed.above.empty()) options.above = positive_value("--above", typed.above);
  if (!typed.threads.empty()) options.threads = threads_value("--threads", typed.threads);
  const double deflection =
      typed.deflection.empty() ? 0.001 : positive_value("--deflection", typed.deflection);
  const std::vector<NamedPath> outputs = checked_outputs(typed);
  const Rest rest = find_rest(read_solid(typed.inputs[0], deflection, options.threads),
                              read_solid(typed.inputs[1], deflection, options.threads), options);
  if (!typed.outputs.empty() && rest.pieces.empty())
    throw Error("rest-none", "nothing is left to cut, so there is no mesh to write");
  const TriMesh pieces = joined_pieces(rest);
  std::vector<OutputFile> files;
  for (const NamedPath& output : outputs)
    files.push_back({output.path, [&, path = output.path](const ByteSink& sink) {
                       if (path != typed.json) return encode_mesh(pieces, path, sink);
                       const std::string text = rest_json(rest, typed.inputs[0], typed.inputs[1]);
                       sink(text.data(), text.size());
                     }});
  write_files_atomically(files);
  if (!typed.quiet && typed.json != "-") print(rest_text(rest));
  return finish_output(kDone);
}

}  // namespace mrsim::cli
