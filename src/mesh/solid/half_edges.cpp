#include "mesh/solid/half_edges.h"

#include "core/numbers/disjoint_sets.h"
#include "core/process/parallel.h"

#include <algorithm>
#include <numeric>

namespace mrsim {
namespace {

// A half edge under the smaller of its two vertices.
struct Entry {
  std::uint32_t other;      // the larger vertex
  std::uint32_t half_edge;  // runs from smaller to larger where `forward`
  bool forward;
};

struct EdgeBuckets {
  std::vector<std::uint32_t> begin;
  std::vector<Entry> entries;
};

// Counting sort: linear, and in the order of the half edges within a bucket.
EdgeBuckets bucket_edges(Triangles triangles, std::size_t vertices) {
  EdgeBuckets out;
  out.begin.assign(vertices + 2, 0);
  const auto each = [&](auto&& body) {
    for (std::uint32_t f = 0; f < triangles.size(); ++f) {
      const auto& t = triangles[f];
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t u = t[k], v = t[k == 2 ? 0 : k + 1];
        body(std::min(u, v), Entry{std::max(u, v), 3 * f + k, u < v});
      }
    }
  };
  each([&](std::uint32_t low, const Entry&) { ++out.begin[low + 2]; });
  std::partial_sum(out.begin.begin(), out.begin.end(), out.begin.begin());
  out.entries.resize(3 * triangles.size());
  each([&](std::uint32_t low, const Entry& e) { out.entries[out.begin[low + 1]++] = e; });
  return out;
}

// [first, last) holds all half edges of one edge.
void resolve_edge(const Entry* first, const Entry* last, std::vector<std::uint32_t>& opposite) {
  const auto count = last - first;
  if (count == 2 && first[0].forward != first[1].forward) {
    opposite[first[0].half_edge] = first[1].half_edge;
    opposite[first[1].half_edge] = first[0].half_edge;
    return;
  }
  const std::uint32_t fault = count == 1 ? kBoundaryEdge : count == 2 ? kTwistedEdge : kCrowdedEdge;
  for (const Entry* e = first; e != last; ++e) opposite[e->half_edge] = fault;
}

}  // namespace

std::vector<std::uint32_t> find_opposites(Triangles triangles, std::size_t vertices, int threads) {
  EdgeBuckets buckets = bucket_edges(triangles, vertices);
  std::vector<std::uint32_t> opposite(3 * triangles.size());
  constexpr std::size_t kGrain = 4096;
  parallel_for(
      vertices, threads,
      [&](std::size_t v) {
        Entry* first = buckets.entries.data() + buckets.begin[v];
        Entry* last = buckets.entries.data() + buckets.begin[v + 1];
        std::sort(first, last, [](const Entry& a, const Entry& b) {
          return a.other != b.other ? a.other < b.other : a.half_edge < b.half_edge;
        });
        while (first != last) {
          Entry* end = first;
          while (end != last && end->other == first->other) ++end;
          resolve_edge(first, end, opposite);
          first = end;
        }
      },
      kGrain);
  return opposite;
}

VertexFans half_edges_by_vertex(Triangles triangles, std::size_t vertices) {
  VertexFans fans;
  fans.begin.assign(vertices + 2, 0);
  for (const auto& t : triangles)
    for (const std::uint32_t v : t) ++fans.begin[v + 2];
  std::partial_sum(fans.begin.begin(), fans.begin.end(), fans.begin.begin());
  fans.items.resize(3 * triangles.size());
  for (std::uint32_t h = 0; h < fans.items.size(); ++h)
    fans.items[fans.begin[triangles[h / 3][h % 3] + 1]++] = h;
  fans.begin.pop_back();
  return fans;
}

std::size_t find_components(Triangles triangles, std::size_t vertices,
                            std::vector<std::uint32_t>& component) {
  DisjointSets joined(vertices);
  for (const auto& t : triangles) joined.join(joined.join(t[0], t[1]), t[2]);
  constexpr std::uint32_t kUnseen = ~0u;
  std::vector<std::uint32_t> number(vertices, kUnseen);
  component.resize(triangles.size());
  std::uint32_t count = 0;
  for (std::size_t f = 0; f < component.size(); ++f) {
    std::uint32_t& n = number[joined.least(triangles[f][0])];
    if (n == kUnseen) n = count++;
    component[f] = n;
  }
  return count;
}

}  // namespace mrsim
