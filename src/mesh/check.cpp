#include "mesh/check.h"

#include "core/parallel.h"
#include "mesh/half_edges.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::size_t kBlock = 8192;  // fixed, so that sums do not depend on the threads
constexpr std::uint32_t kNone = ~0u;

struct EdgeFaults {
  std::size_t open = 0, twisted = 0, crowded = 0;
  std::uint32_t first = kNone;  // half edge
};

struct VertexFaults {
  std::size_t count = 0;
  std::uint32_t first = kNone;  // vertex
};

struct Sums {
  double volume = 0, area = 0;
  std::size_t degenerate = 0;
  std::uint32_t first_degenerate = kNone;
};

std::string place(const Vec3& p) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g}) mm", p.x + 0.0, p.y + 0.0, p.z + 0.0);
}

std::string plural(std::size_t n, const char* what) {
  return fmt::format("{} {}{} in all", n, what, n == 1 ? "" : "s");
}

// What would make every other question undefined.
std::string invalid_content(const TriMesh& mesh) {
  if (mesh.triangles.empty()) return "the mesh has no triangles";
  if (mesh.triangles.size() > 1'400'000'000) return "the mesh has more than 1.4e9 triangles";
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
    for (const std::uint32_t v : mesh.triangles[f])
      if (v >= mesh.vertices.size())
        return fmt::format("triangle {} names vertex {}, there are {}", f + 1, std::uint64_t(v) + 1,
                           mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    for (const float x : mesh.vertices[v])
      if (!std::isfinite(x))
        return fmt::format("vertex {} has a coordinate that is not a number", v + 1);
  return {};
}

EdgeFaults count_edge_faults(const std::vector<std::uint32_t>& opposite) {
  EdgeFaults faults;
  for (std::uint32_t h = 0; h < opposite.size(); ++h) {
    if (is_half_edge(opposite[h])) continue;
    faults.first = std::min(faults.first, h);
    ++(opposite[h] == kOpenEdge      ? faults.open
       : opposite[h] == kTwistedEdge ? faults.twisted
                                     : faults.crowded);
  }
  return faults;
}

// Number of triangles met when turning about the origin of half edge `start`, up to an open or
// faulty edge.
std::uint32_t fan_size(const std::vector<std::uint32_t>& opposite, std::uint32_t start) {
  std::uint32_t size = 0, h = start;
  do {
    ++size;
    h = opposite[previous_half_edge(h)];
  } while (is_half_edge(h) && h != start);
  return size;
}

// A vertex is a disc or a half disc when one turn meets all of its triangles. Edges with faults
// have been told of already; at an open one the turn begins at the border.
bool is_single_fan(const VertexFans& fans, const std::vector<std::uint32_t>& opposite,
                   std::size_t v) {
  const std::uint32_t begin = fans.begin[v], end = fans.begin[v + 1];
  if (begin == end) return true;
  std::uint32_t start = fans.items[begin];
  for (std::uint32_t i = begin; i < end; ++i)
    if (!is_half_edge(opposite[fans.items[i]])) start = fans.items[i];
  return fan_size(opposite, start) == end - begin;
}

VertexFaults count_vertex_faults(const TriMesh& mesh, const std::vector<std::uint32_t>& opposite,
                                 int threads) {
  const VertexFans fans = half_edges_by_vertex(mesh);
  const std::size_t blocks = (mesh.vertices.size() + kBlock - 1) / kBlock;
  std::vector<VertexFaults> parts(blocks);
  parallel_for(blocks, threads, [&](std::size_t b) {
    const std::size_t end = std::min(mesh.vertices.size(), (b + 1) * kBlock);
    for (std::size_t v = b * kBlock; v < end; ++v) {
      if (is_single_fan(fans, opposite, v)) continue;
      ++parts[b].count;
      parts[b].first = std::min(parts[b].first, std::uint32_t(v));
    }
  });
  VertexFaults all;
  for (const VertexFaults& part : parts) {
    all.count += part.count;
    all.first = std::min(all.first, part.first);
  }
  return all;
}

Box3 bounds_of(const TriMesh& mesh) {
  Box3 box;
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t) extend(box, to_vec(mesh.vertices[v]));
  return box;
}

Sums sum_block(const TriMesh& mesh, const Vec3& center, std::size_t begin, std::size_t end) {
  Sums sums;
  for (std::size_t f = begin; f < end; ++f) {
    const Vec3 a = corner(mesh, f, 0) - center, b = corner(mesh, f, 1) - center,
               c = corner(mesh, f, 2) - center;
    const Vec3 n = cross(b - a, c - a);
    const double twice_area = length(n);
    sums.volume += dot(a, n);
    sums.area += twice_area;
    const double longest = std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)});
    // Coordinates are floats, so the cross product of a true sliver is far above rounding.
    if (twice_area > 1e-14 * longest) continue;
    ++sums.degenerate;
    sums.first_degenerate = std::min(sums.first_degenerate, std::uint32_t(f));
  }
  return sums;
}

