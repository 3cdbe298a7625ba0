#include "run/findings/part_findings.h"

#include "core/numbers/motions.h"
#include "core/numbers/rounding.h"
#include "core/process/error.h"
#include "core/process/memory_limit.h"
#include "mesh/solid/pieces.h"
#include "removal/part/stock_margin.h"
#include "run/findings/thread_passes.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

// A few by name: a stock shot through may leave thousands of crumbs.
std::string describe_detached(const std::vector<Piece>& pieces) {
  constexpr std::size_t kNamed = 4;
  std::string text;
  for (std::size_t i = 1; i < std::min(pieces.size(), kNamed); ++i)
    text += (i > 1 ? "; " : "") + describe_piece(pieces[i]);
  if (pieces.size() > kNamed) text += fmt::format("; and {} more", pieces.size() - kNamed);
  return text;
}

std::string describe(const ThinPlace& thin) {
  return fmt::format("a {} of {:.3g} mm at ({:.3f}, {:.3f}, {:.3f})", thin.wall ? "wall" : "gap",
                     thin.thickness, thin.place.x, thin.place.y, thin.place.z);
}

void warn_of_thin(JobResult& result) {
  const std::size_t count = result.thin.size();
  const std::string advice = "a smaller --voxel shows what is thinner than the voxel";
  report(result, Severity::warning, "thin-feature",
         count == 1
             ? fmt::format("{} may be missing in the mesh; {}", describe(result.thin[0]), advice)
             : fmt::format("{} walls or gaps may be missing in the mesh, the thickest {}; {}",
                           count, describe(result.thin[0]), advice));
}

// Whether a milling tool cuts at or above the stock's top only, as a face mill at the zero does.
bool cuts_above(const Program& program, int tool, double top) {
  return program.machine == MachineKind::mill &&
         std::all_of(program.motions.begin(), program.motions.end(), [&](const Motion& m) {
           return m.tool != tool || !is_cut(m) || std::min(m.start.z, m.end.z) > top - kSameHeight;
         });
}

std::string raw_face(const Box3& box) {
  return fmt::format(
      "it cuts at Z{:.6g} and above, where the stock that was taken ends; where the raw part is "
      "higher by 1 mm, say --stock box:{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}",
      box.hi.z, box.lo.x, box.lo.y, box.lo.z, box.hi.x, box.hi.y, box.hi.z + 1);
}

}  // namespace

void report(JobResult& result, Severity severity, const char* code, const std::string& text) {
  Diagnostic diagnostic;
  diagnostic.severity = severity;
  diagnostic.code = code;
  diagnostic.text = text;
  diagnostic.place.file = result.program.files.empty() ? "" : result.program.files[0];
  result.program.diagnostics.push_back(diagnostic);
}

void warn_of_coarse_mesh(const Job& job, JobResult& result) {
  if (!(job.accept > 0)) return;
  const double most = job.accept / 4 * (1 + kShareRounding);
  const auto warn = [&](const std::string& text) {
    report(result, Severity::warning, "tolerance-coarse",
           fmt::format("{} for an --accept of {:g} mm: ", text, job.accept) +
               (result.reduction.most > 0 ? "the deviations are those of the reduced mesh"
                                          : "use a quarter of it or less for --tolerance"));
  };
  if (result.tolerance > most)
    warn(fmt::format("a tolerance of {:g} mm is coarse", result.tolerance));
  else if (result.tolerance == 0 && result.mesh_bound > most)
    warn(fmt::format("a mesh that is up to {:.3g} mm beside the exact part is coarse",
                     result.mesh_bound));
  else if (result.reduction.most > most)
    warn(fmt::format("--max-triangles moved the mesh by up to {:.3g} mm, which is coarse",
                     result.reduction.most));
}

void summarize_part(JobResult& result, MeshStore& part, const CutList& cuts, double volume) {
  result.summary = part.summary();
  const MeshSummary& s = result.summary;
  if (!s.closed || !s.oriented || !s.manifold || s.degenerate > 0)
    throw InternalError("the part's mesh breaks its promise: " + s.first_fault);
  part.set_origin(owner_table(part.owners(), cuts));
  result.triangles = part.source().triangles();
  result.volume = std::min(volume, result.stock_volume);  // the sum of what was sampled may err
  result.removed_volume = result.stock_volume - result.volume;
}

// Dropping was asked for, so it is a note; pieces left lying in the part are a warning.
void keep_pieces(JobResult& result, MeshStore& part, KeepPieces keep, bool in_vdb) {
  const std::vector<Piece> pieces = find_pieces(part.audit(), part.source());
  const bool drop = keep == KeepPieces::largest;
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
  if (in_vdb)
    report(result, Severity::note, "pieces-in-vdb",
           "the .vdb holds all pieces: it is the stock and its cuts");
}

void warn_of_threads(JobResult& result) {
  ThreadPasses threads;
  for (const Motion& m : result.program.motions) threads.add(result.program, m);
  for (Diagnostic& d : threads.warnings(result.program))
    result.program.diagnostics.push_back(std::move(d));
}

void warn_of_idle_tools(JobResult& result, bool stock_assumed) {
  constexpr double kSeen = 3;  // columns of the history in a tool's diameter
  Program& program = result.program;
  for (const auto& [tool, removal] : result.history.tools) {
    if (removal.removed > 0 || result.history.total.removed == 0) continue;
    const auto first = std::find_if(
        program.motions.begin(), program.motions.end(),
        [&, of = tool](const Motion& m) { return m.tool == of && is_cut(m) && m.lead == 0; });
    if (tool < 0 || first == program.motions.end()) continue;  // threads are not cut
    const Tool& data = program.tools[static_cast<std::size_t>(tool)];
    if (!is_turning(data.type) && data.diameter < kSeen * result.history.voxel) continue;
    Diagnostic& d = program.diagnostics.emplace_back();
    d.severity = Severity::warning;
    d.code = "tool-cuts-air";
    d.text = fmt::format(
        "tool {} removes nothing: {}", data.id,
        stock_assumed && cuts_above(program, tool, result.stock.box.hi.z)
            ? raw_face(result.stock.box)
            : "all that it cuts here is air, or has been cut before; check its data, the "
              "offsets of its length and radius, and the stock");
    d.place = source_place(program, *first);
  }
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
  for (const ThinFeature& f : found.thin) result.thin.push_back({f.place, f.wall, f.thickness});
  std::stable_sort(
      result.thin.begin(), result.thin.end(),
      [](const ThinPlace& a, const ThinPlace& b) { return a.thickness > b.thickness; });
  if (!found.thin.empty()) warn_of_thin(result);
}

void report_slabs(JobResult& result, const MeshStore& part, const Stock& stock) {
  result.slabs = part.blocks();
  const auto limit = static_cast<double>(stock.memory_limit());
  report(result, Severity::note, "slabs",
         fmt::format(
             "done in {} slabs, to stay below {}: in one piece it would take {}", part.blocks(),
             size_text(limit),
             stock.memory_whole() > limit ? "about " + size_text(stock.memory_whole()) : "more"));
}

}  // namespace mrsim
