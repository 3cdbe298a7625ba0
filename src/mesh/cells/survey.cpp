#include "mesh/cells/survey.h"

#include "core/numbers/vec.h"
#include "core/process/memory_limit.h"
#include "core/process/parallel.h"
#include "mesh/cells/cells.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace mrsim::detail {
namespace {

constexpr int kFirstDepth = 5, kLastDepth = 7;  ///< halvings of the longest side
constexpr int kApart = 2;                       ///< halvings after which parts are worked on alone
constexpr std::size_t kEnough = 12000;          ///< blocks that give the area well enough
constexpr double kSweepBytes = 110;             ///< measured: each sweep, in the lists of all parts

// Sheets beside another one in a cell with which some, and with which most, are crowded; triangles
// of these, as a multiple of those of others.
constexpr double kFewHeld = 0.3, kManyHeld = 0.6, kFans = 2.5;

struct Count {
  std::size_t blocks = 0, sweeps = 0;
  std::size_t tried = 0, creasing = 0;  ///< of some blocks, and the sweeps that leave creases there
  double sheets = 0;                    ///< of the surface in these blocks
};

// Whether a box is one of those that are tried: one in `one_in`, evenly spread, whatever their
// order.
bool is_tried(const Box3& box, double block, int one_in) {
  const auto cell = [&](double lo) { return static_cast<std::int64_t>(std::floor(lo / block)); };
  return ((cell(box.lo.x) * 7 + cell(box.lo.y) * 13 + cell(box.lo.z) * 29) & (one_in - 1)) == 0;
}

// Whether faces of different directions meet in a box, judged by the normals at eight points of it.
// Many sweeps may share one face, as the turns of a helix do.
bool has_creases(const ExactField& field, const Box3& box, const Candidates& sweeps) {
  constexpr double kLeastCosine = 0.94;  // 20 degrees
  std::array<Vec3, 8> points, normals;
  std::array<FieldSample, 8> samples;
  for (int k = 0; k < 8; ++k) {
    const Box3 part = octant(box, k);
    points[static_cast<std::size_t>(k)] = 0.5 * (part.lo + part.hi);
  }
  field.samples(points, sweeps, samples.data());
  for (std::size_t k = 0; k < 8; ++k) normals[k] = field.gradient(points[k], samples[k]);
  for (std::size_t k = 0; k < 8; ++k)
    for (std::size_t j = 0; j < k; ++j)
      if (dot(normals[j], normals[k]) < kLeastCosine) return true;
  return false;
}

// How many sheets of surface a box holds: how often the surface crosses lines along each axis that
// pass the box, for each square of cells. Two sheets count as two where they are farther apart than
// the points on a line. The points begin up to half a step before the box or in it, so that a sheet
// between two boxes counts in one of them.
double sheets_in(const ExactField& field, const Box3& box, const Candidates& sweeps) {
  constexpr std::size_t kMostSteps = 24, kLeastSteps = 6, kDistances = 400;  // to sweeps, in all
  constexpr double kGolden = 0.618033988749895;
  const std::size_t steps = std::clamp(kDistances / sweeps.size(), kLeastSteps, kMostSteps);
  const double size = box.hi.x - box.lo.x;
  const Vec3 number = (1 / size) * box.lo;
  double spread = number.x * 0.7548776662 + number.y * 0.5698402910 + number.z * 0.8191725134;
  const auto next = [&] {
    spread += kGolden;
    return spread - std::floor(spread);
  };
  std::array<Vec3, kMostSteps + 1> points;
  std::array<FieldSample, kMostSteps + 1> samples;
  int crossed = 0;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 at = box.lo + size * Vec3{next(), next(), next()};
    const double begin = component(box.lo, axis), step = size / static_cast<double>(steps),
                 shift = next() - 0.5;
    for (std::size_t k = 0; k <= steps; ++k) {
      component(at, axis) = begin + step * (static_cast<double>(k) + shift);
      points[k] = at;
    }
    field.samples(std::span(points).first(steps + 1), sweeps, samples.data());
    for (std::size_t k = 0; k < steps; ++k)
      crossed += is_inside(samples[k].distance) != is_inside(samples[k + 1].distance) ? 1 : 0;
  }
  return crossed;
}

