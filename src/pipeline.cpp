// The facade: calls the stages in order.

#include "core/numbers/motions.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "core/process/error.h"
#include "core/process/heap.h"
#include "core/process/memory_limit.h"
#include "core/process/parallel.h"
#include "interp/interpreter.h"
#include "mesh/draw/render.h"
#include "mesh/format/mesh_io.h"
#include "mesh/mesh_part.h"
#include "mesh/solid/check.h"
#include "mesh/solid/solid_repair.h"
#include "removal/collision/collisions.h"
#include "removal/part/default_stock.h"
#include "removal/part/stock.h"
#include "removal/part/stock_file.h"
#include "removal/part/stock_reach.h"
#include "removal/stock/recognise_stock.h"
#include "run/cuts/cuts.h"
#include "run/cuts/history.h"
#include "run/cuts/play.h"
#include "run/cuts/until.h"
#include "run/files/outputs.h"
#include "run/files/stock_wrap.h"
#include "run/files/vdb_files.h"
#include "run/files/voxel_module.h"
#include "run/findings/assumed_sizes.h"
#include "run/findings/collision_findings.h"
#include "run/findings/feed_sides.h"
#include "run/findings/part_findings.h"
#include "run/mesh/mesh_choice.h"
#include "run/mesh/mesh_maker.h"
#include "run/mesh/mesh_store.h"
#include "setup/camotics_project.h"
#include "setup/job_file.h"
#include "setup/machine_file.h"
#include "setup/stock_spec.h"
#include "setup/tool_spec.h"
#include <mrsim/memory.h>
#include <mrsim/mrsim.h>
#include <mrsim/solid_files.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include <fmt/format.h>

namespace mrsim {
namespace {

class StageClock {
 public:
  explicit StageClock(JobResult& result) : result_(result) {}
  void done(const char* stage) {
    const auto now = std::chrono::steady_clock::now();
    result_.stage_seconds.emplace_back(stage, std::chrono::duration<double>(now - last_).count());
    last_ = now;
  }

