#include "mesh/tiles/tile_maker.h"

#include "mesh/cells/tile.h"
#include "mesh/surface/dual_surface.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace mrsim::detail {
namespace {

constexpr double kShallowCrease =
    1.0 / 64;  ///< of a voxel: what cutting off a shallow crease may move
constexpr std::int32_t kFirstOwned = CellTile::kFirstOwned;
constexpr std::int32_t kReached = 2;  ///< owned cells, from the border, that triangles of other
                                      ///< tiles may reach into; one more than they do

}  // namespace

bool reaches(const Tile& tile, const CellPlace& cell, const Lattice& lattice) {
  const std::int32_t unit = lattice.per_voxel();
  for (int a = 0; a < 3; ++a) {
    const std::int32_t i = component(cell.origin, a) - component(tile.first, a) * unit;
    if (i < 0 || i >= kTileCells * unit) return false;
  }
  return true;
}

// The memory in which one thread makes its tiles, one after another.
struct TileMaker::Memory {
  Memory(const ExactField& field, const Lattice& lattice, const CommonLists& common)
      : cells(field, lattice, &common),
        surface(field, cells, {.shallow = kShallowCrease * lattice.voxel(), .threads = 1}) {}
  CellTile cells;
  DualSurface surface;
};

TileMaker::TileMaker(const ExactField& field, const Lattice& lattice, const CommonLists& common,
                     bool measure)
    : field_(field), lattice_(lattice), common_(common), measure_(measure) {}

TileMaker::~TileMaker() = default;

std::unique_ptr<TileMaker::Memory> TileMaker::take_memory() {
  const std::scoped_lock lock(mutex_);
  if (memories_.empty()) return std::make_unique<Memory>(field_, lattice_, common_);
  std::unique_ptr<Memory> memory = std::move(memories_.back());
  memories_.pop_back();
  return memory;
}

void TileMaker::give_memory(std::unique_ptr<Memory> memory) {
  const std::scoped_lock lock(mutex_);
  memories_.push_back(std::move(memory));
}

CellPlace TileMaker::place_of(const SurfaceCells& cells, std::int32_t cell) const {
  return {lattice_.nearest(cells.box(cell).lo), cells.size_of(cell)};
}

// The lower corner of cell number `cell` on the tile's diagonal.
Vec3 TileMaker::corner(const Tile& tile, std::int32_t cell) const {
  return lattice_.position({(tile.first.x + cell) * unit(), (tile.first.y + cell) * unit(),
                            (tile.first.z + cell) * unit()});
}

// The cells of vertices in cells with two pieces of surface; empty where there are none.
std::vector<CellPlace> TileMaker::crowded_vertices(const DualSurface& surface,
                                                   const SurfaceCells& cells,
                                                   const std::vector<std::uint32_t>& id,
                                                   std::size_t count) const {
  std::vector<CellPlace> out;
  if (surface.crowded().empty()) return out;
  out.resize(count);
  const std::set<std::int32_t> crowded(surface.crowded().begin(), surface.crowded().end());
  for (std::size_t v = 0; v < surface.loops().size(); ++v) {
    const std::int32_t cell = surface.loops()[v].cell;
    if (id[v] != ~0u && crowded.count(cell) > 0) out[id[v]] = place_of(cells, cell);
  }
  return out;
}

// Vertices are joined by their coordinates: two pieces of surface with one vertex would touch.
std::vector<CellPlace> TileMaker::touching_cells(const DualSurface& surface,
                                                 const SurfaceCells& cells) const {
  std::vector<CellPlace> out;
  if (surface.crowded().empty()) return out;
  const std::set<std::int32_t> crowded(surface.crowded().begin(), surface.crowded().end());
  std::set<std::tuple<std::int32_t, double, double, double>> seen;
  for (const Loop& loop : surface.loops()) {
    if (crowded.count(loop.cell) == 0 || !cells.is_owned_cell(loop.cell)) continue;
    const Vec3& p = loop.point.position;
    if (!seen.emplace(loop.cell, p.x, p.y, p.z).second) out.push_back(place_of(cells, loop.cell));
  }
  return out;
}

template <class Cells>
MeshDistance TileMaker::measured(const DualSurface& surface, const Cells& cells) const {
  const BaseMesh& base = surface.mesh();
  MeshDistance found;
  for (std::size_t t = 0; t < base.triangles.size(); ++t) {
    const auto& x = base.triangles[t];
    const Crossing& c = surface.crossings()[static_cast<std::size_t>(base.crossings[t])];
    found.add(field_, cells, c.edge, c.at,
              {base.vertices[x[0]], base.vertices[x[1]], base.vertices[x[2]]});
  }
  return found;
}

