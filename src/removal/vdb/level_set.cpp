#include "removal/vdb/level_set.h"

#include "core/numbers/hash.h"
#include "core/process/error.h"
#include "core/process/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <openvdb/io/File.h>
#include <openvdb/tools/VolumeToMesh.h>

namespace mrsim {
namespace {

constexpr double kFinest = 1.0 / (1 << 20);  // of a voxel: the resolution of 32-bit floats

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

template <class T>
void update(ContentHash& hash, const T& value) {
  hash.update(&value, sizeof value);
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
TriMesh joined_surface(const std::vector<openvdb::Vec3s>& points,
                       const std::vector<openvdb::Vec3I>& triangles,
                       const std::vector<openvdb::Vec4I>& quads, double voxel) {
  const double step = kFinest * voxel;
  TriMesh mesh;
  std::map<std::array<float, 3>, std::uint32_t> known;
  std::vector<std::uint32_t> vertex_of;
  for (const openvdb::Vec3s& p : points) {
    const auto snapped = [&](float x) { return static_cast<float>(step * std::round(x / step)); };
    const std::array<float, 3> v{snapped(p.x()), snapped(p.y()), snapped(p.z())};
    const auto [at, is_new] = known.emplace(v, static_cast<std::uint32_t>(mesh.vertices.size()));
    if (is_new) mesh.vertices.push_back(v);
    vertex_of.push_back(at->second);
  }
  // OpenVDB's triangles run clockwise.
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const std::array<std::uint32_t, 3> t{vertex_of[c], vertex_of[b], vertex_of[a]};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh.triangles.push_back(t);
  };
  for (const openvdb::Vec3I& t : triangles) add(t[0], t[1], t[2]);
  for (const openvdb::Vec4I& q : quads) add(q[0], q[1], q[2]), add(q[0], q[2], q[3]);
  return mesh;
}

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
