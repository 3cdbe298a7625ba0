#include "mesh/tiles/uniform.h"

#include "core/process/error.h"
#include "core/process/ordered.h"
#include "core/process/parallel.h"
#include "mesh/cells/step_timer.h"
#include "mesh/tiles/bare_tile_set.h"
#include "mesh/tiles/kept_tiles.h"
#include "mesh/tiles/tile_maker.h"

#include <algorithm>
#include <memory>
#include <set>
#include <vector>

namespace mrsim::detail {
namespace {

constexpr double kMostTold = 0.99;  ///< share of the triangles whose distance is printed
constexpr int kVoxelsBefore = 4;    ///< voxels before the part, which no owned edge is missed in
constexpr std::size_t kBatch = 2;   ///< tiles a thread between two blocks of the mesh

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
        common_(field, lattice),
        maker_(field, lattice, common_, options.measure),
        kept_(set_.tiles.size(), options.tile_room) {
    find_bare();
    timer_.step("tiles");
  }

  // The blocks go out as they are made. Should tiles not meet, or cells turn out to be crossed,
  // the mesh is handed on anew; tiles that stay as they are were kept for that, as far as there was
  // room.
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

  // Splits these cells, and what their neighbours then must split, until all tiles agree.
  void split(std::set<CellPlace> fresh) {
    while (!fresh.empty()) {
      for (const CellPlace& cell : fresh)
        if (cell.size < 2)
          throw Error("mesh-unresolved", "pieces of surface in one cell of the mesh meet");
      mended_.split.insert(fresh.begin(), fresh.end());
      find_bare();
      const std::vector<std::size_t> again = tiles_with(fresh);
      make_again(again);
      fresh.clear();
      for (const std::size_t i : again)
        for (const CellPlace& cell : notes_[i].splits)
          if (mended_.split.count(cell) == 0) fresh.insert(cell);
    }
  }

 private:
  std::int32_t unit() const { return lattice_.per_voxel(); }

  // The mesh goes on in blocks of as many tiles, whoever has made them.
  void make_all(MeshSink& sink) {
    ++report_.passes;
    show_progress(0);
    const std::size_t batch = kBatch * static_cast<std::size_t>(resolve_threads(options_.threads));
    TileMerger merger(set_.order);
    std::size_t joined = 0, triangles = 0;
    make_in_order(
        set_.tiles.size(), options_.threads, [&](std::size_t i) { return tile_mesh(i); },
        [&](const std::shared_ptr<const TileMesh>& tile) {
          merger.add(set_.tiles[joined++].place, *tile);
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

  // The kept mesh of tile i, or a new one.
  std::shared_ptr<const TileMesh> tile_mesh(std::size_t i) {
    std::shared_ptr<const TileMesh> kept = kept_.find(i, bare_.about(set_.tiles[i].place));
    return kept != nullptr ? kept : make_tile(i);
  }

  std::shared_ptr<const TileMesh> make_tile(std::size_t i) {
    const BareTiles about = bare_.about(set_.tiles[i].place);
    auto mesh =
        std::make_shared<const TileMesh>(maker_.make(set_.tiles[i], mended_, about, notes_[i]));
    kept_.keep(i, about, mesh);
    return mesh;
  }

  void show_progress(std::size_t done) {
    const double share = static_cast<double>(done) / static_cast<double>(set_.tiles.size());
    if (options_.progress && !options_.progress("meshing", share))
      throw Error("cancelled", "the run was stopped");
  }

  // Whether anything was found for which tiles must be made again.
  bool mend() {
    bool is_new = false;
    for (const auto& gap : gaps_) is_new = settle({gap[0], gap[1], gap[2]}) || is_new;
    for (std::set<CellPlace> bad = crossed(); !bad.empty(); bad = crossed()) {
      std::set<CellPlace> uneven;
      for (const CellPlace& cell : bad)
        if (mended_.flat.count(cell) == 0) uneven.insert(cell);
      if (uneven.empty())
        split(std::move(bad));
      else
        flatten(uneven);
      is_new = true;
    }
    return is_new;
  }

  void flatten(const std::set<CellPlace>& cells) {
    mended_.flat.insert(cells.begin(), cells.end());
    make_again(tiles_with(cells));
  }

  void make_again(const std::vector<std::size_t>& tiles) {
    parallel_for(tiles.size(), options_.threads, [&](std::size_t k) { make_tile(tiles[k]); });
  }

  // The cells about a vertex on which tiles do not agree, and those that theirs depend on.
  bool settle(const Vec3& vertex) {
    const LatticePoint at = lattice_.floor(vertex);
    const auto cell = [&](int a, std::int32_t i) { return component(at, a) / unit() + i; };
    bool is_new = false;
    for (std::int32_t i = 0; i < 27; ++i) {
      const LatticePoint p{cell(0, i / 9 - 1), cell(1, i / 3 % 3 - 1), cell(2, i % 3 - 1)};
      if (!common_.add(p)) continue;
      is_new = true;
      const CellPlace place{{p.x * unit(), p.y * unit(), p.z * unit()}, unit()};
      for (const std::size_t tile : tiles_with({place})) kept_.forget(tile);
    }
    return is_new;
  }

  void find_bare() {
    std::vector<LatticePoint> split;
    for (const CellPlace& cell : mended_.split)
      split.push_back({cell.origin.x / unit(), cell.origin.y / unit(), cell.origin.z / unit()});
    bare_.find(set_, split);
  }

  // The tiles that have one of the cells among their own or in their rings.
  std::vector<std::size_t> tiles_with(const std::set<CellPlace>& cells) const {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < set_.tiles.size(); ++i)
      if (std::any_of(cells.begin(), cells.end(), [&](const CellPlace& cell) {
            return reaches(set_.tiles[i], cell, lattice_);
          }))
        out.push_back(i);
    return out;
  }

  std::set<CellPlace> crossed() const {
    std::vector<CrowdedTile> crowded;
    for (std::size_t i = 0; i < set_.tiles.size(); ++i)
      if (!notes_[i].crowded.triangles.empty())
        crowded.push_back({set_.order.layer(set_.tiles[i].place), &notes_[i].crowded});
    std::set<CellPlace> bad = crossed_cells(crowded, options_.threads);
    for (const TileNotes& notes : notes_) bad.insert(notes.meeting.begin(), notes.meeting.end());
    return bad;
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
    report_.volume_excess = distance.excess();
    timer_.step("thin");
  }

  const ExactField& field_;
  const Lattice lattice_;
  const MeshPlan& options_;
  MeshReport& report_;
  StepTimer timer_;
  const TileSet set_;
  std::vector<TileNotes> notes_;
  std::vector<std::array<float, 3>> gaps_;  ///< between the tiles that were made last
  MendedCells mended_;
  BareTileSet bare_;    ///< of the tiles that were made last
  CommonLists common_;  ///< of cells in which tiles did not meet
  TileMaker maker_;
  KeptTiles kept_;  ///< as they would be made now
};

}  // namespace

void mesh_uniform(const ExactField& field, double voxel, int halvings, const MeshPlan& options,
                  MeshSink& sink, MeshReport& report, const std::set<CellPlace>& split) {
  UniformMesher mesher(field, Lattice(field.bounds(), voxel, halvings, kVoxelsBefore), options,
                       report);
  mesher.split(split);
  mesher.run(sink);
}

}  // namespace mrsim::detail
