// What is left to cut: pieces by voxels, measured against the exact surfaces.

#include "compare/distance/nominal.h"
#include "compare/distance/sampling.h"
#include "compare/reach/inner_edges.h"
#include "compare/reach/reach.h"
#include "core/numbers/rounding.h"
#include "core/numbers/vec.h"
#include "core/process/error.h"
#include "core/process/memory_limit.h"
#include "core/process/parallel.h"
#include "mesh/solid/check.h"
#include "mesh/solid/half_edges.h"
#include "mesh/solid/pieces.h"
#include "run/files/voxel_module.h"
#include <mrsim/rest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kVoxelsOfRest = 400;  // along the longest side
constexpr double kLeaves = 0.25;     // of what is too thin to be looked for: what a tool may leave
constexpr double kLargestTool = 64;  // mm
constexpr double kNear = 2;          // voxels from a piece's surface: inner edges that belong to it
// Bytes, measured: for a square of a voxel on both surfaces, for a triangle of them.
constexpr double kSquareMemory = 240, kSurfaceTriangle = 100;
constexpr double kMostVoxels = 2500;  // along it: some 10 GB for the surfaces of a block

// Both surfaces, searched for their nearest place.
class Surfaces {
 public:
  Surfaces(const TriMesh& part, const TriMesh& nominal, int threads)
      : part_(part, threads), nominal_(nominal, threads) {}

  struct Place {
    Vec3 point;
    double height = 0;  ///< from the nominal; 0 on it
  };
  /// A vertex of a piece that was cut off `above` over the nominal, moved onto the part's surface
  /// or onto the nominal's.
  Place settled(const Vec3& p, double above) const {
    const TriangleTree::Hit of_part = part_.tree().nearest(p);
    const TriangleTree::Hit of_nominal = nominal_.tree().nearest(p);
    const double from_part = std::sqrt(of_part.distance2);
    const double from_nominal = std::abs(std::sqrt(of_nominal.distance2) - above);
    if (from_nominal < from_part) return {of_nominal.point, 0};
    return {of_part.point, std::max(0.0, nominal_.at(of_part.point).distance)};
  }

  const NominalSurface& nominal() const { return nominal_; }

 private:
  NominalSurface part_, nominal_;
};

// The centroid of the solid within the surface.
Vec3 center_of(const TriMesh& mesh, const Box3& bounds) {
  Vec3 sum;
  double volume = 0;
  for (const Piece& piece : find_pieces(mesh))
    sum += piece.volume * piece.center, volume += piece.volume;
  return volume > 0 ? (1 / volume) * sum : 0.5 * (bounds.lo + bounds.hi);
}

RestPiece measured(TriMesh voxels, const Surfaces& surfaces, double above, int threads) {
  RestPiece out;
  out.surface = voxels;
  auto& vertices = out.surface.vertices;
  std::vector<double> heights(vertices.size());
  parallel_for(
      vertices.size(), threads,
      [&](std::size_t i) {
        const Surfaces::Place place = surfaces.settled(to_vec(vertices[i]), above);
        vertices[i] = {float(place.point.x), float(place.point.y), float(place.point.z)};
        heights[i] = place.height;
      },
      256);
  const auto highest = std::max_element(heights.begin(), heights.end());
  if (highest != heights.end()) {
    out.thickness = *highest;
    out.place = to_vec(vertices[static_cast<std::size_t>(highest - heights.begin())]);
  }
  out.volume = signed_volume(out.surface);
  if (!(out.volume > 0)) {  // thinner than what the surfaces differ by
    out.is_exact = false;
    out.surface = std::move(voxels);
    out.volume = signed_volume(out.surface);
  }
  out.bounds = mesh_bounds(out.surface);
  out.center = center_of(out.surface, out.bounds);
  return out;
}

