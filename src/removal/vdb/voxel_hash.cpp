#include "removal/vdb/voxel_hash.h"

#include "core/numbers/hash.h"

#include <cstdint>

namespace mrsim {
namespace {

template <class T>
void update(ContentHash& hash, const T& value) {
  hash.update(&value, sizeof value);
}

}  // namespace

std::string voxel_hash(const openvdb::FloatGrid& grid) {
  ContentHash hash;
  const openvdb::Vec3d size = grid.voxelSize();
  for (int axis = 0; axis < 3; ++axis) update(hash, size[axis]);
  for (auto leaf = grid.tree().cbeginLeaf(); leaf; ++leaf) {
    const openvdb::Coord origin = leaf->origin();
    for (int axis = 0; axis < 3; ++axis) update(hash, static_cast<std::int32_t>(origin[axis]));
    for (auto voxel = leaf->cbeginValueOn(); voxel; ++voxel) {
      update(hash, static_cast<std::int32_t>(voxel.pos()));
      update(hash, voxel.getValue());
    }
  }
  return hash.uuid();
}

}  // namespace mrsim
