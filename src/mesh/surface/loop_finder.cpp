#include "mesh/surface/loop_finder.h"

#include "core/numbers/disjoint_sets.h"
#include "core/process/error.h"
#include "core/process/parallel.h"
#include "mesh/points/vertex.h"

#include <algorithm>

namespace mrsim::detail {
namespace {

constexpr double kDiagonal = 1.4142135623730951;  ///< of a square

// Of the two quadrants beside a face, cells come by low and high in the first half of the ring.
int low_quadrant(int quadrant) { return quadrant < 2 ? quadrant : (quadrant + 1) & 3; }
int high_quadrant(int quadrant) { return quadrant < 2 ? quadrant + 1 : quadrant; }

// Both edges lie on one side of a face that is flat on `axis`.
bool on_one_side(const MinimalEdge& a, const MinimalEdge& b, int axis) {
  if (a.axis != b.axis) return false;
  const int across = 3 - axis - a.axis;
  return component(a.start, across) == component(b.start, across);
}

enum class Joining { none, two, four };

// Every face should have two crossings, on two of its sides; four on all sides are paired where the
// face is small.
template <class EdgeOf>
Joining joining(const SurfaceCells& cells, const CellFace& face, const EdgeOf& edge_of) {
  const std::int32_t n = face.count;
  if (n != 2 && n != 4) return Joining::none;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < i; ++j)
      if (on_one_side(edge_of(face.crossing(i)), edge_of(face.crossing(j)), face.axis))
        return Joining::none;
  if (n == 2) return Joining::two;
  return cells.size_of(smaller_cell(cells, face)) <= cells.lattice().per_voxel() ? Joining::four
                                                                                 : Joining::none;
}

// Cells about faces whose crossings can not be joined.
std::vector<std::int32_t> badly_crossed(const SurfaceCells& cells, const CrossedGrid& grid) {
  const auto edge_of = [&](std::int32_t k) -> const MinimalEdge& { return at(grid.edges, k); };
  std::vector<std::int32_t> bad;
  for (const CellFace& face : grid.faces)
    if (face.has_all_edges() && joining(cells, face, edge_of) == Joining::none)
      bad.insert(bad.end(), {face.low, face.high});
  return bad;
}

CrossedGrid crossed_grid(const CellOctree& tree) {
  CrossedGrid grid;
  grid.edges = tree.crossing_edges();
  grid.faces = tree.faces(grid.edges);
  return grid;
}

// With all edges of the leaves and of those that share an edge with them.
CrossedGrid grid_about(const CellOctree& tree, std::vector<char> leaves) {
  CrossedGrid grid;
  tree.add_neighbours(leaves);
  grid.edges = tree.crossing_edges_about(leaves);
  grid.faces = tree.faces(grid.edges, leaves);
  grid.complete = std::move(leaves);
  return grid;
}

// Returns whether it has split any; the grid is used up then. It is as large as the surface, so
// that no copy is made of it.
bool split_bad(CellOctree& tree, CrossedGrid& grid) {
  const std::size_t before = tree.size();
  while (tree.split(badly_crossed(tree, grid)) > 0) {
    std::vector<char> leaves(tree.size());
    for (const std::int32_t n : tree.new_leaves()) leaves[static_cast<std::size_t>(n)] = 1;
    grid = grid_about(tree, std::move(leaves));
  }
  return tree.size() > before;
}

}  // namespace

CrossedGrid split_badly_crossed(CellOctree& tree) {
  CrossedGrid grid = crossed_grid(tree);
  if (!split_bad(tree, grid)) return grid;
  return crossed_grid(tree);
}

CrossedGrid split_badly_crossed(CellOctree& tree, std::vector<char> changed) {
  const std::size_t before = tree.size();
  CrossedGrid grid = grid_about(tree, changed);
  split_bad(tree, grid);
  changed.resize(tree.size());
  std::fill(changed.begin() + static_cast<std::ptrdiff_t>(before), changed.end(), 1);
  tree.add_neighbours(changed);
  grid = grid_about(tree, changed);
  for (MinimalEdge& e : grid.edges)
    e.owned = std::any_of(e.cells, e.cells + 4, [&](std::int32_t n) { return at(changed, n); });
  return grid;
}

