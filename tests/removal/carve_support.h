// What the carver has made, voxel by voxel, and the obvious carver that it is compared with.
#pragma once

#include "core/numbers/vec.h"
#include "removal/field/lattice.h"
#include "removal/part/stock.h"
#include "removal/part/stock_grid.h"
#include "removal/stock/stock_solid.h"
#include "removal/sweep/sweep_table.h"
#include "removal/vdb/vdb_grid.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <vector>

namespace mrsim::testing {

inline const VdbGrid& grids(const Stock& stock) {
  return static_cast<const VdbGrid&>(*stock.grid().voxels);
}

using Voxel = std::tuple<openvdb::Coord, float, std::int32_t>;
inline std::vector<Voxel> voxels(const Stock& stock) {
  std::vector<Voxel> list;
  openvdb::tree::ValueAccessor<const openvdb::Int32Tree> owner(grids(stock).owner->tree());
  for (auto it = grids(stock).distance->cbeginValueOn(); it; ++it)
    list.emplace_back(it.getCoord(), it.getValue(), owner.getValue(it.getCoord()));
  std::sort(list.begin(), list.end());
  return list;
}

// The obvious carver: every sweep at every voxel.
inline std::vector<Voxel> reference(const StockShape& shape, std::span<const Motion> motions,
                                    std::span<const Tool> tools, double h) {
  const StockSolid solid(shape);
  const SweepTable sweeps(motions, tools, {.top = shape.box.hi.z});
  const double band = kBandVoxels * h;
  const Box3 whole = inflated(solid.bounds(), band + h);
  std::vector<Voxel> list;
  const auto index = [&](const Vec3& p, int a) {
    return int(lattice_floor(h, component(p, a), component(kLatticeShift, a)));
  };
  for (int i = index(whole.lo, 0); i <= index(whole.hi, 0); ++i)
    for (int j = index(whole.lo, 1); j <= index(whole.hi, 1); ++j)
      for (int k = index(whole.lo, 2); k <= index(whole.hi, 2); ++k) {
        const Vec3 p{lattice_position(h, i, kLatticeShift.x),
                     lattice_position(h, j, kLatticeShift.y),
                     lattice_position(h, k, kLatticeShift.z)};
        double least = std::numeric_limits<double>::infinity();
        std::size_t best = 0;
        for (std::size_t s = 0; s < sweeps.size(); ++s)
          if (const double d = sweeps.distance(s, p); d < least) {
            least = d;
            best = s;
          }
        const double stock = solid.distance(p), d = std::max(stock, -least);
        if (std::abs(d) < band)
          list.emplace_back(openvdb::Coord(i, j, k), float(d),
                            stock >= -least ? kStockOwner : sweeps.motion(best));
      }
  std::sort(list.begin(), list.end());
  return list;
}

}  // namespace mrsim::testing
