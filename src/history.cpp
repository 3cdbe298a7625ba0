#include "history.h"

#include "core/vec.h"
#include "removal/history/removed_volumes.h"
#include "removal/part/default_stock.h"
#include "removal/part/stock_grid.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr double kSummaryVoxels = 200;  // along the longest side

// Columns below a sweep, of all sweeps, that the summary's history may ask: some 50 ms on two
// cores, and a share of what the sweeps of a long program take anyway.
constexpr double kMostColumns = 1.5e6, kColumnsPerCut = 15;

// Of a voxel: a pass along a finished surface removes less by rounding.
constexpr double kNothing = 1e-3;

// mm^2 in plan that the cutter passes over.
double swept_area(const Motion& m, const Tool& tool) {
  const Vec3 way = m.end - m.start;
  const double length = m.kind == MotionKind::arc ? std::fabs(m.sweep) * m.radius
                                                  : std::sqrt(way.x * way.x + way.y * way.y);
  return tool.diameter * (length + tool.diameter);
}

Removal& of_tool(int tool, std::vector<ToolRemoval>& tools) {
  for (ToolRemoval& t : tools)
    if (t.tool == tool) return t.removal;
  return tools.emplace_back(ToolRemoval{tool, {}}).removal;
}

}  // namespace

double summary_voxel(const StockShape& shape, const CutList& cuts, double voxel) {
  const Vec3 size = shape.box.hi - shape.box.lo;
  const double usual = std::max({size.x, size.y, size.z}) / kSummaryVoxels;
  double area = 0, count = 0;
  for (const Motion& motion : cuts.motions()) {
    if (!is_cut(motion) || motion.tool < 0) continue;
    const Tool& tool = cuts.tools()[static_cast<std::size_t>(motion.tool)];
    if (is_turning(tool.type)) continue;
    area += swept_area(motion, tool), ++count;
  }
  const double coarser = std::sqrt(area / (kMostColumns + kColumnsPerCut * count));
  return std::max({usual, coarser, voxel});
}

History make_history(const Job& job, const JobResult& result, const Stock& stock,
                     const CutList& cuts) {
  History history;
  if (job.history == HistoryDetail::off) return history;
  const PartField& field = *stock.grid().field;
  history.voxel = job.history == HistoryDetail::full
                      ? stock.voxel()
                      : summary_voxel(result.stock, cuts, stock.voxel());
  const std::vector<double> all = removed_volumes(field, history_lattice(field, history.voxel),
                                                  cuts.motions().size(), job.carve.threads);
  history.removed.assign(all.begin() + static_cast<std::ptrdiff_t>(cuts.inherited()), all.end());
  for (std::size_t i = 0; i < history.removed.size(); ++i) {
    const Motion& motion = result.program.motions[i];
    if (!is_cut(motion)) continue;
    const Removal one = removal_of(result.program, result.cycle, history, i);
    history.total += one;
    of_tool(motion.tool, history.tools) += one;
  }
  return history;
}

Removal removal_of(const Program& program, const CycleTime& time, const History& history,
                   std::size_t motion) {
  if (program.motions[motion].kind == MotionKind::rapid) return {};
  const double removed = history.removed[motion], seconds = time.seconds[motion];
  const double nothing = kNothing * history.voxel * history.voxel * history.voxel;
  return {removed, seconds, removed > nothing ? 0 : seconds};
}

}  // namespace mrsim
