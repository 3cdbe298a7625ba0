// From signs at the corners of cells to closed loops about them.
#include "core/error.h"
#include "core/parallel.h"
#include "mesh/contour_surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mrsim::detail {
namespace {

std::uint64_t edge_key(const MinimalEdge& e) {
  // The start is a multiple of the length and below 2^21 on each axis: the length's lowest bit
  // in place of the axis coordinate's tells lengths apart.
  LatticePoint p = e.start;
  component(p, e.axis) += e.length / 2;
  return key(p) | static_cast<std::uint64_t>(e.axis) << 62;
}

std::int32_t find(std::vector<std::int32_t>& parent, std::int32_t i) {
  while (parent[static_cast<std::size_t>(i)] != i) {
    auto& p = parent[static_cast<std::size_t>(i)];
    p = parent[static_cast<std::size_t>(p)];
    i = p;
  }
  return i;
}

void join(std::vector<std::int32_t>& parent, std::int32_t a, std::int32_t b) {
  a = find(parent, a);
  b = find(parent, b);
  if (a != b) parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
}

template <class T>
const T& at(const std::vector<T>& v, std::int32_t i) {
  return v[static_cast<std::size_t>(i)];
}

// Both edges lie on one side of a face that is flat on `axis`.
bool on_one_side(const MinimalEdge& a, const MinimalEdge& b, int axis) {
  if (a.axis != b.axis) return false;
  const int across = 3 - axis - a.axis;
  return component(a.start, across) == component(b.start, across);
}

std::int32_t smaller_cell(const ContourCells& cells, const CellFace& face) {
  return cells.size_of(face.high) < cells.size_of(face.low) ? face.high : face.low;
}

bool has_all_edges(const ContourCells& cells, const CellFace& face) {
  return cells.is_complete(face.low) || cells.is_complete(face.high);
}

enum class Joining { none, two, four };

// Every face should have two crossings, on two of its sides; four on all sides are paired where the
// face is small.
template <class EdgeOf>
Joining joining(const ContourCells& cells, const CellFace& face, const EdgeOf& edge_of) {
  const std::size_t n = face.crossings.size();
  if (n != 2 && n != 4) return Joining::none;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (on_one_side(edge_of(face.crossings[i]), edge_of(face.crossings[j]), face.axis))
        return Joining::none;
  if (n == 2) return Joining::two;
  return cells.size_of(smaller_cell(cells, face)) <= cells.lattice().per_voxel() ? Joining::four
                                                                                 : Joining::none;
}

// Cells about faces whose crossings can not be joined; only faces with a cell that is `nearby`
// count (null: all).
std::vector<std::int32_t> badly_crossed(const ContourCells& cells, const CrossedGrid& grid,
                                        const std::vector<char>* nearby) {
  const auto edge_of = [&](std::int32_t k) -> const MinimalEdge& { return at(grid.edges, k); };
  std::vector<std::int32_t> bad;
  for (const CellFace& face : grid.faces) {
    if (nearby && !at(*nearby, face.low) && !at(*nearby, face.high)) continue;
    if (has_all_edges(cells, face) && joining(cells, face, edge_of) == Joining::none)
      bad.insert(bad.end(), {face.low, face.high});
  }
  return bad;
}

}  // namespace

CrossedGrid split_badly_crossed(ContourOctree& tree) {
  CrossedGrid grid = crossed_grid(tree);
  std::size_t count = tree.split(badly_crossed(tree, grid, nullptr));
  if (count == 0) return grid;
  while (count > 0) {
    std::vector<char> nearby;
    grid.edges = tree.crossing_edges_near(tree.new_leaves(), nearby);
    grid.faces = tree.faces(grid.edges);
    count = tree.split(badly_crossed(tree, grid, &nearby));
  }
  return crossed_grid(tree);
}

void ContourSurface::find_loops(CrossedGrid grid) {
  faces_ = std::move(grid.faces);
  find_crossings(grid.edges);
  find_segments();
  join_loops();
}

