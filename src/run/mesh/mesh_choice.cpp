#include "run/mesh/mesh_choice.h"

#include "core/numbers/rounding.h"
#include "core/numbers/vec.h"
#include "mesh/cells/cell_halvings.h"
#include "mesh/cells/survey.h"
#include "removal/part/stock.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

// Default tolerance of the mesh, as a share of the longest side: a turned part of the usual shape
// keeps its volume within 0.03 % (docs/accuracy.md) in a run of a second.
constexpr double kToleranceShare = 1.7e-4;

// Share of that tolerance down to which a mill whose cuts are all shallow may bring it.
constexpr double kLeastShare = 0.1;

// How many times as coarse a mesh within a tolerance may be before the grid takes its place: half
// of the grid's cells, a quarter of them because of the octree's nodes (MeshPlan::most_tolerance).
constexpr double kMostRaised = 8;

// Sweeps in the sample from which the area of the cut surface is estimated where the voxel is
// given.
constexpr std::size_t kEnoughSweeps = 10000;

// Cells of the grid: it is made coarser above the first number (about two seconds of two cores),
// and finer than its default only up to the second one.
constexpr double kMostGridCells = 1e6, kFewGridCells = 4e5, kMostSearchedCells = 4e5;
// Cells where many turns of helices overlap: they take twice as long.
constexpr double kManyTurns = 60, kMostTurnCells = 6e5;
// Nodes of the octree for a piece of a narrow groove that is as long as wide (text of 6 m by a
// V-bit took 40), and up to which they are few.
constexpr double kGrooveNodes = 40, kFewGrooveNodes = 1e5;
// Nodes of the octree for a cell on a curved face of the stock. A relief of 76 000 triangles and a
// clearing of 700 000 took more than 400 000 of them, by 66 000 and 43 000 such cells.
constexpr double kBendNodes = 12;
// Voxels on the cut surface that a mesh within a tolerance scans for what its larger cells may
// hide; above this number the voxel is raised.
constexpr double kMostScanned = 1e5;
// Cells of a grid that is coarser than the smallest radius with which a tool cuts, so that grooves
// are lost, where the part is plain: such cells take a third of the time.
constexpr double kMostGrooveCells = 4e6;
// Average number of creasing sweeps in a block above which no tolerance is tried, because cells
// would be halved too often. It is tried after all where all blocks together have few such sweeps,
// as on a large sheet whose blocks are large, and pointed tools leave few narrow grooves. Where
// most cuts are level, more sweeps count as few.
constexpr double kMostCreasing = 9, kFewCreasing = 1e5, kFewLevelCreasing = 3.5e5;
// Sweeps in all blocks together above which no tolerance is tried: kMostSweeps where a block has
// more than kFewSweeps on average, kMostSearched where points of helices are searched, which costs
// ten times as much.
constexpr double kFewSweeps = 20, kMostSweeps = 6.5e5, kMostSearched = 6e4;
// Average number of creasing sweeps in a block up to which a part counts as plain (pockets, holes):
// its cells take half the time.
constexpr double kPlainSweeps = 1.5;
// Cells of the wished size, and creasing sweeps in a block, up to which another octree is worth its
// time where one has too many nodes. Above these numbers it mostly has too many, too; where the
// cuts are no relief or engraving it has not, unless the wished cells for twice the tolerance are
// more than this share of the most nodes.
constexpr double kMostRetried = 1.2e5, kMostRetriedCreasing = 6, kMostRetriedShare = 1.4;
// Nodes of the octree above which the grid takes its place: as many as two cores make in some five
// seconds. Nodes on the slopes of pointed mills take twice as long, those about the crests of a
// winding helix, or on upright arcs of flat mills, three times, so there are fewer of them.
constexpr std::size_t kMostNodes = 250'000, kMostLevelNodes = 350'000, kMostPlainNodes = 450'000,
                      kMostPointedNodes = 100'000, kMostHelixNodes = 200'000,
                      kMostWindingNodes = 80'000, kMostSearchedNodes = 60'000;

