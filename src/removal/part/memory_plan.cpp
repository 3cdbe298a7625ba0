#include "removal/part/memory_plan.h"

#include "core/numbers/vec.h"
#include "core/process/error.h"
#include "core/process/memory_limit.h"
#include "core/process/parallel.h"
#include "removal/columns/sweep_columns.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

namespace mrsim {
namespace {

// Bytes for each of the units named, as measured (docs/performance.md, Memory of the classes).
// Every run: each motion, beside the program itself.
constexpr double kMotion = 320;
// Each sweep or pack of the whole part, and each segment of a path, in the threads' lists of
// candidates; and beyond the expected in the first cells of an octree of two threads, at most.
constexpr double kListed = 100, kSegment = 20, kFirstListed = 70;
// How many times kListed at most, where many sweeps lie close together: once for all threads, for
// each thread, and for each where more than a share of the sweeps matter in one part of the stock.
constexpr double kWholeListed = 2, kThreadListed = 2.5, kSharedListed = 3, kFewShared = 0.25;
// Each triangle of a stock that is a mesh: the tree over it, and what checking the mesh has left.
constexpr double kStockTriangle = 290;
// Each tool, in what SweepTable keeps of its shapes; checked before the table is made.
constexpr double kTool = 9000;
// Each shape in the table; and in the lists that each thread has while it surveys the part.
constexpr double kShape = 4500, kShapeLists = 5000;
// A .vdb: OpenVDB's library, and each motion once more, in the recipe for the file.
constexpr double kOpenVdb = 30e6, kRecipe = 1300;
// A .vdb: each voxel on the stock's surface has a column of 2 * kBandVoxels active voxels, in
// leaves that are about half full.
constexpr double kGridColumn = 130;
// A .vdb: each voxel of the stock's volume in the grid "cut", should all of the stock be removed.
constexpr double kCutVoxel = 10;
// A mesh without slabs: each voxel on the stock's surface.
constexpr double kMeshColumn = 70;
// Bytes that meshing takes. Measured are the sums; how they divide among the members is a guess.
struct MeshCosts {
  double always;      ///< what it takes beside the rest
  double thread;      ///< each thread that makes tiles, whatever the tiles hold
  double tile_cell;   ///< each cell on the surface in the tiles that a thread makes and joins
  double cell_sweep;  ///< each sweep in the list of such a cell: two nodes hold lists for four
  double front_tile;  ///< each tile that is done and waits for its neighbours, at most
  double front_cell;  ///< each cell in such a tile, beside kFlatTile
  double mesh_cell;   ///< without slabs: each voxel that the cuts' surface passes (two triangles)
  double box_column;  ///< without slabs: each voxel on a box, whose flat sides have few triangles
};
constexpr MeshCosts kExpected{3.5e6, 6e6, 580, 10, 0.7e6, 700, 46, 1.2};
// What a run takes at most, for limits: less of it by its size, more by its threads, as limits are
// tight where there is little to mesh.
constexpr MeshCosts kMost{0, 13e6, 600, 16, 0.45e6, 5000, 48, 3};
constexpr double kFlatTile = 0.1e6;
constexpr double kTilesAThread = 2;
// Each cell in which faces of a stock's mesh meet: it is split and remembered.
constexpr double kBentCell = 900;
// Cells in which the stock bends, for each of its triangles: expected, and at most.
constexpr double kBends = 0.6, kMostBends = 1.5;
// Each tile with surface, as long as the run lasts: the sizes of its records.
constexpr double kTile = 400;
// Tiles that are kept while others are mended: each cell, two triangles and a vertex with their
// records; bytes of all at most; and how many times as much as expected.
constexpr double kKeptCell = 46, kMostKept = 96e6, kMoreKept = 2;
constexpr double kTileVoxels = 60;  ///< voxels along a side of a tile, less those that it shares
// Voxels on the stock's surface, the most that a run accepts; a mesh has twice as many triangles.
constexpr double kMostColumns = 1e9;
// With a limit set by the user: factor on the expected cells, where tiles are full, and on what a
// mesh without slabs takes beside the table of sweeps.
constexpr double kMoreCells = 1.4, kMoreMesh = 1.2;
constexpr std::size_t kSample = 4096;  ///< motions from which the memory of all sweeps is estimated

std::size_t free_memory() {
  const long pages = ::sysconf(_SC_AVPHYS_PAGES), page = ::sysconf(_SC_PAGE_SIZE);
  return pages > 0 && page > 0 ? static_cast<std::size_t>(pages) * static_cast<std::size_t>(page)
                               : std::size_t(4) << 30;
}

// About how many tiles of the mesh hold surface: those of the stock's own surface, at most all.
double surface_tiles(const StockSolid& stock, double voxel) {
  const double tile = voxel * kTileVoxels;
  const Vec3 size = stock.bounds().hi - stock.bounds().lo;
  const double all = std::ceil(size.x / tile) * std::ceil(size.y / tile) * std::ceil(size.z / tile);
  return std::min(stock.area() / (tile * tile) + 1, all);
}

// The surface tiles in whole ones: a tile that sticks out of the stock counts by the share inside
// it. Cells divided by this number are those of a full tile.
double whole_tiles(const StockSolid& stock, double voxel) {
  const double tile = voxel * kTileVoxels;
  const Vec3 size = stock.bounds().hi - stock.bounds().lo;
  const auto along = [&](double length) { return std::max(length / tile, 1.0); };
  return std::min(surface_tiles(stock, voxel), along(size.x) * along(size.y) * along(size.z));
}

// The tiles of the mesh on a cut across the stock's longest axis. Tiles are made along that axis,
// so no more of them wait for their neighbours.
double section_tiles(const StockSolid& stock, double voxel) {
  const Vec3 size = stock.bounds().hi - stock.bounds().lo;
  double sides[3] = {size.x, size.y, size.z};
  std::sort(sides, sides + 3);
  return (sides[0] + 2 * sides[1]) / (voxel * kTileVoxels) + 1;
}

double shapes_in(const SweepTable& sweeps) {
  return static_cast<double>(sweeps.columns().shapes.size());
}

double lists_of_shapes(const SweepTable& sweeps, int threads) {
  return kShapeLists * shapes_in(sweeps) * resolve_threads(threads);
}

// The table, and the segments in lists.
double memory_of(const SweepTable& sweeps) {
  return static_cast<double>(sweeps.memory()) + kSegment * static_cast<double>(sweeps.segments());
}

struct Need {
  const StockSolid& stock;
  const SweepTable& sweeps;
  std::size_t listed;  ///< sweeps and packs of the whole part
  std::size_t motions;
  const CarvePlan& options;
  bool is_most = false;  ///< rather too much, for at_most()

