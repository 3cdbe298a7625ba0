#include "mesh/adaptive.h"

#include "core/numbers/rounding.h"
#include "core/process/error.h"
#include "core/process/parallel.h"
#include "mesh/cells/cell_halvings.h"
#include "mesh/cells/flat_map.h"
#include "mesh/cells/lost_cells.h"
#include "mesh/cells/mesh_memory.h"
#include "mesh/cells/node_budget.h"
#include "mesh/cells/step_timer.h"
#include "mesh/cells/thin_features.h"
#include "mesh/simplify/failed_triangles.h"
#include "mesh/simplify/mesh_certifier.h"
#include "mesh/simplify/owner_borders.h"
#include "mesh/simplify/simplify_apart.h"
#include "mesh/surface/crossed_cells.h"
#include "mesh/surface/dual_surface.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

using detail::BaseMesh;
using detail::CellOctree;
using detail::Detail;
using detail::DualSurface;
using detail::FailedTriangles;
using detail::FoundThin;
using detail::LabelledMesh;
using detail::Lattice;
using detail::NodeBudget;
using detail::StepTimer;

constexpr double kBorderShare = 1.0 / 8;  ///< of the voxel, for borders between owners
constexpr int kCrowdedRounds = 3;         ///< of splitting cells with two pieces of surface
constexpr double kSecondsPerByte = 3e-8;  ///< of one core: time and memory both grow with the cells
constexpr std::size_t kMostRounds = 64;   ///< of splitting, where a grid may take its place
constexpr std::size_t kCarefulRounds = 4;  ///< of splitting, by one step each
constexpr int kLateSteps = 3;              ///< of splitting in one round after those
constexpr double kMostDrawn = 0.4;         ///< share of loops up to which only these are drawn anew
constexpr std::size_t kDrawnRounds = 8;    ///< in which more detail may take the place of splitting
constexpr int kLostRounds = 3;             ///< of splitting cells about walls that were lost

class AdaptiveMesher {
 public:
  AdaptiveMesher(const ExactField& field, const Lattice& lattice, const MeshPlan& options,
                 NodeBudget& budget, MeshReport& report)
      : field_(field),
        options_(options),
        tolerance_(budget.tolerance()),
        budget_(budget),
        report_(report),
        timer_(report, options.progress),
        tree_(field, lattice, budget.tolerance(), options.threads,
              {options.max_memory, static_cast<std::size_t>(budget_.most())}),
        surface_(std::in_place, field, tree_, surface_options()) {
    timer_.step("tree");
  }

  TriMesh run() {
    try {
      return mesh();
    } catch (const Error&) {
      report_.memory = taken();
      throw;
    }
  }

 private:
  DualSurface::Options surface_options() const {
    return {
        .shallow = tolerance_ / 8, .sharpen = true, .remember = true, .threads = options_.threads};
  }

  // Bytes so far, an estimate.
  double taken() const {
    return most_loops_ > 0 ? detail::memory_of_mesh(tree_, surface_->mesh().triangles.size())
                           : detail::memory_of_loops(tree_, surface_->loops().size());
  }

  TriMesh mesh() {
    const double memory = detail::expected_memory(field_, tree_, tolerance_, options_.threads);
    detail::require_mesh_memory(memory, options_.max_memory, tolerance_);
    tree_.mark_drawn();  // their surface is part of the expected memory
    detail::require_cells(detail::expected_nodes(memory), budget_.most_expected());
    timer_.expect(kSecondsPerByte * memory / resolve_threads(options_.threads));
    timer_.step("tree");
    budget_.begin(tree_.size());
    find_topology();
    detail::require_cells(budget_.nodes_after_first(0, tree_.size()), budget_.most());
    for (int k = 0; k < kCrowdedRounds && tree_.split(surface_->crowded()) > 0; ++k)
      find_topology();
    detail::require_cells(budget_.nodes_after_first(0, tree_.size()), budget_.most());
    make_triangles();
    mend_all();
    std::optional<LabelledMesh> without_lost;
    for (int k = 0; k < kLostRounds && !without_lost && find_lost(without_lost);) ++k;
    return finished(without_lost ? std::move(*without_lost) : drawn());
  }

