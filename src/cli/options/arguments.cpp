#include "cli/options/arguments.h"

#include "cli/console/standard_streams.h"
#include "cli/options/idle_options.h"
#include "cli/options/option_values.h"
#include "cli/options/typed_options.h"
#include "core/words/option_table.h"
#include "core/words/tool_number.h"
#include <mrsim/job_file.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace mrsim::cli {
namespace {

// Pictures of a job's run leave out what it says of files and of a comparison.
enum class JobUse { run, pictures };

// Before parsing: "--voxel 1" and "--voxel=1", "-o x" and "-ox".
bool is_typed(const std::string& option, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (word == option || word.starts_with(option + "=")) return true;
    if (option == "--output" && word.starts_with("-o")) return true;
  }
  return false;
}

JobPlaces places_of(const JobFile& job, const std::string& path,
                    const std::vector<std::string>& typed) {
  JobPlaces out{path, job.options};
  std::erase_if(out.options, [&](const JobOption& o) { return is_typed(o.option, typed); });
  out.options.push_back({"", {job.program}, job.line, job.column});
  return out;
}

// Pictures of a run take its options, but for its files and the moments of its parts.
bool is_for_pictures(const std::string& option) {
  static constexpr std::array<std::string_view, 5> kOthers = {"--output", "--frames", "--until",
                                                              "--history", "--rest"};
  return find_option(option, kUseFilm) != nullptr &&
         std::find(kOthers.begin(), kOthers.end(), option) == kOthers.end();
}

// Whether the input of a run is a job and not a program.
bool is_job(const std::vector<std::string>& inputs) {
  if (inputs.size() != 1) return false;
  const std::string extension = std::filesystem::path(inputs[0]).extension().string();
  return extension == ".toml" || extension == ".camotics";
}

// The command line that means the same as job.toml and the options typed beside it; the first word
// is argv[0]. A typed option replaces all that the file says of that option.
std::vector<std::string> job_words(const JobFile& job, const std::string& path, JobUse use,
                                   const std::string& name, const std::vector<std::string>& typed) {
  std::vector<std::string> words = {name, job.program};
  for (const JobOption& option : job.options) {
    if (is_typed(option.option, typed)) continue;
    if (use == JobUse::pictures && !is_for_pictures(option.option)) continue;
    if (option.values.empty()) words.push_back(option.option);
    for (const std::string& value : option.values) words.push_back(option.option + "=" + value);
  }
  bool dropped = false;  // the job itself gives way to its program
  for (const std::string& word : typed)
    if (dropped || word != path)
      words.push_back(word);
    else
      dropped = true;
  return words;
}

void read_variables(Arguments& out, const TypedOptions& typed) {
  for (const std::string& word : typed.texts("--set")) {
    const std::size_t equal = word.find('=');
    if (equal == word.npos || equal == 0 || equal + 1 == word.size())
      fail_usage(fmt::format("--set {}: write a variable, = and its value, such as R1=5", word));
    out.interp.variables.emplace_back(word.substr(0, equal), word.substr(equal + 1));
  }
}

void add_typed_tool(ToolTable& table, const std::string& spec) {
  table.tools.push_back(parse_tool(spec));
  const std::string_view id = tool_number(table.tools.back().id);
  if (std::count_if(table.tools.begin(), table.tools.end(),
                    [&](const Tool& tool) { return tool_number(tool.id) == id; }) > 1)
    fail_usage(fmt::format("--tool {}: this tool is given twice", spec));
}

// Adds the tools and offsets of a file. A tool that the table has already, from the command line or
// an earlier file, is meant to replace the one in this file.
void add_tools_of_file(ToolTable& table, const std::string& file, bool quiet) {
  std::vector<std::string> notes;
  ToolTable more = load_tools(file, &notes);
  for (const std::string& note : notes)
    if (!quiet) say("note: " + note + "\n");
  const std::size_t given = table.tools.size();
  for (Tool& tool : more.tools) {
    const auto end = table.tools.begin() + static_cast<std::ptrdiff_t>(given);
    if (std::none_of(table.tools.begin(), end, [&](const Tool& other) {
          return tool_number(other.id) == tool_number(tool.id);
        }))
      table.tools.push_back(std::move(tool));
  }
  table.offsets.insert(table.offsets.end(), more.offsets.begin(), more.offsets.end());
  table.work.insert(table.work.end(), more.work.begin(), more.work.end());
}

