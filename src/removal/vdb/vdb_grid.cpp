#include "removal/vdb/vdb_grid.h"

#include "core/parallel.h"

#include <openvdb/io/Stream.h>

namespace mrsim {

// The leaves of the two trees lie side by side in memory. They are freed so, in long stretches, and
// each half by one thread, as they were made: a third of the time of one tree after the other.
VdbGrid::~VdbGrid() {
  std::vector<FloatLeaf*> distances;
  std::vector<OwnerLeaf*> owners;
  parallel_for(2, threads, [&](std::size_t tree) {
    if (tree == 0)
      distance->tree().stealNodes(distances);
    else
      owner->tree().stealNodes(owners);
  });
  const auto parts = static_cast<std::size_t>(resolve_threads(threads));
  parallel_for(parts, threads, [&](std::size_t part) {
    for (std::size_t k = leaves.size() * part / parts; k < leaves.size() * (part + 1) / parts; ++k)
      delete leaves[k].first, delete leaves[k].second;
  });
}

std::size_t VdbGrid::memory() const { return distance->memUsage() + owner->memUsage(); }

void VdbGrid::write(std::ostream& out) const {
  openvdb::io::Stream archive(out);
  archive.setCompression(openvdb::io::COMPRESS_ZIP | openvdb::io::COMPRESS_ACTIVE_MASK);
  archive.write(openvdb::GridCPtrVec{distance, owner});
}

}  // namespace mrsim
