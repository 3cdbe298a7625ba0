#include "core/words/option_table.h"

#include <algorithm>
#include <array>

namespace mrsim {
namespace {

using enum OptionGroup;
using V = OptionValue;

constexpr unsigned kRuns = kUseRun | kUseFilm;
constexpr unsigned kPrograms = kRuns | kUseTrace | kUseCheck;
constexpr unsigned kPictures = kUseRender | kUseFilm;
constexpr unsigned kJudged = kUseRun | kUseCompare;
constexpr unsigned kOfRun = kPrograms | kUseRender;

constexpr std::string_view kRefuseMore =
    "refuse what would need more, such as 4G; default: what is free";

constexpr OptionRow kRows[] = {
    {"--stock", "", kRuns, stock, V::stock, "S",
     "mesh file, box:x0,y0,z0,x1,y1,z1, cylinder:d,z0,z1 or tube:d,bore,z0,z1; default: the "
     "one that the program states, or one around its cuts",
     "stock", "box: cylinder: tube:",
     "A closed mesh, or box:x0,y0,z0,x1,y1,z1, cylinder:d,z0,z1, tube:d,bore,z0,z1. Without it, "
     "the stock that the program states (WORKPIECE, comments of Carbide Create and Vectric), else "
     "one around its cuts, which is reported."},
    {"--stock-exact", "", kRuns, stock, V::on_off, "off",
     "off: take a mesh as it is, even where it is a box, a cylinder or a tube", "stock_exact",
     "on off"},
    {"--stock-repair", "", kRuns, stock, V::text, "wrap=W",
     "make a mesh with holes or crossings a solid that lies W mm beside it; gaps up to 10 W, or "
     "G with wrap=W,G, are closed",
     "stock_repair", "wrap=",
     "Wraps a stock's mesh that has holes or crosses itself: a solid that lies at most about W mm "
     "beside it, with gaps up to 10 W mm, or up to G with wrap=W,G, closed. How far it lies from "
     "the surface is measured and told."},

    {"--voxel", "", kRuns, cutting, V::number, "H", "voxel edge, mm; default: from stock and tools",
     "voxel", "",
     "Voxel edge in mm. Default: the stock's longest side / 400, at most an eighth of the smallest "
     "cutter radius, rounded down in the series 1, 2, 2.5, 5."},
    {"--tolerance", "", kRuns, cutting, V::number, "T",
     "largest distance between mesh and exact part, mm", "tolerance"},
    {"--keep", "", kRuns, cutting, V::choice, "K",
     "all or largest: pieces that come loose stay or are dropped; default: all, with a warning",
     "keep", "all largest",
     "all (default) or largest: pieces that the program cuts loose stay in the part, with a "
     "warning that tells their volume and place, or are dropped but for the largest, with a note."},
    {"--max-triangles", "", kRuns, cutting, V::number, "N",
     "reduce a mesh of more triangles, and measure how far that moves it", "max_triangles", "",
     "A mesh of more triangles is reduced to N; how far that moves its surface is measured and "
     "printed. The mesh stays closed, oriented, 2-manifold and free of crossings; a number that "
     "does not allow that is refused with one that does."},
    {"--until", "", kRuns, cutting, V::text, "WHEN",
     "end the program after line 12, line O100:7 of another file, or motion #5000", "until"},
    {"--frames", "", kRuns, cutting, V::whole, "N",
     "N parts, part-1.stl and so on, at equal shares of the machine's time", "frames", "",
     "N parts, numbered (part-1.stl and so on), at equal shares of the machine's time; the last is "
     "the finished part. Each is the part of a program that ends there. render: N pictures."},
    {"--frames-by", "", kRuns, cutting, V::choice, "WHAT",
     "time, or volume: the frames are equal shares of what is removed; default: time", "frames_by",
     "time volume"},
    {"--history", "", kRuns, cutting, V::path_or_off, "FILE",
     "what each motion, line and tool removes, with its time: .csv or .json; off: no sums in the "
     "summary",
     "history", "off",
     "What each motion, line and tool removes, with its time, rate, share of air, depth, width and "
     "angle of engagement, to a .csv or .json file, by the voxels of the run. off leaves the sums "
     "by tool out of the summary."},
    {"--rest", "", kRuns, cutting, V::path, "FILE",
     "what is left to cut for the --nominal, and the largest tools that reach it: .json", "rest",
     "",
     "What is left to cut for the --nominal, piece by piece, and the largest tools that reach it, "
     "to a .json file."},
    {"--threads", "", kRuns, cutting, V::whole, "N",
     "default: all cores; the result is the same for any number", "threads", "",
     "Default: all cores. The result is the same to the last bit for any number."},
    {"--max-memory", "", kRuns, cutting, V::text, "SIZE",
     "do a run that would need more in slabs, or refuse it, such as 4G; default: what is free",
     "max_memory", "",
     "A run that would need more, such as 4G, is done in slabs, with the same files: for a grid "
     "(--voxel without --tolerance) and .stl, .ply, .obj, .off and .3mf. Else it is refused, with "
     "a tolerance once the cells of the mesh are known. Default: what is free."},

    {"--nominal", "", kUseRun, comparison, V::path, "N",
     "compare the part with this mesh or STEP file", "nominal"},
    {"--nominal", "", kUseRender, comparison, V::path, "N",
     "colour by the deviation from this mesh or STEP file"},
    {"--accept", "", kJudged, comparison, V::numbers, "T",
     "tolerance of the part, T or LO,HI in mm: gives the verdict and the exit code", "accept", "",
     "Tolerance of the part, T or LO,HI in mm: exit 4 where a deviation is outside. render: what "
     "is green."},
    {"--accept", "", kUseRender, comparison, V::numbers, "T",
     "tolerance of the part, T or LO,HI in mm: what is green; default: 0.02"},
    {"--align", "", kJudged | kUseRender, comparison, V::choice, "A",
     "none, bbox or icp: move the part onto the nominal first", "align", "none bbox icp"},
    {"--voxel", "", kUseRest, comparison, V::number, "H",
     "mm; default: longest side / 400. Pieces of a voxel or less are lost"},
    {"--above", "", kUseRest, comparison, V::number, "T",
     "leave out what is no thicker, mm; default: half a voxel", "", "",
     "rest: leave out what is no thicker, mm; default: half a voxel."},
    {"--deflection", "", kJudged | kUseRender, comparison, V::number, "D",
     "STEP: largest distance from the exact faces, mm; default: a twentieth of the tolerance",
     "deflection"},
    {"--deflection", "", kUseRest, comparison, V::number, "D",
     "STEP: largest distance from the exact faces, mm; default: 0.001"},
    {"--colors", "", kJudged | kUseRender, comparison, V::choice, "C",
     "standard, or safe for every kind of colour vision", "colors", "standard safe"},
    {"--density", "", kJudged, comparison, V::number, "N",
     "samples per mm2; default: 200 000 on each surface", "density"},
    {"--report", "", kJudged, comparison, V::path, "FILE", "self-contained HTML page", "report"},
    {"--json", "", kUseRun, comparison, V::path, "FILE",
     "what the run did, comparison included, as JSON; - for the standard output", "json", "",
     "compare: the comparison as JSON; rest: the pieces; a run: all that the run did, comparison "
     "included, written also when it fails (docs/schema); - for the standard output. trace, check "
     "and tools take no FILE and print one JSON object a line."},
    {"--json", "", kUseCompare, comparison, V::path, "FILE",
     "comparison as JSON, - for the standard output"},
    {"--junit", "", kUseRun, comparison, V::path, "FILE", "the same as JUnit XML", "junit", "",
     "Verdict and regions as JUnit XML."},
    {"--junit", "", kUseCompare, comparison, V::path, "FILE", "verdict and regions as JUnit XML"},
    {"--deviation", "", kUseRun, comparison, V::path, "FILE",
     "part coloured by deviation: .ply or .glb", "deviation", "",
     "Part coloured by deviation: .ply or .glb (in compare: -o)."},
    {"--path", "", kUseCompare, comparison, V::folders, "DIR",
     "look for the programs here; may be repeated"},
    {"--threads", "", kUseCompare | kUseRest, comparison, V::whole, "N",
     "default: all cores; the result is the same for any number"},
    {"--max-memory", "", kUseCompare | kUseRest, comparison, V::text, "SIZE", kRefuseMore},

    {"--dialect", "", kPrograms, program, V::choice, "D",
     "sinumerik, iso, fanuc, codesys or ngc; default: recognised from the text", "dialect",
     "sinumerik iso fanuc codesys ngc auto",
     "sinumerik, iso, fanuc, codesys or ngc. Default: recognised from the text, with the reason "
     "reported."},
    {"--machine", "", kPrograms, program, V::choice, "M", "mill or lathe; default: recognised",
     "machine", "mill lathe auto",
     "mill or lathe. Default: recognised; where the program does not tell, the run ends and asks."},
    {"--tools", "", kPrograms, program, V::paths, "FILE",
     "tools.toml, or a library: .tbl .camotics .json .tools .fctb .fctl", "tools", "",
     "Tools, registers and work offsets: tools.toml (docs/tools.md), or a library of another "
     "program (.tbl .camotics .json .tools .fctb .fctl); may be repeated."},
    {"--tool", "", kPrograms, program, V::texts, "T",
     "one tool, such as 4=endmill:d=5 or endmill:d=10; may be repeated", "tool", "",
     "One tool: 4=endmill:d=5, or endmill:d=10 for the tool of a program that names none. Keys: d "
     "diameter, r corner or nose radius, l flute or edge length, a angle, and all names of "
     "tools.toml. It replaces a tool of the same number in --tools. May be repeated."},
    {"--machine-file", "", kPrograms, program, V::path, "FILE",
     "TOML with a table [machine]: zeros for G53 and G28, rapids and accelerations for the time",
     "machine_file"},
    {"--start", "", kPrograms, program, V::numbers, "X,Y,Z",
     "position before the first move, mm; default: unknown", "start", "",
     "Position before the first move, mm. Without it, moves whose start is not known cut nothing."},
    {"--block-skip", "", kPrograms, program, V::numbers, "N,N",
     "skip blocks that begin with /N (/ is /0)", "block_skip"},
    {"--comp", "", kPrograms, program, V::choice, "C",
     "radius of G41/G42 without a register: radius (the tool's), wear (none: D is wear alone) or "
     "off; default: radius, with a warning",
     "comp", "auto radius wear off",
     "What G41 and G42 offset by where the D register is not in the tool table: radius (the "
     "tool's; the default, with a warning), wear (nothing: the program holds the path of the "
     "tool's centre) or off (nothing, whatever the table says)."},
    {"--least-increments", "", kPrograms, program, V::flag, "",
     "FANUC: numbers without a point count 0.001 mm (0.0001 inch)", "least_increments"},
    {"--set", "", kPrograms, program, V::texts, "V=N",
     "a variable before the program starts, such as R1=5 or '#100=2'; may be repeated",
     "variables"},
    {"--max-blocks", "", kPrograms, program, V::number, "N",
     "most blocks to run; default: 4000000000", "max_blocks", "",
     "Most blocks to run; more is an error. Default: 4000000000."},
    {"--max-steps", "", kPrograms, program, V::number, "N",
     "most jumps, calls, and passes of loops with motions; default: 10000000", "max_steps", "",
     "Most jumps, calls, passes of loops with their motions, and motions of cycles in programs "
     "that "
     "have them; more is an error. Default: 10000000."},
    {"--path", "", kPrograms, program, V::folders, "DIR",
     "also look for subprograms here, or a .DEF file of SINUMERIK; may be repeated", "path"},
    {"--max-memory", "", kUseTrace | kUseCheck, program, V::text, "SIZE", kRefuseMore},

    {"--size", "", kPictures, picture, V::text, "WxH", "pixels; default: 1600x1200"},
    {"--azimuth", "", kPictures, picture, V::text, "DEG",
     "view from the front, turned about the vertical; default: 30"},
    {"--elevation", "", kPictures, picture, V::text, "DEG", "view from above; default: 35"},
    {"--up", "", kPictures, picture, V::choice, "A",
     "the axis that points up: x or z; default: x for turned parts, else z", "", "x z"},
    {"--edges", "", kPictures, picture, V::text, "DEG",
     "draw edges sharper than this, 0 for none; default: 25"},
    {"--frames", "", kUseRender, picture, V::whole, "N",
     "pictures of a program's part at N moments"},
    {"--threads", "", kUseRender, picture, V::whole, "N", "default: all cores"},
    {"--max-memory", "", kUseRender, picture, V::text, "SIZE", kRefuseMore},

    {"--output", "-o", kUseRun, output, V::paths, "FILE",
     "part to write, format by extension (.stl ...); may be repeated", "outputs", "",
     "The format follows from the extension; may be repeated. All files of a run are written, or "
     "none; no output may be an input or another output. A device, FIFO or socket is written to, "
     "- is the standard output."},
    {"--output", "-o", kUseTrace, output, V::paths, "FILE",
     "draw the tool path: .svg or .ply, or play it: .html"},
    {"--output", "-o", kPictures, output, V::paths, "FILE",
     "picture to write: .png; of frames .webm, too"},
    {"--output", "-o", kUseCompare, output, V::path, "FILE",
     "part coloured by deviation: .ply or .glb"},
    {"--output", "-o", kUseRest, output, V::paths, "FILE",
     "write the pieces as one mesh, format by extension"},
    {"--output", "-o", kUseTools, output, V::paths, "FILE", "draw the tools: .svg or .png"},
    {"--json", "", kUseRest, output, V::path, "FILE",
     "the pieces as JSON, - for the standard output"},
    {"--color", "", kUseRun | kPictures, output, V::choice, "C",
     "colour faces by what cut them: line, tool or none; default: none", "color", "line tool none",
     "Colour faces by what cut them: line, tool or none (default). A run writes the colours where "
     "the format has them (PLY, 3MF, GLB); render draws them with a legend, of a part whose file "
     "names its cuts."},
    {"--json", "", kUseTrace | kUseCheck, output, V::flag, "", "one JSON object a line"},
    {"--json", "", kUseTools, output, V::flag, "", "one JSON object a tool"},
    {"--programmed", "", kUseTrace, output, V::flag, "",
     "the contour instead of the compensated tool point", "", "",
     "trace: the contour instead of the compensated tool point."},
    {"--variables", "", kUseTrace, output, V::flag, "", "show assignments as they happen", "", "",
     "trace: show assignments of variables as they happen."},
    {"--strict", "", kUseRun | kUseTrace | kUseCheck, output, V::flag, "", "warnings are errors",
     "strict"},
    {"--allow-outside", "", kUseRun, output, V::flag, "",
     "let relative paths of a job lead out of its folder"},
    {"--no-open", "", kUseView, output, V::flag, "", "print the file's name and open nothing", "",
     "", "view: print the file's name and open nothing."},
    {"--report", "", kUseView, output, V::path, "FILE", "of a run: write the page there instead"},
    {"--max-memory", "", kUseTools | kUseView, output, V::text, "SIZE", kRefuseMore},
    {"--quiet", "-q", kOfRun | kUseCompare | kUseRest | kUseTools, output, V::flag, "",
     "print errors only"},
    {"--verbose", "-v", kOfRun, output, V::flag, "", "print more"},
    {"--help", "-h", ~0u, output, V::flag, "", "print this and exit", "", "",
     "Print the options of a command."},
    {"--version", "", kOfRun, output, V::flag, "", "print the version and exit"},
};

}  // namespace

std::span<const OptionRow> option_table() { return kRows; }

const OptionRow* find_option(std::string_view name, unsigned uses) {
  const auto* row = std::find_if(std::begin(kRows), std::end(kRows), [&](const OptionRow& r) {
    return r.name == name && (r.uses & uses) != 0;
  });
  return row == std::end(kRows) ? nullptr : row;
}

std::string_view group_title(OptionGroup group) {
  constexpr std::array<std::string_view, 6> kTitles = {
      "Stock", "Cutting", "Comparison", "Reading the program", "Picture", "Output"};
  return kTitles[static_cast<std::size_t>(group)];
}

std::vector<std::string_view> option_words(const OptionRow& row) {
  std::vector<std::string_view> words;
  for (std::size_t begin = 0; begin < row.words.size();) {
    const std::size_t end = std::min(row.words.find(' ', begin), row.words.size());
    words.push_back(row.words.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

}  // namespace mrsim
