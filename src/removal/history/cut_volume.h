// The history of a stock as an array: for each voxel the motion that first removes it.
#pragma once

#include "removal/history/cut_sink.h"
#include "removal/part/part_field.h"
#include <mrsim/options.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrsim {

struct CutVolume {
  CutLattice lattice;
  /// Lattice coordinates of the first voxel, multiples of 8 in space; at least one layer of
  /// kNeverThere voxels surrounds the stock, except at the axis of a half plane.
  std::array<std::int32_t, 3> first{};
  std::array<std::int32_t, 3> size{};  ///< voxels by axis; in the half plane size[1] is 1
  /// By voxel, z fastest, then y: index of the motion that removes it, kStillThere or kNeverThere.
  std::vector<std::int32_t> cut;
  std::vector<double> removed;  ///< mm^3 by motion, as removed_volumes() gives

  std::size_t index(int x, int y, int z) const {
    return (std::size_t(x) * std::size_t(size[1]) + std::size_t(y)) * std::size_t(size[2]) +
           std::size_t(z);
  }
  /// Centre of a voxel, mm.
  Vec3 center(int x, int y, int z) const {
    return lattice.position({first[0] + x, first[1] + y, first[2] + z});
  }
};

/// Same result on any number of threads. Requires: lattice.voxel > 0, all motions of the field
/// below `motions`. Memory: 4 bytes a voxel of the stock's bounds. Throws Error "memory",
/// "cancelled".
CutVolume make_cut_volume(const PartField& field, const CutLattice& lattice, std::size_t motions,
                          int threads, const Progress& progress = {});

}  // namespace mrsim
