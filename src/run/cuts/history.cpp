#include "run/cuts/history.h"

#include "core/numbers/motions.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "removal/history/cut_heights.h"
#include "removal/history/removed_volumes.h"
#include "removal/part/memory_plan.h"
#include "removal/part/stock_grid.h"
#include "removal/tool/tool.h"
#include "run/cuts/cut_kinds.h"
#include "run/cuts/cut_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace mrsim {
namespace {

constexpr double kSummaryVoxels = 200;  // along the longest side

// Columns below sweeps that the summary's history may evaluate: some 50 ms on two
// cores, and a share of what the sweeps of a long program take anyway.
constexpr double kMostColumns = 1.5e6, kColumnsPerCut = 15;

// A file of the history may take so many times as long as the summary's. Up to there its voxels are
// finer than those of the run, by so much at most; columns likewise.
constexpr double kFullTime = 10, kFinestVoxel = 4, kFullColumnTime = 20, kFinestColumn = 2;

// Cost, in plain columns, of a column below a cutter whose head is wider than what is above it, on
// a helix or a tilted arc: each distance is a search.
constexpr double kSearchedColumns = 100;
// Cost of a column below such a cutter's other moves: both ends of the head are evaluated.
constexpr double kHeadColumns = 3;

// Columns across the smallest cutter that are enough: the run's voxel may be as large as its
// radius.
constexpr double kColumnsOfWidth = 12;

// A second history by voxels so many times as large tells how volumes err.
constexpr double kCoarser = 2;

// Columns of the stock in plan, where the sweeps leave heights: they take as much time.
constexpr double kHeightColumns = 60e3, kHeightColumnsPerCut = 0.3;
// The same columns, each counted once for each sweep over it: up to 0.02 us of one core each. Short
// moves of a wide tool side by side come to so many, because each passes over many columns.
constexpr double kColumnsSwept = 25e6, kColumnsSweptPerCut = 20;
// Cost of a column below a cone or a bull-nosed mill, whose bottom takes longer.
constexpr double kSlowBottom = 6;

// Below upright arcs, and below helices of all but flat mills, each column measures the chords of
// a sweep, 5 us, and searches where the cutter is steep.
constexpr double kSearches = 15e3, kSearchesPerCut = 14;

// Share of a voxel up to which a removed volume is rounding: that of a pass along a finished
// surface.
constexpr double kNothing = 1e-3;

// Share of a column or voxel to which the ends of a band are known.
constexpr double kWidthError = 0.125;

// Cuts are sampled in pieces, so that a cut that leaves the material counts as air from there on.
// Pieces are half a diameter long, so that they add few samples. A plunge is short and begins in
// the air, so its pieces are an eighth of a diameter long; where heights give the history, nothing
// is sampled along it. 60 000 pieces take some 30 MB.
constexpr PieceRule kPieces{{0.5, 2}, 64, 60000, true, {0.125, 2}};
constexpr PieceRule kHeightPieces{{0.5, 2}, 64, 60000, true, {0.125, 0.25}};

// mm. Forms have no diameter.
double width_of(const Tool& tool) {
  double width = tool.diameter;
  for (const ProfilePoint& p : tool.profile) width = std::max(width, 2 * p.r);
  return width;
}

double plan_length(const Motion& m) {
  const Vec3 way = m.end - m.start;
  return m.kind == MotionKind::arc ? std::fabs(m.sweep) * m.radius
                                   : std::sqrt(way.x * way.x + way.y * way.y);
}

// mm^2 in plan that the cutter passes over in all pieces.
double swept_area(const Motion& m, const Tool& tool, double voxel, const PieceRule& rule) {
  return width_of(tool) * (plan_length(m) + pieces_of(m, tool, voxel, rule) * width_of(tool));
}

// How many columns or sweeps each of a tool counts as where they leave heights.
double bottoms_of(const Tool& tool) {
  const bool is_flat = tool.type == ToolType::endmill && tool.corner_radius == 0;
  return is_flat || tool.type == ToolType::ballmill ? 1 : kSlowBottom;
}

// How many searches a column below a motion counts as: 0 where its bottom is a closed form, more
// for bull-nosed mills and for cones, whose distances take longer.
double searches_of(const Motion& m, std::span<const Tool> tools) {
  if (!is_cut(m) || m.tool < 0 || m.kind != MotionKind::arc) return 0;
  const bool about_z = std::fabs(m.axis.z) == 1;
  if (about_z && m.rise == 0) return 0;
  const Tool& tool = tools[static_cast<std::size_t>(m.tool)];
  if (about_z && tool.type == ToolType::endmill && tool.corner_radius == 0) return 0;
  if (tool.type == ToolType::bullmill) return 2;
  return tool.type == ToolType::endmill || tool.type == ToolType::ballmill ? 1 : 5;
}

// How many columns each column below a motion counts as where the sweeps leave no heights.
double columns_of(const Motion& m, const Tool& tool) {
  const bool has_head = tool.type == ToolType::form || tool.type == ToolType::tslot ||
                        tool.type == ToolType::lollipop;
  if (!has_head) return 1;
  const bool is_level = m.rise == 0 && std::fabs(m.axis.z) == 1;
  return m.kind == MotionKind::arc && !is_level ? kSearchedColumns : kHeadColumns;
}

// The voxel (mm) of a history by voxels that evaluates about so many columns. `rule_voxel` divides
// the motions into pieces.
double affordable_voxel(const CutList& cuts, double rule_voxel, double columns) {
  double area = 0, count = 0;
  for (const Motion& motion : cuts.motions()) {
    if (!is_cut(motion) || motion.tool < 0) continue;
    const Tool& tool = cuts.tools()[static_cast<std::size_t>(motion.tool)];
    if (is_turning(tool.type)) continue;
    area += columns_of(motion, tool) * swept_area(motion, tool, rule_voxel, kPieces);
    ++count;
  }
  return std::sqrt(area / (columns + kColumnsPerCut * count));
}

// mm, the side of columns that take so many times as long as the summary's.
// Where cutters with slow bottoms pass, each place of the stock costs more; where nothing passes,
// as between holes, nothing.
double affordable_column(const StockShape& shape, const CutList& cuts, double time) {
  const Vec3 size = shape.box.hi - shape.box.lo;
  const double count = static_cast<double>(cuts.motions().size()), plan = size.x * size.y;
  const double columns = time * (kHeightColumns + kHeightColumnsPerCut * count);
  const double least = std::sqrt(plan / columns);
  double area = 0, slow = 0, swept = 0, searched = 0;  // mm^2
  for (const Motion& motion : cuts.motions()) {
    if (!is_cut(motion) || motion.tool < 0) continue;
    const Tool& tool = cuts.tools()[static_cast<std::size_t>(motion.tool)];
    const double own = swept_area(motion, tool, least, kHeightPieces);
    const double whole = width_of(tool) * (plan_length(motion) + width_of(tool));
    area += whole;
    slow += (bottoms_of(tool) - 1) * whole;
    swept += bottoms_of(tool) * own;
    searched += searches_of(motion, cuts.tools()) * own;
  }
  const double share = area > plan ? plan / area : 1;  // what passes again costs nothing new
  const double usual = std::sqrt((plan + share * slow) / columns);
  return std::max({usual, std::sqrt(swept / (time * (kColumnsSwept + kColumnsSweptPerCut * count))),
                   std::sqrt(searched / (time * (kSearches + kSearchesPerCut * count)))});
}

// mm, of the mills that cut.
double smallest_width(const CutList& cuts) {
  double least = kInfinity;
  for (const Motion& motion : cuts.motions())
    if (is_cut(motion) && motion.tool >= 0)
      least = std::min(least, width_of(cuts.tools()[static_cast<std::size_t>(motion.tool)]));
  return least;
}

// Sums err by the square of the voxel, so one finer than that of the run is taken where that is
// cheap.
double full_voxel(const StockShape& shape, const CutList& cuts, double voxel, bool by_heights) {
  if (by_heights) {
    const double finest = std::min(voxel / kFinestColumn, smallest_width(cuts) / kColumnsOfWidth);
    return std::clamp(affordable_column(shape, cuts, kFullColumnTime), finest, voxel);
  }
  return std::clamp(affordable_voxel(cuts, voxel, kFullTime * kMostColumns), voxel / kFinestVoxel,
                    voxel);
}

// Volumes by voxels err by the square of the voxel: what the larger one errs more tells what the
// smaller one does (Richardson). `coarse`: by voxels kCoarser times as large.
std::vector<double> extrapolated(const std::vector<double>& fine,
                                 const std::vector<double>& coarse) {
  std::vector<double> out(fine.size());
  for (std::size_t i = 0; i < fine.size(); ++i)
    out[i] = fine[i] + (fine[i] - coarse[i]) / (kCoarser * kCoarser - 1);
  return out;
}

double mm3_of_nothing(double voxel) { return kNothing * voxel * voxel * voxel; }

// Fills in what each motion of the program removes, and on what share of its way nothing.
// `better`: what pieces remove, more closely than `removed`; empty: that.
void sum_pieces(const CutPieces& pieces, const std::vector<double>& removed,
                const std::vector<double>& better, std::size_t inherited, History& history) {
  const std::vector<double>& volumes = better.empty() ? removed : better;
  const double nothing = mm3_of_nothing(history.voxel);
  for (std::size_t i = inherited; i + 1 < pieces.first.size(); ++i) {
    double volume = 0, air = 0;
    for (std::size_t k = pieces.first[i]; k < pieces.first[i + 1]; ++k)
      volume += volumes[k], air += removed[k] > nothing ? 0 : 1;
    history.removed.push_back(std::max(volume, 0.0));
    history.air.push_back(air / static_cast<double>(pieces.first[i + 1] - pieces.first[i]));
  }
}

// The part has no threads, but passes that cut a thread are not air cuts: what they remove is not
// known.
void leave_out_threads(const CutList& cuts, History& history) {
  for (std::size_t i = 0; i < history.air.size(); ++i) {
    if (!is_thread_pass(cuts.motions()[cuts.inherited() + i], cuts.tools())) continue;
    history.air[i] = 0;
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    if (i < history.shapes.size()) history.shapes[i] = {unknown, unknown, unknown};
  }
}

// Cuts shorter than a column may have none of their own. So a way up to two columns long is no air
// where the cuts before and after it remove something.
void close_short_gaps(std::span<const Motion> motions, History& history) {
  const auto is_air = [&](std::size_t i) { return is_cut(motions[i]) && history.air[i] == 1; };
  const auto removes = [&](std::size_t i) { return is_cut(motions[i]) && history.air[i] < 1; };
  for (std::size_t first = 1, end = 1; first < motions.size(); first = ++end) {
    double way = 0;
    for (end = first; end < motions.size() && is_air(end); ++end) way += length_of(motions[end]);
    if (end == motions.size() || way > 2 * history.voxel) continue;
    if (removes(first - 1) && removes(end) && motions[first - 1].tool == motions[end].tool)
      std::fill(history.air.begin() + static_cast<std::ptrdiff_t>(first),
                history.air.begin() + static_cast<std::ptrdiff_t>(end), 0.0);
  }
}

// The cutters of the mills that cut, by tool.
using Mills = std::vector<std::optional<Profile>>;

Mills mills_of(const CutList& cuts) {
  Mills mills(cuts.tools().size());
  for (const Motion& motion : cuts.motions()) {
    if (!is_cut(motion) || motion.tool < 0) continue;
    const auto k = static_cast<std::size_t>(motion.tool);
    if (!mills[k] && !is_turning(cuts.tools()[k].type)) mills[k] = make_cutter(cuts.tools()[k]);
  }
  return mills;
}

std::vector<CutFrame> frames_of(std::span<const Motion> motions, std::span<const Tool> tools,
                                const Mills& mills) {
  std::vector<CutFrame> frames(motions.size());
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (!is_cut(motions[i]) || motions[i].tool < 0) continue;
    const auto tool = static_cast<std::size_t>(motions[i].tool);
    frames[i] = {motions[i], tools[tool], mills[tool] ? mills[tool]->max_radius() : 0};
  }
  return frames;
}

