#include "mesh/cells/mesh_memory.h"

#include "core/process/error.h"
#include "core/process/memory_limit.h"
#include "core/process/parallel.h"
#include "mesh/cells/cell_scan.h"
#include "mesh/cells/octree.h"
#include "mesh/points/surface_search.h"

#include <algorithm>

#include <fmt/format.h>

namespace mrsim::detail {
namespace {

constexpr std::size_t kMostCells = 4096;  ///< cells from which the memory is estimated

// Bytes, as measured, for a cell that the surface passes: crossings, loops, vertices, triangles,
// and what is kept of them for the next round. A cell takes more where three faces meet in it; much
// more where these bend by more than the tolerance, since it will be split; and more where the
// distance from a face is sampled, since cells are then split along its bends.
constexpr double kCell = 1850, kThirdFace = 3000, kTurningFaces = 30000, kSampledFace = 1200;
constexpr double kCandidate = 6;

// Bytes that the whole run takes for each node of the finished octree; measured.
constexpr double kNodeOfAll = 1500;

// Bytes at the peak of a mesh that was made, by what there is in the end; fitted to the peaks of
// runs (docs/removal.md, Memory).
constexpr double kMesher = 6e6, kFinalNode = 900, kFinalCandidate = 27, kFinalTriangle = 215;
// Bytes of a loop, with its crossings, before there are triangles.
constexpr double kLoop = 650;

// How far the surface leaves a plane in a cell of `size` mm, if it turns evenly between the points.
double sagitta(const CellSurface& surface, double size) {
  double turn = 0;
  for (const CellSurface::Point& p : surface.all())
    for (const CellSurface::Point& q : surface.all())
      turn = std::max(turn, distance(p.normal, q.normal));
  return turn * size / 4;
}

double expected_of(const ExactField& field, const CellOctree& tree, std::int32_t cell,
                   double tolerance) {
  const OctreeNode& node = tree.node(cell);
  double corners[8];
  for (int k = 0; k < 8; ++k) corners[k] = tree.sample(node.corners[k]).distance;
  const Box3 box = tree.box(cell);
  const CellSurface surface = surface_of(field, tree.candidates(cell), box, corners);
  std::size_t faces = 0;
  for (std::size_t k = 0; k < surface.count; ++k)
    faces += std::none_of(surface.points, surface.points + k, [&](const CellSurface::Point& p) {
      return same_face(p.at, surface.points[k].at);
    });
  double bytes = kCell;
  if (faces > 2)
    bytes += kThirdFace + (sagitta(surface, box.hi.x - box.lo.x) > tolerance ? kTurningFaces : 0);
  if (surface.count > 2) {
    const Corners3 triangle{surface.points[0].position, surface.points[1].position,
                            surface.points[2].position};
    if (field.patch_range(triangle, surface.points[0].at).hi == FaceRange{}.hi)
      bytes += kSampledFace;
  }
  return bytes;
}

double candidates_in(const CellOctree& tree) {
  std::size_t candidates = 0;
  for (std::size_t n = 0; n < tree.size(); ++n)
    candidates += tree.candidates(static_cast<std::int32_t>(n)).size();
  return static_cast<double>(candidates);
}

}  // namespace

double expected_memory(const ExactField& field, const CellOctree& tree, double tolerance,
                       int threads) {
  std::vector<std::int32_t> cells;
  for (std::size_t n = 0; n < tree.size(); ++n) {
    const auto cell = static_cast<std::int32_t>(n);
    if (tree.node(cell).child < 0 && tree.node(cell).signs_differ) cells.push_back(cell);
  }
  const std::size_t some = std::min(cells.size(), kMostCells);
  std::vector<double> bytes(some);
  parallel_for(
      some, threads,
      [&](std::size_t k) {
        bytes[k] = expected_of(field, tree, cells[k * cells.size() / some], tolerance);
      },
      64);
  double sum = 0;
  for (const double b : bytes) sum += b;
  return kNodeMemory * static_cast<double>(tree.size()) + kCandidate * candidates_in(tree) +
         sum * static_cast<double>(cells.size()) /
             static_cast<double>(std::max<std::size_t>(some, 1));
}

void require_mesh_memory(double needed, std::size_t available, double tolerance) {
  if (available == 0 || needed <= static_cast<double>(available)) return;
  throw Error("memory",
              fmt::format("the mesh within a tolerance of {:.6g} mm needs about {} or more, "
                          "{} are available for it; a larger --tolerance takes less, and "
                          "with --voxel and no --tolerance the run is done in slabs",
                          tolerance, size_text(needed), size_text(static_cast<double>(available))));
}

double expected_nodes(double memory) { return memory / kNodeOfAll; }

double memory_of_mesh(const CellOctree& tree, std::size_t triangles) {
  return kMesher + kFinalNode * static_cast<double>(tree.size()) +
         kFinalCandidate * candidates_in(tree) + kFinalTriangle * static_cast<double>(triangles);
}

double memory_of_loops(const CellOctree& tree, std::size_t loops) {
  return kNodeMemory * static_cast<double>(tree.size()) + kFinalCandidate * candidates_in(tree) +
         kLoop * static_cast<double>(loops);
}

void require_cells(double nodes, double most) {
  if (most > 0 && nodes > most) throw Error("mesh-unresolved", too_many_cells(most));
}

std::string too_many_cells(double most) {
  return fmt::format("it takes more than {:.0f} 000 cells", most / 1000);
}

void require_room(double bytes, bool has_tolerance) {
  if (has_tolerance)
    require_memory(bytes, "a mesh within a tolerance",
                   "a larger --tolerance takes less, and with --voxel and no --tolerance the "
                   "run is done in slabs");
  else
    require_memory(bytes, "a mesh with details finer than the voxel",
                   "a larger --voxel or fewer --threads take less, --max-memory allows more");
}

}  // namespace mrsim::detail