void read_program_options(Arguments& out, const TypedOptions& typed) {
  out.carve.max_memory = limit_memory(typed);  // of the tables of tools, too
  typed.read("--dialect", out.interp.dialect, dialect_value);
  if (typed.has("--machine-file")) out.machine = load_machine(typed.text("--machine-file"));
  out.interp.places = out.machine.places;
  out.interp.machine = out.machine.kind;
  typed.read("--machine", out.interp.machine, machine_value);
  typed.read("--start", out.interp.start, point_value);
  typed.read("--comp", out.interp.comp, comp_value);
  out.interp.least_increments = typed.flag("--least-increments");
  typed.read("--block-skip", out.interp.block_skip, skip_value);
  out.interp.search_path = existing_paths("--path", typed.texts("--path"));
  read_variables(out, typed);
  typed.read("--max-blocks", out.interp.max_blocks, count_value);
  typed.read("--max-steps", out.interp.max_steps, count_value);
  out.interp.trace_variables = typed.flag("--variables");
  out.interp.programmed_contour = typed.flag("--programmed");
  ToolTable& table = out.interp.table;
  for (const std::string& spec : typed.texts("--tool")) add_typed_tool(table, spec);
  for (const std::string& file : typed.texts("--tools"))
    add_tools_of_file(table, file, typed.flag("--quiet"));
}

void read_simulation_options(Arguments& out, const TypedOptions& typed) {
  typed.read("--stock-exact", out.stock_options.exact_primitives, on_off_value);
  typed.read("--stock-repair", out.stock_options.wrap, wrap_value);
  typed.read("--voxel", out.carve.voxel, positive_value);
  typed.read("--tolerance", out.mesh.tolerance, positive_value);
  out.until = typed.text("--until");
  typed.read("--frames", out.frames, frames_value);
  if (out.frames > 0 && !out.until.empty()) fail_usage("--frames and --until: give one of them");
  const std::string& shares = typed.text("--frames-by");
  if (!shares.empty() && shares != "time" && shares != "volume")
    fail_usage(fmt::format("--frames-by is time or volume, not \"{}\"", shares));
  out.frames_by_volume = shares == "volume";
  if (!shares.empty() && out.frames == 0) fail_usage("--frames-by needs --frames N");
  const std::string& history = typed.text("--history");
  if (out.frames_by_volume && history == "off")
    fail_usage("--frames-by volume asks the history, which --history off leaves out");
  if (!history.empty() && history != "off" && !history.ends_with(".csv") &&
      !history.ends_with(".json"))
    fail_usage(fmt::format("--history {}: a .csv or .json file, or off", history));
  if (typed.has("--rest") && !typed.text("--rest").ends_with(".json"))
    fail_usage(fmt::format("--rest {}: a .json file", typed.text("--rest")));
  typed.read("--keep", out.keep, keep_value);
  typed.read("--max-triangles", out.max_triangles, count_value);
  typed.read("--threads", out.carve.threads, threads_value);
  out.mesh.threads = out.render.threads = out.carve.threads;
  typed.read("--color", out.files.color, color_value);
  out.render.color = out.files.color;
}

void read_picture_options(Arguments& out, const TypedOptions& typed) {
  if (const std::string& size = typed.text("--size"); !size.empty()) {
    const std::size_t cross = size.find('x');
    if (cross == size.npos) fail_usage("--size must be WIDTHxHEIGHT, such as 1600x1200");
    out.render.width = whole_value("--size", size.substr(0, cross), 16, 8192);
    out.render.height = whole_value("--size", size.substr(cross + 1), 16, 8192);
  }
  typed.read("--azimuth", out.render.azimuth, number_value);
  typed.read("--elevation", out.render.elevation, number_value);
  typed.read("--up", out.render.up, up_value);
  typed.read("--edges", out.render.edge_angle, number_value);
}

void read_input(Arguments& out, const TypedOptions& typed, const CommandLine& line) {
  const bool render = (line.uses & (kUseRender | kUseFilm)) != 0;
  if (typed.inputs().empty() || typed.inputs()[0].empty())
    fail_usage(fmt::format(
        "{} is missing; usage: {}", render ? "the part" : "the program",
        std::string_view(line.usage).substr(0, std::string_view(line.usage).find('\n'))));
  if (typed.inputs().size() > 1 && line.uses != kUseCheck)
    fail_usage(fmt::format("one input file is enough: \"{}\" is not expected", typed.inputs()[1]));
  if (is_job(typed.inputs()) && line.uses != kUseRender)
    fail_usage(fmt::format("{} takes a program; a job is run with: mrsim {}", line.word,
                           typed.inputs()[0]));
  out.inputs = typed.inputs();
  if (render && out.outputs.size() != 1) fail_usage("render needs one output: -o picture.png");
  if (typed.has("--frames") && out.outputs.empty())
    fail_usage("--frames numbers the outputs: -o part.stl");
  if (line.uses == kUseTrace && out.outputs.size() > 1)
    fail_usage("trace draws one picture: -o path.svg");
}

