// The stock: what is left after the sweeps. Exact questions are asked of the recipe it was made
// from (shape, tools, motions); beside it there may be an OpenVDB level set, with an owner for
// every active voxel.
#pragma once

#include "removal/field/field.h"
#include "removal/part/carve_plan.h"
#include <mrsim/types.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace mrsim {

struct StockGrid;  // removal/part/stock_grid.h, for src/removal only

class Stock {
 public:
  explicit Stock(std::unique_ptr<StockGrid> grid);
  Stock(Stock&&) noexcept;
  Stock& operator=(Stock&&) noexcept;
  ~Stock();

  double voxel() const;               ///< mm
  const ExactField& field() const;    ///< the exact part
  std::size_t active_voxels() const;  ///< 0 where none were sampled
  std::size_t memory() const;         ///< bytes of the grids and their lists
  double memory_expected() const;     ///< bytes of the run, as in MemoryPlan
  double memory_whole() const;        ///< bytes of the run, were it not cut into slabs
  double list_room() const;           ///< bytes for lists of an octree, as in MemoryPlan
  std::size_t memory_limit() const;
  bool in_slabs() const;  ///< to save memory: the mesh must not be held as a whole
  const StockGrid& grid() const { return *grid_; }

  /// The mesh will be one on voxels of that size after all, whose cut surface passes about
  /// `cut_cells` of them: plans memory and slabs for it. `no_slabs` as in CarvePlan. Throws Error
  /// "memory" where it does not fit.
  void plan_grid_mesh(double voxel, double cut_cells, const std::string& no_slabs);
  /// Bytes that this mesh may take as a whole.
  double mesh_room() const;
  /// Bytes in which tiles of it may be kept besides.
  double tile_room() const;
  /// Plans the same mesh in slabs, after it has taken more memory in one piece than was expected.
  /// Throws what plan_grid_mesh() throws.
  void plan_slabs();

  /// d, gradient and owner at p from the exact field, through the index over the sweeps.
  double distance(const Vec3& p) const;
  Vec3 gradient(const Vec3& p) const;
  std::int32_t owner(const Vec3& p) const;

 private:
  std::unique_ptr<StockGrid> grid_;
};

/// Voxels along the longest side of a stock, when none is given.
inline constexpr double kVoxelsOfSide = 400;

/// The voxel edge used when none is given, and why ("longest side 100 mm / 400").
struct VoxelChoice {
  double voxel = 0;
  std::string reason;
};
/// The voxel edge for a stock and the smallest cutter radius (mm; 0: none), and why.
VoxelChoice default_voxel(const StockShape& shape, double smallest_radius);
/// The largest of 1, 2, 2.5, 5 times a power of ten that is not above `voxel`.
double round_down_voxel(double voxel);

/// Sees the exact part before anything depends on the options of its voxels, and may change these.
using VoxelDecision = std::function<void(const ExactField& field, CarvePlan& options)>;

/// Subtracts every cutting motion from the stock; samples what is left where the grid is to be
/// kept. Cost: that of the sweeps and their index, and of the samples, which grows with the
/// surface, not with the volume, and slowly with the number of motions. Throws Error
/// "voxel-invalid", "memory" (the estimate is above the limit, in slabs too), and what SweepTable
/// and sample_voxels throw.
Stock carve(const StockShape& shape, std::span<const Motion> motions, std::span<const Tool> tools,
            const CarvePlan& options = {}, const VoxelDecision& decide = {});

}  // namespace mrsim
