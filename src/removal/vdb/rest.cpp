#include "removal/vdb/rest.h"

#include "core/numbers/vec.h"
#include "core/process/parallel.h"
#include "removal/vdb/grids.h"
#include "removal/vdb/small_grid.h"

#include <algorithm>
#include <cstddef>

#include <openvdb/tools/Composite.h>
#include <openvdb/tools/MeshToVolume.h>

namespace mrsim {
namespace {

using openvdb::FloatGrid;

constexpr float kBand = 4;            // voxels on both sides of a surface
constexpr std::size_t kPlaces = 256;  // of a piece
constexpr double kNear = 2;           // voxels from the nominal

FloatGrid::Ptr voxels_of(const TriMesh& mesh, double voxel) {
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec3I> triangles;
  for (const auto& v : mesh.vertices) points.emplace_back(v[0], v[1], v[2]);
  for (const auto& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  const auto transform = openvdb::math::Transform::createLinearTransform(voxel);
  return openvdb::tools::meshToLevelSet<FloatGrid>(*transform, points, triangles, kBand);
}

// The solid grown by `by`, which is less than its band.
FloatGrid::Ptr grown(const FloatGrid& solid, double by) {
  FloatGrid::Ptr out = solid.deepCopy();
  for (auto it = out->beginValueOn(); it; ++it) it.setValue(*it - float(by));
  return out;
}

// Middles of voxels of the piece close above the nominal, evenly chosen.
std::vector<Vec3> places_of(const SmallGrid& piece, const FloatGrid& nominal) {
  const double near = kNear * nominal.voxelSize().x();
  std::vector<Vec3> all, out;
  auto at = nominal.getConstAccessor();
  for (auto it = piece.cbeginValueOn(); it; ++it) {
    if (!it.isVoxelValue() || *it > 0 || at.getValue(it.getCoord()) > near) continue;
    const openvdb::Vec3d p = piece.indexToWorld(it.getCoord());
    all.push_back({p.x(), p.y(), p.z()});
  }
  const std::size_t count = std::min(kPlaces, all.size());
  for (std::size_t i = 0; i < count; ++i) out.push_back(all[i * all.size() / count]);
  return out;
}

}  // namespace

std::vector<RestVoxels> find_rest_voxels(const RestTask& task) {
  openvdb::initialize();
  std::vector<RestVoxels> out;
  with_threads(task.threads, [&] {
    const auto part = voxels_of(task.part, task.voxel);
    const auto nominal = voxels_of(task.nominal, task.voxel);
    const auto rest = openvdb::tools::csgDifferenceCopy(*part, *grown(*nominal, task.above));
    const std::vector<SmallGrid::Ptr> pieces = pieces_of(*rest);
    out.resize(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i)
      out[i] = {surface_of(*pieces[i]), places_of(*pieces[i], *nominal)};
  });
  return out;
}

}  // namespace mrsim
