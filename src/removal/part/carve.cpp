#include "core/numbers/vec.h"
#include "removal/field/lattice.h"
#include "removal/part/memory_plan.h"
#include "removal/part/stock.h"
#include "removal/part/stock_grid.h"

#include <algorithm>
#include <utility>

namespace mrsim {
namespace {

// Blocks along the longest side that lists and collisions gain by; where voxels are sampled, blocks
// are theirs.
constexpr double kMostBlocks = 64;

double index_voxel(const StockSolid& solid, const CarvePlan& options) {
  if (options.keep_grid) return options.voxel;
  const Vec3 size = solid.bounds().hi - solid.bounds().lo;
  return std::max(options.voxel, std::max({size.x, size.y, size.z}) / (kMostBlocks * kBlockVoxels));
}

}  // namespace

Stock carve(const StockShape& shape, std::span<const Motion> motions, std::span<const Tool> tools,
            const CarvePlan& options, const VoxelDecision& decide) {
  auto grid = std::make_unique<StockGrid>();
  StockSolid solid(shape);
  const SweepSelection cuts{.top = solid.bounds().hi.z};
  require_table(motions, tools, cuts);
  SweepTable sweeps(motions, tools, cuts, options.threads);
  grid->field = std::make_unique<PartField>(std::move(solid), std::move(sweeps), options.threads);
  const PartField& field = *grid->field;
  require_survey(field.sweeps(), options.threads);
  CarvePlan chosen = options;
  if (decide) decide(field, chosen);
  if (chosen.voxel == 0)
    chosen.voxel = default_voxel(shape, field.sweeps().smallest_radius()).voxel;
  grid->plan = plan_memory(field, motions.size(), chosen);
  grid->asked = chosen;
  grid->motions = motions.size();
  grid->voxel = chosen.voxel;
  grid->index =
      std::make_unique<BlockIndex>(field, index_voxel(field.solid(), chosen),
                                   kBandVoxels * grid->voxel, grid->plan.limit, chosen.threads);
  if (chosen.keep_grid && !grid->plan.in_slabs)
    grid->voxels = sample_voxels(field, *grid->index, grid->voxel, chosen);
  return Stock(std::move(grid));
}

}  // namespace mrsim
