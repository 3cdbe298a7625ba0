// The octree of the mesher: cells that the surface may pass, with the sweeps that can matter in
// them and the exact samples at their corners (docs/mesh.md, Cells).
#pragma once

#include "mesh/contour_lattice.h"
#include "mesh/flat_map.h"
#include "removal/field.h"

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

/// One edge of the grid that no smaller cell divides, and the four cells about it (equal where one
/// cell spans two quadrants).
struct MinimalEdge {
  std::int32_t cells[4];  ///< by bits: side on axis + 1, side on axis + 2
  LatticePoint start;
  std::int32_t axis = 0, length = 0;
  std::int32_t low = -1, high = -1;  ///< samples at its ends
};

class ContourOctree {
 public:
  /// With a tolerance (mm), cells above a voxel may stay where one smooth face passes; without, all
  /// cells that the surface may pass are voxels.
  ContourOctree(const ExactField& field, const Lattice& lattice, double tolerance, int threads);

  const Lattice& lattice() const { return lattice_; }
  const OctreeNode& node(std::int32_t i) const { return nodes_[static_cast<std::size_t>(i)]; }
  std::size_t size() const { return nodes_.size(); }
  const FieldSample& sample(std::int32_t i) const { return samples_[static_cast<std::size_t>(i)]; }

  /// The sweeps that can decide d in the cell.
  std::span<const std::uint32_t> candidates(std::int32_t node) const;
  /// The leaf that holds p; on a plane of the grid, up to rounding, one of the two.
  std::int32_t locate(const Vec3& p) const;
  Box3 box(std::int32_t node) const;

  bool can_split(std::int32_t node) const { return this->node(node).size >= 2; }
  /// Splits the given leaves; duplicates and what can not be split are skipped. Number split.
  std::size_t split(std::vector<std::int32_t> leaves);

  /// All edges whose ends lie on different sides of the surface, in the order of the tree.
  std::vector<MinimalEdge> crossing_edges() const;
  /// The same about the given leaves and those that share an edge with them; `nearby` is set for
  /// all of these.
  std::vector<MinimalEdge> crossing_edges_near(std::span<const std::int32_t> leaves,
                                               std::vector<char>& nearby) const;
  /// Edges up to a voxel long whose ends lie on the same side, have different owners, and are near
  /// enough to the surface for it to pass twice between them.
  std::vector<MinimalEdge> doubtful_edges() const;
  /// Leaves made by the last split.
  const std::vector<std::int32_t>& new_leaves() const { return new_leaves_; }

 private:
  void refine(std::vector<std::int32_t> pending);
  void find_regions(const std::vector<std::int32_t>& pending);
  void sample_corners(const std::vector<std::int32_t>& pending);
  bool must_split(std::int32_t node);
  bool bends_too_much(std::int32_t node, const Box3& box, const FieldSample& middle) const;
  bool shows_more(std::int32_t node, std::span<const std::int32_t> seen, bool stock_seen) const;
  void add_children(std::int32_t node, std::vector<std::int32_t>& out);

  const ExactField& field_;
  Lattice lattice_;
  double tolerance_;
  int threads_;
  std::vector<OctreeNode> nodes_;
  std::vector<std::int32_t> new_leaves_;
  std::vector<Candidates> lists_;  ///< by node
  std::vector<FieldSample> samples_;
  FlatMap sample_of_;
};

}  // namespace mrsim::detail
