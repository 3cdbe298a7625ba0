#include "mesh/tiles/uniform.h"

#include "core/process/error.h"
#include "core/process/ordered.h"
#include "core/process/parallel.h"
#include "mesh/cells/step_timer.h"
#include "mesh/cells/thin_features.h"
#include "mesh/cells/tile.h"
#include "mesh/surface/surface.h"
#include "mesh/tiles/bare_tile_set.h"
#include "mesh/tiles/crowded_cells.h"
#include "mesh/tiles/mesh_distance.h"
#include "mesh/tiles/tile_mesh.h"
#include "mesh/tiles/tile_search.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <set>
#include <tuple>

namespace mrsim::detail {
namespace {

constexpr double kShallowCrease =
    1.0 / 64;                       ///< of a voxel: what cutting off a shallow crease may move
constexpr double kMostTold = 0.99;  ///< share of the triangles whose distance is printed
constexpr int kVoxelsBefore = 4;    ///< voxels before the part, which no owned edge is missed in
constexpr std::size_t kBatch = 2;   ///< tiles a thread between two blocks of the mesh
constexpr std::int32_t kFirstOwned = CellTile::kFirstOwned;

/// What is remembered of a tile when its mesh has gone to the sink.
struct TileNotes {
  CrowdedTriangles crowded;
  std::vector<CellPlace> touching;  ///< owned cells with two vertices in one point
  std::vector<CellPlace> splits;    ///< of owned cells
  std::vector<FoundThin> thin;
  MeshDistance distance;  ///< where it is to be measured
  std::size_t cells = 0, triangles = 0;
};

/// A thread's memory for the tiles it makes.
struct TileMaker {
  TileMaker(const ExactField& field, const Lattice& lattice, const CommonLists& common)
      : cells(field, lattice, &common),
        surface(field, cells, {.shallow = kShallowCrease * lattice.voxel(), .threads = 1}) {}
  CellTile cells;
  DualSurface surface;
};

class UniformMesher {
 public:
  UniformMesher(const ExactField& field, const Lattice& lattice, const MeshPlan& options,
                MeshReport& report)
      : field_(field),
        lattice_(lattice),
        options_(options),
        report_(report),
        timer_(report, {}),  // progress is counted by tiles
        set_(find_tiles(field, lattice, options.threads)),
        notes_(set_.tiles.size()),
        common_(field, lattice) {
    timer_.step("tiles");
  }

  // The blocks go out as they are made. Should tiles not meet, or cells turn out to be crossed,
  // which is rare, all tiles are made again once it is known what to do about it.
  void run(MeshSink& sink) {
    make_all(sink);
    timer_.step("cells");
    while (mend()) {
      timer_.step("check");
      sink.restart();
      make_all(sink);
      timer_.step("cells");
    }
    timer_.step("check");
    finish_report();
  }

 private:
  std::int32_t unit() const { return lattice_.per_voxel(); }

  // The mesh goes on in blocks of as many tiles, whoever has made them.
  void make_all(MeshSink& sink) {
    ++report_.passes;
    show_progress(0);
    std::vector<LatticePoint> split;
    for (const CellPlace& cell : forced_)
      split.push_back({cell.origin.x / unit(), cell.origin.y / unit(), cell.origin.z / unit()});
    bare_.find(set_, split);
    const std::size_t batch = kBatch * static_cast<std::size_t>(resolve_threads(options_.threads));
    TileMerger merger(set_.order);
    std::size_t joined = 0, triangles = 0;
    make_in_order(
        set_.tiles.size(), options_.threads, [&](std::size_t i) { return make_tile(i); },
        [&](const TileMesh& tile) {
          merger.add(set_.tiles[joined++].place, tile);
          if (joined % batch == 0 || joined == set_.tiles.size())
            hand_on(merger, joined, triangles, sink);
        },
        batch);
    gaps_ = merger.gaps();
  }