Sums sum_all(const TriMesh& mesh, const Box3& box, int threads) {
  const Vec3 center = 0.5 * (box.lo + box.hi);
  const std::size_t blocks = (mesh.triangles.size() + kBlock - 1) / kBlock;
  std::vector<Sums> parts(blocks);
  parallel_for(blocks, threads, [&](std::size_t b) {
    parts[b] =
        sum_block(mesh, center, b * kBlock, std::min(mesh.triangles.size(), (b + 1) * kBlock));
  });
  Sums all;
  for (const Sums& part : parts) {
    all.volume += part.volume / 6;
    all.area += part.area / 2;
    all.degenerate += part.degenerate;
    all.first_degenerate = std::min(all.first_degenerate, part.first_degenerate);
  }
  return all;
}

long euler_characteristic(const TriMesh& mesh, const EdgeFaults& faults) {
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t) used[v] = true;
  const long vertices = long(std::count(used.begin(), used.end(), true));
  const long faces = long(mesh.triangles.size());
  // Half edges pair up but for the open ones; crowded edges are counted as if they did.
  return vertices - (3 * faces + long(faults.open)) / 2 + faces;
}

std::string edge_fault_text(const TriMesh& mesh, const std::vector<std::uint32_t>& opposite,
                            const EdgeFaults& faults) {
  const std::uint32_t h = faults.first;
  const Vec3 middle =
      0.5 * (to_vec(mesh.vertices[origin_of(mesh, h)]) + to_vec(mesh.vertices[target_of(mesh, h)]));
  if (opposite[h] == kOpenEdge)
    return fmt::format("open edge at {}; {}", place(middle), plural(faults.open, "open edge"));
  if (opposite[h] == kTwistedEdge)
    return fmt::format("triangles of opposite orientation meet at {}; {}", place(middle),
                       plural(faults.twisted / 2, "such edge"));
  return fmt::format("more than two triangles meet at the edge at {}; {} triangle sides in all",
                     place(middle), faults.crowded);
}

}  // namespace

MeshSummary check_mesh(const TriMesh& mesh, int threads) {
  MeshSummary out;
  out.first_fault = invalid_content(mesh);
  if (!out.first_fault.empty()) return out;
  const std::vector<std::uint32_t> opposite = find_opposites(mesh, threads);
  const EdgeFaults edges = count_edge_faults(opposite);
  const VertexFaults vertices = count_vertex_faults(mesh, opposite, threads);
  out.bounds = bounds_of(mesh);
  const Sums sums = sum_all(mesh, out.bounds, threads);
  out.volume = sums.volume;
  out.area = sums.area;
  out.degenerate = sums.degenerate;
  out.euler = euler_characteristic(mesh, edges);
  std::vector<std::uint32_t> component;
  out.components = find_components(mesh, component);
  const bool pairs = edges.first == kNone;
  out.closed = edges.open + edges.crowded == 0;
  out.inverted = pairs && out.volume < 0;
  out.oriented = pairs && out.volume > 0;
  out.manifold = pairs && vertices.count == 0;
  if (!pairs)
    out.first_fault = edge_fault_text(mesh, opposite, edges);
  else if (vertices.count > 0)
    out.first_fault =
        fmt::format("surfaces touch in one point at {}; {}",
                    place(to_vec(mesh.vertices[vertices.first])), plural(vertices.count, "place"));
  else if (out.inverted)
    out.first_fault = fmt::format("inverted orientation: the volume is {:.6g} mm3", out.volume);
  else if (!out.oriented)
    out.first_fault = "the mesh encloses no volume";
  else if (out.degenerate > 0)
    out.first_fault = fmt::format("triangle without area at {}; {}",
                                  place(corner(mesh, sums.first_degenerate, 0)),
                                  plural(out.degenerate, "such triangle"));
  return out;
}

void require_solid(const TriMesh& mesh, const std::string& name, int threads) {
  const MeshSummary summary = check_mesh(mesh, threads);
  const bool valid = summary.components > 0;
  // Surfaces that touch in a point still bound a solid: a stock may, a part that is written may
  // not.
  if (valid && summary.oriented) return;
  const auto fail = [&](const char* code, const char* advice) {
    throw Error(code, fmt::format("{}: {}; {}", name, summary.first_fault, advice));
  };
  if (!valid) fail("mesh-invalid", "export it again");
  if (summary.inverted)
    fail("mesh-inverted", "the triangles must be counter-clockwise seen from outside: flip them");
  if (!summary.closed && summary.first_fault.starts_with("open"))
    fail("mesh-open", "a solid has no open edges: repair or export it again");
  if (summary.closed && !summary.oriented)
    fail("mesh-not-oriented",
         "all triangles must be counter-clockwise seen from outside: repair it");
  fail("mesh-not-manifold", "repair or export it again");
}

double signed_volume(const TriMesh& mesh) {
  return mesh.triangles.empty() ? 0 : sum_all(mesh, bounds_of(mesh), 1).volume;
}

}  // namespace mrsim
