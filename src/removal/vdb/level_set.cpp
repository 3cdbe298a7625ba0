#include "removal/vdb/level_set.h"

#include "core/process/error.h"
#include "core/process/parallel.h"
#include "removal/vdb/grid_surface.h"
#include "removal/vdb/voxel_hash.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <openvdb/io/File.h>

namespace mrsim {
namespace {

Error unreadable(const std::string& why) { return {"vdb-unreadable", why}; }

// The level set, else the only grid of floats.
std::string grid_name(const openvdb::GridPtrVec& heads) {
  std::vector<std::string> level_sets, floats;
  for (const openvdb::GridBase::Ptr& head : heads) {
    if (!head || !head->isType<openvdb::FloatGrid>()) continue;
    floats.push_back(head->getName());
    if (head->getGridClass() == openvdb::GRID_LEVEL_SET) level_sets.push_back(head->getName());
  }
  const std::vector<std::string>& fit = level_sets.empty() ? floats : level_sets;
  if (fit.empty()) throw unreadable("it holds no level set of 32-bit floats");
  if (level_sets.empty() && fit.size() > 1)
    throw unreadable(
        fmt::format("it holds {} grids, and none is marked as a level set", floats.size()));
  if (fit.size() > 1)
    throw unreadable(
        fmt::format("it holds {} level sets ({}), and which is meant is not known: "
                    "give a file with one",
                    fit.size(), fmt::join(fit, ", ")));
  return fit[0];
}

LevelSetSurface read(const std::string& path) {
  openvdb::initialize();
  openvdb::io::File file(path);
  file.open(/*delayLoad=*/false);
  const std::string name = grid_name(*file.readAllGridMetadata());
  const auto grid = openvdb::gridPtrCast<openvdb::FloatGrid>(file.readGrid(name));
  if (!grid) throw unreadable("its grid " + name + " is none of 32-bit floats");
  LevelSetSurface found;
  found.grid = name;
  const openvdb::Vec3d size = grid->voxelSize();
  found.voxel = std::max({size.x(), size.y(), size.z()});
  found.hash = voxel_hash(*grid);
  found.surface = surface_of(*grid);
  if (found.surface.triangles.empty())
    throw unreadable("its grid " + name + " is nowhere zero: it has no surface");
  return found;
}

}  // namespace

// Where voxels are zero but for rounding, VolumeToMesh draws sheets some 1e-27 mm thin, in which no
// point is certainly inside or outside. Vertices that agree within a millionth of a voxel are one.
LevelSetSurface read_level_set(const std::string& path) {
  LevelSetSurface found;
  with_threads(1, [&] {
    try {
      found = read(path);
    } catch (const openvdb::Exception& error) {
      throw unreadable(error.what());
    }
  });
  return found;
}

}  // namespace mrsim