void ContourSurface::find_crossings(const std::vector<MinimalEdge>& edges) {
  crossings_.assign(edges.size(), {});
  for (std::size_t k = 0; k < edges.size(); ++k) crossings_[k].edge = edges[k];
  if (!options_.remember) {
    parallel_for(
        crossings_.size(), options_.threads,
        [&](std::size_t k) { find_crossing_of(crossings_[k]); }, 64);
    return;
  }
  std::vector<std::int32_t> ids(edges.size());
  std::vector<std::uint8_t> is_new(edges.size());
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const auto [id, fresh] =
        known_.insert(edge_key(edges[k]), static_cast<std::int32_t>(found_.size()));
    ids[k] = id;
    is_new[k] = fresh;
    if (fresh) found_.emplace_back();
  }
  parallel_for(
      crossings_.size(), options_.threads,
      [&](std::size_t k) {
        Crossing& c = crossings_[k];
        Found& found = found_[static_cast<std::size_t>(ids[k])];
        if (!is_new[k]) {
          c.position = found.position;
          c.at = found.at;
          return;
        }
        find_crossing_of(c);
        found = {c.position, c.at};
      },
      64);
}

void ContourSurface::find_crossing_of(Crossing& c) const {
  std::int32_t cell = c.edge.cells[0];
  for (const std::int32_t other : c.edge.cells)
    if (cells_.size_of(other) < cells_.size_of(cell)) cell = other;
  const Vec3 low = low_end(cells_.lattice(), c.edge), high = high_end(cells_.lattice(), c.edge);
  const Probe p = probe(cell);
  auto [f, g] = cells_.offsets(c.edge);
  if (std::isinf(f)) f = p.offset(low);
  if (std::isinf(g)) g = p.offset(high);
  // Tiles know rounded offsets or none: the result may not depend on which.
  f = static_cast<float>(f);
  g = static_cast<float>(g);
  const FoundCrossing x = c.edge.low_inside ? find_crossing(p, {low, f}, {high, g})
                                            : find_crossing(p, {high, g}, {low, f});
  c.at = x.at;
  c.position = low;
  mrsim::component(c.position, c.edge.axis) =
      mrsim::component(snap_inside(x.position, {low, high}), c.edge.axis);
}

std::int32_t ContourSurface::face_cell(const CellFace& face) const {
  return smaller_cell(cells_, face);
}

Box3 ContourSurface::face_box(const CellFace& face) const {
  const std::int32_t cell = face_cell(face);
  Box3 b = cells_.box(cell);
  const double plane =
      mrsim::component(cell == face.low ? b.hi : b.lo, static_cast<int>(face.axis));
  mrsim::component(b.lo, face.axis) = mrsim::component(b.hi, face.axis) = plane;
  return b;
}

void ContourSurface::find_segments() {
  segments_.clear();
  segments_.reserve(faces_.size());
  const auto edge_of = [&](std::int32_t k) -> const MinimalEdge& { return at(crossings_, k).edge; };
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const CellFace& face = faces_[f];
    if (!has_all_edges(cells_, face)) continue;
    const Joining j = joining(cells_, face, edge_of);
    MRSIM_ASSERT(j != Joining::none);
    if (j == Joining::two)
      add_segment(static_cast<std::int32_t>(f), face.crossings[0], face.crossings[1]);
    else
      pair_four(static_cast<std::int32_t>(f));
  }
}

void ContourSurface::add_segment(std::int32_t f, std::int32_t from, std::int32_t to) {
  const CellFace& face = at(faces_, f);
  for (const std::int32_t end : {from, to}) {
    Crossing& c = crossings_[static_cast<std::size_t>(end)];
    for (int i = 0; i < 4; ++i) {
      const std::int32_t a = c.cell(i), b = c.cell((i + 1) & 3);
      if ((a == face.low && b == face.high) || (a == face.high && b == face.low))
        c.segments[i] = static_cast<std::int32_t>(segments_.size());
    }
  }
  Segment s;
  s.face = f;
  s.from = from;
  s.to = to;
  segments_.push_back(s);
}

