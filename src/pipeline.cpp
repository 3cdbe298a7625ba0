// The facade: calls the stages in order.

#include "collision_findings.h"
#include "core/error.h"
#include "core/heap.h"
#include "core/text_io.h"
#include "core/units.h"
#include "core/vec.h"
#include "cuts.h"
#include "interp/interpreter.h"
#include "mesh/check.h"
#include "mesh/extract.h"
#include "mesh/pieces.h"
#include "mesh/render.h"
#include "mesh/solid_repair.h"
#include "outputs.h"
#include "part_mesh.h"
#include "removal/collision.h"
#include "removal/default_stock.h"
#include "removal/stock.h"
#include "removal/stock_file.h"
#include "removal/stock_shape.h"
#include "removal/sweep.h"
#include "setup/job_file.h"
#include "setup/stock_spec.h"
#include "setup/tool_spec.h"
#include "setup/tools_file.h"
#include "voxel_module.h"
#include <mrsim/mrsim.h>
#include <mrsim/solid_files.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <sys/resource.h>

namespace mrsim {
namespace {

class Collector : public MotionSink {
 public:
  // Room for a program of short lines: growing would copy all motions, and touch new pages for
  // them, again and again.
  explicit Collector(const std::string& path) {
    constexpr std::uintmax_t kLineBytes = 24;
    std::error_code failed;
    const std::uintmax_t bytes = std::filesystem::file_size(path, failed);
    if (!failed) reserve_large(motions, bytes / kLineBytes);
  }
  void motion(const Motion& motion) override { motions.push_back(motion); }
  void diagnostic(const Diagnostic& diagnostic) override { diagnostics.push_back(diagnostic); }
  std::vector<Motion> motions;
  std::vector<Diagnostic> diagnostics;
};

class TraceSinkAdapter : public MotionSink {
 public:
  TraceSinkAdapter(const TraceSink& sink, bool json) : sink_(sink), json_(json) {}
  void begin(const Program& program) override { program_ = &program; }
  void motion(const Motion& motion) override {
    if (sink_.motion) sink_.motion(motion);
    if (sink_.line)
      sink_.line(json_ ? motion_json(*program_, motion) : motion_text(*program_, motion));
  }
  void diagnostic(const Diagnostic& diagnostic) override {
    if (sink_.diagnostic) sink_.diagnostic(diagnostic);
  }

