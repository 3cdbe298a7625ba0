#include "cli/commands/commands.h"
#include "cli/console/standard_streams.h"
#include "cli/console/temporary_place.h"
#include "cli/console/terminal.h"
#include "cli/options/option_values.h"
#include "cli/options/typed_options.h"
#include "core/process/child_process.h"
#include "core/text/ascii.h"
#include "core/text/text_io.h"
#include <mrsim/report_html.h>
#include <mrsim/solid_files.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace mrsim::cli {
namespace {

bool is_part(const std::string& path) {
  static constexpr std::array<std::string_view, 9> kEndings = {
      ".stl", ".ply", ".obj", ".off", ".glb", ".3mf", ".step", ".stp", ".vdb"};
  return std::find(kEndings.begin(), kEndings.end(), extension_of(path)) != kEndings.end();
}

void open_page(const std::string& path) {
  if (start_program({"xdg-open", path}, ProgramLife::own) < 0)
    say("xdg-open is missing: open the page with a browser\n");
}

void write_part_page(const std::string& part, const std::string& page) {
  const TriMesh mesh = read_solid(part);
  ReportFacts facts;
  facts.title = std::filesystem::path(part).filename().string();
  Comparison shown;
  shown.part_name = part;
  shown.origin = mesh.origin;
  shown.text = read_program_lines(mesh.origin, part);
  const std::string html = report_html(mesh, {}, shown, facts);
  write_file_atomically(page, [&](const ByteSink& sink) { sink(html.data(), html.size()); });
}

Arguments run_arguments(const std::vector<const char*>& words) {
  Arguments arguments = typed_arguments(static_cast<int>(words.size()), words.data());
  if (arguments.command != Command::simulate || arguments.frames > 0)
    fail_usage("view takes a program, a job or a part and the options of a run without --frames");
  return arguments;
}

// Where the standard output is for JSON, the name is a message.
void tell_page(const std::string& page, const CompareRequest& told) {
  if (told.json == "-" || told.junit == "-")
    say(page + "\n");
  else
    print(page + "\n");
}

int show(const std::string& page, bool opens, int code, const CompareRequest& told = {}) {
  tell_page(page, told);
  if (opens) open_page(page);
  return finish_output(code);
}

// A page whose name reaches nobody is of no use to anybody, unless it is opened.
int show(TemporaryPlace& page, bool opens, int code, const CompareRequest& told = {}) {
  if (opens) page.keep();
  show(page.path(), opens, code, told);
  page.keep();
  return code;
}

// `words`: "mrsim" and what was typed after "view".
int view_run(const std::vector<const char*>& words, bool opens) {
  Arguments arguments = run_arguments(words);
  if (!arguments.compare.report.empty()) {
    const int code = run_simulate(arguments);
    const bool is_there = code == kDone || code == kRejected;
    return is_there ? show(arguments.compare.report, opens, code, arguments.compare) : code;
  }
  TemporaryPlace page(TemporaryPlace::Kind::page);
  arguments.compare.report = page.path();
  const int code = run_simulate(arguments);
  if (code != kDone && code != kRejected) return code;
  return show(page, opens, code, arguments.compare);
}

// A part takes what bounds its memory, and no options of a run.
int view_part(const std::vector<const char*>& words, bool opens) {
  const std::string part = words[1];
  const TypedOptions typed(command_line(kUseView), static_cast<int>(words.size()), words.data());
  if (!typed.is_known() || typed.inputs().size() > 1 || typed.has("--report"))
    fail_usage(fmt::format("view {}: a part takes no options of a run but --max-memory", part));
  limit_memory(typed);
  TemporaryPlace page(TemporaryPlace::Kind::page);
  write_part_page(part, page.path());
  return show(page, opens, kDone);
}

}  // namespace

int run_view(int argc, const char* const* argv) {
  std::vector<const char*> words{"mrsim"};
  bool opens = true;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--help" || word == "-h") {
      const char* const asked[] = {"view", "--help"};
      print(TypedOptions(command_line(kUseView), 2, asked).help());
      return finish_output(kDone);
    }
    if (word == "--no-open")
      opens = false;
    else
      words.push_back(argv[i]);
  }
  if (words.size() < 2) fail_usage("view takes a program, a job or a part");
  if (!is_part(words[1])) return view_run(words, opens);
  return view_part(words, opens);
}

}  // namespace mrsim::cli
