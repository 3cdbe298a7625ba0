// The edges of an octree that no smaller cell divides, and the faces about them.
#include "core/process/parallel.h"
#include "mesh/cells/doubtful_edges.h"
#include "mesh/cells/octree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

namespace mrsim::detail {
namespace {

// Walks the edges of the tree: a cell's own, those in the face between two cells, those about the
// line where four cells meet [Ju, Losasso, Schaefer and Warren 2002].
class EdgeWalk {
 public:
  /// `marked` (null: everything): only edges about nodes with a mark; `ring` (null: none): set for
  /// all leaves about such an edge, crossed or not.
  EdgeWalk(const CellOctree& tree, const std::vector<char>* marked, std::vector<char>* ring,
           std::vector<MinimalEdge>& out)
      : tree_(tree), marked_(marked), ring_(ring), out_(out) {}

  /// Collect edges that may be crossed twice instead of the crossed ones.
  void doubtful() { doubtful_ = true; }

  void cell(std::int32_t n) {
    const OctreeNode& node = tree_.node(n);
    if (node.child < 0 || !is_marked(n)) return;
    for (int k = 0; k < 8; ++k) cell(node.child + k);
    for (int axis = 0; axis < 3; ++axis)
      for (int k = 0; k < 8; ++k)
        if (!(k >> axis & 1)) face(node.child + k, node.child + (k | 1 << axis), axis);
    for (int axis = 0; axis < 3; ++axis)
      for (int s = 0; s < 2; ++s) {
        std::int32_t four[4];
        for (int q = 0; q < 4; ++q)
          four[q] =
              node.child + (s << axis | (q & 1) << (axis + 1) % 3 | (q >> 1) << (axis + 2) % 3);
        edge(four, axis);
      }
  }

 private:
  std::int32_t child(std::int32_t n, int k) const {
    const OctreeNode& node = tree_.node(n);
    return node.child < 0 ? n : node.child + k;
  }
  bool is_empty(std::int32_t n) const { return tree_.node(n).region != ExactField::Region::mixed; }

  bool is_marked(std::int32_t n) const {
    return !marked_ || (*marked_)[static_cast<std::size_t>(n)] != 0;
  }

  void face(std::int32_t low, std::int32_t high, int axis) {
    if (is_empty(low) || is_empty(high) || !(is_marked(low) || is_marked(high))) return;
    if (tree_.node(low).child < 0 && tree_.node(high).child < 0) return;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int q = 0; q < 4; ++q) {
      const int k = (q & 1) << u | (q >> 1) << v;
      face(child(low, k | 1 << axis), child(high, k), axis);
    }
    for (const int along : {u, v}) {
      const int across = along == u ? v : u;
      for (int s = 0; s < 2; ++s) {
        std::int32_t four[4];
        for (int q = 0; q < 4; ++q) {
          // Bit of each quadrant on the face's axis and on the one across the edge.
          const int b1 = q & 1, b2 = q >> 1;
          const bool first_is_axis = (along + 1) % 3 == axis;
          const int on_axis = first_is_axis ? b1 : b2, on_across = first_is_axis ? b2 : b1;
          const int k = s << along | on_across << across | (on_axis ? 0 : 1) << axis;
          four[q] = child(on_axis ? high : low, k);
        }
        edge(four, along);
      }
    }
  }

  void edge(const std::int32_t (&four)[4], int axis) {
    int smallest = 0;
    bool leaves = true;
    if (!is_marked(four[0]) && !is_marked(four[1]) && !is_marked(four[2]) && !is_marked(four[3]))
      return;
    for (int q = 0; q < 4; ++q) {
      if (is_empty(four[q])) return;
      leaves = leaves && tree_.node(four[q]).child < 0;
      if (tree_.node(four[q]).size < tree_.node(four[smallest]).size) smallest = q;
    }
    if (leaves) {
      emit(four, axis, smallest);
      return;
    }
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int s = 0; s < 2; ++s) {
      std::int32_t next[4];
      for (int q = 0; q < 4; ++q)
        next[q] = child(four[q], s << axis | ((q & 1) ^ 1) << u | ((q >> 1) ^ 1) << v);
      edge(next, axis);
    }
  }

  void emit(const std::int32_t (&four)[4], int axis, int smallest) {
    if (ring_)
      for (const std::int32_t n : four) (*ring_)[static_cast<std::size_t>(n)] = 1;
    const OctreeNode& node = tree_.node(four[smallest]);
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const int k = ((smallest & 1) ^ 1) << u | ((smallest >> 1) ^ 1) << v;
    MinimalEdge e;
    std::copy(four, four + 4, e.cells);
    e.low = node.corners[k];
    e.high = node.corners[k | 1 << axis];
    if (e.low < 0 || e.high < 0) return;
    const FieldSample &a = tree_.sample(e.low), &b = tree_.sample(e.high);
    const bool crossed = is_inside(a.distance) != is_inside(b.distance);
    if (doubtful_
            ? crossed || a.owner == b.owner || node.size > tree_.lattice().per_voxel() ||
                  std::abs(a.distance) + std::abs(b.distance) > node.size * tree_.lattice().fine()
            : !crossed)
      return;
    e.start = node.origin;
    component(e.start, u) += k >> u & 1 ? node.size : 0;
    component(e.start, v) += k >> v & 1 ? node.size : 0;
    e.axis = axis;
    e.length = node.size;
    for (const std::int8_t q : {2, 1, 0})
      if (tree_.node(four[q]).size < tree_.node(four[e.smallest]).size) e.smallest = q;
    e.low_inside = is_inside(a.distance);
    e.owned = tree_.is_owned(e.start);
    out_.push_back(e);
  }

