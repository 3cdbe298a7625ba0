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
#include <mrsim/options.h>
#include <mrsim/play.h>
#include <mrsim/types.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
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

struct JobResult;

/// A file that a run writes besides the part: it appears together with the outputs, or none does.
struct SideFile {
  NamedPath file;  ///< "-" is the standard output; the role is what messages call it, "--report"
  /// Called once the part's files are complete, in the order of Job::side_files.
  std::function<void(const JobResult& result, const ByteSink& sink)> write;
  bool is_last = false;  ///< lists all files: made when PreparedFiles are published
};

/// A file that a run has written.
struct WrittenFile {
  std::string path;
  std::uint64_t bytes = 0;
  std::string sha256;  ///< where Job::hash_files asks for it
};

/// Files of one run or of several, complete but not yet in their places. They lie on the disk
/// without names, each with an open descriptor, and are gone if nobody publishes them.
class MRSIM_API PreparedFiles {
 public:
  PreparedFiles();
  ~PreparedFiles();
  PreparedFiles(const PreparedFiles&) = delete;
  PreparedFiles& operator=(const PreparedFiles&) = delete;
  /// Makes the last ones of `result`, whose `files` they join; then all take their places, or none
  /// does and an Error is thrown.
  void publish(JobResult& result);

 private:
  friend class Outputs;
  struct Files;
  std::unique_ptr<Files> files_;
};

struct Job {
  std::string program;
  InterpOptions interp;
  /// As load_stock takes it. Empty: the stock that the program states, or else a box around its
  /// cuts, on lathes a bar; reported.
  std::string stock;
  StockOptions stock_options;
  CarveOptions carve;
  CollisionOptions collisions;
  MeshOptions mesh;
  std::vector<std::string> outputs;  ///< files to write, format by extension; may be empty
  MeshFileOptions files;             ///< colours and such of the mesh files among them
  std::vector<SideFile> side_files;  ///< written together with the outputs
  /// Gets the files of the run, which appear when it is published; nullptr: at the end of the run.
  PreparedFiles* prepared = nullptr;
  std::vector<NamedPath> inputs;  ///< further files that no output may overwrite
  bool hash_files = false;        ///< fill WrittenFile::sha256
  /// Pieces that the program cuts loose: kept, with a warning, or dropped but for the largest, with
  /// a note. A .vdb among the outputs holds them all: it is the stock and its cuts.
  KeepPieces keep = KeepPieces::all;
  /// Most triangles of the mesh, 0 = any number. More are reduced, and the distance that makes is
  /// measured: JobResult::reduction. Error "max-triangles" where no sound mesh is that small. The
  /// run is not done in slabs, and a .vdb does not change.
  std::size_t max_triangles = 0;
  /// The moment at which the program ends: "12" (a line), "O100:7" (a line of another file) or
  /// "#5000" (a motion); empty: its end. The stock and the tools are those of the whole program.
  std::string until;
  /// What each motion removes is found, too, for JobResult::history.
  HistoryDetail history = HistoryDetail::summary;
  bool play = false;    ///< JobResult::play is made, for a page that plays the run
  MachineData machine;  ///< what decides how long the program takes
  bool strict = false;  ///< warnings are errors
  /// Tolerance of the part in mm that the mesh will be judged by; 0 = none. Where neither a voxel
  /// nor a tolerance of the mesh is given, the mesh keeps to a quarter of it.
  double accept = 0;
  /// Sees the part before anything is written; what it throws ends the run. Default: nothing.
  std::function<void(const TriMesh& part)> inspect;
  /// The whole mesh is wanted, in JobResult or by `inspect`. false: a run that does not fit into
  /// memory is done in slabs where it can be, with the same files; JobResult::mesh is then empty.
  bool whole_mesh = true;
};

/// One of the pieces that no material joins.
struct PartPiece {
  double volume = 0;  ///< mm^3, cavities subtracted
  Vec3 center;        ///< centre of volume, mm
  Box3 bounds;        ///< mm
  std::size_t triangles = 0;
  bool kept = true;  ///< false: dropped by Job::keep, and not in JobResult::mesh
};

/// What Job::max_triangles did to the mesh.
struct MeshReduction {
  std::size_t before = 0;  ///< triangles; 0: the mesh was not reduced
  /// mm: the largest distance of a point of either mesh, before and after, from the other one lies
  /// between these.
  double least = 0, most = 0;
  Vec3 place;  ///< where `least` was found
};

/// What StockOptions::wrap made of the stock's mesh.
struct StockRepair {
  bool wrapped = false;
  std::size_t openings = 0;  ///< closed with triangles between their corners
  double widest = 0;         ///< mm: the largest side of those
  /// mm: the largest distance of a point of the wrap, or of the surface with its openings closed,
  /// from the other one lies between these.
  double least = 0, most = 0;
  Vec3 place;  ///< where `least` was found
};

/// A wall (material between air) or gap that the mesh does not hold, or may not hold.
struct ThinPlace {
  Vec3 place;  ///< mm, on or in it
  bool wall = false;
  double thickness = 0;  ///< mm
};

struct JobResult {
  Program program;   ///< with all diagnostics, those of later stages too
  StockShape stock;  ///< as simulated, without its mesh
  StockRepair stock_repair;
  double voxel = 0;  ///< mm
  std::string voxel_reason;
  double tolerance = 0;  ///< mm, 0 = the mesh has the grid of the voxels
  std::string tolerance_reason;
  /// mm: certified distance between mesh and part; 0 where the voxel was given. By default it may
  /// be that of the grid's triangles from the part; then mesh_usual holds for 99 % of them. Both
  /// are of the mesh before its reduction.
  double mesh_bound = 0, mesh_usual = 0;
  /// Triangles whose distance from the exact part is sampled, not proven.
  std::size_t mesh_sampled = 0;
  /// Vertices that stay because the mesh would meet itself without them.
  std::size_t mesh_kept = 0;
  /// What mesh_bound does not hold for, the thickest first.
  std::vector<ThinPlace> thin;
  std::size_t rapid_motions = 0, line_motions = 0, arc_motions = 0;
  CycleTime cycle;                  ///< how long the machine takes
  History history;                  ///< what the motions remove
  Play play;                        ///< the stock at every moment, where Job::play asks for it
  std::size_t cutting_motions = 0;  ///< lines and arcs whose start is known
  std::size_t active_voxels = 0;    ///< 0 where none were sampled: a .vdb alone needs them
  CollisionReport collisions;       ///< each a warning among the diagnostics as well
  TriMesh mesh;                     ///< empty where the run was done in slabs
  std::size_t triangles = 0;        ///< of the part
  std::size_t slabs = 0;            ///< 0: the mesh was in memory
  MeshSummary summary;
  MeshReduction reduction;
  std::vector<PartPiece> pieces;  ///< of the part as cut, the largest first; usually one
  /// mm^3, of the exact part where the mesh has a tolerance and no piece was dropped (docs/mesh.md,
  /// Volume), else of the mesh (summary.volume); pieces that were dropped count as removed.
  double volume = 0, stock_volume = 0, removed_volume = 0;
  std::vector<std::pair<std::string, double>> stage_seconds;  ///< in the order they ran
  std::size_t peak_memory = 0;                                ///< bytes
  std::size_t expected_memory = 0;  ///< bytes, as estimated before the mesh was made
  std::vector<WrittenFile> files;   ///< outputs, then side files, as far as they are complete
  bool ok = false;                  ///< false: the program has errors, nothing was written
};

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
