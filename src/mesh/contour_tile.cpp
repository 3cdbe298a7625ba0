#include "mesh/contour_tile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim::detail {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::infinity();
constexpr float kEven = 0.3f;  ///< of a voxel: second differences of an even run of offsets

}  // namespace

ContourTile::ContourTile(const ExactField& field, const Lattice& lattice)
    : ContourCells(lattice), field_(field), offset_(kCount), list_of_(kNodes * kNodes * kNodes) {
  for (int a = 0; a < 3; ++a) {
    planes_[a].resize(kCells + 1);
    face_of_[a].assign(kCount, -1);
  }
}

void ContourTile::build(const LatticePoint& first, std::span<const std::uint32_t> candidates) {
  first_ = first;
  for (int a = 0; a < 3; ++a)
    for (std::int32_t i = 0; i <= kCells; ++i)
      planes_[a][static_cast<std::size_t>(i)] =
          lattice().coordinate(a, (component(first, a) + i) * lattice().per_voxel());
  ids_.clear();
  lists_.assign(1, {});
  std::fill(list_of_.begin(), list_of_.end(), 0);
  const Box3 whole = node_box({0, 0, 0}, kCells);
  descent_ = field_.descent(0.5 * (whole.lo + whole.hi), candidates);
  visit({0, 0, 0}, kCells, 1);
}

Box3 ContourTile::node_box(const LatticePoint& origin, std::int32_t size) const {
  const auto plane = [&](int axis, std::int32_t i) {
    return planes_[axis][static_cast<std::size_t>(i)];
  };
  return {{plane(0, origin.x), plane(1, origin.y), plane(2, origin.z)},
          {plane(0, origin.x + size), plane(1, origin.y + size), plane(2, origin.z + size)}};
}

void ContourTile::visit(const LatticePoint& origin, std::int32_t size, std::size_t level) {
  const auto region =
      descent_->enter(level, inflated(node_box(origin, size), kQuantum), kSurfaceBand,
                      /*last=*/size <= 2 * kNode);
  if (region != ExactField::Region::mixed)
    return fill(origin, size, region == ExactField::Region::material);
  if (size == kNode || (size == 2 * kNode && descent_->is_short(level))) {
    descent_->candidates(level, list_);
    return sample_node(origin, size, list_);
  }
  const std::int32_t half = size / 2;
  for (int k = 0; k < 8; ++k)
    visit({origin.x + (k & 1 ? half : 0), origin.y + (k & 2 ? half : 0),
           origin.z + (k & 4 ? half : 0)},
          half, level + 1);
}

void ContourTile::fill(const LatticePoint& origin, std::int32_t size, bool inside) {
  for (std::int32_t x = origin.x; x < origin.x + size; ++x)
    for (std::int32_t y = origin.y; y < origin.y + size; ++y) {
      const auto begin = offset_.begin() + id(x, y, origin.z);
      std::fill(begin, begin + size, inside ? -kUnknown : kUnknown);
    }
}

void ContourTile::sample_node(const LatticePoint& origin, std::int32_t size,
                              std::span<const std::uint32_t> list) {
  for (std::int32_t x = origin.x; x < origin.x + size; x += kNode)
    for (std::int32_t y = origin.y; y < origin.y + size; y += kNode)
      for (std::int32_t z = origin.z; z < origin.z + size; z += kNode)
        list_of_[static_cast<std::size_t>(node_id(x / kNode, y / kNode, z / kNode))] =
            static_cast<std::int32_t>(lists_.size());
  lists_.push_back({static_cast<std::uint32_t>(ids_.size()),
                    static_cast<std::uint32_t>(ids_.size() + list.size())});
  ids_.insert(ids_.end(), list.begin(), list.end());
  points_.clear();
  for (std::int32_t x = origin.x; x < origin.x + size; ++x)
    for (std::int32_t y = origin.y; y < origin.y + size; ++y)
      for (std::int32_t z = origin.z; z < origin.z + size; ++z)
        points_.push_back({planes_[0][static_cast<std::size_t>(x)],
                           planes_[1][static_cast<std::size_t>(y)],
                           planes_[2][static_cast<std::size_t>(z)]});
  distance_.resize(points_.size());
  field_.distances(points_, list, distance_.data());
  const double* d = distance_.data();
  for (std::int32_t x = origin.x; x < origin.x + size; ++x)
    for (std::int32_t y = origin.y; y < origin.y + size; ++y)
      for (std::int32_t z = 0; z < size; ++z)
        offset_[static_cast<std::size_t>(id(x, y, origin.z + z))] =
            static_cast<float>(*d++ + kInsideTolerance);
}

Box3 ContourTile::box(std::int32_t cell) const {
  const LatticePoint p = place(cell);
  const auto x = static_cast<std::size_t>(p.x), y = static_cast<std::size_t>(p.y),
             z = static_cast<std::size_t>(p.z);
  return {{planes_[0][x], planes_[1][y], planes_[2][z]},
          {planes_[0][x + 1], planes_[1][y + 1], planes_[2][z + 1]}};
}

std::span<const std::uint32_t> ContourTile::candidates(std::int32_t cell) const {
  const List& list = lists_[static_cast<std::size_t>(list_of(cell))];
  return {ids_.data() + list.begin, list.end - list.begin};
}

std::int32_t ContourTile::list_of(std::int32_t cell) const {
  const LatticePoint p = place(cell);
  return list_of_[static_cast<std::size_t>(node_id(p.x / kNode, p.y / kNode, p.z / kNode))];
}