  void hand_on(TileMerger& merger, std::size_t joined, std::size_t& triangles, MeshSink& sink) {
    const bool is_last = joined == set_.tiles.size();
    const MeshBlock block =
        merger.block(is_last ? kNoTile : set_.order.key(set_.tiles[joined].place));
    triangles += block.triangles.size();
    const auto in_all = [&](std::size_t so_far) {
      return so_far * set_.tiles.size() / joined * 9 / 8;  // tiles are more or less alike
    };
    sink.expect(in_all(block.first_new + block.fresh().size()), in_all(triangles));
    sink.take(block);
    show_progress(joined);
  }

  // A thread has a tile's memory for itself, which is used again.
  TileMesh make_tile(std::size_t i) {
    std::unique_ptr<TileMaker> maker = take_maker();
    TileMesh mesh = make_tile(i, *maker);
    give_maker(std::move(maker));
    return mesh;
  }

  TileMesh make_tile(std::size_t i, TileMaker& maker) {
    const Tile& tile = set_.tiles[i];
    if (!forced_in(tile).empty()) return make_split(tile, notes_[i]);
    maker.cells.build(tile.first, tile.candidates, CellTile::FlatCells::merged,
                      bare_.about(tile.place));
    maker.surface.find_loops(maker.cells);
    maker.surface.make_triangles();
    TileMesh mesh = collect(maker.surface, maker.cells, tile, notes_[i]);
    notes_[i].thin = thin_features(field_, maker.cells, maker.cells.doubtful_edges());
    return mesh;
  }

  std::unique_ptr<TileMaker> take_maker() {
    const std::scoped_lock lock(mutex_);
    if (makers_.empty()) return std::make_unique<TileMaker>(field_, lattice_, common_);
    std::unique_ptr<TileMaker> maker = std::move(makers_.back());
    makers_.pop_back();
    return maker;
  }
  void give_maker(std::unique_ptr<TileMaker> maker) {
    const std::scoped_lock lock(mutex_);
    makers_.push_back(std::move(maker));
  }

  void show_progress(std::size_t done) {
    const double share = static_cast<double>(done) / static_cast<double>(set_.tiles.size());
    if (options_.progress && !options_.progress("meshing", share))
      throw Error("cancelled", "the run was stopped");
  }

