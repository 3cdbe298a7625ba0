// The history of a run: what its motions remove (removal/history), with the time they take.
#pragma once

#include "removal/part/stock.h"
#include "run/cuts/cuts.h"
#include <mrsim/mrsim.h>

namespace mrsim {

/// The voxel of the summary's history, mm: longest side / 200, coarser where that would take more
/// than a fixed count of columns. `voxel`: that of the run, which is never refined.
double summary_voxel(const StockShape& shape, const CutList& cuts, double voxel);

/// The side of the summary's columns where all sweeps leave heights, mm: of a fixed count of
/// columns that cover the stock in plan.
double summary_column(const StockShape& shape, const CutList& cuts);

/// What the motions of `result.program` remove of the stock as they find it. Empty where none is
/// wanted.
History make_history(const Job& job, const JobResult& result, const Stock& stock,
                     const CutList& cuts);

}  // namespace mrsim
