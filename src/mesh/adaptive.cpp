#include "mesh/adaptive.h"

#include "core/process/error.h"
#include "core/process/parallel.h"
#include "mesh/cells/cell_levels.h"
#include "mesh/cells/flat_map.h"
#include "mesh/cells/mesh_memory.h"
#include "mesh/cells/node_budget.h"
#include "mesh/cells/step_timer.h"
#include "mesh/cells/thin_features.h"
#include "mesh/simplify/mesh_certifier.h"
#include "mesh/simplify/owner_borders.h"
#include "mesh/simplify/simplify_apart.h"
#include "mesh/solid/self_intersection.h"
#include "mesh/surface/input_hash.h"
#include "mesh/surface/surface.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

using detail::BaseMesh;
using detail::CellOctree;
using detail::Crossing;
using detail::Detail;
using detail::DualSurface;
using detail::InputHash;
using detail::LabelledMesh;
using detail::Lattice;
using detail::StepTimer;

constexpr double kBaseShare = 1.0;        ///< of the tolerance, for triangles before simplification
constexpr double kBorderShare = 1.0 / 8;  ///< of the voxel, for borders between owners
constexpr int kCrowdedRounds = 3;         ///< of splitting cells with two pieces of surface
constexpr double kSecondsPerByte = 3e-8;  ///< of one core: both go with the cells and their faces
constexpr std::size_t kMostRounds = 24;   ///< of splitting, where a grid may take its place
constexpr std::size_t kCarefulRounds = 4;  ///< of splitting, by one step each
constexpr int kLateSteps = 3;              ///< of splitting in one round after those
constexpr std::size_t kDrawnRounds = 8;    ///< in which more detail may take the place of splitting

