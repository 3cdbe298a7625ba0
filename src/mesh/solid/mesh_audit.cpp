#include "mesh/solid/mesh_audit.h"

#include "core/process/error.h"
#include "core/process/parallel.h"
#include "core/text/counted.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::size_t kTrianglesAThread = 8192;
constexpr double kSliver = 1e-14;  // height over longest side: a triangle without an area
constexpr std::uint32_t kNone = ~0u;

std::string point_text(const Vec3& p) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g}) mm", p.x + 0.0, p.y + 0.0, p.z + 0.0);
}

std::string in_all(std::size_t n, const char* what) { return counted(n, what) + " in all"; }

std::uint32_t origin_of(Triangles triangles, std::uint32_t h) { return triangles[h / 3][h % 3]; }

// Number of triangles met when turning about the origin of half edge `start`, up to a boundary or
// faulty edge.
std::uint32_t fan_size(const std::vector<std::uint32_t>& opposite, std::uint32_t start) {
  std::uint32_t size = 0, h = start;
  do {
    ++size;
    h = opposite[previous_half_edge(h)];
  } while (is_half_edge(h) && h != start);
  return size;
}

// The surface about a vertex is a disc (or half a disc, at a boundary edge) if one turn meets
// all of its triangles. Faulty edges are reported already; at a boundary edge the turn begins at
// the border.
bool is_single_fan(const VertexFans& fans, const std::vector<std::uint32_t>& opposite,
                   std::size_t v) {
  const std::uint32_t begin = fans.begin[v], end = fans.begin[v + 1];
  if (begin == end) return true;
  std::uint32_t start = fans.items[begin];
  for (std::uint32_t i = begin; i < end; ++i)
    if (!is_half_edge(opposite[fans.items[i]])) start = fans.items[i];
  return fan_size(opposite, start) == end - begin;
}

void add(SurfaceComponent& sum, const SurfaceComponent& part) {
  sum.first_triangle = std::min(sum.first_triangle, part.first_triangle);
  sum.triangles += part.triangles;
  sum.vertices += part.vertices;
  if (!is_empty(part.bounds)) {
    extend(sum.bounds, part.bounds.lo);
    extend(sum.bounds, part.bounds.hi);
  }
  sum.volume6.add(part.volume6);
  sum.area2.add(part.area2);
  for (int a = 0; a < 3; ++a) sum.moment24[a].add(part.moment24[a]);
}

// What some triangles, one after another, add to the components of their block.
struct PartialSums {
  std::map<std::uint32_t, SurfaceComponent> components;
  std::size_t degenerate = 0;
  Vec3 first_degenerate;
};

PartialSums sum_triangles(const MeshBlock& block, const std::vector<std::uint32_t>& components,
                          const Vec3& center, std::size_t begin, std::size_t end) {
  PartialSums out;
  SurfaceComponent* sum = nullptr;
  std::uint32_t last = kNone;
  for (std::size_t f = begin; f < end; ++f) {
    if (components[f] != last) {
      last = components[f];
      sum = &out.components[last];
      sum->first_triangle = std::min<std::uint64_t>(sum->first_triangle, f);
    }
    const auto& t = block.triangles[f];
    const Vec3 p = to_vec(block.points[t[0]]), q = to_vec(block.points[t[1]]),
               r = to_vec(block.points[t[2]]);
    const Vec3 a = p - center, b = q - center, c = r - center;
    const Vec3 n = cross(b - a, c - a), middle = a + b + c;
    const double twice_area = length(n), volume6 = dot(a, n);
    ++sum->triangles;
    sum->volume6.add(volume6);
    sum->area2.add(twice_area);
    for (int k = 0; k < 3; ++k) sum->moment24[k].add(volume6 * mrsim::component(middle, k));
    for (const Vec3& x : {p, q, r}) extend(sum->bounds, x);
    const double longest = std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)});
    // Coordinates are floats, so the cross product of a true sliver is far above rounding.
    if (twice_area > kSliver * longest) continue;
    if (out.degenerate++ == 0) out.first_degenerate = p;
  }
  return out;
}

}  // namespace

void MeshAudit::take(const MeshBlock& block) {
  if (block.triangles.empty()) return first_node_.push_back(std::uint32_t(nodes_.size()));
  if (triangles_ == 0) center_ = to_vec(block.points[block.triangles[0][0]]);
  add_components(block);
  if (front_.points.empty() && block.unfinished.empty() && block.borrowed.empty()) {
    check({}, block.points, block.triangles);
  } else {
    const Patch patch = patch_with(block);
    check(patch.states, patch.points, patch.triangles);
    keep_front(patch);
  }
  triangles_ += block.triangles.size();
}