  /// With room for more cells where the user has set a limit: that must hold, an estimate may err.
  double at_most(double voxel, bool in_slabs) const {
    if (options.max_memory == 0) return (*this)(voxel, in_slabs);
    CarvePlan more = options;
    more.cut_cells *= kMoreCells;
    const Need worst{stock, sweeps, listed, motions, more, true};
    const double most = worst(voxel, in_slabs);
    return in_slabs ? most : most + (kMoreMesh - 1) * (most - worst.always());
  }

  double always() const {
    return kProgramMemory + kMotion * static_cast<double>(motions) + memory_of(sweeps) +
           (is_most ? most_lists() : 1) * kListed * static_cast<double>(listed) +
           kShape * shapes_in(sweeps) + lists_of_shapes(sweeps, options.threads) +
           kStockTriangle * static_cast<double>(stock.triangles());
  }
  double most_lists() const {
    const double shared = std::max(options.shared_sweeps - kFewShared, 0.0);
    return kWholeListed +
           resolve_threads(options.threads) * (kThreadListed + kSharedListed * shared);
  }
  /// The lists of all tiles, where most sweeps are in each.
  double lists_of_tiles(double tiles) const {
    return tiles * sizeof(std::uint32_t) * static_cast<double>(listed) * options.shared_sweeps;
  }
  /// Cells in which faces of a stock's mesh meet: they are split, and remembered. Long straight
  /// edges pass more of them, which take less.
  double bent_cells(double voxel) const {
    const double most = (is_most ? kMostBends : kBends) * static_cast<double>(stock.triangles());
    return std::min(stock.bent_edges() / voxel, most);
  }
  double cut_voxels(double voxel) const { return stock.volume() / (voxel * voxel * voxel); }
  double operator()(double voxel, bool in_slabs) const {
    const double columns = stock.area() / (voxel * voxel);
    double grid = options.keep_grid ? kOpenVdb + kRecipe * static_cast<double>(motions) : 0;
    if (options.keep_grid && !in_slabs)
      grid += columns * kGridColumn + cut_voxels(voxel) * kCutVoxel;
    return always() + grid + (options.grid_mesh ? mesh(voxel, in_slabs) : 0);
  }

