#include "removal/vdb/vdb_grid.h"

#include <openvdb/io/Stream.h>

namespace mrsim {

std::size_t VdbGrid::memory() const { return distance->memUsage() + owner->memUsage(); }

void VdbGrid::write(std::ostream& out) const {
  openvdb::io::Stream archive(out);
  archive.setCompression(openvdb::io::COMPRESS_ZIP | openvdb::io::COMPRESS_ACTIVE_MASK);
  archive.write(openvdb::GridCPtrVec{distance, owner});
}

}  // namespace mrsim
