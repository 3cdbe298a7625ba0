// What a page plays of a run, from its cuts.
#pragma once

#include "removal/part/stock.h"
#include "run/cuts/cuts.h"
#include <mrsim/mrsim.h>

namespace mrsim {

/// Voxels of the longest side / 200. Takes some seconds for programs of 100 000 moves. Throws Error
/// "memory".
Play make_play(const Job& job, const JobResult& result, const Stock& stock, const CutList& cuts);

}  // namespace mrsim
