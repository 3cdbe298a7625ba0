#include "removal/vdb/vdb_grid.h"

#include "core/parallel.h"

#include <vector>

#include <openvdb/io/Stream.h>

namespace mrsim {

// The leaves of the two trees lie side by side in memory and are freed so, in long stretches: a
// third of the time of one tree after the other.
VdbGrid::~VdbGrid() {
  std::vector<openvdb::FloatTree::LeafNodeType*> distances;
  std::vector<openvdb::Int32Tree::LeafNodeType*> owners;  // of the same places
  parallel_for(2, threads, [&](std::size_t tree) {
    if (tree == 0)
      distance->tree().stealNodes(distances);
    else
      owner->tree().stealNodes(owners);
  });
  const auto parts = static_cast<std::size_t>(resolve_threads(threads));
  parallel_for(parts, threads, [&](std::size_t part) {
    const std::size_t leaves = distances.size();
    for (std::size_t k = leaves * part / parts; k < leaves * (part + 1) / parts; ++k)
      delete distances[k], delete owners[k];
  });
}

std::size_t VdbGrid::memory() const { return distance->memUsage() + owner->memUsage(); }

void VdbGrid::write(std::ostream& out) const {
  openvdb::io::Stream archive(out);
  archive.setCompression(openvdb::io::COMPRESS_ZIP | openvdb::io::COMPRESS_ACTIVE_MASK);
  archive.write(openvdb::GridCPtrVec{distance, owner});
}

}  // namespace mrsim
