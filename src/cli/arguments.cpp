#include "cli/arguments.h"

#include "cli/job_words.h"
#include "cli/option_values.h"
#include "core/suggest.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace mrsim::cli {
namespace {

// Options as they are typed; they become values after parsing, so that all errors read alike.
struct Typed {
  std::vector<std::string> inputs, outputs, tools_files, tools, search_path;
  std::string dialect, machine, start, block_skip, comp;
  bool least_increments = false;
  std::string until, frames, frames_by, history, rest, machine_file;
  std::vector<std::string> variables;
  std::string max_blocks, max_steps;
  bool trace_variables = false;
  std::string stock, stock_exact, stock_repair, voxel, tolerance, threads, max_memory, keep;
  std::string max_triangles;
  std::string size, azimuth, elevation, up, edges, color;
  bool quiet = false, verbose = false, strict = false, json = false, programmed = false;
  bool allow_outside = false, help = false, version = false;
  CompareTyped compare;
};

struct CommandLine {
  Command command;
  std::string_view word;
  const char* summary;
  const char* usage;
  const char* examples;
};

constexpr std::array<CommandLine, 4> kCommands = {{
    {Command::simulate, "",
     "Cuts a part out of a stock the way an NC program would, and writes its mesh.",
     "mrsim PROGRAM [--stock S] -o OUT [options]\n"
     "       mrsim job.toml          all options of a run from one file\n"
     "       mrsim trace PROGRAM     what the control understood, one motion a line\n"
     "       mrsim check PROGRAM     diagnostics only\n"
     "       mrsim compare PART NOMINAL  where the part differs from its drawing\n"
     "       mrsim rest PART NOMINAL what is left to cut, and the largest tool for it\n"
     "       mrsim view PROGRAM|PART the page that plays a run, opened\n"
     "       mrsim render PART       a picture of a mesh, without a display\n"
     "       mrsim tools FILE        the tools of a table or library",
     "Examples:\n"
     "  mrsim PRIMER_2F.MPF --stock block.stl -o part.stl\n"
     "  mrsim pocket.nc --stock box:0,0,-20,80,60,0 --tool endmill:d=10 -o part.stl\n"
     "  mrsim shaft.mpf --stock cylinder:50,0,51 --tools tools.toml --voxel 0.1 -o shaft.stl\n\n"
     "Exit: 0 done; 1 the program or a file has errors; 2 wrong usage; 3 a fault of mrsim;\n"
     "4 out of tolerance; 5 a collision under --strict; 130, 143 stopped by Ctrl-C, SIGTERM.\n"
     "Each command has its own --help. Manual: man mrsim, and docs/."},
    {Command::trace, "trace", "Prints what the control understood, one motion a line.",
     "mrsim trace PROGRAM [--json] [-o path.svg|path.html] [options]",
     "Examples:\n"
     "  mrsim trace PRIMER_2F.MPF\n"
     "  mrsim trace PRIMER_2F.MPF --json | jq .kind\n"
     "  mrsim trace PRIMER_2S.MPF -o path.svg\n"
     "  mrsim trace PRIMER_2S.MPF -q -o path.html"},
    {Command::check, "check", "Reads a program and prints its errors, warnings and notes.",
     "mrsim check PROGRAM|FOLDER|- ... [options]",
     "Examples:\n"
     "  mrsim check --json programs/ | jq 'select(.kind==\"summary\")'\n"
     "  mrsim check PRIMER_2F.MPF\n"
     "  mrsim check --strict --dialect fanuc O0001.nc"},
    {Command::render, "render",
     "Draws a mesh as a shaded picture with its edges; needs no display.",
     "mrsim render PART -o picture.png [options]\n"
     "       mrsim render PROGRAM|job.toml --frames N -o f%04d.png|film.webm [options of a run]",
     "Examples:\n"
     "  mrsim render part.stl -o part.png\n"
     "  mrsim render part.ply --nominal nominal.step --accept 0.02 -o deviation.png\n"
     "  mrsim render part.stl -o top.png --azimuth 0 --elevation 90 --size 800x600"},
}};

void add_program_options(CLI::App& app, Typed& typed) {
  const char* group = "Reading the program";
  const auto add = [&](const char* name, auto& value, const char* type, const char* text) {
    app.add_option(name, value, text)->type_name(type)->group(group);
  };
  add("--dialect", typed.dialect, "D",
      "sinumerik, iso, fanuc, codesys or ngc; default: recognised from the text");
  add("--machine", typed.machine, "M", "mill or lathe; default: recognised");
  app.add_option("--tools", typed.tools_files,
                 "tools.toml, or a library: .tbl .camotics .json .tools .fctb .fctl")
      ->type_name("FILE")
      ->group(group)
      ->allow_extra_args(false);
  app.add_option("--tool", typed.tools,
                 "one tool, such as 4=endmill:d=5 or endmill:d=10; may be repeated")
      ->type_name("T")
      ->group(group)
      ->allow_extra_args(false);
  add("--machine-file", typed.machine_file, "FILE",
      "TOML with a table [machine]: zeros for G53 and G28, rapids and accelerations for the time");
  add("--start", typed.start, "X,Y,Z", "position before the first move, mm; default: unknown");
  add("--block-skip", typed.block_skip, "N,N", "skip blocks that begin with /N (/ is /0)");
  add("--comp", typed.comp, "C",
      "radius of G41/G42 without a register: radius (the tool's), wear (none: D is wear alone) or "
      "off; default: radius, with a warning");
  app.add_flag("--least-increments", typed.least_increments,
               "FANUC: numbers without a point count 0.001 mm (0.0001 inch)")
      ->group(group);
  app.add_option("--set", typed.variables,
                 "a variable before the program starts, such as R1=5 or '#100=2'; may be repeated")
      ->type_name("V=N")
      ->group(group)
      ->allow_extra_args(false);
  add("--max-blocks", typed.max_blocks, "N", "most blocks to run; default: 4000000000");
  add("--max-steps", typed.max_steps, "N",
      "most jumps, passes of loops and calls; default: 10000000");
  app.add_option("--path", typed.search_path,
                 "also look for subprograms here, or a .DEF file of SINUMERIK; may be repeated")
      ->type_name("DIR")
      ->group(group)
      ->allow_extra_args(false);
}

void add_simulation_options(CLI::App& app, Typed& typed) {
  const auto add = [&](const char* group, const char* name, std::string& value, const char* type,
                       const char* text) {
    app.add_option(name, value, text)->type_name(type)->group(group);
  };
  add("Stock", "--stock", typed.stock, "S",
      "mesh file, box:x0,y0,z0,x1,y1,z1, cylinder:d,z0,z1 or tube:d,bore,z0,z1; default: a stock "
      "around the program's cuts");
  add("Stock", "--stock-exact", typed.stock_exact, "off",
      "off: take a mesh as it is, even where it is a box, a cylinder or a tube");
  add("Stock", "--stock-repair", typed.stock_repair, "wrap=W",
      "make a mesh with holes or crossings a solid that lies W mm beside it; gaps up to 10 W, or "
      "G with wrap=W,G, are closed");
  add("Cutting", "--voxel", typed.voxel, "H", "voxel edge, mm; default: from stock and tools");
  add("Cutting", "--tolerance", typed.tolerance, "T",
      "largest distance between mesh and exact part, mm");
  add("Cutting", "--keep", typed.keep, "K",
      "all or largest: pieces that come loose stay or are dropped; default: all, with a warning");
  add("Cutting", "--max-triangles", typed.max_triangles, "N",
      "reduce a mesh of more triangles, and measure how far that moves it");
  add("Cutting", "--until", typed.until, "WHEN",
      "end the program after line 12, line O100:7 of another file, or motion #5000");
  add("Cutting", "--frames", typed.frames, "N",
      "N parts, part-1.stl and so on, at equal shares of the machine's time");
  add("Cutting", "--frames-by", typed.frames_by, "WHAT",
      "time, or volume: the frames are equal shares of what is removed; default: time");
  add("Cutting", "--history", typed.history, "FILE",
      "what each motion, line and tool removes, with its time: .csv or .json; off: no sums in the "
      "summary");
  add("Cutting", "--rest", typed.rest, "FILE",
      "what is left to cut for the --nominal, and the largest tools that reach it: .json");
  add("Cutting", "--threads", typed.threads, "N",
      "default: all cores; the result is the same for any number");
  add("Cutting", "--max-memory", typed.max_memory, "SIZE",
      "do a run that would need more in slabs, or refuse it, such as 4G; default: what is free");
}

// `plays`: of the frames of a run, whose own options come beside these.
void add_picture_options(CLI::App& app, Typed& typed, bool plays) {
  const auto add = [&](const char* name, std::string& value, const char* type, const char* text) {
    app.add_option(name, value, text)->type_name(type)->group("Picture");
  };
  add("--size", typed.size, "WxH", "pixels; default: 1600x1200");
  add("--azimuth", typed.azimuth, "DEG",
      "view from the front, turned about the vertical; default: 30");
  add("--elevation", typed.elevation, "DEG", "view from above; default: 35");
  add("--up", typed.up, "A",
      "the axis that points up: x or z; default: x for turned parts, else z");
  add("--edges", typed.edges, "DEG", "draw edges sharper than this, 0 for none; default: 25");
  if (plays) return;
  add("--frames", typed.frames, "N", "pictures of a program's part at N moments");
  add("--threads", typed.threads, "N", "default: all cores");
}

void add_output_options(CLI::App& app, Typed& typed, Command command) {
  const char* group = "Output";
  if (command != Command::check)
    app.add_option("-o,--output", typed.outputs,
                   command == Command::simulate ? "part to write, format by extension (.stl ...); "
                                                  "may be repeated"
                   : command == Command::trace
                       ? "draw the tool path: .svg or .ply, or play it: .html"
                       : "picture to write: .png; of frames .webm, too")
        ->type_name("FILE")
        ->group(group)
        ->allow_extra_args(false);
  if (command == Command::simulate || command == Command::render)
    app.add_option("--color", typed.color,
                   "colour faces by what cut them: line, tool or none; default: none")
        ->type_name("C")
        ->group(group);
  if (command == Command::trace || command == Command::check)
    app.add_flag("--json", typed.json, "one JSON object a line")->group(group);
  if (command == Command::trace)
    app.add_flag("--programmed", typed.programmed,
                 "the contour instead of the compensated tool point")
        ->group(group);
  if (command == Command::trace)
    app.add_flag("--variables", typed.trace_variables, "show assignments as they happen")
        ->group(group);
  if (command != Command::render)
    app.add_flag("--strict", typed.strict, "warnings are errors")->group(group);
  if (command == Command::simulate)
    app.add_flag("--allow-outside", typed.allow_outside,
                 "let relative paths of a job lead out of its folder")
        ->group(group);
  app.add_flag("-q,--quiet", typed.quiet, "print errors only")->group(group);
  app.add_flag("-v,--verbose", typed.verbose, "print more")->group(group);
  app.add_flag("-h,--help", typed.help, "print this and exit")->group(group);
  app.add_flag("--version", typed.version, "print the version and exit")->group(group);
}

// One shape for all help: usage first, then groups, then examples.
class HelpFormatter : public CLI::Formatter {
 public:
  explicit HelpFormatter(const CommandLine& line) : line_(line) { column_width(26); }
  std::string make_usage(const CLI::App*, std::string) const override {
    return fmt::format("\nUsage: {}\n", line_.usage);
  }
  std::string make_positionals(const CLI::App*) const override { return ""; }
  std::string make_option(const CLI::Option* option, bool) const override {
    const std::string type = option->get_items_expected_max() > 0 ? option->get_type_name() : "";
    const std::string name =
        fmt::format("  {}{}{}", option->get_name(false, true), type.empty() ? "" : " ", type);
    return fmt::format("{:<26}{}{}\n", name, name.size() > 25 ? "\n" + std::string(26, ' ') : "",
                       wrapped(option->get_description()));
  }