// Counts the blocks that so many `halvings` make of the box, which is at `tier` of the descent.
void count_blocks(const ExactField& field, ExactField::Descent& descent, const Box3& box,
                  std::size_t tier, int halvings, int one_in, Candidates& left, Count& count) {
  if (descent.enter(tier, box, kSurfaceBand, halvings == 0) != ExactField::Region::mixed) return;
  if (halvings == 0) {
    descent.candidates(tier, left);
    count.blocks += !left.empty();
    count.sweeps += left.size();
    if (left.empty() || !is_tried(box, box.hi.x - box.lo.x, one_in)) return;
    ++count.tried;
    count.creasing += has_creases(field, box, left) ? left.size() : 1;
    count.sheets += sheets_in(field, box, left);
    return;
  }
  for (int k = 0; k < 8; ++k)
    count_blocks(field, descent, octant(box, k), tier + 1, halvings - 1, one_in, left, count);
}

struct Part {
  Box3 box;
  Candidates candidates;
};

// The parts of the box after some halvings, with what can matter in each.
void find_parts(ExactField::Descent& descent, const Box3& box, std::size_t tier, int halvings,
                std::vector<Part>& out) {
  if (descent.enter(tier, box, kSurfaceBand, false) != ExactField::Region::mixed) return;
  if (halvings == 0) {
    descent.candidates(tier, out.emplace_back(Part{box, {}}).candidates);
    return;
  }
  for (int k = 0; k < 8; ++k) find_parts(descent, octant(box, k), tier + 1, halvings - 1, out);
}

}  // namespace

double SurfaceSurvey::cells(double voxel) const {
  return static_cast<double>(blocks) * (block / voxel) * (block / voxel);
}

// Where gaps and walls are about as wide as a cell, most cells hold two sheets, whose polygons are
// fans about their crossings. Larger cells hold more sheets, which they do not show.
double SurfaceSurvey::crossed_cells(double voxel) const {
  const double held = std::max(sheets - 1, 0.0) * voxel / block;
  const double crowded = std::clamp((held - kFewHeld) / (kManyHeld - kFewHeld), 0.0, 1.0);
  return (1 + (kFans - 1) * crowded) / std::max(held, 1.0) * sheets * cells(voxel);
}

SurfaceSurvey survey_surface(const ExactField& field, const Candidates& list, int threads,
                             int one_in) {
  require_memory(kSweepBytes * static_cast<double>(list.size()), "a survey of the part's surface");
  const Box3 cube = cube_about(field.bounds());
  std::vector<Part> parts;
  // Its lists, of all sweeps, are gone when the parts have theirs.
  find_parts(*field.descent(0.5 * (cube.lo + cube.hi), list), cube, 1, kApart, parts);
  std::size_t most = 0;
  for (const Part& part : parts) most = std::max(most, part.candidates.size());
  SurfaceSurvey survey;
  for (int depth = kFirstDepth; depth <= kLastDepth && survey.blocks < kEnough; ++depth) {
    std::vector<Count> counts(parts.size());
    parallel_for(parts.size(), threads, [&](std::size_t k) {
      const Part& part = parts[k];
      Candidates left;
      const auto own = field.descent(0.5 * (part.box.lo + part.box.hi), part.candidates);
      count_blocks(field, *own, part.box, 1, depth - kApart, one_in, left, counts[k]);
    });
    survey = {};
    survey.shared =
        static_cast<double>(most) / static_cast<double>(std::max<std::size_t>(list.size(), 1));
    survey.block = (cube.hi.x - cube.lo.x) / static_cast<double>(1 << depth);
    std::size_t sweeps = 0, tried = 0, creasing = 0;
    double sheets = 0, squares = 0;
    for (const Count& count : counts) {
      const auto blocks = static_cast<double>(count.blocks);
      squares += blocks * blocks;
      survey.blocks += count.blocks, sweeps += count.sweeps;
      tried += count.tried, creasing += count.creasing;
      sheets += count.sheets;
    }
    survey.sweeps =
        static_cast<double>(sweeps) / static_cast<double>(std::max<std::size_t>(survey.blocks, 1));
    survey.creasing =
        tried > 0 ? static_cast<double>(creasing) / static_cast<double>(tried) : survey.sweeps;
    if (tried > 0) survey.sheets = sheets / static_cast<double>(tried);
    const double side = static_cast<double>(1 << (depth - kApart));  // blocks along a part
    survey.layers = survey.sheets * squares /
                    static_cast<double>(std::max<std::size_t>(survey.blocks, 1)) / (side * side);
  }
  return survey;
}

}  // namespace mrsim::detail
