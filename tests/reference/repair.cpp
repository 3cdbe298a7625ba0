#include "reference/repair.h"

#include "mesh/solid/half_edges.h"
#include "mesh/solid/weld.h"

#include <algorithm>
#include <tuple>

namespace mrsim::testing {
namespace {

constexpr double kStep = 1.0 / 64;  // of the way to the neighbours
constexpr int kMostPasses = 16;

// A half edge of a crowded edge, seen along the edge from its larger to its smaller vertex.
struct Leaf {
  std::uint32_t low, high, half_edge;
  bool forward;     // runs from low to high
  double turn = 0;  // grows with the angle about the edge, counter-clockwise, in [0, 4)
};

// A number that grows with the angle of (x, y), without trigonometry.
double pseudo_angle(double x, double y) {
  const double p = y / (std::fabs(x) + std::fabs(y));
  if (!(p == p)) return 0;  // a triangle without area
  return x < 0 ? 2 - p : y < 0 ? 4 + p : p;
}

std::vector<Leaf> crowded_leaves(const TriMesh& mesh, const std::vector<std::uint32_t>& opposite) {
  std::vector<Leaf> leaves;
  for (std::uint32_t h = 0; h < opposite.size(); ++h) {
    if (opposite[h] != kCrowdedEdge) continue;
    const std::uint32_t a = origin_of(mesh, h), b = target_of(mesh, h);
    leaves.push_back({std::min(a, b), std::max(a, b), h, a < b});
  }
  std::sort(leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) {
    return std::tie(a.low, a.high, a.half_edge) < std::tie(b.low, b.high, b.half_edge);
  });
  return leaves;
}

void sort_about_edge(const TriMesh& mesh, Leaf* first, Leaf* last) {
  const Vec3 low = to_vec(mesh.vertices[first->low]), high = to_vec(mesh.vertices[first->high]);
  const Vec3 axis = normalized(high - low);
  const auto across = [&](const Leaf& leaf) {
    const Vec3 to_apex =
        to_vec(mesh.vertices[origin_of(mesh, previous_half_edge(leaf.half_edge))]) - low;
    return to_apex - dot(to_apex, axis) * axis;
  };
  const Vec3 x = normalized(across(*first)), y = cross(axis, x);
  for (Leaf* leaf = first; leaf != last; ++leaf) {
    const Vec3 c = across(*leaf);
    leaf->turn = leaf == first ? 0 : pseudo_angle(dot(c, x), dot(c, y));
  }
  std::sort(first, last, [](const Leaf& a, const Leaf& b) {
    return std::tie(a.turn, a.forward, a.half_edge) < std::tie(b.turn, b.forward, b.half_edge);
  });
}

// Turning counter-clockwise about the edge, material begins at a backward half edge and ends at
// the next forward one: matched like brackets, twice round so that the seam does not matter.
void pair_about_edge(const Leaf* first, const Leaf* last, std::vector<std::uint32_t>& opposite) {
  const auto count = std::size_t(last - first);
  std::vector<std::uint32_t> waiting;
  for (std::size_t i = 0; i < 2 * count; ++i) {
    const Leaf& leaf = first[i % count];
    if (is_half_edge(opposite[leaf.half_edge])) continue;
    if (!leaf.forward) {
      if (std::find(waiting.begin(), waiting.end(), leaf.half_edge) == waiting.end())
        waiting.push_back(leaf.half_edge);
    } else if (!waiting.empty()) {
      opposite[leaf.half_edge] = waiting.back();
      opposite[waiting.back()] = leaf.half_edge;
      waiting.pop_back();
    }
  }
}

// find_opposites, with the half edges of crowded edges paired by the material between them.
std::vector<std::uint32_t> pair_all(const TriMesh& mesh) {
  std::vector<std::uint32_t> opposite = find_opposites(mesh);
  std::vector<Leaf> leaves = crowded_leaves(mesh, opposite);
  for (std::size_t begin = 0, end = 0; begin < leaves.size(); begin = end) {
    while (end < leaves.size() && leaves[end].low == leaves[begin].low &&
           leaves[end].high == leaves[begin].high)
      ++end;
    sort_about_edge(mesh, leaves.data() + begin, leaves.data() + end);
    pair_about_edge(leaves.data() + begin, leaves.data() + end, opposite);
  }
  return opposite;
}

void move_towards(std::array<float, 3>& p, const Vec3& target, double step) {
  const Vec3 moved = lerp(to_vec(p), target, step);
  p = {float(moved.x), float(moved.y), float(moved.z)};
}

// The half edges that leave one vertex and are reached from `start` by turning about it.
std::vector<std::uint32_t> fan_from(const std::vector<std::uint32_t>& opposite,
                                    std::uint32_t start) {
  std::vector<std::uint32_t> fan;
  std::uint32_t h = start;
  do {
    fan.push_back(h);
    h = opposite[previous_half_edge(h)];
  } while (is_half_edge(h) && h != start);
  return fan;
}

Vec3 fan_middle(const TriMesh& mesh, const std::vector<std::uint32_t>& fan) {
  Vec3 sum;
  for (const std::uint32_t h : fan) sum += to_vec(mesh.vertices[target_of(mesh, h)]);
  return (1.0 / double(fan.size())) * sum;
}

// Gives every fan but the first of a vertex a vertex of its own.
void split_vertices(TriMesh& mesh, const std::vector<std::uint32_t>& opposite) {
  const VertexFans all = half_edges_by_vertex(mesh);
  struct Move {
    std::uint32_t vertex;
    Vec3 target;
  };
  std::vector<Move> moves;
  std::vector<bool> seen(opposite.size(), false);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> renamed;  // half edge, vertex it leaves
  for (std::uint32_t v = 0; v + 1 < all.begin.size(); ++v) {
    const std::uint32_t begin = all.begin[v], end = all.begin[v + 1];
    if (begin == end) continue;
    std::vector<std::uint32_t> fan = fan_from(opposite, all.items[begin]);
    if (fan.size() == end - begin) continue;
    std::uint32_t vertex = v;
    for (std::uint32_t i = begin; i < end; ++i) {
      if (seen[all.items[i]]) continue;
      fan = fan_from(opposite, all.items[i]);
      if (vertex != v || i != begin) {
        vertex = std::uint32_t(mesh.vertices.size());
        mesh.vertices.push_back(mesh.vertices[v]);
      }
      for (const std::uint32_t h : fan) {
        seen[h] = true;
        renamed.emplace_back(h, vertex);
      }
      moves.push_back({vertex, fan_middle(mesh, fan)});
    }
  }
  for (const auto& [h, vertex] : renamed) mesh.triangles[h / 3][h % 3] = vertex;
  for (const Move& move : moves) move_towards(mesh.vertices[move.vertex], move.target, kStep);
}

// Two sheets that share both ends of an edge still share the edge: each gets a middle of its own.
// One edge a triangle and pass; returns whether there was one.
bool split_edges(TriMesh& mesh, const std::vector<std::uint32_t>& opposite) {
  const std::vector<std::uint32_t> plain = find_opposites(mesh);
  std::vector<bool> touched(mesh.triangles.size(), false);
  bool any = false;
  for (std::uint32_t h = 0; h < plain.size(); ++h) {
    const std::uint32_t o = opposite[h];
    if (plain[h] != kCrowdedEdge || !is_half_edge(o) || touched[h / 3] || touched[o / 3]) continue;
    any = true;
    const auto middle = std::uint32_t(mesh.vertices.size());
    const Vec3 a = to_vec(mesh.vertices[origin_of(mesh, h)]),
               b = to_vec(mesh.vertices[target_of(mesh, h)]);
    Vec3 apexes;
    for (const std::uint32_t side : {h, o})
      apexes += 0.5 * to_vec(mesh.vertices[origin_of(mesh, previous_half_edge(side))]);
    const Vec3 at = lerp(0.5 * (a + b), apexes, kStep);
    mesh.vertices.push_back({float(at.x), float(at.y), float(at.z)});
    for (const std::uint32_t side : {h, o}) {
      touched[side / 3] = true;
      std::array<std::uint32_t, 3> second = mesh.triangles[side / 3];
      second[side % 3] = middle;
      mesh.triangles[side / 3][next_half_edge(side) % 3] = middle;
      mesh.triangles.push_back(second);
      if (!mesh.owners.empty()) mesh.owners.push_back(mesh.owners[side / 3]);
    }
  }
  return any;
}

bool is_flat(const TriMesh& mesh, std::size_t f) {
  const Vec3 a = corner(mesh, f, 0), b = corner(mesh, f, 1), c = corner(mesh, f, 2);
  const double longest = std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)});
  return !(length(cross(b - a, c - a)) > 1e-12 * longest);
}

