/// mrsim: the facade. One function per stage, and simulate() that runs them all.
///
/// Example:
///     mrsim::Job job;
///     job.program = "PRIMER_2F.MPF";
///     job.stock = "block.stl";
///     job.outputs = {"part.stl"};
///     const mrsim::JobResult result = mrsim::simulate(job);
///     printf("%g mm^3 of %zu motions\n", result.volume, result.program.motions.size());
///
/// Errors: faults of files, options and the machine throw mrsim::Error; faults of the program are
/// Diagnostics. Every function that reads a file may throw "file-missing", "file-unreadable",
/// "file-is-directory", "file-too-large", "file-read-once" and "memory". One that writes a file may
/// throw "output-unwritable", "output-folder" and "output-full"; the file that was there then
/// stays. The functions name only what they throw besides.
///
/// Every function may be called from any thread; results do not depend on the number of threads.
#pragma once

#include <mrsim/collisions.h>
#include <mrsim/cycle_time.h>
#include <mrsim/files.h>
#include <mrsim/history.h>
#include <mrsim/job.h>
#include <mrsim/options.h>
#include <mrsim/play.h>
#include <mrsim/result.h>
#include <mrsim/types.h>

#include <functional>
#include <string>
#include <vector>

namespace mrsim {

/// Reads an NC program as its control would. Faults of the program are in Program::diagnostics, a
/// rejected block moves nothing. Throws Error "program-empty", "file-encoding", and of kind usage
/// "machine-unclear" (mill or lathe?) and "variable-unknown" (InterpOptions::variables).
/// Cost: linear in the blocks that run; sizeof(Motion) bytes of memory for each motion.
MRSIM_API Program interpret(const std::string& path, const InterpOptions& options = {});

/// One motion as the JSON object of `mrsim trace --json` (docs/interp.md), in UTF-8, without line
/// end. `motion` is one of `program`: its file, tool and call are looked up there.
MRSIM_API std::string motion_json(const Program& program, const Motion& motion);
/// One finding as the JSON object that `mrsim check --json` prints, in UTF-8, without line end.
MRSIM_API std::string diagnostic_json(const Diagnostic& diagnostic);
/// That motion as a line for people: mm, degrees.
MRSIM_API std::string motion_text(const Program& program, const Motion& motion);
/// The tool path as a picture, .svg or .ply by extension: rapids dashed, arcs as arcs, a lathe in
/// ZX. Throws Error "output-format" (usage) for another extension. Cost: linear in the motions.
MRSIM_API void write_path_picture(const Program& program, const std::string& path);

/// Takes what trace() finds, in program order, as it is found. Any of them may be empty.
struct TraceSink {
  std::function<void(const Motion& motion)> motion;
  std::function<void(const std::string& line)> line;  ///< the same motion as text, no line end
  std::function<void(const Diagnostic& diagnostic)> diagnostic;
};
/// Like interpret, with the same errors, but hands motions on instead of keeping them, as values
/// and as lines of JSON or text: memory does not grow with the length of the program.
/// Program::motions and Program::diagnostics of the result are empty.
MRSIM_API Program trace(const std::string& path, const InterpOptions& options, bool json,
                        const TraceSink& sink);

/// What check_program() counts, beside what the interpreter found.
struct CheckReport {
  Program program;
  std::size_t motions = 0, cuts = 0;
};
/// Reads a program like trace(), with the same errors and in as little memory, and reports, too,
/// what a run of it would refuse: threads, moves that can not be swept, tools without a shape.
/// `found` takes the findings as they come.
MRSIM_API CheckReport check_program(const std::string& path, const InterpOptions& options,
                                    const std::function<void(const Diagnostic&)>& found);

/// Reads tools.toml, or a tool library: LinuxCNC .tbl, CAMotics .camotics and .json, Fusion .json
/// and .tools, FreeCAD .fctb and .fctl. `notes`: sentences about tools that were left out. Throws
/// PlacedError "tools-syntax", "tools-key", "tools-value", "tools-duplicate" with line and column
/// (libraries in JSON: Error with the tool's name), Error "tools-format" for another file.
MRSIM_API ToolTable load_tools(const std::string& path, std::vector<std::string>* notes = nullptr);
/// Draws tools from the side, .svg or .png by extension. Throws Error "tools-empty", and
/// "output-format" (usage) for another extension.
MRSIM_API void write_tools_picture(const std::vector<Tool>& tools, const std::string& path);
/// The bytes of that picture, as the extension of `name` says; it throws the same.
MRSIM_API void encode_tools_picture(const std::vector<Tool>& tools, const std::string& name,
                                    const ByteSink& sink);
/// The table [machine] of a TOML file (docs/job.md). Throws PlacedError "machine-syntax",
/// "machine-missing", "machine-key", "machine-value".
MRSIM_API MachineData load_machine(const std::string& path);
/// One tool from "4=endmill:d=5" or "endmill:d=5", lengths in mm, angles in degrees
/// (docs/tools.md). Throws Error "tool-spec" (usage).
MRSIM_API Tool parse_tool(const std::string& spec);

/// The stock from "box:x0,y0,z0,x1,y1,z1", "cylinder:d,z0,z1", "tube:d,bore,z0,z1", all in mm, or
/// from a file: a mesh in mm, or a .vdb. Throws Error "stock-spec" (usage), "stock-empty", what
/// read_mesh() throws, "mesh-open" and the like for a mesh that bounds no solid and can not be made
/// to, "stock-wrap" where StockOptions::wrap finds no solid either, "vdb-unreadable" and the like
/// for a damaged .vdb, "cancelled". Cost: a few sorts of a mesh's triangles, more where it must be
/// repaired.
MRSIM_API StockShape load_stock(const std::string& spec, const StockOptions& options = {});

/// A mesh in mm from .stl, .obj, .ply, .off, .3mf or .glb, by extension. It need not be closed.
/// Throws Error "mesh-format" (usage) for another extension; what is wrong with the file has a code
/// that begins with the format's name: "stl-truncated", "3mf-xml".
MRSIM_API TriMesh read_mesh(const std::string& path);
/// Writes .stl, .obj, .ply, .off, .3mf or .glb, by extension. Throws Error "mesh-format" (usage),
/// "mesh-empty", "stl-too-large", "glb-too-large", "3mf-too-large".
MRSIM_API void write_mesh(const std::string& path, const TriMesh& mesh);
/// The bytes of a mesh file in the format of `name`, which is not opened. Throws as write_mesh().
MRSIM_API void encode_mesh(const TriMesh& mesh, const std::string& name, const ByteSink& sink);

/// What a mesh is, and whether it keeps the promises of docs/mesh.md. Throws
/// nothing, whatever the mesh. Cost: about 0.1 s for a million triangles.
MRSIM_API MeshSummary summarize(const TriMesh& mesh);

/// Writes a shaded PNG of the mesh, edges drawn, without a display. Throws Error "render-options"
/// (usage), "mesh-empty", "mesh-invalid", "memory". Cost: a few rays for each pixel, each of them
/// logarithmic in the triangles.
MRSIM_API void render(const TriMesh& mesh, const std::string& png_path,
                      const RenderOptions& options = {});

/// The whole way from program to part. With any error in the program nothing is carved or written
/// and `ok` is false. Throws what interpret(), load_stock() and the writers throw, and:
///   "program-no-cuts", "part-empty"       nothing is cut, nothing is left
///   "until-invalid", "until-file", "until-beyond"  Job::until (usage)
///   "voxel-invalid", "tolerance-invalid"  out of range for this part
///   "tool-invalid", "tool-missing", "motion-unsupported"  a cut that can not be swept
///   "mesh-unresolved", "max-triangles"    no mesh keeps the promise that was asked for
///   "memory", "cancelled"                 CarveOptions::max_memory, Progress
///   "output-is-input", "output-twice"     an output is an input or another output (usage)
///   "vdb-module"                          mrsim/vdb.so, which samples voxels for a .vdb, is
///                                         missing beside the library or does not fit
/// Cost: grows with the motions and with the cut surface counted in voxels, not with the volume;
/// docs/performance.md has measured runs.
MRSIM_API JobResult simulate(const Job& job);
/// simulate() into `result`, which holds what was found until then when an Error is thrown.
MRSIM_API void simulate(const Job& job, JobResult& result);

/// "0.1.0"
MRSIM_API const char* version();

}  // namespace mrsim