double longest_side(const Box3& box) {
  const Vec3 size = box.hi - box.lo;
  return std::max({size.x, size.y, size.z});
}

// Neighbours in the series 1, 2, 2.5, 5.
double finer_voxel(double voxel) { return round_down_voxel(0.9 * voxel); }
double next_voxel(double voxel) { return round_down_voxel(2.01 * voxel); }

// The next of the preferred numbers R'10 (ISO 3): a quarter more.
double coarser_grid(double voxel) {
  constexpr double kSteps[] = {1, 1.25, 1.6, 2, 2.5, 3.2, 4, 5, 6.3, 8, 10};
  const double decade = std::pow(10, std::floor(std::log10(voxel * (1 + kShareRounding))));
  for (const double step : kSteps)
    if (step * decade > voxel * (1 + kShareRounding)) return step * decade;
  return 10 * decade;
}

// Cells of this size are within the tolerance on a cylinder or ball of the cutter's radius, and
// hold no more than half of it.
double wished_cell(const CutKinds& kinds, double tolerance, double longest) {
  if (!(kinds.radius > 0)) return longest / kVoxelsOfSide;
  return std::min(2 * std::sqrt(kinds.radius * tolerance), kinds.radius / 2);
}

std::string count_text(double count) {
  return count < 1e6 ? fmt::format("{:.0f} 000", std::ceil(count / 1e3))
                     : fmt::format("{:.1f} million", count / 1e6);
}

bool is_plain(const detail::SurfaceSurvey& survey) { return survey.creasing <= kPlainSweeps; }

double groove_nodes(const MeshChoice& choice) { return kGrooveNodes * choice.kinds.grooves; }

// The sum over all blocks: one for the block itself, and one for each sweep that meets it.
double sweeps_met(const detail::SurfaceSurvey& survey) {
  return static_cast<double>(survey.blocks) * (1 + survey.sweeps);
}

// Whether a mesh within the tolerance is worth a try. Its true cost is known only when its octree
// is made.
bool may_suit_tolerance(const detail::SurfaceSurvey& survey, const MeshChoice& choice) {
  if (choice.kinds.search_arcs && sweeps_met(survey) > kMostSearched) return false;
  if (survey.sweeps > kFewSweeps && sweeps_met(survey) > kMostSweeps) return false;
  const double few = choice.kinds.are_level ? kFewLevelCreasing : kFewCreasing;
  return survey.creasing <= kMostCreasing ||
         (groove_nodes(choice) <= kFewGrooveNodes &&
          static_cast<double>(survey.blocks) * survey.creasing <= few);
}

// Whether another octree, for twice the tolerance, is worth its time where one has too many nodes.
bool suits_another_octree(const detail::SurfaceSurvey& survey, const MeshChoice& choice,
                          double longest) {
  const double cells = survey.cells(wished_cell(choice.kinds, choice.tolerance, longest));
  if (cells <= kMostRetried && survey.creasing <= kMostRetriedCreasing) return true;
  const double next = survey.cells(wished_cell(choice.kinds, 2 * choice.tolerance, longest));
  return !choice.kinds.are_slanted && !choice.kinds.are_pointed &&
         next <= kMostRetriedShare * static_cast<double>(choice.most_nodes);
}

// What a mesh within the tolerance takes where creases lie everywhere: bytes and seconds of a cell,
// within a factor of four. A relief by a tapered mill with 0.7 million took 1.7 GB and 51 s. 50
// threads by a form tool, whose crests are narrower than cells, took 1.1 million instead of 0.12,
// and 264 s.
constexpr double kCellBytes = 2.5e3, kCellSeconds = 5e-5, kSearchedSeconds = 10 * kCellSeconds;

std::string needs_text(const detail::SurfaceSurvey& survey, double cell, bool searches_arc) {
  const double cells = std::max(survey.cells(cell), sweeps_met(survey));
  const double seconds = cells * (searches_arc ? kSearchedSeconds : kCellSeconds);
  return fmt::format("would take about {} cells, perhaps {:.1g} GB and {:.0f} s of one core",
                     count_text(cells), cells * kCellBytes / 1e9, std::ceil(seconds));
}

