#include "mesh/cells/tile.h"

#include "mesh/cells/doubtful_edges.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace mrsim::detail {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::infinity();
constexpr float kWhenAsked = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint32_t kSign = 1u << 31;

bool has(std::uint64_t bits, std::int32_t i) { return (bits >> i & 1) != 0; }

}  // namespace

CellTile::CellTile(const ExactField& field, const Lattice& lattice, const CommonLists* common)
    : SurfaceCells(lattice),
      field_(field),
      common_(common),
      columns_(kCells * kCells),
      offset_(kCount),
      decider_(kCount),
      list_of_(kNodes * kNodes * kNodes),
      squares_(lattice) {
  for (std::vector<double>& planes : planes_) planes.resize(kCells + 1);
  for (auto& ranges : inner_) ranges.resize(kCells);
}

void CellTile::build(const LatticePoint& first, std::span<const std::uint32_t> candidates,
                     FlatCells flat, const BareTiles& bare) {
  first_ = first;
  for (int a = 0; a < 3; ++a) {
    for (std::int32_t i = 0; i <= kCells; ++i)
      planes_[a][static_cast<std::size_t>(i)] =
          lattice().coordinate(a, (component(first, a) + i) * lattice().per_voxel());
    for (std::size_t i = 0; i < inner_[a].size(); ++i)
      inner_[a][i] = inner(planes_[a][i], planes_[a][i + 1]);
  }
  find_stock();
  ids_.clear();
  lists_.assign(1, {});
  std::fill(columns_.begin(), columns_.end(), TileColumn{});
  std::fill(list_of_.begin(), list_of_.end(), 0);
  squares_.clear();
  const Box3 whole = node_box({0, 0, 0}, kCells);
  descent_ = field_.descent(0.5 * (whole.lo + whole.hi), candidates);
  visit({0, 0, 0}, kCells, 1);
  add_common_lists();
  find_crossed();
  if (is_box_ && flat == FlatCells::merged)
    squares_.merge(columns_, {field_.bounds(), first_, {within_[0], within_[1], within_[2]}}, bare,
                   crossed_);
  crossed_.number();
}

void CellTile::add_common_lists() {
  own_lists_.clear();
  if (common_ == nullptr) return;
  common_->each_in(first_, kCells, [&](const LatticePoint& p, const Candidates& list) {
    own_lists_.emplace_back(cell_at(p.x, p.y, p.z), static_cast<std::int32_t>(lists_.size()));
    add_list(list);
  });
  std::sort(own_lists_.begin(), own_lists_.end());
}

void CellTile::add_list(std::span<const std::uint32_t> list) {
  lists_.push_back({static_cast<std::uint32_t>(ids_.size()),
                    static_cast<std::uint32_t>(ids_.size() + list.size())});
  ids_.insert(ids_.end(), list.begin(), list.end());
}

// Finds the planes that lie between the sides of the stock's box, as its distance sees them.
void CellTile::find_stock() {
  is_box_ = field_.has_box_stock();
  if (!is_box_) return;
  const Box3 box = field_.bounds();
  for (int a = 0; a < 3; ++a) {
    const double lo = mrsim::component(box.lo, a), hi = mrsim::component(box.hi, a);
    within_[a] = 0;
    for (std::int32_t i = 0; i < kCells; ++i) {
      const double p = planes_[a][static_cast<std::size_t>(i)];
      if (std::max(lo - p, p - hi) + kInsideTolerance < 0) within_[a] |= bit_range(i, 1);
    }
  }
}

Box3 CellTile::node_box(const LatticePoint& origin, std::int32_t size) const {
  const auto plane = [&](int axis, std::int32_t i) {
    return planes_[axis][static_cast<std::size_t>(i)];
  };
  return {{plane(0, origin.x), plane(1, origin.y), plane(2, origin.z)},
          {plane(0, origin.x + size), plane(1, origin.y + size), plane(2, origin.z + size)}};
}

void CellTile::visit(const LatticePoint& origin, std::int32_t size, std::size_t tier) {
  const Box3 reach = reach_of(node_box(origin, size), lattice().voxel());
  const auto region = size == kNode
                          ? descent_->finish(tier, reach, kSurfaceBand, list_)
                          : descent_->enter(tier, reach, kSurfaceBand, /*last=*/size == 2 * kNode);
  if (region != ExactField::Region::mixed)
    return fill(origin, size, region == ExactField::Region::material);
  if (size == kNode) return sample_node<kNode>(origin, list_);
  if (size == 2 * kNode && descent_->is_short(tier)) {
    descent_->candidates(tier, list_);
    return sample_node<2 * kNode>(origin, list_);
  }
  const std::int32_t half = size / 2;
  for (int k = 0; k < 8; ++k)
    visit({origin.x + (k & 1 ? half : 0), origin.y + (k & 2 ? half : 0),
           origin.z + (k & 4 ? half : 0)},
          half, tier + 1);
}

