#include "removal/part/stock.h"

#include "core/numbers/rounding.h"
#include "core/numbers/vec.h"
#include "core/process/error.h"
#include "core/process/memory_limit.h"
#include "removal/part/stock_grid.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kVoxelsOfRadius = 8;  // of the smallest cutter, at least

// The sweeps that can decide d at p: those of the block that holds p, or all where no block does.
Candidates candidates_at(const StockGrid& grid, const Vec3& p) {
  const std::size_t block = grid.index->find(p);
  if (block == grid.index->size()) return grid.field->all();
  const auto ids = grid.index->sweeps(block);
  return {ids.begin(), ids.end()};
}

}  // namespace

Stock::Stock(std::unique_ptr<StockGrid> grid) : grid_(std::move(grid)) {}
Stock::Stock(Stock&&) noexcept = default;
Stock& Stock::operator=(Stock&&) noexcept = default;
Stock::~Stock() = default;

double Stock::voxel() const { return grid_->voxel; }
const ExactField& Stock::field() const { return *grid_->field; }
std::size_t Stock::active_voxels() const {
  return grid_->voxels ? grid_->voxels->active_voxels() : 0;
}
std::size_t Stock::memory() const {
  return (grid_->voxels ? grid_->voxels->memory() : 0) + grid_->index->memory();
}

double Stock::memory_expected() const { return grid_->plan.expected; }
double Stock::list_room() const { return grid_->plan.list_room; }
double Stock::memory_whole() const { return grid_->plan.whole; }
std::size_t Stock::memory_limit() const { return grid_->plan.limit; }
bool Stock::in_slabs() const { return grid_->plan.in_slabs; }

void Stock::plan_grid_mesh(double voxel, double cut_cells, const std::string& no_slabs) {
  CarvePlan plan = grid_->asked;
  plan.voxel = voxel;
  plan.grid_mesh = true;
  plan.cut_cells = cut_cells;
  // A grid that is kept has been sampled.
  plan.no_slabs = plan.keep_grid ? "the voxels of the stock are kept" : no_slabs;
  grid_->asked = plan;
  grid_->plan = plan_memory(*grid_->field, grid_->motions, plan);
}

double Stock::mesh_room() const { return grid_->plan.mesh_room; }

double Stock::tile_room() const { return grid_->plan.tile_room; }

void Stock::plan_slabs() {
  if (!grid_->asked.no_slabs.empty())
    throw Error("memory",
                fmt::format("the mesh takes more than {}, which the limit of {} leaves "
                            "for it; {}",
                            size_text(mesh_room()), size_text(static_cast<double>(memory_limit())),
                            grid_->asked.no_slabs));
  CarvePlan plan = grid_->asked;
  plan.slabs = true;
  grid_->plan = plan_memory(*grid_->field, grid_->motions, plan);
}

double Stock::distance(const Vec3& p) const {
  return field().sample(p, candidates_at(*grid_, p)).distance;
}

Vec3 Stock::gradient(const Vec3& p) const {
  return field().gradient(p, field().sample(p, candidates_at(*grid_, p)));
}

std::int32_t Stock::owner(const Vec3& p) const {
  return field().sample(p, candidates_at(*grid_, p)).owner;
}

// The result is the double nearest to its decimal form.
double round_down_voxel(double x) {
  double scale = 1;  // x * scale or x / scale lies in [1, 10)
  const bool below_one = x < 1;
  while (below_one ? x * scale < 1 : x / scale >= 10) scale *= 10;
  const double digits = below_one ? x * scale : x / scale;
  double step = 1;
  for (const double candidate : {2.0, 2.5, 5.0})
    if (candidate <= digits * (1 + kShareRounding))
      step = candidate;  // the series itself stays, whatever its rounding
  return below_one ? step / scale : step * scale;
}

VoxelChoice default_voxel(const StockShape& shape, double smallest_radius) {
  const Vec3 size = shape.box.hi - shape.box.lo;
  const double longest = std::max({size.x, size.y, size.z});
  VoxelChoice choice{longest / kVoxelsOfSide,
                     fmt::format("longest side {:.6g} mm / {:g}", longest, kVoxelsOfSide)};
  if (smallest_radius > 0 && smallest_radius / kVoxelsOfRadius < choice.voxel)
    choice = {
        smallest_radius / kVoxelsOfRadius,
        fmt::format("smallest cutter radius {:.6g} mm / {:g}", smallest_radius, kVoxelsOfRadius)};
  choice.voxel = round_down_voxel(choice.voxel);
  choice.reason += ", rounded down";
  return choice;
}

}  // namespace mrsim
