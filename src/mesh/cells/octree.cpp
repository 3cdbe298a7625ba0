#include "mesh/cells/octree.h"

#include "core/process/parallel.h"
#include "mesh/cells/mesh_memory.h"
#include "mesh/points/vertex.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim::detail {
namespace {

constexpr int kLargestCell = 64;  ///< voxels, where sweeps can decide d
constexpr int kMixedCell = 4;     ///< voxels: the largest cell in which faces may meet in a crease
constexpr double kShallow = 0.125;  ///< of the tolerance: what a cell may hide

}  // namespace

CellOctree::CellOctree(const ExactField& field, const Lattice& lattice, double tolerance,
                       int threads, const OctreeLimits& limits)
    : SurfaceCells(lattice),
      field_(field),
      tolerance_(tolerance),
      threads_(threads),
      limits_(limits),
      is_box_(tolerance > 0 && field.has_box_stock()) {
  part_.size = static_cast<std::int32_t>(lattice.size());
  part_.complete[1] = part_.owned[1] = part_.size;
  OctreeNode root;
  root.size = part_.size;
  nodes_.push_back(root);
  lists_.push_back(field.all());
  refine({0});
}

CellOctree::CellOctree(const ExactField& field, const Lattice& lattice, const OctreePart& part)
    : SurfaceCells(lattice), field_(field), part_(part), tolerance_(0), threads_(1) {
  OctreeNode root;
  root.origin = part.origin;
  root.size = part.size;
  nodes_.push_back(root);
  lists_.emplace_back(part.candidates.begin(), part.candidates.end());
  refine({0});
}

Box3 CellOctree::box(std::int32_t n) const {
  const OctreeNode& a = node(n);
  return {lattice().position(a.origin),
          lattice().position({a.origin.x + a.size, a.origin.y + a.size, a.origin.z + a.size})};
}

FieldSample CellOctree::sample_at(const Vec3& p, std::int32_t cell) const {
  const Candidates* few = short_lists_.empty() ? nullptr : short_lists_.at(p, cell, box(cell));
  if (few != nullptr) {
    const FieldSample near = field_.sample(p, *few);
    if (std::abs(near.distance) <= surface_band(p)) return near;
  }
  return field_.sample(p, candidates(cell));
}

std::int32_t CellOctree::locate(const Vec3& p, std::int32_t near) const {
  const LatticePoint at = lattice().floor(p);
  const auto holds = [&](const OctreeNode& a) {
    return at.x >= a.origin.x && at.y >= a.origin.y && at.z >= a.origin.z &&
           at.x < a.origin.x + a.size && at.y < a.origin.y + a.size && at.z < a.origin.z + a.size;
  };
  std::int32_t n = near;
  while (n > 0 && !holds(node(n))) n = node(n).parent;
  while (node(n).child >= 0) {
    const OctreeNode& a = node(n);
    const std::int32_t half = a.size / 2;
    n = a.child + (at.x >= a.origin.x + half) + 2 * (at.y >= a.origin.y + half) +
        4 * (at.z >= a.origin.z + half);
  }
  return n;
}

void CellOctree::add_children(std::int32_t n, std::vector<std::int32_t>& out) {
  const OctreeNode parent = node(n);
  nodes_[static_cast<std::size_t>(n)].child = static_cast<std::int32_t>(nodes_.size());
  const std::int32_t half = parent.size / 2;
  for (int k = 0; k < 8; ++k) {
    OctreeNode c;
    c.parent = n;
    c.size = half;
    c.origin = {parent.origin.x + (k & 1 ? half : 0), parent.origin.y + (k & 2 ? half : 0),
                parent.origin.z + (k & 4 ? half : 0)};
    out.push_back(static_cast<std::int32_t>(nodes_.size()));
    nodes_.push_back(c);
    lists_.emplace_back();
  }
}

std::size_t CellOctree::split(std::vector<std::int32_t> leaves) {
  std::sort(leaves.begin(), leaves.end());
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
  require_room(8 * (kSplitMemory + kSurfaceMemory) * static_cast<double>(leaves.size()) +
                   kSurfaceMemory * static_cast<double>(undrawn()),
               tolerance_ > 0);
  std::erase_if(leaves, [&](std::int32_t n) { return node(n).child >= 0 || !can_split(n); });
  make_room(leaves.size());
  short_lists_ = SurfaceLists();
  std::vector<std::int32_t> pending;
  for (const std::int32_t n : leaves) add_children(n, pending);
  refine(std::move(pending));
  return leaves.size();
}

