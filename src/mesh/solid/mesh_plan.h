// What the mesher is to make: the options of the user, and what a run has decided about them.
#pragma once

#include <mrsim/options.h>

#include <cstddef>

namespace mrsim {

struct MeshPlan {
  double tolerance = 0;  ///< MeshOptions::tolerance; 0 = a mesh on the grid of the voxels
  int threads = 0;       ///< MeshOptions::threads
  /// Bytes of memory that a mesh with a tolerance may take while it is made, 0 = any amount; more,
  /// by an estimate from its first cells, is an Error "memory".
  std::size_t max_memory = 0;
  /// Without a tolerance: measure how far the mesh is from the exact part.
  bool measure = false;
  /// Without a tolerance: bytes in which tiles that are done may be kept, so that they need not be
  /// made again where others must be.
  std::size_t tile_room = 0;
  /// A mesh within the tolerance is given up (MeshReport::given_up) where it takes more nodes of an
  /// octree than these, as its first cells show, or more memory, or is not possible. 0 =
  /// never: that is an Error.
  std::size_t most_nodes = 0;
  /// mm: before it is given up, the tolerance is doubled as long as it does not exceed this;
  /// because of the octree's nodes, half of this.
  double most_tolerance = 0;
  /// Whether another octree may be made for that where one has too many nodes.
  bool makes_new_octrees = false;
  Progress progress;
};

inline MeshPlan mesh_plan(const MeshOptions& options) {
  return {.tolerance = options.tolerance, .threads = options.threads, .progress = options.progress};
}

}  // namespace mrsim
