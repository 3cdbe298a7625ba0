// One cube of the uniform grid: the same cells as an octree without larger or smaller ones would
// have, in dense arrays that are used again for the next tile (docs/mesh.md, Tiles).
//
// A tile owns the edges that start in kOwned^3 of its cells. Two rings of cells lie about them,
// so that a cell at an owned edge has all its crossings here, and this tile computes the same of it
// as the tile that owns it. Tiles follow each other by a multiple of the nodes that
// share lists, so that a cell has the same list in both but for rounding (common_lists.h).
#pragma once

#include "mesh/cells/cells.h"
#include "mesh/cells/common_lists.h"
#include "mesh/cells/tile_squares.h"

#include <memory>
#include <vector>

namespace mrsim::detail {

class CellTile final : public SurfaceCells {
 public:
  static constexpr std::int32_t kCells = kTileCells;
  static constexpr std::int32_t kOwned = kTileOwned;
  static constexpr std::int32_t kFirstOwned = kTileFirstOwned;
  static constexpr std::int32_t kEndOwned = kFirstOwned + kOwned;

  /// `common`: lists of cells that do not take the tile's, null = none.
  CellTile(const ExactField& field, const Lattice& lattice, const CommonLists* common = nullptr);

  /// `merged`: squares of cells are one each where no sweep can decide and the stock is a box. Of
  /// their edges only those at corners of squares count as crossed.
  enum class FlatCells : std::uint8_t { kept, merged };

  /// Moves to the cube whose first cell is `first` (in voxels, counted by the lattice).
  /// `candidates`: what can matter in it. `bare`: tiles of which a flat side is one square.
  void build(const LatticePoint& first, std::span<const std::uint32_t> candidates, FlatCells flat,
             const BareTiles& bare = {});

  std::size_t size() const override { return kCount; }
  std::int32_t size_of(std::int32_t) const override { return lattice().per_voxel(); }
  Box3 box(std::int32_t cell) const override;
  Box3 inner_box(std::int32_t cell) const override;
  bool is_mixed(std::int32_t cell) const override;
  std::span<const std::uint32_t> candidates(std::int32_t cell) const override;
  std::int32_t list_of(std::int32_t cell) const override;
  std::size_t lists() const override { return lists_.size(); }
  bool is_complete(std::int32_t cell) const override;
  bool is_far(std::int32_t cell) const override;
  bool is_owned_cell(std::int32_t cell) const override { return is_owned(point_of(cell)); }
  std::pair<double, double> offsets(const MinimalEdge& edge) const override;
  EdgeEnds ends(const MinimalEdge& edge) const override;

  /// The edges whose ends lie on different sides of the surface, and what lies about them.
  const TileEdges& crossed() const { return crossed_; }
  /// Adds these edges to `out`, by their numbers.
  void append_crossed(std::vector<MinimalEdge>& out) const;
  /// The cells that are merged to squares.
  const TileSquares& squares() const { return squares_; }
  /// The middle of a square in its layer, mm; along its axis, where the layer begins.
  Vec3 middle(const TileSquare& square) const;
  /// One of the square's cells in this tile.
  static std::int32_t cell_in(const TileSquare& square);
  /// Bits of the corners (x, y, z), z a bit: in the material.
  std::uint64_t inside(std::int32_t x, std::int32_t y) const { return column(x, y).inside; }
  static std::int32_t cell_at(std::int32_t x, std::int32_t y, std::int32_t z) {
    return (x * kCells + y) * kCells + z;
  }

  /// Edges with ends on the same side between which the surface may pass twice: different sweeps
  /// decide at the ends, and |d| there leaves room. Of those for which tests_edge() holds.
  std::vector<MinimalEdge> doubtful_edges() const;
  /// Whether a thin feature on an edge of this axis that starts in the cell is looked for here: by
  /// one tile of all, which knows the samples before and behind it on its line. So it starts where
  /// edges are owned, or one cell before that along its axis.
  static bool tests_edge(const LatticePoint& cell, int axis) {
    return is_tested(cell.x, axis == 0) && is_tested(cell.y, axis == 1) &&
           is_tested(cell.z, axis == 2);
  }