template <class Cells>
TileMesh TileMaker::collect(const DualSurface& surface, const Cells& cells, const Tile& tile,
                            TileNotes& notes) const {
  const BaseMesh& base = surface.mesh();
  TileMesh out;
  const std::int32_t last = kFirstOwned + kTileOwned - 1;
  const Vec3 inner_low = corner(tile, kFirstOwned), inner_high = corner(tile, last);
  const Vec3 middle = corner(tile, kFirstOwned + kTileOwned / 2);
  std::vector<std::uint32_t> id(base.vertices.size(), ~0u);
  out.vertices.reserve(base.vertices.size());
  out.marks.reserve(base.vertices.size());
  out.triangles.reserve(base.triangles.size());
  out.owners.reserve(base.triangles.size());
  for (std::size_t t = 0; t < base.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& v = id[base.triangles[t][k]];
      if (v == ~0u) {
        v = static_cast<std::uint32_t>(out.vertices.size());
        const Vec3& p = base.vertices[base.triangles[t][k]];
        out.vertices.push_back(
            {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
        out.marks.push_back(tile_marks(p, inner_low, inner_high, middle));
      }
      triangle[k] = v;
    }
    out.triangles.push_back(triangle);
    out.owners.push_back(surface.crossings()[static_cast<std::size_t>(base.crossings[t])].at.owner);
  }
  out.border = border_edges(out);
  notes = {};
  if (measure_) notes.distance = measured(surface, cells);
  CrowdedTriangles crowded = crowded_triangles(
      out.vertices, out.triangles, crowded_vertices(surface, cells, id, out.vertices.size()));
  notes.meeting = crossed_cells(std::vector{CrowdedTile{0, &crowded}}, 1);
  const std::vector<CellPlace> touching = touching_cells(surface, cells);
  notes.meeting.insert(touching.begin(), touching.end());
  keep_outside(crowded, {corner(tile, kFirstOwned + kReached), corner(tile, last - kReached + 1)});
  notes.crowded = std::move(crowded);
  for (const Loop& loop : surface.loops()) notes.cells += cells.is_owned_cell(loop.cell);
  notes.triangles = out.triangles.size();
  return out;
}

void TileMaker::flatten(DualSurface& surface, const SurfaceCells& cells,
                        const std::set<CellPlace>& flat) const {
  std::vector<std::int32_t> out;
  if (!flat.empty())
    for (const std::int32_t cell : surface.crowded())
      if (flat.count(place_of(cells, cell)) > 0) out.push_back(cell);
  surface.flatten_only(out);
}

TileMesh TileMaker::make(const Tile& tile, const MendedCells& mended, const BareTiles& about,
                         TileNotes& notes) {
  const bool has_split = std::ranges::any_of(
      mended.split, [&](const CellPlace& cell) { return reaches(tile, cell, lattice_); });
  if (has_split) return make_split(tile, mended, notes);
  std::unique_ptr<Memory> memory = take_memory();
  TileMesh mesh = make_whole(tile, mended, about, notes, *memory);
  give_memory(std::move(memory));
  return mesh;
}

TileMesh TileMaker::make_whole(const Tile& tile, const MendedCells& mended, const BareTiles& about,
                               TileNotes& notes, Memory& memory) {
  memory.cells.build(tile.first, tile.candidates, CellTile::FlatCells::merged, about);
  memory.surface.find_loops(memory.cells);
  flatten(memory.surface, memory.cells, mended.flat);
  memory.surface.make_triangles();
  TileMesh mesh = collect(memory.surface, memory.cells, tile, notes);
  notes.thin = one_of_each(thin_features(field_, memory.cells, memory.cells.doubtful_edges()));
  return mesh;
}

// A tile of which some cells are split, here or next to it.
TileMesh TileMaker::make_split(const Tile& tile, const MendedCells& mended,
                               TileNotes& notes) const {
  OctreePart part;
  part.origin = {tile.first.x * unit(), tile.first.y * unit(), tile.first.z * unit()};
  part.size = kTileCells * unit();
  part.candidates = tile.candidates;
  part.complete[0] = unit();
  part.complete[1] = (kTileCells - 1) * unit();
  part.owned[0] = kFirstOwned * unit();
  part.owned[1] = (kFirstOwned + kTileOwned) * unit();
  part.common = &common_;
  CellOctree tree(field_, lattice_, part);
  for (std::size_t count = 1; count > 0;) {
    std::vector<std::int32_t> leaves;
    for (std::int32_t n = 0; n < static_cast<std::int32_t>(tree.size()); ++n)
      if (tree.node(n).child < 0 &&
          mended.split.count({tree.node(n).origin, tree.node(n).size}) > 0)
        leaves.push_back(n);
    count = tree.split(std::move(leaves));
  }
  CrossedGrid grid = split_badly_crossed(tree);
  DualSurface surface(field_, tree, {.shallow = kShallowCrease * lattice_.voxel(), .threads = 1});
  surface.find_loops(std::move(grid));
  flatten(surface, tree, mended.flat);
  surface.make_triangles();
  TileMesh mesh = collect(surface, tree, tile, notes);
  for (std::int32_t n = 0; n < static_cast<std::int32_t>(tree.size()); ++n) {
    const OctreeNode& node = tree.node(n);
    if (node.child >= 0 && node.size <= unit() && tree.is_owned(node.origin))
      notes.splits.push_back({node.origin, node.size});
  }
  std::vector<MinimalEdge> doubtful = tree.doubtful_edges();
  std::erase_if(doubtful, [&](const MinimalEdge& e) {
    const auto cell = [&](int a) {
      return (component(e.start, a) - component(part.origin, a)) / unit();
    };
    return !CellTile::tests_edge({cell(0), cell(1), cell(2)}, e.axis);
  });
  notes.thin = one_of_each(thin_features(field_, tree, doubtful));
  return mesh;
}

}  // namespace mrsim::detail
