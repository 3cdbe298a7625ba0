#include "mesh/contour.h"

#include "core/error.h"
#include "core/parallel.h"
#include "mesh/contour_certify.h"
#include "mesh/contour_hash.h"
#include "mesh/contour_levels.h"
#include "mesh/contour_memory.h"
#include "mesh/contour_simplify.h"
#include "mesh/contour_surface.h"
#include "mesh/contour_thin.h"
#include "mesh/contour_timer.h"
#include "mesh/contour_uniform.h"
#include "mesh/flat_map.h"
#include "mesh/self_intersection.h"
#include "mesh/turned_mesh.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace mrsim {
namespace {

using detail::BaseMesh;
using detail::ContourOctree;
using detail::ContourSurface;
using detail::ContourTimer;
using detail::Crossing;
using detail::Detail;
using detail::LabelledMesh;
using detail::Lattice;
using detail::PlaceHash;
using detail::TriangleBound;

constexpr double kExact = 1e-4;     ///< mm: a vertex farther off its face has missed a crease
constexpr double kBaseShare = 1.0;  ///< of the tolerance, for triangles before simplification
constexpr double kNearestCorner = 0.5773502691896258;  ///< of the longest side, at most
constexpr int kCrowdedRounds = 3;  ///< of splitting cells with two pieces of surface
constexpr int kLockRounds = 12;
constexpr std::size_t kCarefulRounds = 4;  ///< of splitting, by one step each

class Contour {
 public:
  Contour(const ExactField& field, const Lattice& lattice, const MeshOptions& options,
          ContourReport& report)
      : field_(field),
        options_(options),
        report_(report),
        timer_(report, options.progress),
        tree_(field, lattice, options.tolerance, options.threads, options.max_memory),
        surface_(std::in_place, field, tree_,
                 ContourSurface::Options{.shallow = options.tolerance / 8,
                                         .sharpen = true,
                                         .remember = true,
                                         .threads = options.threads}) {
    timer_.step("tree");
  }

  TriMesh run() {
    report_.memory = detail::expected_memory(field_, tree_, options_.tolerance, options_.threads);
    detail::require_memory(report_.memory, options_.max_memory, options_.tolerance);
    find_topology();
    for (int k = 0; k < kCrowdedRounds && tree_.split(surface_->crowded()) > 0; ++k)
      find_topology();
    make_triangles();
    while (split_failed()) {
      find_topology();
      make_triangles();
    }
    LabelledMesh mesh = label(surface_->mesh());
    report_.triangles_before = mesh.triangles.size();
    report_.cells = surface_->loops().size();
    surface_.reset();
    passed_ = detail::FlatMap();
    mesh = simplified(mesh);
    report_bound(mesh);
    report_.volume_excess = volume_excess(mesh);
    timer_.step("certify");
    TriMesh out = to_mesh(mesh);
    report_.thin = detail::distinct(detail::lost_features(
        field_, tree_, tree_.doubtful_edges(), out, options_.tolerance, options_.threads));
    timer_.step("thin");
    return out;
  }

 private:
  // Splits cells until the crossings on every face can be joined, then joins them.
  void find_topology() {
    detail::CrossedGrid grid = detail::split_badly_crossed(tree_);
    timer_.step("tree");
    surface_->find_loops(std::move(grid));
    ++report_.passes;
    timer_.step("loops");
  }

  LabelledMesh label(const BaseMesh& base) const {
    LabelledMesh mesh;
    mesh.vertices = base.vertices;
    mesh.triangles = base.triangles;
    mesh.labels.reserve(base.crossings.size());
    detail::FlatMap ids;
    for (const std::int32_t c : base.crossings) {
      const FieldSample& at = surface_->crossings()[static_cast<std::size_t>(c)].at;
      const std::uint64_t key = static_cast<std::uint64_t>(at.owner - kStockOwner) << 32 |
                                static_cast<std::uint32_t>(at.patch);
      const auto [id, is_new] = ids.insert(key, static_cast<std::int32_t>(mesh.faces.size()));
      if (is_new) mesh.faces.push_back(at);
      mesh.labels.push_back(static_cast<std::uint32_t>(id));
    }
    return mesh;
  }