void find_tools(const NominalSurface& nominal, const Rest& rest, const RestVoxels& found,
                RestPiece& piece) {
  std::vector<Vec3> vertices;
  for (const auto& v : piece.surface.vertices) vertices.push_back(to_vec(v));
  std::vector<SurfacePlace> places = inner_edge_places(nominal, vertices, kNear * rest.voxel);
  const std::vector<SurfacePlace> faces = surface_places(nominal, found.places);
  places.insert(places.end(), faces.begin(), faces.end());
  const ReachTask task{rest.leaves, kLargestTool / 2, rest.leaves};
  const auto told = [](const Reach& r) {
    return ReachingTool{r.diameter, r.error, r.is_least, r.is_most};
  };
  piece.searched = !places.empty();
  if (!piece.searched) return;
  piece.ball = told(largest_ball(nominal, places, task));
  piece.flat = told(largest_flat(nominal, places, task));
}

// The length in mm, rounded up to three digits: as an option it is not below.
std::string at_least(double length) {
  const double unit = std::pow(10, std::floor(std::log10(length)) - 2);
  return fmt::format("{:.3g}", std::ceil(length / unit * (1 - kShareRounding)) * unit);
}

double voxel_of(const RestOptions& options, const Box3& box) {
  const Vec3 size = box.hi - box.lo;
  const double longest = std::max({size.x, size.y, size.z});
  const double voxel = options.voxel > 0 ? options.voxel : longest / kVoxelsOfRest;
  if (longest / voxel > kMostVoxels)
    throw Error("rest-voxel",
                fmt::format("a voxel of {:g} mm is too small for {:g} mm: {} mm or more", voxel,
                            longest, at_least(longest / kMostVoxels)),
                Error::Kind::usage);
  return voxel;
}

}  // namespace

Rest find_rest(const TriMesh& part, const TriMesh& nominal, const RestOptions& options) {
  require_comparable(part, "part", "part", options.threads);
  require_comparable(nominal, "nominal", "nominal", options.threads);
  Box3 box = mesh_bounds(part);
  extend(box, mesh_bounds(nominal));
  Rest out;
  out.voxel = voxel_of(options, box);
  out.above = options.above > 0 ? options.above : out.voxel / 2;
  out.leaves = kLeaves * out.above;
  if (out.above > 2 * out.voxel)
    throw Error(
        "rest-voxel",
        fmt::format("--above {:g} mm is more than 2 voxels of {:g} mm: with it --voxel {} or more "
                    "is needed",
                    out.above, out.voxel, at_least(out.above / 2)),
        Error::Kind::usage);
  const double squares = (surface_area(part) + surface_area(nominal)) / (out.voxel * out.voxel);
  const double triangles = double(part.triangles.size() + nominal.triangles.size());
  require_memory(kVoxelModuleMemory + kSquareMemory * squares + kSurfaceTriangle * triangles,
                 fmt::format("what is left by voxels of {:.3g} mm", out.voxel),
                 "a larger --voxel takes less");
  release_freed_memory();  // of a run and its comparison: OpenVDB has an allocator of its own
  std::vector<RestVoxels> found =
      find_rest_voxels({part, nominal, out.voxel, out.above, options.threads});
  const Surfaces surfaces(part, nominal, options.threads);
  std::erase_if(found, [](const RestVoxels& one) { return one.surface.triangles.empty(); });
  std::vector<RestPiece> pieces;
  for (RestVoxels& one : found) {
    pieces.push_back(measured(std::move(one.surface), surfaces, out.above, options.threads));
    out.volume += pieces.back().volume;
  }
  std::vector<std::size_t> order(pieces.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return pieces[a].volume > pieces[b].volume;
  });
  parallel_for(std::min(order.size(), options.searched), options.threads, [&](std::size_t i) {
    find_tools(surfaces.nominal(), out, found[order[i]], pieces[order[i]]);
  });
  for (const std::size_t i : order) out.pieces.push_back(std::move(pieces[i]));
  return out;
}

TriMesh joined_pieces(const Rest& rest) {
  TriMesh out;
  for (const RestPiece& piece : rest.pieces) {
    const auto first = static_cast<std::uint32_t>(out.vertices.size());
    out.vertices.insert(out.vertices.end(), piece.surface.vertices.begin(),
                        piece.surface.vertices.end());
    for (const auto& t : piece.surface.triangles)
      out.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return out;
}

}  // namespace mrsim
