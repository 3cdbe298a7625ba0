#include "mesh/tiles/tile_mesh.h"

#include "core/process/error.h"

#include <algorithm>

namespace mrsim::detail {

std::size_t TileMesh::memory() const {
  const auto bytes = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return sizeof(*this) + bytes(vertices) + bytes(marks) + bytes(triangles) + bytes(owners) +
         bytes(border);
}

std::uint8_t tile_marks(const Vec3& p, const Vec3& low, const Vec3& high, const Vec3& middle) {
  if ((p.x == middle.x) + (p.y == middle.y) + (p.z == middle.z) >= 2) return TileMesh::kShared | 7u;
  unsigned out = 0;
  for (int a = 0; a < 3; ++a) {
    if (mrsim::component(p, a) >= mrsim::component(high, a)) out |= TileMesh::kShared | 1u << a;
    if (mrsim::component(p, a) <= mrsim::component(low, a)) out |= TileMesh::kShared;
  }
  return static_cast<std::uint8_t>(out);
}

std::vector<std::array<std::uint32_t, 2>> border_edges(const TileMesh& tile) {
  std::vector<std::array<std::uint32_t, 2>> out;
  for (const auto& t : tile.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = t[k], to = t[(k + 1) % 3];
      if (tile.marks[from] != 0 && tile.marks[to] != 0) out.push_back({from, to});
    }
  // Edges and their opposites come together; what is left of each pair is in `out` for good.
  const auto ends = [](const std::array<std::uint32_t, 2>& e) {
    return std::pair(std::min(e[0], e[1]), std::max(e[0], e[1]));
  };
  std::sort(out.begin(), out.end(), [&](const auto& a, const auto& b) {
    return std::pair(ends(a), a) < std::pair(ends(b), b);
  });
  std::size_t kept = 0;
  for (const std::array<std::uint32_t, 2> e : out) {
    if (kept > 0 && out[kept - 1][0] == e[1] && out[kept - 1][1] == e[0])
      --kept;
    else
      out[kept++] = e;
  }
  out.resize(kept);
  return out;
}

void TileMerger::restart() { *this = TileMerger(order_); }

// Vertices that no later tile has are forgotten; the others are numbered.
void TileMerger::begin_block() {
  std::vector<std::array<float, 3>> points = welder_.take();
  std::vector<SharedVertex> open;
  welder_ = {};
  for (std::size_t i = 0; i < shared_.size(); ++i) {
    SharedVertex& vertex = shared_[i];
    if (vertex.index == kUnused && vertex.last == 0) continue;
    welder_.add(points[i]);
    open.push_back({vertex.last, vertex.number, kUnused});
  }
  shared_ = std::move(open);
  first_new_ += static_cast<std::uint32_t>(fresh_.size());
  for (auto* v : {&fresh_, &points_, &borrowed_points_}) v->clear();
  for (auto* v : {&borrowed_, &unfinished_}) v->clear();
  triangles_.clear();
  owners_.clear();
  is_complete_ = false;
}

std::uint32_t TileMerger::index_of(SharedVertex& vertex, const std::array<float, 3>& point) {
  if (vertex.index == kUnused) {
    vertex.index = kBorrowed | static_cast<std::uint32_t>(borrowed_.size());
    borrowed_.push_back(vertex.number);
    borrowed_points_.push_back(point);
  }
  return vertex.index;
}

void TileMerger::add(const LatticePoint& place, const TileMesh& tile) {
  if (is_complete_) begin_block();
  index_.resize(tile.vertices.size());
  number_.resize(tile.vertices.size());
  for (std::size_t v = 0; v < index_.size(); ++v) {
    const auto fresh = static_cast<std::uint32_t>(fresh_.size());
    index_[v] = fresh;
    if (tile.marks[v] != 0) {
      const std::uint32_t known = welder_.add(tile.vertices[v]);
      LatticePoint last = place;
      for (int a = 0; a < 3; ++a) component(last, a) += tile.marks[v] >> a & 1;
      if (known == shared_.size()) shared_.push_back({0, first_new_ + fresh, fresh});
      shared_[known].last = std::max(shared_[known].last, order_.key(last));
      index_[v] = index_of(shared_[known], tile.vertices[v]);
      number_[v] = shared_[known].number;
    }
    if (index_[v] == fresh) fresh_.push_back(tile.vertices[v]);
  }
  for (const auto& t : tile.triangles)
    triangles_.push_back({index_[t[0]], index_[t[1]], index_[t[2]]});
  owners_.insert(owners_.end(), tile.owners.begin(), tile.owners.end());
  close_edges(tile);
}

void TileMerger::close_edges(const TileMesh& tile) {
  for (const auto& [from, to] : tile.border) {
    const std::uint64_t a = number_[from], b = number_[to];
    if (a == b) continue;
    const auto edge = unmatched_edges_.try_emplace(std::min(a, b) << 32 | std::max(a, b)).first;
    edge->second.end = tile.vertices[from];
    edge->second.count += a < b ? 1 : -1;
    if (edge->second.count == 0) unmatched_edges_.erase(edge);
  }
}

std::vector<std::array<float, 3>> TileMerger::gaps() const {
  std::vector<std::array<float, 3>> out;
  for (const auto& [ends, edge] : unmatched_edges_) out.push_back(edge.end);
  std::sort(out.begin(), out.end());
  return out;
}

MeshBlock TileMerger::block(std::uint64_t next) {
  if (is_complete_) begin_block();
  is_complete_ = true;
  if (std::uint64_t(first_new_) + fresh_.size() >= kBorrowed)
    throw Error("mesh-too-large", "the mesh has more than 2e9 vertices; take a larger --voxel");
  const auto borrowed = static_cast<std::uint32_t>(borrowed_.size());
  const auto point_of = [&](std::uint32_t index) {
    return (index & kBorrowed) != 0 ? index & ~kBorrowed : index + borrowed;
  };
  points_ = borrowed_points_;
  points_.insert(points_.end(), fresh_.begin(), fresh_.end());
  for (auto& t : triangles_)
    for (std::uint32_t& v : t) v = point_of(v);
  for (SharedVertex& vertex : shared_) {
    const bool is_unfinished = next != kNoTile && vertex.last >= next;
    if (is_unfinished)
      unfinished_.push_back(vertex.number);
    else
      vertex = {0, 0, kUnused};
  }
  std::sort(unfinished_.begin(), unfinished_.end());
  return {points_, borrowed_, first_new_, triangles_, owners_, {}, unfinished_};
}

}  // namespace mrsim::detail
