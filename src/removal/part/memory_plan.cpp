#include "removal/part/memory_plan.h"

#include "core/error.h"
#include "core/parallel.h"
#include "core/vec.h"
#include "removal/sweep/turn_tree.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <unistd.h>

namespace mrsim {
namespace {

// Bytes, as measured (docs/removal.md, Memory). A surface voxel column holds 2 * kBandVoxels
// active voxels, in leaves that are about half full, and two triangles of a mesh on the voxels;
// flat sides that a box keeps have few.
constexpr double kProgram = 10e6, kMotion = 400;
constexpr double kTurn = 1500;     ///< the outline that an insert sweeps, besides
constexpr double kOpenVdb = 30e6;  ///< its library
constexpr double kRecipe = 400;    ///< a motion once more, for the file
constexpr double kGridColumn = 130;
constexpr double kCutVoxel = 10;  ///< of the grid "cut", should all of the stock be removed
constexpr double kThread = 12e6, kMeshColumn = 70, kBoxMeshColumn = 20;
constexpr double kFrontTile = 0.45e6;  ///< a tile on the front of those that are done
constexpr double kTileVoxels = 61;
constexpr double kTile = 400;         ///< what is kept of each, by the sizes of its records
constexpr double kMostColumns = 1e9;  ///< of surface voxels; the triangles of a mesh are twice that

std::size_t free_memory() {
  const long pages = ::sysconf(_SC_AVPHYS_PAGES), page = ::sysconf(_SC_PAGE_SIZE);
  return pages > 0 && page > 0 ? static_cast<std::size_t>(pages) * static_cast<std::size_t>(page)
                               : std::size_t(4) << 30;
}

// The tiles of the mesh that a cut across the longest axis meets, were it the stock's whole
// section.
double section_tiles(const StockSolid& stock, double voxel) {
  const Vec3 size = stock.bounds().hi - stock.bounds().lo;
  double sides[3] = {size.x, size.y, size.z};
  std::sort(sides, sides + 3);
  return (sides[0] + 2 * sides[1]) / (voxel * kTileVoxels) + 1;
}

struct Need {
  const StockSolid& stock;
  std::size_t motions, turns;
  const CarveOptions& options;

  double cut_voxels(double voxel) const { return stock.volume() / (voxel * voxel * voxel); }
  double operator()(double voxel, bool in_slabs) const {
    const double columns = stock.area() / (voxel * voxel);
    const double always =
        kProgram + kMotion * static_cast<double>(motions) + kTurn * static_cast<double>(turns);
    double grid = options.keep_grid ? kOpenVdb : 0;
    if (options.keep_grid && !in_slabs)
      grid += columns * kGridColumn + cut_voxels(voxel) * kCutVoxel +
              kRecipe * static_cast<double>(motions);
    if (!options.grid_mesh) return always + grid;
    const double working = kThread * resolve_threads(options.threads) +
                           section_tiles(stock, voxel) * kFrontTile +
                           columns / (kTileVoxels * kTileVoxels) * kTile;
    return always + grid + working +
           (in_slabs ? 0 : columns * (stock.is_box() ? kBoxMeshColumn : kMeshColumn));
  }
};

[[noreturn]] void refuse(const Need& need, double voxel, double available, bool may_slab) {
  double fits = voxel;
  while (need(fits, may_slab) > available &&
         need(fits, may_slab) > 1.001 * need(2 * fits, may_slab))
    fits *= 1.05;
  throw Error(
      "memory",
      fmt::format("a voxel of {:.6g} mm needs about {:.3g} GB for this stock and {} "
                  "motions{}, {:.3g} GB are available; {}{}",
                  voxel, need(voxel, may_slab) / 1e9, need.motions, may_slab ? " in slabs" : "",
                  available / 1e9,
                  need(fits, may_slab) <= available ? fmt::format("{:.3g} mm would fit", fits)
                                                    : "no voxel would fit",
                  may_slab ? "" : "; " + need.options.no_slabs));
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

MemoryPlan plan_memory(const PartField& field, std::size_t motions, const CarveOptions& options) {
  if (!(options.voxel > 0) || !std::isfinite(options.voxel))
    throw Error("voxel-invalid",
                fmt::format("--voxel {} is not a positive length in mm", options.voxel),
                Error::Kind::usage);
  if (options.grid_mesh || options.keep_grid) require_columns(field.solid(), options.voxel);
  const Need need{field.solid(), motions, field.sweeps().turn_tree().size(), options};
  MemoryPlan plan;
  plan.limit = options.max_memory > 0 ? options.max_memory : free_memory();
  plan.expected = plan.whole = need(options.voxel, false);
  const auto available = static_cast<double>(plan.limit);
  if (plan.expected <= available) return plan;
  const bool may_slab = options.no_slabs.empty();
  plan.in_slabs = true;
  plan.expected = need(options.voxel, true);
  if (!may_slab || plan.expected > available) refuse(need, options.voxel, available, may_slab);
  return plan;
}

}  // namespace mrsim
