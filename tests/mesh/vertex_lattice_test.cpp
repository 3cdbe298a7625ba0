// Coordinates of vertices: what holds of them for two cells that share a face.
#include "mesh/solid/vertex_lattice.h"

#include <random>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace detail;

// A tile of equal cells leaves the vertex of such a face out without a look; an octree over it has
// to come to the same, wherever in their cells the two vertices lie.
TEST(VertexLattice, LinesBetweenEqualCellsPassInsideTheirFace) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  for (int round = 0; round < 200000; ++round) {
    const double voxel = 0.02 + share(random), reach = round % 2 == 0 ? 150 : 5000;
    const auto origin = [&] { return reach * (2 * share(random) - 1); };
    const Vec3 first{origin(), origin(), origin()};
    const Lattice lattice({first, first + Vec3{voxel, voxel, voxel}}, voxel, 2);
    const std::int32_t unit = lattice.per_voxel();
    const int axis = round % 3;
    LatticePoint at{unit, unit, unit}, end{2 * unit, 2 * unit, 2 * unit};
    const Box3 low{lattice.position(at), lattice.position(end)};
    component(at, axis) += unit, component(end, axis) += unit;
    const Box3 high{lattice.position(at), lattice.position(end)};
    const auto place = [&](const Box3& cell) {
      const Box3 room = inner(cell);
      const auto one = [&](double a, double b) {
        const double x = share(random);
        return x < 0.3 ? a : x < 0.6 ? b : snap_between(a + x * (b - a), a, b);
      };
      return Vec3{one(room.lo.x, room.hi.x), one(room.lo.y, room.hi.y), one(room.lo.z, room.hi.z)};
    };
    Box3 face = high;
    mrsim::component(face.hi, axis) = mrsim::component(face.lo, axis);
    ASSERT_TRUE(passes_inside(face, axis, place(low), place(high))) << "round " << round;
  }
}

}  // namespace
}  // namespace mrsim
