#include "removal/vdb/rest.h"

#include "core/numbers/vec.h"
#include "core/process/parallel.h"
#include "removal/vdb/level_set.h"

#include <algorithm>
#include <cstddef>

#include <openvdb/openvdb.h>
#include <openvdb/tools/Composite.h>
#include <openvdb/tools/LevelSetUtil.h>
#include <openvdb/tools/MeshToVolume.h>

namespace mrsim {
namespace {

// Each piece has a tree of its own for a while. OpenVDB's usual one takes 300 kB where it holds a
// single voxel, and there may be ten thousand pieces; in this one the nodes above the leaves are
// small.
using Grid = openvdb::Grid<openvdb::tree::Tree3<float, 3, 3>::Type>;

constexpr float kBand = 4;            // voxels on both sides of a surface
constexpr std::size_t kPlaces = 256;  // of a piece
constexpr double kNear = 2;           // voxels from the nominal

Grid::Ptr voxels_of(const TriMesh& mesh, double voxel) {
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec3I> triangles;
  for (const auto& v : mesh.vertices) points.emplace_back(v[0], v[1], v[2]);
  for (const auto& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  const auto transform = openvdb::math::Transform::createLinearTransform(voxel);
  return openvdb::tools::meshToLevelSet<Grid>(*transform, points, triangles, kBand);
}

// The solid grown by `by`, which is less than its band.
Grid::Ptr grown(const Grid& solid, double by) {
  Grid::Ptr out = solid.deepCopy();
  for (auto it = out->beginValueOn(); it; ++it) it.setValue(*it - float(by));
  return out;
}

// Middles of voxels of the piece close above the nominal, evenly chosen.
std::vector<Vec3> places_of(const Grid& piece, const Grid& nominal) {
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
    std::vector<Grid::Ptr> pieces;
    openvdb::tools::segmentSDF(*rest, pieces);
    out.resize(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i)
      out[i] = {surface_of(*pieces[i]), places_of(*pieces[i], *nominal)};
  });
  return out;
}

}  // namespace mrsim
