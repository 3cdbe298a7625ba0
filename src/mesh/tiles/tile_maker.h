// The meshes of single tiles, cell by cell or with some cells split (docs/mesh.md, Tiles).
#pragma once

#include "mesh/cells/bare_tiles.h"
#include "mesh/cells/common_lists.h"
#include "mesh/cells/thin_features.h"
#include "mesh/tiles/crowded_cells.h"
#include "mesh/tiles/mesh_distance.h"
#include "mesh/tiles/tile_mesh.h"
#include "mesh/tiles/tile_search.h"

#include <cstddef>
#include <memory>
#include <mutex>
#include <set>
#include <vector>

namespace mrsim::detail {

class DualSurface;

/// What is remembered of a tile when its mesh has gone to the sink.
struct TileNotes {
  std::set<CellPlace> meeting;    ///< cells whose pieces of surface meet within the tile
  CrowdedTriangles crowded;       ///< those that may meet triangles of other tiles
  std::vector<CellPlace> splits;  ///< of owned cells
  std::vector<FoundThin> thin;
  MeshDistance distance;  ///< where it is to be measured
  std::size_t cells = 0, triangles = 0;
};

/// Cells in which pieces of surface met.
struct MendedCells {
  std::set<CellPlace> flat;   ///< their vertices are put between their crossings
  std::set<CellPlace> split;  ///< where that was not enough, and what their neighbours then must
                              ///< split
};

/// Whether the tile has the cell among its own or in its rings.
bool reaches(const Tile& tile, const CellPlace& cell, const Lattice& lattice);

/// Any number of threads may use it at once. The references must outlive it.
class TileMaker {
 public:
  /// `common`: lists of cells in which tiles did not meet. `measure`: notes how far triangles are
  /// from the exact part.
  TileMaker(const ExactField& field, const Lattice& lattice, const CommonLists& common,
            bool measure);
  ~TileMaker();

  /// The mesh of a tile. `about`: the tiles about it that the stock alone decides. Equal
  /// arguments give the same mesh, except where `common` holds lists from other tiles.
  TileMesh make(const Tile& tile, const MendedCells& mended, const BareTiles& about,
                TileNotes& notes);

 private:
  struct Memory;
  TileMesh make_whole(const Tile& tile, const MendedCells& mended, const BareTiles& about,
                      TileNotes& notes, Memory& memory);
  TileMesh make_split(const Tile& tile, const MendedCells& mended, TileNotes& notes) const;
  void flatten(DualSurface& surface, const SurfaceCells& cells,
               const std::set<CellPlace>& flat) const;
  template <class Cells>
  TileMesh collect(const DualSurface& surface, const Cells& cells, const Tile& tile,
                   TileNotes& notes) const;
  template <class Cells>
  MeshDistance measured(const DualSurface& surface, const Cells& cells) const;
  Vec3 corner(const Tile& tile, std::int32_t cell) const;
  CellPlace place_of(const SurfaceCells& cells, std::int32_t cell) const;
  std::vector<CellPlace> crowded_vertices(const DualSurface& surface, const SurfaceCells& cells,
                                          const std::vector<std::uint32_t>& id,
                                          std::size_t count) const;
  std::vector<CellPlace> touching_cells(const DualSurface& surface,
                                        const SurfaceCells& cells) const;
  std::unique_ptr<Memory> take_memory();
  void give_memory(std::unique_ptr<Memory> memory);
  std::int32_t unit() const { return lattice_.per_voxel(); }

  const ExactField& field_;
  const Lattice lattice_;
  const CommonLists& common_;
  const bool measure_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Memory>> memories_;  ///< memories that no thread uses now
};

}  // namespace mrsim::detail
