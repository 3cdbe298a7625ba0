#include "mesh/surface/tile_loops.h"

#include "core/process/error.h"

#include <array>

namespace mrsim::detail {
namespace {

// What the signs at the corners of a cell (bits 4 x + 2 y + z) tell of it.
struct CellCase {
  std::uint16_t edges = 0;  ///< the crossed edges, by kCellEdges
  bool is_plain = false;    ///< these edges make one loop
};

constexpr CellCase cell_case(unsigned corners) {
  CellCase c;
  int part[12] = {}, parts = 0;
  for (int e = 0; e < 12; ++e) {
    const int* d = kCellEdges[e].d;
    const int low = 4 * d[0] + 2 * d[1] + d[2], high = low + (4 >> kCellEdges[e].axis);
    part[e] = e;
    if ((corners >> low & 1) == (corners >> high & 1)) continue;
    c.edges = static_cast<std::uint16_t>(c.edges | 1u << e);
    ++parts;
  }
  c.is_plain = true;
  for (int face = 0; face < 6; ++face) {
    int on[4] = {}, n = 0;
    for (int e = 0; e < 12; ++e)
      if ((c.edges >> e & 1) != 0 && kCellEdges[e].axis != face / 2 &&
          kCellEdges[e].d[face / 2] == face % 2)
        on[n++] = e;
    if (n == 4) c.is_plain = false;
    if (n != 2 || part[on[0]] == part[on[1]]) continue;
    const int from = part[on[0]], to = part[on[1]];
    for (int& p : part)
      if (p == from) p = to;
    --parts;
  }
  c.is_plain = c.is_plain && parts == 1;
  return c;
}

constexpr std::array<CellCase, 256> cell_cases() {
  std::array<CellCase, 256> cases{};
  for (unsigned corners = 0; corners < cases.size(); ++corners) cases[corners] = cell_case(corners);
  return cases;
}
constexpr std::array<CellCase, 256> kCases = cell_cases();

// An edge of a face by the column and the z where it starts beside the face's low corner,
// and the quadrant about it that lies before the face; in the order of all edges.
struct FaceEdge {
  std::int32_t column;
  int z, quadrant;
};
constexpr FaceEdge face_edge(int axis, int x, int y, int z, int quadrant) {
  return {TileEdges::column(axis, x, y), z, quadrant};
}
constexpr FaceEdge kFaceEdges[3][4] = {{face_edge(1, 0, 0, 0, 1), face_edge(2, 0, 0, 0, 2),
                                        face_edge(1, 0, 0, 1, 3), face_edge(2, 0, 1, 0, 0)},
                                       {face_edge(0, 0, 0, 0, 2), face_edge(2, 0, 0, 0, 1),
                                        face_edge(0, 0, 0, 1, 0), face_edge(2, 1, 0, 0, 3)},
                                       {face_edge(0, 0, 0, 0, 1), face_edge(1, 0, 0, 0, 2),
                                        face_edge(0, 0, 1, 0, 3), face_edge(1, 1, 0, 0, 0)}};

bool has_bit(std::uint64_t bits, std::int32_t i) { return (bits >> i & 1) != 0; }

// Bits 1 .. last.
std::uint64_t up_to(std::int32_t last) {
  return ~std::uint64_t(1) & ~std::uint64_t(0) >> (63 - last);
}

}  // namespace

void TileLoops::find(const CellTile& tile) {
  begin_loops();
  loop_crossings_.clear();
  faces_.clear();
  segments_.clear();
  for (const TileSquare& square : tile.squares().all()) add_square(tile, square);
  const std::vector<std::uint64_t> crowded = add_plain_loops(tile);
  add_segments<0>(tile, crowded);
  add_segments<1>(tile, crowded);
  add_segments<2>(tile, crowded);
  for (std::int32_t x = 1; x < kTileCells - 1; ++x)
    for (std::int32_t y = 1; y < kTileCells - 1; ++y)
      for (std::uint64_t left = crowded[static_cast<std::size_t>(x * kTileCells + y)]; left != 0;
           left &= left - 1)
        add_crowded_loops(tile, x, y, std::countr_zero(left));
  list_segments();
}

// Its vertex lies in the middle, on the plane of the face that its crossings are on.
void TileLoops::add_square(const CellTile& tile, const TileSquare& square) {
  const auto id = static_cast<std::int32_t>(loops_.size());
  const CellSquare& s = square.cells;
  const auto is_complete = [](std::int32_t i) { return i >= 1 && i < kTileCells - 1; };
  Loop& loop = new_loop(CellTile::cell_in(square));
  const Crossing* on = nullptr;
  for (std::int32_t row = 0; row < s.size; ++row)
    for (std::int32_t column = 0; column < s.size; ++column) {
      if (row > 0 && row < s.size - 1 && column == 1) column = s.size - 1;  // no edges inside
      if (!is_complete(s.row + row) || !is_complete(s.column + column)) continue;
      const LatticePoint p = square.cell(s.row + row, s.column + column);
      for (const CellEdge& e : kCellEdges) {
        const std::int32_t edges = TileEdges::column(0, p.x, p.y) + e.column, z = p.z + e.d[2];
        if (e.axis != square.axis || !has_bit(tile.crossed().bits(edges), z)) continue;
        Crossing& c = crossings_[static_cast<std::size_t>(tile.crossed().number(edges, z))];
        c.loops[e.quadrant] = id;
        on = &c;
      }
    }
  MRSIM_ASSERT(on != nullptr);  // at its corners
  const int axis = square.axis;
  loop.point.position = tile.middle(square);
  mrsim::component(loop.point.position, axis) =
      snap(mrsim::component(on->position, axis) -
           field_.patch_distance(on->position, on->at) * mrsim::component(on->normal, axis));
  loop.point.faces[0] = on->at;
  loop.point.count = 1;
}

// The loops of cells that have one; bits of the others.
std::vector<std::uint64_t> TileLoops::add_plain_loops(const CellTile& tile) {
  std::vector<std::uint64_t> crowded(kTileCells * kTileCells);
  for (std::int32_t x = 1; x < kTileCells - 1; ++x)
    for (std::int32_t y = 1; y < kTileCells - 1; ++y) {
      const std::uint64_t corners[4] = {tile.inside(x, y), tile.inside(x, y + 1),
                                        tile.inside(x + 1, y), tile.inside(x + 1, y + 1)};
      std::uint64_t any = 0, all = ~any;
      for (const std::uint64_t c : corners) any |= c | c >> 1, all &= c & c >> 1;
      for (std::uint64_t left = any & ~all & ~tile.squares().merged(x, y) & up_to(kTileCells - 2);
           left != 0; left &= left - 1) {
        const std::int32_t z = std::countr_zero(left);
        unsigned signs = 0;
        for (unsigned k = 0; k < 4; ++k)
          signs |= static_cast<unsigned>(corners[k] >> z & 3) << 2 * k;
        // Bit 0 of each pair is the lower corner.
        if (kCases[signs].is_plain)
          add_loop(tile, x, y, z, kCases[signs].edges);
        else
          crowded[static_cast<std::size_t>(x * kTileCells + y)] |= std::uint64_t(1) << z;
      }
    }
  return crowded;
}

// `edges`: bits by kCellEdges.
void TileLoops::add_loop(const CellTile& tile, std::int32_t x, std::int32_t y, std::int32_t z,
                         std::uint32_t edges) {
  const auto id = static_cast<std::int32_t>(loops_.size());
  Loop& loop = new_loop(CellTile::cell_at(x, y, z));
  loop.first_crossing = static_cast<std::uint32_t>(loop_crossings_.size());
  const std::int32_t column = TileEdges::column(0, x, y);
  for (; edges != 0; edges &= edges - 1) {
    const CellEdge& e = kCellEdges[std::countr_zero(edges)];
    const std::int32_t k = tile.crossed().number(column + e.column, z + e.d[2]);
    crossings_[static_cast<std::size_t>(k)].loops[e.quadrant] = id;
    loop_crossings_.push_back(k);
  }
  loop.crossings = static_cast<std::uint32_t>(loop_crossings_.size()) - loop.first_crossing;
}

// Segments in faces that are flat on the axis, about complete cells: where they are creases or help
// to follow loops.
template <int kAxis>
void TileLoops::add_segments(const CellTile& tile, const std::vector<std::uint64_t>& crowded) {
  constexpr const FaceEdge(&kOn)[4] = kFaceEdges[kAxis];
  constexpr auto last = [](int axis) { return axis == kAxis ? kTileCells - 1 : kTileCells - 2; };
  const TileEdges& edges = tile.crossed();
  for (std::int32_t x = 1; x <= last(0); ++x)
    for (std::int32_t y = 1; y <= last(1); ++y) {
      const std::int32_t column = TileEdges::column(0, x, y);
      std::uint64_t bits[4], any = 0, all = ~any;
      for (int k = 0; k < 4; ++k) {
        bits[k] = edges.bits(column + kOn[k].column) >> kOn[k].z;
        any |= bits[k], all &= bits[k];
      }
      // A side of a square needs none.
      const std::uint64_t square = tile.squares().merged(x, y);
      any &= up_to(last(2)) & ~square;
      any &= ~(kAxis == 0   ? tile.squares().merged(x - 1, y)
               : kAxis == 1 ? tile.squares().merged(x, y - 1)
                            : square << 1);
      if (any == 0) continue;
      const auto crowded_at = [&](std::int32_t i) { return crowded[static_cast<std::size_t>(i)]; };
      const std::uint64_t own = crowded_at(column);
      const std::uint64_t needed = all | own |
                                   (kAxis == 0   ? crowded_at(column - kTileCells)
                                    : kAxis == 1 ? crowded_at(column - 1)
                                                 : own << 1);
      for (; any != 0; any &= any - 1) {
        const std::int32_t z = std::countr_zero(any);
        CellFace face;
        for (int k = 0; k < 4; ++k)
          if (has_bit(bits[k], z))
            face.add(edges.number(column + kOn[k].column, z + kOn[k].z), kOn[k].quadrant);
        if (!has_bit(needed, z) &&
            same_face(crossings_[static_cast<std::size_t>(face.crossing(0))].at,
                      crossings_[static_cast<std::size_t>(face.crossing(1))].at))
          continue;
        face.axis = kAxis;
        face.high = CellTile::cell_at(x, y, z);
        face.low = CellTile::cell_at(x - (kAxis == 0), y - (kAxis == 1), z - (kAxis == 2));
        add_segment_if(face, has_bit(needed, z));
      }
    }
}

void TileLoops::add_segment_if(CellFace& face, bool is_needed) {
  const auto crossing = [&](int i) -> const Crossing& {
    return crossings_[static_cast<std::size_t>(face.crossing(i))];
  };
  const bool crease = face.count == 2 && is_crease(face, crossing(0), crossing(1));
  if (!is_needed && !crease) return;
  face.low_complete = cells_.is_complete(face.low);
  face.high_complete = cells_.is_complete(face.high);
  const auto f = static_cast<std::int32_t>(faces_.size());
  faces_.push_back(face);
  if (face.count == 2) {
    add_segment(f, 0, 1);
    segments_.back().is_crease = crease;
    return;
  }
  pair_four(f);
  for (Segment& s : std::span(segments_).last(2))
    s.is_crease = is_crease(face, crossings_[static_cast<std::size_t>(s.from)],
                            crossings_[static_cast<std::size_t>(s.to)]);
}

// Follows the segments about the cell.
void TileLoops::add_crowded_loops(const CellTile& tile, std::int32_t x, std::int32_t y,
                                  std::int32_t z) {
  std::int32_t ids[12];
  std::uint32_t open = 0;
  for (int k = 0; k < 12; ++k) {
    const CellEdge& e = kCellEdges[k];
    const std::int32_t column = TileEdges::column(0, x, y) + e.column;
    ids[k] = -1;
    if (!has_bit(tile.crossed().bits(column), z + e.d[2])) continue;
    ids[k] = tile.crossed().number(column, z + e.d[2]);
    open |= 1u << k;
  }
  while (open != 0) {
    std::uint32_t loop = 0;
    for (std::uint32_t next = open & ~(open - 1); next != 0;) {
      const int k = std::countr_zero(next);
      next &= next - 1;
      loop |= 1u << k;
      const Crossing& c = crossings_[static_cast<std::size_t>(ids[k])];
      for (const int quadrant : {kCellEdges[k].quadrant, kCellEdges[k].quadrant + 3}) {
        const std::int32_t s = c.segments[quadrant & 3];
        MRSIM_ASSERT(s >= 0);
        const Segment& segment = segments_[static_cast<std::size_t>(s)];
        const std::int32_t other = segment.from == ids[k] ? segment.to : segment.from;
        for (int j = 0; j < 12; ++j)
          if (ids[j] == other && (loop >> j & 1) == 0) next |= 1u << j;
      }
    }
    add_loop(tile, x, y, z, loop);
    open &= ~loop;
  }
}

}  // namespace mrsim::detail