 private:
  const TraceSink& sink_;
  bool json_;
  const Program* program_ = nullptr;
};

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

std::size_t peak_memory() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

bool has(const Program& program, Severity severity) {
  return std::any_of(program.diagnostics.begin(), program.diagnostics.end(),
                     [&](const Diagnostic& d) { return d.severity == severity; });
}

bool is_faulty(const JobResult& result, bool strict) {
  return has(result.program, Severity::error) || (strict && has(result.program, Severity::warning));
}

void report(JobResult& result, Severity severity, const char* code, const std::string& text) {
  Diagnostic diagnostic;
  diagnostic.severity = severity;
  diagnostic.code = code;
  diagnostic.text = text;
  diagnostic.place.file = result.program.files.empty() ? "" : result.program.files[0];
  result.program.diagnostics.push_back(diagnostic);
}

void count_motions(JobResult& result) {
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

// The stock that was given, else the one the program states, else one round its cuts.
StockShape choose_stock(const Job& job, JobResult& result) {
  const Program& program = result.program;
  if (!job.stock.empty()) {
    StockShape given = load_stock(job.stock, job.stock_options);
    if (!given.repairs.empty())
      report(result, Severity::warning, "stock-repaired",
             fmt::format("{} was no solid and has been repaired: {}", job.stock, given.repairs));
    return given;
  }
  if (program.workpiece) return *program.workpiece;
  StockShape shape =
      default_stock(program.motions, program.tools, program.machine == MachineKind::lathe);
  report(result, Severity::note, "stock-assumed", "no --stock given: a stock " + shape.description);
  return shape;
}

// The tools' smallest radius, from one cut of each tool: the sweeps of a long program are made once
// only.
double smallest_radius(const CutList& cuts) {
  std::vector<bool> seen(cuts.tools().size(), false);
  std::vector<Motion> samples;
  for (const Motion& motion : cuts.motions()) {
    if (!is_cut(motion) || motion.tool < 0 || seen[static_cast<std::size_t>(motion.tool)]) continue;
    seen[static_cast<std::size_t>(motion.tool)] = true;
    samples.push_back(motion);
  }
  return SweepTable(samples, cuts.tools(), 0).smallest_radius();
}

void choose_voxel(CarveOptions& options, const CutList& cuts, JobResult& result) {
  result.voxel_reason = "--voxel";
  if (options.voxel == 0) {
    const VoxelChoice choice = default_voxel(result.stock, smallest_radius(cuts));
    options.voxel = choice.voxel;
    result.voxel_reason = choice.reason;
  }
  result.voxel = options.voxel;
}

// Default tolerance of the mesh, as a share of the longest side: a turned part of the usual shape
// keeps its volume within 0.03 % (docs/accuracy.md) in a run of a second.
constexpr double kToleranceShare = 1.7e-4;

// Who sets the voxel wants its grid; else the mesh has a tolerance that goes with the part's size.
void choose_tolerance(const Job& job, MeshOptions& options, JobResult& result) {
  result.tolerance_reason = "--tolerance";
  if (options.tolerance == 0 && job.carve.voxel == 0) {
    const Vec3 size = result.stock.box.hi - result.stock.box.lo;
    const double longest = std::max({size.x, size.y, size.z});
    options.tolerance = longest * kToleranceShare;
    result.tolerance_reason = fmt::format("0.017 % of the longest side, {:.6g} mm", longest);
    if (job.accept > 0 && options.tolerance > job.accept / 4) {
      options.tolerance = job.accept / 4;
      result.tolerance_reason = fmt::format("a quarter of --accept, {:.6g} mm", job.accept);
    }
  }
  result.tolerance = options.tolerance;
}

// Exact where the stock is a primitive; a stock that has been cut before is meshed as it was.
double volume_before(const StockShape& shape, CarveOptions options, const MeshOptions& mesh) {
  if (!shape.history.motions.empty()) {
    options.keep_grid = false;  // of a stock that only its volume is asked of
    ContourReport found;
    const Stock stock = carve(shape, shape.history.motions, shape.history.tools, options);
    MeshAudit audit(mesh.threads);
    extract_mesh(stock, mesh, audit, &found);
    return audit.summary().volume - found.volume_excess;
  }
  const Vec3 size = shape.box.hi - shape.box.lo;
  if (shape.kind == StockShape::Kind::box) return size.x * size.y * size.z;
  if (shape.kind == StockShape::Kind::mesh) return signed_volume(shape.mesh);
  const double outer = shape.outer_radius, inner = shape.inner_radius;
  return kPi * (outer * outer - inner * inner) * size.z;
}

// `excess`: what the mesh holds more than the exact part, mm^3.
void summarize_part(JobResult& result, PartMesh& part, const CutList& cuts, double excess) {
  result.summary = part.summary();
  const MeshSummary& s = result.summary;
  if (!s.closed || !s.oriented || !s.manifold || s.degenerate > 0)
    throw InternalError("the part's mesh breaks its promise: " + s.first_fault);
  part.set_origin(owner_table(part.owners(), cuts));
  result.triangles = part.source().triangles();
  result.volume = s.volume - excess;
  result.removed_volume = result.stock_volume - result.volume;
}

// A few by name: a stock shot through may leave thousands of crumbs.
std::string describe_detached(const std::vector<Piece>& pieces) {
  constexpr std::size_t kNamed = 4;
  std::string text;
  for (std::size_t i = 1; i < std::min(pieces.size(), kNamed); ++i)
    text += (i > 1 ? "; " : "") + describe_piece(pieces[i]);
  if (pieces.size() > kNamed) text += fmt::format("; and {} more", pieces.size() - kNamed);
  return text;
}

// Dropping was asked for, so it is a note; pieces left lying in the part are a warning.
void keep_pieces(JobResult& result, PartMesh& part, const Job& job) {
  const std::vector<Piece> pieces = find_pieces(part.audit(), part.source());
  const bool drop = job.keep == KeepPieces::largest;
  for (const Piece& piece : pieces)
    result.pieces.push_back({piece.volume, piece.center, piece.bounds, piece.triangles,
                             !drop || result.pieces.empty()});
  if (pieces.size() < 2) return;
  const std::string found = describe_detached(pieces);
  if (!drop)
    return report(result, Severity::warning, "detached-pieces",
                  fmt::format("the part is in {} pieces: {}; --keep largest drops all but the "
                              "largest",
                              pieces.size(), found));
  part.keep(pieces[0]);
  report(result, Severity::note, "pieces-dropped",
         fmt::format("the part was in {} pieces, the largest is kept; dropped: {}", pieces.size(),
                     found));
  if (writes_vdb(job))
    report(result, Severity::note, "pieces-in-vdb",
           "the .vdb holds all pieces: it is the stock and its cuts");
}

void report_mesh(JobResult& result, const ContourReport& found) {
  result.mesh_bound = found.bound;
  result.mesh_sampled = found.sampled;
  if (found.unresolved > 0)
    report(result, Severity::warning, "tolerance-missed",
           fmt::format("{} places stay above the tolerance of {:.6g} mm; a smaller --voxel helps",
                       found.unresolved, result.tolerance));
  if (!found.thin.empty()) {
    const ThinFeature& first = found.thin.front();
    report(result, Severity::warning, "thin-feature",
           fmt::format("{} walls or gaps are thinner than a voxel and may be missing, the first a "
                       "{} of {:.3g} mm at ({:.3f}, {:.3f}, {:.3f}); a smaller --voxel shows them",
                       found.thin.size(), first.wall ? "wall" : "gap", first.thickness,
                       first.place.x, first.place.y, first.place.z));
  }
}

// Empty where the run can be done in slabs, should memory be short.
std::string no_slabs(const Job& job, const MeshOptions& mesh) {
  if (mesh.tolerance > 0)
    return "a mesh with a tolerance is made in one piece: with --voxel and no --tolerance the run "
           "is done in slabs";
  if (job.whole_mesh || job.inspect)
    return "a comparison or report needs the whole mesh: without it the run is done in slabs";
  return whole_output(job.outputs);
}

void report_slabs(JobResult& result, const PartMesh& part, const Stock& stock) {
  result.slabs = part.blocks();
  report(result, Severity::note, "slabs",
         fmt::format("done in {} slabs, to stay below {:.3g} GB: in one piece it would take about "
                     "{:.3g} GB",
                     part.blocks(), static_cast<double>(stock.memory_limit()) / 1e9,
                     stock.memory_whole() / 1e9));
}

// Makes the mesh, which is checked as it comes.
void make_mesh(JobResult& result, PartMesh& part, const Stock& stock, const MeshOptions& options,
               ContourReport& found) {
  extract_mesh(stock, options, part, &found);
  if (part.source().triangles() == 0) throw Error("part-empty", "nothing is left of the stock");
  if (stock.in_slabs()) report_slabs(result, part, stock);
  if (part.owners().back() < 0)
    report(result, Severity::warning, "nothing-cut",
           "no cut meets the stock: check the stock's place and the work offset");
  report_mesh(result, found);
}

void require_cuts(const Job& job, const JobResult& result) {
  if (result.cutting_motions == 0)
    throw Error("program-no-cuts",
                job.program + " cuts nothing: it has no G1, G2 or G3 whose start is known");
}

}  // namespace

Program interpret(const std::string& path, const InterpOptions& options) {
  Collector collector(path);
  Program program = interpret(path, options, collector);
  program.motions = std::move(collector.motions);
  program.diagnostics = std::move(collector.diagnostics);
  return program;
}

Program trace(const std::string& path, const InterpOptions& options, bool json,
              const TraceSink& sink) {
  TraceSinkAdapter adapter(sink, json);
  return interpret(path, options, adapter);
}

ToolTable load_tools(const std::string& path) { return load_tools_file(path); }
JobFile load_job(const std::string& path) { return load_job_file(path); }
Tool parse_tool(const std::string& spec) { return parse_tool_spec(spec); }

StockShape load_stock(const std::string& spec, const StockOptions& options) {
  if (std::optional<StockShape> shape = parse_stock_spec(spec)) return *shape;
  if (is_vdb(spec)) return read_vdb(read_file(spec), spec).shape;
  TriMesh mesh = is_step(spec) ? read_step(spec) : read_mesh(spec);
  const std::string repairs = make_solid(mesh, spec);
  StockShape shape = recognise_stock(std::move(mesh), options, spec);
  shape.repairs = repairs;
  if (shape.kind == StockShape::Kind::mesh) refuse_self_intersections(shape.mesh, spec);
  return shape;
}

void render(const TriMesh& mesh, const std::string& png_path, const RenderOptions& options) {
  write_file_atomically(png_path, [&](const ByteSink& out) { render_mesh(mesh, options, out); });
}

MeshSummary summarize(const TriMesh& mesh) { return check_mesh(mesh); }

JobResult simulate(const Job& job) {
  JobResult result;
  StageClock clock(result);
  check_outputs(job.outputs);
  const std::future<void> opening = writes_vdb(job) ? open_voxel_module() : std::future<void>();
  result.program = interpret(job.program, job.interp);
  count_motions(result);
  clock.done("read");
  if (is_faulty(result, job.strict)) return result;
  require_cuts(job, result);

  result.stock = choose_stock(job, result);
  const CutList cuts(result.stock.history, result.program);
  CarveOptions options = job.carve;
  choose_voxel(options, cuts, result);
  MeshOptions mesh_options = job.mesh;
  choose_tolerance(job, mesh_options, result);
  options.grid_mesh = mesh_options.tolerance == 0;
  options.keep_grid = writes_vdb(job);  // nothing else reads the samples
  options.no_slabs = no_slabs(job, mesh_options);
  clock.done("stock");

  const Stock stock = carve(result.stock, cuts.motions(), cuts.tools(), options);
  result.active_voxels = stock.active_voxels();
  clock.done("carve");
  result.collisions =
      find_collisions(stock, cuts.motions(), cuts.tools(), cuts.inherited(), job.collisions);
  add_collisions(result.program, cuts, result.collisions);
  clock.done("collisions");
  ContourReport contour_report;
  MeshFileOptions files = job.files;
  files.threads = job.mesh.threads;
  // Blocks on the voxels come while the threads make the next ones.
  const int block_threads = mesh_options.tolerance > 0 ? mesh_options.threads : 1;
  Outputs outputs(job.outputs, files, block_threads);
  PartMesh part(stock.in_slabs() ? std::optional(spill_folder(job.outputs)) : std::nullopt,
                block_threads, outputs);
  mesh_options.max_memory =
      stock.memory_limit() - static_cast<std::size_t>(stock.memory_expected());
  make_mesh(result, part, stock, mesh_options, contour_report);
  result.expected_memory =
      static_cast<std::size_t>(stock.memory_expected() + contour_report.memory);
  clock.done("mesh");
  result.stock_volume = volume_before(result.stock, options, mesh_options);
  keep_pieces(result, part, job);
  const bool is_whole = std::all_of(result.pieces.begin(), result.pieces.end(),
                                    [](const PartPiece& piece) { return piece.kept; });
  if (!is_whole) outputs.replace_mesh();
  summarize_part(result, part, cuts, is_whole ? contour_report.volume_excess : 0);
  clock.done("check");
  if (is_faulty(result, job.strict)) return result;
  if (job.inspect) {
    job.inspect(part.in_memory());
    clock.done("inspect");
  }

  StockRecipe recipe;
  if (writes_vdb(job)) {
    recipe = {result.stock, result.voxel};
    recipe.shape.history = cuts.history();
  }
  outputs.finish(part.source(), stock, recipe);
  clock.done("write");
  result.mesh = std::move(part.in_memory());
  result.stock.mesh = {};
  result.peak_memory = peak_memory();
  result.ok = true;
  return result;
}

const char* version() { return MRSIM_VERSION; }

}  // namespace mrsim
