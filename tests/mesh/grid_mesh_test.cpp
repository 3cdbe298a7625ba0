#include "reference/grid_mesh.h"

#include "support/mesh_asserts.h"
#include "support/random.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>
#include <openvdb/tools/SignedFloodFill.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

using Distance = std::function<double(const openvdb::Vec3d&)>;

struct Grids {
  openvdb::FloatGrid::Ptr distance;
  openvdb::Int32Grid::Ptr owners;
};

// Samples a solid within [-extent, extent]^3 voxels; owner 0 above z = 0, 1 below.
Grids sample(const Distance& d, double voxel, int extent) {
  openvdb::initialize();
  const float band = float(3 * voxel);
  Grids g{openvdb::FloatGrid::create(band), openvdb::Int32Grid::create(-1)};
  const auto transform = openvdb::math::Transform::createLinearTransform(voxel);
  transform->postTranslate(openvdb::Vec3d(0.013, 0.029, 0.041) * voxel);
  g.distance->setTransform(transform);
  g.distance->setGridClass(openvdb::GRID_LEVEL_SET);
  g.owners->setTransform(transform);
  auto values = g.distance->getAccessor();
  auto owners = g.owners->getAccessor();
  for (int x = -extent; x <= extent; ++x)
    for (int y = -extent; y <= extent; ++y)
      for (int z = -extent; z <= extent; ++z) {
        const openvdb::Coord c(x, y, z);
        const openvdb::Vec3d p = transform->indexToWorld(c);
        const float value = float(d(p));
        if (std::fabs(value) >= band) continue;
        values.setValue(c, value);
        owners.setValue(c, p.z() > 0 ? 0 : 1);
      }
  openvdb::tools::signedFloodFill(g.distance->tree());
  return g;
}

double sphere(const openvdb::Vec3d& p) { return p.length() - 5; }

double box(const openvdb::Vec3d& p) {
  const openvdb::Vec3d q(std::fabs(p.x()) - 4, std::fabs(p.y()) - 3, std::fabs(p.z()) - 2);
  return std::max({q.x(), q.y(), q.z()});
}

TEST(MeshGrid, SphereIsClosedAndRound) {
  for (const double voxel : {0.5, 0.25}) {
    const Grids g = sample(sphere, voxel, int(7 / voxel));
    const TriMesh m = mesh_grid(*g.distance, g.owners.get());
    testing::expect_closed_manifold(m);
    EXPECT_NEAR(check_mesh(m).volume, 523.5988, 0.05 * voxel * voxel * 523.6);
    EXPECT_EQ(check_mesh(m).euler, 2);
    for (std::size_t f = 0; f < m.triangles.size(); ++f) {
      double z = 0;
      for (const std::uint32_t v : m.triangles[f]) z += m.vertices[v][2] / 3.0;
      if (std::fabs(z) > voxel) {
        EXPECT_EQ(m.owners[f], z > 0 ? 0 : 1);
      }
    }
  }
}

TEST(MeshGrid, BoxKeepsItsVolume) {
  const Grids g = sample(box, 0.2, 25);
  const TriMesh m = mesh_grid(*g.distance, nullptr);
  testing::expect_closed_manifold(m);
  EXPECT_TRUE(m.owners.empty());
  EXPECT_NEAR(check_mesh(m).volume, 8 * 6 * 4, 1.5);
}

TEST(MeshGrid, IsTheSameForAnyNumberOfThreads) {
  const Grids g = sample(sphere, 0.2, 30);
  const TriMesh a = mesh_grid(*g.distance, g.owners.get(), 1);
  for (const int threads : {2, 5}) {
    const TriMesh b = mesh_grid(*g.distance, g.owners.get(), threads);
    EXPECT_EQ(a.vertices, b.vertices);
    EXPECT_EQ(a.triangles, b.triangles);
    EXPECT_EQ(a.owners, b.owners);
  }
}

TEST(MeshGrid, NoiseOfAnyTopologyBecomesAManifold) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(testing::salted(seed));
    const Distance noise = [&](const openvdb::Vec3d& p) {
      const double inside = double(random() % 1000) / 1000 - 0.4 - 0.01 * seed;
      return p.length() > 11 ? 1.0 : inside;
    };
    const Grids g = sample(noise, 1, 14);
    const TriMesh m = mesh_grid(*g.distance, g.owners.get());
    ASSERT_GT(m.triangles.size(), 1000u);
    testing::expect_closed_manifold(m);
  }
}

TEST(MeshGrid, NothingInsideIsEmpty) {
  const Grids g = sample([](const openvdb::Vec3d&) { return 1.0; }, 1, 4);
  EXPECT_TRUE(mesh_grid(*g.distance, g.owners.get()).triangles.empty());
}

}  // namespace
}  // namespace mrsim