  double mesh(double voxel, bool in_slabs) const {
    const int threads = resolve_threads(options.threads);
    const double finer = options.voxel / voxel, cells = options.cut_cells * finer * finer;
    const double tiles = surface_tiles(stock, voxel);
    const double tile_cells = std::clamp(options.cut_layers * kTileVoxels * kTileVoxels,
                                         cells / whole_tiles(stock, voxel), std::max(cells, 1.0));
    const MeshCosts& costs = is_most ? kMost : kExpected;
    const double working =
        costs.always +
        threads * (kTilesAThread * costs.tile_cell + costs.cell_sweep * options.block_sweeps) *
            tile_cells +
        (is_most ? threads : std::min<double>(threads, std::ceil(tiles))) * costs.thread +
        section_tiles(stock, voxel) *
            std::min(costs.front_tile, kFlatTile + costs.front_cell * tile_cells) +
        tiles * kTile + (is_most ? lists_of_tiles(tiles) : 0) + kBentCell * bent_cells(voxel);
    return in_slabs ? working : working + whole_mesh(voxel);
  }
  /// All tiles of the mesh, if they are kept.
  double kept_tiles() const {
    return kKeptCell * (options.cut_cells +
                        stock.area() / (options.voxel * options.voxel) * (stock.is_box() ? 0 : 1));
  }
  double whole_mesh(double voxel) const {
    const double finer = options.voxel / voxel, cells = options.cut_cells * finer * finer;
    const MeshCosts& costs = is_most ? kMost : kExpected;
    return costs.mesh_cell * cells +
           stock.area() / (voxel * voxel) * (stock.is_box() ? costs.box_column : kMeshColumn);
  }
};

// Searches upwards: tiles grow with the voxel, so a slightly coarser one may need more memory.
[[noreturn]] void refuse(const Need& need, double voxel, double available, bool may_slab) {
  const Vec3 size = need.stock.bounds().hi - need.stock.bounds().lo;
  const double coarsest = std::max({size.x, size.y, size.z});
  double fits = voxel;
  while (fits < coarsest && need.at_most(fits, may_slab) > available) fits *= 1.05;
  throw Error("memory",
              fmt::format("a voxel of {:.6g} mm needs up to {} for this stock and {} "
                          "motions{}, {} are available; {}{}",
                          voxel, size_text(need.at_most(voxel, may_slab)), need.motions,
                          may_slab ? " in slabs" : "", size_text(available),
                          need.at_most(fits, may_slab) <= available
                              ? fmt::format("{:.3g} mm would fit", fits)
                              : "no voxel would fit: a larger --max-memory, or fewer --threads",
                          may_slab ? "" : "; " + need.options.no_slabs));
}

std::set<int> tools_of(std::span<const Motion> motions) {
  std::set<int> out;
  for (const Motion& m : motions) out.insert(out.end(), m.tool);
  return out;
}

// Slabs bound the memory, not the time.
void require_columns(const StockSolid& stock, double voxel) {
  const double columns = stock.area() / (voxel * voxel);
  if (columns <= kMostColumns) return;
  throw Error(
      "voxel-too-small",
      fmt::format("a voxel of {:.6g} mm divides this stock's surface into {:.3g} squares, "
                  "{:.3g} are the most; --voxel {:.3g} or more",
                  voxel, columns, kMostColumns, 1.01 * std::sqrt(stock.area() / kMostColumns)));
}

}  // namespace

void require_table(std::span<const Motion> motions, std::span<const Tool> tools,
                   const SweepSelection& selection) {
  if (tools.size() > 100) {
    const auto used = static_cast<double>(tools_of(motions).size());
    require_memory(kTool * used, fmt::format("what {} tools sweep", used));
  }
  if (motions.size() < 2 * kSample) return;
  std::vector<Motion> some;
  for (std::size_t k = 0; k < kSample; ++k) some.push_back(motions[motions.size() / kSample * k]);
  const SweepTable sample(some, tools, selection);
  const double share = static_cast<double>(motions.size()) / kSample;
  require_memory(share * memory_of(sample),
                 fmt::format("what the tools sweep along {} motions", motions.size()));
}

void require_survey(const SweepTable& sweeps, int threads) {
  require_memory(lists_of_shapes(sweeps, threads),
                 fmt::format("a survey of what {} shapes of tools cut", shapes_in(sweeps)),
                 "fewer --threads take less");
}

MemoryPlan plan_memory(const PartField& field, std::size_t motions, const CarvePlan& options) {
  if (!(options.voxel > 0) || !std::isfinite(options.voxel))
    throw Error("voxel-invalid",
                fmt::format("--voxel {} is not a positive length in mm", options.voxel),
                Error::Kind::usage);
  if (options.grid_mesh || options.keep_grid) require_columns(field.solid(), options.voxel);
  const Need need{field.solid(), field.sweeps(), field.all().size(), motions, options};
  MemoryPlan plan;
  plan.limit = options.max_memory > 0 ? options.max_memory : free_memory();
  plan.expected = plan.whole = need(options.voxel, false);
  plan.list_room = kFirstListed * static_cast<double>(need.listed) *
                   std::max(1.0, 0.5 * resolve_threads(options.threads));
  const auto available = static_cast<double>(plan.limit);
  plan.mesh_room = available - (plan.whole - need.whole_mesh(options.voxel));
  const double left = available - need.at_most(options.voxel, false);
  if (!options.slabs && left >= 0) {
    if (options.grid_mesh)
      plan.tile_room = std::min({left, kMostKept, kMoreKept * need.kept_tiles()});
    plan.expected += std::min(plan.tile_room, need.kept_tiles());
    plan.mesh_room -= plan.tile_room;
    return plan;
  }
  const bool may_slab = options.no_slabs.empty();
  plan.in_slabs = true;
  plan.expected = need(options.voxel, true);
  if (!may_slab || need.at_most(options.voxel, true) > available)
    refuse(need, options.voxel, available, may_slab);
  return plan;
}

}  // namespace mrsim