class AdaptiveMesher {
 public:
  /// `tolerance`: mm, the one of `options` or what it was raised to.
  AdaptiveMesher(const ExactField& field, const Lattice& lattice, double tolerance,
                 const MeshPlan& options, MeshReport& report)
      : field_(field),
        options_(options),
        tolerance_(tolerance),
        budget_(options.most_nodes, options.most_tolerance, tolerance > options.tolerance),
        report_(report),
        timer_(report, options.progress),
        tree_(field, lattice, tolerance, options.threads,
              {options.max_memory, static_cast<std::size_t>(budget_.most())}),
        surface_(std::in_place, field, tree_,
                 DualSurface::Options{.shallow = tolerance / 8,
                                      .sharpen = true,
                                      .remember = true,
                                      .threads = options.threads}) {
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
  // Bytes so far, an estimate.
  double taken() const {
    const double of_node = report_.passes > 0 ? detail::kTriedMemory : detail::kNodeMemory;
    return of_node * static_cast<double>(tree_.size());
  }

  TriMesh mesh() {
    report_.memory = detail::expected_memory(field_, tree_, tolerance_, options_.threads);
    detail::require_mesh_memory(report_.memory, options_.max_memory, tolerance_);
    timer_.expect(kSecondsPerByte * report_.memory / resolve_threads(options_.threads));
    timer_.step("tree");
    tree_.mark_drawn();  // their surface is part of the expected memory
    detail::require_cells(detail::expected_nodes(report_.memory), budget_.most());
    budget_.begin(tree_.size());
    find_topology();
    detail::require_cells(budget_.nodes_after_first(0, tree_.size()), budget_.most());
    for (int k = 0; k < kCrowdedRounds && tree_.split(surface_->crowded()) > 0; ++k)
      find_topology();
    detail::require_cells(budget_.nodes_after_first(0, tree_.size()), budget_.most());
    make_triangles();
    while (split_failed()) {
      if (options_.most_nodes > 0 && report_.passes >= kMostRounds)
        throw Error("mesh-unresolved", "cells were split too many times");
      find_topology();
      make_triangles();
    }
    LabelledMesh mesh = label(surface_->mesh());
    detail::drop_unused_vertices(mesh);
    report_.triangles_before = mesh.triangles.size();
    report_.cells = surface_->loops().size();
    surface_.reset();
    passed_ = detail::FlatMap();
    mesh = detail::cut_owner_borders(field_, tree_, mesh, border_room(), options_.threads);
    timer_.step("borders");
    mesh = simplified(mesh);
    const detail::MeshCertifier::Total total = certifier().total(mesh);
    report_.tolerance = tolerance_;
    report_.bound = total.bound;
    report_.sampled = total.sampled;
    report_.volume_excess = certifier().volume_excess(mesh);
    timer_.step("certify");
    TriMesh out = detail::to_tri_mesh(mesh);
    report_.thin = detail::distinct(detail::lost_features(field_, tree_, tree_.doubtful_edges(),
                                                          out, tolerance_, options_.threads));
    timer_.step("thin");
    return out;
  }

  // Splits cells until the crossings on every face can be joined, then joins them.
  void find_topology() {
    detail::CrossedGrid grid = detail::split_badly_crossed(tree_);
    timer_.step("tree");
    detail::require_room(detail::kSurfaceMemory * static_cast<double>(tree_.undrawn()));
    tree_.mark_drawn();
    surface_->find_loops(std::move(grid));
    ++report_.passes;
    budget_.add_round(tree_.size());
    timer_.step("loops");
  }

  LabelledMesh label(const BaseMesh& base) const {
    LabelledMesh mesh;
    mesh.vertices = base.vertices;
    mesh.triangles = base.triangles;
    mesh.labels.reserve(base.crossings.size());
    detail::FlatMap ids;
    auto moved = base.moved.begin();
    for (std::uint32_t t = 0; t < base.crossings.size(); ++t) {
      const auto c = static_cast<std::size_t>(base.crossings[t]);
      const bool is_moved = moved != base.moved.end() && moved->first == t;
      const FieldSample& at = is_moved ? (moved++)->second : surface_->crossings()[c].at;
      const auto [id, is_new] =
          ids.insert(detail::face_key(at), static_cast<std::int32_t>(mesh.faces.size()));
      if (is_new) mesh.faces.push_back(at);
      mesh.labels.push_back(static_cast<std::uint32_t>(id));
    }
    return mesh;
  }

  // Makes triangles; cells with several pieces of surface whose triangles meet are split.
  void make_triangles() {
    for (;;) {
      const std::size_t loops = surface_->loops().size();
      const double more = static_cast<double>(loops) - static_cast<double>(drawn_loops_);
      detail::require_room(detail::kLoopMemory * std::max(more, 0.0));
      drawn_loops_ = loops;
      surface_->make_triangles();
      timer_.step("surface");
      const std::vector<std::int32_t> bad = crossed_cells();
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

  // Only cells with more than one loop can hold triangles that meet (docs/mesh.md, Surface).
  std::vector<std::int32_t> crossed_cells() const {
    if (surface_->crowded().empty()) return {};
    std::vector<char> is_crowded(tree_.size(), 0);
    for (const std::int32_t c : surface_->crowded()) is_crowded[static_cast<std::size_t>(c)] = 1;
    const BaseMesh& mesh = surface_->mesh();
    const auto crowded_cell = [&](std::uint32_t v) {
      if (v >= surface_->loops().size()) return -1;
      const std::int32_t c = surface_->loops()[v].cell;
      return is_crowded[static_cast<std::size_t>(c)] ? c : -1;
    };
    std::vector<std::array<std::uint32_t, 3>> some;
    for (const auto& t : mesh.triangles)
      if (crowded_cell(t[0]) >= 0 || crowded_cell(t[1]) >= 0 || crowded_cell(t[2]) >= 0)
        some.push_back(t);
    std::vector<std::int32_t> bad;
    for (const auto& [i, j] : detail::self_intersections(mesh.vertices, some, options_.threads))
      for (const std::uint32_t k : {i, j})
        for (const std::uint32_t v : some[k])
          if (crowded_cell(v) >= 0) bad.push_back(crowded_cell(v));
    return bad;
  }

  // What the triangles of a round ask for.
  struct Failures {
    std::vector<std::uint64_t> hashes;              ///< of all triangles
    std::vector<Detail> wanted;                     ///< of all triangles
    std::vector<std::vector<std::int32_t>> guilty;  ///< cells to split, of all triangles
    std::size_t cells = 0;                          ///< with duplicates
  };

  Failures find_failures() const {
    const BaseMesh& base = surface_->mesh();
    const LabelledMesh mesh = label(base);
    const double limit = kBaseShare * tolerance_;
    const detail::MeshCertifier certifier = this->certifier();
    const std::size_t count = mesh.triangles.size();
    Failures out{std::vector<std::uint64_t>(count), std::vector<Detail>(count, Detail::flat),
                 std::vector<std::vector<std::int32_t>>(count)};
    parallel_for_chunks(
        count, options_.threads, detail::MeshCertifier::kChunk,
        [&](std::size_t begin, std::size_t end) {
          detail::FaceDistances distances(field_);
          for (std::size_t t = begin; t < end; ++t) {
            out.hashes[t] = triangle_hash(mesh, t);
            if (passed_.find(out.hashes[t]) >= 0) continue;
            const double bound = certifier.certified(mesh, t, limit, distances).distance;
            if (bound <= limit) continue;
            if (!misses_crease(mesh, t, distances))
              out.wanted[t] = detail_for(base, t, bound / limit);
            if (out.wanted[t] == Detail::flat)
              out.guilty[t] = detail::guilty_cells(field_, tree_, *surface_, mesh, t, is_late());
          }
        });
    for (const auto& cells : out.guilty) out.cells += cells.size();
    return out;
  }

  // Raises the tolerance until the cells that fail may be split; throws where it must not be raised
  // so far.
  Failures find_failures_that_fit() {
    Failures found = find_failures();
    while (!budget_.fits(found.cells, tree_.size(), tolerance_)) {
      if (!budget_.may_raise(tolerance_))
        throw Error("mesh-unresolved", detail::too_many_cells(budget_.most()));
      budget_.raise(tree_.size());
      tolerance_ *= 2;
      report_.memory = 0;  // what was expected for the former one
      tree_.raise_tolerance(tolerance_);
      found = find_failures();
    }
    return found;
  }

  // Splits cells whose triangles are not within the tolerance. False when none is left that can be
  // split.
  bool split_failed() {
    require_room(detail::kCertifyMemory);
    const Failures found = find_failures_that_fit();
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
    const double more = detail::kNodesAFailure * static_cast<double>(cells.size());
    const double bytes = detail::memory_of_nodes(static_cast<double>(tree_.size()) + more);
    report_.memory = std::max(report_.memory, bytes);
    const std::size_t count = split(std::move(cells));
    timer_.step("tree");
    return count + refined > 0;
  }

  // Draws the surface more finely where that is enough, and remembers which triangles need no more
  // looks. Returns how many places are drawn anew.
  std::size_t refine(const Failures& found) {
    const BaseMesh& base = surface_->mesh();
    std::size_t refined = 0;
    for (std::size_t t = 0; t < found.hashes.size(); ++t)
      if (found.wanted[t] != Detail::flat) {
        surface_->refine(surface_->crossings()[static_cast<std::size_t>(base.crossings[t])],
                         found.wanted[t]);
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
    const auto failed = static_cast<double>(cells.size()),
               nodes = static_cast<double>(tree_.size());
    const double later = goes_on ? 8 * (kLateSteps - 1) * nodes / detail::NodeBudget::kFew : 0;
    detail::require_room(detail::kSplitMemory * (8 * failed + later));
    few_failed_ = is_few(cells.size());
    budget_.add_failed(cells.size());
    const std::size_t count = tree_.split(std::move(cells));
    for (int k = 1; goes_on && k < kLateSteps && is_few(tree_.new_leaves().size()); ++k)
      tree_.split(std::vector<std::int32_t>(tree_.new_leaves()));
    return count;
  }
  bool is_few(std::size_t cells) const { return detail::NodeBudget::is_few(cells, tree_.size()); }

  detail::MeshCertifier certifier() const { return {field_, tree_, tolerance_, options_.threads}; }

  // A vertex lies far from the face that the triangle is measured by: what lies between is not seen
  // in these cells, however finely the surface is drawn in them.
  bool misses_crease(const LabelledMesh& mesh, std::size_t t,
                     detail::FaceDistances& distances) const {
    const auto& x = mesh.triangles[t];
    return std::any_of(x.begin(), x.end(), [&](std::uint32_t v) {
      return std::abs(distances(mesh.vertices[v], mesh.faces[mesh.labels[t]])) > tolerance_;
    });
  }

  // How finely the surface about a triangle that misses the tolerance by `factor` has to be drawn
  // in the same cells: with the square of the length of its edges the distance falls by two from
  // step to step. Flat: cells must be split; so they are in the end, since detail about one edge
  // can need detail about the next one, all along a curve.
  Detail detail_for(const BaseMesh& base, std::size_t t, double factor) const {
    const Crossing& c = surface_->crossings()[static_cast<std::size_t>(base.crossings[t])];
    if (report_.passes > kDrawnRounds) return Detail::flat;
    if (c.detail == Detail::flat && factor <= 2 && !is_late()) return Detail::fan;
    return c.detail != Detail::full && factor <= 4 ? Detail::full : Detail::flat;
  }

  // After some rounds few triangles fail: splitting too many cells about them is then cheaper than
  // another round.
  bool is_late() const { return report_.passes > kCarefulRounds && few_failed_; }

  // Equal for equal triangles: those of former rounds need not be certified again.
  static std::uint64_t triangle_hash(const LabelledMesh& mesh, std::size_t t) {
    InputHash hash;
    hash.add(mesh.faces[mesh.labels[t]]);
    for (const std::uint32_t v : mesh.triangles[t]) hash.add(mesh.vertices[v]);
    return hash.value();
  }

  // mm: how far chords may leave the borders between owners on plane faces.
  double border_room() const {
    return std::max(tolerance_, kBorderShare * tree_.lattice().voxel());
  }

  LabelledMesh simplified(const LabelledMesh& mesh) {
    const double voxel = tree_.lattice().voxel();
    detail::MeasuredTriangles measured;
    detail::ApartMesh small =
        detail::simplify_apart(mesh, voxel, options_.threads, [&](const std::vector<char>& locked) {
          return detail::simplify(field_, tree_, mesh, {tolerance_, 0.5 * voxel, border_room()},
                                  locked, measured, options_.threads);
        });
    report_.kept = small.kept;
    timer_.step("simplify");
    return std::move(small.mesh);
  }

  const ExactField& field_;
  const MeshPlan& options_;
  double tolerance_;  ///< mm
  detail::NodeBudget budget_;
  MeshReport& report_;
  StepTimer timer_;
  CellOctree tree_;
  std::size_t drawn_loops_ = 0;         ///< of the surface whose triangles were made last
  bool few_failed_ = true;              ///< cells in the round before
  std::optional<DualSurface> surface_;  ///< until its triangles are final
  detail::FlatMap passed_;              ///< by hashes of triangles within the tolerance
};

}  // namespace

std::optional<TriMesh> adaptive_mesh(const ExactField& field, double voxel, const MeshPlan& options,
                                     MeshReport& report) {
  double memory = 0;
  for (double tolerance = options.tolerance;; tolerance *= 2) {
    const int levels = detail::fine_levels(field.bounds(), voxel, tolerance);
    const Lattice lattice(field.bounds(), voxel, levels);
    try {
      TriMesh mesh = AdaptiveMesher(field, lattice, tolerance, options, report).run();
      report.memory = std::max(report.memory, memory);
      return mesh;
    } catch (const Error& error) {
      const bool has_no_mesh = error.code() == "mesh-unresolved";
      if ((!has_no_mesh && error.code() != "memory") || options.most_nodes == 0) throw;
      // An octree that was given up before its end held between an eighth and all of its nodes.
      const double tree = detail::kNodeMemory * static_cast<double>(options.most_nodes) / 2;
      memory = std::max(memory, report.memory > 0 ? report.memory : tree);
      // Once the surface is drawn, the tolerance is raised without another octree.
      const bool may_retry = options.makes_new_octrees && has_no_mesh && report.passes == 0;
      report = {};
      if (may_retry &&
          2 * tolerance <= detail::NodeBudget::kRaisedForNodes * options.most_tolerance)
        continue;
      report.memory = memory;
      report.given_up = error.what();
      return {};
    }
  }
}

}  // namespace mrsim
