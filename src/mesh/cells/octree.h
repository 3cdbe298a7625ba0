// The octree of the mesher: cells that the surface may pass, with the sweeps that can matter in
// them and the exact samples at their corners (docs/mesh.md, Cells).
#pragma once

#include "mesh/cells/cell_scan.h"
#include "mesh/cells/cells.h"
#include "mesh/cells/common_lists.h"
#include "mesh/cells/flat_map.h"
#include "mesh/cells/surface_lists.h"
#include "removal/field/field.h"

#include <cstdint>
#include <span>
#include <vector>

namespace mrsim::detail {

struct OctreeNode {
  LatticePoint origin;
  std::int32_t size = 0;    ///< fine units
  std::int32_t child = -1;  ///< first of eight, by bits x, y, z; -1 = leaf
  std::int32_t parent = -1;
  ExactField::Region region = ExactField::Region::mixed;
  bool signs_differ = false;  ///< of its corners
  bool plain = false;         ///< nothing but `face` can decide d in it
  FieldSample face;
  std::int32_t corners[8] = {-1, -1, -1, -1, -1, -1, -1, -1};  ///< samples; mixed leaves only
};

/// A cube of the grid that is worked on by itself: a tile of the uniform mesher whose cells must be
/// split (tile.h). `complete` is where is_complete() holds, `owned` where edges start.
struct OctreePart {
  LatticePoint origin;    ///< of the root, fine units
  std::int32_t size = 0;  ///< of the root, fine units
  std::span<const std::uint32_t> candidates;
  std::int32_t complete[2] = {}, owned[2] = {};  ///< ranges from the origin, fine units
  const CommonLists* common = nullptr;  ///< of cells that do not take the part's, null = none
};

/// Limits on the nodes of an octree: their memory in bytes, and their number; 0 = no limit.
struct OctreeLimits {
  std::size_t memory = 0, nodes = 0;
};

class CellOctree final : public SurfaceCells {
 public:
  /// With a tolerance (mm), cells above a voxel may stay where one smooth face passes; without, all
  /// cells that the surface may pass are voxels. Throws Error "memory" or "mesh-unresolved" once
  /// its nodes exceed the limits; split() does so, too.
  CellOctree(const ExactField& field, const Lattice& lattice, double tolerance, int threads,
             const OctreeLimits& limits = {});
  /// The octree of one part of the grid, without a tolerance.
  CellOctree(const ExactField& field, const Lattice& lattice, const OctreePart& part);

  const OctreeNode& node(std::int32_t i) const { return nodes_[static_cast<std::size_t>(i)]; }
  std::size_t size() const override { return nodes_.size(); }
  std::int32_t size_of(std::int32_t cell) const override { return node(cell).size; }
  const FieldSample& sample(std::int32_t i) const { return samples_[static_cast<std::size_t>(i)]; }

  bool is_mixed(std::int32_t cell) const override {
    return node(cell).region == ExactField::Region::mixed;
  }
  /// The sweeps that can decide d in the leaf.
  std::span<const std::uint32_t> candidates(std::int32_t node) const override {
    return lists_[static_cast<std::size_t>(node)];
  }
  /// What decides d at p, in the leaf.
  FieldSample sample_at(const Vec3& p, std::int32_t cell) const;
  /// Makes sample_at() faster on surface that many sweeps share, until leaves are split.
  void shorten_lists() { short_lists_ = SurfaceLists(field_, *this, threads_); }
  /// The leaf that holds p; on a plane of the grid, up to rounding, one of the two. Faster where
  /// `near` is a cell close to it.
  std::int32_t locate(const Vec3& p, std::int32_t near = 0) const;
  Box3 box(std::int32_t node) const override;
  bool is_complete(std::int32_t cell) const override {
    return is_whole() || in_range(node(cell).origin, part_.complete);
  }
  /// True where all corners of the cell lie on one side: the surface may still pass between them.
  bool is_far(std::int32_t cell) const override { return !node(cell).signs_differ; }
  bool is_owned_cell(std::int32_t cell) const override { return is_owned(node(cell).origin); }
  bool is_owned(const LatticePoint& edge_start) const {
    return is_whole() || in_range(edge_start, part_.owned);
  }