  std::vector<CellPlace> forced_in(const Tile& tile) const {
    std::vector<CellPlace> out;
    for (const CellPlace& cell : forced_)
      if (covers(tile, cell.origin, 0, kTileCells)) out.push_back(cell);
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
  TileMesh make_split(const Tile& tile, TileNotes& notes) const {
    OctreePart part;
    part.origin = {tile.first.x * unit(), tile.first.y * unit(), tile.first.z * unit()};
    part.size = kTileCells * unit();
    part.candidates = tile.candidates;
    part.complete[0] = unit();
    part.complete[1] = (kTileCells - 1) * unit();
    part.owned[0] = kFirstOwned * unit();
    part.owned[1] = (kFirstOwned + kTileOwned) * unit();
    part.common = &common_;
    CellOctree tree(field_, lattice_, part);
    for (std::size_t count = 1; count > 0;) {
      std::vector<std::int32_t> leaves;
      for (std::int32_t n = 0; n < static_cast<std::int32_t>(tree.size()); ++n)
        if (tree.node(n).child < 0 && forced_.count({tree.node(n).origin, tree.node(n).size}) > 0)
          leaves.push_back(n);
      count = tree.split(std::move(leaves));
    }
    CrossedGrid grid = split_badly_crossed(tree);
    DualSurface surface(field_, tree, {.shallow = kShallowCrease * lattice_.voxel(), .threads = 1});
    surface.find_loops(std::move(grid));
    surface.make_triangles();
    TileMesh mesh = collect(surface, tree, tile, notes);
    for (std::int32_t n = 0; n < static_cast<std::int32_t>(tree.size()); ++n) {
      const OctreeNode& node = tree.node(n);
      if (node.child >= 0 && node.size <= unit() && tree.is_owned(node.origin))
        notes.splits.push_back({node.origin, node.size});
    }
    std::vector<MinimalEdge> doubtful = tree.doubtful_edges();
    std::erase_if(doubtful, [&](const MinimalEdge& e) {
      const auto cell = [&](int a) {
        return (component(e.start, a) - component(part.origin, a)) / unit();
      };
      return !CellTile::tests_edge({cell(0), cell(1), cell(2)}, e.axis);
    });
    notes.thin = thin_features(field_, tree, doubtful);
    return mesh;
  }

  template <class Cells>
  TileMesh collect(const DualSurface& surface, const Cells& cells, const Tile& tile,
                   TileNotes& notes) const {
    const BaseMesh& base = surface.mesh();
    TileMesh out;
    const auto plane = [&](int axis, std::int32_t i) {
      return lattice_.coordinate(axis, (component(tile.first, axis) + i) * unit());
    };
    const Vec3 inner_low{plane(0, kFirstOwned), plane(1, kFirstOwned), plane(2, kFirstOwned)};
    const std::int32_t last = kFirstOwned + kTileOwned - 1;
    const Vec3 inner_high{plane(0, last), plane(1, last), plane(2, last)};
    constexpr std::int32_t kMiddle = kFirstOwned + kTileOwned / 2;
    const Vec3 middle{plane(0, kMiddle), plane(1, kMiddle), plane(2, kMiddle)};
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
          out.marks.push_back(tile_marks(p, inner_low, inner_high, middle));
        }
        triangle[k] = v;
      }
      out.triangles.push_back(triangle);
      out.owners.push_back(
          surface.crossings()[static_cast<std::size_t>(base.crossings[t])].at.owner);
    }
    out.border = border_edges(out);
    notes = {};
    if (options_.measure) notes.distance = measured(surface, cells);
    notes.crowded = crowded_triangles(out.vertices, out.triangles,
                                      crowded_vertices(surface, cells, id, out.vertices.size()));
    notes.touching = touching_cells(surface, cells);
    for (const Loop& loop : surface.loops()) notes.cells += cells.is_owned_cell(loop.cell);
    notes.triangles = out.triangles.size();
    return out;
  }

  template <class Cells>
  MeshDistance measured(const DualSurface& surface, const Cells& cells) const {
    const BaseMesh& base = surface.mesh();
    MeshDistance found;
    for (std::size_t t = 0; t < base.triangles.size(); ++t) {
      const auto& x = base.triangles[t];
      const Crossing& c = surface.crossings()[static_cast<std::size_t>(base.crossings[t])];
      found.add(field_, cells, c.edge, c.at,
                {base.vertices[x[0]], base.vertices[x[1]], base.vertices[x[2]]});
    }
    return found;
  }

  CellPlace place_of(const SurfaceCells& cells, std::int32_t cell) const {
    return {lattice_.nearest(cells.box(cell).lo), cells.size_of(cell)};
  }

  // The cells of vertices in cells with two pieces of surface; empty where there are none.
  std::vector<CellPlace> crowded_vertices(const DualSurface& surface, const SurfaceCells& cells,
                                          const std::vector<std::uint32_t>& id,
                                          std::size_t count) const {
    std::vector<CellPlace> out;
    if (surface.crowded().empty()) return out;
    out.resize(count);
    const std::set<std::int32_t> crowded(surface.crowded().begin(), surface.crowded().end());
    for (std::size_t v = 0; v < surface.loops().size(); ++v) {
      const std::int32_t cell = surface.loops()[v].cell;
      if (id[v] != ~0u && crowded.count(cell) > 0) out[id[v]] = place_of(cells, cell);
    }
    return out;
  }

