// The first motion that removes each voxel, from the staircases of columns (cut_heights.h).
#pragma once

#include "removal/history/cut_heights.h"
#include "removal/history/cut_sink.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrsim {

/// What a motion first removes, voxel by voxel, from staircases: where has_height_history() holds,
/// a voxel is removed where its centre lies above the bottom of a sweep.
class StaircaseWalker {
 public:
  StaircaseWalker(const PartField& field, double voxel);
  std::size_t tiles() const { return grid_.tiles(); }
  /// The voxels of one tile that belong to the stock, and some about them, in cells of 8 voxels
  /// each way. Tiles may be walked at once.
  void walk(std::size_t tile, CutSink& sink) const;

 private:
  void hand_on(std::size_t tile, const std::vector<std::int32_t>& cut, CutSink& sink) const;

  const PartField& field_;
  CutLattice lattice_;
  HeightGrid grid_;
  SweepUndersides tools_;
  std::vector<std::vector<std::uint32_t>> sweeps_;  // by tile
  std::int32_t bottom_ = 0, deep_ = 0;              // first voxel of a column, and their count
};

}  // namespace mrsim
