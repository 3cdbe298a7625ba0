#include "mesh/draw/lying.h"

#include "mesh/solid/half_edges.h"

#include <cmath>

namespace mrsim {
namespace {

constexpr double kAlong = 0.999;      // cosine: a face along Z says nothing
constexpr double kRadial = 0.1;       // sine: what a coarse mesh of a round wall is off
constexpr double kTurned = 0.9;       // share of the walls
constexpr double kLeastWalls = 0.02;  // share of the area

}  // namespace

bool is_turned(const TriMesh& mesh) {
  double all = 0, walls = 0, turned = 0;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const Vec3 n = area_normal(mesh, f);
    const double area = length(n);
    all += area;
    if (std::abs(n.z) >= kAlong * area) continue;
    Vec3 middle;
    for (const std::uint32_t v : mesh.triangles[f])
      middle = middle + (1.0 / 3) * to_vec(mesh.vertices[v]);
    const double radius = std::sqrt(middle.x * middle.x + middle.y * middle.y);
    walls += area;
    if (std::abs(n.x * middle.y - n.y * middle.x) <= kRadial * area * radius) turned += area;
  }
  return walls > kLeastWalls * all && turned >= kTurned * walls;
}

TriMesh laid_down(TriMesh mesh) {
  for (auto& [x, y, z] : mesh.vertices) {
    const float left = x;
    x = z, y = -y, z = left;
  }
  return mesh;
}

}  // namespace mrsim