  // Vertices are joined by their coordinates: two pieces of surface with one vertex would touch.
  std::vector<CellPlace> touching_cells(const DualSurface& surface,
                                        const SurfaceCells& cells) const {
    std::vector<CellPlace> out;
    if (surface.crowded().empty()) return out;
    const std::set<std::int32_t> crowded(surface.crowded().begin(), surface.crowded().end());
    std::set<std::tuple<std::int32_t, double, double, double>> seen;
    for (const Loop& loop : surface.loops()) {
      if (crowded.count(loop.cell) == 0 || !cells.is_owned_cell(loop.cell)) continue;
      const Vec3& p = loop.point.position;
      if (!seen.emplace(loop.cell, p.x, p.y, p.z).second) out.push_back(place_of(cells, loop.cell));
    }
    return out;
  }

  // Whether anything was found for which all tiles must be made again.
  bool mend() {
    bool is_new = false;
    for (const auto& gap : gaps_) is_new = settle({gap[0], gap[1], gap[2]}) || is_new;
    for (std::set<CellPlace> bad = crossed(); !bad.empty(); bad = crossed()) {
      split(std::move(bad));
      is_new = true;
    }
    return is_new;
  }

  // The cells about a vertex on which tiles do not agree, and those that theirs depend on.
  bool settle(const Vec3& vertex) {
    const LatticePoint at = lattice_.floor(vertex);
    const auto cell = [&](int a, std::int32_t i) { return component(at, a) / unit() + i; };
    bool is_new = false;
    for (std::int32_t i = 0; i < 27; ++i)
      is_new =
          common_.add({cell(0, i / 9 - 1), cell(1, i / 3 % 3 - 1), cell(2, i % 3 - 1)}) || is_new;
    return is_new;
  }

  std::set<CellPlace> crossed() const {
    std::vector<CrowdedTile> crowded;
    for (std::size_t i = 0; i < set_.tiles.size(); ++i)
      if (!notes_[i].crowded.triangles.empty())
        crowded.push_back({set_.order.layer(set_.tiles[i].place), &notes_[i].crowded});
    std::set<CellPlace> bad = crossed_cells(crowded, options_.threads);
    for (const TileNotes& notes : notes_) bad.insert(notes.touching.begin(), notes.touching.end());
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
      for (std::size_t i = 0; i < set_.tiles.size(); ++i)
        if (std::any_of(fresh.begin(), fresh.end(), [&](const CellPlace& cell) {
              return covers(set_.tiles[i], cell.origin, 0, kTileCells);
            }))
          again.push_back(i);
      parallel_for(again.size(), options_.threads, [&](std::size_t k) { make_tile(again[k]); });
      fresh.clear();
      for (const std::size_t i : again)
        for (const CellPlace& cell : notes_[i].splits)
          if (forced_.count(cell) == 0) fresh.insert(cell);
    }
  }

  void finish_report() {
    std::vector<FoundThin> thin;
    MeshDistance distance;
    for (const TileNotes& notes : notes_) {
      distance.add(notes.distance);
      report_.triangles_before += notes.triangles;
      report_.cells += notes.cells;
      thin.insert(thin.end(), notes.thin.begin(), notes.thin.end());
    }
    report_.thin = distinct(thin);
    report_.bound = distance.largest();
    report_.usual = distance.quantile(kMostTold);
    report_.sampled = distance.sampled();
    timer_.step("thin");
  }

  const ExactField& field_;
  const Lattice lattice_;
  const MeshPlan& options_;
  MeshReport& report_;
  StepTimer timer_;
  std::mutex mutex_;
  const TileSet set_;
  std::vector<TileNotes> notes_;
  std::vector<std::array<float, 3>> gaps_;          ///< between the tiles that were made last
  std::vector<std::unique_ptr<TileMaker>> makers_;  ///< those that no thread has
  std::set<CellPlace> forced_;                      ///< cells that must be split
  BareTileSet bare_;                                ///< of the tiles that were made last
  CommonLists common_;                              ///< of cells in which tiles did not meet
};

}  // namespace

void mesh_uniform(const ExactField& field, double voxel, int halvings, const MeshPlan& options,
                  MeshSink& sink, MeshReport& report) {
  UniformMesher(field, Lattice(field.bounds(), voxel, halvings, kVoxelsBefore), options, report)
      .run(sink);
}

}  // namespace mrsim::detail