// mm^2 in plan that a plunge clears. Voxels do not tell which of them lie above each other, so the
// cleared share of the circle is taken to be the removed share of the volume in full material.
// Simpson's rule is exact for flat mills, balls and cones.
double cleared_area(double removed, const Motion& plunge, const CutExtent& extent,
                    const Profile& mill) {
  const double depth = extent.high - extent.low, way = std::min(length_of(plunge), depth);
  const auto circle = [&](double z) {
    const double r = mill.max_radius_below(z);
    return kPi * r * r;
  };
  const double mean = (circle(depth - way) + 4 * circle(depth - way / 2) + circle(depth)) / 6;
  return removed / (mean * way) * circle(depth);
}

// The largest figures of the pieces of each motion. `is_turned`: extents lie in the half plane.
void measure_shapes(const CutPieces& pieces, const CutExtents& extents,
                    const std::vector<double>& removed, const CutList& cuts, const Mills& mills,
                    bool is_turned, History& history) {
  const double nothing = mm3_of_nothing(history.voxel);
  for (std::size_t i = cuts.inherited(); i + 1 < pieces.first.size(); ++i) {
    CutShape shape;
    CutExtent plunge;  // the pieces of one lie below each other
    for (std::size_t k = pieces.first[i]; k < pieces.first[i + 1]; ++k) {
      if (!(removed[k] > nothing)) continue;
      const CutFrame& frame = extents.frames[k];
      CutExtent extent = extents.extents[k];
      if (frame.is_plunge() && is_turned) extent = turned_about_axis(extent);
      const auto& mill = mills[static_cast<std::size_t>(cuts.motions()[i].tool)];
      if (frame.is_plunge() && extent.area == 0 && !extent.is_empty() && mill)
        extent.area = cleared_area(removed[k], pieces.of(cuts)[k], extent, *mill);
      shape += cut_shape(frame, extent, mill ? &*mill : nullptr, kWidthError * history.voxel);
      if (frame.is_plunge()) plunge.add(extent);
    }
    if (!plunge.is_empty()) shape.depth = plunge.high - plunge.low;
    history.shapes.push_back(shape);
  }
}