  TriangleBound bound(const LabelledMesh& mesh, std::size_t t, double limit) const {
    const auto& x = mesh.triangles[t];
    const Vec3 &a = mesh.vertices[x[0]], &b = mesh.vertices[x[1]], &c = mesh.vertices[x[2]];
    const FieldSample& label = mesh.faces[mesh.labels[t]];
    TriangleBound found = detail::triangle_bound(field_, label, a, b, c, limit);
    std::int32_t cell = 0;
    if (found.distance <= limit)
      found.distance = std::max(
          found.distance, detail::largest_distance(field_, tree_, label, a, b, c, limit, cell));
    if (found.distance <= options_.tolerance) return found;
    const double part = detail::part_bound(field_, tree_, a, b, c, limit);
    return part < found.distance ? TriangleBound{part, false} : found;
  }

  // From the face of the part, or from the nearest corner, which is exact.
  TriangleBound certified(const LabelledMesh& mesh, std::size_t t, double limit) const {
    const auto& x = mesh.triangles[t];
    const Vec3 &a = mesh.vertices[x[0]], &b = mesh.vertices[x[1]], &c = mesh.vertices[x[2]];
    const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
    const TriangleBound found = bound(mesh, t, limit);
    const double corner = kNearestCorner * longest;
    return corner <= found.distance ? TriangleBound{corner, true} : found;
  }

