#include "removal/vdb/rest.h"

#include "core/parallel.h"
#include "core/vec.h"
#include "removal/vdb/level_set.h"
#include "removal/vdb/reach.h"

#include <algorithm>
#include <cstddef>

#include <openvdb/openvdb.h>
#include <openvdb/tools/Composite.h>
#include <openvdb/tools/LevelSetUtil.h>
#include <openvdb/tools/MeshToVolume.h>

namespace mrsim {
namespace {

constexpr float kBand = 4;           // voxels on both sides of a surface
constexpr double kLargestTool = 64;  // mm
constexpr std::size_t kPlaces = 48;  // of a piece, at which tools are tried
constexpr double kNear = 2;          // voxels from the nominal: where the tool must come to

openvdb::FloatGrid::Ptr level_set_of(const TriMesh& mesh, double voxel) {
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec3I> triangles;
  for (const auto& v : mesh.vertices) points.emplace_back(v[0], v[1], v[2]);
  for (const auto& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  const auto transform = openvdb::math::Transform::createLinearTransform(voxel);
  return openvdb::tools::meshToLevelSet<openvdb::FloatGrid>(*transform, points, triangles, kBand);
}

// The solid grown by `by`, which is less than its band.
openvdb::FloatGrid::Ptr grown(const openvdb::FloatGrid& solid, double by) {
  openvdb::FloatGrid::Ptr out = solid.deepCopy();
  for (auto it = out->beginValueOn(); it; ++it) it.setValue(*it - float(by));
  return out;
}

// Middles of voxels of the piece close above the nominal, evenly chosen.
std::vector<Vec3> places_of(const openvdb::FloatGrid& piece, const openvdb::FloatGrid& nominal) {
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

void find_tools(const openvdb::FloatGrid& piece, const openvdb::FloatGrid& nominal,
                RestVoxels& out) {
  const std::vector<Vec3> places = places_of(piece, nominal);
  const Reach ball = largest_ball(nominal, places, kLargestTool);
  const Reach flat = largest_cylinder(nominal, places, kLargestTool);
  out.ball = ball.diameter;
  out.flat = flat.diameter;
  out.error = std::max(ball.error, flat.error);
  out.ball_is_least = ball.is_least;
  out.flat_is_least = flat.is_least;
}

}  // namespace

std::vector<RestVoxels> find_rest_voxels(const RestTask& task) {
  openvdb::initialize();
  std::vector<RestVoxels> out;
  with_threads(task.threads, [&] {
    const auto part = level_set_of(task.part, task.voxel);
    const auto nominal = level_set_of(task.nominal, task.voxel);
    const auto rest = openvdb::tools::csgDifferenceCopy(*part, *grown(*nominal, task.above));
    std::vector<openvdb::FloatGrid::Ptr> pieces;
    openvdb::tools::segmentSDF(*rest, pieces);
    out.resize(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) out[i].surface = surface_of(*pieces[i]);
    parallel_for(std::min(pieces.size(), task.searched), task.threads,
                 [&](std::size_t i) { find_tools(*pieces[i], *nominal, out[i]); });
  });
  return out;
}

}  // namespace mrsim