// Crossings on all four sides: the side of the surface on which the face's centre lies is
// connected, the two corners of the other are cut off.
void ContourSurface::pair_four(std::int32_t f) {
  const CellFace& face = at(faces_, f);
  const Box3 b = face_box(face);
  const int u = (face.axis + 1) % 3, v = (face.axis + 2) % 3;
  std::int32_t side[4] = {};  // low v, high u, high v, low u: counter-clockwise
  for (const std::int32_t k : face.crossings) {
    const Crossing& c = at(crossings_, k);
    const int across = c.edge.axis == u ? v : u;
    const bool high = mrsim::component(c.position, across) > mrsim::component(b.lo, across);
    side[c.edge.axis == u ? (high ? 2 : 0) : (high ? 1 : 3)] = k;
  }
  // The corner between sides 3 and 0 is the low end of side 0's edge.
  const Crossing& first = at(crossings_, side[0]);
  const bool corner_inside = first.edge.low_inside;
  const bool center_inside = is_inside(probe(face_cell(face)).sample(0.5 * (b.lo + b.hi)).distance);
  const int shift =
      corner_inside != center_inside ? 3 : 0;  // cut off corners 3-0 and 1-2, or others
  for (int k = 0; k < 2; ++k)
    add_segment(f, side[(shift + 2 * k) & 3], side[(shift + 2 * k + 1) & 3]);
}

void ContourSurface::join_loops() {
  std::vector<std::int32_t> parent(4 * crossings_.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto slot = [&](std::int32_t crossing, std::int32_t cell) {
    for (int i = 0; i < 4; ++i)
      if (at(crossings_, crossing).cell(i) == cell) return 4 * crossing + i;
    MRSIM_ASSERT(false);
    return 0;
  };
  for (std::size_t k = 0; k < crossings_.size(); ++k)
    for (int i = 0; i < 4; ++i)
      if (crossings_[k].cell(i) == crossings_[k].cell((i + 1) & 3))
        join(parent, static_cast<std::int32_t>(4 * k) + i,
             static_cast<std::int32_t>(4 * k) + ((i + 1) & 3));
  for (const Segment& s : segments_) {
    const CellFace& face = at(faces_, s.face);
    join(parent, slot(s.from, face.low), slot(s.to, face.low));
    join(parent, slot(s.from, face.high), slot(s.to, face.high));
  }
  loops_.clear();
  loops_in_cell_.assign(cells_.size(), 0);
  std::vector<std::int32_t> loop_of_root(parent.size(), -1);
  crowded_.clear();
  for (std::size_t k = 0; k < crossings_.size(); ++k)
    for (int i = 0; i < 4; ++i) {
      const std::int32_t root = find(parent, static_cast<std::int32_t>(4 * k) + i);
      std::int32_t& id = loop_of_root[static_cast<std::size_t>(root)];
      if (id < 0) {
        id = static_cast<std::int32_t>(loops_.size());
        loops_.emplace_back();
        loops_.back().cell = crossings_[k].cell(i);
        if (++loops_in_cell_[static_cast<std::size_t>(loops_.back().cell)] == 2 &&
            cells_.is_complete(loops_.back().cell))
          crowded_.push_back(loops_.back().cell);
      }
      crossings_[k].loops[i] = id;
      Loop& loop = loops_[static_cast<std::size_t>(id)];
      if (loop.crossings.empty() || loop.crossings.back() != static_cast<std::int32_t>(k))
        loop.crossings.push_back(static_cast<std::int32_t>(k));
    }
  for (std::size_t s = 0; s < segments_.size(); ++s) {
    const CellFace& face = at(faces_, segments_[s].face);
    for (const std::int32_t cell : {face.low, face.high}) {
      const std::int32_t root = find(parent, slot(segments_[s].from, cell));
      loops_[static_cast<std::size_t>(at(loop_of_root, root))].segments.push_back(
          static_cast<std::int32_t>(s));
    }
  }
}

}  // namespace mrsim::detail