void CellTile::fill(const LatticePoint& origin, std::int32_t size, bool inside) {
  if (!inside) return;
  for (std::int32_t x = origin.x; x < origin.x + size; ++x)
    for (std::int32_t y = origin.y; y < origin.y + size; ++y)
      column(x, y).inside |= bit_range(origin.z, size);
}

// Keeps the list for the nodes of a cube.
void CellTile::set_list(const LatticePoint& origin, std::int32_t size,
                        std::span<const std::uint32_t> list) {
  const auto number = static_cast<std::int32_t>(list.empty() ? 0 : lists_.size());
  if (!list.empty()) add_list(list);
  for (std::int32_t x = origin.x; x < origin.x + size; x += kNode)
    for (std::int32_t y = origin.y; y < origin.y + size; y += kNode)
      for (std::int32_t z = origin.z; z < origin.z + size; z += kNode)
        list_of_[static_cast<std::size_t>(node_id(x / kNode, y / kNode, z / kNode))] = number;
}

// Samples the corners of a cube, whose sides are those of nodes.
template <std::int32_t kSize>
void CellTile::sample_node(const LatticePoint& origin, std::span<const std::uint32_t> list) {
  constexpr std::size_t kPoints = std::size_t(kSize) * kSize * kSize;
  if (list.empty() && is_box_) return mark_stock_node<kSize>(origin);  // list 0, as at first
  set_list(origin, kSize, list);
  Vec3 points[kPoints];
  double distances[kPoints];
  std::uint32_t deciders[kPoints];
  const double* planes[3];
  for (int a = 0; a < 3; ++a)
    planes[a] = &planes_[a][static_cast<std::size_t>(component(origin, a))];
  Vec3* point = points;
  for (int x = 0; x < kSize; ++x)
    for (int y = 0; y < kSize; ++y)
      for (int z = 0; z < kSize; ++z) *point++ = {planes[0][x], planes[1][y], planes[2][z]};
  field_.distances(points, list, distances, deciders);
  // Sizes of floats compare as their bits do.
  const auto voxel_length = static_cast<float>(lattice().voxel());
  const auto voxel = std::bit_cast<std::uint32_t>(voxel_length),
             half_voxel = std::bit_cast<std::uint32_t>(0.5f * voxel_length);
  const double* d = distances;
  for (std::int32_t x = 0; x < kSize; ++x)
    for (std::int32_t y = 0; y < kSize; ++y) {
      const auto first = static_cast<std::size_t>(cell_at(origin.x + x, origin.y + y, origin.z));
      std::copy_n(deciders + (d - distances), kSize, &decider_[first]);
      TileColumn found;
      for (std::int32_t z = 0; z < kSize; ++z) {
        const auto offset = static_cast<float>(*d++ + kInsideTolerance);
        offset_[first + static_cast<std::size_t>(z)] = offset;
        const auto bits = std::bit_cast<std::uint32_t>(offset), size = bits & ~kSign;
        found.inside |= std::uint64_t(bits >> 31) << z;
        found.near |= std::uint64_t(size <= voxel) << z;
        found.very_near |= std::uint64_t(size <= half_voxel) << z;
      }
      TileColumn& own = column(origin.x + x, origin.y + y);
      own.sampled |= bit_range(origin.z, kSize);
      if (!list.empty()) own.cut |= bit_range(origin.z, kSize);
      own.inside |= found.inside << origin.z;
      own.near |= found.near << origin.z;
      own.very_near |= found.very_near << origin.z;
    }
}

// A node in which the box of the stock alone decides: its planes give most signs, and the other
// corners are sampled when they are needed.
template <std::int32_t kSize>
void CellTile::mark_stock_node(const LatticePoint& origin) {
  const std::uint64_t all = bit_range(origin.z, kSize);
  for (std::int32_t x = origin.x; x < origin.x + kSize; ++x)
    for (std::int32_t y = origin.y; y < origin.y + kSize; ++y) {
      const auto first = static_cast<std::size_t>(cell_at(x, y, origin.z));
      std::fill_n(&decider_[first], kSize, kStockDecides);
      std::fill_n(&offset_[first], kSize, kWhenAsked);
      TileColumn& own = column(x, y);
      own.sampled |= all, own.near |= all, own.very_near |= all;
      if (has(within_[0], x) && has(within_[1], y)) own.inside |= all & within_[2];
    }
}

Vec3 CellTile::position(const LatticePoint& p) const {
  return {planes_[0][static_cast<std::size_t>(p.x)], planes_[1][static_cast<std::size_t>(p.y)],
          planes_[2][static_cast<std::size_t>(p.z)]};
}

