#include "removal/vdb/small_grid.h"

#include "removal/vdb/grid_surface.h"

#include <openvdb/tools/LevelSetUtil.h>
#include <openvdb/tools/SignedFloodFill.h>

namespace mrsim {
namespace {

// The same level set in a small grid, whose class tells volumeToMesh on which side the solid is.
SmallGrid::Ptr in_small_nodes(const openvdb::FloatGrid& grid) {
  SmallGrid::Ptr out = SmallGrid::create(grid.background());
  out->setTransform(grid.transform().copy());
  out->setGridClass(grid.getGridClass());
  for (auto leaf = grid.tree().cbeginLeaf(); leaf; ++leaf)
    out->tree().addLeaf(new SmallGrid::TreeType::LeafNodeType(*leaf));
  openvdb::tools::signedFloodFill(out->tree());
  return out;
}

}  // namespace

std::vector<SmallGrid::Ptr> pieces_of(const openvdb::FloatGrid& grid) {
  std::vector<SmallGrid::Ptr> pieces;
  openvdb::tools::segmentSDF(*in_small_nodes(grid), pieces);
  return pieces;
}

TriMesh surface_of(const SmallGrid& piece) { return surface_of<SmallGrid>(piece); }

}  // namespace mrsim
