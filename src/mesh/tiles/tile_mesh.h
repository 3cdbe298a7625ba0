// What the tiles of the uniform grid add to the mesh, and how it is joined (docs/mesh.md, Tiles).
//
// Tiles come by rows and layers, the longest axis of the part last to grow, so that only a narrow
// front of vertices is shared with tiles to come.
#pragma once

#include "mesh/solid/mesh_block.h"
#include "mesh/solid/vertex_lattice.h"
#include "mesh/solid/weld.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <unordered_map>
#include <vector>

namespace mrsim::detail {

/// The order of tiles: by their places on three axes, the first named first.
struct TileOrder {
  std::array<int, 3> axes{0, 1, 2};
  std::int32_t layer(const LatticePoint& place) const { return component(place, axes[0]); }
  /// Grows with the order; `place` in tiles.
  std::uint64_t key(const LatticePoint& place) const {
    std::uint64_t k = 0;
    for (const int axis : axes) k = k << 21 | static_cast<std::uint64_t>(component(place, axis));
    return k;
  }
};
inline constexpr std::uint64_t kNoTile = std::numeric_limits<std::uint64_t>::max();

/// What a tile adds to the mesh.
struct TileMesh {
  /// Marks of a vertex: bit a: the next tile on axis a may have it too.
  static constexpr std::uint8_t kShared = 8;  ///< another tile may have it

  std::vector<std::array<float, 3>> vertices;
  std::vector<std::uint8_t> marks;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::int32_t> owners;
  std::vector<std::array<std::uint32_t, 2>> border;  ///< edges that other tiles have to close

  std::size_t memory() const;  ///< bytes, about
};

/// The marks of a vertex in a tile. `low`, `high`: where its first and last cells begin that are
/// its own; `middle`: of these cells. The vertex of a side that is one square lies there on two
/// axes, and may be of all tiles about this one.
std::uint8_t tile_marks(const Vec3& p, const Vec3& low, const Vec3& high, const Vec3& middle);

/// The directed edges of triangles between marked vertices whose opposite no triangle has.
std::vector<std::array<std::uint32_t, 2>> border_edges(const TileMesh& tile);

/// Joins tiles, in their order, by the coordinates of the vertices that they share.
class TileMerger {
 public:
  explicit TileMerger(const TileOrder& order) : order_(order) {}
  /// Forgets all tiles.
  void restart();
  void add(const LatticePoint& place, const TileMesh& tile);
  /// The tiles since the last block, valid until the next add(). `next`: key of the tile that comes
  /// next. Throws Error "mesh-too-large".
  MeshBlock block(std::uint64_t next);
  /// After the last tile: where tiles have not met, as ends of edges that none has closed.
  std::vector<std::array<float, 3>> gaps() const;

 private:
  static constexpr std::uint32_t kUnused = ~std::uint32_t(0);
  static constexpr std::uint32_t kBorrowed = std::uint32_t(1) << 31;  ///< bit of an index

  struct SharedVertex {
    std::uint64_t last = 0;         ///< key of the last tile that may have it
    std::uint32_t number = 0;       ///< in the whole mesh
    std::uint32_t index = kUnused;  ///< in this block, with kBorrowed where it is an earlier one
  };
  struct UnmatchedEdge {
    int count = 0;  ///< triangles that run along the edge, less those against
    std::array<float, 3> end{};
  };
  std::uint32_t index_of(SharedVertex& vertex, const std::array<float, 3>& point);
  void close_edges(const TileMesh& tile);
  void begin_block();

  TileOrder order_;
  bool is_complete_ = false;  ///< block() was called: the next tile begins a new one
  std::uint32_t first_new_ = 0;
  Welder welder_;
  std::vector<SharedVertex> shared_;  ///< by the welder's index
  std::vector<std::array<float, 3>> fresh_, points_;
  std::vector<std::uint32_t> borrowed_, unfinished_, index_, number_;
  std::unordered_map<std::uint64_t, UnmatchedEdge>
      unmatched_edges_;  ///< by the numbers of their ends
  std::vector<std::array<float, 3>> borrowed_points_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<std::int32_t> owners_;
};

}  // namespace mrsim::detail
