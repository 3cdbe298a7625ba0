#include "mesh/cells/survey.h"

#include "core/parallel.h"
#include "core/vec.h"
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
constexpr std::size_t kEnough = 12000;          ///< blocks that tell the area well enough

struct Count {
  std::size_t blocks = 0, sweeps = 0;
  std::size_t tried = 0, creasing = 0;  ///< of some blocks, and the sweeps that leave creases there
  std::size_t crossings = 0;            ///< of the same, by the surface
};

// One in sixteen, evenly spread, whatever the order.
bool is_tried(const Box3& box, double block) {
  const auto cell = [&](double lo) { return static_cast<std::int64_t>(std::floor(lo / block)); };
  return ((cell(box.lo.x) * 7 + cell(box.lo.y) * 13 + cell(box.lo.z) * 29) & 15) == 0;
}

// What eight points of a box tell of the surface in it.
struct Look {
  bool creases = false;       // faces of different directions meet: normals differ
  std::size_t crossings = 0;  // of the twelve edges between them, by the surface
};

// Many sweeps may share one face, as the turns of a helix do.
Look look_at(const ExactField& field, const Box3& box, const Candidates& sweeps) {
  constexpr double kLeastCosine = 0.94;  // 20 degrees
  std::array<Vec3, 8> points, normals;
  std::array<FieldSample, 8> samples;
  for (int k = 0; k < 8; ++k) {
    const Box3 part = octant(box, k);
    points[static_cast<std::size_t>(k)] = 0.5 * (part.lo + part.hi);
  }
  field.samples(points, sweeps, samples.data());
  for (std::size_t k = 0; k < 8; ++k) normals[k] = field.gradient(points[k], samples[k]);
  Look look;
  for (std::size_t k = 0; k < 8; ++k)
    for (std::size_t j = 0; j < k; ++j) {
      look.creases = look.creases || dot(normals[j], normals[k]) < kLeastCosine;
      const bool is_edge = std::has_single_bit(j ^ k);
      look.crossings +=
          is_edge && is_inside(samples[j].distance) != is_inside(samples[k].distance) ? 1 : 0;
    }
  return look;
}

// Counts the blocks `depth` halvings below the box, which is at `level` of the descent.
void count_blocks(const ExactField& field, ExactField::Descent& descent, const Box3& box,
                  std::size_t level, int depth, Candidates& left, Count& count) {
  if (descent.enter(level, box, kSurfaceBand, depth == 0) != ExactField::Region::mixed) return;
  if (depth == 0) {
    descent.candidates(level, left);
    count.blocks += !left.empty();
    count.sweeps += left.size();
    if (left.empty() || !is_tried(box, box.hi.x - box.lo.x)) return;
    ++count.tried;
    const Look look = look_at(field, box, left);
    count.creasing += look.creases ? left.size() : 1;
    count.crossings += look.crossings;
    return;
  }
  for (int k = 0; k < 8; ++k)
    count_blocks(field, descent, octant(box, k), level + 1, depth - 1, left, count);
}

struct Part {
  Box3 box;
  Candidates candidates;
};

// The parts of the box after some halvings, with what can matter in each.
void find_parts(ExactField::Descent& descent, const Box3& box, std::size_t level, int depth,
                std::vector<Part>& out) {
  if (descent.enter(level, box, kSurfaceBand, false) != ExactField::Region::mixed) return;
  if (depth == 0) {
    descent.candidates(level, out.emplace_back(Part{box, {}}).candidates);
    return;
  }
  for (int k = 0; k < 8; ++k) find_parts(descent, octant(box, k), level + 1, depth - 1, out);
}

}  // namespace

double SurfaceSurvey::cells(double voxel) const {
  return static_cast<double>(blocks) * (block / voxel) * (block / voxel);
}

SurfaceSurvey survey_surface(const ExactField& field, const Candidates& list, int threads) {
  const Box3 cube = cube_about(field.bounds());
  std::vector<Part> parts;
  const auto whole = field.descent(0.5 * (cube.lo + cube.hi), list);
  find_parts(*whole, cube, 1, kApart, parts);
  SurfaceSurvey survey;
  for (int depth = kFirstDepth; depth <= kLastDepth && survey.blocks < kEnough; ++depth) {
    std::vector<Count> counts(parts.size());
    parallel_for(parts.size(), threads, [&](std::size_t k) {
      const Part& part = parts[k];
      Candidates left;
      const auto own = field.descent(0.5 * (part.box.lo + part.box.hi), part.candidates);
      count_blocks(field, *own, part.box, 1, depth - kApart, left, counts[k]);
    });
    survey = {};
    survey.block = (cube.hi.x - cube.lo.x) / static_cast<double>(1 << depth);
    std::size_t sweeps = 0, tried = 0, creasing = 0, crossings = 0;
    for (const Count& count : counts) {
      survey.blocks += count.blocks, sweeps += count.sweeps;
      tried += count.tried, creasing += count.creasing;
      crossings += count.crossings;
    }
    survey.sweeps =
        static_cast<double>(sweeps) / static_cast<double>(std::max<std::size_t>(survey.blocks, 1));
    survey.creasing =
        tried > 0 ? static_cast<double>(creasing) / static_cast<double>(tried) : survey.sweeps;
    // Half of the edges of half blocks lie between blocks.
    if (tried > 0)
      survey.crossings = 2 * static_cast<double>(crossings) / static_cast<double>(tried);
  }
  return survey;
}

}  // namespace mrsim::detail
