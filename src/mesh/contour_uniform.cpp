#include "mesh/contour_uniform.h"

#include "core/error.h"
#include "core/parallel.h"
#include "mesh/contour_surface.h"
#include "mesh/contour_thin.h"
#include "mesh/contour_tile.h"
#include "mesh/contour_timer.h"
#include "mesh/self_intersection.h"
#include "mesh/weld.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <set>
#include <tuple>
#include <unordered_map>

namespace mrsim::detail {
namespace {

constexpr double kShallow = 1.0 / 64;  ///< of a voxel: what cutting off a shallow crease may move
constexpr int kMargin = 4;             ///< voxels before the part, which no owned edge is missed in
constexpr std::int32_t kCells = ContourTile::kCells, kOwned = ContourTile::kOwned,
                       kFirstOwned = ContourTile::kFirstOwned;

/// A cell by its place, in fine units.
struct CellPlace {
  LatticePoint origin;
  std::int32_t size = 0;
  friend bool operator<(const CellPlace& a, const CellPlace& b) {
    return std::tie(a.origin.x, a.origin.y, a.origin.z, a.size) <
           std::tie(b.origin.x, b.origin.y, b.origin.z, b.size);
  }
};

struct Tile {
  LatticePoint first;  ///< of its cells, voxels
  Candidates candidates;
};

/// What a tile adds to the mesh.
struct TileMesh {
  std::vector<std::array<float, 3>> vertices;
  std::vector<char> is_shared;  ///< the next tile may have this vertex too
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::int32_t> owners;
  std::vector<std::pair<std::uint32_t, CellPlace>> crowded;  ///< vertices of cells with two pieces
  std::vector<CellPlace> splits;                             ///< of owned cells
  std::vector<FoundThin> thin;
  std::size_t cells = 0;
};

// Boxes of tiles, halved until they are single ones.
struct TileRange {
  LatticePoint low, high;  ///< tiles, half open
};

class UniformContour {
 public:
  UniformContour(const ExactField& field, const Lattice& lattice, const MeshOptions& options,
                 ContourReport& report)
      : field_(field),
        lattice_(lattice),
        options_(options),
        report_(report),
        timer_(report, {}) {}  // progress is told by tiles