  /// Cells that are made from now on may hide and bend as a tolerance of so many mm allows.
  /// `most_nodes`: in all, 0 = any number.
  void go_on_within(double tolerance, std::size_t most_nodes) {
    tolerance_ = tolerance;
    limits_.nodes = most_nodes;
  }
  bool can_split(std::int32_t node) const { return this->node(node).size >= 2; }
  /// Splits the given leaves; duplicates and what can not be split are skipped. Number split.
  std::size_t split(std::vector<std::int32_t> leaves);
  /// Nodes since the surface was drawn last: split() leaves room for their surface.
  std::size_t undrawn() const { return size() - drawn_; }
  void mark_drawn() { drawn_ = size(); }

  /// All edges that no smaller cell divides and whose ends lie on different sides of the surface,
  /// in the order of the tree; of a part: in the order of their places.
  std::vector<MinimalEdge> crossing_edges() const;
  /// Those of crossing_edges() that lie about the leaves that are set.
  std::vector<MinimalEdge> crossing_edges_about(const std::vector<char>& leaves) const;
  /// Sets the leaves, too, that share an edge with one that is set. `leaves`: by cell.
  void add_neighbours(std::vector<char>& leaves) const;
  /// The faces about these edges, each with its crossings, in the order of the edges; of a part:
  /// by axis and plane. `complete`: the cells whose edges are all there; empty: as is_complete().
  std::vector<CellFace> faces(std::span<const MinimalEdge> edges,
                              const std::vector<char>& complete = {}) const;
  std::pair<double, double> offsets(const MinimalEdge& edge) const override;
  EdgeEnds ends(const MinimalEdge& edge) const override;
  /// Edges up to a voxel long whose ends lie on the same side, have different owners, and are near
  /// enough to the surface for it to pass twice between them; in cells above a voxel, those of
  /// doubtful_inside() (doubtful_edges.h).
  std::vector<MinimalEdge> doubtful_edges() const;
  /// Leaves made by the last split.
  const std::vector<std::int32_t>& new_leaves() const { return new_leaves_; }

 private:
  const Candidates* common_list(std::int32_t cell) const;
  bool is_whole() const { return part_.size == lattice().size(); }
  bool in_range(const LatticePoint& p, const std::int32_t (&range)[2]) const;
  void refine(std::vector<std::int32_t> pending);
  /// Reserves memory for the parts of that many cells. Throws Error "memory", "mesh-unresolved".
  void make_room(std::size_t split);
  void find_regions(const std::vector<std::int32_t>& pending);
  void sample_corners(const std::vector<std::int32_t>& pending);
  bool shows_box(std::int32_t node) const;
  bool must_split(std::int32_t node);
  /// What the samples of a cell show of the part.
  struct Sight {
    bool one_face = false, owners_seen = false, stock_seen = false;
    bool is_alone = false;  ///< nothing but the centre's owner can decide d
  };
  Sight look_at(std::int32_t node, const Box3& box, const CellSurface& surface, Candidates& seen);
  void add_children(std::int32_t node, std::vector<std::int32_t>& out);
  void add_doubtful_inside(std::vector<MinimalEdge>& out) const;
  std::vector<char> with_parents(std::vector<char> leaves) const;

  const ExactField& field_;
  OctreePart part_;
  double tolerance_;
  int threads_;
  OctreeLimits limits_;
  bool is_box_ = false;    ///< the stock is, and there is a tolerance
  std::size_t drawn_ = 0;  ///< nodes over which the surface was drawn
  std::vector<OctreeNode> nodes_;
  std::vector<std::int32_t> new_leaves_;
  std::vector<Candidates> lists_;  ///< by node
  std::size_t listed_ = 0;         ///< sweeps that they have room for
  SurfaceLists short_lists_;
  std::vector<FieldSample> samples_;
  FlatMap sample_of_;
};

}  // namespace mrsim::detail
