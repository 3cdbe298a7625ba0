// What is left to cut: pieces by voxels, measured against the exact surfaces.

#include "compare/nominal.h"
#include "core/error.h"
#include "core/parallel.h"
#include "core/vec.h"
#include "mesh/solid/check.h"
#include "mesh/solid/half_edges.h"
#include "voxel_module.h"
#include <mrsim/rest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kVoxels = 400;       // along the longest side
constexpr double kMostVoxels = 2500;  // along it: some 10 GB for the surfaces of a block

Box3 bounds_of(const TriMesh& mesh) {
  Box3 box;
  for (const auto& v : mesh.vertices) extend(box, to_vec(v));
  return box;
}

// Both surfaces, asked for the place that is nearest.
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

 private:
  NominalSurface part_, nominal_;
};

// Of the solid within the surface.
Vec3 center_of(const TriMesh& mesh, const Box3& bounds) {
  const Vec3 middle = 0.5 * (bounds.lo + bounds.hi);
  Vec3 sum;
  double volume = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = to_vec(mesh.vertices[t[0]]) - middle, b = to_vec(mesh.vertices[t[1]]) - middle,
               c = to_vec(mesh.vertices[t[2]]) - middle;
    const double one = dot(a, cross(b, c)) / 6;
    volume += one;
    sum = sum + (one / 4) * (a + b + c);
  }
  return volume > 0 ? middle + (1 / volume) * sum : middle;
}

RestPiece measured(RestVoxels found, const Surfaces& surfaces, double above, int threads) {
  RestPiece out;
  out.surface = std::move(found.surface);
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
  out.bounds = bounds_of(out.surface);
  out.center = center_of(out.surface, out.bounds);
  out.ball = {found.ball, found.error, found.ball_is_least};
  out.flat = {found.flat, found.error, found.flat_is_least};
  return out;
}

double voxel_of(const RestOptions& options, const Box3& box) {
  const Vec3 size = box.hi - box.lo;
  const double longest = std::max({size.x, size.y, size.z});
  const double voxel = options.voxel > 0 ? options.voxel : longest / kVoxels;
  if (longest / voxel > kMostVoxels)
    throw Error("rest-voxel",
                fmt::format("a voxel of {:g} mm is too small for {:g} mm: {:.3g} mm or more", voxel,
                            longest, longest / kMostVoxels),
                Error::Kind::usage);
  return voxel;
}

}  // namespace

Rest find_rest(const TriMesh& part, const TriMesh& nominal, const RestOptions& options) {
  require_comparable(part, "part", "part", options.threads);
  require_comparable(nominal, "nominal", "nominal", options.threads);
  Box3 box = bounds_of(part);
  extend(box, bounds_of(nominal));
  Rest out;
  out.voxel = voxel_of(options, box);
  out.above = options.above > 0 ? options.above : out.voxel / 2;
  if (out.above > 2 * out.voxel)
    throw Error("rest-voxel",
                fmt::format("{:g} mm are more than 2 voxels of {:g} mm", out.above, out.voxel),
                Error::Kind::usage);
  std::vector<RestVoxels> found =
      find_rest_voxels({part, nominal, out.voxel, out.above, options.searched, options.threads});
  const Surfaces surfaces(part, nominal, options.threads);
  for (std::size_t i = 0; i < found.size(); ++i) {
    RestPiece piece = measured(std::move(found[i]), surfaces, out.above, options.threads);
    piece.searched = i < options.searched;
    if (!(piece.volume > 0)) continue;
    out.volume += piece.volume;
    out.pieces.push_back(std::move(piece));
  }
  std::stable_sort(out.pieces.begin(), out.pieces.end(),
                   [](const RestPiece& a, const RestPiece& b) { return a.volume > b.volume; });
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