// `why`: a clause about the tolerance.
void take_grid(MeshChoice& choice, const std::string& why) {
  choice.tolerance_reason =
      fmt::format("{:.4g} mm, {}, {}; --tolerance {:.4g} insists on it", choice.tolerance,
                  choice.tolerance_reason, why, choice.tolerance);
  choice.voxel = choice.fallback_voxel;
  choice.tolerance = 0;
  choice.measure = true;
}

// Every so many of a long list.
Candidates some_of(const Candidates& all) {
  const std::size_t step = std::max<std::size_t>(all.size() / kEnoughSweeps, 1);
  Candidates some;
  for (std::size_t k = 0; k < all.size(); k += step) some.push_back(all[k]);
  return some;
}

// Nodes of the octree for the curved faces of a stock that is a mesh: cells whose chords leave them
// by the tolerance, but no more than have an edge.
double stock_nodes(const StockFacets& facets, double tolerance) {
  return kBendNodes * std::min(facets.bend / (8 * tolerance), facets.edges);
}

// `cell`: the wanted edge of a cell, mm.
void fit_voxel(const detail::SurfaceSurvey& survey, double cell, const StockFacets& facets,
               MeshChoice& choice) {
  double& grid = choice.fallback_voxel;
  while (finer_voxel(grid) >= choice.voxel && survey.cells(finer_voxel(grid)) <= kFewGridCells)
    grid = finer_voxel(grid);
  const double finest = grid;
  // Several sheets of surface in one block count; less than one counts as one, since sheets that
  // lie within a cell take as long.
  const auto most = [&](double voxel) {
    const bool is_groove = voxel > choice.kinds.radius && is_plain(survey);
    const bool has_turns = choice.kinds.have_many_helices && survey.sweeps > kManyTurns;
    const double cells = choice.kinds.search_arcs ? kMostSearchedCells
                         : is_groove              ? kMostGrooveCells
                         : has_turns              ? kMostTurnCells
                                                  : kMostGridCells;
    return cells / std::max(survey.sheets, 1.0);
  };
  while (survey.cells(grid) > most(grid)) grid = coarser_grid(grid);
  const double in_grooves = groove_nodes(choice), on_stock = stock_nodes(facets, choice.tolerance);
  const double nodes = std::max(in_grooves, on_stock);
  const bool fits = nodes <= static_cast<double>(choice.most_nodes);
  if (!choice.is_default || (fits && may_suit_tolerance(survey, choice))) {
    const double given = choice.voxel;
    const auto scanned = [&](double voxel) {
      return survey.cells(voxel) + facets.area / (voxel * voxel);
    };
    const bool is_stock = 2 * survey.cells(given) < scanned(given);
    while (scanned(choice.voxel) > kMostScanned && next_voxel(choice.voxel) <= choice.kinds.radius)
      choice.voxel = next_voxel(choice.voxel);
    if (choice.voxel > given)
      choice.voxel_reason =
          fmt::format("raised from {:.6g} mm, {}: {} surface is large", given, choice.voxel_reason,
                      is_stock ? "the stock's curved" : "the cuts'");
    return;
  }
  take_grid(choice, fits ? needs_text(survey, cell, choice.kinds.search_arcs)
                         : fmt::format("would take more than {} cells {}", count_text(nodes),
                                       on_stock > in_grooves ? "on the stock's curved faces"
                                                             : "along narrow grooves"));
  choice.voxel_reason =
      choice.voxel > finest
          ? fmt::format("{:.6g} mm would take about {} cells", finest,
                        count_text(survey.cells(finest)))
          : fmt::format("for a cutter radius of {:.6g} mm, rounded down", choice.kinds.radius);
}

}  // namespace

