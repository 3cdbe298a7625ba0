#include "mesh/format/mesh_builder.h"

#include "mesh/solid/half_edges.h"
#include "mesh/solid/weld.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim::detail {
namespace {

constexpr std::size_t kMostCorners = 512;  // ears take the square of it

// Bytes: a vertex with its colour, a triangle with its owner; and the half edges by which take()
// looks for borders.
constexpr std::size_t kVertexBytes = 15, kTriangleBytes = 16, kHalfEdges = 48,
                      kHalfEdgesOfVertex = 4;

using Polygon = std::vector<std::uint32_t>;

Vec3 loop_normal(const TriMesh& mesh, const Polygon& loop) {
  Vec3 sum;
  const Vec3 a = to_vec(mesh.vertices[loop[0]]);
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    sum += cross(to_vec(mesh.vertices[loop[i]]) - a, to_vec(mesh.vertices[loop[i + 1]]) - a);
  return sum;
}

// Whether the corner `i` can be cut off: it is convex and no other corner lies in it.
bool is_ear(const TriMesh& mesh, const Polygon& loop, std::size_t i, const Vec3& normal) {
  const std::size_t n = loop.size(), before = (i + n - 1) % n, after = (i + 1) % n;
  const Vec3 a = to_vec(mesh.vertices[loop[before]]), b = to_vec(mesh.vertices[loop[i]]),
             c = to_vec(mesh.vertices[loop[after]]);
  const auto side = [&](const Vec3& p, const Vec3& q, const Vec3& r) {
    return dot(cross(q - p, r - p), normal);
  };
  if (!(side(a, b, c) > 0)) return false;
  for (std::size_t k = 0; k < n; ++k) {
    if (k == before || k == i || k == after) continue;
    const Vec3 p = to_vec(mesh.vertices[loop[k]]);
    if (side(a, b, p) >= 0 && side(b, c, p) >= 0 && side(c, a, p) >= 0) return false;
  }
  return true;
}

// Cuts ears off until a triangle is left; a polygon without an ear (crossing itself, or flat) is
// cut anywhere, so that its border stays what it was.
std::vector<std::array<std::uint32_t, 3>> triangulate(const TriMesh& mesh, Polygon loop) {
  std::vector<std::array<std::uint32_t, 3>> out;
  const Vec3 normal = loop.size() > 3 ? loop_normal(mesh, loop) : Vec3{};
  bool has_ears = true;
  while (loop.size() > 3) {
    std::size_t ear = 0;
    while (has_ears && ear < loop.size() && !is_ear(mesh, loop, ear, normal)) ++ear;
    has_ears = has_ears && ear < loop.size();
    if (!has_ears) ear = 0;
    const std::size_t n = loop.size();
    out.push_back({loop[(ear + n - 1) % n], loop[ear], loop[(ear + 1) % n]});
    loop.erase(loop.begin() + std::ptrdiff_t(ear));
  }
  out.push_back({loop[0], loop[1], loop[2]});
  return out;
}

bool has_boundary(const TriMesh& mesh) {
  const std::vector<std::uint32_t> opposite = find_opposites(mesh);
  return std::any_of(opposite.begin(), opposite.end(),
                     [](std::uint32_t h) { return !is_half_edge(h); });
}

}  // namespace

std::string too_far(double coordinate) {
  return fmt::format("a coordinate of {:.3g} mm, more than {:g} mm (10 km); is the unit right?",
                     coordinate, kFarthest);
}

void MeshBuilder::expect(std::size_t vertices, std::size_t triangles) const {
  constexpr std::size_t kMostTriangles = 50'000'000;
  if (triangles > kMostTriangles - std::min<std::size_t>(kMostTriangles, mesh_.triangles.size()) ||
      vertices >
          3 * kMostTriangles - std::min<std::size_t>(3 * kMostTriangles, mesh_.vertices.size()))
    throw Error(format_ + "-too-large",
                fmt::format("{} has more than 50 million triangles, instances counted; export a "
                            "coarser mesh",
                            name_));
  // A vector that grows holds its numbers three times for a moment; the half edges come later.
  const double v = double(vertices), t = double(triangles);
  const double held =
      std::max(3 * (kVertexBytes * v + kTriangleBytes * t),
               (kVertexBytes + kHalfEdgesOfVertex) * v + (kTriangleBytes + kHalfEdges) * t);
  if (vertices + triangles > 100'000) require_memory(held, "reading " + name_);
}

void MeshBuilder::fail(const char* fault, const std::string& text) const {
  throw Error(format_ + "-" + fault, fmt::format("{}: {}; export it again", name_, text));
}

void MeshBuilder::add_vertex(double x, double y, double z) {
  const double largest = std::max({std::fabs(x), std::fabs(y), std::fabs(z)});
  if (!std::isfinite(x + y + z))
    fail("nan", fmt::format("vertex {} has a coordinate that is not a number", vertex_count() + 1));
  if (largest > kFarthest)
    fail("too-far", fmt::format("vertex {} has {}", vertex_count() + 1, too_far(largest)));
  require_growth(mesh_.vertices, kVertexBytes, name_);
  mesh_.vertices.push_back({float(x), float(y), float(z)});
}

void MeshBuilder::add_face(std::span<const std::int64_t> corners, std::int32_t owner) {
  Polygon loop;
  if (corners.size() > kMostCorners)
    fail("polygon", fmt::format("a face has {} corners, {} are too many to take apart; "
                                "triangulate the mesh before",
                                corners.size(), kMostCorners + 1));
  for (const std::int64_t corner : corners) {
    if (corner < 0 || std::uint64_t(corner) >= vertex_count())
      fail("index", fmt::format("face {} names vertex {}, there are {}", mesh_.triangles.size() + 1,
                                corner + 1, vertex_count()));
    if (loop.empty() || (loop.back() != corner)) loop.push_back(std::uint32_t(corner));
  }
  while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
  if (loop.size() < 3) return;
  has_owners_ = has_owners_ || owner >= 0;
  for (const auto& t : triangulate(mesh_, std::move(loop))) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    require_growth(mesh_.triangles, kTriangleBytes, name_);
    mesh_.triangles.push_back(t);
    mesh_.owners.push_back(owner);
  }
}

TriMesh MeshBuilder::take() {
  if (mesh_.triangles.empty()) fail("empty", "it holds no triangles");
  if (mesh_.triangles.size() > 1'000'000'000) fail("size", "it has more than 1e9 triangles");
  if (!has_owners_) mesh_.owners.clear();
  if (mesh_.colors.size() != mesh_.vertices.size()) mesh_.colors.clear();
  if (mesh_.colors.empty()) mesh_.legend.clear();
  drop_unused_vertices(mesh_);
  // Welding takes as much, once the half edges have gone.
  require_memory(
      double(kHalfEdges * mesh_.triangles.size() + kHalfEdgesOfVertex * mesh_.vertices.size()),
      "reading " + name_);
  if (has_boundary(mesh_)) mesh_ = weld(mesh_);
  if (mesh_.triangles.empty()) fail("empty", "all its triangles are without area");
  return std::move(mesh_);
}

}  // namespace mrsim::detail