float CellTile::known_offset(std::int32_t corner) const {
  const LatticePoint p = point_of(corner);
  const TileColumn& own = column(p.x, p.y);
  if (has(own.sampled, p.z)) return offset_[static_cast<std::size_t>(corner)];
  return has(own.inside, p.z) ? -kUnknown : kUnknown;
}

float CellTile::offset(std::int32_t corner) const {
  const float known = known_offset(corner);
  if (!std::isnan(known)) return known;
  return static_cast<float>(field_.sample(position(point_of(corner)), {}).distance +
                            kInsideTolerance);
}

Box3 CellTile::box(std::int32_t cell) const {
  const LatticePoint p = point_of(cell);
  const auto x = static_cast<std::size_t>(p.x), y = static_cast<std::size_t>(p.y),
             z = static_cast<std::size_t>(p.z);
  return {{planes_[0][x], planes_[1][y], planes_[2][z]},
          {planes_[0][x + 1], planes_[1][y + 1], planes_[2][z + 1]}};
}

Box3 CellTile::inner_box(std::int32_t cell) const {
  const LatticePoint p = point_of(cell);
  const auto &x = inner_[0][static_cast<std::size_t>(p.x)],
             &y = inner_[1][static_cast<std::size_t>(p.y)],
             &z = inner_[2][static_cast<std::size_t>(p.z)];
  return {{x.first, y.first, z.first}, {x.second, y.second, z.second}};
}

bool CellTile::is_mixed(std::int32_t cell) const {
  const LatticePoint p = point_of(cell);
  return has(column(p.x, p.y).sampled, p.z);
}

std::span<const std::uint32_t> CellTile::candidates(std::int32_t cell) const {
  const List& list = lists_[static_cast<std::size_t>(list_of(cell))];
  return {ids_.data() + list.begin, list.end - list.begin};
}

// The number of the cell's common list, 0 where it has none.
std::int32_t CellTile::own_list(std::int32_t cell) const {
  const auto found = std::lower_bound(own_lists_.begin(), own_lists_.end(), std::pair(cell, 0));
  return found == own_lists_.end() || found->first != cell ? 0 : found->second;
}

std::int32_t CellTile::list_of(std::int32_t cell) const {
  if (!own_lists_.empty())
    if (const std::int32_t own = own_list(cell); own != 0) return own;
  const LatticePoint p = point_of(cell);
  return list_of_[static_cast<std::size_t>(node_id(p.x / kNode, p.y / kNode, p.z / kNode))];
}

bool CellTile::is_complete(std::int32_t cell) const {
  const LatticePoint p = point_of(cell);
  const auto in = [](std::int32_t i) { return i > 0 && i < kCells - 1; };
  return in(p.x) && in(p.y) && in(p.z);
}

bool CellTile::is_far(std::int32_t cell) const {
  const LatticePoint p = point_of(cell);
  const auto range = [](std::int32_t i) {
    return std::pair(std::max(i - 1, 0), std::min(i + 2, kCells - 1));
  };
  const auto [x0, x1] = range(p.x);
  const auto [y0, y1] = range(p.y);
  const auto [z0, z1] = range(p.z);
  std::uint64_t any = 0, all = ~std::uint64_t(0);
  for (std::int32_t x = x0; x <= x1; ++x)
    for (std::int32_t y = y0; y <= y1; ++y) {
      any |= column(x, y).inside;
      all &= column(x, y).inside;
    }
  const std::uint64_t bits = bit_range(z0, z1 - z0 + 1);
  return (any & bits) == 0 || (all & bits) == bits;
}

MinimalEdge CellTile::edge_at(const LatticePoint& p, int axis) const {
  const std::int32_t n = cell_at(p.x, p.y, p.z);
  const std::int32_t u = kStep[(axis + 1) % 3], v = kStep[(axis + 2) % 3];
  const std::int32_t unit = lattice().per_voxel();
  MinimalEdge e;
  e.cells[0] = n - u - v;
  e.cells[1] = n - v;
  e.cells[2] = n - u;
  e.cells[3] = n;
  e.start = {(first_.x + p.x) * unit, (first_.y + p.y) * unit, (first_.z + p.z) * unit};
  e.axis = axis;
  e.length = unit;
  e.low = n;
  e.high = n + kStep[axis];
  e.low_inside = has(column(p.x, p.y).inside, p.z);
  e.owned = is_owned(p);
  return e;
}

