#include "reference/grid_mesh.h"

#include "core/process/parallel.h"
#include "mesh/solid/half_edges.h"
#include "reference/repair.h"
#include "removal/field/field.h"

#include <cmath>

#include <openvdb/tools/VolumeToMesh.h>

namespace mrsim::testing {
namespace {

// Splits quads along their shorter diagonal; VolumeToMesh runs clockwise.
void add_quads(const std::vector<openvdb::Vec4I>& quads, TriMesh& mesh) {
  const auto squared = [&](std::uint32_t a, std::uint32_t b) {
    const Vec3 d = to_vec(mesh.vertices[a]) - to_vec(mesh.vertices[b]);
    return dot(d, d);
  };
  for (const openvdb::Vec4I& p : quads)
    if (squared(p[0], p[2]) <= squared(p[1], p[3]))
      mesh.triangles.insert(mesh.triangles.end(), {{p[0], p[2], p[1]}, {p[0], p[3], p[2]}});
    else
      mesh.triangles.insert(mesh.triangles.end(), {{p[1], p[3], p[2]}, {p[1], p[0], p[3]}});
}

// Owner of the voxel with the least |d| among the eight corners of the cell that holds `at`.
std::int32_t owner_near(const openvdb::FloatGrid::ConstAccessor& distance,
                        const openvdb::Int32Grid::ConstAccessor& owners, const openvdb::Vec3d& at) {
  const openvdb::Coord cell = openvdb::Coord::floor(at);
  float least = std::numeric_limits<float>::infinity();
  std::int32_t owner = kStockOwner;
  for (int i = 0; i < 8; ++i) {
    const openvdb::Coord c = cell.offsetBy(i & 1, (i >> 1) & 1, i >> 2);
    std::int32_t value = kStockOwner;
    const float d = std::fabs(distance.getValue(c));
    if (!(d < least) || !owners.probeValue(c, value)) continue;
    least = d;
    owner = value;
  }
  return owner;
}

void add_owners(const openvdb::FloatGrid& distance, const openvdb::Int32Grid& owners, int threads,
                TriMesh& mesh) {
  constexpr std::size_t kBlock = 4096;
  mesh.owners.resize(mesh.triangles.size());
  parallel_for((mesh.triangles.size() + kBlock - 1) / kBlock, threads, [&](std::size_t block) {
    const auto d = distance.getConstAccessor();
    const auto o = owners.getConstAccessor();
    const std::size_t end = std::min(mesh.triangles.size(), (block + 1) * kBlock);
    for (std::size_t f = block * kBlock; f < end; ++f) {
      const Vec3 c = (1.0 / 3) * (corner(mesh, f, 0) + corner(mesh, f, 1) + corner(mesh, f, 2));
      mesh.owners[f] = owner_near(d, o, distance.worldToIndex(openvdb::Vec3d(c.x, c.y, c.z)));
    }
  });
}

}  // namespace

TriMesh mesh_grid(const openvdb::FloatGrid& distance, const openvdb::Int32Grid* owners,
                  int threads) {
  TriMesh mesh;
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec4I> quads;  // nothing else without adaptivity
  // Compiled in the library; its class VolumeToMesh would be compiled here, for a minute.
  with_threads(threads,
               [&] { openvdb::tools::volumeToMesh(distance, points, quads, -kInsideTolerance); });
  mesh.vertices.reserve(points.size());
  for (const openvdb::Vec3s& p : points) mesh.vertices.push_back({p[0], p[1], p[2]});
  add_quads(quads, mesh);
  if (distance.getGridClass() != openvdb::GRID_LEVEL_SET)  // taken for a fog: inside out
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  if (owners) add_owners(distance, *owners, threads, mesh);
  make_manifold(mesh);
  return mesh;
}

}  // namespace mrsim::testing