// A node for each component within the block; components that share an unfinished vertex are
// joined.
void MeshAudit::add_components(const MeshBlock& block) {
  std::vector<std::uint32_t> component;
  const std::size_t count = find_components(block.triangles, block.points.size(), component);
  const auto first = static_cast<std::uint32_t>(nodes_.size());
  first_node_.push_back(first);
  nodes_.resize(first + count);
  joined_.grow(first + count);
  add_sums(block, component);
  node_of_.assign(block.points.size(), kNone);
  for (std::size_t f = 0; f < component.size(); ++f)
    for (const std::uint32_t v : block.triangles[f]) node_of_[v] = first + component[f];
  for (std::size_t v = block.borrowed.size(); v < node_of_.size(); ++v)
    if (node_of_[v] != kNone) ++nodes_[node_of_[v]].vertices;
}

void MeshAudit::add_sums(const MeshBlock& block, const std::vector<std::uint32_t>& component) {
  const std::size_t parts = (component.size() + kTrianglesAThread - 1) / kTrianglesAThread;
  std::vector<PartialSums> sums(parts);
  parallel_for(parts, threads_, [&](std::size_t i) {
    sums[i] = sum_triangles(block, component, center_, i * kTrianglesAThread,
                            std::min(component.size(), (i + 1) * kTrianglesAThread));
  });
  for (PartialSums& part : sums) {
    for (auto& [index, sum] : part.components) {
      sum.first_triangle += triangles_;
      add(nodes_[first_node_.back() + index], sum);
    }
    if (part.degenerate > 0 && fault_.degenerate == 0)
      fault_.flat = point_text(part.first_degenerate);
    fault_.degenerate += part.degenerate;
  }
}

// The triangles of the block and those about the vertices that were unfinished before it.
MeshAudit::Patch MeshAudit::patch_with(const MeshBlock& block) {
  Patch patch = std::move(front_);
  std::vector<std::uint32_t> at(block.points.size());
  for (std::uint32_t v = 0; v < block.borrowed.size(); ++v) {
    const auto found =
        std::lower_bound(patch.numbers.begin(), patch.numbers.end(), block.borrowed[v]);
    at[v] = static_cast<std::uint32_t>(found - patch.numbers.begin());
    if (found == patch.numbers.end() || *found != block.borrowed[v] ||
        patch.states[at[v]] != Patch::unfinished)
      throw InternalError("a block of the mesh borrows a vertex that is finished");
    joined_.join(node_of_[v], patch.nodes[at[v]]);
  }
  for (std::size_t v = block.borrowed.size(); v < block.points.size(); ++v) {
    at[v] = static_cast<std::uint32_t>(patch.points.size());
    patch.points.push_back(block.points[v]);
    patch.numbers.push_back(block.number(static_cast<std::uint32_t>(v)));
    patch.nodes.push_back(node_of_[v]);
    patch.states.push_back(Patch::unfinished);
  }
  for (const auto& t : block.triangles) patch.triangles.push_back({at[t[0]], at[t[1]], at[t[2]]});
  auto unfinished = block.unfinished.begin();
  for (std::size_t v = 0; v < patch.points.size(); ++v) {
    if (patch.states[v] != Patch::unfinished) continue;
    while (unfinished != block.unfinished.end() && *unfinished < patch.numbers[v]) ++unfinished;
    if (unfinished == block.unfinished.end() || *unfinished != patch.numbers[v])
      patch.states[v] = Patch::closing;
  }
  return patch;
}

// Keeps the triangles about vertices that stay unfinished.
void MeshAudit::keep_front(const Patch& patch) {
  front_ = {};
  std::vector<std::uint32_t> at(patch.points.size(), kNone);
  const auto is_unfinished = [&](std::uint32_t v) { return patch.states[v] == Patch::unfinished; };
  for (const auto& t : patch.triangles) {
    if (!is_unfinished(t[0]) && !is_unfinished(t[1]) && !is_unfinished(t[2])) continue;
    for (const std::uint32_t v : t) at[v] = 0;
  }
  for (std::uint32_t v = 0; v < at.size(); ++v) {
    if (at[v] == kNone) continue;
    at[v] = static_cast<std::uint32_t>(front_.points.size());
    front_.points.push_back(patch.points[v]);
    front_.numbers.push_back(patch.numbers[v]);
    front_.nodes.push_back(patch.nodes[v]);
    front_.states.push_back(is_unfinished(v) ? Patch::unfinished : Patch::done);
  }
  for (const auto& t : patch.triangles)
    if (is_unfinished(t[0]) || is_unfinished(t[1]) || is_unfinished(t[2]))
      front_.triangles.push_back({at[t[0]], at[t[1]], at[t[2]]});
}

void MeshAudit::check(std::span<const Patch::State> states,
                      std::span<const std::array<float, 3>> points, Triangles triangles) {
  const std::vector<std::uint32_t> opposite = find_opposites(triangles, points.size(), threads_);
  check_edges(states, points, triangles, opposite);
  check_vertices(states, points, triangles, opposite);
}