// All files of the command line, before anything that is typed may be wrong.
void read_files(Arguments& out, const TypedOptions& typed) {
  if (!typed.inputs().empty()) out.input = typed.inputs()[0];
  out.stock = typed.text("--stock");
  out.outputs = typed.texts("--output");
  out.history = typed.text("--history");
  out.rest = typed.text("--rest");
  out.json = typed.flag("--json");
  out.compare = named_request(typed);
  for (const std::string& file : typed.texts("--tools"))
    out.named_inputs.push_back({file, "--tools"});
  if (typed.has("--machine-file"))
    out.named_inputs.push_back({typed.text("--machine-file"), "--machine-file"});
  if (typed.has("--nominal")) out.named_inputs.push_back({typed.text("--nominal"), "--nominal"});
}

void read_values(Arguments& out, const TypedOptions& typed) {
  out.quiet = typed.flag("--quiet");
  out.verbose = typed.flag("--verbose");
  out.strict = typed.flag("--strict");
  read_simulation_options(out, typed);
  read_picture_options(out, typed);
  out.compare = compare_request(typed);
  if (out.compare.options.accept && out.compare.nominal.empty())
    fail_usage("--accept judges against a nominal: --nominal part.step");
  if (out.compare.nominal.empty())
    for (const char* option :
         {"--rest", "--deviation", "--align", "--density", "--deflection", "--colors"})
      if (typed.has(option))
        fail_usage(fmt::format("{} needs a nominal to compare with: --nominal part.step", option));
  read_program_options(out, typed);
}

Command command_of(OptionUse use) {
  switch (use) {
    case kUseTrace:
      return Command::trace;
    case kUseCheck:
      return Command::check;
    case kUseRender:
    case kUseFilm:
      return Command::render;
    default:
      return Command::simulate;
  }
}

Arguments parse_command(const CommandLine& line, int argc, const char* const* argv,
                        Arguments* refused);

// The words of the file are read like typed ones; it names a program, so this goes one deep.
Arguments parse_job_command(const CommandLine& line, const std::string& path, int argc,
                            const char* const* argv, Arguments* refused) {
  const std::vector<std::string> typed(argv + 1, argv + argc);
  const bool outside = std::find(typed.begin(), typed.end(), "--allow-outside") != typed.end();
  const JobFile job = load_job(path, outside);
  const JobUse use = line.uses == kUseFilm ? JobUse::pictures : JobUse::run;
  const std::vector<std::string> words = job_words(job, path, use, argv[0], typed);
  std::vector<const char*> pointers;
  pointers.reserve(words.size());
  for (const std::string& word : words) pointers.push_back(word.c_str());
  try {
    Arguments out =
        parse_command(line, static_cast<int>(pointers.size()), pointers.data(), refused);
    out.named_inputs.push_back({path, "the job"});
    out.job = places_of(job, path, typed);
    return out;
  } catch (const PlacedError&) {
    throw;
  } catch (const Error& fault) {
    show_in_job(fault, places_of(job, path, typed));
    throw;
  }
}

Arguments parse_command(const CommandLine& line, int argc, const char* const* argv,
                        Arguments* refused) {
  const TypedOptions typed(line, argc, argv);
  Arguments out;
  out.help = typed.help();
  out.command = typed.flag("--help")      ? Command::help
                : typed.flag("--version") ? Command::version
                                          : command_of(line.uses);
  if (out.command == Command::help || out.command == Command::version) return out;
  read_files(out, typed);
  if (refused != nullptr) *refused = out;
  typed.refuse_unknown();
  if ((line.uses == kUseRun || line.uses == kUseFilm) && is_job(typed.inputs()))
    return parse_job_command(line, typed.inputs()[0], argc, argv, refused);
  read_input(out, typed, line);
  read_values(out, typed);
  tell_idle_options(line, typed);
  return out;
}

// Pictures of a run take other options than the picture of a mesh.
OptionUse render_use(int argc, const char* const* argv) {
  const bool film = std::any_of(argv, argv + argc,
                                [](std::string_view word) { return word.starts_with("--frames"); });
  return film ? kUseFilm : kUseRender;
}

}  // namespace

Arguments parse_arguments(int argc, const char* const* argv, Arguments* refused) {
  const std::string_view first = argc > 1 ? argv[1] : "help";
  const char* const help[] = {"mrsim", "--help"};
  if (first == "help") return parse_command(command_line(kUseRun), 2, help, refused);
  if (first == "render")
    return parse_command(command_line(render_use(argc, argv)), argc - 1, argv + 1, refused);
  for (const OptionUse use : {kUseTrace, kUseCheck})
    if (first == command_line(use).word)
      return parse_command(command_line(use), argc - 1, argv + 1, refused);
  return parse_command(command_line(kUseRun), argc, argv, refused);
}

}  // namespace mrsim::cli