MeshChoice choose_mesh(const Job& job, const StockShape& stock, const CutList& cuts) {
  MeshChoice choice;
  choice.voxel = job.carve.voxel;
  choice.voxel_reason = "--voxel";
  choice.tolerance = job.mesh.tolerance;
  choice.tolerance_reason = choice.tolerance != 0 ? "--tolerance" : "";
  if (choice.tolerance > 0) detail::require_tolerance(stock.box, choice.tolerance);
  if (choice.voxel != 0) return choice;
  choice.fits_voxel = true;
  choice.kinds = kinds_of(cuts, stock.box.hi.z);
  const VoxelChoice voxel = default_voxel(stock, choice.kinds.radius);
  choice.voxel = voxel.voxel;
  choice.voxel_reason = voxel.reason;
  if (choice.tolerance != 0) return choice;
  const double longest = longest_side(stock.box);
  choice.tolerance = longest * kToleranceShare;
  choice.tolerance_reason = fmt::format("0.017 % of the longest side, {:.6g} mm", longest);
  // What a tool engraves on a large plate must not be lost within the tolerance.
  const double depth = choice.kinds.depth;
  if (depth / 2 < choice.tolerance) {
    choice.tolerance = std::max(depth / 2, kLeastShare * choice.tolerance);
    choice.tolerance_reason = fmt::format("a mill cuts no deeper than {:.4g} mm", depth);
  }
  choice.is_default = true;
  choice.most_tolerance = std::min(kMostRaised * choice.tolerance, depth);
  if (job.accept > 0 && choice.tolerance > job.accept / 4) {
    choice.tolerance = job.accept / 4;
    choice.tolerance_reason = fmt::format("a quarter of --accept, {:.6g} mm", job.accept);
    choice.is_default = false;
    choice.most_tolerance = 0;
  }
  return choice;
}

void fit_mesh(const ExactField& field, int threads, MeshChoice& choice) {
  if (!choice.fits_voxel && choice.tolerance > 0) return;
  const double longest = longest_side(field.bounds());
  const double cell = wished_cell(choice.kinds, choice.tolerance, longest);
  if (choice.fits_voxel) choice.fallback_voxel = std::max(choice.voxel, round_down_voxel(cell));
  if (choice.is_default) choice.most_nodes = kMostPlainNodes;
  if (field.is_turned(field.all())) return;  // meshed by its section
  const Candidates sweeps = choice.fits_voxel ? field.all() : some_of(field.all());
  const detail::SurfaceSurvey survey =
      detail::survey_surface(field, sweeps, threads, choice.kinds.search_arcs ? 64 : 16);
  if (choice.fits_voxel) fit_voxel(survey, cell, field.facets(), choice);
  choice.cut_cells = survey.crossed_cells(choice.voxel);
  choice.cut_layers = survey.layers;
  choice.block_sweeps = survey.sweeps;
  choice.shared_sweeps = survey.shared;
  if (!choice.is_default) return;
  if (choice.kinds.search_arcs)
    choice.most_nodes = kMostSearchedNodes;
  else if (choice.kinds.have_winding_helix || choice.kinds.have_many_upright_arcs)
    choice.most_nodes = kMostWindingNodes;
  else if (choice.kinds.have_many_helices)
    choice.most_nodes = kMostHelixNodes;
  else if (!is_plain(survey))
    choice.most_nodes = choice.kinds.are_level     ? kMostLevelNodes
                        : choice.kinds.are_pointed ? kMostPointedNodes
                                                   : kMostNodes;
  choice.makes_new_octrees = suits_another_octree(survey, choice, longest);
  choice.fallback_cells = survey.crossed_cells(choice.fallback_voxel);
}

void raise_tolerance(MeshChoice& choice, double raised) {
  choice.tolerance_reason = fmt::format(
      "raised from {:.4g} mm, {}, which takes too many cells; --tolerance {:.4g} insists on it",
      choice.tolerance, choice.tolerance_reason, choice.tolerance);
  choice.tolerance = raised;
}

void give_up_tolerance(MeshChoice& choice, const std::string& why) {
  take_grid(choice, "was given up: " + why);
  choice.voxel_reason = "the grid instead of the tolerance";
  choice.cut_cells = choice.fallback_cells;
}

}  // namespace mrsim