// An edge is judged once: with the first of its ends that is done.
void MeshAudit::check_edges(std::span<const Patch::State> states,
                            std::span<const std::array<float, 3>> points, Triangles triangles,
                            const std::vector<std::uint32_t>& opposite) {
  for (std::uint32_t h = 0; h < opposite.size(); ++h) {
    if (is_half_edge(opposite[h])) continue;
    const std::uint32_t a = origin_of(triangles, h), b = origin_of(triangles, next_half_edge(h));
    if (!states.empty() && (states[a] == Patch::done || states[b] == Patch::done ||
                            (states[a] == Patch::unfinished && states[b] == Patch::unfinished)))
      continue;
    if (fault_.edges() == 0) {
      fault_.first = opposite[h];
      fault_.edge = point_text(0.5 * (to_vec(points[a]) + to_vec(points[b])));
    }
    ++(opposite[h] == kBoundaryEdge  ? fault_.boundary
       : opposite[h] == kTwistedEdge ? fault_.twisted
                                     : fault_.crowded);
  }
}

void MeshAudit::check_vertices(std::span<const Patch::State> states,
                               std::span<const std::array<float, 3>> points, Triangles triangles,
                               const std::vector<std::uint32_t>& opposite) {
  struct Found {
    std::size_t count = 0;
    std::uint32_t first = kNone;
  };
  const VertexFans fans = half_edges_by_vertex(triangles, points.size());
  std::vector<Found> parts((points.size() + kTrianglesAThread - 1) / kTrianglesAThread);
  parallel_for(parts.size(), threads_, [&](std::size_t i) {
    const std::size_t end = std::min(points.size(), (i + 1) * kTrianglesAThread);
    for (std::size_t v = i * kTrianglesAThread; v < end; ++v) {
      if ((!states.empty() && states[v] != Patch::closing) || is_single_fan(fans, opposite, v))
        continue;
      if (parts[i].count++ == 0) parts[i].first = std::uint32_t(v);
    }
  });
  for (const Found& part : parts) {
    if (part.count > 0 && fault_.vertices == 0)
      fault_.vertex = point_text(to_vec(points[part.first]));
    fault_.vertices += part.count;
  }
}

const std::vector<SurfaceComponent>& MeshAudit::components() const {
  if (!components_.empty()) return components_;
  // The least node of a component comes first, so components are in the order of their first
  // triangles.
  component_of_node_.resize(nodes_.size());
  for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
    const std::uint32_t least = joined_.least(node);
    if (least == node) components_.emplace_back();
    component_of_node_[node] = least == node ? static_cast<std::uint32_t>(components_.size() - 1)
                                             : component_of_node_[least];
    add(components_[component_of_node_[node]], nodes_[node]);
  }
  return components_;
}

std::vector<std::uint32_t> MeshAudit::components_of(std::size_t index,
                                                    const MeshBlock& block) const {
  components();
  std::vector<std::uint32_t> out;
  find_components(block.triangles, block.points.size(), out);
  // The whole mesh in one block: its components are numbered alike, by their first triangles.
  if (block.triangles.size() == triangles_) return out;
  for (std::uint32_t& c : out) c = component_of_node_[first_node_[index] + c];
  return out;
}

std::string MeshAudit::Fault::edge_text() const {
  if (first == kBoundaryEdge)
    return fmt::format("open edge at {}; {}", edge, in_all(boundary, "open edge"));
  if (first == kTwistedEdge)
    return fmt::format("triangles of opposite orientation meet at {}; {}", edge,
                       in_all(twisted / 2, "such edge"));
  return fmt::format("more than two triangles meet at the edge at {}; {} triangle sides in all",
                     edge, crowded);
}

MeshSummary MeshAudit::summary(const std::vector<bool>& kept) const {
  MeshSummary out;
  SurfaceComponent whole;
  for (std::size_t c = 0; c < components().size(); ++c) {
    if (!kept.empty() && !kept[c]) continue;
    add(whole, components()[c]);
    ++out.components;
  }
  out.bounds = whole.bounds;
  out.volume = whole.volume();
  out.area = whole.area();
  out.degenerate = fault_.degenerate;
  // Half edges pair up but for those at the boundary; crowded edges are counted as if they did.
  const long faces = long(whole.triangles);
  out.euler = long(whole.vertices) - (3 * faces + long(fault_.boundary)) / 2 + faces;
  const bool pairs = fault_.edges() == 0;
  out.closed = fault_.boundary + fault_.crowded == 0;
  out.inverted = pairs && out.volume < 0;
  out.oriented = pairs && out.volume > 0;
  out.manifold = pairs && fault_.vertices == 0;
  if (!pairs)
    out.first_fault = fault_.edge_text();
  else if (fault_.vertices > 0)
    out.first_fault = fmt::format("surfaces touch in one point at {}; {}", fault_.vertex,
                                  in_all(fault_.vertices, "place"));
  else if (out.inverted)
    out.first_fault = fmt::format("inverted orientation: the volume is {:.6g} mm3", out.volume);
  else if (!out.oriented)
    out.first_fault = "the mesh encloses no volume";
  else if (out.degenerate > 0)
    out.first_fault = fmt::format("triangle without area at {}; {}", fault_.flat,
                                  in_all(out.degenerate, "such triangle"));
  return out;
}

}  // namespace mrsim