 private:
  JobResult& result_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

bool has(const Program& program, Severity severity) {
  return std::any_of(program.diagnostics.begin(), program.diagnostics.end(),
                     [&](const Diagnostic& d) { return d.severity == severity; });
}

bool is_faulty(const JobResult& result, bool strict) {
  return has(result.program, Severity::error) || (strict && has(result.program, Severity::warning));
}

void count_motions(JobResult& result) {
  result.rapid_motions = result.line_motions = result.arc_motions = result.cutting_motions = 0;
  for (const Motion& motion : result.program.motions) {
    result.rapid_motions += motion.kind == MotionKind::rapid;
    result.line_motions += motion.kind == MotionKind::line;
    result.arc_motions += motion.kind == MotionKind::arc;
    result.cutting_motions += is_cut(motion);
  }
}

bool writes_vdb(const Job& job) {
  return std::any_of(job.outputs.begin(), job.outputs.end(), is_vdb);
}

// Bytes that a triangle of a stock takes, measured: in the search for self-intersections.
constexpr double kTriangleMemory = 430;

// What reading and checking a stock's file takes at most, by its size.
double stock_file_memory(const std::string& stock) {
  constexpr double kTriangleInFile = 10;  // bytes, of a 3MF file
  std::error_code none;
  const std::uintmax_t bytes = std::filesystem::file_size(stock, none);
  return none ? 0 : kTriangleMemory / kTriangleInFile * double(bytes);
}

// A stock of voxels is read, and one with gaps wrapped, in a copy of this process, made while no
// threads start (vdb_files.cpp). Where memory is short, the plan of the run is asked first.
bool opens_voxels_early(const Job& job) {
  return writes_vdb(job) && !is_vdb(job.stock) && job.stock_options.wrap.distance == 0 &&
         memory_left() > kVoxelModuleMemory + stock_file_memory(job.stock);
}

// What is to be reported of a stock's file.
struct StockFindings {
  std::string accuracy;  // what a surface that was made of voxels is worth
  std::string step;      // what a surface that was made of a STEP file is worth
  StockRepair repair;
};

constexpr std::string_view kOtherStocks =
    " .step .stp .vdb; a plain stock is box:x0,y0,z0,x1,y1,z1, cylinder:d,z0,z1 or "
    "tube:d,bore,z0,z1";

StockShape load_stock(const std::string& spec, const StockOptions& options,
                      StockFindings* findings) {
  if (std::optional<StockShape> shape = parse_stock_spec(spec)) return *shape;
  VdbContent saved;
  if (is_vdb(spec)) saved = read_vdb_file(spec);
  release_freed_memory();  // the file's
  if (saved.recipe) return std::move(saved.recipe->shape);
  if (!is_vdb(spec) && !is_step(spec)) mesh_format_of(spec, kOtherStocks);
  StockFindings found;
  found.accuracy = saved.accuracy;
  TriMesh mesh = is_vdb(spec)    ? std::move(saved.surface)
                 : is_step(spec) ? read_step(spec, step_deflection({}), &found.step)
                                 : read_mesh(spec);
  if (options.wrap.distance > 0) found.repair = wrap_stock(mesh, options);
  if (findings != nullptr) *findings = found;
  release_freed_memory();  // what reading and wrapping took: the checks' blocks do not fit into it
  require_memory(kTriangleMemory * double(mesh.triangles.size()),
                 fmt::format("a stock of {} triangles", mesh.triangles.size()),
                 "a coarser mesh takes less");
  const std::string repairs = make_solid(mesh, spec);
  StockShape shape = recognise_stock(std::move(mesh), options, spec);
  shape.repairs = repairs;
  if (shape.kind == StockShape::Kind::mesh) require_clean_bodies(shape.mesh, spec);
  release_freed_memory();  // what the checks took
  return shape;
}

// Warns where the program states a stock and cuts beside it.
void check_reach(const StockShape& stock, JobResult& result) {
  constexpr double kFew = 0.05;
  const Program& program = result.program;
  if (program.machine == MachineKind::lathe) return;
  const double share = share_beside(program.motions, program.tools, stock.box);
  if (share <= kFew) return;
  report(result, Severity::warning, "stock-elsewhere",
         fmt::format("{:.0f} % of the cuts pass by the stock that the program states ({}): give "
                     "--stock, or the work offset with --tools",
                     100 * share, stock.description));
}

// The stock that was given, else the one the program states, else one round its cuts.
StockShape choose_stock(const Job& job, JobResult& result) {
  const Program& program = result.program;
  if (!job.stock.empty()) {
    StockFindings found;
    StockShape given = load_stock(job.stock, job.stock_options, &found);
    result.stock_repair = found.repair;
    if (found.repair.wrapped)
      report(result, Severity::note, "stock-wrapped", wrap_text(job.stock, found.repair));
    if (!given.repairs.empty())
      report(result, Severity::warning, "stock-repaired",
             fmt::format("{} was no solid and has been repaired: {}", job.stock, given.repairs));
    if (!found.step.empty()) report(result, Severity::note, "stock-of-step", found.step);
    if (!found.accuracy.empty())
      report(result, Severity::warning, "stock-of-voxels", found.accuracy);
    return given;
  }
  if (program.workpiece) {
    check_reach(*program.workpiece, result);
    return *program.workpiece;
  }
  AssumedStock assumed = default_stock(program.motions, program.tools,
                                       program.machine == MachineKind::lathe, program.zero_height);
  const bool sure = assumed.guesses.empty();
  report(result, sure ? Severity::note : Severity::warning, "stock-assumed",
         "no --stock given: a stock " + assumed.shape.description +
             (sure ? "" : "; " + assumed.guesses + ": say --stock if it is not so"));
  return std::move(assumed.shape);
}

// Whether the stock is one around the cuts, for want of another.
bool assumes_stock(const Job& job, const JobResult& result) {
  return job.stock.empty() && !result.program.workpiece;
}

// Sizes of tools that nothing says follow from the stock, and an assumed stock from the tools.
void settle_tools_and_stock(const Job& job, JobResult& result) {
  complete_inserts(result.program);
  turn_drills_round(result.program);
  const bool assumed = assumes_stock(job, result);
  if (assumed) complete_cones(result, std::nullopt);
  result.stock = choose_stock(job, result);
  if (!assumed) complete_cones(result, result.stock.box.hi.z);
}

Stock carve_part(const Job& job, const StockShape& shape, const CutList& cuts, MeshChoice& choice) {
  CarvePlan plan = carve_plan(job.carve);
  plan.keep_grid = writes_vdb(job);  // nothing else reads the samples
  return carve(shape, cuts.motions(), cuts.tools(), plan,
               [&](const ExactField& field, CarvePlan& chosen) {
                 fit_mesh(field, job.mesh.threads, choice);
                 chosen.voxel = choice.voxel;
                 chosen.grid_mesh = choice.tolerance == 0;
                 chosen.cut_cells = choice.cut_cells;
                 chosen.cut_layers = choice.cut_layers;
                 chosen.block_sweeps = choice.block_sweeps;
                 chosen.shared_sweeps = choice.shared_sweeps;
                 chosen.no_slabs = no_slabs(job, choice.tolerance);
               });
}

// Makes the mesh, which is checked as it comes. Returns its volume less that of the exact part,
// mm^3.
double make_mesh(const Job& job, JobResult& result, Stock& stock, MeshChoice& choice,
                 MeshMaker& maker) {
  const MeshReport found = maker.make();
  const MeshStore& part = maker.part();
  if (part.source().triangles() == 0) refuse_empty(stock.field(), choice.voxel);
  tell_choice(result, choice);
  if (stock.in_slabs()) report_slabs(result, part, stock);
  if (part.owners().back() < 0)
    report(result, Severity::warning, "nothing-cut",
           "no cut meets the stock: check the stock's place and the work offset");
  report_mesh(result, found);
  result.expected_memory = static_cast<std::size_t>(maker.memory());
  result.stock_volume = volume_before(job, result.stock, choice);
  return found.volume_excess;
}

// Drops loose pieces where that was asked for. Returns the volume of the part, mm^3.
double settle_pieces(const Job& job, JobResult& result, double excess, MeshStore& part,
                     Outputs& outputs) {
  keep_pieces(result, part, job.keep, writes_vdb(job));
  const bool is_whole = std::all_of(result.pieces.begin(), result.pieces.end(),
                                    [](const PartPiece& piece) { return piece.kept; });
  if (!is_whole) outputs.replace_mesh();
  return part.summary().volume - (is_whole ? excess : 0);
}

StockRecipe recipe_of(const Job& job, const JobResult& result, const CutList& cuts) {
  if (!writes_vdb(job)) return {};
  StockRecipe recipe{result.stock, result.voxel};
  recipe.shape.history = cuts.history();
  return recipe;
}

void require_cuts(const Job& job, const JobResult& result) {
  if (result.cutting_motions == 0)
    throw Error("program-no-cuts",
                job.program + " cuts nothing: it has no G1, G2 or G3 whose start is known");
}

void end_program(const Job& job, JobResult& result) {
  Program& program = result.program;
  const Moment moment = moment_until(
      program, job.until, [&](MotionSink& sink) { interpret(job.program, job.interp, sink); });
  const std::size_t all = program.motions.size(), kept = moment.motions;
  const bool is_part = kept < program.motions.size() / 2;
  program.motions.resize(kept);
  if (is_part) program.motions.shrink_to_fit();  // plans of memory count those that are kept
  program.events.resize(moment.events);
  if (moment.dwell > 0) program.events.back().seconds = moment.dwell;
  count_motions(result);
  report(result, Severity::note, "until",
         fmt::format("--until {}: the program ends after {} of {} motions", job.until, kept, all));
  require_cuts(job, result);
}

// False: the program has faults.
bool read_program(const Job& job, JobResult& result, StageClock& clock) {
  result.program = interpret(job.program, job.interp);
  protect_program_files(job, result.program.files);
  count_motions(result);
  clock.done("read");
  if (is_faulty(result, job.strict)) return false;
  require_cuts(job, result);
  return true;
}

// What the cuts of the carved stock show: what each removes, how they play, what collides.
void examine_cuts(const Job& job, JobResult& result, const Stock& stock, const CutList& cuts,
                  StageClock& clock) {
  result.history = make_history(job, result, stock, cuts);
  if (job.until.empty()) warn_of_idle_tools(result, assumes_stock(job, result));
  clock.done("history");
  if (job.play) {
    result.play = make_play(job, result, stock, cuts);
    clock.done("play");
  }
  result.collisions =
      find_collisions(stock, cuts.motions(), cuts.tools(), cuts.inherited(), job.collisions);
  add_collisions(result.program, cuts, result.collisions);
  clock.done("collisions");
}

// Publishes the files, all of them or none.
void publish_files(const Job& job, JobResult& result, Outputs& outputs, StageClock& clock) {
  PreparedFiles own;
  PreparedFiles& prepared = job.prepared != nullptr ? *job.prepared : own;
  outputs.prepare(job, result, prepared);
  if (job.prepared == nullptr) prepared.publish(result);
  result.peak_memory = peak_memory();  // with what histories and documents took
  clock.done("publish");
}

}  // namespace

JobFile load_job(const std::string& path, bool allow_outside) {
  return path.ends_with(".camotics") ? load_camotics_project(path)
                                     : load_job_file(path, allow_outside);
}
MachineData load_machine(const std::string& path) { return load_machine_file(path); }
Tool parse_tool(const std::string& spec) { return parse_tool_spec(spec); }

StockShape load_stock(const std::string& spec, const StockOptions& options) {
  return load_stock(spec, options, nullptr);
}

void render(const TriMesh& mesh, const std::string& png_path, const RenderOptions& options) {
  write_file_atomically(png_path, [&](const ByteSink& out) { render_mesh(mesh, options, out); });
}

MeshSummary summarize(const TriMesh& mesh) { return check_mesh(mesh); }

JobResult simulate(const Job& job) {
  const MemoryLimit limit(job.carve.max_memory);
  JobResult result;
  simulate(job, result);
  return result;
}

void simulate(const Job& job, JobResult& result) {
  StageClock clock(result);
  require_address_space(resolve_threads(job.carve.threads));
  check_outputs(job);
  const std::future<void> opening =
      opens_voxels_early(job) ? open_voxel_module() : std::future<void>();
  if (!read_program(job, result, clock)) return;

  settle_tools_and_stock(job, result);
  if (!job.until.empty()) end_program(job, result);
  warn_of_threads(result);
  warn_of_hands(result);
  warn_of_blades(result);
  result.cycle = cycle_time(result.program, job.machine);
  const CutList cuts(result.stock.history, result.program);
  MeshChoice choice = choose_mesh(job, result.stock, cuts);
  clock.done("stock");
  if (is_faulty(result, job.strict)) return;

  Stock stock = carve_part(job, result.stock, cuts, choice);
  result.active_voxels = stock.active_voxels();
  clock.done("carve");
  examine_cuts(job, result, stock, cuts, clock);

  const int stream_threads = choice.tolerance > 0 ? job.mesh.threads : 1;
  MeshFileOptions files = job.files;
  files.threads = job.mesh.threads;
  Outputs outputs(job.outputs, files, stream_threads);
  MeshMaker maker(job, stock, choice, outputs, stream_threads);
  const double excess = make_mesh(job, result, stock, choice, maker);
  MeshStore& part = maker.part();
  clock.done("mesh");
  const double volume = settle_pieces(job, result, excess, part, outputs);
  clock.done("check");
  if (reduce_part(job, result, part, outputs)) clock.done("reduce");
  warn_of_coarse_mesh(job, result);
  summarize_part(result, part, cuts, volume);
  if (is_faulty(result, job.strict)) return;
  if (job.inspect) {
    job.inspect(part.in_memory());
    clock.done("inspect");
  }

  outputs.complete(part.source(), stock, recipe_of(job, result, cuts), job.hash_files,
                   result.files);
  result.mesh = std::move(part.in_memory());
  result.stock.mesh = {};
  result.peak_memory = peak_memory();
  clock.done("write");
  publish_files(job, result, outputs, clock);
  result.ok = true;
}

const char* version() { return MRSIM_VERSION; }

void set_memory_limit(std::size_t bytes) { set_thread_limit(bytes); }

}  // namespace mrsim