void CellOctree::make_room(std::size_t split) {
  const std::size_t count = size() + 8 * split;
  const auto nodes = static_cast<double>(count);
  // The new lists are taken to be as long as the present ones.
  const double list = sizeof(std::uint32_t) * static_cast<double>(listed_) / double(size());
  require_mesh_memory((kNodeMemory + list) * nodes, limits_.memory, tolerance_);
  require_cells(nodes, static_cast<double>(limits_.nodes));
  if (count <= nodes_.capacity()) return;
  // Twice as many, as a vector would take by itself, are too much where memory is short.
  const std::size_t room = std::max(count, size() + size() / 8);
  nodes_.reserve(room), lists_.reserve(room);
}

void CellOctree::refine(std::vector<std::int32_t> pending) {
  new_leaves_.clear();
  while (!pending.empty()) {
    find_regions(pending);
    std::vector<std::int32_t> mixed, next;
    for (const std::int32_t n : pending)
      if (node(n).region == ExactField::Region::mixed) mixed.push_back(n);
    sample_corners(mixed);
    std::vector<char> split(mixed.size());
    parallel_for(
        mixed.size(), threads_, [&](std::size_t k) { split[k] = must_split(mixed[k]); }, 8);
    make_room(static_cast<std::size_t>(std::count(split.begin(), split.end(), 1)));
    for (std::size_t k = 0; k < mixed.size(); ++k)
      if (split[k])
        add_children(mixed[k], next);
      else
        new_leaves_.push_back(mixed[k]);
    pending = std::move(next);
  }
}

// The list that the cell shares with its neighbours; null where it has none.
const Candidates* CellOctree::common_list(std::int32_t n) const {
  const OctreeNode& a = node(n);
  if (part_.common == nullptr || a.region != ExactField::Region::mixed ||
      a.size > lattice().per_voxel())
    return nullptr;
  return part_.common->at(a.origin);
}

void CellOctree::find_regions(const std::vector<std::int32_t>& pending) {
  parallel_for(
      pending.size(), threads_,
      [&](std::size_t k) {
        const auto n = static_cast<std::size_t>(pending[k]);
        OctreeNode& a = nodes_[n];
        const Box3 b = box(pending[k]);
        const Candidates whole = a.parent < 0 ? std::move(lists_[n]) : Candidates{};
        const std::span<const std::uint32_t> in =
            a.parent < 0 ? std::span<const std::uint32_t>(whole) : candidates(a.parent);
        a.region = field_.restrict_to(reach_of(b, b.hi.x - b.lo.x), kSurfaceBand, in, lists_[n]);
        if (const Candidates* common = common_list(pending[k])) lists_[n] = *common;
      },
      64);
  // Lists are narrowed once.
  for (const std::int32_t n : pending) {
    listed_ += lists_[static_cast<std::size_t>(n)].capacity();
    if (const std::int32_t parent = node(n).parent; parent >= 0) {
      Candidates& whole = lists_[static_cast<std::size_t>(parent)];
      listed_ -= whole.capacity();
      Candidates().swap(whole);
    }
  }
}

void CellOctree::sample_corners(const std::vector<std::int32_t>& pending) {
  const std::size_t first = samples_.size();
  std::vector<std::pair<LatticePoint, std::int32_t>> wanted;  // place, a node about it
  const std::int32_t largest = kLargestCell * lattice().per_voxel();
  for (const std::int32_t n : pending) {
    OctreeNode& a = nodes_[static_cast<std::size_t>(n)];
    if (a.size > (tolerance_ > 0 ? largest : lattice().per_voxel()) && !shows_box(n)) continue;
    for (int k = 0; k < 8; ++k) {
      const LatticePoint p{a.origin.x + (k & 1 ? a.size : 0), a.origin.y + (k & 2 ? a.size : 0),
                           a.origin.z + (k & 4 ? a.size : 0)};
      const auto [id, is_new] =
          sample_of_.insert(key(p), static_cast<std::int32_t>(first + wanted.size()));
      if (is_new) wanted.emplace_back(p, n);
      a.corners[k] = id;
    }
  }
  samples_.resize(first + wanted.size());
  parallel_for(
      wanted.size(), threads_,
      [&](std::size_t k) {
        samples_[first + k] =
            field_.sample(lattice().position(wanted[k].first), candidates(wanted[k].second));
      },
      256);
  for (const std::int32_t n : pending) {
    OctreeNode& a = nodes_[static_cast<std::size_t>(n)];
    if (a.corners[0] < 0) continue;
    for (int k = 1; k < 8; ++k)
      a.signs_differ = a.signs_differ || is_inside(sample(a.corners[k]).distance) !=
                                             is_inside(sample(a.corners[0]).distance);
  }
}