Removal& of_tool(int tool, std::vector<ToolRemoval>& tools) {
  for (ToolRemoval& t : tools)
    if (t.tool == tool) return t.removal;
  return tools.emplace_back(ToolRemoval{tool, {}}).removal;
}

void sum_tools(const JobResult& result, History& history) {
  for (std::size_t i = 0; i < history.removed.size(); ++i) {
    const Motion& motion = result.program.motions[i];
    if (!is_cut(motion)) continue;
    const Removal one = removal_of(result.program, result.cycle, history, i);
    history.total += one;
    of_tool(motion.tool, history.tools) += one;
  }
}

}  // namespace

CutShape& CutShape::operator+=(const CutShape& other) {
  // 0 says nothing against "not defined": an air cut.
  const auto larger = [](double a, double b) {
    if (!std::isnan(a) && !std::isnan(b)) return std::max(a, b);
    const double known = std::isnan(a) ? b : a;
    return known > 0 ? known : std::numeric_limits<double>::quiet_NaN();
  };
  depth = larger(depth, other.depth);
  width = larger(width, other.width);
  engagement = larger(engagement, other.engagement);
  return *this;
}

double summary_voxel(const StockShape& shape, const CutList& cuts, double voxel) {
  const Vec3 size = shape.box.hi - shape.box.lo;
  const double usual = std::max({size.x, size.y, size.z}) / kSummaryVoxels;
  return std::max({usual, affordable_voxel(cuts, std::max(usual, voxel), kMostColumns), voxel});
}