  // Splits cells until all triangles are within the tolerance.
  void mend_all() {
    while (mend_failed() || !is_whole_) {
      if (options_.most_nodes > 0 && report_.passes >= kMostRounds)
        throw Error("mesh-unresolved", "cells were split too many times");
      is_whole_ = draws_all();
      find_topology();
      make_triangles();
    }
  }

  // The mesh of the surface as it is drawn.
  LabelledMesh drawn() const {
    LabelledMesh mesh = detail::labelled_mesh(*surface_);
    detail::drop_unused_vertices(mesh);
    return mesh;
  }

  // What the mesh has lost that is at least `thinnest` mm thick.
  std::vector<FoundThin> lost_from(const LabelledMesh& mesh, double thinnest) const {
    return detail::lost_features(field_, tree_, tree_.doubtful_edges(), detail::to_tri_mesh(mesh),
                                 tolerance_, thinnest, options_.threads);
  }

  // The mesh, simplified, with what it has lost in the report. The surface is gone then.
  TriMesh finished(LabelledMesh mesh) {
    report_.cells = surface_->loops().size();
    surface_.reset();
    passed_ = detail::FlatMap();
    tree_.shorten_lists();
    mesh = detail::cut_owner_borders(field_, tree_, mesh, border_room(), options_.threads);
    timer_.step("borders");
    report_.triangles_before = mesh.triangles.size();
    report_.memory =
        std::max(report_.memory, detail::memory_of_mesh(tree_, report_.triangles_before));
    mesh = simplified(mesh);
    const std::vector<FoundThin> lost = lost_from(mesh, 0);
    timer_.step("thin");
    const detail::MeshCertifier::Total total = certifier().total(mesh, lost);
    report_.tolerance = tolerance_;
    report_.bound = total.bound;
    report_.sampled = total.sampled;
    report_.volume_excess = certifier().volume_excess(mesh);
    report_.thin = detail::distinct(lost);
    timer_.step("certify");
    return detail::to_tri_mesh(mesh);
  }

  // Draws the surface once more where it has lost something, on smaller cells. False: nothing is
  // lost, or there is no room for such cells. Where the mesh on them takes too much, `before` is
  // the one without what is lost.
  bool find_lost(std::optional<LabelledMesh>& before) {
    LabelledMesh mesh = drawn();
    const std::vector<FoundThin> lost = lost_from(mesh, tolerance_);
    timer_.step("thin");
    const MeshReport report = report_;
    budget_.begin_lost();
    tree_.go_on_within(tolerance_, static_cast<std::size_t>(budget_.most()));
    try {
      if (detail::split_lost(tree_, lost, tolerance_, room_for_lost()) == 0) return false;
      timer_.step("tree");
      redrawn_.clear();
      is_whole_ = draws_all();
      find_topology();
      make_triangles();
      mend_all();
      return true;
    } catch (const Error& error) {
      if (error.code() != "mesh-unresolved" && error.code() != "memory") throw;
      report_.passes = report.passes;
      report_.unresolved = report.unresolved;
      before = std::move(mesh);
      return false;
    }
  }

  double room_for_lost() const {
    const auto memory = static_cast<double>(options_.max_memory);
    return detail::room_for_lost(tree_.size(), budget_.most(),
                                 memory > 0 ? memory - taken() : kInfinity);
  }

  // Leaves that were made, or are to be drawn more finely, since triangles were measured last.
  std::vector<char> changed_cells() const {
    std::vector<char> changed(tree_.size());
    for (const std::int32_t c : redrawn_) changed[static_cast<std::size_t>(c)] = 1;
    std::fill(changed.begin() + static_cast<std::ptrdiff_t>(measured_nodes_), changed.end(), 1);
    return changed;
  }

  // While little changes, only the surface about it is drawn and measured; when nothing fails there
  // any more, all of it once again.
  bool draws_all() const {
    if (redrawn_.empty() && measured_nodes_ == tree_.size()) return true;
    std::vector<char> drawn = changed_cells();
    for (int rings = 0; rings < 2; ++rings) tree_.add_neighbours(drawn);
    std::size_t crossed = 0;
    for (std::size_t n = 0; n < drawn.size(); ++n)
      crossed += drawn[n] && tree_.node(static_cast<std::int32_t>(n)).signs_differ;
    return static_cast<double>(crossed) > kMostDrawn * static_cast<double>(most_loops_);
  }