bool ContourTile::is_complete(std::int32_t cell) const {
  const LatticePoint p = place(cell);
  const auto in = [](std::int32_t i) { return i > 0 && i < kCells - 1; };
  return in(p.x) && in(p.y) && in(p.z);
}

MinimalEdge ContourTile::edge_at(const LatticePoint& p, int axis) const {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  MinimalEdge e;
  for (int q = 0; q < 4; ++q) {
    LatticePoint cell = p;
    component(cell, u) -= (q & 1) ^ 1;
    component(cell, v) -= (q >> 1) ^ 1;
    e.cells[q] = id(cell.x, cell.y, cell.z);
  }
  const std::int32_t unit = lattice().per_voxel();
  e.start = {(first_.x + p.x) * unit, (first_.y + p.y) * unit, (first_.z + p.z) * unit};
  e.axis = axis;
  e.length = unit;
  e.low = id(p.x, p.y, p.z);
  LatticePoint end = p;
  ++component(end, axis);
  e.high = id(end.x, end.y, end.z);
  e.low_inside = std::signbit(offset_[static_cast<std::size_t>(e.low)]);
  const auto owned = [](std::int32_t i) { return i >= kFirstOwned && i < kFirstOwned + kOwned; };
  e.owned = owned(p.x) && owned(p.y) && owned(p.z);
  return e;
}

// The corners of nodes that the surface may pass, in the order of their places. An edge that starts
// elsewhere is not crossed: it lies in its corner's node.
template <class Body>
void ContourTile::for_each_corner(Body body) const {
  for (std::int32_t x = 0; x < kCells; ++x)
    for (std::int32_t ny = 0; ny < kNodes; ++ny) {
      std::int32_t mixed[kNodes], count = 0;
      for (std::int32_t nz = 0; nz < kNodes; ++nz)
        if (list_of_[static_cast<std::size_t>(node_id(x / kNode, ny, nz))] > 0) mixed[count++] = nz;
      if (count == 0) continue;
      for (std::int32_t y = ny * kNode; y < (ny + 1) * kNode; ++y)
        for (std::int32_t k = 0; k < count; ++k)
          for (std::int32_t z = mixed[k] * kNode; z < (mixed[k] + 1) * kNode; ++z)
            body(LatticePoint{x, y, z});
    }
}

std::vector<MinimalEdge> ContourTile::crossing_edges() const {
  std::vector<MinimalEdge> out;
  for_each_corner([&](const LatticePoint& p) {
    const std::int32_t n = id(p.x, p.y, p.z);
    const bool inside = std::signbit(offset_[static_cast<std::size_t>(n)]);
    for (int axis = 0; axis < 3; ++axis) {
      if (component(p, axis) == kCells - 1) continue;
      const auto end = static_cast<std::size_t>(n + kStep[axis]);
      if (std::signbit(offset_[end]) == inside) continue;
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      if (component(p, u) > 0 && component(p, v) > 0) out.push_back(edge_at(p, axis));
    }
  });
  return out;
}

// A surface that passes beside an edge shows itself by offsets that rise or fall evenly over the
// edge and its two neighbours on the line; a wall or gap across it does not.
bool ContourTile::runs_evenly(std::int32_t low, std::int32_t step) const {
  const float* f = &offset_[static_cast<std::size_t>(low)];
  const float rise = f[step] - f[0];
  const float even = kEven * static_cast<float>(lattice().voxel());
  for (const float next : {f[0] - f[-step], f[2 * step] - f[step]})
    if (!std::isinf(next) && (next * rise < 0 || std::abs(next - rise) > even)) return false;
  return true;
}

std::vector<MinimalEdge> ContourTile::doubtful_edges() const {
  std::vector<MinimalEdge> out;
  const auto voxel = static_cast<float>(lattice().voxel());
  for_each_corner([&](const LatticePoint& p) {
    if (std::min({p.x, p.y, p.z}) < kFirstOwned) return;
    const std::int32_t n = id(p.x, p.y, p.z);
    const float a = offset_[static_cast<std::size_t>(n)];
    for (int axis = 0; axis < 3; ++axis) {
      if (component(p, axis) >= kCells - 2) continue;
      const float b = offset_[static_cast<std::size_t>(n + kStep[axis])];
      if (std::signbit(a) == std::signbit(b) && std::abs(a) + std::abs(b) <= voxel &&
          !runs_evenly(n, kStep[axis]))
        out.push_back(edge_at(p, axis));
    }
  });
  return out;
}

std::vector<CellFace> ContourTile::faces(std::span<const MinimalEdge> edges) const {
  std::vector<CellFace> out;
  out.reserve(2 * edges.size());
  for (std::size_t k = 0; k < edges.size(); ++k)
    for (int place = 0; place < 4; ++place) {
      const CellFace face = face_of(edges[k], place);
      std::int32_t& known = face_of_[face.axis][static_cast<std::size_t>(face.high)];
      if (known < 0) {
        known = static_cast<std::int32_t>(out.size());
        out.push_back(face);
      }
      out[static_cast<std::size_t>(known)].add(static_cast<std::int32_t>(k));
    }
  for (const CellFace& face : out) face_of_[face.axis][static_cast<std::size_t>(face.high)] = -1;
  return out;
}

std::pair<double, double> ContourTile::offsets(const MinimalEdge& e) const {
  return {offset_[static_cast<std::size_t>(e.low)], offset_[static_cast<std::size_t>(e.high)]};
}

}  // namespace mrsim::detail