  const CellOctree& tree_;
  const std::vector<char>* marked_;
  std::vector<char>* ring_;
  std::vector<MinimalEdge>& out_;
  bool doubtful_ = false;
};

}  // namespace

std::vector<MinimalEdge> CellOctree::crossing_edges() const {
  std::vector<MinimalEdge> out;
  EdgeWalk(*this, nullptr, nullptr, out).cell(0);
  if (is_whole()) return out;
  std::sort(out.begin(), out.end(), [](const MinimalEdge& a, const MinimalEdge& b) {
    return std::tie(a.start.x, a.start.y, a.start.z, a.axis) <
           std::tie(b.start.x, b.start.y, b.start.z, b.axis);
  });
  return out;
}

std::vector<CellFace> CellOctree::faces(std::span<const MinimalEdge> edges,
                                        const std::vector<char>& complete) const {
  const auto has_edges = [&](std::int32_t n) {
    return is_complete(n) && (complete.empty() || complete[static_cast<std::size_t>(n)] != 0);
  };
  std::vector<std::int32_t> ids(6 * size(), -1);  // by the smaller of the two cells and its side
  std::vector<CellFace> out;
  for (std::size_t k = 0; k < edges.size(); ++k)
    for (int quadrant = 0; quadrant < 4; ++quadrant) {
      CellFace face = face_of(edges[k], quadrant);
      if (face.low == face.high) continue;
      const std::int32_t owner = size_of(face.high) < size_of(face.low) ? face.high : face.low;
      const std::int32_t side = 2 * face.axis + (owner == face.low);
      std::int32_t& index =
          ids[6 * static_cast<std::size_t>(owner) + static_cast<std::size_t>(side)];
      if (index < 0) {
        index = static_cast<std::int32_t>(out.size());
        face.low_complete = has_edges(face.low);
        face.high_complete = has_edges(face.high);
        out.push_back(face);
      }
      out[static_cast<std::size_t>(index)].add(static_cast<std::int32_t>(k), quadrant);
    }
  if (is_whole()) return out;
  const auto plane = [&](const CellFace& face) {
    const int axis = face.axis;
    return component(node(face.high).origin, axis);
  };
  std::stable_sort(out.begin(), out.end(), [&](const CellFace& a, const CellFace& b) {
    return a.axis != b.axis ? a.axis < b.axis : plane(a) < plane(b);
  });
  return out;
}

std::pair<double, double> CellOctree::offsets(const MinimalEdge& e) const {
  constexpr double kWhenAsked = std::numeric_limits<double>::quiet_NaN();
  if (common_list(e.smallest_cell()) != nullptr) return {kWhenAsked, kWhenAsked};
  return {sample(e.low).distance + kInsideTolerance, sample(e.high).distance + kInsideTolerance};
}

EdgeEnds CellOctree::ends(const MinimalEdge& e) const {
  return {lattice().position(e.start),
          lattice().coordinate(e.axis, component(e.start, e.axis) + e.length)};
}

std::vector<MinimalEdge> CellOctree::doubtful_edges() const {
  std::vector<MinimalEdge> out;
  EdgeWalk walk(*this, nullptr, nullptr, out);
  walk.doubtful();
  walk.cell(0);
  add_doubtful_inside(out);
  return out;
}

// Looks within cells larger than a voxel, where more than one owner can decide d.
void CellOctree::add_doubtful_inside(std::vector<MinimalEdge>& out) const {
  const std::int32_t voxel = lattice().per_voxel();
  std::vector<std::int32_t> large;
  for (std::size_t n = 0; n < size(); ++n)
    if (const OctreeNode& a = nodes_[n]; a.child < 0 && a.region == ExactField::Region::mixed &&
                                         a.size > voxel && !a.plain &&
                                         !shows_box(static_cast<std::int32_t>(n)))
      large.push_back(static_cast<std::int32_t>(n));
  std::vector<std::vector<VoxelEdge>> inside(large.size());
  parallel_for(
      large.size(), threads_,
      [&](std::size_t k) {
        const OctreeNode& a = node(large[k]);
        inside[k] = doubtful_inside(field_, lattice(), candidates(large[k]), a.origin,
                                    a.size / voxel, !a.signs_differ);
      },
      16);
  for (std::size_t k = 0; k < large.size(); ++k)
    for (const VoxelEdge& edge : inside[k]) {
      MinimalEdge& e = out.emplace_back();
      std::fill_n(e.cells, 4, large[k]);
      e.start = edge.start;
      e.axis = edge.axis;
      e.length = voxel;
    }
}

// Sets all nodes that hold a leaf that is set.
std::vector<char> CellOctree::with_parents(std::vector<char> leaves) const {
  // Parents come before their children.
  for (std::size_t n = leaves.size(); n-- > 1;)
    if (leaves[n]) leaves[static_cast<std::size_t>(nodes_[n].parent)] = 1;
  return leaves;
}

std::vector<MinimalEdge> CellOctree::crossing_edges_about(const std::vector<char>& leaves) const {
  std::vector<MinimalEdge> out;
  const std::vector<char> marked = with_parents(leaves);
  EdgeWalk(*this, &marked, nullptr, out).cell(0);
  return out;
}

void CellOctree::add_neighbours(std::vector<char>& leaves) const {
  std::vector<MinimalEdge> unused;
  const std::vector<char> marked = with_parents(leaves);
  EdgeWalk(*this, &marked, &leaves, unused).cell(0);
}

}  // namespace mrsim::detail