// Whether only the stock's box decides d in the cell, and no two opposite sides of the box pass the
// cell. Then the corners show the whole surface: one sheet of at most three planes and one vertex,
// which a mesh has exactly, however large the cell is.
bool CellOctree::shows_box(std::int32_t n) const {
  if (!is_box_ || !candidates(n).empty()) return false;
  const Box3 cell = inflated(box(n), kSurfaceBand), stock = field_.bounds();
  for (int a = 0; a < 3; ++a)
    if (mrsim::component(cell.lo, a) <= mrsim::component(stock.lo, a) &&
        mrsim::component(cell.hi, a) >= mrsim::component(stock.hi, a))
      return false;
  return true;
}

// A cell larger than a voxel stays whole only where it hides nothing: each sweep that can decide d
// in it decides it at a corner, at the centre or on an edge, or is shallow at every point of the
// voxel lattice.
bool CellOctree::must_split(std::int32_t n) {
  OctreeNode& a = nodes_[static_cast<std::size_t>(n)];
  const bool above_voxel = a.size > lattice().per_voxel();
  if (!(tolerance_ > 0) || a.corners[0] < 0) return above_voxel;
  const Box3 b = box(n);
  const std::span<const std::uint32_t> list = candidates(n);
  double corners[8];
  for (int k = 0; k < 8; ++k) corners[k] = sample(a.corners[k]).distance;
  CellSurface surface;
  if (a.signs_differ) surface = surface_of(field_, list, b, corners);
  const bool shown = shows_box(n);
  const Bend bend =
      shown ? Bend::even : bend_of(field_, list, surface, b.hi.x - b.lo.x, tolerance_);
  if (bend == Bend::face && can_split(n)) return true;

  static thread_local Candidates seen;
  const Sight sight = look_at(n, b, surface, seen);
  a.plain = sight.one_face && sight.is_alone;
  if (shown || !above_voxel || (sight.one_face && sight.owners_seen && sight.stock_seen))
    return false;
  const bool large = a.size > kMixedCell * lattice().per_voxel();
  if (bend == Bend::crease && large) return true;
  const CellView view{a.origin,
                      a.size / lattice().per_voxel(),
                      is_inside(corners[0]),
                      surface,
                      list,
                      seen,
                      sight.owners_seen,
                      sight.stock_seen};
  if (!a.signs_differ) return hides_surface(field_, lattice(), view, kShallow * tolerance_);
  return shows_more(field_, lattice(), view,
                    {tolerance_, kShallow * tolerance_,
                     large ? tolerance_ : std::numeric_limits<double>::infinity()});
}

// What the cell shows; `seen`: the sweeps that decide d at its corners, centre and on its edges.
CellOctree::Sight CellOctree::look_at(std::int32_t n, const Box3& b, const CellSurface& surface,
                                      Candidates& seen) {
  static thread_local Candidates sweeps;
  OctreeNode& a = nodes_[static_cast<std::size_t>(n)];
  const Vec3 center = 0.5 * (b.lo + b.hi);
  const double radius = 0.5 * length(b.hi - b.lo) + kQuantum;
  a.face = field_.sample(center, candidates(n));
  const bool near_stock = std::abs(field_.sample(center, {}).distance) <= radius + kSurfaceBand;
  Sight sight;
  sight.one_face = true;
  sight.stock_seen = !near_stock;
  seen.clear();
  const auto add = [&](const FieldSample& s) {
    sight.one_face = sight.one_face && same_face(s, a.face);
    if (s.owner == kStockOwner)
      sight.stock_seen = true;
    else
      seen.push_back(field_.candidate(s.owner));
  };
  add(a.face);
  for (const std::int32_t corner : a.corners) add(sample(corner));
  for (const CellSurface::Point& p : surface.all()) add(p.at);
  std::sort(seen.begin(), seen.end());
  seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
  const bool known =
      field_.expand_packs(inflated(b, kQuantum), kSurfaceBand, candidates(n), sweeps);
  sight.owners_seen =
      known && std::includes(seen.begin(), seen.end(), sweeps.begin(), sweeps.end());
  sight.is_alone = sight.owners_seen && sweeps.size() + near_stock <= 1;
  return sight;
}

bool CellOctree::in_range(const LatticePoint& p, const std::int32_t (&range)[2]) const {
  for (int a = 0; a < 3; ++a) {
    const std::int32_t i = component(p, a) - component(part_.origin, a);
    if (i < range[0] || i >= range[1]) return false;
  }
  return true;
}

}  // namespace mrsim::detail