 private:
  static std::string wrapped(const std::string& text) {
    std::string out;
    std::size_t column = 26, begin = 0;
    while (begin < text.size()) {
      std::size_t end = text.find(' ', begin);
      if (end == text.npos) end = text.size();
      if (column + (end - begin) > 96 && column > 26) {
        out.back() = '\n';
        out += std::string(26, ' ');
        column = 26;
      }
      out += text.substr(begin, end - begin) + " ";
      column += end - begin + 1;
      begin = end + 1;
    }
    return out.substr(0, out.find_last_not_of(' ') + 1);
  }
  const CommandLine& line_;
};

// CLI11 leaves two empty lines after each group.
std::string single_spaced(std::string text) {
  for (std::size_t at = 0; (at = text.find("\n\n\n", at)) != text.npos;) text.erase(at, 1);
  return text;
}

void read_program_options(Arguments& out, const Typed& typed) {
  if (!typed.dialect.empty()) out.interp.dialect = dialect_value(typed.dialect);
  if (!typed.machine_file.empty()) out.machine = load_machine(typed.machine_file);
  out.interp.places = out.machine.places;
  if (!typed.machine.empty()) out.interp.machine = machine_value(typed.machine);
  if (!typed.start.empty()) out.interp.start = point_value("--start", typed.start);
  if (!typed.comp.empty()) out.interp.comp = comp_value(typed.comp);
  out.interp.least_increments = typed.least_increments;
  if (!typed.block_skip.empty())
    out.interp.block_skip = skip_value("--block-skip", typed.block_skip);
  out.interp.search_path = typed.search_path;
  for (const std::string& word : typed.variables) {
    const std::size_t equal = word.find('=');
    if (equal == word.npos || equal == 0 || equal + 1 == word.size())
      fail_usage(fmt::format("--set {}: write a variable, = and its value, such as R1=5", word));
    out.interp.variables.emplace_back(word.substr(0, equal), word.substr(equal + 1));
  }
  if (!typed.max_blocks.empty())
    out.interp.max_blocks = count_value("--max-blocks", typed.max_blocks);
  if (!typed.max_steps.empty()) out.interp.max_steps = count_value("--max-steps", typed.max_steps);
  out.interp.trace_variables = typed.trace_variables;
  out.interp.programmed_contour = typed.programmed;
  ToolTable& table = out.interp.table;
  for (const std::string& spec : typed.tools) {
    table.tools.push_back(parse_tool(spec));
    const std::string& id = table.tools.back().id;
    if (std::count_if(table.tools.begin(), table.tools.end(),
                      [&](const Tool& tool) { return tool.id == id; }) > 1)
      fail_usage(fmt::format("--tool {}: this tool is given twice", spec));
  }
  for (const std::string& file : typed.tools_files) {
    std::vector<std::string> notes;
    ToolTable more = load_tools(file, &notes);
    for (const std::string& note : notes)
      if (!typed.quiet) fmt::print(stderr, "note: {}\n", note);
    const std::size_t given = table.tools.size();
    // A tool on the command line is meant to replace the one in the file.
    for (Tool& tool : more.tools) {
      const auto end = table.tools.begin() + static_cast<std::ptrdiff_t>(given);
      if (std::none_of(table.tools.begin(), end,
                       [&](const Tool& other) { return other.id == tool.id; }))
        table.tools.push_back(std::move(tool));
    }
    table.offsets.insert(table.offsets.end(), more.offsets.begin(), more.offsets.end());
    table.work.insert(table.work.end(), more.work.begin(), more.work.end());
  }
}

void read_simulation_options(Arguments& out, const Typed& typed) {
  if (!typed.stock_exact.empty())
    out.stock_options.exact_primitives = on_off_value("--stock-exact", typed.stock_exact);
  if (!typed.stock_repair.empty())
    out.stock_options.wrap = wrap_value("--stock-repair", typed.stock_repair);
  if (!typed.voxel.empty()) out.carve.voxel = positive_value("--voxel", typed.voxel);
  if (!typed.tolerance.empty()) out.mesh.tolerance = positive_value("--tolerance", typed.tolerance);
  out.until = typed.until;
  if (!typed.frames.empty()) out.frames = whole_value("--frames", typed.frames, 1, 256);
  if (out.frames > 0 && !out.until.empty()) fail_usage("--frames and --until: give one of them");
  if (!typed.frames_by.empty() && typed.frames_by != "time" && typed.frames_by != "volume")
    fail_usage(fmt::format("--frames-by is time or volume, not \"{}\"", typed.frames_by));
  out.frames_by_volume = typed.frames_by == "volume";
  if (!typed.frames_by.empty() && out.frames == 0) fail_usage("--frames-by needs --frames N");
  if (out.frames_by_volume && typed.history == "off")
    fail_usage("--frames-by volume asks the history, which --history off leaves out");
  if (!typed.history.empty() && typed.history != "off" && !typed.history.ends_with(".csv") &&
      !typed.history.ends_with(".json"))
    fail_usage(fmt::format("--history {}: a .csv or .json file, or off", typed.history));
  if (!typed.rest.empty() && !typed.rest.ends_with(".json"))
    fail_usage(fmt::format("--rest {}: a .json file", typed.rest));
  if (!typed.keep.empty()) out.keep = keep_value(typed.keep);
  if (!typed.max_triangles.empty())
    out.max_triangles = count_value("--max-triangles", typed.max_triangles);
  if (!typed.threads.empty()) {
    const int threads = threads_value("--threads", typed.threads);
    out.carve.threads = out.mesh.threads = out.render.threads = threads;
  }
  if (!typed.color.empty()) out.files.color = out.render.color = color_value(typed.color);
  if (!typed.max_memory.empty())
    out.carve.max_memory = size_value("--max-memory", typed.max_memory);
}

void read_picture_options(Arguments& out, const Typed& typed) {
  if (!typed.size.empty()) {
    const std::size_t cross = typed.size.find('x');
    if (cross == typed.size.npos) fail_usage("--size must be WIDTHxHEIGHT, such as 1600x1200");
    out.render.width = whole_value("--size", typed.size.substr(0, cross), 16, 8192);
    out.render.height = whole_value("--size", typed.size.substr(cross + 1), 16, 8192);
  }
  if (!typed.azimuth.empty()) out.render.azimuth = number_value("--azimuth", typed.azimuth);
  if (!typed.elevation.empty()) out.render.elevation = number_value("--elevation", typed.elevation);
  if (!typed.up.empty()) out.render.up = up_value(typed.up);
  if (!typed.edges.empty()) out.render.edge_angle = number_value("--edges", typed.edges);
}

void read_input(Arguments& out, const Typed& typed, const CommandLine& line) {
  const bool render = line.command == Command::render;
  if (typed.inputs.empty() || typed.inputs[0].empty())
    fail_usage(fmt::format(
        "{} is missing; usage: {}", render ? "the part" : "the program",
        std::string_view(line.usage).substr(0, std::string_view(line.usage).find('\n'))));
  if (typed.inputs.size() > 1 && line.command != Command::check)
    fail_usage(fmt::format("one input file is enough: \"{}\" is not expected", typed.inputs[1]));
  if (is_job(typed.inputs) && (!render || !typed.frames.empty()))
    fail_usage(
        fmt::format("{} takes a program; a job is run with: mrsim {}", line.word, typed.inputs[0]));
  out.inputs = typed.inputs;
  if (render && out.outputs.size() != 1) fail_usage("render needs one output: -o picture.png");
  if (!typed.frames.empty() && out.outputs.empty())
    fail_usage("--frames numbers the outputs: -o part.stl");
  if (line.command == Command::trace && out.outputs.size() > 1)
    fail_usage("trace draws one picture: -o path.svg");
}

// All files of the command line, before anything that is typed may be wrong.
void read_files(Arguments& out, const Typed& typed) {
  if (!typed.inputs.empty()) out.input = typed.inputs[0];
  out.stock = typed.stock;
  out.outputs = typed.outputs;
  out.history = typed.history;
  out.rest = typed.rest;
  out.compare.json = typed.compare.json;
  out.compare.junit = typed.compare.junit;
  out.compare.report = typed.compare.report;
  out.compare.deviation = typed.compare.deviation;
  for (const std::string& file : typed.tools_files) out.named_inputs.push_back({file, "--tools"});
  if (!typed.machine_file.empty())
    out.named_inputs.push_back({typed.machine_file, "--machine-file"});
  if (!typed.compare.nominal.empty())
    out.named_inputs.push_back({typed.compare.nominal, "--nominal"});
}

void read_values(Arguments& out, const Typed& typed) {
  out.quiet = typed.quiet;
  out.verbose = typed.verbose;
  out.strict = typed.strict;
  out.json = typed.json;
  read_simulation_options(out, typed);
  read_picture_options(out, typed);
  out.compare = compare_request(typed.compare);
  if (out.compare.options.accept && out.compare.nominal.empty())
    fail_usage("--accept judges against a nominal: --nominal part.step");
  if (out.compare.nominal.empty())
    for (const auto& [value, option] : {std::pair(typed.rest, "--rest"),
                                        {typed.compare.deviation, "--deviation"},
                                        {typed.compare.align, "--align"},
                                        {typed.compare.density, "--density"},
                                        {typed.compare.deflection, "--deflection"},
                                        {typed.compare.colors, "--colors"}})
      if (!value.empty())
        fail_usage(fmt::format("{} needs a nominal to compare with: --nominal part.step", option));
  read_program_options(out, typed);
}

Arguments parse_command(const CommandLine& line, int argc, const char* const* argv,
                        Arguments* refused);

// The words of the file are read like typed ones; it names a program, so this goes one deep.
Arguments parse_job_command(const CommandLine& line, const std::string& path, int argc,
                            const char* const* argv, Arguments* refused) {
  const std::vector<std::string> words =
      job_words(path, argc, argv, line.command == Command::render ? JobUse::pictures : JobUse::run);
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  Arguments out = parse_command(line, static_cast<int>(pointers.size()), pointers.data(), refused);
  out.named_inputs.push_back({path, "the job"});
  return out;
}

Arguments parse_command(const CommandLine& line, int argc, const char* const* argv,
                        Arguments* refused) {
  Typed typed;
  CLI::App app(line.summary);
  app.set_help_flag("");
  app.allow_extras();
  app.formatter(std::make_shared<HelpFormatter>(line));
  app.footer("\n" + std::string(line.examples));
  app.add_option("INPUT", typed.inputs)->expected(0, -1)->group("");
  if (line.command == Command::simulate) {
    add_simulation_options(app, typed);
    add_compare_options(app, typed.compare, CompareUse::run);
  }
  const bool plays =
      line.command == Command::render && std::any_of(argv, argv + argc, [](std::string_view word) {
        return word.starts_with("--frames");
      });
  if (plays) add_simulation_options(app, typed);
  if (plays || line.command != Command::render) add_program_options(app, typed);
  if (line.command == Command::render) add_picture_options(app, typed, plays);
  if (line.command == Command::render && !plays)
    add_compare_options(app, typed.compare, CompareUse::picture);
  add_output_options(app, typed, line.command);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    fail_usage(error.what());
  }
  Arguments out;
  out.command = typed.help ? Command::help : typed.version ? Command::version : line.command;
  if (typed.help) out.help = single_spaced(app.help());
  if (typed.help || typed.version) return out;
  read_files(out, typed);
  if (refused != nullptr) *refused = out;
  refuse_unknown(app);
  if ((line.command == Command::simulate || plays) && is_job(typed.inputs))
    return parse_job_command(line, typed.inputs[0], argc, argv, refused);
  read_input(out, typed, line);
  read_values(out, typed);
  return out;
}

}  // namespace

Arguments parse_arguments(int argc, const char* const* argv, Arguments* refused) {
  const std::string_view first = argc > 1 ? argv[1] : "--help";
  const bool ask_help = argc < 2 || first == "help";
  for (const CommandLine& line : kCommands)
    if (!line.word.empty() && first == line.word)
      return parse_command(line, argc - 1, argv + 1, refused);
  if (ask_help) {
    const char* words[] = {"mrsim", "--help"};
    return parse_command(kCommands[0], 2, words, refused);
  }
  return parse_command(kCommands[0], argc, argv, refused);
}

}  // namespace mrsim::cli
