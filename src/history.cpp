#include "history.h"

#include "core/vec.h"
#include "cut_pieces.h"
#include "removal/history/cut_heights.h"
#include "removal/history/removed_volumes.h"
#include "removal/part/default_stock.h"
#include "removal/part/stock_grid.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace mrsim {
namespace {

constexpr double kSummaryVoxels = 200;  // along the longest side

// Columns below a sweep, of all sweeps, that the summary's history may ask: some 50 ms on two
// cores, and a share of what the sweeps of a long program take anyway.
constexpr double kMostColumns = 1.5e6, kColumnsPerCut = 15;

// Of the stock in plan, where the sweeps leave heights: as much time.
constexpr double kHeightColumns = 60e3, kHeightColumnsPerCut = 0.5;

// Below falling arcs of all but flat mills each column takes a search, some 0.1 ms.
constexpr double kSearches = 2500, kSearchesPerCut = 10;

// Of a voxel: a pass along a finished surface removes less by rounding.
constexpr double kNothing = 1e-3;

// Cuts are asked in pieces, so that a cut that leaves the material counts as air from
// there: half a diameter long, so that they do not add much to what is asked. 60 000 pieces take
// some 30 MB.
constexpr PieceRule kPieces{0.5, 2, 64, 60000, true};

// mm^2 in plan that the cutter passes over in all pieces.
double swept_area(const Motion& m, const Tool& tool, double voxel) {
  const Vec3 way = m.end - m.start;
  const double length = m.kind == MotionKind::arc ? std::fabs(m.sweep) * m.radius
                                                  : std::sqrt(way.x * way.x + way.y * way.y);
  return tool.diameter * (length + pieces_of(m, tool, voxel, kPieces) * tool.diameter);
}

// How many searches a column below a motion stands for: only falling arcs take one, not those of
// flat mills, five times as long for cones.
double searches_of(const Motion& m, std::span<const Tool> tools) {
  if (!is_cut(m) || m.tool < 0 || m.kind != MotionKind::arc || m.rise == 0) return 0;
  const Tool& tool = tools[static_cast<std::size_t>(m.tool)];
  if (tool.type == ToolType::endmill && tool.corner_radius == 0) return 0;
  return tool.type == ToolType::endmill || tool.type == ToolType::ballmill ||
                 tool.type == ToolType::bullmill
             ? 1
             : 5;
}

// Fills in what each motion of the program removes, and on what share of its way nothing.
void sum_pieces(const CutPieces& pieces, const std::vector<double>& removed, std::size_t inherited,
                History& history) {
  const double nothing = kNothing * history.voxel * history.voxel * history.voxel;
  for (std::size_t i = inherited; i + 1 < pieces.first.size(); ++i) {
    double volume = 0, air = 0;
    for (std::size_t k = pieces.first[i]; k < pieces.first[i + 1]; ++k)
      volume += removed[k], air += removed[k] > nothing ? 0 : 1;
    history.removed.push_back(volume);
    history.air.push_back(air / static_cast<double>(pieces.first[i + 1] - pieces.first[i]));
  }
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
    area += swept_area(motion, tool, std::max(usual, voxel)), ++count;
  }
  const double coarser = std::sqrt(area / (kMostColumns + kColumnsPerCut * count));
  return std::max({usual, coarser, voxel});
}

double summary_column(const StockShape& shape, const CutList& cuts) {
  const Vec3 size = shape.box.hi - shape.box.lo;
  const double count = static_cast<double>(cuts.motions().size());
  const double usual = std::sqrt(size.x * size.y / (kHeightColumns + kHeightColumnsPerCut * count));
  double searched = 0;  // mm^2
  for (const Motion& motion : cuts.motions())
    if (const double searches = searches_of(motion, cuts.tools()); searches > 0)
      searched +=
          searches * swept_area(motion, cuts.tools()[static_cast<std::size_t>(motion.tool)], usual);
  return std::max(usual, std::sqrt(searched / (kSearches + kSearchesPerCut * count)));
}

History make_history(const Job& job, const JobResult& result, const Stock& stock,
                     const CutList& cuts) {
  History history;
  if (job.history == HistoryDetail::off) return history;
  const PartField& field = *stock.grid().field;
  history.voxel = job.history == HistoryDetail::full ? stock.voxel()
                  : has_height_history(field)        ? summary_column(result.stock, cuts)
                                              : summary_voxel(result.stock, cuts, stock.voxel());
  const int threads = job.carve.threads;
  const auto removed_by = [&](const PartField& of, std::size_t motions) {
    return removed_volumes(of, history_lattice(of, history.voxel), motions, threads, nullptr,
                           job.carve.progress);
  };
  const double piece = piece_voxel(cuts, history.voxel, kPieces);
  const bool whole = !std::isfinite(piece);
  const CutPieces pieces = divide_cuts(cuts, piece, kPieces);
  const std::vector<double> removed =
      whole ? removed_by(field, cuts.motions().size())
            : removed_by(PartField(field.solid(),
                                   SweepTable(pieces.motions, cuts.tools(),
                                              {.top = field.bounds().hi.z}, threads),
                                   threads),
                         pieces.motions.size());
  sum_pieces(pieces, removed, cuts.inherited(), history);
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
  const double seconds = time.seconds[motion];
  return {history.removed[motion], seconds, history.air[motion] * seconds};
}

}  // namespace mrsim