  // Makes triangles; cells with several pieces of surface whose triangles meet are split.
  void make_triangles() {
    for (;;) {
      surface_->make_triangles();
      timer_.step("surface");
      const std::vector<std::int32_t> bad = crossed_cells();
      timer_.step("check");
      if (bad.empty()) {
        surface_->sharpen(tree_);
        timer_.step("sharpen");
        return;
      }
      if (tree_.split(bad) == 0)
        throw Error("mesh-unresolved", "pieces of surface in one cell of the mesh meet");
      find_topology();
    }
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

  // Splits cells whose triangles are not within the tolerance. False when none is left that can be
  // split.
  bool split_failed() {
    const BaseMesh& base = surface_->mesh();
    const LabelledMesh mesh = label(base);
    const double limit = kBaseShare * options_.tolerance;
    std::vector<std::vector<std::int32_t>> failed(mesh.triangles.size());
    std::vector<std::uint64_t> hashes(mesh.triangles.size());
    std::vector<Detail> wanted(mesh.triangles.size(), Detail::flat);
    parallel_for(
        mesh.triangles.size(), options_.threads,
        [&](std::size_t t) {
          hashes[t] = triangle_hash(mesh, t);
          if (passed_.find(hashes[t]) >= 0) return;
          const double bound = certified(mesh, t, limit).distance;
          if (bound <= limit) return;
          if (!misses_crease(mesh, t)) wanted[t] = detail_for(base, t, bound / limit);
          if (wanted[t] == Detail::flat) failed[t] = guilty_cells(mesh, base, t);
        },
        64);
    std::size_t refined = 0;
    for (std::size_t t = 0; t < hashes.size(); ++t)
      if (wanted[t] != Detail::flat) {
        surface_->refine(surface_->crossings()[static_cast<std::size_t>(base.crossings[t])],
                         wanted[t]);
        ++refined;
      } else if (failed[t].empty()) {
        passed_.insert(hashes[t], 0);
      }
    std::vector<std::int32_t> cells;
    report_.unresolved = 0;
    for (const auto& f : failed) {
      cells.insert(cells.end(), f.begin(), f.end());
      bool can = f.empty();
      for (const std::int32_t c : f) can = can || tree_.can_split(c);
      report_.unresolved += !can;
    }
    timer_.step("certify");
    const std::size_t count = tree_.split(std::move(cells));
    if (is_late()) tree_.split(std::vector<std::int32_t>(tree_.new_leaves()));
    timer_.step("tree");
    return count + refined > 0;
  }

  // A vertex lies far from the face that the triangle is measured by: what lies between is not seen
  // in these cells, however finely the surface is drawn in them.
  bool misses_crease(const LabelledMesh& mesh, std::size_t t) const {
    const auto& x = mesh.triangles[t];
    return std::any_of(x.begin(), x.end(), [&](std::uint32_t v) {
      return std::abs(field_.patch_distance(mesh.vertices[v], mesh.faces[mesh.labels[t]])) >
             options_.tolerance;
    });
  }

  // How finely the surface about a triangle that misses the tolerance by `factor` has to be drawn
  // in the same cells: with the square of the length of its edges the distance falls by two from
  // step to step. Flat: cells must be split.
  Detail detail_for(const BaseMesh& base, std::size_t t, double factor) const {
    const Crossing& c = surface_->crossings()[static_cast<std::size_t>(base.crossings[t])];
    if (c.detail == Detail::flat && factor <= 2 && !is_late()) return Detail::fan;
    return c.detail != Detail::full && factor <= 4 ? Detail::full : Detail::flat;
  }

  // By then few triangles fail, and a round costs more than what too many cells about them do.
  bool is_late() const { return report_.passes > kCarefulRounds; }

  // Tells a triangle from all others of former rounds, which need not be certified again.
  static std::uint64_t triangle_hash(const LabelledMesh& mesh, std::size_t t) {
    PlaceHash hash;
    hash.add(mesh.faces[mesh.labels[t]]);
    for (const std::uint32_t v : mesh.triangles[t]) hash.add(mesh.vertices[v]);
    return hash.value();
  }

  // The cell whose vertex has missed the face of the part; else the largest about the edge.
  std::vector<std::int32_t> guilty_cells(const LabelledMesh& mesh, const BaseMesh& base,
                                         std::size_t t) const {
    std::vector<std::int32_t> cells;
    const auto& loops = surface_->loops();
    for (const std::uint32_t v : mesh.triangles[t])
      if (v < loops.size() &&
          std::abs(field_.patch_distance(mesh.vertices[v], mesh.faces[mesh.labels[t]])) > kExact)
        cells.push_back(loops[v].cell);
    if (!cells.empty()) return cells;
    const Crossing& c = surface_->crossings()[static_cast<std::size_t>(base.crossings[t])];
    std::int32_t largest = 0;
    for (const std::int32_t cell : c.edge.cells) largest = std::max(largest, tree_.node(cell).size);
    for (const std::int32_t cell : c.edge.cells)
      if (tree_.node(cell).size == largest) cells.push_back(cell);
    return cells;
  }

  // Simplifies; where walls are so thin that the result meets itself, keeps the vertices about the
  // place and starts again.
  LabelledMesh simplified(const LabelledMesh& mesh) {
    std::vector<char> locked(mesh.vertices.size(), 0);
    for (int round = 0; round < kLockRounds; ++round) {
      const LabelledMesh small =
          detail::simplify(field_, tree_, mesh, {options_.tolerance, 0.5 * tree_.lattice().voxel()},
                           locked, options_.threads);
      timer_.step("simplify");
      const auto pairs =
          detail::self_intersections(small.vertices, small.triangles, options_.threads);
      timer_.step("check");
      if (pairs.empty()) return small;
      lock_about(small, pairs, mesh, locked);
    }
    throw Error("mesh-unresolved",
                "the mesh still meets itself after simplification; use a larger tolerance");
  }

  void lock_about(const LabelledMesh& small,
                  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs,
                  const LabelledMesh& mesh, std::vector<char>& locked) const {
    const double margin = tree_.lattice().voxel();
    for (const auto& [i, j] : pairs) {
      Box3 a, b;
      for (const std::uint32_t v : small.triangles[i]) extend(a, small.vertices[v]);
      for (const std::uint32_t v : small.triangles[j]) extend(b, small.vertices[v]);
      const Vec3 lo = max(a.lo, b.lo) - Vec3{margin, margin, margin},
                 hi = min(a.hi, b.hi) + Vec3{margin, margin, margin};
      for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const Vec3& p = mesh.vertices[v];
        if (p.x >= lo.x && p.x <= hi.x && p.y >= lo.y && p.y <= hi.y && p.z >= lo.z && p.z <= hi.z)
          locked[v] = 1;
      }
    }
  }

