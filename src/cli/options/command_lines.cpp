#include "cli/options/command_lines.h"

#include "core/process/error.h"

#include <algorithm>
#include <array>

namespace mrsim::cli {
namespace {

using enum OptionGroup;

constexpr const char* kRenderSummary =
    "Draws a mesh as a shaded picture with its edges; needs no display.";
constexpr const char* kRenderUsage =
    "mrsim render PART -o picture.png [options]\n"
    "       mrsim render PROGRAM|job.toml --frames N -o f%04d.png|film.webm [options of a run]";
constexpr const char* kRenderExamples =
    "Examples:\n"
    "  mrsim render part.stl -o part.png\n"
    "  mrsim render part.ply --nominal nominal.step --accept 0.02 -o deviation.png\n"
    "  mrsim render part.stl -o top.png --azimuth 0 --elevation 90 --size 800x600";

const std::array<CommandLine, 9> kLines = {{
    {"",
     kUseRun,
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
     {stock, cutting, comparison, program, output},
     "Examples:\n"
     "  mrsim PRIMER_2F.MPF --stock block.stl -o part.stl\n"
     "  mrsim pocket.nc --stock box:0,0,-20,80,60,0 --tool endmill:d=10 -o part.stl\n"
     "  mrsim shaft.mpf --stock cylinder:50,0,51 --tools tools.toml --voxel 0.1 -o shaft.stl\n\n"
     "Exit: 0 done; 1 the program or a file has errors; 2 wrong usage; 3 a fault of mrsim;\n"
     "4 out of tolerance; 5 a collision under --strict; 130, 143, 129 stopped by Ctrl-C, SIGTERM,\n"
     "SIGHUP.\n"
     "Each command has its own --help. Manual: man mrsim, and docs/."},
    {"trace",
     kUseTrace,
     "Prints what the control understood, one motion a line.",
     "mrsim trace PROGRAM [--json] [-o path.svg|path.html] [options]",
     {program, output},
     "Examples:\n"
     "  mrsim trace PRIMER_2F.MPF\n"
     "  mrsim trace PRIMER_2F.MPF --json | jq .kind\n"
     "  mrsim trace PRIMER_2S.MPF -o path.svg\n"
     "  mrsim trace PRIMER_2S.MPF -q -o path.html"},
    {"check",
     kUseCheck,
     "Reads a program and prints its errors, warnings and notes.",
     "mrsim check PROGRAM|FOLDER|- ... [options]",
     {program, output},
     "Examples:\n"
     "  mrsim check --json programs/ | jq 'select(.kind==\"summary\")'\n"
     "  mrsim check PRIMER_2F.MPF\n"
     "  mrsim check --strict --dialect fanuc O0001.nc"},
    {"render",
     kUseRender,
     kRenderSummary,
     kRenderUsage,
     {picture, comparison, output},
     kRenderExamples},
    {"render",
     kUseFilm,
     kRenderSummary,
     kRenderUsage,
     {stock, cutting, program, picture, output},
     kRenderExamples},
    {"compare",
     kUseCompare,
     "Says where a part differs from its drawing, by how much, and which line is to blame.",
     "mrsim compare PART NOMINAL [options]",
     {comparison, output},
     "Examples:\n"
     "  mrsim compare part.ply nominal.step --accept 0.02 --report r.html\n"
     "  mrsim compare part.3mf nominal.stl --accept -0.02,0.05 --json - | jq .verdict\n\n"
     "Exit: 0 in tolerance, or no --accept; 1 a bad file; 2 wrong usage; 4 out of tolerance."},
    {"rest",
     kUseRest,
     "Says what is left to cut of a part: pieces with volume, thickness and place, and the "
     "largest\n"
     "tool that reaches each of them without cutting the nominal.",
     "mrsim rest PART NOMINAL [-o pieces.stl] [options]\n\n"
     "PART and NOMINAL are meshes, STEP files or .vdb stocks.",
     {comparison, output},
     "Examples:\n"
     "  mrsim rest part.stl nominal.step\n"
     "  mrsim rest part.ply nominal.stl --voxel 0.1 --above 0.05 -o pieces.stl --json rest.json"},
    {"tools",
     kUseTools,
     "Lists the tools of a file, and draws them.",
     "mrsim tools FILE [-o tools.svg|tools.png] [--json] [-q]\n\n"
     "FILE is tools.toml, LinuxCNC .tbl, CAMotics .camotics or .json, Fusion .json or .tools,\n"
     "FreeCAD .fctb or .fctl. What can not be read is named.",
     {output},
     "Examples:\n"
     "  mrsim tools tools.toml\n"
     "  mrsim tools library.tools -o library.svg"},
    {"view",
     kUseView,
     "Writes the page that plays a run, or shows a part, to a temporary file and opens it.",
     "mrsim view PROGRAM|job.toml|PART [options of a run] [--no-open]",
     {output},
     "Examples:\n"
     "  mrsim view PRIMER_2F.MPF --stock block.stl\n"
     "  mrsim view job.toml\n"
     "  mrsim view part.ply --no-open"},
}};

}  // namespace

const CommandLine& command_line(OptionUse use) {
  const auto line = std::find_if(kLines.begin(), kLines.end(),
                                 [use](const CommandLine& other) { return other.uses == use; });
  MRSIM_ASSERT(line != kLines.end());
  return *line;
}

}  // namespace mrsim::cli