void LoopFinder::find(std::vector<CellFace> faces) {
  faces_ = std::move(faces);
  find_segments();
  join_loops();
  list_crossings();
  list_segments();
}

void LoopFinder::find_segments() {
  segments_.clear();
  segments_.reserve(faces_.size());
  const auto edge_of = [&](std::int32_t k) -> const MinimalEdge& { return at(crossings_, k).edge; };
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const CellFace& face = faces_[f];
    if (!face.has_all_edges()) continue;
    const Joining j = joining(cells_, face, edge_of);
    MRSIM_ASSERT(j != Joining::none);
    if (j == Joining::two)
      add_segment(static_cast<std::int32_t>(f), 0, 1);
    else
      pair_four(static_cast<std::int32_t>(f));
  }
  parallel_for(
      segments_.size(), options_.threads,
      [&](std::size_t k) {
        Segment& s = segments_[k];
        s.is_crease = is_crease(at(faces_, s.face), at(crossings_, s.from), at(crossings_, s.to));
      },
      256);
}

bool LoopFinder::is_crease(const CellFace& face, const Crossing& a, const Crossing& b) const {
  if (same_face(a.at, b.at)) return false;
  const std::int32_t cell = face_cell(face);
  const double size = kDiagonal * cells_.lattice().fine() * cells_.size_of(cell);
  const Probe p = probe(cell);
  return !is_nearly_flat(p, {a.position, a.normal}, {b.position, b.normal}, size) &&
         !join_smoothly(p, 0.5 * (a.position + b.position), a.at, b.at, size);
}

// `from`, `to`: which crossings of the face.
void LoopFinder::add_segment(std::int32_t f, int from, int to) {
  const CellFace& face = at(faces_, f);
  const auto quadrant = [&](int i) { return static_cast<std::int8_t>(face.slots[i] & 3); };
  for (const int i : {from, to})
    crossings_[static_cast<std::size_t>(face.crossing(i))].segments[quadrant(i)] =
        static_cast<std::int32_t>(segments_.size());
  Segment s;
  s.face = f;
  s.from = face.crossing(from);
  s.to = face.crossing(to);
  s.from_quadrant = quadrant(from);
  s.to_quadrant = quadrant(to);
  segments_.push_back(s);
}

// Crossings on all four sides: the side of the surface on which the face's centre lies is
// connected, the two corners of the other are cut off.
void LoopFinder::pair_four(std::int32_t f) {
  const CellFace& face = at(faces_, f);
  const Box3 b = face_box(face);
  const int u = (face.axis + 1) % 3, v = (face.axis + 2) % 3;
  int side[4] = {};  // low v, high u, high v, low u: counter-clockwise
  for (int i = 0; i < 4; ++i) {
    const Crossing& c = at(crossings_, face.crossing(i));
    const int across = c.edge.axis == u ? v : u;
    const bool high = mrsim::component(c.position, across) > mrsim::component(b.lo, across);
    side[c.edge.axis == u ? (high ? 2 : 0) : (high ? 1 : 3)] = i;
  }
  // The corner between sides 3 and 0 is the low end of side 0's edge.
  const Crossing& first = at(crossings_, face.crossing(side[0]));
  const bool corner_inside = first.edge.low_inside;
  const bool center_inside = is_inside(probe(face_cell(face)).sample(0.5 * (b.lo + b.hi)).distance);
  const int shift =
      corner_inside != center_inside ? 3 : 0;  // cut off corners 3-0 and 1-2, or others
  for (int k = 0; k < 2; ++k)
    add_segment(f, side[(shift + 2 * k) & 3], side[(shift + 2 * k + 1) & 3]);
}