// Corners that were not sampled lie in nodes that the surface does not pass, and so do edges that
// start there. Edges have cells on both sides.
void CellTile::find_crossed() {
  const std::uint64_t above = bit_range(1, kCells - 1), below = bit_range(0, kCells - 1);
  for (std::int32_t x = 0; x < kCells; ++x)
    for (std::int32_t y = 0; y < kCells; ++y) {
      const TileColumn& own = column(x, y);
      const auto crossed = [&](bool exist, std::uint64_t ends, std::uint64_t from) {
        return exist ? (own.inside ^ ends) & own.sampled & from : 0;
      };
      const std::int32_t right = x < kCells - 1 ? x + 1 : x, back = y < kCells - 1 ? y + 1 : y;
      crossed_.set(TileEdges::column(0, x, y),
                   crossed(right > x && y > 0, column(right, y).inside, above));
      crossed_.set(TileEdges::column(1, x, y),
                   crossed(back > y && x > 0, column(x, back).inside, above));
      crossed_.set(TileEdges::column(2, x, y), crossed(x > 0 && y > 0, own.inside >> 1, below));
    }
}

void CellTile::append_crossed(std::vector<MinimalEdge>& out) const {
  out.reserve(out.size() + static_cast<std::size_t>(crossed_.size()));
  for (std::int32_t x = 0; x < kCells; ++x)
    for (std::int32_t y = 0; y < kCells; ++y)
      for (int axis = 0; axis < 3; ++axis)
        for (std::uint64_t left = crossed_.bits(TileEdges::column(axis, x, y)); left != 0;
             left &= left - 1)
          out.push_back(edge_at({x, y, std::countr_zero(left)}, axis));
}

// False where a neighbour was not sampled.
bool CellTile::runs_evenly(std::int32_t low, std::int32_t step) const {
  return run_evenly({offset(low - step), offset(low), offset(low + step), offset(low + 2 * step)},
                    lattice().voxel());
}

std::vector<MinimalEdge> CellTile::doubtful_edges() const {
  std::vector<MinimalEdge> out;
  const auto voxel = static_cast<float>(lattice().voxel());
  const auto is_doubtful = [&](std::int32_t low, std::int32_t step) {
    return decider_[static_cast<std::size_t>(low)] !=
               decider_[static_cast<std::size_t>(low + step)] &&
           std::abs(offset(low)) + std::abs(offset(low + step)) <= voxel && !runs_evenly(low, step);
  };
  for (std::int32_t x = kFirstTested; x < kEndOwned; ++x)
    for (std::int32_t y = kFirstTested; y < kEndOwned; ++y) {
      const TileColumn& own = column(x, y);
      if (own.near == 0) continue;
      // Where the offsets of two ends add up to at most a voxel, one is at most half a voxel.
      const auto alike = [&](int axis, const TileColumn& end, int shift) {
        if (!is_tested(x, axis == 0) || !is_tested(y, axis == 1)) return std::uint64_t(0);
        return own.near & end.near >> shift & (own.very_near | end.very_near >> shift) &
               (own.cut | end.cut >> shift) & ~(own.inside ^ end.inside >> shift) &
               bit_range(axis == 2 ? kFirstTested : kFirstOwned, kOwned);
      };
      const std::uint64_t bits[3] = {alike(0, column(x + 1, y), 0), alike(1, column(x, y + 1), 0),
                                     alike(2, own, 1)};
      for (std::uint64_t left = bits[0] | bits[1] | bits[2]; left != 0; left &= left - 1) {
        const std::int32_t z = std::countr_zero(left);
        for (int axis = 0; axis < 3; ++axis)
          if (has(bits[axis], z) && is_doubtful(cell_at(x, y, z), kStep[axis]))
            out.push_back(edge_at({x, y, z}, axis));
      }
    }
  return out;
}

std::pair<double, double> CellTile::offsets(const MinimalEdge& e) const {
  if (!own_lists_.empty() && own_list(e.smallest_cell()) != 0) return {kWhenAsked, kWhenAsked};
  return {known_offset(e.low), known_offset(e.high)};
}

EdgeEnds CellTile::ends(const MinimalEdge& e) const {
  const LatticePoint p = point_of(e.low);
  return {position(p), planes_[e.axis][static_cast<std::size_t>(component(p, e.axis) + 1)]};
}

Vec3 CellTile::middle(const TileSquare& square) const {
  const CellSquare& s = square.cells;
  const LatticePoint p = square.cell(s.row + s.size / 2, s.column + s.size / 2);
  const auto at = [&](int axis) {
    return lattice().coordinate(
        axis, (component(first_, axis) + component(p, axis)) * lattice().per_voxel());
  };
  return {at(0), at(1), at(2)};
}

std::int32_t CellTile::cell_in(const TileSquare& square) {
  const CellSquare& s = square.cells;
  const auto inside = [](std::int32_t i) { return std::clamp(i, 1, kCells - 2); };
  const LatticePoint p = square.cell(inside(s.row + s.size / 2), inside(s.column + s.size / 2));
  return cell_at(p.x, p.y, p.z);
}

}  // namespace mrsim::detail
