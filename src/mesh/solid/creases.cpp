#include "mesh/solid/creases.h"

#include "core/numbers/trig.h"
#include "core/process/parallel.h"
#include "mesh/solid/check.h"
#include "mesh/solid/half_edges.h"

#include <cmath>

namespace mrsim {
namespace {

constexpr std::size_t kEdgesAThread = 4096;
constexpr double kSliverHeight = 1e-4;  // height of a sliver, of the part's diagonal
constexpr int kSliverPasses = 16;
constexpr float kUnset = 9;  // in place of a unit vector

double angle_at(const TriMesh& mesh, std::uint32_t h) {
  const Vec3 p = to_vec(mesh.vertices[origin_of(mesh, h)]);
  const Vec3 a = to_vec(mesh.vertices[target_of(mesh, h)]) - p;
  const Vec3 b = to_vec(mesh.vertices[origin_of(mesh, previous_half_edge(h))]) - p;
  return mrsim::atan2(length(cross(a, b)), dot(a, b));
}

class Sectors {
 public:
  Sectors(const TriMesh& mesh, const SurfaceShape& shape, double cosine)
      : mesh_(mesh), shape_(shape), cosine_(cosine) {}

  bool is_smooth(std::uint32_t h) const {
    const std::uint32_t o = shape_.opposite[h];
    return is_half_edge(o) &&
           dot(shape_.face_normals[h / 3], shape_.face_normals[o / 3]) >= cosine_;
  }

  // Normals of all corners of the sector that `h` begins or lies in, turning one way.
  Vec3 sum_from(std::uint32_t start, std::vector<std::uint32_t>& members) const {
    Vec3 sum;
    std::uint32_t h = start;
    do {
      members.push_back(h);
      sum += angle_at(mesh_, h) * shape_.face_normals[h / 3];
      const std::uint32_t in = previous_half_edge(h);
      if (!is_smooth(in)) break;
      h = shape_.opposite[in];
    } while (h != start);
    return sum;
  }

 private:
  const TriMesh& mesh_;
  const SurfaceShape& shape_;
  double cosine_;
};

double altitude(const TriMesh& mesh, std::size_t f, int& longest_side) {
  double longest = 0;
  for (int k = 0; k < 3; ++k) {
    const double side = distance(corner(mesh, f, k), corner(mesh, f, (k + 1) % 3));
    if (side <= longest) continue;
    longest = side;
    longest_side = k;
  }
  return longest > 0 ? length(area_normal(mesh, f)) / longest : 0;
}

// The normal of a sliver is rounding noise. It takes the normal of its neighbour across its longest
// side; otherwise it would be shaded, and its sides drawn, as an edge of the part.
void straighten_slivers(const TriMesh& mesh, SurfaceShape& shape) {
  const Box3 box = mesh_bounds(mesh);
  const double thin = kSliverHeight * length(box.hi - box.lo);
  std::vector<std::uint32_t> slivers, left;  // by their longest sides
  std::vector<bool> is_open(mesh.triangles.size(), false);
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    int side = 0;
    if (altitude(mesh, f, side) >= thin) continue;
    slivers.push_back(3 * f + std::uint32_t(side));
    is_open[f] = true;
  }
  for (int pass = 0; pass < kSliverPasses && !slivers.empty(); ++pass) {
    left.clear();
    std::vector<std::uint32_t> done;
    for (const std::uint32_t h : slivers) {
      const std::uint32_t o = shape.opposite[h];
      const bool known = is_half_edge(o) && !is_open[o / 3];
      (known ? done : left).push_back(h);
      if (known) shape.face_normals[h / 3] = shape.face_normals[o / 3];
    }
    for (const std::uint32_t h : done) is_open[h / 3] = false;
    if (done.empty()) return;
    slivers.swap(left);
  }
}

// If the mean normal points away from the face, use the face's own normal.
void set_normals(const std::vector<std::uint32_t>& members, const Vec3& sum, SurfaceShape& shape) {
  const Vec3 mean = normalized(sum);
  for (const std::uint32_t h : members) {
    const Vec3& face = shape.face_normals[h / 3];
    const Vec3& n = dot(mean, face) > 0.4 ? mean : face;
    shape.normals[h] = {float(n.x), float(n.y), float(n.z)};
  }
}

void smooth_vertex(const VertexFans& fans, std::size_t v, const Sectors& sectors,
                   std::vector<std::uint32_t>& members, SurfaceShape& shape) {
  // Sectors begin behind creases; a vertex without one is a single sector, whatever its start. A
  // corner is done when it has a normal.
  const auto done = [&](std::uint32_t h) { return shape.normals[h][0] != kUnset; };
  for (const bool creases_only : {true, false})
    for (std::uint32_t i = fans.begin[v]; i < fans.begin[v + 1]; ++i) {
      const std::uint32_t h = fans.items[i];
      if (done(h) || (creases_only && sectors.is_smooth(h))) continue;
      members.clear();
      const Vec3 sum = sectors.sum_from(h, members);
      set_normals(members, sum, shape);
    }
}

}  // namespace

SurfaceShape find_surface_shape(const TriMesh& mesh, double degrees, int threads) {
  SurfaceShape shape;
  shape.opposite = find_opposites(mesh, threads);
  shape.face_normals.resize(mesh.triangles.size());
  parallel_for(
      mesh.triangles.size(), threads,
      [&](std::size_t f) { shape.face_normals[f] = normalized(area_normal(mesh, f)); },
      kEdgesAThread);
  straighten_slivers(mesh, shape);
  shape.normals.assign(3 * mesh.triangles.size(), {kUnset, 0, 0});
  const Sectors sectors(mesh, shape, sincos_deg(degrees).cos);
  const VertexFans fans = half_edges_by_vertex(mesh);
  const std::size_t blocks = (mesh.vertices.size() + kEdgesAThread - 1) / kEdgesAThread;
  parallel_for(blocks, threads, [&](std::size_t b) {
    std::vector<std::uint32_t> members;
    const std::size_t end = std::min(mesh.vertices.size(), (b + 1) * kEdgesAThread);
    for (std::size_t v = b * kEdgesAThread; v < end; ++v)
      smooth_vertex(fans, v, sectors, members, shape);
  });
  for (std::uint32_t h = 0; h < shape.opposite.size(); ++h) {
    if (is_half_edge(shape.opposite[h]) && shape.opposite[h] < h) continue;
    (sectors.is_smooth(h) ? shape.smooth_edges : shape.creases).push_back(h);
  }
  return shape;
}

}  // namespace mrsim