  // Splits cells until the crossings on every face can be joined, then joins them.
  void find_topology() {
    detail::CrossedGrid grid = is_whole_ ? detail::split_badly_crossed(tree_)
                                         : detail::split_badly_crossed(tree_, changed_cells());
    timer_.step("tree");
    detail::require_room(detail::kSurfaceMemory * static_cast<double>(tree_.undrawn()));
    tree_.mark_drawn();
    budget_.add_round(is_whole_ ? tree_.size()
                                : static_cast<std::size_t>(
                                      std::count(grid.complete.begin(), grid.complete.end(), 1)));
    surface_->find_loops(std::move(grid));
    ++report_.passes;
    timer_.step("loops");
  }

  // Makes triangles; cells with several pieces of surface whose triangles meet are split.
  void make_triangles() {
    for (;;) {
      const std::size_t loops = std::max(surface_->loops().size(), most_loops_);
      detail::require_room(detail::kLoopMemory * static_cast<double>(loops - most_loops_));
      most_loops_ = loops;
      surface_->make_triangles();
      timer_.step("surface");
      const std::vector<std::int32_t> bad =
          detail::crossed_cells(*surface_, tree_.size(), options_.threads);
      timer_.step("check");
      if (bad.empty()) {
        require_room(detail::kSharpenMemory);
        surface_->sharpen(tree_);
        timer_.step("sharpen");
        return;
      }
      if (tree_.split(bad) > 0)
        find_topology();
      else if (!surface_->flatten(bad))
        throw Error("mesh-unresolved", "pieces of surface in one cell of the mesh meet");
    }
  }

  void require_room(double bytes_of_a_triangle) const {
    const auto triangles = static_cast<double>(surface_->mesh().triangles.size());
    detail::require_room(bytes_of_a_triangle * triangles);
  }

  FailedTriangles find_failures() const {
    return detail::failed_triangles(field_, tree_, *surface_, passed_,
                                    {.tolerance = tolerance_,
                                     .may_draw = report_.passes <= kDrawnRounds,
                                     .is_late = report_.passes > kCarefulRounds && few_failed_,
                                     .threads = options_.threads});
  }

  // Raises the tolerance until the cells that fail may be split; throws where it must not be raised
  // so far.
  FailedTriangles find_failures_that_fit() {
    FailedTriangles found = find_failures();
    while (!budget_.fits(found.cells, tree_.size())) {
      if (!budget_.may_raise())
        throw Error("mesh-unresolved", detail::too_many_cells(budget_.most()));
      budget_.raise(tree_.size());
      tolerance_ = budget_.tolerance();
      tree_.go_on_within(tolerance_, static_cast<std::size_t>(budget_.most()));
      found = find_failures();
    }
    return found;
  }

  // Splits cells whose triangles are not within the tolerance, or has places drawn more finely.
  // False when all triangles that are drawn are good, or no cell is left that can be split.
  bool mend_failed() {
    require_room(detail::kCertifyMemory);
    const FailedTriangles found = find_failures_that_fit();
    measured_nodes_ = tree_.size();
    const std::size_t refined = refine(found);
    std::vector<std::int32_t> cells;
    report_.unresolved = 0;
    for (const auto& f : found.guilty) {
      cells.insert(cells.end(), f.begin(), f.end());
      bool can = f.empty();
      for (const std::int32_t c : f) can = can || tree_.can_split(c);
      report_.unresolved += !can;
    }
    timer_.step("certify");
    const std::size_t count = split(std::move(cells));
    timer_.step("tree");
    return count + refined > 0;
  }

  // Draws the surface more finely where that is enough, and remembers which triangles need no more
  // looks. Returns how many places are drawn anew.
  std::size_t refine(const FailedTriangles& found) {
    const BaseMesh& base = surface_->mesh();
    std::size_t refined = 0;
    redrawn_.clear();
    for (std::size_t t = 0; t < found.hashes.size(); ++t)
      if (found.wanted[t] != Detail::flat) {
        const detail::Crossing& crossing = detail::at(surface_->crossings(), base.crossings[t]);
        surface_->refine(crossing, found.wanted[t]);
        redrawn_.insert(redrawn_.end(), crossing.edge.cells, crossing.edge.cells + 4);
        ++refined;
      } else if (found.guilty[t].empty()) {
        passed_.insert(found.hashes[t], 0);
      }
    return refined;
  }

