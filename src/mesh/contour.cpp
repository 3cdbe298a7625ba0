#include "mesh/contour.h"

#include "core/error.h"
#include "core/parallel.h"
#include "mesh/contour_certify.h"
#include "mesh/contour_simplify.h"
#include "mesh/contour_surface.h"
#include "mesh/self_intersection.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstdio>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace mrsim {
namespace {

using detail::BaseMesh;
using detail::ContourOctree;
using detail::ContourSurface;
using detail::Crossing;
using detail::LabelledMesh;
using detail::Lattice;

constexpr double kExact = 1e-4;        ///< mm: a vertex farther off its face has missed a crease
constexpr double kBaseShare = 1.0;     ///< of the tolerance, for triangles before simplification
constexpr int kLockRounds = 12;

class Timer {
 public:
  explicit Timer(ContourReport& report) : report_(report), start_(Clock::now()) {}
  void step(const char* name) {
    const auto now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - start_).count();
    start_ = now;
    for (auto& [known, sum] : report_.seconds)
      if (known == name) {
        sum += seconds;
        return;
      }
    report_.seconds.emplace_back(name, seconds);
  }

 private:
  using Clock = std::chrono::steady_clock;
  ContourReport& report_;
  Clock::time_point start_;
};

class Contour {
 public:
  Contour(const ExactField& field, const Lattice& lattice, const MeshOptions& options,
          ContourReport& report)
      : field_(field),
        options_(options),
        report_(report),
        timer_(report),
        tree_(field, lattice, options.tolerance > 0, options.threads),
        surface_(field, tree_, options.threads) {
    timer_.step("tree");
  }

  TriMesh run() {
    find_topology();
    LabelledMesh mesh = label(surface_.make_triangles());
    timer_.step("surface");
    if (options_.tolerance > 0) {
      while (split_failed()) {
        find_topology();
        mesh = label(surface_.make_triangles());
        timer_.step("surface");
      }
      report_.triangles_before = mesh.triangles.size();
      mesh = simplified(mesh);
      report_.bound = largest_bound(mesh);
      timer_.step("certify");
    } else {
      report_.triangles_before = mesh.triangles.size();
    }
    report_.cells = surface_.loops().size();
    if (std::getenv("HIST")) { std::map<int,int> h; for (const auto& l : surface_.loops()) ++h[tree_.node(l.cell).size]; for (auto [s, n] : h) std::printf("  size %g voxels: %d\n", s / 64.0, n); std::map<int,int> g; for (std::size_t k = 0; k < tree_.size(); ++k) ++g[tree_.node(int(k)).size]; for (auto [s, n] : g) std::printf("  nodes %g: %d\n", s / 64.0, n); }
    return to_mesh(mesh);
  }

 private:
  void find_topology() {
    for (;;) {
      ++report_.passes;
      const std::vector<std::int32_t> bad = surface_.find_loops();
      timer_.step("loops");
      if (std::getenv("HIST")) std::printf("  bad %zu of loops %zu nodes %zu\n", bad.size(), surface_.loops().size(), tree_.size());
      const std::size_t split = tree_.split(bad);
      timer_.step("tree");
      if (split == 0) return;
    }
  }

  LabelledMesh label(const BaseMesh& base) const {
    LabelledMesh mesh;
    mesh.vertices = base.vertices;
    mesh.triangles = base.triangles;
    std::map<std::pair<std::int32_t, std::int32_t>, std::uint32_t> ids;
    for (const std::int32_t c : base.crossings) {
      const FieldSample& at = surface_.crossings()[static_cast<std::size_t>(c)].at;
      const auto [it, is_new] =
          ids.try_emplace({at.owner, at.patch}, static_cast<std::uint32_t>(mesh.faces.size()));
      if (is_new) mesh.faces.push_back(at);
      mesh.labels.push_back(it->second);
    }
    return mesh;
  }

  double bound(const LabelledMesh& mesh, std::size_t t, double limit) const {
    const auto& x = mesh.triangles[t];
    const Vec3 &a = mesh.vertices[x[0]], &b = mesh.vertices[x[1]], &c = mesh.vertices[x[2]];
    const double face =
        detail::triangle_bound(field_, mesh.faces[mesh.labels[t]], a, b, c, limit);
    if (face > limit) return face;
    const Vec3 center = (1.0 / 3) * (a + b + c);
    const auto list = tree_.candidates(tree_.locate(center));
    return std::max(face, std::abs(field_.sample(center, list).distance));
  }

  // Splits cells whose triangles are not within the tolerance. False when none is left that can be
  // split.
  bool split_failed() {
    const BaseMesh& base = surface_.mesh();
    const LabelledMesh mesh = label(base);
    const double limit = kBaseShare * options_.tolerance;
    std::vector<std::vector<std::int32_t>> failed(mesh.triangles.size());
    parallel_for(
        mesh.triangles.size(), options_.threads,
        [&](std::size_t t) {
          if (bound(mesh, t, limit) > limit) failed[t] = guilty_cells(mesh, base, t);
        },
        64);
    std::vector<std::int32_t> cells;
    report_.unresolved = 0;
    for (const auto& f : failed) {
      cells.insert(cells.end(), f.begin(), f.end());
      bool can = f.empty();
      for (const std::int32_t c : f) can = can || tree_.can_split(c);
      report_.unresolved += !can;
    }
    timer_.step("certify");
    if (std::getenv("HIST")) std::printf("  failed %zu\n", cells.size());
    const std::size_t count = tree_.split(std::move(cells));
    timer_.step("tree");
    return count > 0;
  }

  // The cell whose vertex has missed the face of the part; else the largest about the edge.
  std::vector<std::int32_t> guilty_cells(const LabelledMesh& mesh, const BaseMesh& base,
                                         std::size_t t) const {
    std::vector<std::int32_t> cells;
    const auto& loops = surface_.loops();
    for (const std::uint32_t v : mesh.triangles[t])
      if (v < loops.size() && std::abs(field_.patch_distance(
                                  mesh.vertices[v], mesh.faces[mesh.labels[t]])) > kExact)
        cells.push_back(loops[v].cell);
    if (!cells.empty()) return cells;
    const Crossing& c = surface_.crossings()[static_cast<std::size_t>(base.crossings[t])];
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
      const LabelledMesh small = detail::simplify(
          field_, tree_, mesh, {options_.tolerance, 0.5 * tree_.lattice().voxel()}, locked);
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

  double largest_bound(const LabelledMesh& mesh) const {
    std::vector<double> bounds(mesh.triangles.size());
    parallel_for(
        bounds.size(), options_.threads,
        [&](std::size_t t) {
          bounds[t] = bound(mesh, t, std::numeric_limits<double>::infinity());
        },
        64);
    double most = 0;
    for (const double b : bounds) most = std::max(most, b);
    return most;
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
  Timer timer_;
  ContourOctree tree_;
  ContourSurface surface_;
};

}  // namespace

TriMesh contour(const ExactField& field, double voxel, const MeshOptions& options,
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
  TriMesh mesh =
      Contour(field, Lattice(field.bounds(), voxel, detail::kFineLevels), options, out).run();
  if (mesh.triangles.empty()) throw Error("part-empty", "nothing is left of the stock");
  return mesh;
}

}  // namespace mrsim
