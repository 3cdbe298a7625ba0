// How much each motion removes, summed over the voxels of the stock.
#pragma once

#include "removal/history/cut_walk.h"
#include <mrsim/options.h>
#include <mrsim/types.h>

#include <cstddef>
#include <vector>

namespace mrsim {

/// The lattice on which the history of a part is made: the half plane where stock and sweeps are
/// turned.
CutLattice history_lattice(const PartField& field, double voxel);

/// Walks one block of kBlockVoxels^3 in space. `sweeps`: all that reach the block or half a voxel
/// beyond, ascending. Adds the mm^3 that each of them removes to `removed`; `sink` may be null.
void walk_block(const PartField& field, const CutLattice& lattice,
                const std::array<std::int32_t, 3>& origin, std::span<const std::uint32_t> sweeps,
                CutSink* sink, std::span<double> removed);

/// The extents of what motions remove, where they are wanted.
struct CutExtents {
  std::vector<CutFrame> frames;    ///< by motion
  std::vector<CutExtent> extents;  ///< by motion: filled in
};

/// mm^3 by motion, 0 for those that remove nothing; the same bits on any number of threads.
/// Requires: lattice.voxel > 0, all motions of the field below `motions`. Throws Error "memory",
/// "cancelled". `sink`, where given, takes each voxel of the stock once, from several threads at
/// the same time. Only one of `sink` and `extents` may be given.
std::vector<double> removed_volumes(const PartField& field, const CutLattice& lattice,
                                    std::size_t motions, int threads, CutSink* sink = nullptr,
                                    const Progress& progress = {}, CutExtents* extents = nullptr);

}  // namespace mrsim