  // What a triangle above the tolerance is measured by need not be a bound, unless asked without.
  TriangleBound reached(const LabelledMesh& mesh, std::size_t t) const {
    const TriangleBound found = certified(mesh, t, options_.tolerance);
    return found.distance <= options_.tolerance
               ? found
               : certified(mesh, t, std::numeric_limits<double>::infinity());
  }

  void report_bound(const LabelledMesh& mesh) {
    std::vector<TriangleBound> bounds(mesh.triangles.size());
    parallel_for(
        bounds.size(), options_.threads, [&](std::size_t t) { bounds[t] = reached(mesh, t); }, 64);
    for (const TriangleBound& b : bounds) {
      report_.bound = std::max(report_.bound, b.distance);
      report_.sampled += !b.is_proven;
    }
  }

  // The integral of d over the mesh.
  double volume_excess(const LabelledMesh& mesh) const {
    std::vector<double> parts(mesh.triangles.size());
    parallel_for(
        parts.size(), options_.threads,
        [&](std::size_t t) {
          const auto& x = mesh.triangles[t];
          parts[t] =
              detail::excess_over(field_, tree_, mesh.faces[mesh.labels[t]], mesh.vertices[x[0]],
                                  mesh.vertices[x[1]], mesh.vertices[x[2]], options_.tolerance);
        },
        64);
    double sum = 0;
    for (const double part : parts) sum += part;
    return sum;
  }

  static TriMesh to_mesh(const LabelledMesh& mesh) {
    TriMesh out;
    out.vertices.reserve(mesh.vertices.size());
    for (const Vec3& p : mesh.vertices)
      out.vertices.push_back(
          {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    out.triangles = mesh.triangles;
    out.owners.reserve(mesh.labels.size());
    for (const std::uint32_t l : mesh.labels) out.owners.push_back(mesh.faces[l].owner);
    return out;
  }

  const ExactField& field_;
  const MeshOptions& options_;
  ContourReport& report_;
  ContourTimer timer_;
  ContourOctree tree_;
  std::optional<ContourSurface> surface_;  ///< until its triangles are final
  detail::FlatMap passed_;                 ///< by hashes of triangles within the tolerance
};

}  // namespace

void contour(const ExactField& field, double voxel, const MeshOptions& options, MeshSink& sink,
             ContourReport* report) {
  if (!(voxel > 0) || !std::isfinite(voxel))
    throw Error("voxel-invalid", fmt::format("a voxel of {} mm is not a positive length", voxel));
  if (!(options.tolerance >= 0) || !std::isfinite(options.tolerance))
    throw Error("tolerance-invalid",
                fmt::format("--tolerance {} is not a length in mm", options.tolerance),
                Error::Kind::usage);
  ContourReport ignored;
  ContourReport& out = report ? *report : ignored;
  out = {};
  const int levels = detail::fine_levels(field.bounds(), voxel, options.tolerance);
  if (options.tolerance > 0 && field.is_turned(field.all()))
    if (const std::optional<TriMesh> turned = detail::turned_mesh(field, voxel, options, out))
      return sink.take(whole_block(*turned));
  detail::require_resolved(field.bounds(), voxel);
  if (options.tolerance > 0)
    sink.take(
        whole_block(Contour(field, Lattice(field.bounds(), voxel, levels), options, out).run()));
  else
    detail::contour_uniform(field, voxel, levels, options, sink, out);
}

TriMesh contour(const ExactField& field, double voxel, const MeshOptions& options,
                ContourReport* report) {
  MeshCollector collector;
  contour(field, voxel, options, collector, report);
  if (collector.mesh().triangles.empty()) throw Error("part-empty", "nothing is left of the stock");
  return std::move(collector.mesh());
}

}  // namespace mrsim
