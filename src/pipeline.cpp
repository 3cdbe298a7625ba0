// The facade: calls the stages in order.

#include "collision_findings.h"
#include "core/error.h"
#include "core/heap.h"
#include "core/memory_limit.h"
#include "core/text_io.h"
#include "core/units.h"
#include "core/vec.h"
#include "cuts.h"
#include "interp/interpreter.h"
#include "interp/show/motion_text.h"
#include "mesh/draw/render.h"
#include "mesh/extract.h"
#include "mesh/solid/check.h"
#include "mesh/solid/pieces.h"
#include "mesh/solid/solid_repair.h"
#include "mesh_choice.h"
#include "outputs.h"
#include "part_mesh.h"
#include "removal/collision/collisions.h"
#include "removal/part/default_stock.h"
#include "removal/part/stock.h"
#include "removal/part/stock_file.h"
#include "removal/stock/stock_shape.h"
#include "setup/camotics_project.h"
#include "setup/job_file.h"
#include "setup/machine_file.h"
#include "setup/stock_spec.h"
#include "setup/tool_spec.h"
#include "until.h"
#include "voxel_module.h"
#include <mrsim/memory.h>
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
    const double most = memory_left() / 4 / sizeof(Motion);
    if (!failed && double(bytes) / kLineBytes <= most) reserve_large(motions, bytes / kLineBytes);
  }
  void motion(const Motion& motion) override {
    if (motions.size() == motions.capacity() && motions.size() > kFew)
      require_memory(2.0 * double(motions.size()) * sizeof(Motion),
                     fmt::format("a program of more than {} motions", motions.size()));
    motions.push_back(motion);
  }
  void diagnostic(const Diagnostic& diagnostic) override { diagnostics.push_back(diagnostic); }
  std::vector<Motion> motions;
  std::vector<Diagnostic> diagnostics;

 private:
  static constexpr std::size_t kFew = 10000;  // of which nothing is asked
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
  void assignment(const SourcePlace& place, const std::string& name,
                  const std::string& value) override {
    if (!sink_.line) return;
    sink_.line(json_ ? fmt::format(R"({{"line":{},"kind":"variable","name":{},"value":{}}})",
                                   place.line, json_string(name), json_string(value))
                     : fmt::format("{:5}     {} = {}", place.line, name, value));
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

// A coarse mesh may decide the verdict instead of the part.
void warn_of_coarse_tolerance(const Job& job, double tolerance, JobResult& result) {
  if (job.accept > 0 && tolerance > job.accept / 4 * (1 + 1e-9))
    report(result, Severity::warning, "tolerance-coarse",
           fmt::format("a tolerance of {:g} mm is coarse for an --accept of {:g} mm: use a quarter "
                       "of it or less",
                       tolerance, job.accept));
}

// Exact where the stock is a primitive; a stock that has been cut before is meshed as it was.
double volume_before(const StockShape& shape, CarveOptions options, const MeshOptions& mesh) {
  if (!shape.history.motions.empty()) {
    options.keep_grid = false;  // of a stock that only its volume is asked of
    MeshReport found;
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

void tell_choice(JobResult& result, const MeshChoice& choice) {
  result.voxel = choice.voxel;
  result.voxel_reason = choice.voxel_reason;
  result.tolerance = choice.tolerance;
  result.tolerance_reason = choice.tolerance_reason;
}

void report_mesh(JobResult& result, const MeshReport& found) {
  result.mesh_bound = found.bound;
  result.mesh_usual = found.usual;
  result.mesh_sampled = found.sampled;
  result.mesh_kept = found.kept;
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
std::string no_slabs(const Job& job, double tolerance) {
  if (tolerance > 0)
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
               MeshReport& found) {
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

void end_program(const Job& job, JobResult& result) {
  Program& program = result.program;
  const std::size_t all = program.motions.size(), kept = motions_until(program, job.until);
  program.motions.resize(kept);
  count_motions(result);
  report(result, Severity::note, "until",
         fmt::format("--until {}: the program ends after {} of {} motions", job.until, kept, all));
  require_cuts(job, result);
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

JobFile load_job(const std::string& path, bool allow_outside) {
  return path.ends_with(".camotics") ? load_camotics_project(path)
                                     : load_job_file(path, allow_outside);
}
MachineData load_machine(const std::string& path) { return load_machine_file(path); }
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
  const MemoryLimit limit(job.carve.max_memory);
  JobResult result;
  simulate(job, result);
  return result;
}

void simulate(const Job& job, JobResult& result) {
  StageClock clock(result);
  check_outputs(job);
  const std::future<void> opening = writes_vdb(job) ? open_voxel_module() : std::future<void>();
  result.program = interpret(job.program, job.interp);
  protect_program_files(job, result.program.files);
  count_motions(result);
  clock.done("read");
  if (is_faulty(result, job.strict)) return;
  require_cuts(job, result);

  result.stock = choose_stock(job, result);
  if (!job.until.empty()) end_program(job, result);
  result.cycle = cycle_time(result.program, job.machine);
  const CutList cuts(result.stock.history, result.program);
  CarveOptions options = job.carve;
  MeshChoice choice = choose_mesh(job, result.stock, cuts);
  options.keep_grid = writes_vdb(job);  // nothing else reads the samples
  clock.done("stock");
  if (is_faulty(result, job.strict)) return;

  const Stock stock = carve(result.stock, cuts.motions(), cuts.tools(), options,
                            [&](const ExactField& field, CarveOptions& chosen) {
                              fit_mesh(field, job.mesh.threads, choice);
                              chosen.voxel = choice.voxel;
                              chosen.grid_mesh = choice.tolerance == 0;
                              chosen.no_slabs = no_slabs(job, choice.tolerance);
                            });
  MeshOptions mesh_options = job.mesh;
  mesh_options.tolerance = choice.tolerance;
  mesh_options.measure = choice.measure;
  mesh_options.fallback_voxel = choice.fallback_voxel;
  result.active_voxels = stock.active_voxels();
  clock.done("carve");
  result.collisions =
      find_collisions(stock, cuts.motions(), cuts.tools(), cuts.inherited(), job.collisions);
  add_collisions(result.program, cuts, result.collisions);
  clock.done("collisions");
  MeshReport mesh_report;
  MeshFileOptions files = job.files;
  files.threads = job.mesh.threads;
  // Blocks on the voxels come while the threads make the next ones.
  const int block_threads = mesh_options.tolerance > 0 ? mesh_options.threads : 1;
  Outputs outputs(job.outputs, files, block_threads);
  PartMesh part(stock.in_slabs() ? std::optional(spill_folder(job.outputs)) : std::nullopt,
                block_threads, outputs);
  mesh_options.max_memory =
      stock.memory_limit() - static_cast<std::size_t>(stock.memory_expected());
  make_mesh(result, part, stock, mesh_options, mesh_report);
  if (!mesh_report.given_up.empty()) give_up_tolerance(choice, mesh_report.given_up);
  tell_choice(result, choice);
  warn_of_coarse_tolerance(job, choice.tolerance, result);
  result.expected_memory = static_cast<std::size_t>(stock.memory_expected() + mesh_report.memory);
  clock.done("mesh");
  result.stock_volume = volume_before(result.stock, options, mesh_options);
  keep_pieces(result, part, job);
  const bool is_whole = std::all_of(result.pieces.begin(), result.pieces.end(),
                                    [](const PartPiece& piece) { return piece.kept; });
  if (!is_whole) outputs.replace_mesh();
  summarize_part(result, part, cuts, is_whole ? mesh_report.volume_excess : 0);
  clock.done("check");
  if (is_faulty(result, job.strict)) return;
  if (job.inspect) {
    job.inspect(part.in_memory());
    clock.done("inspect");
  }

  StockRecipe recipe;
  if (writes_vdb(job)) {
    recipe = {result.stock, result.voxel};
    recipe.shape.history = cuts.history();
  }
  outputs.complete(part.source(), stock, recipe, job.hash_files, result.files);
  result.mesh = std::move(part.in_memory());
  result.stock.mesh = {};
  result.peak_memory = peak_memory();
  clock.done("write");
  outputs.publish(job, result);
  clock.done("publish");
  result.ok = true;
}

const char* version() { return MRSIM_VERSION; }

void set_memory_limit(std::size_t bytes) { set_thread_limit(bytes); }

}  // namespace mrsim