 private:
  static constexpr std::int32_t kFirstTested = kFirstOwned - 1;  ///< along an edge's own axis
  static constexpr std::int32_t kNode = 2;  ///< cells on a side that share a list of candidates;
                                            ///< twice as many where that is short
  static constexpr std::int32_t kNodes = kCells / kNode;
  static constexpr std::int32_t kStep[3] = {kCells * kCells, kCells, 1};
  static constexpr std::size_t kCount = std::size_t(kCells) * kCells * kCells;
  static_assert(kOwned % (2 * kNode) == 0);

  struct List {
    std::uint32_t begin = 0, end = 0;
  };
  static std::int32_t node_id(std::int32_t x, std::int32_t y, std::int32_t z) {
    return (x * kNodes + y) * kNodes + z;
  }
  static LatticePoint point_of(std::int32_t id) {
    constexpr std::int32_t kLast = kCells - 1;  // of a power of two
    return {id / (kCells * kCells), id / kCells & kLast, id & kLast};
  }
  static bool is_owned(const LatticePoint& p) {
    const auto in = [](std::int32_t i) { return i >= kFirstOwned && i < kEndOwned; };
    return in(p.x) && in(p.y) && in(p.z);
  }
  static bool is_tested(std::int32_t i, bool along) {
    const std::int32_t first = along ? kFirstTested : kFirstOwned;
    return i >= first && i < first + kOwned;
  }
  TileColumn& column(std::int32_t x, std::int32_t y) {
    return columns_[static_cast<std::size_t>(x * kCells + y)];
  }
  const TileColumn& column(std::int32_t x, std::int32_t y) const {
    return columns_[static_cast<std::size_t>(x * kCells + y)];
  }
  float known_offset(std::int32_t corner) const;
  float offset(std::int32_t corner) const;  ///< infinite where not sampled
  Vec3 position(const LatticePoint& corner) const;

  void visit(const LatticePoint& origin, std::int32_t size, std::size_t tier);
  Box3 node_box(const LatticePoint& origin, std::int32_t size) const;
  void fill(const LatticePoint& origin, std::int32_t size, bool inside);
  void find_stock();
  void add_common_lists();
  void add_list(std::span<const std::uint32_t> list);
  void set_list(const LatticePoint& origin, std::int32_t size, std::span<const std::uint32_t> list);
  std::int32_t own_list(std::int32_t cell) const;
  template <std::int32_t kSize>
  void mark_stock_node(const LatticePoint& origin);
  void find_crossed();
  template <std::int32_t kSize>
  void sample_node(const LatticePoint& origin, std::span<const std::uint32_t> list);
  bool runs_evenly(std::int32_t low, std::int32_t step) const;
  MinimalEdge edge_at(const LatticePoint& p, int axis) const;

  const ExactField& field_;
  const CommonLists* common_;
  LatticePoint first_;
  std::vector<double> planes_[3];                    ///< coordinates of the planes, mm
  std::vector<std::pair<double, double>> inner_[3];  ///< where vertices between two may lie, mm
  std::vector<TileColumn> columns_;
  std::vector<float> offset_;           ///< d + kInsideTolerance at corners, where sampled; NaN: of
                                        ///< the stock, when asked for
  std::vector<std::uint32_t> decider_;  ///< of d there
  std::vector<std::int32_t> list_of_;   ///< by node, 0 (empty) where no sweep can decide
  std::vector<List> lists_;
  std::vector<std::uint32_t> ids_;
  std::vector<std::pair<std::int32_t, std::int32_t>> own_lists_;  ///< by cell, the common ones
  std::unique_ptr<ExactField::Descent> descent_;
  Candidates list_;
  bool is_box_ = false;        ///< the stock is
  std::uint64_t within_[3]{};  ///< the box: bits of the planes
  TileEdges crossed_;
  TileSquares squares_;
};

}  // namespace mrsim::detail
