#include "removal/history/staircase_walker.h"

#include "core/numbers/vec.h"
#include "removal/field/lattice.h"
#include "removal/stock/stock_solid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mrsim {
namespace {

constexpr int kCell = 8;  // voxels of a cell that is handed on, each way

}  // namespace

StaircaseWalker::StaircaseWalker(const PartField& field, double voxel)
    : field_(field),
      lattice_{voxel, false},
      grid_(field.bounds(), lattice_),
      tools_(field.sweeps()),
      sweeps_(grid_.sweeps_of_tiles(field.sweeps())) {
  const auto cell_of = [&](double z) {
    return static_cast<std::int32_t>(
        std::floor(lattice_floor(voxel, z, kLatticeShift.z) / double(kCell)));
  };
  bottom_ = cell_of(field.bounds().lo.z) * kCell;
  deep_ = (cell_of(field.bounds().hi.z) + 1) * kCell - bottom_;
}

void StaircaseWalker::walk(std::size_t tile, CutSink& sink) const {
  const std::array<std::int32_t, 2> origin = grid_.origin(tile);
  const auto deep = static_cast<std::size_t>(deep_);
  const Box3& stock = field_.bounds();
  std::vector<std::int32_t> cut(std::size_t(HeightGrid::kTile) * HeightGrid::kTile * deep,
                                kNeverThere);
  const auto z = [&](std::int32_t k) { return lattice_.position({0, 0, bottom_ + k}).z; };
  std::int32_t first = 0, end = deep_;  // layers with voxels of the stock
  while (first < end && !(z(first) > stock.lo.z)) ++first;
  while (end > first && !(z(end - 1) < stock.hi.z)) --end;
  for (int x = 0; x < HeightGrid::kTile; ++x)
    for (int y = 0; y < HeightGrid::kTile; ++y) {
      const Vec3 p = lattice_.position({origin[0] + x, origin[1] + y, 0});
      if (!(field_.solid().plan_distance(p.x, p.y) < 0)) continue;
      const auto column = cut.begin() + std::ptrdiff_t((x * HeightGrid::kTile + y) * deep);
      std::fill(column + first, column + end, kStillThere);
    }
  const std::vector<std::uint32_t>& sweeps = sweeps_[tile];
  const Vec2 corner = grid_.corner(tile);
  const double h = lattice_.voxel;
  // Bottoms of successive steps only get lower, so all above the first voxel that an earlier step
  // has removed is gone.
  const auto remove = [&](const Vec2& at, std::uint32_t index, double bottom) {
    const auto x = std::size_t(std::lround((at.x - corner.x) / h)),
               y = std::size_t(std::lround((at.y - corner.y) / h));
    std::int32_t* column = cut.data() + (x * HeightGrid::kTile + y) * deep;
    auto k = std::max(static_cast<std::int32_t>(std::floor((bottom - z(0)) / h)), first);
    while (k < end && z(k) < bottom) ++k;
    const std::int32_t motion = field_.sweeps().motion(sweeps[index]);
    for (; k < end && column[k] == kStillThere; ++k) column[k] = motion;
  };
  if (!sweeps.empty()) HeightWalker(field_, tools_).walk_steps(grid_, tile, sweeps, remove);
  hand_on(tile, cut, sink);
}

void StaircaseWalker::hand_on(std::size_t tile, const std::vector<std::int32_t>& cut,
                              CutSink& sink) const {
  const std::array<std::int32_t, 2> origin = grid_.origin(tile);
  std::array<std::int32_t, std::size_t(kCell) * kCell * kCell> cell;
  for (int x = 0; x < HeightGrid::kTile; x += kCell)
    for (int y = 0; y < HeightGrid::kTile; y += kCell)
      for (int z = 0; z < deep_; z += kCell) {
        for (int i = 0; i < kCell; ++i)
          for (int j = 0; j < kCell; ++j)
            std::copy_n(
                cut.begin() + ((x + i) * HeightGrid::kTile + y + j) * std::ptrdiff_t(deep_) + z,
                kCell, cell.begin() + (i * kCell + j) * kCell);
        const CutCell whole{{origin[0] + x, origin[1] + y, bottom_ + z}, kCell};
        if (std::all_of(cell.begin(), cell.end(), [&](std::int32_t c) { return c == cell[0]; }))
          sink.tile(whole, cell[0]);
        else
          sink.leaf(whole, cell.data());
      }
}

}  // namespace mrsim