Loop& LoopFinder::new_loop(std::int32_t cell) {
  if (++loops_in_cell_[static_cast<std::size_t>(cell)] == 2 && is_complete(cell))
    crowded_.push_back(cell);
  Loop& loop = loops_.emplace_back();
  loop.cell = cell;
  return loop;
}

void LoopFinder::begin_loops() {
  loops_.clear();
  loops_in_cell_.assign(cells_.size(), 0);
  crowded_.clear();
}

void LoopFinder::join_loops() {
  const auto place = [](std::size_t crossing, int quadrant) {
    return static_cast<std::uint32_t>(4 * crossing) + static_cast<std::uint32_t>(quadrant);
  };
  DisjointSets joined(4 * crossings_.size());
  for (std::size_t k = 0; k < crossings_.size(); ++k)
    for (int i = 0; i < 4; ++i)
      if (crossings_[k].cell(i) == crossings_[k].cell((i + 1) & 3))
        joined.join(place(k, i), place(k, (i + 1) & 3));
  for (const Segment& s : segments_) {
    const auto from = static_cast<std::size_t>(s.from), to = static_cast<std::size_t>(s.to);
    joined.join(place(from, low_quadrant(s.from_quadrant)), place(to, low_quadrant(s.to_quadrant)));
    joined.join(place(from, high_quadrant(s.from_quadrant)),
                place(to, high_quadrant(s.to_quadrant)));
  }
  begin_loops();
  std::vector<std::int32_t> loop_of_set(joined.size(), -1);
  for (std::size_t k = 0; k < crossings_.size(); ++k)
    for (int i = 0; i < 4; ++i) {
      std::int32_t& id = loop_of_set[joined.least(place(k, i))];
      if (id < 0) {
        id = static_cast<std::int32_t>(loops_.size());
        new_loop(crossings_[k].cell(i));
      }
      crossings_[k].loops[i] = id;
    }
}

// What crossings each loop has, in the order of all.
void LoopFinder::list_crossings() {
  const auto loop = [&](std::int32_t i) -> Loop& { return loops_[static_cast<std::size_t>(i)]; };
  const auto is_first = [](const Crossing& c, int i) {
    for (int j = 0; j < i; ++j)
      if (c.loops[j] == c.loops[i]) return false;
    return true;
  };
  for (const Crossing& c : crossings_)
    for (int i = 0; i < 4; ++i)
      if (is_first(c, i)) ++loop(c.loops[i]).crossings;
  std::uint32_t crossings = 0;
  for (Loop& l : loops_) {
    l.first_crossing = crossings;
    crossings += l.crossings;
    l.crossings = 0;
  }
  loop_crossings_.resize(crossings);
  for (std::size_t k = 0; k < crossings_.size(); ++k)
    for (int i = 0; i < 4; ++i)
      if (is_first(crossings_[k], i)) {
        Loop& l = loop(crossings_[k].loops[i]);
        loop_crossings_[l.first_crossing + l.crossings++] = static_cast<std::int32_t>(k);
      }
}

// The loops on both sides of each segment, and what segments each has, in the order of all.
void LoopFinder::list_segments() {
  const auto loop = [&](std::int32_t i) -> Loop& { return loops_[static_cast<std::size_t>(i)]; };
  for (Segment& s : segments_) {
    const Crossing& c = at(crossings_, s.from);
    s.low = c.loops[low_quadrant(s.from_quadrant)];
    s.high = c.loops[high_quadrant(s.from_quadrant)];
    for (const std::int32_t i : {s.low, s.high})
      if (i >= 0) ++loop(i).segments;
  }
  std::uint32_t segments = 0;
  for (Loop& l : loops_) {
    l.first_segment = segments;
    segments += l.segments;
    l.segments = 0;
  }
  loop_segments_.resize(segments);
  for (std::size_t k = 0; k < segments_.size(); ++k)
    for (const std::int32_t i : {segments_[k].low, segments_[k].high}) {
      if (i < 0) continue;
      Loop& l = loop(i);
      loop_segments_[l.first_segment + l.segments++] = static_cast<std::int32_t>(k);
    }
}

}  // namespace mrsim::detail