  // Returns how many cells were split. After some rounds their parts are split, too, while they are
  // few: that costs less than another round.
  std::size_t split(std::vector<std::int32_t> cells) {
    const bool goes_on = report_.passes > kCarefulRounds;
    const auto failed = static_cast<double>(cells.size());
    const double few = NodeBudget::few(tree_.size());
    const double later = goes_on ? 8 * (kLateSteps - 1) * few : 0;
    detail::require_room(detail::kSplitMemory * (8 * failed + later));
    few_failed_ = is_few(cells.size());
    budget_.add_failed(cells.size());
    const std::size_t count = tree_.split(std::move(cells));
    for (int k = 1; goes_on && k < kLateSteps && is_few(tree_.new_leaves().size()); ++k)
      tree_.split(std::vector<std::int32_t>(tree_.new_leaves()));
    return count;
  }
  bool is_few(std::size_t cells) const { return NodeBudget::is_few(cells, tree_.size()); }

  detail::MeshCertifier certifier() const { return {field_, tree_, tolerance_, options_.threads}; }

  // mm: how far chords may leave the borders between owners on plane faces.
  double border_room() const {
    return std::max(tolerance_, kBorderShare * tree_.lattice().voxel());
  }

  LabelledMesh simplified(const LabelledMesh& mesh) {
    const double voxel = tree_.lattice().voxel();
    detail::MeshSimplifier simplifier(field_, tree_, mesh, {tolerance_, 0.5 * voxel, border_room()},
                                      options_.threads);
    detail::ApartMesh small = detail::simplify_apart(
        mesh, voxel / 9, options_.threads,
        [&](const std::vector<char>& locked) { return simplifier.simplified(locked); });
    report_.kept = small.kept;
    timer_.step("simplify");
    return std::move(small.mesh);
  }

  const ExactField& field_;
  const MeshPlan& options_;
  double tolerance_;  ///< mm
  NodeBudget& budget_;
  MeshReport& report_;
  StepTimer timer_;
  CellOctree tree_;
  std::size_t most_loops_ = 0;          ///< of all surfaces whose triangles were made
  bool is_whole_ = true;                ///< the surface is drawn everywhere
  std::size_t measured_nodes_ = 0;      ///< when triangles were measured last
  std::vector<std::int32_t> redrawn_;   ///< cells, about what is drawn more finely since
  bool few_failed_ = true;              ///< cells in the round before
  std::optional<DualSurface> surface_;  ///< until its triangles are final
  detail::FlatMap passed_;              ///< by hashes of triangles within the tolerance
};

}  // namespace

std::optional<TriMesh> adaptive_mesh(const ExactField& field, double voxel, const MeshPlan& options,
                                     MeshReport& report) {
  double memory = 0;
  std::string why;  // of the first octree, whose tolerance is the wish
  NodeBudget budget(options.most_nodes, options.tolerance, options.most_tolerance);
  for (;;) {
    const int halvings = detail::voxel_halvings(field.bounds(), voxel, budget.tolerance());
    const Lattice lattice(field.bounds(), voxel, halvings);
    try {
      TriMesh mesh = AdaptiveMesher(field, lattice, options, budget, report).run();
      report.memory = std::max(report.memory, memory);
      return mesh;
    } catch (const Error& error) {
      const bool has_no_mesh = error.code() == "mesh-unresolved";
      if ((!has_no_mesh && error.code() != "memory") || options.most_nodes == 0) throw;
      // An octree that was given up before its end held between an eighth and all of its nodes.
      const double tree = detail::kNodeMemory * static_cast<double>(options.most_nodes) / 2;
      memory = std::max(memory, report.memory > 0 ? report.memory : tree);
      if (why.empty()) why = error.what();
      const bool is_drawn = report.passes > 0;
      report = {};
      if (options.makes_new_octrees && has_no_mesh && budget.begin_again(is_drawn)) continue;
      report.memory = memory;
      report.given_up = why;
      return {};
    }
  }
}

}  // namespace mrsim