// Vertices of triangles without area, and vertices on the place of another.
std::vector<std::uint32_t> crushed_vertices(const TriMesh& mesh) {
  std::vector<std::uint32_t> found;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
    if (is_flat(mesh, f))
      found.insert(found.end(), mesh.triangles[f].begin(), mesh.triangles[f].end());
  Welder welder;
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v)
    if (welder.add(mesh.vertices[v]) + 1 < welder.size()) found.push_back(v);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

// Moves them a little towards their neighbours, each by a step of its own.
bool relax(TriMesh& mesh, int pass) {
  const std::vector<std::uint32_t> crushed = crushed_vertices(mesh);
  if (crushed.empty()) return false;
  const VertexFans fans = half_edges_by_vertex(mesh);
  for (const std::uint32_t v : crushed) {
    const std::vector<std::uint32_t> fan(fans.items.begin() + fans.begin[v],
                                         fans.items.begin() + fans.begin[v + 1]);
    if (!fan.empty())
      move_towards(mesh.vertices[v], fan_middle(mesh, fan), kStep * (1 + pass + v % 3));
  }
  return true;
}

void drop_two_cornered(TriMesh& mesh) {
  std::size_t kept = 0;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto t = mesh.triangles[f];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    mesh.triangles[kept] = t;
    if (!mesh.owners.empty()) mesh.owners[kept] = mesh.owners[f];
    ++kept;
  }
  mesh.triangles.resize(kept);
  if (!mesh.owners.empty()) mesh.owners.resize(kept);
}

}  // namespace

void make_manifold(TriMesh& mesh) {
  mesh.colors.clear();
  drop_two_cornered(mesh);
  for (int pass = 0; pass < kMostPasses; ++pass) {
    const std::vector<std::uint32_t> opposite = pair_all(mesh);
    split_vertices(mesh, opposite);
    if (!split_edges(mesh, opposite)) break;
  }
  drop_unused_vertices(mesh);
  for (int pass = 0; pass < kMostPasses && relax(mesh, pass); ++pass) {
  }
}

}  // namespace mrsim::testing