  TriMesh run() {
    find_tiles();
    timer_.step("tiles");
    meshes_.resize(tiles_.size());
    std::vector<std::size_t> all(tiles_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    make(all);
    for (;;) {
      timer_.step("cells");
      ++report_.passes;
      TriMesh mesh = merged();
      timer_.step("merge");
      const std::set<CellPlace> bad = crossed_cells(mesh);
      timer_.step("check");
      if (bad.empty()) {
        finish_report(mesh);
        return mesh;
      }
      split(bad);
    }
  }

 private:
  std::int32_t unit() const { return lattice_.per_voxel(); }

  Box3 box(const TileRange& range) const {
    const auto corner = [&](const LatticePoint& tile, std::int32_t more) {
      return lattice_.position({(tile.x * kOwned + more) * unit(),
                                (tile.y * kOwned + more) * unit(),
                                (tile.z * kOwned + more) * unit()});
    };
    return {corner(range.low, 0), corner(range.high, kCells - kOwned)};
  }

  TileRange whole() const {
    TileRange range;
    const LatticePoint last = lattice_.floor(field_.bounds().hi);
    for (int a = 0; a < 3; ++a)
      component(range.high, a) = (component(last, a) / unit() + 1) / kOwned + 1;
    return range;
  }

  void find_tiles() {
    const Box3 bounds = field_.bounds();
    const auto descent = field_.descent(0.5 * (bounds.lo + bounds.hi), field_.all());
    find_tiles(*descent, whole(), 1);
  }

  void find_tiles(ExactField::Descent& descent, const TileRange& range, std::size_t level) {
    if (descent.enter(level, inflated(box(range), kQuantum), kSurfaceBand) !=
        ExactField::Region::mixed)
      return;
    int axis = 0;
    for (const int a : {1, 2})
      if (extent(range, a) > extent(range, axis)) axis = a;
    if (extent(range, axis) == 1) {
      tiles_.push_back({{range.low.x * kOwned, range.low.y * kOwned, range.low.z * kOwned}, {}});
      descent.candidates(level, tiles_.back().candidates);
      return;
    }
    TileRange low = range, high = range;
    component(low.high, axis) = component(high.low, axis) =
        component(low.low, axis) + extent(range, axis) / 2;
    find_tiles(descent, low, level + 1);
    find_tiles(descent, high, level + 1);
  }
  static std::int32_t extent(const TileRange& range, int axis) {
    return component(range.high, axis) - component(range.low, axis);
  }

  // Each thread has a tile of its own, whose memory it uses again.
  void make(const std::vector<std::size_t>& wanted) {
    std::atomic<std::size_t> next{0};
    const auto threads = static_cast<std::size_t>(resolve_threads(options_.threads));
    parallel_for(std::min(threads, wanted.size()), options_.threads, [&](std::size_t) {
      ContourTile cells(field_, lattice_);
      ContourSurface surface(field_, cells, {.shallow = kShallow * lattice_.voxel(), .threads = 1});
      for (std::size_t k = next++; k < wanted.size(); k = next++) {
        const std::size_t i = wanted[k];
        if (forced_in(tiles_[i]).empty()) {
          cells.build(tiles_[i].first, tiles_[i].candidates);
          surface.find_loops(crossed_grid(cells));
          surface.make_triangles();
          meshes_[i] = collect(surface, cells, tiles_[i]);
          meshes_[i].thin = thin_features(field_, cells, cells.doubtful_edges());
        } else {
          meshes_[i] = make_split(tiles_[i]);
        }
        show_progress(k, wanted.size());
      }
    });
  }

  void show_progress(std::size_t done, std::size_t all) {
    if (!options_.progress || done % 16 != 0) return;
    const std::scoped_lock lock(mutex_);
    if (!options_.progress("meshing", static_cast<double>(done) / static_cast<double>(all)))
      throw Error("cancelled", "the run was stopped");
  }

  std::vector<CellPlace> forced_in(const Tile& tile) const {
    std::vector<CellPlace> out;
    for (const CellPlace& cell : forced_)
      if (covers(tile, cell.origin, 0, kCells)) out.push_back(cell);
    return out;
  }
  bool covers(const Tile& tile, const LatticePoint& p, std::int32_t from, std::int32_t to) const {
    for (int a = 0; a < 3; ++a) {
      const std::int32_t i = component(p, a) - component(tile.first, a) * unit();
      if (i < from * unit() || i >= to * unit()) return false;
    }
    return true;
  }

  // A tile of which some cells are split, here or next to it.
  TileMesh make_split(const Tile& tile) const {
    OctreePart part;
    part.origin = {tile.first.x * unit(), tile.first.y * unit(), tile.first.z * unit()};
    part.size = kCells * unit();
    part.candidates = tile.candidates;
    part.complete[0] = unit();
    part.complete[1] = (kCells - 1) * unit();
    part.owned[0] = kFirstOwned * unit();
    part.owned[1] = (kFirstOwned + kOwned) * unit();
    ContourOctree tree(field_, lattice_, part);
    for (std::size_t count = 1; count > 0;) {
      std::vector<std::int32_t> leaves;
      for (std::int32_t n = 0; n < static_cast<std::int32_t>(tree.size()); ++n)
        if (tree.node(n).child < 0 && forced_.count({tree.node(n).origin, tree.node(n).size}) > 0)
          leaves.push_back(n);
      count = tree.split(std::move(leaves));
    }
    CrossedGrid grid = split_badly_crossed(tree);
    ContourSurface surface(field_, tree, {.shallow = kShallow * lattice_.voxel(), .threads = 1});
    surface.find_loops(std::move(grid));
    surface.make_triangles();
    TileMesh mesh = collect(surface, tree, tile);
    for (std::int32_t n = 0; n < static_cast<std::int32_t>(tree.size()); ++n) {
      const OctreeNode& node = tree.node(n);
      if (node.child >= 0 && node.size <= unit() && tree.is_owned(node.origin))
        mesh.splits.push_back({node.origin, node.size});
    }
    std::vector<MinimalEdge> doubtful = tree.doubtful_edges();
    std::erase_if(doubtful, [](const MinimalEdge& e) { return !e.owned; });
    mesh.thin = thin_features(field_, tree, doubtful);
    return mesh;
  }

  template <class Cells>
  TileMesh collect(const ContourSurface& surface, const Cells& cells, const Tile& tile) const {
    const BaseMesh& base = surface.mesh();
    TileMesh out;
    const auto plane = [&](int axis, std::int32_t i) {
      return lattice_.coordinate(axis, (component(tile.first, axis) + i) * unit());
    };
    const Vec3 inner_low{plane(0, kFirstOwned), plane(1, kFirstOwned), plane(2, kFirstOwned)};
    const std::int32_t last = kFirstOwned + kOwned - 1;
    const Vec3 inner_high{plane(0, last), plane(1, last), plane(2, last)};
    std::vector<std::uint32_t> id(base.vertices.size(), ~0u);
    out.triangles.reserve(base.triangles.size());
    out.owners.reserve(base.triangles.size());
    for (std::size_t t = 0; t < base.triangles.size(); ++t) {
      std::array<std::uint32_t, 3> triangle{};
      for (std::size_t k = 0; k < 3; ++k) {
        std::uint32_t& v = id[base.triangles[t][k]];
        if (v == ~0u) {
          v = static_cast<std::uint32_t>(out.vertices.size());
          const Vec3& p = base.vertices[base.triangles[t][k]];
          out.vertices.push_back(
              {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
          out.is_shared.push_back(p.x <= inner_low.x || p.y <= inner_low.y || p.z <= inner_low.z ||
                                  p.x >= inner_high.x || p.y >= inner_high.y ||
                                  p.z >= inner_high.z);
        }
        triangle[k] = v;
      }
      out.triangles.push_back(triangle);
      out.owners.push_back(
          surface.crossings()[static_cast<std::size_t>(base.crossings[t])].at.owner);
    }
    note_crowded(surface, cells, id, out);
    for (const Loop& loop : surface.loops()) out.cells += is_owned(cells, tile, loop.cell);
    return out;
  }

  CellPlace place_of(const ContourCells& cells, std::int32_t cell) const {
    return {lattice_.nearest(cells.box(cell).lo), cells.size_of(cell)};
  }
  bool is_owned(const ContourCells& cells, const Tile& tile, std::int32_t cell) const {
    return covers(tile, place_of(cells, cell).origin, kFirstOwned, kFirstOwned + kOwned);
  }

  void note_crowded(const ContourSurface& surface, const ContourCells& cells,
                    const std::vector<std::uint32_t>& id, TileMesh& out) const {
    if (surface.crowded().empty()) return;
    const std::set<std::int32_t> crowded(surface.crowded().begin(), surface.crowded().end());
    for (std::size_t v = 0; v < surface.loops().size(); ++v) {
      const std::int32_t cell = surface.loops()[v].cell;
      if (id[v] != ~0u && crowded.count(cell) > 0)
        out.crowded.emplace_back(id[v], place_of(cells, cell));
    }
  }

  TriMesh merged() {
    TriMesh mesh;
    std::size_t vertices = 0, triangles = 0;
    for (const TileMesh& tile : meshes_) {
      vertices += tile.vertices.size();
      triangles += tile.triangles.size();
    }
    mesh.vertices.reserve(vertices);
    mesh.triangles.reserve(triangles);
    mesh.owners.reserve(triangles);
    crowded_.clear();
    Welder welder;
    std::vector<std::uint32_t> of_shared, id;
    for (const TileMesh& tile : meshes_) {
      id.resize(tile.vertices.size());
      for (std::size_t v = 0; v < id.size(); ++v) {
        const auto fresh = static_cast<std::uint32_t>(mesh.vertices.size());
        id[v] = fresh;
        if (tile.is_shared[v]) {
          const std::uint32_t known = welder.add(tile.vertices[v]);
          if (known == of_shared.size()) of_shared.push_back(fresh);
          id[v] = of_shared[known];
        }
        if (id[v] == fresh) mesh.vertices.push_back(tile.vertices[v]);
      }
      for (const auto& t : tile.triangles) mesh.triangles.push_back({id[t[0]], id[t[1]], id[t[2]]});
      mesh.owners.insert(mesh.owners.end(), tile.owners.begin(), tile.owners.end());
      for (const auto& [v, cell] : tile.crowded) crowded_.emplace(id[v], cell);
    }
    return mesh;
  }

  // Only cells with more than one loop can hold triangles that meet (docs/mesh.md, Surface).
  std::set<CellPlace> crossed_cells(const TriMesh& mesh) const {
    std::set<CellPlace> bad;
    if (crowded_.empty()) return bad;
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> names;
    std::unordered_map<std::uint32_t, std::uint32_t> id;
    std::vector<std::array<std::uint32_t, 3>> some;
    for (const auto& t : mesh.triangles) {
      if (crowded_.count(t[0]) + crowded_.count(t[1]) + crowded_.count(t[2]) == 0) continue;
      std::array<std::uint32_t, 3> triangle{};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [it, is_new] = id.try_emplace(t[k], static_cast<std::uint32_t>(names.size()));
        if (is_new) {
          names.push_back(t[k]);
          const auto& p = mesh.vertices[t[k]];
          vertices.push_back({p[0], p[1], p[2]});
        }
        triangle[k] = it->second;
      }
      some.push_back(triangle);
    }
    for (const auto& [i, j] : self_intersections(vertices, some, options_.threads))
      for (const std::uint32_t k : {i, j})
        for (const std::uint32_t v : some[k])
          if (const auto it = crowded_.find(names[v]); it != crowded_.end()) bad.insert(it->second);
    return bad;
  }

  // Splits these cells, and what their neighbours then must split, until all tiles agree.
  void split(std::set<CellPlace> fresh) {
    while (!fresh.empty()) {
      for (const CellPlace& cell : fresh)
        if (cell.size < 2)
          throw Error("mesh-unresolved", "pieces of surface in one cell of the mesh meet");
      forced_.insert(fresh.begin(), fresh.end());
      std::vector<std::size_t> again;
      for (std::size_t i = 0; i < tiles_.size(); ++i)
        if (std::any_of(fresh.begin(), fresh.end(), [&](const CellPlace& cell) {
              return covers(tiles_[i], cell.origin, 0, kCells);
            }))
          again.push_back(i);
      make(again);
      fresh.clear();
      for (const std::size_t i : again)
        for (const CellPlace& cell : meshes_[i].splits)
          if (forced_.count(cell) == 0) fresh.insert(cell);
    }
  }

  void finish_report(const TriMesh& mesh) {
    report_.triangles_before = mesh.triangles.size();
    std::vector<FoundThin> thin;
    for (const TileMesh& tile : meshes_) {
      report_.cells += tile.cells;
      thin.insert(thin.end(), tile.thin.begin(), tile.thin.end());
    }
    report_.thin = distinct(thin);
    timer_.step("thin");
  }

  const ExactField& field_;
  const Lattice lattice_;
  const MeshOptions& options_;
  ContourReport& report_;
  ContourTimer timer_;
  std::mutex mutex_;
  std::vector<Tile> tiles_;
  std::vector<TileMesh> meshes_;
  std::set<CellPlace> forced_;                            ///< cells that must be split
  std::unordered_map<std::uint32_t, CellPlace> crowded_;  ///< by vertex of the mesh
};

}  // namespace

TriMesh contour_uniform(const ExactField& field, double voxel, int fine_levels,
                        const MeshOptions& options, ContourReport& report) {
  return UniformContour(field, Lattice(field.bounds(), voxel, fine_levels, kMargin), options,
                        report)
      .run();
}

}  // namespace mrsim::detail
