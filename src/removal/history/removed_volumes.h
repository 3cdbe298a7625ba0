// How much each motion removes, summed over the voxels of the stock.
#pragma once

#include "removal/history/cut_walk.h"
#include <mrsim/types.h>

#include <cstddef>
#include <vector>

namespace mrsim {

/// The lattice on which the history of a part is made: the half plane where stock and sweeps are
/// turned.
CutLattice history_lattice(const PartField& field, double voxel);

/// mm^3 by motion, 0 for those that remove nothing; the same bits on any number of threads.
/// Requires: lattice.voxel > 0, all motions of the field below `motions`. Throws Error "memory".
std::vector<double> removed_volumes(const PartField& field, const CutLattice& lattice,
                                    std::size_t motions, int threads);

}  // namespace mrsim