double summary_column(const StockShape& shape, const CutList& cuts) {
  return affordable_column(shape, cuts, 1);
}

History make_history(const Job& job, const JobResult& result, const Stock& stock,
                     const CutList& cuts) {
  History history;
  if (job.history == HistoryDetail::off) return history;
  const PartField& field = *stock.grid().field;
  const bool has_shapes = job.history == HistoryDetail::full,
             by_heights = has_height_history(field);
  history.voxel = has_shapes   ? full_voxel(result.stock, cuts, stock.voxel(), by_heights)
                  : by_heights ? summary_column(result.stock, cuts)
                               : summary_voxel(result.stock, cuts, stock.voxel());
  const int threads = job.carve.threads;
  CutExtents extents;
  const Mills mills = has_shapes ? mills_of(cuts) : Mills();
  std::vector<double> better;
  const auto removed_by = [&](const PartField& of, std::span<const Motion> motions) {
    const auto at = [&](double voxel, CutExtents* shapes) {
      return removed_volumes(of, history_lattice(of, voxel), motions.size(), threads, nullptr,
                             job.carve.progress, shapes);
    };
    if (!has_shapes) return at(history.voxel, nullptr);
    extents.frames = frames_of(motions, cuts.tools(), mills);
    std::vector<double> removed = at(history.voxel, &extents);
    if (!by_heights) better = extrapolated(removed, at(kCoarser * history.voxel, nullptr));
    return removed;
  };
  const PieceRule& rule = by_heights ? kHeightPieces : kPieces;
  const double piece = piece_voxel(cuts, history.voxel, rule);
  const bool whole = !std::isfinite(piece);
  const CutPieces pieces = divide_cuts(cuts, piece, rule);
  const SweepSelection below_top{.top = field.bounds().hi.z};
  require_table(pieces.motions, cuts.tools(), below_top);
  const std::vector<double> removed =
      whole ? removed_by(field, cuts.motions())
            : removed_by(
                  PartField(field.solid(),
                            SweepTable(pieces.motions, cuts.tools(), below_top, threads), threads),
                  pieces.motions);
  if (has_shapes)
    measure_shapes(pieces, extents, removed, cuts, mills,
                   history_lattice(field, history.voxel).half_plane, history);
  sum_pieces(pieces, removed, better, cuts.inherited(), history);
  close_short_gaps(cuts.motions().subspan(cuts.inherited()), history);
  leave_out_threads(cuts, history);
  sum_tools(result, history);
  return history;
}

Removal removal_of(const Program& program, const CycleTime& time, const History& history,
                   std::size_t motion) {
  if (program.motions[motion].kind == MotionKind::rapid) return {};
  const double seconds = time.seconds[motion];
  return {history.removed[motion], seconds, history.air[motion] * seconds};
}

}  // namespace mrsim
